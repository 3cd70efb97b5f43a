// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/theme.h"

#include <QWidget>

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
    {QPalette::Window, 0xf3f3f3, 0x2b2d30},     {QPalette::Button, 0xf3f3f3, 0x393b40},
    {QPalette::Base, 0xffffff, 0x1e1f22},       {QPalette::AlternateBase, 0xf7f7f7, 0x25272a},
    {QPalette::Text, 0x1c1c1c, 0xe6e6e6},       {QPalette::WindowText, 0x1c1c1c, 0xe6e6e6},
    {QPalette::ButtonText, 0x1c1c1c, 0xe6e6e6}, {QPalette::PlaceholderText, 0x6a6a6a, 0x9a9a9a},
    {QPalette::Highlight, 0x005fa3, 0x2a76b8},  {QPalette::HighlightedText, 0xffffff, 0xffffff},
    {QPalette::Link, 0x005fa3, 0x6cb6f5},       {QPalette::ToolTipBase, 0xffffff, 0x393b40},
    {QPalette::ToolTipText, 0x1c1c1c, 0xe6e6e6}};

QPalette paletteOf(bool dark)
{
    QPalette palette(QColor(dark ? 0x2b2d30 : 0xf3f3f3)); // Qt derives the other shades from it
    for (const RoleColours &colours : kRoles) {
        palette.setColor(colours.role, QColor(dark ? colours.dark : colours.light));
    }
    if (dark) {
        palette.setColor(QPalette::BrightText, Qt::white);
    }
    for (const QPalette::ColorRole role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(dark ? 0x7d7f84 : 0xa0a0a0));
    }
    return palette;
}

} // namespace

QPalette paletteFor(Theme theme)
{
    switch (theme) {
    case Theme::System: return QPalette();
    case Theme::Light: return paletteOf(false);
    case Theme::Dark: return paletteOf(true);
    }
    return {};
}

SeriesColours seriesColours(const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    return {.model = dark ? QColor(0x56, 0xb4, 0xe9) : QColor(0x00, 0x72, 0xb2),
            .reference = dark ? QColor(0xe6, 0x9f, 0x00) : QColor(0xd5, 0x5e, 0x00),
            .pinned = dark ? QColor(0xb8, 0xb8, 0xb8) : QColor(0x58, 0x58, 0x58),
            .error = dark ? QColor(0xc2, 0x69, 0x95) : QColor(0x75, 0x1a, 0x63),
            .errorOther = dark ? QColor(0x57, 0xd9, 0x98) : QColor(0x00, 0x7d, 0x5c),
            .cursor = dark ? QColor(0xf0, 0xf0, 0xf0) : QColor(0x40, 0x40, 0x40),
            .warning = dark ? QColor(0xff, 0x8a, 0x65) : QColor(0xc0, 0x39, 0x2b),
            .grid = dark ? QColor(0x3c, 0x3f, 0x44) : QColor(0xe2, 0xe2, 0xe2),
            .text = palette.color(QPalette::Text),
            .background = palette.color(QPalette::Base)};
}

void setInk(QWidget &widget, const QColor &ink)
{
    QPalette palette = widget.palette();
    palette.setColor(QPalette::WindowText, ink);
    widget.setPalette(palette);
}

} // namespace slidercrank
