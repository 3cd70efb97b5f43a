// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "ui/document/result.h"
#include "ui/words/written_number.h"

#include <QCoreApplication>
#include <QLocale>

namespace slidercrank
{

namespace
{

class StatusLine
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StatusLine)
};

QString mobilityText(Mobility mobility)
{
    switch (mobility) {
    case Mobility::FullTurn: return StatusLine::tr("crank turns round");
    case Mobility::Rocker: return StatusLine::tr("crank rocks");
    case Mobility::Locked: return StatusLine::tr("locked in one pose");
    case Mobility::Impossible: return StatusLine::tr("cannot be assembled");
    }
    return {};
}

} // namespace

QString statusLine(const Result &result)
{
    const QLocale locale;
    const RunSummary &run = result.summary;
    const std::size_t samples = run.instants;
    const std::size_t missing = run.count(Status::NotAssemblable);
    const QString branch = result.mechanism.branch() == Branch::Open ? StatusLine::tr("Open assembly")
                                                                     : StatusLine::tr("Crossed assembly");
    QString assembly = QStringLiteral("%1, %2").arg(branch, mobilityText(result.limits.mobility));
    if (missing > 0 && result.limits.mobility != Mobility::Impossible) {
        assembly += StatusLine::tr(", no pose at %1 of %2 instants").arg(missing).arg(samples);
    }
    QString method = StatusLine::tr("closed form (exact)");
    if (result.solver.method == Method::Newton) {
        method = StatusLine::tr("Newton-Raphson, at most %1 iterations, residual %2")
                     .arg(QString::number(run.mostIterations), locale.toString(run.largestResidual, 'g', 2));
    }
    const QString cost = StatusLine::tr("%1 samples in %2 ms")
                             .arg(locale.toString(static_cast<qulonglong>(samples)),
                                  shortNumber(result.computeSeconds * 1e3, 2, locale));
    return QStringLiteral("%1  ·  %2  ·  %3").arg(assembly, method, cost);
}

} // namespace slidercrank
