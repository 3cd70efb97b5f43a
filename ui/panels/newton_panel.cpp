// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/newton_panel.h"

#include "ui/panels/newton_pages.h"
#include "ui/panels/solver_form.h"
#include "ui/panels/table_panel.h"
#include "ui/widgets/named.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>

namespace slidercrank
{

NewtonPanel::NewtonPanel(QWidget *parent)
    : QWidget(parent)
    , m_pages(new QButtonGroup(this))
    , m_stack(new QStackedWidget)
    , m_form(new SolverForm)
    , m_tables(new TablePanel("newtonTables", tr("Newton-Raphson at the time on show"), [this] { return page(); }))
{
    named("newtonPanel", this, tr("Newton-Raphson"));
    auto *segments = new QVBoxLayout;
    segments->setSpacing(1);
    for (const QString &title :
         {tr("Settings"), tr("Equations"), tr("Jacobian"), tr("Iterations"), tr("Coordinates")}) {
        const int id = static_cast<int>(m_pages->buttons().size());
        auto *button = named(QStringLiteral("segment%1").arg(id), new QToolButton);
        button->setText(title);
        button->setCheckable(true);
        button->setChecked(id == 0);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        m_pages->addButton(button, id);
        segments->addWidget(button);
    }
    segments->addStretch(1);
    m_stack->addWidget(m_form);
    m_stack->addWidget(m_tables);
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(4, 4, 4, 2);
    columns->addLayout(segments);
    columns->addWidget(m_stack, 1);

    connect(m_pages, &QButtonGroup::idClicked, this, &NewtonPanel::showPage);
    showPage(0);
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

void NewtonPanel::showPage(int index)
{
    for (QAbstractButton *button : m_pages->buttons()) {
        button->setFocusPolicy(button->isChecked() ? Qt::TabFocus : Qt::NoFocus); // arrow keys lead to the others
    }
    m_stack->setCurrentIndex(index == 0 ? 0 : 1);
    m_tables->refreshNow();
}

Page NewtonPanel::page() const
{
    if (!m_result) {
        return {};
    }
    switch (m_pages->checkedId()) {
    case 1: return equationPage(*m_result, m_time);
    case 2: return jacobianPage(*m_result, m_time);
    case 3: return iterationPage(*m_result, m_time);
    case 4: return coordinatePage(*m_result, m_time);
    default: return {};
    }
}

} // namespace slidercrank
