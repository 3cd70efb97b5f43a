// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A chart of points and lines over two axes, linear or logarithmic. The legend is beside them or, where there is
// little space, over them or hidden. It knows no mechanism.

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
    QPainterPath mark = {}; ///< around the origin, in px; empty for no marks
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
    std::optional<Interval> unshaded = {}; ///< range of x without shade; a reversed range leaves none
};

class Chart : public QWidget
{
    Q_OBJECT

public:
    explicit Chart(QWidget *parent = nullptr);
    ~Chart() override;

    void setContent(const ChartContent &content);
    const ChartContent &content() const { return m_content; }

    /// Identifies a point of a series.
    struct Place {
        std::size_t series = 0;
        std::size_t point = 0;
        friend bool operator==(const Place &, const Place &) = default;
    };

    /// Returns the point with a mark at a position in the widget, or nullopt.
    std::optional<Place> pointAt(const QPointF &position);

    /// Returns the position (px) of a point in the widget.
    QPointF positionOf(const Place &place);

    /// Paints the chart on any paint device.
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
