// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segmented_pages.h"

#include "ui/widgets/named.h"

#include <QButtonGroup>
#include <QHBoxLayout>
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
    const int id = static_cast<int>(m_buttons->buttons().size());
    auto *button = named(m_buttonName + QString::number(id), new QToolButton);
    button->setText(title);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_buttons->addButton(button, id);
    m_column->insertWidget(id, button);
    m_stack->addWidget(page);
    connect(button, &QToolButton::toggled, this, [this, button, page, id](bool checked) {
        button->setFocusPolicy(checked ? Qt::TabFocus : Qt::NoFocus); // arrow keys lead to the other buttons
        if (checked) {
            m_stack->setCurrentWidget(page);
            emit currentChanged(id);
        }
    });
    button->setFocusPolicy(Qt::NoFocus);
    button->setChecked(id == 0);
}

int SegmentedPages::current() const
{
    return m_buttons->checkedId();
}

void SegmentedPages::setCurrent(int index)
{
    m_buttons->button(index)->setChecked(true);
}

} // namespace slidercrank
