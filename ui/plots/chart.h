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
    enum class Line { None, Solid, Dashed, Steps }; ///< Steps keeps the value of a point until the next one

    QString name = {}; ///< in the legend; a series without a name is not listed
    QColor SeriesColours::*colour = &SeriesColours::model;
    std::vector<QPointF> points = {}; ///< ascending in x
    Line line = Line::None;
    QPainterPath mark = {};  ///< around the origin, in px; empty for no marks
    bool isHollow = false;   ///< whether the marks are outlines
    QStringList labels = {}; ///< one beside each point; may be empty
    QStringList tips = {};   ///< the tool tip of each point; may be empty
};

struct ChartAxis {
    QString title;
    Interval range; ///< positive if the axis is logarithmic
    bool isLogarithmic = false;
};

struct ChartContent {
    enum class Legend { Above, Right };

    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series = {};
    Legend legend = Legend::Above; ///< hidden where there is too little space
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

    /// Draws a ring around that point; nullopt removes it.
    void setMarked(const std::optional<Place> &place);

    /// Returns the marked point at a position in the widget, or nullopt.
    std::optional<Place> pointAt(const QPointF &position);

    /// Returns the position (px) of a point in the widget.
    QPointF positionOf(const Place &place);

    /// Paints the chart, without the ring, on any paint device.
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
