// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/theme.h"

#include <QWidget>

#include <cmath>

namespace slidercrank
{

namespace
{

struct RoleColours {
    QPalette::ColorRole role;
    QRgb light;
    QRgb dark;
};

constexpr RoleColours kRoles[] = {
    {QPalette::Button, 0xf3f3f3, 0x393b40},        {QPalette::Base, 0xffffff, 0x1e1f22},
    {QPalette::AlternateBase, 0xf7f7f7, 0x25272a}, {QPalette::PlaceholderText, 0x6a6a6a, 0x9a9a9a},
    {QPalette::Highlight, 0x005fa3, 0x2a76b8},     {QPalette::HighlightedText, 0xffffff, 0xffffff},
    {QPalette::Link, 0x005fa3, 0x6cb6f5},          {QPalette::ToolTipBase, 0xffffff, 0x393b40}};

} // namespace

QPalette paletteFor(Theme theme)
{
    if (theme == Theme::System) {
        return {};
    }
    const bool isDark = theme == Theme::Dark;
    QPalette palette(QColor(isDark ? 0x2b2d30 : 0xf3f3f3)); // Qt derives the other shades from it
    for (const RoleColours &colours : kRoles) {
        palette.setColor(colours.role, QColor(isDark ? colours.dark : colours.light));
    }
    for (const QPalette::ColorRole role :
         {QPalette::Text, QPalette::WindowText, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(role, QColor(isDark ? 0xe6e6e6 : 0x1c1c1c));
        palette.setColor(QPalette::Disabled, role, QColor(isDark ? 0x7d7f84 : 0xa0a0a0));
    }
    return palette;
}

SeriesColours seriesColours(const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    const auto pick = [dark](QRgb light, QRgb onDark) { return QColor(dark ? onDark : light); };
    const QColor purple = pick(0x751a63, 0xc26995);
    const QColor green = pick(0x007d5c, 0x57d998);
    return {.model = pick(0x0072b2, 0x56b4e9),
            .reference = pick(0xd55e00, 0xe69f00),
            .pinnedFirst = pick(0x585858, 0xb8b8b8),
            .pinnedSecond = pick(0x8a5a00, 0xd9b26a),
            .pinnedThird = pick(0xa01830, 0xff9db0),
            .pinnedFourth = pick(0x3d3d9c, 0xb3b3ff),
            .couplerError = purple,
            .sliderError = green,
            .velocity = green,
            .acceleration = purple,
            .highlight = purple,
            .good = green,
            .cursor = pick(0x404040, 0xf0f0f0),
            .warning = pick(0xc0392b, 0xff8a65),
            .grid = pick(0xe2e2e2, 0x3c3f44),
            .text = palette.color(QPalette::Text),
            .background = palette.color(QPalette::Base)};
}

QColor mixed(const QColor &colour, const QColor &background, double share)
{
    const auto blend = [share](float x, float y) { return std::lerp(y, x, static_cast<float>(share)); };
    return QColor::fromRgbF(blend(colour.redF(), background.redF()), blend(colour.greenF(), background.greenF()),
                            blend(colour.blueF(), background.blueF()));
}

void setInk(QWidget &widget, const QColor &ink)
{
    QPalette palette = widget.palette();
    palette.setColor(QPalette::WindowText, ink);
    widget.setPalette(palette);
}

} // namespace slidercrank
