// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>

namespace slidercrank
{

/// Returns whether all pixels have the same colour.
inline bool isBlank(const QImage &image)
{
    QImage uniform = image;
    uniform.fill(image.pixelColor(0, 0));
    return image == uniform;
}

/// Returns the number of pixels of exactly that colour.
inline int countPixels(const QImage &image, const QColor &colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += image.pixelColor(x, y) == colour ? 1 : 0;
        }
    }
    return count;
}

} // namespace slidercrank
