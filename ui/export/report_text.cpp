// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report.h"

#include "ui/export/motion_table.h"
#include "ui/export/polygon_figure.h"
#include "ui/text/channel_text.h"
#include "ui/text/column_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/explanation.h"
#include "ui/text/identification_text.h"
#include "ui/text/language.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/subscripts.h"
#include "ui/text/written_number.h"
#include "ui/widgets/paragraph.h"

#include "core/mechanism/turn.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace slidercrank
{

namespace
{

struct Report {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::Report)
};

// Significant digits.
constexpr int kDigits = 6; // enough for a calculation by hand
constexpr int kRoundingStepDigits = 3;
constexpr int kResidualDigits = 2;

QString element(const char *tag, const QString &text)
{
    return QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped().replace(u'\n', "<br>"));
}

QString heading(const QString &text)
{
    return element("h2", text);
}

/// Returns a paragraph in which no equation is broken into lines.
QString paragraph(const QString &text)
{
    return text.isEmpty() ? QString() : element("p", withUnbrokenUnits(text));
}

QString note(const QString &text)
{
    return text.isEmpty() ? QString() : QStringLiteral("<div class=note>%1</div>").arg(paragraph(text));
}

/// What the columns of a table contain.
enum class TableKind {
    Numbers,            ///< numbers alone
    NamesAndNumbers,    ///< names in the first column
    NamesNumbersAndText ///< names in the first column, text in the last one
};

enum class ColumnKind { Name, Number, Text };

ColumnKind columnKind(TableKind table, qsizetype column, qsizetype columnCount)
{
    if (column == 0 && table != TableKind::Numbers) {
        return ColumnKind::Name;
    }
    const bool isLast = column + 1 == columnCount;
    return isLast && table == TableKind::NamesNumbersAndText ? ColumnKind::Text : ColumnKind::Number;
}

/// Returns the attributes of the HTML cells of a column. Names and text are aligned to the left, numbers to the right.
/// In a table with a column of text, both the text and the names are broken into lines.
QString cellAttributes(TableKind table, ColumnKind column)
{
    constexpr int kWidthOfBrokenNames = 130; // px
    const bool isBroken = table == TableKind::NamesNumbersAndText && column != ColumnKind::Number;
    QString attributes = QStringLiteral("class=%1 align=%2")
                             .arg(QLatin1String(isBroken ? "text" : "unbroken"),
                                  QLatin1String(column == ColumnKind::Number ? "right" : "left"));
    if (isBroken && column == ColumnKind::Name) {
        attributes += QStringLiteral(" width=%1").arg(kWidthOfBrokenNames);
    }
    return attributes;
}

/// Returns the class of an HTML table in the style sheet of the report.
QString tableClass(TableKind kind)
{
    switch (kind) {
    case TableKind::Numbers: return "numbers";
    case TableKind::NamesAndNumbers: break;
    case TableKind::NamesNumbersAndText: return "dense"; // smaller letters
    }
    return "plain";
}

/// The first row is the header, which is repeated on each page.
QString table(const std::vector<QStringList> &rows, TableKind kind = TableKind::NamesAndNumbers)
{
    QString html = QStringLiteral("<table class=%1 cellspacing=0 cellpadding=2>").arg(tableClass(kind));
    for (const QStringList &row : rows) {
        const bool isHeader = &row == &rows.front();
        const QLatin1String element(isHeader ? "th" : "td");
        html += isHeader ? "<thead><tr>" : "<tr>";
        for (qsizetype i = 0; i < row.size(); ++i) {
            html += QStringLiteral("<%1 %2>%3</%1>")
                        .arg(element, cellAttributes(kind, columnKind(kind, i, row.size())), subscriptHtml(row[i]));
        }
        html += isHeader ? "</tr></thead>" : "</tr>";
    }
    return html + "</table>";
}

/// Returns the value of a quantity at the chosen position, such as "μ = 60°".
QString equation(const ReportContent &content, const OutputChannel &channel)
{
    const Mechanism &mechanism = content.result->mechanism;
    const OutputState state = unambiguousStateAt(mechanism, content.time, content.alpha2);
    const double exact = withoutNoise(state.valueOf(channel), channel, mechanism, content.alpha2);
    const double value = shownChannel(channel, mechanism.branch(), exact);
    return QStringLiteral("%1 = %2").arg(
        symbolOf(channel), std::isfinite(value) ? withUnit(shortNumber(value, kDigits), shownUnit(channel)) : dash());
}

/// Returns the values of coupler and slider at the chosen position.
QString valueTable(const ReportContent &content)
{
    std::vector<QStringList> rows{{QString(), Report::tr("coupler"), Report::tr("slider"), QString()},
                                  {Report::tr("position")},
                                  {Report::tr("velocity")},
                                  {Report::tr("acceleration")}};
    for (const Channel channel : kPlottedChannels) {
        rows[static_cast<std::size_t>(channel.order) + 1] << equation(content, channel);
    }
    return table(rows);
}

QString derivedValues(const ReportContent &content)
{
    const DerivedChannel mu{DerivedQuantity::TransmissionAngle, Order::Position};
    const DerivedChannel displacement{DerivedQuantity::Displacement, Order::Position};
    return paragraph(
        QStringLiteral("%1: %2; %3: %4.")
            .arg(nameText(mu), equation(content, mu), nameText(displacement), equation(content, displacement)));
}

/// Returns the note that the velocities jump at the chosen position; empty if they do not.
QString jumpNote(const ReportContent &content)
{
    const Mechanism &mechanism = content.result->mechanism;
    const bool jumps = mechanism.omega2() != 0.0 &&
                       velocitiesJumpAt(mechanism, mechanism.theta20() + mechanism.omega2() * content.time);
    return jumps ? note(jumpSentence()) : QString();
}

/// Returns the note that motion limits and plots are those of a constant crank speed; empty without an acceleration.
QString accelerationNote(const ReportContent &content)
{
    return content.alpha2 == 0.0
               ? QString()
               : note(Report::tr("The motion limits and the plots are those of a constant crank speed, without α₂."));
}

QString limitSection(const Result &result)
{
    const std::vector<MotionFact> facts = motionFacts(result.mechanism, result.limits, result.sampling, notation());
    return heading(Report::tr("Motion limits")) + paragraph(mobilitySentence(result.mechanism, result.limits)) +
           (facts.empty() ? QString() : table(limitTable(facts)));
}

QString crankText(const ReportContent &content)
{
    const Mechanism &mechanism = content.result->mechanism;
    const double theta2 = mechanism.theta20() + mechanism.omega2() * content.time;
    const Units &units = notation().units;
    constexpr double kStepInRadians = 1e-4;
    constexpr double kStepInDegrees = 1e-2;
    const double step = units.angle == AngleUnit::Radian ? kStepInRadians : kStepInDegrees;
    const double roundedAngle = std::round(shownCrankAngle(theta2) / step) * step;
    QString text = QStringLiteral("θ₂ = %1, t = %2 s")
                       .arg(withUnit(numberText(roundedAngle), shownUnit(Measure::Angle)), numberText(content.time));
    if (content.alpha2 != 0.0) {
        text += QStringLiteral(", α₂ = %1 rad/s²").arg(numberText(content.alpha2));
    }
    return text;
}

/// Returns the settings of the table of the motion. A step that gives more rows than a report should have is replaced.
MotionTableSettings printedTableSettings(const ReportContent &content)
{
    constexpr std::size_t kMaxPrintedRows = 361; // every degree, about nine pages
    const MotionTableSettings usual{.columns = usualTableChannels()};
    MotionTableSettings settings = content.table.value_or(usual);
    if (tablePositions(settings, content.result->mechanism, content.result->sampling).size() > kMaxPrintedRows) {
        settings.step = TableStep::CrankAngle;
        settings.angleStep = usual.angleStep;
    }
    return settings;
}

std::vector<TableRow> motionRows(const ReportContent &content, const MotionTableSettings &settings)
{
    const Mechanism &mechanism = content.result->mechanism;
    std::vector<TableRow> rows;
    for (const TablePosition &position : tablePositions(settings, mechanism, content.result->sampling)) {
        rows.push_back(motionTableRow(settings, mechanism, content.alpha2, position));
    }
    return rows;
}

/// Returns some columns of the table of the motion as HTML.
QString motionColumns(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows,
                      const std::vector<std::size_t> &shown)
{
    std::vector<QStringList> texts(rows.size() + 1);
    for (const std::size_t column : shown) {
        texts.front() << columns[column].title;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            texts[row + 1] << rows[row].cells[column].text;
        }
    }
    return table(texts, TableKind::Numbers);
}

/// Returns the notes that explain the dashes in the table of the motion.
QString dashNotes(const std::vector<TableRow> &rows)
{
    const auto hasNoNumber = [](const TableCell &cell) { return !cell.number; };
    const auto hasNoTime = [&](const TableRow &row) { return hasNoNumber(row.cells.front()); };
    const auto hasNoValue = [&](const TableRow &row) {
        return std::any_of(row.cells.begin() + kFirstChannelColumn, row.cells.end(), hasNoNumber);
    };
    QString html;
    if (std::ranges::any_of(rows, hasNoTime)) {
        html += note(Report::tr("Without a time: angles that the crank does not reach within the time range."));
    }
    if (std::ranges::any_of(rows, hasNoValue)) {
        html += note(Report::tr("Without a value: angles at which the mechanism cannot be assembled, or at which the "
                                "velocities do not exist."));
    }
    return html;
}

/// Returns the section with the table of the motion, on a new page. Columns for which the page is too narrow follow in
/// sections of their own. Returns an empty text if there is a reference or the mechanism cannot be assembled.
QString motionTableSection(const ReportContent &content)
{
    if (content.result->reference || content.result->limits.mobility == Mobility::Impossible) {
        return {};
    }
    constexpr std::size_t kMaxChannels = 8; // side by side
    const MotionTableSettings settings = printedTableSettings(content);
    const std::vector<TableColumn> columns = motionTableColumns(settings);
    const std::vector<TableRow> rows = motionRows(content, settings);
    const bool isOverTime = settings.step == TableStep::Time;
    const QString step =
        isOverTime ? withUnit(numberText(settings.timeStep), "s") : withUnit(numberText(settings.angleStep), "°");
    const QString acceleration =
        content.alpha2 == 0.0 ? QString() : QStringLiteral(", α₂ = %1 rad/s²").arg(numberText(content.alpha2));
    const QString title = Report::tr("Table, every %1%2").arg(step, acceleration);
    QString html;
    for (std::size_t first = kFirstChannelColumn; first < columns.size(); first += kMaxChannels) {
        std::vector<std::size_t> shown(kFirstChannelColumn);
        std::iota(shown.begin(), shown.end(), 0U); // t and θ₂
        for (std::size_t i = first; i < std::min(first + kMaxChannels, columns.size()); ++i) {
            shown.push_back(i);
        }
        html += heading(html.isEmpty() ? title : Report::tr("Further columns of the table"));
        html += motionColumns(columns, rows, shown);
    }
    return html + dashNotes(rows);
}

/// Returns the section with the polygons; an empty text if there is a reference or no vector to be drawn.
QString polygonSection(const ReportContent &content)
{
    const Polygons polygons = polygonsAt(content.result->mechanism, content.time, content.alpha2);
    if (content.result->reference || !hasVectors(polygons)) {
        return {};
    }
    return heading(Report::tr("Velocity and acceleration polygons")) +
           note(Report::tr("At %1").arg(crankText(content))) + QStringLiteral("<p>%1</p>").arg(kPolygonsPlaceholder);
}

QString pinnedText(const Result &result)
{
    QStringList motions;
    for (const Parameters &pinned : result.pinned) {
        motions << pinnedText(pinned, result.mechanism.parameters());
    }
    return motions.isEmpty() ? QString() : Report::tr("Thin curves: the pinned motions (%1).").arg(motions.join(u"; "));
}

/// Returns a table of the errors of a file or of the differences from a pinned motion, with the names of the quantities
/// as in the window and, for a file, the verdicts in words.
QString errorTable(const std::vector<ChannelComparison> &comparison, const ReferenceData *file)
{
    const bool isOverAngle = file && file->crank;
    std::vector<QStringList> rows{
        {Report::tr("quantity"), file ? Report::tr("largest error") : Report::tr("largest difference"),
         isOverAngle ? Report::tr("at θ₂ [%1]").arg(shownUnit(Measure::Angle)) : Report::tr("at t [s]"),
         Report::tr("rms"), Report::tr("% of peak")}};
    if (file) {
        rows.front() << Report::tr("rounding step") << Report::tr("verdict");
    }
    for (const ChannelComparison &channel : comparison) {
        const QString unit = shownUnit(channel.channel);
        const auto inShownUnit = [&channel](std::optional<double> error) {
            return shownDifference(channel.channel, error);
        };
        const QString time = channel.largestError ? numberText(channel.timeOfLargestError) : dash();
        const QString place = file ? abscissaOfLargestError(channel, *file) : time;
        const QString largest = errorText(inShownUnit(channel.largestError));
        rows.push_back({QStringLiteral("%1 %2").arg(quantityName(channel.channel), symbolText(channel.channel)),
                        channel.largestError ? withUnit(largest, unit) : largest, place,
                        errorText(inShownUnit(channel.rms)), errorText(channel.percentOfPeak)});
        if (file) {
            rows.back() << numberText(inShownUnit(channel.roundingStep), kRoundingStepDigits) << verdictText(channel);
        }
    }
    return table(rows, file ? TableKind::NamesNumbersAndText : TableKind::NamesAndNumbers);
}

/// Returns the description of the reference: the files, and how their columns were interpreted.
QString fileText(const Reference &reference)
{
    const ReferenceData &data = reference.data;
    QString html = paragraph(Report::tr("Reference: %1, %2, %n rows.", nullptr, static_cast<int>(data.time.size()))
                                 .arg(displayName(reference.source.paths), abscissaText(data)));
    for (const QString &doubt : doubtTexts(data)) {
        html += note(doubt);
    }
    return html;
}

/// Returns the section about the reference: the verdict, its cause, the mechanism found and the errors.
QString comparisonSection(const ReportContent &content)
{
    const Result &result = *content.result;
    const Identification &found = content.found;
    QString html = heading(Report::tr("Errors: model against reference")) + fileText(*result.reference) +
                   QStringLiteral("<b>%1</b>").arg(paragraph(summaryText(result.comparison)));
    for (const Explanation &explanation :
         explainDifferences(found, result.mechanism.parameters(), result.reference->data.layout)) {
        html += paragraph(explanation.text);
    }
    if (found.hasMechanism()) {
        html += paragraph(found.agreesWithGiven ? summaryText(found) : QString()) + paragraph(roundNumbersText(found)) +
                note(Report::tr("Found by weighted least squares; ± is one standard error."));
    }
    return html + errorTable(result.comparison, &result.reference->data) +
           note(Report::tr("Rounding step: the largest spacing between neighbouring values of the file."));
}

/// Returns the section about the difference from the motion that was pinned last.
QString differenceSection(const Result &result)
{
    const QString pinned = pinnedText(result.pinned.back(), result.mechanism.parameters());
    return heading(Report::tr("Difference from the pinned motion")) +
           paragraph(Report::tr("The model is compared with the pinned motion (%1).").arg(pinned)) +
           errorTable(result.difference->channels, nullptr);
}

/// Returns the section with the plots; an empty text if nothing moves and nothing is compared.
QString plotSection(const ReportContent &content)
{
    const Result &result = *content.result;
    const bool isMoving = result.limits.mobility != Mobility::Impossible && result.mechanism.omega2() != 0.0;
    if (!isMoving && !result.isCompared()) {
        return {};
    }
    QString timeRange;
    if (const std::optional<Interval> &time = content.plottedTime) {
        timeRange =
            Report::tr("The plots show t = %1 s to %2 s.").arg(numberText(time->lower), numberText(time->upper));
    }
    return heading(Report::tr("Motion")) + paragraph(timeRange) + paragraph(pinnedText(result)) +
           QStringLiteral("<p>%1</p>").arg(kFigurePlaceholder);
}

QString methodText(const Result &result)
{
    const NewtonOptions &newton = result.solver.newton;
    const Sampling &sampling = result.sampling;
    const SamplingSummary &summary = result.summary;
    QString text;
    if (result.solver.method == Method::ClosedForm) {
        text = Report::tr("Closed form, exact to rounding.");
    } else {
        text =
            Report::tr("Newton-Raphson in the 12 absolute coordinates: tolerance %1 (%2), at most %n iterations per "
                       "time step. Iterations: %3; largest residual: %4.",
                       nullptr, newton.maxIterations)
                .arg(numberText(newton.tolerance),
                     newton.toleranceKind == ToleranceKind::Absolute ? Report::tr("absolute") : Report::tr("relative"),
                     iterationsText(summary), numberText(summary.largestResidual, kResidualDigits));
    }
    text +=
        u' ' + Report::tr("%1 time steps from t = %2 s to %3 s, %4 of them solved.")
                   .arg(QString::number(summary.timeSteps), numberText(sampling.start),
                        numberText(sampling.start + sampling.duration), QString::number(summary.count(Status::Solved)));
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        const auto status = static_cast<Status>(i);
        const QString reason = statusSentence(status, newton);
        if (summary.count(status) > 0 && !reason.isEmpty()) {
            text +=
                u' ' + Report::tr("%n time steps: %1", nullptr, static_cast<int>(summary.count(status))).arg(reason);
        }
    }
    if (result.solver.method == Method::Newton) { // the closed form computes as many points as a curve needs
        text += u' ' + fewSamplesSentence(result.mechanism, sampling);
    }
    return text;
}

} // namespace

std::optional<Interval> plottedTime(const Result &result, const PlotZoom &zoom)
{
    constexpr double kMaxRevolutions = 5.0;
    const Sampling &sampling = result.sampling;
    const double speed = std::abs(result.mechanism.omega2());
    const bool isFast = speed * sampling.duration > kMaxRevolutions * kTurn * (1.0 + kEpsilon);
    if (zoom.time || !isFast || result.isCompared()) {
        return zoom.time;
    }
    return Interval{sampling.start, sampling.start + kTurn / speed};
}

QString parameterTable(const ReportContent &content)
{
    const Parameters &model = content.result->mechanism.parameters();
    std::vector<QStringList> rows{{QString(), Report::tr("model")}};
    for (const Parameter parameter : kAllParameters) {
        rows.push_back({QStringLiteral("%1, %2").arg(symbolText(parameter), parameterName(parameter)),
                        parameterText(parameter, valueOf(model, parameter))});
    }
    rows.push_back({Report::tr("assembly"), assemblyText(model.branch)});
    return table(rows);
}

QString reportHtml(const ReportContent &content)
{
    const Result &result = *content.result;
    const auto sideBySide = [](const QString &left, const QString &right) {
        return QStringLiteral("<table width=100%><tr><td>%1</td><td align=right>%2</td></tr></table>").arg(left, right);
    };
    QString caption = Report::tr("The mechanism at %1.").arg(crankText(content));
    if (result.isCompared()) {
        caption += u' ' + (result.reference ? Report::tr("Thin lines: the motion in the file.")
                                            : Report::tr("Thin lines: the pinned mechanism."));
    }
    QString comparison;
    if (result.isCompared()) {
        comparison = result.reference ? comparisonSection(content) : differenceSection(result);
    }
    return element("h1", Report::tr("Motion of an offset slider-crank")) +
           note(Report::tr("%1, by %2 %3")
                    .arg(textLocale().toString(content.timeOfWriting.toLocalTime(), Report::tr("d MMMM yyyy, HH:mm")),
                         QCoreApplication::applicationName(), QCoreApplication::applicationVersion())) +
           sideBySide(parameterTable(content), kMechanismPlaceholder) + note(caption) +
           heading(Report::tr("At %1").arg(crankText(content))) + valueTable(content) + derivedValues(content) +
           jumpNote(content) + accelerationNote(content) + limitSection(result) + motionTableSection(content) +
           polygonSection(content) + plotSection(content) + heading(Report::tr("Method")) +
           paragraph(methodText(result)) + comparison;
}

} // namespace slidercrank
