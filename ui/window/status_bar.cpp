// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_bar.h"

#include "ui/document/result.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"

#include <QProgressBar>
#include <QToolButton>

#include <chrono>

namespace slidercrank
{

namespace
{

constexpr std::chrono::milliseconds kMoment{250}; // shorter tasks show no progress

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
    setProgress(-1.0);
    showProgress(false);
    m_moment.setSingleShot(true);
    connect(&m_moment, &QTimer::timeout, this, [this] { showProgress(true); });
    connect(m_cancel, &QToolButton::clicked, this, &StatusBar::cancelled);
}

void StatusBar::showResult(const Result &result)
{
    const SamplingSummary &summary = result.summary;
    const QString samples = QString::number(summary.timeSteps);
    QStringList parts;
    if (const std::size_t missing = summary.count(Status::NotAssemblable); missing > 0) {
        parts << tr("cannot be assembled at %1 of %2 time steps").arg(QString::number(missing), samples);
    }
    if (result.solver.method == Method::Newton) {
        parts << tr("Newton-Raphson");
        const std::size_t unsolved = summary.count(Status::IterationLimit) + summary.count(Status::NotFinite);
        if (unsolved > 0) {
            parts << tr("%1 of %2 time steps not solved").arg(QString::number(unsolved), samples);
        }
        if (summary.found() > 0) {
            parts << tr("iterations: %1").arg(iterationsText(summary, result.solver.newton))
                  << tr("residual %1").arg(numberText(summary.largestResidual, 2));
        }
    }
    if (result.sampleSeconds) {
        parts << tr("%1 samples in %2 ms").arg(samples, shortNumber(*result.sampleSeconds * 1e3, 2));
    }
    showMessage(parts.join("  ·  ")); // unlike a label, this does not lay out the window
}

void StatusBar::setBusy(bool busy)
{
    m_tasks += busy ? 1 : -1;
    if (busy && m_tasks == 1) {
        m_moment.start(kMoment);
    } else if (m_tasks == 0) {
        m_moment.stop();
        showProgress(false);
        setProgress(-1.0);
    }
}

void StatusBar::showProgress(bool shown)
{
    m_progress->setVisible(shown);
    m_cancel->setVisible(shown);
}

void StatusBar::setProgress(double part)
{
    m_progress->setRange(0, part < 0.0 ? 0 : 100);
    m_progress->setValue(static_cast<int>(100.0 * part));
}

} // namespace slidercrank
