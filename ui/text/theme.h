// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Defines the light and the dark theme and the colours of curves. Colours follow M. Okabe and K. Ito, "Color Universal
// Design", 2008. The two error colours differ more in lightness, so that colour-blind users can distinguish them.

#include <QColor>
#include <QPalette>

#include <array>

class QWidget;

namespace slidercrank
{

/// The settings store the number of the enumerator.
enum class Theme { System = 0, Light = 1, Dark = 2 };

/// Returns a palette for the Fusion style. Theme::System returns the platform's palette.
QPalette paletteFor(Theme theme);

/// The colours of the drawing and the plots, chosen for contrast with the palette's base colour.
struct SeriesColours {
    QColor model;       ///< solid curves, the mechanism's links
    QColor reference;   ///< dashed curves
    QColor pinnedFirst; ///< thin curves of pinned motions (kPinnedColours)
    QColor pinnedSecond;
    QColor pinnedThird;
    QColor pinnedFourth;
    QColor couplerError; ///< errors of the coupler
    QColor sliderError;  ///< errors of the slider, in the same axes
    QColor velocity;     ///< vectors in the drawing and in a polygon, and the path of a point
    QColor acceleration; ///< vectors in the drawing and in a polygon
    QColor highlight;    ///< the part of the mechanism that another view names
    QColor good;         ///< Tone::Good
    QColor cursor;       ///< the current time
    QColor warning;      ///< crank angles at which the mechanism cannot be assembled, and warnings
    QColor grid;
    QColor text;
    QColor background;
};
SeriesColours seriesColours(const QPalette &palette);

/// The colours of the pinned motions, the oldest first.
inline constexpr std::array kPinnedColours{&SeriesColours::pinnedFirst, &SeriesColours::pinnedSecond,
                                           &SeriesColours::pinnedThird, &SeriesColours::pinnedFourth};

/// Returns an opaque mixture of two colours. `share`: the fraction of `colour`, 0 to 1.
QColor mixed(const QColor &colour, const QColor &background, double share);

/// Sets the text colour of a widget.
void setInk(QWidget &widget, const QColor &ink);

} // namespace slidercrank
