// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Light and dark, and the one table of series colours: after Okabe and Ito, Color Universal Design, 2008, the two of
// the errors farther apart in lightness, so that those who see no red or no green tell them apart in the same axes,
// too.

#include <QColor>
#include <QPalette>

class QWidget;

namespace slidercrank
{

enum class Theme { System, Light, Dark };

/// A Fusion palette; for System that of the platform.
QPalette paletteFor(Theme theme);

/// What the drawing and the plots use, chosen to stand out against the palette's base colour.
struct SeriesColours {
    QColor model;      ///< solid curves, the mechanism's links
    QColor reference;  ///< dashed curves
    QColor pinned;     ///< thin curves of pinned motions
    QColor error;      ///< angle errors
    QColor errorOther; ///< length errors, drawn in the same axes
    QColor cursor;     ///< the current instant
    QColor warning;    ///< forbidden arcs, what cannot be
    QColor grid;
    QColor text;
    QColor background;
};
SeriesColours seriesColours(const QPalette &palette);

/// What is written on the widget.
void setInk(QWidget &widget, const QColor &ink);

} // namespace slidercrank
