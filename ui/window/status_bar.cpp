// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_bar.h"

#include "ui/widgets/named.h"

#include <QProgressBar>
#include <QToolButton>

#include <chrono>

namespace slidercrank
{

namespace
{

constexpr std::chrono::milliseconds kProgressDelay{250}; // shorter tasks show no progress

} // namespace

StatusBar::StatusBar(QWidget *parent)
    : QStatusBar(parent)
    , m_progress(named("progress", new QProgressBar, tr("Computing")))
    , m_cancel(named("cancelButton", new QToolButton))
{
    setSizeGripEnabled(false);
    m_progress->setMaximumWidth(140);
    m_cancel->setText(tr("Cancel"));
    addPermanentWidget(m_progress);
    addPermanentWidget(m_cancel);
    showProgress(false);
    m_progressDelay.setSingleShot(true);
    connect(&m_progressDelay, &QTimer::timeout, this, [this] { showProgress(true); });
    connect(m_cancel, &QToolButton::clicked, this, &StatusBar::cancelled);
}

void StatusBar::setBusy(bool busy)
{
    m_tasks += busy ? 1 : -1;
    if (busy && m_tasks == 1) {
        m_progressDelay.start(kProgressDelay);
    } else if (m_tasks == 0) {
        m_progressDelay.stop();
        showProgress(false);
    }
    setProgress(0.0);
}

void StatusBar::showProgress(bool shown)
{
    m_progress->setVisible(shown);
    m_cancel->setVisible(shown);
}

void StatusBar::setProgress(double fraction)
{
    m_progress->setRange(0, fraction > 0.0 ? 100 : 0);
    m_progress->setValue(static_cast<int>(100.0 * fraction));
}

} // namespace slidercrank

#include "moc_status_bar.cpp"
