// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exports figures to files and to the clipboard. A figure is a function that draws with a QPainter at a given size. A
// file is written completely or not at all.

#include "core/mechanism/mechanism.h"

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <stop_token>

class QPainter;
class QPageSize;
class QPalette;
class QPdfWriter;

namespace slidercrank
{

enum class FigureFormat { Png, Svg, Pdf };

/// Returns the format by the suffix of the file name, ignoring case, or nullopt for other suffixes.
std::optional<FigureFormat> figureFormat(const QString &path);

/// Returns "png", "svg" or "pdf".
QString suffixOf(FigureFormat format);

inline constexpr int kLogicalPixelsPerInch = 96; ///< as in SVG and CSS

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kPointsPerInch = 72.0;

/// The size of a figure. A drawing is made for a whole number of logical pixels and then scaled to the exact size.
struct FigureSize {
    QSize size{1400, 900};        ///< logical pixels
    double scale = 1.0;           ///< device pixels per logical pixel, for PNG and the clipboard
    double paperPixel = 1.0;      ///< size of a logical pixel in SVG and PDF, in 1/96 inch
    bool isInMillimetres = false; ///< whether SVG states its size in mm, and PNG its resolution
    int fontPixels = 0;           ///< of the painter's font; 0 for the size of the application's font
};

/// The size and the content of an exported figure, as the user chooses them.
struct FigureOptions {
    enum class Unit { Millimetre, Pixel };

    double width = 160.0; ///< a column of text on A4
    Unit unit = Unit::Millimetre;
    double fontSize = 9.0;    ///< points of 1/72 inch
    QStringList plots = {};   ///< names in PlotGrid; empty for all that can be shown
    bool showsCursor = false; ///< whether the values at the current time are written
    FigureFormat format = FigureFormat::Png;

    friend bool operator==(const FigureOptions &, const FigureOptions &) = default;
};

/// The width and the font size that a figure can have.
inline constexpr double kMinFigureWidthMm = 20.0;
inline constexpr double kMaxFigureWidthMm = 1000.0;
inline constexpr double kMinFigureWidthPx = 100.0;
inline constexpr double kMaxFigureWidthPx = 20'000.0;
inline constexpr double kSmallestFont = 4.0; ///< pt
inline constexpr double kLargestFont = 48.0; ///< pt

/// Returns the height (logical pixels) of a figure with the given width and font.
using FigureHeight = std::function<int(int width, const QFont &)>;

/// Returns the size of a figure with the width of the options, at 300 dots per inch if the width is in mm. `height`
/// chooses the height.
FigureSize figureSize(const FigureOptions &options, const FigureHeight &height);

/// Draws a figure, with its background, at a logical size from the origin, with text in the font of the painter.
using FigureDrawing = std::function<void(QPainter &, const QSize &)>;

/// Returns the same drawing with the mechanism's parameters below it, in as many lines as they need.
FigureDrawing withParameters(const FigureDrawing &draw, const Mechanism &mechanism, const QPalette &palette);

/// Returns the height of a figure with the mechanism's parameters below it.
FigureHeight withParameters(const FigureHeight &height, const Mechanism &mechanism);

/// Returns the figure as an image; a null image if the size is impossible, or if there is not enough memory.
QImage figureImage(const FigureSize &size, const FigureDrawing &draw);

/// Writes the figure to a file, with `title` in its metadata. Returns nullopt on success, else a message that says why
/// not; an older file of that name is then unchanged.
std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw);

/// Writes a figure that has been drawn, with the result of exportFigure(). Can run in any thread. Writes nothing if
/// stopped.
using FigureWriter = std::function<std::optional<QString>(const std::stop_token &stop)>;

/// Draws the figure in memory. The returned function compresses it, which takes longer, and writes it.
FigureWriter drawFigure(const QString &path, const FigureSize &size, const QString &title, const FigureDrawing &draw);

/// Prepares a PDF with pages of that size, at kLogicalPixelsPerInch, without margins.
void preparePdf(QPdfWriter &writer, const QPageSize &page, const QString &title);

/// Copies the figure to the clipboard as an image. Returns nullopt on success, else a message that says why not.
std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw);

} // namespace slidercrank
