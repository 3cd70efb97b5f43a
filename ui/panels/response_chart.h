// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A chart of one limit over a parameter. A dot marks the current value and can be dragged.

#include "ui/panels/response.h"
#include "ui/plots/chart.h"

#include <QPixmap>

namespace slidercrank
{

class ResponseChart : public Chart
{
    Q_OBJECT

public:
    struct Dot {
        double value = 0.0; ///< of the parameter
        LimitValues limits{};
    };
    using Dots = std::vector<Dot>; ///< the current value first, then the pinned motions

    explicit ResponseChart(std::size_t limit); ///< index in LimitValues

    /// Returns the name of the limit with its unit.
    QString title() const;

    /// Replaces the curve. `title`: title of the parameter's axis.
    void setCurve(const Response &response, const QString &title);
    void setDots(const Dots &dots);
    const Dots &dots() const { return m_dots; }

    /// Returns the position of a dot, px.
    QPointF positionOf(const Dot &dot);

    /// Paints curve, shading and dots on any device.
    void paintAll(QPainter &painter, const QSize &size, const QPalette &palette) const;

signals:
    void requested(double value);
    void dragBegan();
    void dragEnded();

protected:
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    QRectF axisArea(); ///< px
    void paintDots(QPainter &painter, const QPalette &palette);
    void paintShade(QPainter &painter, const QPalette &palette);
    void requestAt(double pixel);

    std::size_t m_limit;
    ResponseRange m_range;
    Interval m_curveRange; ///< range of the limit on the curve, without the dots
    Dots m_dots;
    QPixmap m_picture; ///< the chart without dots, so that a moving dot does not redraw it; null: must be redrawn
};

} // namespace slidercrank
