// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/solver_form.h"

#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

namespace slidercrank
{

namespace
{

constexpr double kMaximumIterations = 1000.0; // more iterations change nothing

QString outcomeText(const Result &result)
{
    const SamplingSummary &run = result.summary;
    const std::size_t solved = run.count(Status::Solved);
    const QString steps =
        solved == run.timeSteps
            ? SolverForm::tr("All %1 time steps are solved.").arg(countText(run.timeSteps))
            : SolverForm::tr("%1 of %2 time steps are solved.").arg(countText(solved), countText(run.timeSteps));
    if (result.solver.method == Method::ClosedForm) {
        return SolverForm::tr("The closed form needs no iterations.") + u'\n' + steps;
    }
    const QString residual = run.found() > 0 ? shortNumber(run.largestResidual, 3) : dash();
    return SolverForm::tr("Iterations: %1.").arg(iterationsText(run, result.solver.newton)) + u'\n' +
           SolverForm::tr("Largest residual ‖C‖ of the time steps solved: %1.").arg(residual) + u'\n' + steps;
}

QStringList warningsOf(const Result &result)
{
    const SamplingSummary &run = result.summary;
    const NewtonOptions &newton = result.solver.newton;
    QStringList warnings;
    const auto warn = [&](Status status, const QString &sentence) {
        if (run.count(status) > 0) {
            warnings << sentence.arg(countText(run.count(status)), countText(run.timeSteps));
        }
    };
    warn(Status::IterationLimit,
         (newton.tolerance > 0.0
              ? SolverForm::tr("%1 of %2 time steps did not converge within %3 iterations: allow more "
                               "iterations or a larger tolerance.")
              : SolverForm::tr("%1 of %2 time steps did not converge within %3 iterations: allow more "
                               "iterations."))
             .replace("%3", QLocale().toString(newton.maxIterations)));
    warn(Status::NotAssemblable,
         SolverForm::tr("%1 of %2 time steps cannot be assembled: the coupler is too short there."));
    warn(Status::Singular,
         SolverForm::tr("At %1 of %2 time steps the coupler is perpendicular to the slider's line: the "
                        "position exists, velocity and acceleration do not."));
    warn(Status::NotFinite, SolverForm::tr("At %1 of %2 time steps the result is too large to be a number."));
    if (result.solver.method == Method::Newton) {
        warnings << fewSamplesSentence(result.mechanism, result.sampling);
    }
    warnings.removeAll(QString());
    return warnings;
}

} // namespace

SolverForm::SolverForm(QWidget *parent)
    : QWidget(parent)
    , m_method(named("methodBox", new QComboBox))
    , m_tolerance(named("toleranceBox", new NumberBox))
    , m_toleranceKind(named("toleranceKindBox", new QComboBox))
    , m_iterations(named("iterationsBox", new NumberBox))
    , m_outcome(named("outcomeLabel", plainText()))
    , m_warnings(named("warningLabel", plainText()))
{
    named("solverForm", this, tr("Settings and outcome"));
    m_method->addItem(tr("Newton-Raphson"), QVariant::fromValue(Method::Newton));
    m_method->addItem(tr("closed form, exact"), QVariant::fromValue(Method::ClosedForm));
    m_method->setToolTip(tr("How the curves are computed"));
    m_tolerance->setRange({.smallest = 0.0});
    m_tolerance->setToolTip(tr("Iterates until ‖C‖ is at most this; 0: until it no longer decreases"));
    m_toleranceKind->addItem(tr("absolute"), QVariant::fromValue(ToleranceKind::Absolute));
    m_toleranceKind->addItem(tr("relative"), QVariant::fromValue(ToleranceKind::Relative));
    m_toleranceKind->setToolTip(
        tr("Absolute: mm and rad mixed, as in the reference report. Relative: lengths divided by a + b + |c|, the same "
           "at every scale"));
    m_iterations->setRange({.smallest = 1.0, .largest = kMaximumIterations, .isWhole = true});
    m_iterations->setFixedDecimals(0);
    m_iterations->setStep(1.0);
    m_iterations->setToolTip(tr("At one time step"));

    auto *settings = new QFormLayout;
    settings->setVerticalSpacing(4);
    settings->setRowWrapPolicy(QFormLayout::WrapLongRows); // on small screens
    const auto add = [settings](const QString &name, QWidget *field) {
        field->setAccessibleName(name);
        field->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        settings->addRow(name, field);
    };
    add(tr("Method"), m_method);
    add(tr("Tolerance"), m_tolerance);
    add(tr("Tolerance type"), m_toleranceKind);
    add(tr("Maximum iterations"), m_iterations);
    connect(m_method, &QComboBox::activated, this, &SolverForm::edit);
    connect(m_tolerance, &NumberBox::edited, this, &SolverForm::edit);
    connect(m_toleranceKind, &QComboBox::activated, this, &SolverForm::edit);
    connect(m_iterations, &NumberBox::edited, this, &SolverForm::edit);

    auto *outcome = new QVBoxLayout;
    outcome->addWidget(m_outcome);
    outcome->addWidget(m_warnings);
    outcome->addStretch(1);
    auto *columns = new QHBoxLayout(this);
    columns->setContentsMargins(4, 0, 0, 0);
    columns->setSpacing(20);
    columns->addLayout(settings);
    columns->addLayout(outcome, 1);
    setSolver(m_solver);
}

void SolverForm::setSolver(const SolverSettings &solver)
{
    m_solver = solver;
    m_method->setCurrentIndex(m_method->findData(QVariant::fromValue(solver.method)));
    m_tolerance->setValue(solver.newton.tolerance);
    m_toleranceKind->setCurrentIndex(m_toleranceKind->findData(QVariant::fromValue(solver.newton.toleranceKind)));
    m_iterations->setValue(solver.newton.maxIterations);
    for (QWidget *field : std::initializer_list<QWidget *>{m_tolerance, m_toleranceKind, m_iterations}) {
        field->setEnabled(solver.method == Method::Newton);
    }
}

void SolverForm::setResult(const Result &result)
{
    const QStringList warnings = warningsOf(result);
    m_outcome->setText(outcomeText(result));
    m_warnings->setText(warnings.isEmpty() ? QString() : QStringLiteral("⚠ ") + warnings.join(u' '));
}

void SolverForm::edit()
{
    SolverSettings solver = m_solver;
    solver.method = m_method->currentData().value<Method>();
    solver.newton.tolerance = m_tolerance->value();
    solver.newton.toleranceKind = m_toleranceKind->currentData().value<ToleranceKind>();
    solver.newton.maxIterations = static_cast<int>(m_iterations->value());
    const bool isChange = solver != m_solver;
    setSolver(solver);
    if (isChange) {
        emit edited(solver);
    }
}

} // namespace slidercrank
