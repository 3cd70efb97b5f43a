// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace slidercrank
{

/// Returns an area without a frame that contains a widget and scrolls it where it does not fit.
inline QScrollArea *scrollable(QWidget *content)
{
    auto *area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus); // the Tab key stops at the content only
    area->setWidgetResizable(true);
    area->setWidget(content);
    return area;
}

} // namespace slidercrank
