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
    QString renderName; ///< its name on the command line; empty if `render` does not offer it
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

/// Returns a zoom in which the curves extend beyond their axes on every side.
inline PlotZoom closeZoom()
{
    PlotZoom zoom;
    zoom.time = Interval{0.2, 0.6};
    zoom.values[0] = Interval{10.0, 15.0};  // °
    zoom.values[1] = Interval{60.0, 70.0};  // mm
    zoom.values[3] = Interval{-50.0, 50.0}; // °/s
    zoom.values[5] = Interval{5.0, 100.0};  // %
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

/// Describes what is wrong with the curves. Returns an empty text if each plot has curves and all curves are within
/// their axes. `scale`: pixels of the picture per logical pixel.
inline QString curveFault(const QImage &picture, PictureSubject subject, double scale)
{
    const int plots = describe(subject).plots;
    const std::vector<QRect> axes = axesIn(picture, plots == 9 ? 3 : 1);
    if (axes.size() != static_cast<std::size_t>(plots)) {
        return QStringLiteral("%1 axes").arg(axes.size());
    }
    const int pen = static_cast<int>(2.0 * scale);    // half the width of a line and its smoothing
    const int title = static_cast<int>(15.0 * scale); // height of the title above the axes
    const SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    const std::array<QColor, 4> curves{colours.model, colours.reference, colours.error, colours.errorOther};
    std::vector<int> pixelsWithin(axes.size(), 0);
    const int legend = static_cast<int>(25.0 * scale); // height of the legend above the title
    const int width = picture.width();
    for (int y = std::max(legend, axes.front().top() - title); y < picture.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        for (int x = 0; x < width; ++x) {
            const QRgb colour = line[x];
            const auto isDrawn = [&](const QColor &curve) { return isSimilar(colour, curve); };
            if (colour == kWhite || isGrey(colour) || std::none_of(curves.begin(), curves.end(), isDrawn)) {
                continue;
            }
            bool isExpected = false;
            for (std::size_t i = 0; i < axes.size(); ++i) {
                // The title of an error plot ends with the largest errors in the colours of their curves.
                const bool hasColours =
                    subject == PictureSubject::Errors || (subject == PictureSubject::Figure && i % 3 == 2);
                const bool isWithin = axes[i].adjusted(-pen, -pen, pen, pen).contains(x, y);
                const bool isTitle = hasColours && axes[i].adjusted(0, -title, 0, -axes[i].height()).contains(x, y);
                pixelsWithin[i] += isWithin ? 1 : 0;
                isExpected = isExpected || isWithin || isTitle;
            }
            if (!isExpected) {
                return QStringLiteral("a curve at %1, %2").arg(x).arg(y);
            }
        }
    }
    const auto empty = std::ranges::find_if(pixelsWithin, [](int pixels) { return pixels < 50; });
    return empty == pixelsWithin.end() ? QString()
                                       : QStringLiteral("no curve in plot %1").arg(empty - pixelsWithin.begin());
}

/// Describes what is wrong with the picture. Returns an empty text if it shows the subject and has that size (px at 96
/// dpi).
inline QString pictureFault(const QString &path, PictureSubject subject, const QSize &size, double scale)
{
    const QString suffix = QFileInfo(path).suffix();
    const QImage picture = printedPicture(path);
    const bool isPdf = suffix == QLatin1String("pdf");
    const double pixels = isPdf ? 2.0 : suffix == QLatin1String("png") ? scale : 1.0;
    const QSize difference = picture.size() - size * pixels;
    const int rounding = isPdf ? 2 : 0; // because PDF pages are rounded to whole points
    if (std::max(std::abs(difference.width()), std::abs(difference.height())) > rounding) {
        return QStringLiteral("%1 x %2 pixels").arg(picture.width()).arg(picture.height());
    }
    if (isBlank(picture)) {
        return QStringLiteral("blank");
    }
    if (describe(subject).plots > 0) {
        if (const QString fault = curveFault(picture, subject, pixels); !fault.isEmpty()) {
            return fault;
        }
    }
    QString text;
    if (isPdf) {
        text = QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {"-layout", path, "-"}));
    } else if (suffix == QLatin1String("svg")) {
        static const QRegularExpression kTextElement(QStringLiteral("<text[^>]*>([^<]*)</text>"));
        QRegularExpressionMatchIterator matches = kTextElement.globalMatch(QString::fromUtf8(contentOf(path)));
        while (matches.hasNext()) {
            text += matches.next().captured(1);
        }
    } else {
        return {};
    }
    text.remove(u' '); // because a text may be stored in several pieces
    for (const QString &word : describe(subject).texts) {
        if (!text.contains(QString(word).remove(u' '))) {
            return QStringLiteral("no \"%1\" in %2").arg(word, text);
        }
    }
    return {};
}

} // namespace slidercrank
