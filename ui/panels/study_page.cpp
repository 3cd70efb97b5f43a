// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_page.h"

#include "ui/text/axis_scale.h"
#include "ui/text/enum_table.h"
#include "ui/text/study_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kResultDigits = 3;
constexpr int kSpreadDigits = 2;
constexpr double kSmallestDrawnError = 1e-17; // errors below this, including 0, are drawn here

using SeriesColour = QColor SeriesColours::*;

struct MethodText {
    MethodName::Kind key;
    const char *name;
    const char *explanation;
    Tone tone;
    SeriesColour colour;
    bool isHollow; ///< its marks are hollow, because a second method has the same colour
};

struct StudyPage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StudyPage)

public:
    using enum MethodName::Kind;
    static constexpr const char *kTaylorStart = QT_TR_NOOP(
        "The same, started from position, velocity and acceleration of the time step before (Taylor series)");
    static constexpr bool kFilled = false;
    static constexpr bool kHollow = true;
    // These colours are free, because the chart shows no errors of slider or coupler.
    static constexpr SeriesColour kExactColour = &SeriesColours::sliderError;
    static constexpr SeriesColour kApproximateColour = &SeriesColours::couplerError;
    static constexpr MethodText kMethods[] = {
        {NewtonDense, QT_TR_NOOP("Newton-Raphson, dense"),
         QT_TR_NOOP(
             "The textbook's method: 12 equations solved together (dense LU), started from the time step before"),
         Tone::Fair, &SeriesColours::reference, kFilled},
        {NewtonDenseTaylor, QT_TR_NOOP("dense, Taylor start"), kTaylorStart, Tone::Fair, &SeriesColours::reference,
         kHollow},
        {NewtonStructured, QT_TR_NOOP("Newton-Raphson, structured"),
         QT_TR_NOOP("The same 12 equations, solved joint by joint"), Tone::Model, &SeriesColours::model, kFilled},
        {NewtonStructuredTaylor, QT_TR_NOOP("structured, Taylor start"), kTaylorStart, Tone::Model,
         &SeriesColours::model, kHollow},
        {ClosedForm, QT_TR_NOOP("closed form"), QT_TR_NOOP("The exact formulas, one time step after the other"),
         Tone::Good, kExactColour, kFilled},
        {ClosedFormBatch, QT_TR_NOOP("closed form, batch"),
         QT_TR_NOOP("The exact formulas for several time steps at once (vector instructions)"), Tone::Good,
         kExactColour, kHollow},
        {FiniteDifference, QT_TR_NOOP("finite differences"),
         QT_TR_NOOP("Velocity and acceleration as central differences of exact positions"), Tone::Bad,
         kApproximateColour, kFilled},
        {Harmonics, QT_TR_NOOP("Fourier series"), QT_TR_NOOP("The motion as a Fourier series"), Tone::Bad,
         kApproximateColour, kHollow}};
    static_assert(isCompleteTable(kMethods, Harmonics));

    static const MethodText &textOf(const MethodResult &method)
    {
        return slidercrank::rowOf(kMethods, method.method.kind);
    }

    static QString shownNameOf(const MethodResult &method)
    {
        const QString name = tr(textOf(method).name);
        return method.method.kind == MethodName::Kind::Harmonics
                   ? tr("%1, %2 harmonics").arg(name, QString::number(method.method.harmonics))
                   : name;
    }

    static QString statusText(Status status)
    {
        switch (status) {
        case Status::Solved: return tr("solved");
        case Status::Singular: return tr("singular");
        case Status::IterationLimit: return tr("not converged");
        case Status::NotAssemblable: return tr("cannot be assembled");
        case Status::NotFinite: break;
        }
        return tr("not finite");
    }

    /// Returns "solved", "190 solved, 11 singular", or "201 solved, 12 reported as solved but wrong".
    static QString outcomeText(const MethodResult &method)
    {
        QStringList parts;
        for (std::size_t i = 0; i < kStatusCount; ++i) {
            if (method.counts[i] > 0) {
                parts +=
                    QStringLiteral("%1 %2").arg(QString::number(method.counts[i]), statusText(static_cast<Status>(i)));
            }
        }
        const bool hasSilentFailures = method.silentFailures.value_or(0) > 0;
        QString text = parts.size() == 1 && !hasSilentFailures ? statusText(method.status) : parts.join(", ");
        if (hasSilentFailures) {
            text += tr(", %1 reported as solved but wrong").arg(QString::number(*method.silentFailures));
        }
        return text;
    }

    static QString descriptionOf(const MethodResult &method)
    {
        QStringList lines{shownNameOf(method), tr(textOf(method).explanation),
                          tr("%1 ns per time step (± %2), %3 channels")
                              .arg(shortNumber(method.nanosecondsPerState, kResultDigits),
                                   shortNumber(0.5 * method.spread, kSpreadDigits), QString::number(method.channels)),
                          method.maxError
                              ? tr("Largest error: %1 of the peak").arg(shortNumber(*method.maxError, kResultDigits))
                              : tr("No time step is solved")};
        if (method.errorBound) {
            lines << tr("Rounding a, b, c, ω₂, θ₂₀ and t to doubles alone may cause an error of %1")
                         .arg(shortNumber(*method.errorBound, kResultDigits));
        }
        return lines.join(u'\n');
    }

    static TableRow rowOf(const MethodResult &method)
    {
        const auto cell = [](std::optional<double> value) {
            return TableCell{.text = shortNumber(value, kResultDigits), .number = value};
        };
        return {
            {{.text = shownNameOf(method), .tone = textOf(method).tone},
             {.text = QString::number(method.channels), .number = method.channels},
             {.text = numberText(method.tolerance, kResultDigits), .number = method.tolerance},
             cell(method.nanosecondsPerState),
             cell(method.maxError),
             cell(method.iterationsPerState),
             {.text = outcomeText(method), .tone = method.silentFailures.value_or(0) > 0 ? Tone::Bad : Tone::Normal}},
            {},
            MechanismPart::None,
            descriptionOf(method)};
    }

    static PageTable tableOf(const CaseResult &result)
    {
        PageTable table{
            "studyTable",
            tr("Methods, a row for each method and tolerance"),
            {{tr("method"), tr("How the motion is computed"), "method", false},
             {tr("channels"), tr("How many channels the method computes"), "channels"},
             {tr("tolerance"),
              tr("Tolerance of Newton-Raphson: absolute for the textbook's dense method, relative for the others"),
              "tolerance"},
             {tr("time [ns]"),
              tr("Position, velocity and acceleration at one time step: median over interleaved rounds"), "time [ns]"},
             {tr("error"),
              tr("Largest error of the six plotted channels, relative to the peak of the channel, over "
                 "the time steps solved"),
              "error"},
             {tr("iterations"), tr("For each time step"), "iterations"},
             {tr("time steps"), tr("What the method reports"), "instants", false}}};
        for (const MethodResult &method : result.methods) {
            table.rows.push_back(rowOf(method));
        }
        return table;
    }

    static ChartContent chartOf(const CaseResult &result)
    {
        ChartContent chart{
            {tr("time for one time step [ns]"), {1e1, 1e3}, true}, {tr("error / peak"), {1e-17, 1.0}, true}, {}};
        const auto includeDecade = [](ChartAxis &axis, double value) {
            axis.range.include(std::pow(10.0, std::floor(std::log10(value))));
            axis.range.include(std::pow(10.0, std::ceil(std::log10(value))));
        };
        std::vector<MethodName::Kind> kinds; // of the series
        double largestInputError = 0.0;
        for (const MethodResult &method : result.methods) {
            if (!method.maxError || method.nanosecondsPerState <= 0.0) {
                continue;
            }
            auto kind = std::ranges::find(kinds, method.method.kind);
            if (kind == kinds.end()) {
                const MethodText &text = textOf(method);
                chart.series.push_back({.name = tr(text.name), .colour = text.colour, .isHollow = text.isHollow});
                chart.series.back().mark.addRect(-4.0, -4.0, 8.0, 8.0);
                kind = kinds.insert(kinds.end(), method.method.kind);
            }
            ChartSeries &series = chart.series[static_cast<std::size_t>(kind - kinds.begin())];
            const double error =
                std::isfinite(*method.maxError) ? std::max(kSmallestDrawnError, *method.maxError) : 1.0;
            const QPointF point(method.nanosecondsPerState, error);
            const auto index = // the points are sorted by time
                std::ranges::lower_bound(series.points, point.x(), {}, &QPointF::x) - series.points.begin();
            series.points.insert(series.points.begin() + index, point);
            series.tips.insert(index, descriptionOf(method));
            includeDecade(chart.x, point.x());
            includeDecade(chart.y, point.y());
            largestInputError = std::max(largestInputError, method.errorBound.value_or(0.0));
        }
        if (largestInputError > 0.0) {
            includeDecade(chart.y, largestInputError);
            chart.series.push_back(
                {.name = tr("effect of rounded input"),
                 .colour = &SeriesColours::warning,
                 .points = {{chart.x.range.lower, largestInputError}, {chart.x.range.upper, largestInputError}},
                 .line = ChartSeries::Line::Dashed});
        }
        return chart;
    }
};

} // namespace

Page studyPage(const CaseResult &result)
{
    Page page;
    page.sentence = closedFormSentence(result);
    page.chart =
        PageChart{"studyChart", StudyPage::tr("Error against time for each method"), StudyPage::chartOf(result)};
    page.tables = {StudyPage::tableOf(result)};
    return page;
}

} // namespace slidercrank
