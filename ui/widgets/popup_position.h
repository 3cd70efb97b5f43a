// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace slidercrank
{

/// Returns the global position of a popup of that size: below the widget and aligned with its right edge, or above it
/// at the lower edge of the screen.
inline QPoint popupPosition(const QWidget &widget, const QSize &size)
{
    const QRect available = widget.screen()->availableGeometry();
    QRect place(QPoint(), size);
    place.moveTopRight(widget.mapToGlobal(widget.rect().bottomRight()) + QPoint(0, 1));
    if (place.bottom() > available.bottom()) {
        place.moveBottom(widget.mapToGlobal(QPoint()).y() - 1);
    }
    return {std::max(place.left(), available.left()), place.top()};
}

} // namespace slidercrank
