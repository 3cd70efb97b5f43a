// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/segmented_pages.h"

#include "ui/widgets/named.h"
#include "ui/widgets/scrollable.h"
#include "ui/widgets/spacing.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QStackedWidget>

namespace slidercrank
{

SegmentedPages::SegmentedPages(const QString &listName, QWidget *parent)
    : QWidget(parent)
    , m_titles(named(listName, new QListWidget, tr("Pages")))
    , m_pages(new QStackedWidget)
{
    m_titles->setFrameShape(QFrame::NoFrame);
    m_titles->setFocusPolicy(Qt::TabFocus);
    m_titles->setSpacing(kDenseSpacing);
    m_titles->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    m_titles->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Expanding);
    m_titles->viewport()->setBackgroundRole(QPalette::Window);
    connect(m_titles, &QListWidget::currentRowChanged, m_pages, &QStackedWidget::setCurrentIndex);
    connect(m_titles, &QListWidget::itemSelectionChanged, this, [this] {
        if (m_titles->selectedItems().isEmpty()) { // after a click beside the titles
            setCurrent(m_pages->currentIndex());
        }
    });
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(kPagesMargins);
    columns->addWidget(m_titles);
    columns->addWidget(m_pages, 1);
}

void SegmentedPages::addPage(const QString &title, QWidget *page)
{
    m_pages->addWidget(scrollable(page));
    m_titles->addItem(title);
    setCurrent(0);
}

void SegmentedPages::setCurrent(int index)
{
    m_titles->setCurrentRow(index);
}

} // namespace slidercrank

#include "moc_segmented_pages.cpp"
