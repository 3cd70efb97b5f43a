// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/column_text.h"

#include "ui/text/channel_text.h"
#include "ui/text/enum_table.h"
#include "ui/text/notation.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <optional>

namespace slidercrank
{

namespace
{

struct ColumnText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ColumnText)

public:
    static constexpr EnumText<ColumnReason> kReasons[] = {
        {ColumnReason::KnownName, QT_TR_NOOP("recognized by its heading")},
        {ColumnReason::Chosen, QT_TR_NOOP("chosen by hand")},
        {ColumnReason::QuantityInName, QT_TR_NOOP("assumed: the heading names the quantity, but not the body")},
        {ColumnReason::WideAngle,
         QT_TR_NOOP("assumed from its values: an angle that spans more than half a turn or rises evenly, or its "
                    "derivative")},
        {ColumnReason::StraightPath,
         QT_TR_NOOP("assumed from its values: of several points, only this one has a y that does not change")},
        {ColumnReason::UnknownWords,
         QT_TR_NOOP("assumed: some words are unknown, but no other column is this quantity")},
        {ColumnReason::RisingValues, QT_TR_NOOP("assumed: the first column, whose values only increase")},
        {ColumnReason::PathInSi, QT_TR_NOOP("assumed from the heading: named as in Modelica or ROS, in m, rad and s")},
        {ColumnReason::AngleForTime, QT_TR_NOOP("assumed: no column is the time, and this is the angle of the crank")},
        {ColumnReason::UnknownName, QT_TR_NOOP("its heading names no quantity that is compared")},
        {ColumnReason::UnknownBody, QT_TR_NOOP("its heading does not name the body")},
        {ColumnReason::RowNumber, QT_TR_NOOP("it numbers the rows")},
        {ColumnReason::Magnitude, QT_TR_NOOP("the magnitude of a vector, without its sign")},
        {ColumnReason::SameTimeStamps, QT_TR_NOOP("the same time stamps as in the column of the time")},
        {ColumnReason::TimeOfDay, QT_TR_NOOP("the time of a clock; another column contains the time")},
        {ColumnReason::NoName, QT_TR_NOOP("no heading")},
        {ColumnReason::NoNumber, QT_TR_NOOP("it contains no number")},
        {ColumnReason::MoreWords, QT_TR_NOOP("it contains more words than numbers")},
        {ColumnReason::UnknownUnit, QT_TR_NOOP("its unit is unknown, or does not suit the quantity")},
        {ColumnReason::Ratio, QT_TR_NOOP("a ratio of two quantities, which is not compared")},
        {ColumnReason::OverAngle,
         QT_TR_NOOP(
             "a derivative with respect to the crank angle, not the time: multiply it by ω₂, or by ω₂² if it is the "
             "second one")},
        {ColumnReason::LikeOther, QT_TR_NOOP("another column could be the same quantity")},
        {ColumnReason::AngleOrLength, QT_TR_NOOP("neither unit nor values tell whether it is an angle or a length")},
        {ColumnReason::TurnsOrRadians, QT_TR_NOOP("its unit may be rad/s or turns per second: state which one")},
        {ColumnReason::CrankPin, QT_TR_NOOP("it describes the crank pin A, which is not compared")},
        {ColumnReason::Constant, QT_TR_NOOP("its values do not change, like those of a parameter")},
    };
};

static_assert(isCompleteTable(ColumnText::kReasons, ColumnReason::Constant));

/// Returns the text, followed by the name of the file if several files are joined.
QString withFile(const QString &text, const FileLayout &layout, std::size_t file)
{
    return file < layout.files.size() ? ColumnText::tr("%1 (%2)").arg(text, QString::fromUtf8(layout.files[file]))
                                      : text;
}

QString differenceText(Difference difference)
{
    switch (difference) {
    case Difference::Forward: return ColumnText::tr("forward differences");
    case Difference::Backward: return ColumnText::tr("backward differences");
    case Difference::Central: break;
    }
    return ColumnText::tr("central differences");
}

/// Returns the symbol in the chosen notation. The θ₃ of textbooks is measured at B, that of a file at A.
QString channelMeaning(Channel channel)
{
    const bool isAtA = channel == Channel{Theta3, Order::Position} && notation().symbols == Symbols::Textbook;
    return isAtA ? ColumnText::tr("%1, measured at A").arg(symbolText(channel)) : symbolText(channel);
}

/// Returns the hint that lengths without a unit were read as mm, with the option that reads them as metres if the
/// stroke is short, otherwise as inches. Columns that have the name of a channel are not read as inches. Empty if
/// a length has a unit, or if the option would concern no column.
std::optional<QString> millimetresHint(const ReferenceData &data)
{
    constexpr double kShortestStroke = 1.0; // mm: a smaller stroke is probably in metres
    const ReferenceSeries *const x = data.find({R4x, Order::Position});
    const double stroke = x ? rangeOf(x->values).width() : 0.0;
    const bool areMetres = stroke > 0.0 && stroke < kShortestStroke;
    std::vector<ColumnChoice> choices;
    for (const FileColumn &column : data.layout.columns) {
        const bool isLength = column.role == ColumnRole::Channel && !isAngle(column.channel.coordinate);
        if (isLength && !column.unit.empty()) {
            return std::nullopt; // then the other columns are not in metres either
        }
        const bool isKnownUnit = !areMetres && channelNamed(column.heading);
        if (isLength && !column.heading.empty() && !isKnownUnit) {
            const std::string perTime(fileUnit(column.channel).substr(std::string_view("mm").size())); // "/s" of "mm/s"
            choices.push_back({.role = column.role,
                               .channel = column.channel,
                               .unit = (areMetres ? "m" : "in") + perTime,
                               .heading = column.heading});
        }
    }
    if (choices.empty()) {
        return std::nullopt;
    }
    const QString text =
        areMetres ? ColumnText::tr("The lengths have no unit and are read as mm. If they are metres, add %1")
                  : ColumnText::tr("The lengths have no unit and are read as mm. If they are inches, add %1");
    return text.arg(optionText(choices));
}

/// Returns the hint that angles without a unit were read as radians, because of their values, with the option that
/// reads them as degrees; empty if there are none.
std::optional<QString> radiansHint(const FileLayout &layout)
{
    std::vector<ColumnChoice> choices;
    for (const FileColumn &column : layout.columns) {
        if (column.isInRadiansByValues && column.role != ColumnRole::Ignored) {
            const bool isCrank = column.role == ColumnRole::CrankAngle;
            const Channel channel = isCrank ? Channel{Theta2, Order::Position} : column.channel;
            choices.push_back({.role = column.role,
                               .channel = channel,
                               .unit = std::string(fileUnit(channel)),
                               .heading = column.heading});
        }
    }
    if (choices.empty()) {
        return std::nullopt;
    }
    return ColumnText::tr("The angles have no unit and are read in radians, as their values suggest. If they are in "
                          "degrees, add %1")
        .arg(optionText(choices));
}

/// Returns a hint for each speed in 1/s or Hz, which may be in rad/s or in turns per second, with both options.
QStringList crankSpeedHints(const FileLayout &layout)
{
    QStringList hints;
    for (const FileColumn &column : layout.columns) {
        if (column.reason == ColumnReason::TurnsOrRadians) {
            const auto optionFor = [&column](const char *unit) {
                return optionText({{.role = ColumnRole::Channel,
                                    .channel = {Theta2, Order::Velocity},
                                    .unit = unit,
                                    .heading = column.heading}});
            };
            hints << ColumnText::tr("If this is the speed of the crank in rad/s, add %1; in turns per second, add %2")
                         .arg(optionFor("rad/s"), optionFor("rev/s"));
        }
    }
    return hints;
}

} // namespace

QString headingWithoutFile(const FileLayout &layout, std::size_t column)
{
    const QString heading = QString::fromUtf8(layout.columns[column].heading);
    return heading.isEmpty() ? ColumnText::tr("column %1").arg(column + 1) : heading;
}

QString headingText(const FileLayout &layout, std::size_t column)
{
    return withFile(headingWithoutFile(layout, column), layout, layout.columns[column].file);
}

QString lineText(const FileLayout &layout, const SkippedRow &row)
{
    return row.line == 0 ? QString() : withFile(QString::number(row.line), layout, row.file);
}

bool repeatsTimeStamps(const FileLayout &layout, std::size_t column)
{
    return !layout.files.empty() && layout.columns[column].reason == ColumnReason::SameTimeStamps;
}

QStringList ignoredHeadings(const FileLayout &layout)
{
    QStringList headings;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        if (layout.columns[i].role == ColumnRole::Ignored && !repeatsTimeStamps(layout, i)) {
            headings += headingText(layout, i);
        }
    }
    return headings;
}

QStringList doubtTexts(const ReferenceData &data)
{
    const FileLayout &layout = data.layout;
    QStringList texts;
    if (!data.skipped.empty()) {
        const SkippedRow &first = data.skipped.front();
        texts << ColumnText::tr("Rows that were skipped: %1, the first in line %2, column %3 (“%4”): %5.")
                     .arg(QString::number(data.skippedCount), lineText(layout, first), QString::number(first.column),
                          QString::fromStdString(first.text), rowFaultText(first));
    }
    if (layout.mayBeThousands) {
        texts << ColumnText::tr("Every number with a decimal sign has exactly three digits after it: read as decimals, "
                                "not as thousands.");
    }
    QStringList ignored, guesses;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (column.role == ColumnRole::Ignored && !repeatsTimeStamps(layout, i)) {
            ignored << ColumnText::tr("%1 (%2)").arg(headingText(layout, i), reasonText(layout, i));
        } else if (isGuess(column.reason)) {
            const QString meaning =
                column.role == ColumnRole::Channel ? columnName(column.channel) : meaningText(column);
            guesses << ColumnText::tr("“%1” as %2").arg(headingText(layout, i), meaning);
        }
    }
    if (!ignored.isEmpty()) {
        texts << ColumnText::tr("Columns that were not used: %1.").arg(ignored.join(", "));
    }
    if (!guesses.isEmpty()) {
        texts << ColumnText::tr("Check these columns, whose headings leave their meaning open: %1.")
                     .arg(guesses.join(", "));
    }
    return texts;
}

QStringList optionHints(const ReferenceData &data)
{
    QStringList hints;
    for (const std::optional<QString> &hint : {millimetresHint(data), radiansHint(data.layout)}) {
        if (hint) {
            hints << *hint;
        }
    }
    return hints + crankSpeedHints(data.layout);
}

QString meaningText(const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Ignored: return dash();
    case ColumnRole::Time: return ColumnText::tr("time");
    case ColumnRole::CrankAngle: return ColumnText::tr("crank angle");
    case ColumnRole::Channel: return channelMeaning(column.channel);
    }
    return {};
}

QString unitText(const FileColumn &column)
{
    if (!column.unit.empty()) {
        return QString::fromUtf8(column.unit);
    }
    const auto noneGiven = [](const QString &unit) { return ColumnText::tr("%1 (none given)").arg(unit); };
    switch (column.role) {
    case ColumnRole::Ignored: return dash();
    case ColumnRole::Time: return noneGiven("s");
    case ColumnRole::CrankAngle: return noneGiven("°");
    case ColumnRole::Channel: return noneGiven(unitText(column.channel));
    }
    return {};
}

QString reasonText(ColumnReason reason)
{
    return ColumnText::tr(rowOf(ColumnText::kReasons, reason).text);
}

QString reasonText(const FileLayout &layout, std::size_t column)
{
    const FileColumn &read = layout.columns[column];
    const QString reason = repeatsTimeStamps(layout, column) ? ColumnText::tr("the time stamps, the same in all files")
                                                             : reasonText(read.reason);
    return read.difference ? ColumnText::tr("%1; %2, not a derivative").arg(reason, differenceText(*read.difference))
                           : reason;
}

QString roundingText(const Rounding &rounding)
{
    switch (rounding.rule) {
    case Rounding::Rule::Unknown: return dash();
    case Rounding::Rule::SignificantDigits: return ColumnText::tr("significant digits: %1").arg(rounding.digits);
    case Rounding::Rule::Decimals: return ColumnText::tr("multiples of %1").arg(powerOfTenText(-rounding.digits));
    case Rounding::Rule::Multiples:
        return ColumnText::tr("multiples of %1").arg(numberText(rounding.quantum * rounding.unitFactor));
    }
    return {};
}

QString layoutText(const FileLayout &layout)
{
    if (!layout.files.empty()) {
        return ColumnText::tr("Joined files of one motion: %1").arg(layout.files.size());
    }
    const QString delimiter = layout.delimiter == '\t' ? "\\t" : QString(QLatin1Char(layout.delimiter));
    return QStringList{ColumnText::tr("Columns separated by “%1”").arg(delimiter),
                       layout.decimalSign == DecimalSign::Point ? ColumnText::tr("decimal point")
                                                                : ColumnText::tr("decimal comma"),
                       layout.headerLine == 0 ? ColumnText::tr("no headings")
                                              : ColumnText::tr("headings in line %1").arg(layout.headerLine)}
        .join(", ");
}

QString abscissaText(const ReferenceData &data)
{
    const std::vector<double> &values = data.crank ? data.crank->degrees : data.time;
    return QString(data.crank ? "θ₂ = %1 … %2°" : "t = %1 … %2 s")
        .arg(numberText(values.front()), numberText(values.back()));
}

} // namespace slidercrank
