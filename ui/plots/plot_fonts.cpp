// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_fonts.h"

#include <QFontInfo>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PlotFonts::PlotFonts(const QFont &base)
    : title(base)
    , tick(base)
{
    constexpr int kMinPixels = 9; // smallest size of tick labels
    constexpr double kTickFraction = 0.87;
    constexpr double kMaxUsualPixels = 15.0; // with larger text, lines become thicker
    const int pixels = QFontInfo(base).pixelSize();
    title.setPixelSize(pixels);
    tick.setPixelSize(std::max(kMinPixels, static_cast<int>(std::lround(kTickFraction * pixels))));
    lineFactor = std::max(1.0, pixels / kMaxUsualPixels);
}

} // namespace slidercrank
