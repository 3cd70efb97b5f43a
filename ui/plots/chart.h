// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A chart of points and lines over two axes, linear or logarithmic. The legend is beside the axes or, where there is
// little space, over the axes or hidden.

#include "ui/text/interval.h"
#include "ui/text/theme.h"

#include <QPainterPath>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace slidercrank
{

class PlotDrawing;

struct ChartSeries {
    enum class Line { None, Solid, Dashed };

    QString name = {}; ///< in the legend; a series without a name is not listed
    QColor SeriesColours::*colour = &SeriesColours::model;
    std::vector<QPointF> points = {}; ///< ascending in x
    Line line = Line::None;
    QPainterPath mark = {}; ///< shape drawn at each point, around the origin, px; may be empty
    bool isHollow = false;  ///< whether the marks are outlines
    QStringList tips = {};  ///< the tool tip of each point; may be empty
};

struct ChartAxis {
    QString title;
    Interval range; ///< positive if the axis is logarithmic
    bool isLogarithmic = false;
};

struct ChartContent {
    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series = {};
    std::optional<Interval> unshaded = {}; ///< range of x without shade; if it is reversed, all is shaded
};

class Chart : public QWidget
{
    Q_OBJECT

public:
    explicit Chart(QWidget *parent = nullptr);
    ~Chart() override;

    void setContent(const ChartContent &content);
    const ChartContent &content() const { return m_content; }

    struct PointIndex {
        std::size_t series = 0;
        std::size_t point = 0;
        friend bool operator==(const PointIndex &, const PointIndex &) = default;
    };

    /// Returns the marked point nearest to a position in the widget (px); nullopt if none is within a few pixels.
    std::optional<PointIndex> pointAt(const QPointF &position);

    /// Returns the position (px) of a point in the widget.
    QPointF positionOf(const PointIndex &index);

    void paint(QPainter &painter, const QSize &size, const QPalette &palette);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    void rebuildDrawing(const QSize &size, const QFont &font, const QPalette &palette);

    std::unique_ptr<PlotDrawing> m_drawing;
    ChartContent m_content;
};

} // namespace slidercrank
