// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exports figures to files and to the clipboard. A figure is a function that draws with a QPainter at a given size. A
// file is written completely or not at all.

#include "core/mechanism/mechanism.h"

#include <QByteArray>
#include <QSize>
#include <QString>

#include <functional>
#include <optional>

class QPainter;
class QPageSize;
class QPalette;
class QPdfWriter;

namespace slidercrank
{

enum class FigureFormat { Png, Svg, Pdf };

/// Returns the format by the suffix of the file name, ignoring case, or nullopt.
std::optional<FigureFormat> figureFormat(const QString &path);

inline constexpr int kDotsPerInch = 96; ///< logical pixels, as in SVG and CSS

struct FigureSize {
    QSize size{1400, 900}; ///< logical pixels
    double scale = 1.0;    ///< device pixels per logical pixel, for PNG and the clipboard
};

/// Draws the figure, with its background, at that logical size from the origin.
using FigureDrawing = std::function<void(QPainter &, const QSize &)>;

/// Returns the same drawing with the mechanism's parameters in a line below it.
FigureDrawing withParameters(const FigureDrawing &draw, const Mechanism &mechanism, const QPalette &palette);

/// Writes the figure to a file, with `title` in its metadata. Returns nullopt on success, else a message that says why
/// not; an older file of that name is then unchanged.
std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw);

/// Returns a PDF of such pages in the resolution kDotsPerInch. `fill` draws on the first page.
QByteArray makePdf(const QPageSize &page, const QString &title, const std::function<void(QPdfWriter &)> &fill);

/// Copies the figure to the clipboard as an image. Returns as exportFigure().
std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw);

} // namespace slidercrank
