// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/solver_form.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/document/with.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr double kMostIterations = 1000.0; // with more nothing more comes
constexpr int kWideInLetters = 115;        // from here on what came out has room beside the settings

} // namespace

SolverForm::SolverForm(QWidget *parent)
    : QWidget(parent)
{
    named("solverForm", this, tr("Settings and outcome"));

    m_method = named("methodBox", new QComboBox);
    m_method->addItem(tr("Newton-Raphson"), static_cast<int>(Method::Newton));
    m_method->addItem(tr("closed form, exact"), static_cast<int>(Method::ClosedForm));
    m_method->setToolTip(tr("How the curves are computed"));
    connect(m_method, &QComboBox::activated, this, [this](int index) {
        const auto method = static_cast<Method>(m_method->itemData(index).toInt());
        edit(with(m_solver, &SolverSettings::method, method));
    });

    m_tolerance = named("toleranceBox", new NumberBox);
    m_tolerance->setRange({.smallest = 0.0});
    m_tolerance->setToolTip(tr("Iterates until ‖C‖ is at most this; 0: until it no longer falls"));
    connect(m_tolerance, &NumberBox::edited, this, [this](double tolerance) {
        SolverSettings solver = m_solver;
        solver.newton.tolerance = tolerance;
        edit(solver);
    });

    m_toleranceKind = named("toleranceKindBox", new QComboBox);
    m_toleranceKind->addItem(tr("absolute"), static_cast<int>(ToleranceKind::Absolute));
    m_toleranceKind->addItem(tr("relative"), static_cast<int>(ToleranceKind::Relative));
    m_toleranceKind->setToolTip(
        tr("Absolute: mm and rad mixed, as in the report. Relative: lengths divided by a + b + |c|, the same at every "
           "scale"));
    connect(m_toleranceKind, &QComboBox::activated, this, [this](int index) {
        SolverSettings solver = m_solver;
        solver.newton.toleranceKind = static_cast<ToleranceKind>(m_toleranceKind->itemData(index).toInt());
        edit(solver);
    });

    m_iterations = named("iterationsBox", new NumberBox);
    m_iterations->setRange({.smallest = 1.0, .largest = kMostIterations, .isWhole = true});
    m_iterations->setFixedDecimals(0);
    m_iterations->setStep(1.0);
    m_iterations->setToolTip(tr("At one instant"));
    connect(m_iterations, &NumberBox::edited, this, [this](double iterations) {
        SolverSettings solver = m_solver;
        solver.newton.maxIterations = static_cast<int>(iterations);
        edit(solver);
    });

    auto *settings = new QGridLayout;
    settings->setHorizontalSpacing(8);
    settings->setVerticalSpacing(4);
    const auto add = [settings](const QString &name, QWidget *field, int row) {
        auto *label = new QLabel(name);
        label->setBuddy(field);
        field->setAccessibleName(name);
        field->setMaximumWidth(std::max(130, field->sizeHint().width())); // the method's name whole
        settings->addWidget(label, row, 0);
        settings->addWidget(field, row, 1);
    };
    add(tr("Method"), m_method, 0);
    add(tr("Tolerance"), m_tolerance, 1);
    add(tr("Kind of tolerance"), m_toleranceKind, 2);
    add(tr("Most iterations"), m_iterations, 3);

    m_iterationsDone = named("iterationsLabel", new QLabel);
    m_residual = named("residualLabel", new QLabel);
    m_instants = named("instantsLabel", new QLabel);
    m_explanation = named("explanationLabel", new QLabel);
    auto *outcome = new QFormLayout;
    outcome->setHorizontalSpacing(8);
    outcome->setVerticalSpacing(4);
    outcome->addRow(tr("Iterations"), m_iterationsDone);
    outcome->addRow(tr("Largest residual ‖C‖"), m_residual);
    outcome->addRow(tr("Instants"), m_instants);
    for (QLabel *label : {m_iterationsDone, m_residual, m_instants, m_explanation}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        label->setWordWrap(true);
    }
    m_residual->setToolTip(
        tr("Of the instants that were found, as the tolerance measures it. It bounds the residual, not the error."));

    m_beside = new QHBoxLayout;
    m_beside->addLayout(settings);
    m_beside->addLayout(outcome, 1);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(m_beside);
    rows->addWidget(m_explanation);
    rows->addStretch(1);
    showSettings();
    colourExplanation();
}

void SolverForm::setSolver(const SolverSettings &solver)
{
    m_solver = solver;
    showSettings();
}

void SolverForm::setResult(const std::shared_ptr<const Result> &result)
{
    if (!result) {
        return;
    }
    const QLocale locale;
    const SamplingSummary &run = result->summary;
    const std::size_t instants = run.instants;
    const bool newton = result->solver.method == Method::Newton;
    if (newton) {
        m_iterationsDone->setText(iterationsText(run, result->solver.newton));
        m_residual->setText(run.found() > 0 ? shortNumber(run.largestResidual, 3) : dash());
    } else {
        m_iterationsDone->setText(tr("none: the closed form needs none"));
        m_residual->setText(dash());
    }

    const std::size_t solved = run.count(Status::Solved);
    m_instants->setText(solved == instants ? tr("all %1 solved").arg(countText(instants))
                                           : tr("%1 of %2 solved").arg(countText(solved), countText(instants)));

    QStringList sentences;
    const auto tell = [&](Status status, const QString &sentence) {
        const std::size_t count = run.count(status);
        if (count > 0) {
            sentences << sentence.arg(countText(count), countText(instants));
        }
    };
    tell(Status::IterationLimit,
         result->solver.newton.tolerance > 0.0
             ? tr("%1 of %2 instants did not converge within %3 iterations: allow more iterations or a larger "
                  "tolerance.")
             : tr("%1 of %2 instants did not converge within %3 iterations: allow more iterations."));
    for (QString &sentence : sentences) {
        sentence = sentence.arg(locale.toString(result->solver.newton.maxIterations));
    }
    tell(Status::NotAssemblable, tr("%1 of %2 instants cannot be assembled: the coupler is too short there."));
    tell(Status::Singular, tr("At %1 of %2 instants the coupler is perpendicular to the slider's line: the position "
                              "exists, velocity and acceleration do not."));
    tell(Status::NotFinite, tr("At %1 of %2 instants the result is too large to be a number."));
    if (const QString few = newton ? fewSamplesSentence(result->mechanism, result->sampling) : QString();
        !few.isEmpty()) {
        sentences << few;
    }
    m_explanation->setText(sentences.isEmpty() ? QString() : tr("⚠ %1").arg(sentences.join(QLatin1Char(' '))));
    m_explanation->setVisible(!sentences.isEmpty());
}

void SolverForm::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const bool wide = width() >= kWideInLetters * fontMetrics().averageCharWidth();
    m_beside->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_beside->setSpacing(wide ? 20 : 6);
}

void SolverForm::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange) {
        colourExplanation();
    }
    QWidget::changeEvent(event);
}

void SolverForm::colourExplanation()
{
    setInk(*m_explanation, seriesColours(palette()).warning);
}

void SolverForm::showSettings()
{
    m_method->setCurrentIndex(m_method->findData(static_cast<int>(m_solver.method)));
    m_tolerance->setValue(m_solver.newton.tolerance);
    m_toleranceKind->setCurrentIndex(m_toleranceKind->findData(static_cast<int>(m_solver.newton.toleranceKind)));
    m_iterations->setValue(m_solver.newton.maxIterations);
    const bool newton = m_solver.method == Method::Newton;
    m_tolerance->setEnabled(newton);
    m_toleranceKind->setEnabled(newton);
    m_iterations->setEnabled(newton);
}

void SolverForm::edit(const SolverSettings &solver)
{
    const bool isChange = solver != m_solver;
    m_solver = solver;
    showSettings();
    if (isChange) {
        emit edited(solver);
    }
}

} // namespace slidercrank
