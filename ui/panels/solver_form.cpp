// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/solver_form.h"

#include "ui/document/session.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace slidercrank
{

namespace
{

constexpr double kMaximumIterations = 1000.0; // more iterations change nothing

QString outcomeText(const Result &result)
{
    const SamplingSummary &run = result.summary;
    const QString all = SolverForm::tr("All %1 time steps are solved.").arg(QString::number(run.timeSteps));
    return (run.count(Status::Solved) == run.timeSteps ? all : QString()) + u'\n' + samplingText(result);
}

QStringList warningsOf(const Result &result)
{
    const SamplingSummary &run = result.summary;
    const NewtonOptions &newton = result.solver.newton;
    QStringList warnings;
    const auto warn = [&](Status status, const QString &sentence) {
        if (run.count(status) > 0) {
            warnings << sentence.arg(QString::number(run.count(status)), QString::number(run.timeSteps));
        }
    };
    warn(Status::IterationLimit,
         SolverForm::tr("%1 of %2 time steps did not converge within %3 iterations: allow more iterations or a larger "
                        "tolerance.")
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

QString samplingText(const Result &result)
{
    const SamplingSummary &summary = result.summary;
    const QString samples = QString::number(summary.timeSteps);
    QStringList parts;
    if (const std::size_t missing = summary.count(Status::NotAssemblable); missing > 0) {
        parts << SolverForm::tr("cannot be assembled at %1 of %2 time steps").arg(QString::number(missing), samples);
    }
    if (result.solver.method == Method::Newton) {
        parts << SolverForm::tr("Newton-Raphson");
        const std::size_t unsolved = summary.count(Status::IterationLimit) + summary.count(Status::NotFinite);
        if (unsolved > 0) {
            parts << SolverForm::tr("%1 of %2 time steps not solved").arg(QString::number(unsolved), samples);
        }
        if (summary.found() > 0) {
            parts << SolverForm::tr("iterations: %1").arg(iterationsText(summary, result.solver.newton))
                  << SolverForm::tr("residual %1").arg(numberText(summary.largestResidual, 2));
        }
    }
    if (result.sampleSeconds) {
        parts << SolverForm::tr("%1 samples in %2 ms").arg(samples, shortNumber(*result.sampleSeconds * 1e3, 2));
    }
    return parts.join("  ·  ");
}

SolverForm::SolverForm(Session *session, QWidget *parent)
    : QWidget(parent)
{
    named("solverForm", this, tr("Settings and outcome"));
    auto *form = new QFormLayout;
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows); // on small screens
    auto *method = addField(form, "methodBox", tr("Method"), new QComboBox, tr("How the curves are computed"));
    method->addItems({tr("Newton-Raphson"), tr("closed form, exact")}); // in the order of Method
    auto *tolerance = addField(form, "toleranceBox", tr("Tolerance"), new NumberBox,
                               tr("Iterates until ‖C‖ is at most this; 0: until it no longer decreases"));
    tolerance->setRange({.smallest = 0.0});
    auto *kind = addField(form, "toleranceKindBox", tr("Tolerance type"), new QComboBox,
                          tr("Absolute: mm and rad mixed, as in the reference report. Relative: lengths divided by "
                             "a + b + |c|, the same at every scale"));
    kind->addItems({tr("absolute"), tr("relative")}); // in the order of ToleranceKind
    auto *iterations = addField(form, "iterationsBox", tr("Maximum iterations"), new NumberBox, tr("At one time step"));
    iterations->setRange({.smallest = 1.0, .largest = kMaximumIterations, .isWhole = true});
    iterations->setFixedDecimals(0);
    iterations->setStep(1.0);
    for (QWidget *field : std::initializer_list<QWidget *>{method, tolerance, kind, iterations}) {
        field->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }

    auto *outcome = named("outcomeLabel", plainText());
    auto *warnings = named("warningLabel", plainText());
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(4, 0, 0, 0);
    rows->addLayout(form);
    rows->addWidget(outcome);
    rows->addWidget(warnings);
    rows->addStretch(1);

    const auto show = [=] {
        const auto &[shownMethod, newton] = session->solver();
        method->setCurrentIndex(static_cast<int>(shownMethod));
        tolerance->setValue(newton.tolerance);
        kind->setCurrentIndex(static_cast<int>(newton.toleranceKind));
        iterations->setValue(newton.maxIterations);
        for (QWidget *field : std::initializer_list<QWidget *>{tolerance, kind, iterations}) {
            field->setEnabled(shownMethod == Method::Newton);
        }
        const QStringList sentences = warningsOf(*session->result());
        outcome->setText(outcomeText(*session->result()));
        warnings->setText(sentences.isEmpty() ? QString() : QStringLiteral("⚠ ") + sentences.join(u' '));
    };
    const auto edit = [=] {
        SolverSettings solver = session->solver();
        solver.method = static_cast<Method>(method->currentIndex());
        solver.newton.tolerance = tolerance->value();
        solver.newton.toleranceKind = static_cast<ToleranceKind>(kind->currentIndex());
        solver.newton.maxIterations = static_cast<int>(iterations->value());
        session->setSolver(solver);
    };
    for (const QComboBox *box : {method, kind}) {
        connect(box, &QComboBox::activated, session, edit);
    }
    for (const NumberBox *box : {tolerance, iterations}) {
        connect(box, &NumberBox::edited, session, edit);
    }
    connect(session, &Session::settingsChanged, this, show);
    connect(session, &Session::resultChanged, this, show);
    show();
}

} // namespace slidercrank
