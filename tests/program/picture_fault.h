// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks the pixels and the texts of exported pictures.

#include "tests/support/pixels.h"
#include "tests/support/place_of_a_save.h"
#include "tests/support/printed_picture.h"
#include "ui/document/view_settings.h"
#include "ui/text/theme.h"

#include <QColor>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace slidercrank
{

enum class PictureSubject { Figure, Plot, Errors, Mechanism, Study };

struct SubjectDescription {
    const char *name;
    QString renderName; ///< value of `render --what`; empty if `render` does not offer the subject
    int plots;          ///< number of plots in the picture
    QStringList texts;  ///< texts that the picture must contain
};

inline const SubjectDescription &describe(PictureSubject subject)
{
    static const std::array kDescriptions{
        SubjectDescription{"figure",
                           "figure",
                           9,
                           {"t [s]", "coupler angle θ³ [°]", "slider position Rₓ⁴ [mm]", "ω³ = dθ³/dt [°/s]",
                            "a⁴ = dv⁴/dt [mm/s²]", "error [% of peak]", "inventor_sample.csv"}},
        SubjectDescription{"plot", "theta3", 1, {"t [s]", "coupler angle θ³ [°]", "model", "inventor_sample.csv"}},
        SubjectDescription{"errors", "error_velocity", 1, {"t [s]", "error [% of peak]", "error of the coupler"}},
        SubjectDescription{"mechanism", "mechanism", 0, {"mm", "−20", "60"}},
        SubjectDescription{"study", "", 0, {"closed form"}},
    };
    return kDescriptions[static_cast<std::size_t>(subject)];
}

/// Returns the number of the plot with that plotName(), or kPlotCount if there is none.
inline std::size_t plotNamed(const char *name)
{
    std::size_t plot = 0;
    while (plot < kPlotCount && plotName(plot) != QLatin1String(name)) {
        ++plot;
    }
    return plot;
}

/// Returns a zoom in which the curves extend beyond their axes on every side.
inline PlotZoom zoomInsideCurves()
{
    PlotZoom zoom;
    zoom.time = Interval{0.2, 0.6};
    zoom.values[plotNamed("plot_theta3")] = Interval{10.0, 15.0};         // °
    zoom.values[plotNamed("plot_R4_x")] = Interval{60.0, 70.0};           // mm
    zoom.values[plotNamed("plot_theta3_diff")] = Interval{-50.0, 50.0};   // °/s
    zoom.values[plotNamed("plot_error_velocity")] = Interval{5.0, 100.0}; // %
    return zoom;
}

/// Whether two colours are the same, except for the smoothing of edges.
inline bool isSimilar(QRgb pixel, const QColor &colour)
{
    constexpr int kTolerance = 70;
    return std::abs(qRed(pixel) - colour.red()) + std::abs(qGreen(pixel) - colour.green()) +
               std::abs(qBlue(pixel) - colour.blue()) <
           kTolerance;
}

/// Whether a pixel has the colour of a curve, except for the smoothing of edges.
inline bool hasCurveColour(QRgb pixel)
{
    static const SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    static const std::array<QColor, 4> curves{colours.model, colours.reference, colours.couplerError,
                                              colours.sliderError};
    if (pixel == kWhite || isGrey(pixel)) { // decides most pixels quickly
        return false;
    }
    return std::ranges::any_of(curves, [pixel](const QColor &curve) { return isSimilar(pixel, curve); });
}

/// The areas of one plot in which the colours of curves may occur, px.
struct PlotArea {
    QRect axes;
    QRect curves;        ///< the axes with a margin of half the width of a line and its smoothing
    QRect colouredTitle; ///< null if the title has no colours
    int curvePixels = 0; ///< number of pixels in `curves` that have the colour of a curve
};

/// Returns the areas of each plot in the picture. The title of an error plot ends with the largest errors in the
/// colours of their curves.
inline std::vector<PlotArea> plotAreas(const QImage &picture, PictureSubject subject, double scale, int titleHeight)
{
    const int margin = static_cast<int>(2.0 * scale); // px
    const bool isFigure = subject == PictureSubject::Figure;
    std::vector<PlotArea> plots;
    for (const QRect &axes : axesIn(picture, isFigure ? static_cast<int>(kPlotColumns) : 1)) {
        PlotArea plot{.axes = axes, .curves = axes.adjusted(-margin, -margin, margin, margin), .colouredTitle = {}};
        if (subject == PictureSubject::Errors || (isFigure && isErrorPlot(plots.size()))) {
            plot.colouredTitle = axes.adjusted(0, -titleHeight, 0, -axes.height());
        }
        plots.push_back(plot);
    }
    return plots;
}

/// Describes what is wrong with the curves. Returns an empty text if each plot has curves and all curves are within
/// their axes. `scale`: pixels of the picture per logical pixel.
inline QString curveFault(const QImage &picture, PictureSubject subject, double scale)
{
    constexpr int kMinPixels = 50; // of the curves of a plot
    const double titleHeight = 15.0 * scale;
    const double legendHeight = 25.0 * scale;
    std::vector<PlotArea> plots = plotAreas(picture, subject, scale, static_cast<int>(titleHeight));
    if (plots.size() != static_cast<std::size_t>(describe(subject).plots)) {
        return QStringLiteral("%1 axes").arg(plots.size());
    }
    const int top = std::max(static_cast<int>(legendHeight), plots.front().axes.top() - static_cast<int>(titleHeight));
    const int width = picture.width();
    for (int y = top; y < picture.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        for (int x = 0; x < width; ++x) {
            if (!hasCurveColour(line[x])) {
                continue;
            }
            bool isExpected = false;
            for (PlotArea &plot : plots) {
                const bool isCurve = plot.curves.contains(x, y);
                plot.curvePixels += isCurve ? 1 : 0;
                isExpected = isExpected || isCurve || plot.colouredTitle.contains(x, y);
            }
            if (!isExpected) {
                return QStringLiteral("a curve at %1, %2").arg(x).arg(y);
            }
        }
    }
    const auto empty = std::ranges::find_if(plots, [](const PlotArea &plot) { return plot.curvePixels < kMinPixels; });
    return empty == plots.end() ? QString() : QStringLiteral("no curve in plot %1").arg(empty - plots.begin());
}

inline bool isPdf(const QString &path)
{
    return QFileInfo(path).suffix() == QLatin1String("pdf");
}

inline bool isSvg(const QString &path)
{
    return QFileInfo(path).suffix() == QLatin1String("svg");
}

/// Returns the side of a logical pixel in the picture of printedPicture(), px. `pngScale`: that side for PNG files.
inline double pixelsPerLogicalPixel(const QString &path, double pngScale)
{
    if (isPdf(path)) {
        return 2.0;
    }
    return isSvg(path) ? 1.0 : pngScale;
}

/// Returns the texts of a PDF or SVG file without spaces, because a text may be stored in several pieces.
inline QString textsWithoutSpaces(const QString &path)
{
    QString text;
    if (isPdf(path)) {
        text = QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {"-layout", path, "-"}));
    } else {
        static const QRegularExpression kTextElement(QStringLiteral("<text[^>]*>([^<]*)</text>"));
        QRegularExpressionMatchIterator matches = kTextElement.globalMatch(QString::fromUtf8(contentOf(path)));
        while (matches.hasNext()) {
            text += matches.next().captured(1);
        }
    }
    return text.remove(u' ');
}

/// Names a text of the subject that a PDF or SVG file lacks. Returns an empty text if it has all of them.
inline QString textFault(const QString &path, PictureSubject subject)
{
    const QString texts = textsWithoutSpaces(path);
    for (const QString &text : describe(subject).texts) {
        if (!texts.contains(QString(text).remove(u' '))) {
            return QStringLiteral("no \"%1\" in %2").arg(text, texts);
        }
    }
    return {};
}

/// Describes what is wrong with the picture. Returns an empty text if it shows the subject and has `size` (px at 96
/// dpi). `pngScale`: pixels of a PNG file per logical pixel.
inline QString pictureFault(const QString &path, PictureSubject subject, const QSize &size, double pngScale)
{
    const QImage picture = printedPicture(path);
    const double scale = pixelsPerLogicalPixel(path, pngScale);
    const QSize difference = picture.size() - size * scale;
    const int rounding = isPdf(path) ? 2 : 0; // because PDF pages are rounded to whole points
    if (std::max(std::abs(difference.width()), std::abs(difference.height())) > rounding) {
        return QStringLiteral("%1 x %2 pixels").arg(picture.width()).arg(picture.height());
    }
    if (isBlank(picture)) {
        return QStringLiteral("blank");
    }
    if (describe(subject).plots > 0) {
        if (const QString fault = curveFault(picture, subject, scale); !fault.isEmpty()) {
            return fault;
        }
    }
    return isPdf(path) || isSvg(path) ? textFault(path, subject) : QString();
}

} // namespace slidercrank
