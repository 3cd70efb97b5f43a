// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figures to files and to the clipboard. Whatever can draw itself with a QPainter at a given size can be written; a
// file is written whole or not at all.

#include "core/mechanism/mechanism.h"

#include <QByteArray>
#include <QSize>
#include <QString>

#include <functional>
#include <optional>

class QImage;
class QPainter;
class QPalette;

namespace slidercrank
{

enum class FigureFormat { Png, Svg, Pdf };

/// By the file name's suffix, in any case.
std::optional<FigureFormat> figureFormatOf(const QString &path);

inline constexpr int kDotsPerInch = 96; ///< logical pixels, as in SVG and CSS

struct FigureSize {
    QSize size{1400, 900}; ///< logical pixels
    double scale = 1.0;    ///< PNG and clipboard: device pixels per logical pixel
};

/// Draws the figure at that logical size, from the origin, background included.
using FigureDrawing = std::function<void(QPainter &, const QSize &)>;

/// The same drawing with the mechanism's parameters in a line below it.
FigureDrawing withParameters(const FigureDrawing &draw, const Mechanism &mechanism, const QPalette &palette);

/// Nothing when the file was written, else a sentence that says why not; then an older file of that name is still
/// there. `title`: for the file's own description.
std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw);

/// Empty when there is not enough memory.
QByteArray pngOf(const QImage &image);

/// As exportFigure(), an image to the clipboard.
std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw);

} // namespace slidercrank
