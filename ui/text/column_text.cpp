// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/column_text.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct ColumnText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ColumnText)
};

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
    case ',': return ColumnText::tr("columns separated by commas");
    case ';': return ColumnText::tr("columns separated by semicolons");
    case '\t': return ColumnText::tr("columns separated by tabs");
    case ' ': return ColumnText::tr("columns separated by spaces");
    default: return ColumnText::tr("columns separated by “%1”").arg(QLatin1Char(delimiter));
    }
}

/// With the name of the file, where there are several.
QString ofFile(const QString &text, const FileLayout &layout, std::size_t file)
{
    return file < layout.files.size() ? ColumnText::tr("%1 (%2)").arg(text, QString::fromUtf8(layout.files[file]))
                                      : text;
}

/// Of the column that the reason speaks of.
QString otherHeading(const FileLayout &layout, std::size_t column)
{
    const std::optional<std::size_t> other = layout.columns[column].otherColumn;
    return other && *other < layout.columns.size() ? headingText(layout, *other) : QString();
}

} // namespace

QString headingAlone(const FileLayout &layout, std::size_t column)
{
    const QString heading = QString::fromUtf8(layout.columns[column].heading);
    return heading.isEmpty() ? ColumnText::tr("column %1").arg(column + 1) : heading;
}

QString headingText(const FileLayout &layout, std::size_t column)
{
    return ofFile(headingAlone(layout, column), layout, layout.columns[column].file);
}

QString lineText(const FileLayout &layout, const SkippedRow &row)
{
    return row.line == 0 ? QString() : ofFile(QString::number(row.line), layout, row.file);
}

bool repeatsInstants(const FileLayout &layout, std::size_t column)
{
    return !layout.files.empty() && layout.columns[column].reason == ColumnReason::SameInstants;
}

std::vector<std::size_t> ignoredColumns(const FileLayout &layout)
{
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        if (layout.columns[i].role == ColumnRole::Ignored && !repeatsInstants(layout, i)) {
            columns.push_back(i);
        }
    }
    return columns;
}

QStringList ignoredHeadings(const FileLayout &layout)
{
    QStringList headings;
    for (const std::size_t column : ignoredColumns(layout)) {
        headings += headingText(layout, column);
    }
    return headings;
}

QString meaningText(const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Ignored: return QStringLiteral("–");
    case ColumnRole::Time: return ColumnText::tr("time");
    case ColumnRole::CrankAngle: return ColumnText::tr("crank angle");
    case ColumnRole::Channel: return symbolOf(column.channel);
    }
    return {};
}

QString unitText(const FileColumn &column)
{
    if (!column.unit.empty()) {
        return QString::fromUtf8(column.unit);
    }
    switch (column.role) {
    case ColumnRole::Ignored: return QStringLiteral("–");
    case ColumnRole::Time: return ColumnText::tr("s (none given)");
    case ColumnRole::CrankAngle: return ColumnText::tr("%1 (none given)").arg(QStringLiteral("°"));
    case ColumnRole::Channel: return ColumnText::tr("%1 (none given)").arg(QString::fromUtf8(fileUnit(column.channel)));
    }
    return {};
}

namespace
{

/// Why the column became what it is, whatever it is made of.
QString roleReason(const FileLayout &layout, std::size_t column)
{
    const QString other = otherHeading(layout, column);
    switch (layout.columns[column].reason) {
    case ColumnReason::KnownName: return ColumnText::tr("its name is known");
    case ColumnReason::Chosen: return ColumnText::tr("chosen by hand");
    case ColumnReason::QuantityInName:
        return ColumnText::tr("guessed: its name says the quantity, and this is the body usually exported");
    case ColumnReason::LetterAndUnit:
        return ColumnText::tr("guessed: P, V or A says the order, its unit says angle or length");
    case ColumnReason::OtherOfJoint:
        return ColumnText::tr("guessed: P, V or A says the order, another column of the joint says angle or length");
    case ColumnReason::EvenRate:
        return ColumnText::tr("guessed: an angle that grows at an even rate, as the crank's does");
    case ColumnReason::BeyondOneTurn:
        return other.isEmpty() ? ColumnText::tr("guessed: an angle beyond one turn is the crank's")
                               : ColumnText::tr("guessed: its values are the derivative of “%1”").arg(other);
    case ColumnReason::RisingValues: return ColumnText::tr("guessed: the first column whose values only rise");
    case ColumnReason::FileName: return ColumnText::tr("guessed: the file's name says so");
    case ColumnReason::ModelicaName:
        return ColumnText::tr("guessed: named as in Modelica, whose variables are in m, rad and s");
    case ColumnReason::AngleForTime:
        return ColumnText::tr("guessed: no column is the time, and this is the angle of the crank");
    case ColumnReason::UnknownName: return ColumnText::tr("ignored: its name is not known");
    case ColumnReason::UnknownBody: return ColumnText::tr("ignored: its name does not say of which body it is");
    case ColumnReason::RowNumber: return ColumnText::tr("ignored: it counts the rows");
    case ColumnReason::Magnitude:
        return ColumnText::tr("ignored: a magnitude, without direction; “%1” is a component of it").arg(other);
    case ColumnReason::SameInstants:
        return repeatsInstants(layout, column) ? ColumnText::tr("the instants, the same in all files")
                                               : ColumnText::tr("ignored: the same instants as “%1”").arg(other);
    case ColumnReason::OtherInstants:
        return ColumnText::tr("ignored: it belongs to other instants than those of “%1”").arg(other);
    case ColumnReason::NoName: return ColumnText::tr("ignored: it has no name");
    case ColumnReason::NoNumber: return ColumnText::tr("ignored: it holds no number");
    case ColumnReason::UnknownUnit:
        return ColumnText::tr("ignored: its unit is not known or does not suit the quantity");
    case ColumnReason::LikeOther: return ColumnText::tr("ignored: “%1” could be the same quantity").arg(other);
    case ColumnReason::NotDerivative:
        return ColumnText::tr("ignored: its values are not the derivative of “%1” that its name says").arg(other);
    case ColumnReason::AngleOrLength:
        return ColumnText::tr("ignored: neither its unit nor its values tell an angle from a length");
    }
    return {};
}

} // namespace

QString reasonText(const FileLayout &layout, std::size_t column)
{
    const QString reason = roleReason(layout, column);
    const std::optional<Difference> difference = layout.columns[column].difference;
    if (!difference) {
        return reason;
    }
    switch (*difference) {
    case Difference::Forward: return ColumnText::tr("%1; forward differences, no derivative").arg(reason);
    case Difference::Backward: return ColumnText::tr("%1; backward differences, no derivative").arg(reason);
    case Difference::Central: return ColumnText::tr("%1; central differences, no derivative").arg(reason);
    }
    return reason;
}

QString shortReasonText(const FileLayout &layout, std::size_t column)
{
    if (layout.columns[column].difference && !isGuess(layout.columns[column].reason)) {
        return ColumnText::tr("differences from row to row");
    }
    const QString other = otherHeading(layout, column);
    switch (layout.columns[column].reason) {
    case ColumnReason::KnownName: return ColumnText::tr("name known");
    case ColumnReason::Chosen: return ColumnText::tr("chosen by hand");
    case ColumnReason::QuantityInName: return ColumnText::tr("guessed by its name");
    case ColumnReason::LetterAndUnit: return ColumnText::tr("guessed by its unit");
    case ColumnReason::OtherOfJoint: return ColumnText::tr("guessed by its joint");
    case ColumnReason::EvenRate: return ColumnText::tr("guessed: even rate");
    case ColumnReason::BeyondOneTurn:
        return other.isEmpty() ? ColumnText::tr("guessed: beyond one turn")
                               : ColumnText::tr("guessed: derivative of %1").arg(other);
    case ColumnReason::RisingValues: return ColumnText::tr("guessed: only rises");
    case ColumnReason::FileName: return ColumnText::tr("guessed: file's name");
    case ColumnReason::ModelicaName: return ColumnText::tr("guessed: named as in Modelica");
    case ColumnReason::AngleForTime: return ColumnText::tr("guessed: no time here");
    case ColumnReason::UnknownName: return ColumnText::tr("name not known");
    case ColumnReason::UnknownBody: return ColumnText::tr("of which body?");
    case ColumnReason::RowNumber: return ColumnText::tr("counts the rows");
    case ColumnReason::Magnitude: return ColumnText::tr("magnitude of %1 …").arg(other);
    case ColumnReason::SameInstants:
        return repeatsInstants(layout, column) ? ColumnText::tr("same in all files")
                                               : ColumnText::tr("same instants as %1").arg(other);
    case ColumnReason::OtherInstants: return ColumnText::tr("other instants");
    case ColumnReason::NoName: return ColumnText::tr("no name");
    case ColumnReason::NoNumber: return ColumnText::tr("no number in it");
    case ColumnReason::UnknownUnit: return ColumnText::tr("unit not known");
    case ColumnReason::LikeOther: return ColumnText::tr("%1 could be it, too").arg(other);
    case ColumnReason::NotDerivative: return ColumnText::tr("not the derivative of %1").arg(other);
    case ColumnReason::AngleOrLength: return ColumnText::tr("angle or length?");
    }
    return {};
}

QString roundingText(const Rounding &rounding)
{
    switch (rounding.rule) {
    case Rounding::Rule::Unknown: return QStringLiteral("–");
    case Rounding::Rule::SignificantDigits:
        return rounding.digits == 1 ? ColumnText::tr("1 significant digit")
                                    : ColumnText::tr("%1 significant digits").arg(rounding.digits);
    case Rounding::Rule::Decimals:
        if (rounding.digits < 0) {
            return ColumnText::tr("whole multiples of 1e%1").arg(-rounding.digits);
        }
        return rounding.digits == 1 ? ColumnText::tr("1 decimal") : ColumnText::tr("%1 decimals").arg(rounding.digits);
    case Rounding::Rule::Multiples:
        return ColumnText::tr("multiples of %1").arg(numberText(rounding.quantum * rounding.unitFactor));
    }
    return {};
}

QString formText(const FileLayout &layout)
{
    if (!layout.files.empty()) {
        return ColumnText::tr("%1 files of one motion, joined").arg(layout.files.size());
    }
    QStringList parts{encodingText(layout), delimiterText(layout.delimiter),
                      layout.decimalSign == DecimalSign::Point ? ColumnText::tr("decimal point")
                                                               : ColumnText::tr("decimal comma"),
                      layout.headerLine == 0 ? ColumnText::tr("no names of columns")
                                             : ColumnText::tr("names in line %1").arg(layout.headerLine)};
    if (layout.unitsLine != 0) {
        parts << ColumnText::tr("units in line %1").arg(layout.unitsLine);
    }
    if (layout.preambleLines.size() == 1) {
        parts << ColumnText::tr("line %1 above them skipped").arg(layout.preambleLines[0]);
    } else if (!layout.preambleLines.empty()) {
        parts << ColumnText::tr("%1 lines above them skipped").arg(layout.preambleLines.size());
    }
    return parts.join(ColumnText::tr(", "));
}

QString abscissaText(const ReferenceData &data)
{
    const auto range = [](const std::vector<double> &values, const QString &text) {
        return text.arg(numberText(values.front()), numberText(values.back()));
    };
    return data.crank ? range(data.crank->degrees,
                              ColumnText::tr("%1 = %2 … %3°").arg(symbolOf(Channel{Theta2, Order::Position})))
                      : range(data.time, ColumnText::tr("t = %1 … %2 s"));
}

} // namespace slidercrank
