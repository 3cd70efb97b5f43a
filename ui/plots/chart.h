// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A chart of points and lines over two axes, linear or logarithmic, with a legend. It knows no mechanism.

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
    enum class Line { None, Solid, Dashed, Steps }; ///< a step keeps the value of the point to its left

    QString name = {}; ///< in the legend; empty: not listed there
    QColor SeriesColours::*colour = &SeriesColours::model;
    std::vector<QPointF> points = {}; ///< ascending in x
    Line line = Line::None;
    QPainterPath mark = {};  ///< around the origin, in px; empty: none
    bool isHollow = false;   ///< the marks
    QStringList labels = {}; ///< beside the points, one each; may be empty
    QStringList tips = {};   ///< shown while the pointer is over a point, one each; may be empty
};

struct ChartAxis {
    QString title;
    Interval range; ///< of a logarithmic axis: positive
    bool isLogarithmic = false;
};

struct ChartContent {
    enum class Legend { Above, Right };

    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series = {};
    Legend legend = Legend::Above; ///< left out where there is too little room
};

class Chart : public QWidget
{
    Q_OBJECT

public:
    explicit Chart(QWidget *parent = nullptr);
    ~Chart() override;

    void setContent(const ChartContent &content);
    const ChartContent &content() const { return m_content; }

    /// A point of a series.
    struct Place {
        std::size_t series = 0;
        std::size_t point = 0;
        friend bool operator==(const Place &, const Place &) = default;
    };

    /// Puts a ring around that point.
    void setMarked(const std::optional<Place> &place);

    /// The marked point of a series under a position on the screen.
    std::optional<Place> pointAt(const QPointF &position);

    /// Where a point is drawn on the screen, px.
    QPointF positionOf(const Place &place);

    /// Without the ring, for any device.
    void paint(QPainter &painter, const QSize &size, const QPalette &palette);

signals:
    void pointed(const slidercrank::Chart::Place &place); ///< the pointer is over that point

protected:
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    void fill(const QSize &size, const QPalette &palette, const std::optional<Place> &marked);

    std::unique_ptr<PlotDrawing> m_drawing;
    ChartContent m_content;
    std::optional<Place> m_marked;
};

} // namespace slidercrank
