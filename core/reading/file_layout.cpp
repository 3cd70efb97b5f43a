// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/file_layout.h"

#include <algorithm>

namespace slidercrank
{

std::string_view clauseOf(ColumnReason reason)
{
    switch (reason) {
    case ColumnReason::KnownName: return "its name is known";
    case ColumnReason::Chosen: return "chosen by hand";
    case ColumnReason::QuantityInName: return "its name says the quantity, and this is the usual one to export";
    case ColumnReason::LetterAndUnit: return "P, V or A says the order, the unit says angle or length";
    case ColumnReason::LetterAndValues: return "P, V or A says the order, the values tell an angle from a length";
    case ColumnReason::DerivativeOfOther: return "its values are the derivative of another column";
    case ColumnReason::EvenRate: return "it is an angle that changes at an even rate, as the crank's does";
    case ColumnReason::RisingValues: return "it is the first column whose values only rise";
    case ColumnReason::UnknownName: return "its name means no channel";
    case ColumnReason::NoName: return "it has no name";
    case ColumnReason::NoNumber: return "it holds no number";
    case ColumnReason::UnknownUnit: return "its unit is not known or does not suit the quantity";
    case ColumnReason::LikeOther: return "another column could be the same quantity";
    case ColumnReason::NotDerivative: return "its values are not the derivative that its name says";
    case ColumnReason::AngleOrLength: return "neither its unit nor its values tell an angle from a length";
    }
    return {};
}

bool FileLayout::isGuessed() const
{
    return std::any_of(columns.begin(), columns.end(), [](const FileColumn &column) { return isGuess(column.reason); });
}

} // namespace slidercrank
