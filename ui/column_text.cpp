// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/column_text.h"

#include "ui/finding_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace slidercrank
{

namespace
{

QString tr(const char *text, int count = -1)
{
    return QCoreApplication::translate("slidercrank::ColumnText", text, nullptr, count);
}

QString encodingText(const FileLayout &layout)
{
    switch (layout.encoding) {
    case TextEncoding::Utf8: return QStringLiteral("UTF-8");
    case TextEncoding::Utf16LittleEndian:
    case TextEncoding::Utf16BigEndian: return QStringLiteral("UTF-16");
    case TextEncoding::Windows1252: return QStringLiteral("Windows-1252 (Latin-1)");
    }
    return {};
}

QString delimiterText(char delimiter)
{
    switch (delimiter) {
    case ',': return tr("columns separated by commas");
    case ';': return tr("columns separated by semicolons");
    case '\t': return tr("columns separated by tabs");
    case ' ': return tr("columns separated by spaces");
    default: return tr("columns separated by “%1”").arg(QLatin1Char(delimiter));
    }
}

/// Of the column that the reason speaks of.
QString otherHeading(const FileLayout &layout, std::size_t column)
{
    const std::optional<std::size_t> other = layout.columns[column].otherColumn;
    return other && *other < layout.columns.size() ? headingText(layout, *other) : QString();
}

} // namespace

QString textOf(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QString headingText(const FileLayout &layout, std::size_t column)
{
    const QString heading = textOf(layout.columns[column].heading);
    return heading.isEmpty() ? tr("column %1").arg(column + 1) : heading;
}

QString meaningText(const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Ignored: return QStringLiteral("–");
    case ColumnRole::Time: return tr("time");
    case ColumnRole::Channel: return symbolOf(column.channel);
    }
    return {};
}

QString unitText(const FileColumn &column)
{
    if (!column.unit.empty()) {
        return textOf(column.unit);
    }
    switch (column.role) {
    case ColumnRole::Ignored: return QStringLiteral("–");
    case ColumnRole::Time: return tr("s (none given)");
    case ColumnRole::Channel: return tr("%1 (none given)").arg(textOf(authorUnitOf(column.channel)));
    }
    return {};
}

QString reasonText(const FileLayout &layout, std::size_t column)
{
    const QString other = otherHeading(layout, column);
    switch (layout.columns[column].reason) {
    case ColumnReason::KnownName: return tr("its name is known");
    case ColumnReason::Chosen: return tr("chosen by hand");
    case ColumnReason::QuantityInName:
        return tr("guessed: its name says the quantity, and this is the body usually exported");
    case ColumnReason::LetterAndUnit: return tr("guessed: P, V or A says the order, its unit says angle or length");
    case ColumnReason::LetterAndValues:
        return tr("guessed: P, V or A says the order, its values tell an angle from a length");
    case ColumnReason::DerivativeOfOther: return tr("guessed: its values are the derivative of “%1”").arg(other);
    case ColumnReason::EvenRate: return tr("guessed: an angle that grows at an even rate, as the crank's does");
    case ColumnReason::RisingValues: return tr("guessed: the first column whose values only rise");
    case ColumnReason::UnknownName: return tr("ignored: its name means no channel");
    case ColumnReason::NoName: return tr("ignored: it has no name");
    case ColumnReason::NoNumber: return tr("ignored: it holds no number");
    case ColumnReason::UnknownUnit: return tr("ignored: its unit is not known or does not suit the quantity");
    case ColumnReason::LikeOther: return tr("ignored: “%1” could be the same quantity").arg(other);
    case ColumnReason::NotDerivative:
        return tr("ignored: its values are not the derivative of “%1” that its name says").arg(other);
    case ColumnReason::AngleOrLength: return tr("ignored: neither its unit nor its values tell an angle from a length");
    }
    return {};
}

QString shortReasonText(const FileLayout &layout, std::size_t column)
{
    const QString other = otherHeading(layout, column);
    switch (layout.columns[column].reason) {
    case ColumnReason::KnownName: return tr("name known");
    case ColumnReason::Chosen: return tr("chosen by hand");
    case ColumnReason::QuantityInName: return tr("guessed by its name");
    case ColumnReason::LetterAndUnit: return tr("guessed by its unit");
    case ColumnReason::LetterAndValues: return tr("guessed by its values");
    case ColumnReason::DerivativeOfOther: return tr("guessed: derivative of %1").arg(other);
    case ColumnReason::EvenRate: return tr("guessed: even rate");
    case ColumnReason::RisingValues: return tr("guessed: only rises");
    case ColumnReason::UnknownName: return tr("name not known");
    case ColumnReason::NoName: return tr("no name");
    case ColumnReason::NoNumber: return tr("no number in it");
    case ColumnReason::UnknownUnit: return tr("unit not known");
    case ColumnReason::LikeOther: return tr("as %1 could be").arg(other);
    case ColumnReason::NotDerivative: return tr("not the derivative of %1").arg(other);
    case ColumnReason::AngleOrLength: return tr("angle or length?");
    }
    return {};
}

QString roundingText(const Rounding &rounding)
{
    switch (rounding.rule) {
    case Rounding::Rule::Unknown: return QStringLiteral("–");
    case Rounding::Rule::SignificantDigits:
        return rounding.digits == 1 ? tr("1 significant digit") : tr("%1 significant digits").arg(rounding.digits);
    case Rounding::Rule::Decimals:
        if (rounding.digits < 0) {
            return tr("whole multiples of 1e%1").arg(-rounding.digits);
        }
        return rounding.digits == 1 ? tr("1 decimal") : tr("%1 decimals").arg(rounding.digits);
    }
    return {};
}

QString formText(const FileLayout &layout)
{
    QStringList parts{encodingText(layout), delimiterText(layout.delimiter),
                      layout.decimalSign == DecimalSign::Point ? tr("decimal point") : tr("decimal comma"),
                      layout.headerLine == 0 ? tr("no names of columns")
                                             : tr("names in line %1").arg(layout.headerLine)};
    if (layout.unitsLine != 0) {
        parts << tr("units in line %1").arg(layout.unitsLine);
    }
    if (layout.preambleLines.size() == 1) {
        parts << tr("line %1 above them passed over").arg(layout.preambleLines[0]);
    } else if (!layout.preambleLines.empty()) {
        parts << tr("%1 lines above them passed over").arg(layout.preambleLines.size());
    }
    return parts.join(tr(", "));
}

} // namespace slidercrank
