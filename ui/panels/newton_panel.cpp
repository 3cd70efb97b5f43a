// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/newton_panel.h"

#include "ui/panels/newton_pages.h"
#include "ui/panels/solver_form.h"
#include "ui/panels/table_panel.h"
#include "ui/widgets/named.h"

namespace slidercrank
{

NewtonPanel::NewtonPanel(QWidget *parent)
    : SegmentedPages(QStringLiteral("segment"), parent)
    , m_form(new SolverForm)
    , m_tables(new TablePanel("newtonTables", tr("Newton-Raphson at the current time"), [this] { return page(); }))
{
    named("newtonPanel", this, tr("Newton-Raphson"));
    addPage(tr("Settings"), m_form);
    for (const QString &title : {tr("Equations"), tr("Jacobian"), tr("Iterations"), tr("Coordinates")}) {
        addPage(title, m_tables);
    }
    connect(this, &NewtonPanel::currentChanged, m_tables, &TablePanel::refreshNow);
    connect(m_form, &SolverForm::edited, this, &NewtonPanel::edited);
    connect(m_tables, &TablePanel::rowsCopied, this, &NewtonPanel::rowsCopied);
    connect(m_tables, &TablePanel::partHovered, this, &NewtonPanel::partHovered);
    connect(m_tables, &TablePanel::problemFound, this, &NewtonPanel::problemFound);
}

void NewtonPanel::setSolver(const SolverSettings &solver)
{
    m_form->setSolver(solver);
}

void NewtonPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_result = result;
    m_form->setResult(*result);
    m_tables->refresh();
}

void NewtonPanel::setPose(const Pose &pose)
{
    m_time = pose.time;
    m_tables->refresh();
}

Page NewtonPanel::page() const
{
    if (!m_result) {
        return {};
    }
    switch (current()) {
    case 1: return equationPage(*m_result, m_time);
    case 2: return jacobianPage(*m_result, m_time);
    case 3: return iterationPage(*m_result, m_time);
    case 4: return coordinatePage(*m_result, m_time);
    default: return {};
    }
}

} // namespace slidercrank
