// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One plot: a QCustomPlot that shows a PlotPicture and otherwise does nothing of its own.

#include "ui/plots/plot_arrangement.h"
#include "ui/plots/plot_figure.h"
#include "ui/text/theme.h"

#include <qcustomplot.h>

namespace slidercrank
{

class PlotCanvas : public QCustomPlot
{
public:
    explicit PlotCanvas(QWidget *parent);

    void setStyle(const PlotTypography &typography, const SeriesColours &colours);
    void display(const PlotPicture &picture, const QMargins &margins);

    const Interval &timeRange() const { return m_picture.time; }
    const Interval &valueRange() const { return m_picture.values; }
    bool hasValues() const { return m_picture.hasValues; }
    /// In parts without gaps.
    std::vector<QPolygonF> curvesInPixels() const;

    const QCPAxis *valueAxisOf(std::size_t curve) const { return curve == 1 && m_picture.rightValues ? yAxis2 : yAxis; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QCPGraph *addCurve();

    /// The picture with its background in it: shown by copying, where QCustomPlot's own, transparent one is blended.
    class OpaqueBuffer : public QCPAbstractPaintBuffer
    {
    public:
        OpaqueBuffer(const PlotCanvas *plot, double devicePixelRatio);
        QCPPainter *startPainting() override;
        void draw(QCPPainter *painter) const override { painter->drawPixmap(0, 0, m_pixmap); }
        void clear(const QColor &colour) override;

    protected:
        void reallocateBuffer() override;

    private:
        const PlotCanvas *m_plot;
        QPixmap m_pixmap;
    };

    /// Title, unit of the time axis, marks and dots: what QCustomPlot has no cheap element for.
    class Lettering : public QCPLayerable
    {
    public:
        explicit Lettering(PlotCanvas *plot)
            : QCPLayerable(plot, QStringLiteral("axes"))
            , m_plot(plot)
        {
        }

    protected:
        void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(true); }
        void draw(QCPPainter *painter) override;

    private:
        bool hasValueBesideTitle(const QRect &axes) const;
        void drawTitle(QCPPainter &painter, const QRect &axes) const;
        PlotCanvas *m_plot;
    };

    /// What the file's rounding alone may make, under the curves.
    class Bands : public QCPLayerable
    {
    public:
        explicit Bands(PlotCanvas *plot)
            : QCPLayerable(plot, QStringLiteral("grid"))
            , m_plot(plot)
        {
        }

    protected:
        void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(true); }
        QRect clipRect() const override { return m_plot->axisRect()->rect(); }
        void draw(QCPPainter *painter) override;

    private:
        PlotCanvas *m_plot;
    };

    /// The axis' coordinates are zero + perUnit·label.
    class Ticker : public QCPAxisTicker
    {
    public:
        AxisScale scale;
        double zero = 0.0;
        double perUnit = 1.0;

    protected:
        double getTickStep(const QCPRange &) override { return scale.step * std::abs(perUnit); }
        int getSubTickCount(double) override { return 0; }
        QString getTickLabel(double tick, const QLocale &locale, QChar, int) override
        {
            return scale.label((tick - zero) / perUnit, locale);
        }
    };

    PlotPicture m_picture;
    std::vector<QCPGraph *> m_kept; ///< lines under the others; made when one is kept
    QFont m_titleFont;
    QFont m_tickFont;
    double m_lineFactor = 1.0;
    SeriesColours m_colours;
    QSharedPointer<Ticker> m_timeTicker;
    QSharedPointer<Ticker> m_valueTicker;
    QSharedPointer<Ticker> m_rightTicker;
};

} // namespace slidercrank
