// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report.h"

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

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slidercrank
{

namespace
{

struct Report {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::Report)
};

constexpr int kDigits = 6; // significant digits, enough for a calculation by hand

QString element(const char *tag, const QString &text)
{
    return QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text.toHtmlEscaped().replace(u'\n', "<br>"));
}

QString heading(const QString &text)
{
    return element("h2", text);
}

/// Returns a paragraph in which no equation is broken at its sign or before its unit.
QString paragraph(QString text)
{
    static const QRegularExpression kBeforeUnit("(?<=[0-9]) (?=[a-z°])");
    text.replace(" = ", "\u00a0=\u00a0").replace(kBeforeUnit, "\u00a0");
    return text.isEmpty() ? QString() : element("p", text);
}

QString note(const QString &text)
{
    return text.isEmpty() ? QString() : QStringLiteral("<div class=note>%1</div>").arg(element("p", text));
}

/// Whether the last column of a table contains numbers or text.
enum class LastColumn { Number, Text };

/// Returns an HTML table. The first row is the header. The first column is aligned to the left, numbers to the right.
/// With a last column of text, which is broken into lines, the first column is broken, too, and the letters are
/// smaller.
QString table(const std::vector<QStringList> &rows, LastColumn last = LastColumn::Number)
{
    const bool hasText = last == LastColumn::Text;
    QString html = hasText ? "<table class=dense cellspacing=0 cellpadding=2>" : "<table cellspacing=0 cellpadding=2>";
    for (const QStringList &row : rows) {
        html += "<tr>";
        for (qsizetype i = 0; i < row.size(); ++i) {
            const bool isText = hasText && i + 1 == row.size();
            const bool isBroken = isText || (hasText && i == 0);
            html += QStringLiteral("<%1 class=%2 align=%3%4>%5</%1>")
                        .arg(QLatin1String(&row == &rows.front() ? "th" : "td"),
                             QLatin1String(isBroken ? "text" : "unbroken"),
                             QLatin1String(isText || i == 0 ? "left" : "right"),
                             QLatin1String(hasText && i == 0 ? " width=130" : ""), // px
                             subscriptHtml(row[i]));
        }
        html += "</tr>";
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
    return QStringLiteral("%1 = %2").arg(symbolOf(channel), withUnit(shortNumber(value, kDigits), shownUnit(channel)));
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

QString pinnedText(const Result &result)
{
    QStringList motions;
    for (const Parameters &pinned : result.pinned) {
        motions << pinnedText(pinned, result.mechanism.parameters());
    }
    return motions.isEmpty() ? QString() : Report::tr("Thin curves: pinned motions, %1.").arg(motions.join(u", "));
}

/// Returns a table of errors, with the names of the quantities as in the window and, for a file, the verdicts in words.
QString errorTable(const std::vector<ChannelComparison> &comparison, const ReferenceData *file)
{
    const bool isOverAngle = file && file->crank;
    std::vector<QStringList> rows{
        {Report::tr("quantity"), Report::tr("largest error"),
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
        const QString time = channel.maxAbs ? numberText(channel.timeOfMaxAbs) : dash();
        const QString place = file ? placeText(channel, *file) : time;
        const QString largest = errorText(inShownUnit(channel.maxAbs));
        rows.push_back({QStringLiteral("%1 %2").arg(quantityName(channel.channel), symbolText(channel.channel)),
                        channel.maxAbs ? withUnit(largest, unit) : largest, place, errorText(inShownUnit(channel.rms)),
                        errorText(channel.percentOfPeak)});
        if (file) {
            rows.back() << numberText(inShownUnit(channel.roundingStep), 3) << verdictText(channel);
        }
    }
    return table(rows, file ? LastColumn::Text : LastColumn::Number);
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
QString comparisonText(const ReportContent &content)
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
QString differenceText(const Result &result)
{
    const QString pinned = pinnedText(result.pinned.back(), result.mechanism.parameters());
    return heading(Report::tr("Difference from the pinned motion")) +
           paragraph(Report::tr("The model is compared with the pinned motion (%1).").arg(pinned)) +
           errorTable(result.difference->channels, nullptr);
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
                     iterationsText(summary), numberText(summary.largestResidual, 2));
    }
    text +=
        u' ' + Report::tr("%1 time steps from t = %2 s to %3 s, %4 of them solved.")
                   .arg(QString::number(summary.timeSteps), numberText(sampling.start),
                        numberText(sampling.start + sampling.duration), QString::number(summary.count(Status::Solved)));
    return text + u' ' + fewSamplesSentence(result.mechanism, sampling);
}

} // namespace

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
        comparison = result.reference ? comparisonText(content) : differenceText(result);
    }
    return element("h1", Report::tr("Motion of an offset slider-crank")) +
           note(Report::tr("%1, by %2 %3")
                    .arg(textLocale().toString(content.timeOfWriting.toLocalTime(), Report::tr("d MMMM yyyy, HH:mm")),
                         QCoreApplication::applicationName(), QCoreApplication::applicationVersion())) +
           sideBySide(parameterTable(content), kMechanismPlace) + note(caption) +
           heading(Report::tr("At %1").arg(crankText(content))) + valueTable(content) + derivedValues(content) +
           jumpNote(content) + accelerationNote(content) + heading(Report::tr("Motion limits")) +
           paragraph(mobilitySentence(result.mechanism, result.limits)) +
           table(limitTable(motionFacts(result.mechanism, result.limits, result.sampling, notation()))) +
           heading(Report::tr("Motion")) + paragraph(pinnedText(result)) +
           QStringLiteral("<p>%1</p>").arg(kFigurePlace) + heading(Report::tr("Method")) +
           paragraph(methodText(result)) + comparison;
}

} // namespace slidercrank
