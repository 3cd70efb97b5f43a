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
    constexpr int kSmallest = 9;
    constexpr double kTickPart = 0.87;
    constexpr double kUsual = 15.0; // px, at most
    const int pixels = QFontInfo(base).pixelSize();
    title.setPixelSize(pixels);
    tick.setPixelSize(std::max(kSmallest, static_cast<int>(std::lround(kTickPart * pixels))));
    lineFactor = std::max(1.0, pixels / kUsual);
}

} // namespace slidercrank
