// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segmented_pages.h"

#include "ui/widgets/named.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

namespace slidercrank
{

SegmentedPages::SegmentedPages(const QString &buttonName, QWidget *parent)
    : QWidget(parent)
    , m_buttonName(buttonName)
    , m_buttons(new QButtonGroup(this))
    , m_column(new QVBoxLayout)
    , m_stack(new QStackedWidget)
{
    m_column->setSpacing(1);
    m_column->addStretch(1);
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(4, 4, 4, 2);
    columns->addLayout(m_column);
    columns->addWidget(m_stack, 1);
}

void SegmentedPages::addPage(const QString &title, QWidget *page)
{
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setWidget(page);
    const int id = m_stack->addWidget(scroll);
    auto *button = named(m_buttonName + QString::number(id), new QToolButton);
    button->setText(title);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_buttons->addButton(button, id);
    m_column->insertWidget(id, button);
    connect(button, &QToolButton::toggled, this, [this, button, id](bool checked) {
        button->setFocusPolicy(checked ? Qt::TabFocus : Qt::NoFocus); // arrow keys lead to the other buttons
        if (checked) {
            m_stack->setCurrentIndex(id);
        }
    });
    button->setFocusPolicy(Qt::NoFocus);
    button->setChecked(id == 0);
}

void SegmentedPages::setCurrent(int index)
{
    m_buttons->button(index)->setChecked(true);
}

} // namespace slidercrank
