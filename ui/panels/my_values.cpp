// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/my_values.h"

#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"
#include "ui/export/motion_table.h"
#include "ui/text/check_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/quantity_text.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The values that were typed at a position, as they are shown and as they are read.
struct ReadValues {
    std::vector<TableCell> cells;   ///< one for each channel, empty if no value was typed
    std::vector<TypedValue> values; ///< of the texts that are values
    QStringList faults;             ///< a sentence for each text that is no value
};

/// Reads the texts that were typed. The key of a text is the name of its column.
ReadValues readValues(const std::map<QString, QString> &texts, const std::vector<OutputChannel> &channels)
{
    ReadValues read;
    for (const OutputChannel &channel : channels) {
        TableCell &cell = read.cells.emplace_back();
        const auto text = texts.find(columnName(channel));
        if (text == texts.end()) {
            continue;
        }
        cell.text = text->second;
        if (cell.text.startsWith(u'-')) {
            cell.text.replace(0, 1, "−"); // as in the row above
        }
        const QString number = QString(cell.text).replace(QLocale().decimalPoint(), ".");
        const TypedValue value = readTypedValue(number, channel, notation().units);
        if (value.parsed.fault) {
            cell.tone = Tone::Bad;
            read.faults << QStringLiteral("%1: %2").arg(symbolOf(channel), faultText(value));
        } else {
            read.values.push_back(value);
        }
    }
    return read;
}

CheckResult checkAll(const CrankPosition &position, const std::vector<TypedValue> &values)
{
    std::vector<GivenValue> given(values.size());
    std::ranges::transform(values, given.begin(), &TypedValue::given);
    return check(position, given);
}

/// Returns the row of the table that shows a cell for each channel.
TableRow rowOf(const std::vector<TableCell> &cells)
{
    TableRow row;
    row.cells = {{.text = MyValues::tr("my values"), .tone = Tone::Muted}, {}}; // below t and θ₂
    row.cells.insert(row.cells.end(), cells.begin(), cells.end());
    row.explanation =
        MyValues::tr("Type values of your calculation: they are compared with the exact ones, each to its last digit");
    return row;
}

} // namespace

bool isSamePosition(double x, double y)
{
    constexpr double kRounding = 1e-9; // rad
    return std::abs(wrapToPi(x - y)) < kRounding;
}

void MyValues::setText(double theta2, const OutputChannel &channel, const QString &text)
{
    auto typedHere = std::ranges::find_if(
        m_positions, [theta2](const TypedTexts &typed) { return isSamePosition(typed.theta2, theta2); });
    if (typedHere == m_positions.end()) {
        typedHere = m_positions.insert(typedHere, {.theta2 = wrapToPi(theta2), .byColumn = {}});
    }
    if (text.isEmpty()) {
        typedHere->byColumn.erase(columnName(channel));
    } else {
        typedHere->byColumn[columnName(channel)] = text;
    }
    if (typedHere->byColumn.empty()) {
        m_positions.erase(typedHere);
    }
}

const MyValues::TypedTexts *MyValues::textsAt(double theta2) const
{
    const auto typedHere = std::ranges::find_if(
        m_positions, [theta2](const TypedTexts &typed) { return isSamePosition(typed.theta2, theta2); });
    return typedHere == m_positions.end() ? nullptr : &*typedHere;
}

QString MyValues::positionsText() const
{
    QStringList angles;
    for (const TypedTexts &typed : m_positions) {
        angles << QStringLiteral("θ₂ = ") + crankAngleWithUnit(typed.theta2);
    }
    return angles.isEmpty() ? QString() : tr("Your values are shown again at %1.").arg(listed(angles));
}

MyValues::CheckedRow MyValues::check(const CrankPosition &position, const std::vector<OutputChannel> &channels) const
{
    const double theta2 = position.mechanism.theta20();
    const TypedTexts *typedHere = textsAt(theta2);
    if (!typedHere) {
        return {rowOf(std::vector<TableCell>(channels.size())), positionsText()};
    }
    ReadValues read = readValues(typedHere->byColumn, channels);
    const std::vector<TypedValue> values = inLikelyUnits(std::move(read.values), position, notation().units);
    const CheckResult result = checkAll(position, values);
    QStringList sentences = read.faults;
    QStringList wrong;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const QString symbol = symbolOf(values[i].channel);
        const bool isRight = result.values[i].isRight;
        const auto column = std::ranges::find(channels, values[i].channel) - channels.begin();
        read.cells[static_cast<std::size_t>(column)].tone = isRight ? Tone::Good : Tone::Bad;
        sentences << QStringLiteral("%1: %2.").arg(symbol, verdictText(values[i], result.values[i]));
        if (!isRight) {
            wrong << symbol;
        }
    }
    const bool isIncomplete = wrong.isEmpty() && !read.faults.isEmpty(); // then not "all values are right"
    if (!values.empty() && !isIncomplete) {
        sentences << explanationText(result, wrong);
    }
    if (!values.empty() && result.status == Status::Singular && velocitiesJumpAt(position.mechanism, theta2)) {
        sentences << jumpSentence();
    }
    return {rowOf(read.cells), sentences.join(u' ')};
}

} // namespace slidercrank
