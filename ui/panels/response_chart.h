// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The curve of one limit over a parameter, with a dot at the present value that can be dragged with the mouse or moved
// by keys.

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
    using Dots = std::vector<Dot>; ///< the present value first, then pinned motions

    explicit ResponseChart(Limit limit);

    /// The limit with its unit.
    QString title() const;

    /// `title`: of the axis of the parameter.
    void setCurve(const Response &response, const QString &title);
    void setDots(const Dots &dots);
    const Dots &dots() const { return m_dots; }

    /// Where a dot is drawn, px.
    QPointF positionOf(const Dot &dot);

    /// With shade and dots, for any device.
    void paintAll(QPainter &painter, const QSize &size, const QPalette &palette) const;

signals:
    void requested(double value);
    void dragBegan();
    void dragEnded();

protected:
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRectF axisArea(); ///< px
    void paintDots(QPainter &painter, const QPalette &palette);
    void paintShade(QPainter &painter, const QPalette &palette);
    void request(double value);
    double keyStep(int key) const;
    void requestAt(double pixel);

    std::size_t m_limit;
    ResponseRange m_range;
    Interval m_curveRange; ///< of the limit, without the dots
    Dots m_dots;
    QPixmap m_picture; ///< the chart without dots: they move without it being drawn again; null: out of date
    bool m_isDragging = false;
};

} // namespace slidercrank
