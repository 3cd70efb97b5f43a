// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/theme.h"

namespace slidercrank
{

namespace
{

QPalette lightPalette()
{
    QPalette palette(QColor(0xf3, 0xf3, 0xf3));
    palette.setColor(QPalette::Window, QColor(0xf3, 0xf3, 0xf3));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::AlternateBase, QColor(0xf7, 0xf7, 0xf7));
    palette.setColor(QPalette::Text, QColor(0x1c, 0x1c, 0x1c));
    palette.setColor(QPalette::WindowText, QColor(0x1c, 0x1c, 0x1c));
    palette.setColor(QPalette::ButtonText, QColor(0x1c, 0x1c, 0x1c));
    palette.setColor(QPalette::PlaceholderText, QColor(0x6a, 0x6a, 0x6a));
    palette.setColor(QPalette::Highlight, QColor(0x00, 0x5f, 0xa3));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x00, 0x5f, 0xa3));
    palette.setColor(QPalette::ToolTipBase, Qt::white);
    palette.setColor(QPalette::ToolTipText, QColor(0x1c, 0x1c, 0x1c));
    for (const QPalette::ColorRole role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(0xa0, 0xa0, 0xa0));
    }
    return palette;
}

QPalette darkPalette()
{
    QPalette palette(QColor(0x2b, 0x2d, 0x30));
    palette.setColor(QPalette::Window, QColor(0x2b, 0x2d, 0x30));
    palette.setColor(QPalette::Base, QColor(0x1e, 0x1f, 0x22));
    palette.setColor(QPalette::AlternateBase, QColor(0x25, 0x27, 0x2a));
    palette.setColor(QPalette::Button, QColor(0x39, 0x3b, 0x40));
    palette.setColor(QPalette::Text, QColor(0xe6, 0xe6, 0xe6));
    palette.setColor(QPalette::WindowText, QColor(0xe6, 0xe6, 0xe6));
    palette.setColor(QPalette::ButtonText, QColor(0xe6, 0xe6, 0xe6));
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, QColor(0x9a, 0x9a, 0x9a));
    palette.setColor(QPalette::Highlight, QColor(0x2a, 0x76, 0xb8));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x6c, 0xb6, 0xf5));
    palette.setColor(QPalette::ToolTipBase, QColor(0x39, 0x3b, 0x40));
    palette.setColor(QPalette::ToolTipText, QColor(0xe6, 0xe6, 0xe6));
    for (const QPalette::ColorRole role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, QColor(0x7d, 0x7f, 0x84));
    }
    return palette;
}

} // namespace

QPalette paletteFor(Theme theme)
{
    switch (theme) {
    case Theme::System: return QPalette();
    case Theme::Light: return lightPalette();
    case Theme::Dark: return darkPalette();
    }
    return {};
}

SeriesColours seriesColours(const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Base).lightness() < 128;
    SeriesColours colours;
    colours.model = dark ? QColor(0x56, 0xb4, 0xe9) : QColor(0x00, 0x72, 0xb2);
    colours.reference = dark ? QColor(0xe6, 0x9f, 0x00) : QColor(0xd5, 0x5e, 0x00);
    colours.error = dark ? QColor(0xc2, 0x69, 0x95) : QColor(0x75, 0x1a, 0x63);
    colours.errorOther = dark ? QColor(0x57, 0xd9, 0x98) : QColor(0x00, 0x7d, 0x5c);
    colours.cursor = dark ? QColor(0xf0, 0xf0, 0xf0) : QColor(0x40, 0x40, 0x40);
    colours.warning = dark ? QColor(0xff, 0x8a, 0x65) : QColor(0xc0, 0x39, 0x2b);
    colours.grid = dark ? QColor(0x3c, 0x3f, 0x44) : QColor(0xe2, 0xe2, 0xe2);
    colours.text = palette.color(QPalette::Text);
    colours.background = palette.color(QPalette::Base);
    return colours;
}

} // namespace slidercrank
