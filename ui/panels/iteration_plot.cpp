// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/iteration_plot.h"

#include "ui/widgets/named.h"
#include "ui/text/axis_scale.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kLeast = 1e-18; // a residual of 0 is drawn here, below what a double leaves of lengths
constexpr double kRadius = 3.5;  // px
constexpr int kFewestSteps = 6;  // on the axis, so that it stands still while the mechanism moves

double logarithmOf(double residual)
{
    return std::log10(std::isfinite(residual) ? std::max(kLeast, residual) : 1.0);
}

enum class Mark { Dot, Square };

void paintMark(QPainter &painter, const QPointF &at, Mark mark, const QColor &colour, const QColor &background)
{
    painter.setPen(QPen(colour, 1.5));
    if (mark == Mark::Dot) {
        painter.setBrush(colour);
        painter.drawEllipse(at, kRadius, kRadius);
    } else {
        painter.setBrush(background);
        painter.drawRect(QRectF(at.x() - kRadius, at.y() - kRadius, 2.0 * kRadius, 2.0 * kRadius));
    }
}

QString digitsOf(double residual)
{
    return shortNumber(residual, 2);
}

} // namespace

struct IterationPlot::Axes {
    QRectF area;
    int steps = kFewestSteps;
    Interval decades;

    QPointF place(int step, double logarithm) const
    {
        return {area.left() + area.width() * (step + 0.25) / (steps + 0.5),
                area.bottom() - area.height() * (logarithm - decades.lower) / decades.length()};
    }
};

IterationPlot::IterationPlot(QWidget *parent)
    : QWidget(parent)
{
    named("iterationPlot", this, tr("Residual ‖C‖ over the iterations"));
    setToolTip(tr("Near the solution each iteration doubles the number of correct digits: the line bends down"));
}

void IterationPlot::setHistories(const IterationHistory &fromAfar, const IterationHistory &fromBefore,
                                 const NewtonOptions &options, double seconds)
{
    const auto residualsOf = [](const IterationHistory &history) {
        std::vector<double> residuals;
        for (const Iteration &iteration : history) {
            residuals.push_back(iteration.residual);
        }
        return residuals;
    };
    m_fromAfar = residualsOf(fromAfar);
    m_fromBefore = residualsOf(fromBefore);
    m_options = options;
    m_seconds = seconds;

    QStringList told;
    const auto tell = [&told](const QString &start, const std::vector<double> &residuals) {
        QStringList numbers;
        for (const double residual : residuals) {
            numbers << digitsOf(residual);
        }
        if (!numbers.isEmpty()) {
            told << QStringLiteral("%1: %2").arg(start, numbers.join(QStringLiteral("; ")));
        }
    };
    tell(tr("From a rough start"), m_fromAfar);
    tell(tr("From %1 s earlier").arg(numberText(seconds)), m_fromBefore);
    setAccessibleDescription(told.join(QStringLiteral(". ")));
    update();
}

IterationPlot::Axes IterationPlot::axes() const
{
    Axes axes;
    double lowest = std::log10(kLeast) - 1.0;
    double highest = 2.0;
    for (const std::vector<double> *residuals : {&m_fromAfar, &m_fromBefore}) {
        axes.steps = std::max(axes.steps, static_cast<int>(residuals->size()) - 1);
        for (const double residual : *residuals) {
            highest = std::max(highest, std::ceil(logarithmOf(residual)));
        }
    }
    if (m_options.tolerance > 0.0) {
        lowest = std::min(lowest, std::floor(logarithmOf(m_options.tolerance)) - 1.0);
        highest = std::max(highest, std::ceil(logarithmOf(m_options.tolerance)) + 1.0);
    }
    axes.decades = {lowest, highest};
    const QFontMetricsF metrics(font());
    const double left = metrics.horizontalAdvance(QStringLiteral("10⁻¹⁸")) + 8.0;
    const double top = metrics.height() + 4.0;
    const double bottom = metrics.height() + 2.0;
    axes.area = QRectF(left, top, width() - left - 6.0, height() - top - bottom);
    return axes;
}

void IterationPlot::paintAxes(QPainter &painter, const Axes &axes, const SeriesColours &colours) const
{
    const QLocale locale;
    const QFontMetricsF metrics(font());
    const double lineHeight = metrics.height();
    const QRectF &area = axes.area;
    const AxisScale scale = logarithmicScale(axes.decades, std::max(1.0, area.height() / (1.6 * lineHeight)));
    const auto paintTick = [&](double logarithm, const QString &label) {
        const double y = axes.place(0, logarithm).y();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(colours.text);
        painter.drawText(QRectF(0.0, y - lineHeight, area.left() - 4.0, 2.0 * lineHeight),
                         Qt::AlignRight | Qt::AlignVCenter, label);
    };
    for (double tick = scale.step * std::ceil(axes.decades.lower / scale.step); tick <= axes.decades.upper;
         tick += scale.step) {
        paintTick(tick, scale.label(tick, locale));
    }
    const auto isZero = [](double residual) { return residual == 0.0; };
    if (std::ranges::any_of(m_fromAfar, isZero) || std::ranges::any_of(m_fromBefore, isZero)) {
        paintTick(std::log10(kLeast), locale.toString(0));
    }
    painter.setPen(colours.text);
    const int every = 1 + static_cast<int>(axes.steps * 2.5 * lineHeight / area.width());
    for (int step = 0; step <= axes.steps; step += every) {
        const double x = axes.place(step, 0.0).x();
        painter.drawText(QRectF(x - 30.0, area.bottom() + 1.0, 60.0, lineHeight), Qt::AlignHCenter | Qt::AlignTop,
                         locale.toString(step));
    }

    if (m_options.tolerance > 0.0) {
        const double y = axes.place(0, logarithmOf(m_options.tolerance)).y();
        painter.setPen(QPen(colours.warning, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.drawText(QRectF(area.left(), y, area.width() - 4.0, lineHeight), Qt::AlignRight | Qt::AlignTop,
                         tr("tolerance %1").arg(shortNumber(m_options.tolerance, 2)));
    }
}

/// The axis' name and the two curves', in one line above.
void IterationPlot::paintLegend(QPainter &painter, const Axes &axes, const SeriesColours &colours) const
{
    const QFontMetricsF metrics(font());
    double right = axes.area.right();
    const auto add = [&](Mark mark, const QColor &colour, const QString &text, const std::vector<double> &residuals) {
        if (residuals.empty()) {
            return;
        }
        const double width = metrics.horizontalAdvance(text);
        painter.setPen(colours.text);
        painter.drawText(QRectF(right - width, 1.0, width + 1.0, metrics.height()), Qt::AlignVCenter, text);
        paintMark(painter, {right - width - 2.0 * kRadius, 1.0 + 0.5 * metrics.height()}, mark, colour,
                  colours.background);
        right -= width + 4.0 * kRadius + 8.0;
    };
    add(Mark::Square, colours.reference, tr("from %1 s earlier").arg(numberText(m_seconds)), m_fromBefore);
    add(Mark::Dot, colours.model, tr("from a rough start"), m_fromAfar);

    const bool relative = m_options.toleranceKind == ToleranceKind::Relative;
    const QString name = relative ? tr("‖C‖, relative") : tr("‖C‖");
    painter.setPen(colours.text);
    if (4.0 + metrics.horizontalAdvance(name) < right) {
        painter.drawText(QRectF(4.0, 1.0, right, metrics.height()), Qt::AlignVCenter, name);
    }
}

void IterationPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const SeriesColours colours = seriesColours(palette());
    painter.fillRect(rect(), colours.background);
    const Axes axes = this->axes();
    paintAxes(painter, axes, colours);

    const auto paintCurve = [&](const std::vector<double> &residuals, Mark mark, const QColor &colour) {
        QPolygonF line;
        for (std::size_t k = 0; k < residuals.size(); ++k) {
            line << axes.place(static_cast<int>(k), logarithmOf(residuals[k]));
        }
        painter.setPen(QPen(colour, 1.0, mark == Mark::Dot ? Qt::SolidLine : Qt::DashLine));
        painter.drawPolyline(line);
        for (const QPointF &point : line) {
            paintMark(painter, point, mark, colour, colours.background);
        }
    };
    paintCurve(m_fromAfar, Mark::Dot, colours.model);
    paintCurve(m_fromBefore, Mark::Square, colours.reference);
    paintLegend(painter, axes, colours);
}

} // namespace slidercrank
