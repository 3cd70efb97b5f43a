// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>

namespace slidercrank
{

/// The fonts of a figure. Sizes are in pixels, not points, so that text has the right size on every device.
struct PlotFonts {
    explicit PlotFonts(const QFont &base = {});

    QFont title;
    QFont tick;
    double lineFactor = 1.0; ///< factor of the line widths; above 1 for large fonts
};

/// Width (px) of an ordinary curve, to be multiplied by PlotFonts::lineFactor.
inline constexpr double kCurveWidth = 2.0;

} // namespace slidercrank
