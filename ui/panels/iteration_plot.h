// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// ‖C‖ over the iterations at one instant, on a logarithmic axis, against the tolerance: from afar and from the instant
// before. Where each step doubles the right digits, as Newton-Raphson does near a root, the line bends down.

#include "core/newton/newton.h"

#include <QWidget>

#include <vector>

namespace slidercrank
{

struct SeriesColours;

class IterationPlot : public QWidget
{
    Q_OBJECT

public:
    explicit IterationPlot(QWidget *parent = nullptr);

    /// `fromBefore` starts from the position so many seconds earlier.
    void setHistories(const IterationHistory &fromAfar, const IterationHistory &fromBefore,
                      const NewtonOptions &options, double seconds);

    QSize sizeHint() const override { return {360, 180}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Axes;

    Axes axes() const;
    void paintAxes(QPainter &painter, const Axes &axes, const SeriesColours &colours) const;
    void paintLegend(QPainter &painter, const Axes &axes, const SeriesColours &colours) const;

    std::vector<double> m_fromAfar;
    std::vector<double> m_fromBefore;
    NewtonOptions m_options;
    double m_seconds = 0.0;
};

} // namespace slidercrank
