// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/solver_form.h"

#include "ui/document/session.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"
#include "ui/widgets/enum_box.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/spacing.h"

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

/// Returns how the motion was computed, and a warning for each reason why time steps are not solved.
QString outcomeText(const Result &result)
{
    const SamplingSummary &summary = result.summary;
    const QString count = QString::number(summary.timeSteps);
    QStringList lines{samplingText(result)};
    if (summary.count(Status::Solved) == summary.timeSteps) {
        lines.prepend(SolverForm::tr("All %1 time steps are solved.").arg(count));
    }
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        const auto status = static_cast<Status>(i);
        if (status != Status::Solved && summary.count(status) > 0) {
            lines << SolverForm::tr("⚠ %1 of %2 time steps: %3")
                         .arg(QString::number(summary.count(status)), count,
                              statusSentence(status, result.solver.newton));
        }
    }
    if (result.solver.method == Method::Newton) {
        lines << fewSamplesSentence(result.mechanism, result.sampling);
    }
    lines.removeAll(QString());
    return lines.join(u'\n');
}

} // namespace

QString samplingText(const Result &result)
{
    const SamplingSummary &summary = result.summary;
    const QString samples = QString::number(summary.timeSteps);
    constexpr int kDigits = 2;
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
        if (summary.positionCount() > 0) {
            parts << SolverForm::tr("iterations: %1").arg(iterationsText(summary))
                  << SolverForm::tr("residual %1").arg(numberText(summary.largestResidual, kDigits));
        }
    }
    if (result.sampleSeconds) {
        parts << SolverForm::tr("%1 samples in %2 ms").arg(samples, shortNumber(*result.sampleSeconds * 1e3, kDigits));
    }
    return parts.join("  ·  ");
}

SolverForm::SolverForm(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_method(new QComboBox)
    , m_tolerance(new NumberBox)
    , m_toleranceKind(new QComboBox)
    , m_maxIterations(new NumberBox)
    , m_outcome(named("outcomeLabel", plainText()))
{
    named("solverForm", this, tr("Settings and outcome"));
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kPageMargins);
    rows->addLayout(makeFields());
    rows->addWidget(m_outcome);
    rows->addStretch(1);
    for (const QComboBox *box : {m_method, m_toleranceKind}) {
        connect(box, &QComboBox::activated, this, &SolverForm::edit);
    }
    for (const NumberBox *box : {m_tolerance, m_maxIterations}) {
        connect(box, &NumberBox::edited, this, &SolverForm::edit);
    }
    connect(session, &Session::settingsChanged, this, &SolverForm::showSettings);
    connect(session, &Session::resultChanged, this, &SolverForm::showSettings);
    showSettings();
}

QLayout *SolverForm::makeFields()
{
    auto *form = new QFormLayout;
    form->setVerticalSpacing(kFormSpacing);
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows); // on small screens
    addField(form, "methodBox", tr("Method"), m_method, tr("How the curves are computed"));
    addChoice(m_method, Method::Newton, tr("Newton-Raphson"));
    addChoice(m_method, Method::ClosedForm, tr("closed form, exact"));
    addField(form, "toleranceBox", tr("Tolerance"), m_tolerance,
             tr("Iterates until ‖C‖ is at most this; 0: until it no longer decreases"));
    m_tolerance->setRange(0.0, kLargestParameter);
    addField(form, "toleranceKindBox", tr("Tolerance type"), m_toleranceKind,
             tr("Absolute: mm and rad mixed. Relative: lengths divided by a + b + |c|, the same at every scale"));
    addChoice(m_toleranceKind, ToleranceKind::Absolute, tr("absolute"));
    addChoice(m_toleranceKind, ToleranceKind::Relative, tr("relative"));
    addField(form, "iterationsBox", tr("Maximum iterations"), m_maxIterations, tr("At one time step"));
    m_maxIterations->setRange(1.0, kMaximumIterations);
    m_maxIterations->setFixedDecimals(0);
    for (QWidget *field : std::initializer_list<QWidget *>{m_method, m_tolerance, m_toleranceKind, m_maxIterations}) {
        field->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    }
    return form;
}

void SolverForm::showSettings()
{
    const auto &[method, newton] = m_session->solver();
    choose(m_method, method);
    m_tolerance->setValue(newton.tolerance);
    choose(m_toleranceKind, newton.toleranceKind);
    m_maxIterations->setValue(newton.maxIterations);
    for (QWidget *field : std::initializer_list<QWidget *>{m_tolerance, m_toleranceKind, m_maxIterations}) {
        field->setEnabled(method == Method::Newton);
    }
    m_outcome->setText(outcomeText(*m_session->result()));
}

void SolverForm::edit()
{
    SolverSettings solver = m_session->solver();
    solver.method = chosen<Method>(m_method);
    solver.newton.tolerance = m_tolerance->value();
    solver.newton.toleranceKind = chosen<ToleranceKind>(m_toleranceKind);
    solver.newton.maxIterations = static_cast<int>(m_maxIterations->value());
    m_session->setSolver(solver);
}

} // namespace slidercrank

#include "moc_solver_form.cpp"
