// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_bar.h"

#include "ui/document/result.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

namespace slidercrank
{

namespace
{

constexpr int kMoment = 250; // ms: what is done sooner is not worth a flicker

QString mobilityText(Mobility mobility, double omega2)
{
    if (omega2 == 0.0 && (mobility == Mobility::FullTurn || mobility == Mobility::Rocker)) {
        return StatusBar::tr("crank at rest");
    }
    switch (mobility) {
    case Mobility::FullTurn: return StatusBar::tr("crank makes full turns");
    case Mobility::Rocker: return StatusBar::tr("crank oscillates");
    case Mobility::Locked: return StatusBar::tr("locked in a single position");
    case Mobility::Impossible: return StatusBar::tr("cannot be assembled");
    }
    return {};
}

} // namespace

StatusBar::StatusBar(QWidget *parent)
    : QStatusBar(parent)
    , m_progress(new QProgressBar(this))
    , m_cancel(new QToolButton(this))
{
    setSizeGripEnabled(false);
    m_progress->setMaximumWidth(140);
    m_cancel->setObjectName(QStringLiteral("cancelButton"));
    addPermanentWidget(m_progress);
    addPermanentWidget(m_cancel);
    setProgressUnknown();
    setBusyShown(false);

    m_moment.setSingleShot(true);
    m_moment.setInterval(kMoment);
    connect(&m_moment, &QTimer::timeout, this, [this] { setBusyShown(true); });
    connect(m_cancel, &QToolButton::clicked, this, &StatusBar::cancelled);
}

void StatusBar::retranslate()
{
    m_progress->setAccessibleName(tr("Computing"));
    m_cancel->setText(tr("Cancel"));
}

void StatusBar::showRun(const Result &result)
{
    const SamplingSummary &run = result.summary;
    const std::size_t samples = run.instants;
    const std::size_t missing = run.count(Status::NotAssemblable);
    const QString branch = result.mechanism.branch() == Branch::Open ? tr("Open assembly") : tr("Crossed assembly");
    QString assembly =
        QStringLiteral("%1, %2").arg(branch, mobilityText(result.limits.mobility, result.mechanism.omega2()));
    if (missing > 0 && result.limits.mobility != Mobility::Impossible) {
        assembly += tr(", no pose at %1 of %2 instants").arg(missing).arg(samples);
    }
    QStringList parts{assembly};
    if (result.solver.method == Method::Newton) {
        parts << tr("Newton-Raphson");
        const std::size_t unsolved = run.count(Status::IterationLimit) + run.count(Status::NotFinite);
        if (unsolved > 0) {
            parts << tr("%1 of %2 instants not solved").arg(countText(unsolved), countText(samples));
        }
        if (run.found() > 0) {
            parts << tr("iterations: %1").arg(iterationsText(run, result.solver.newton))
                  << tr("residual %1").arg(numberText(run.largestResidual, 2));
        }
    } else {
        parts << tr("closed form (exact)");
    }
    if (result.sampleSeconds) {
        parts << tr("%1 samples in %2 ms").arg(countText(samples), shortNumber(*result.sampleSeconds * 1e3, 2));
    }
    // A message, not labels: those would lay the whole window out anew with every move of a slider.
    showMessage(parts.join(QStringLiteral("  ·  ")));
}

void StatusBar::setBusy(bool busy)
{
    m_underWay += busy ? 1 : -1;
    if (busy && m_underWay == 1) {
        m_moment.start();
    } else if (m_underWay == 0) {
        m_moment.stop();
        setBusyShown(false);
        setProgressUnknown();
    }
}

void StatusBar::setBusyShown(bool shown)
{
    m_progress->setVisible(shown);
    m_cancel->setVisible(shown);
}

void StatusBar::setProgress(double part)
{
    m_progress->setRange(0, 100);
    m_progress->setValue(static_cast<int>(100.0 * part));
}

void StatusBar::setProgressUnknown()
{
    m_progress->setRange(0, 0);
}

} // namespace slidercrank
