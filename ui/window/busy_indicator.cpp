// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/busy_indicator.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>

namespace slidercrank
{

namespace
{

constexpr int kMoment = 250; // ms: what is done sooner is not worth a flicker

} // namespace

BusyIndicator::BusyIndicator(QWidget *parent)
    : QWidget(parent)
    , m_progress(new QProgressBar)
    , m_cancel(new QToolButton)
{
    m_progress->setMaximumWidth(140);
    m_cancel->setObjectName(QStringLiteral("cancelButton"));
    setTexts();
    setProgressUnknown();
    hide();

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);

    m_moment.setSingleShot(true);
    m_moment.setInterval(kMoment);
    connect(&m_moment, &QTimer::timeout, this, &QWidget::show);
    connect(m_cancel, &QToolButton::clicked, this, &BusyIndicator::cancelled);
}

void BusyIndicator::setTexts()
{
    m_progress->setAccessibleName(tr("Computing"));
    m_cancel->setText(tr("Cancel"));
}

void BusyIndicator::setBusy(bool busy)
{
    m_underWay += busy ? 1 : -1;
    if (busy && m_underWay == 1) {
        m_moment.start();
    } else if (m_underWay == 0) {
        m_moment.stop();
        hide();
        setProgressUnknown();
    }
}

void BusyIndicator::setProgress(double part)
{
    m_progress->setRange(0, 100);
    m_progress->setValue(static_cast<int>(100.0 * part));
}

void BusyIndicator::setProgressUnknown()
{
    m_progress->setRange(0, 0);
}

void BusyIndicator::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange) {
        setTexts();
    }
    QWidget::changeEvent(event);
}

} // namespace slidercrank
