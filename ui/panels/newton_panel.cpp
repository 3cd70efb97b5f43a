// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/newton_panel.h"

#include "core/newton/newton.h"
#include "ui/widgets/named.h"
#include "ui/panels/iteration_plot.h"
#include "ui/panels/newton_tables.h"
#include "ui/panels/solver_form.h"
#include "ui/text/axis_scale.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QStackedWidget>
#include <QToolButton>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr int kBetweenInstants = 50; // ms: numbers that change faster cannot be read, and cost
constexpr int kWide = 760;           // px: from here on there is room for the segments beside the page

} // namespace

NewtonPanel::NewtonPanel(QWidget *parent)
    : QWidget(parent)
{
    named("newtonPanel", this, tr("Newton-Raphson"));

    m_buttons = new QButtonGroup(this);
    m_segments = new QBoxLayout(QBoxLayout::TopToBottom);
    m_segments->setSpacing(1);
    m_pages = new QStackedWidget;

    m_form = new SolverForm;
    connect(m_form, &SolverForm::edited, this, &NewtonPanel::edited);
    addPage(Settings, tr("Settings"), m_form, nullptr);

    auto *equations =
        new NumberTable(QStringLiteral("equationTable"), tr("Equations, a row a constraint"), equationColumns());
    equations->setColumnText(0, longestConstraintName());
    equations->setColumnText(1, QStringLiteral("−R_y³ + R_y² + a/2 cos θ₂ + b/2 cos θ³ = 0"));
    equations->setColumnText(2, QStringLiteral("-0.000·10⁻¹⁰"));
    equations->setColumnText(3, QStringLiteral("-0000.0000"));
    equations->setColumnText(4, QStringLiteral("-0000.0000"));
    addPage(Equations, tr("Equations"), equations, equations);

    QWidget *jacobian = createJacobianPage();
    addPage(Jacobian, tr("Jacobian"), jacobian, m_jacobian);
    QWidget *iterations = createIterationPage();
    addPage(Iterations, tr("Iterations"), iterations, m_iterations);

    auto *coordinates =
        new NumberTable(QStringLiteral("coordinateTable"), tr("Coordinates, a row each"), coordinateColumns());
    coordinates->setColumnText(0, QStringLiteral("R_y¹"));
    coordinates->setColumnText(1, longestBodyName());
    for (const int column : {2, 3, 4}) {
        coordinates->setColumnText(column, QStringLiteral("-00000.00000"));
    }
    addPage(Coordinates, tr("Coordinates"), coordinates, coordinates);

    m_copy = named("copyTableButton", new QToolButton);
    m_copy->setText(tr("Copy as CSV"));
    m_copy->setToolTip(tr("The table with every digit (Ctrl+C in the table)"));
    connect(m_copy, &QToolButton::clicked, this, [this] {
        if (NumberTable *table = m_tables[static_cast<std::size_t>(m_pages->currentIndex())]) {
            table->copy();
        }
    });
    m_segments->addStretch(1);
    m_segments->addWidget(m_copy);

    m_remark = named("instantRemark", new QLabel);
    m_remark->setWordWrap(true);
    m_remark->hide();

    auto *column = new QVBoxLayout;
    column->setSpacing(2);
    column->addWidget(m_remark);
    column->addWidget(m_pages, 1);
    m_beside = new QBoxLayout(QBoxLayout::LeftToRight, this);
    m_beside->setContentsMargins(4, 4, 4, 2);
    m_beside->setSpacing(8);
    m_beside->addLayout(m_segments);
    m_beside->addLayout(column, 1);

    m_pause.setSingleShot(true);
    m_pause.setInterval(kBetweenInstants);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_stale) {
            showLater();
        }
    });
    connect(m_buttons, &QButtonGroup::idClicked, this, &NewtonPanel::showPage);
    showPage(Settings);
}

void NewtonPanel::addPage(Page page, const QString &title, QWidget *widget, NumberTable *table)
{
    auto *button = named(QStringLiteral("segment%1").arg(page), new QToolButton);
    button->setText(title);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setMinimumWidth(button->sizeHint().width() * 2 / 3); // on the smallest screens, some letters short
    m_buttons->addButton(button, page);
    m_segments->addWidget(button);
    m_pages->addWidget(widget);
    m_tables.push_back(table);
    if (table) {
        connect(table, &NumberTable::partHovered, this, &NewtonPanel::partHovered);
        connect(table, &NumberTable::copied, this, &NewtonPanel::rowsCopied);
    }
}

QWidget *NewtonPanel::createJacobianPage()
{
    m_jacobian = new NumberTable(QStringLiteral("jacobianTable"),
                                 tr("Jacobian C_q, a row a constraint, a column a coordinate"), jacobianColumns());
    m_jacobian->setRuled(true);
    m_jacobian->setColumnText(0, longestConstraintName());
    m_jacobianNote = named("jacobianNote", new QLabel);
    m_jacobianNote->setTextFormat(Qt::RichText);
    m_jacobianNote->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_jacobianNote->setToolTip(
        tr("κ: the largest singular value over the smallest, mm and rad mixed as in C_q. The larger it is, the more "
           "digits are lost; it is infinite where the coupler is perpendicular to the slider's line."));

    auto *page = new QWidget;
    auto *beside = new QHBoxLayout(page);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->addWidget(m_jacobian, 1);
    beside->addWidget(m_jacobianNote);
    return page;
}

QWidget *NewtonPanel::createIterationPage()
{
    m_plot = new IterationPlot;
    m_iterations = new NumberTable(QStringLiteral("iterationTable"), tr("Iterations, a row each"), iterationColumns());
    m_iterations->setColumnText(0, QStringLiteral("00"));
    for (const int column : {1, 3}) {
        m_iterations->setColumnText(column, QStringLiteral("0.00·10⁻¹⁰"));
        m_iterations->setColumnText(column + 1, QStringLiteral("-00.0000000000"));
    }
    auto *page = new QWidget;
    auto *beside = new QHBoxLayout(page);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->addWidget(m_plot, 4);
    beside->addWidget(m_iterations, 5);
    return page;
}

void NewtonPanel::setSolver(const SolverSettings &solver)
{
    m_form->setSolver(solver);
}

void NewtonPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_form->setResult(result);
    m_result = result;
    showLater();
}

void NewtonPanel::setPose(const Pose &pose)
{
    m_time = pose.time;
    showLater();
}

void NewtonPanel::showEvent(QShowEvent *event)
{
    if (m_stale) {
        showLater();
    }
    QWidget::showEvent(event);
}

void NewtonPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void NewtonPanel::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LocaleChange) {
        showLater();
    }
    QWidget::changeEvent(event);
}

void NewtonPanel::arrange()
{
    const bool wide = width() >= kWide;
    m_beside->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_beside->setSpacing(wide ? 8 : 2);
    m_segments->setDirection(wide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void NewtonPanel::showPage(int page)
{
    m_buttons->button(page)->setChecked(true);
    for (QAbstractButton *button : m_buttons->buttons()) {
        button->setFocusPolicy(button->isChecked() ? Qt::TabFocus : Qt::NoFocus); // the arrow keys lead to the others
    }
    m_pages->setCurrentIndex(page);
    m_copy->setVisible(m_tables[static_cast<std::size_t>(page)] != nullptr);
    m_remark->hide();
    showLater();
}

void NewtonPanel::showLater()
{
    m_stale = true;
    const bool onShow = m_result && isVisible() && m_pages->currentIndex() != Settings;
    if (onShow && !m_pause.isActive()) {
        fill();
        m_pause.start();
    }
}

void NewtonPanel::fill()
{
    m_stale = false;
    const Mechanism &mechanism = m_result->mechanism;
    const Sampling &run = m_result->sampling;
    const double step = run.duration / run.steps;
    const InstantEquations equations = equationsAt(mechanism, m_time, step, m_result->solver);
    explain(equations.state.status);
    NumberTable *table = m_tables[static_cast<std::size_t>(m_pages->currentIndex())];
    switch (static_cast<Page>(m_pages->currentIndex())) {
    case Settings: break;
    case Equations: table->setRows(equationRows(equations)); break;
    case Jacobian: {
        table->setRows(jacobianRows(mechanism, equations));
        const bool exists = equations.hasPosition();
        const double condition = exists ? conditionNumber(equations.Cq) : std::numeric_limits<double>::quiet_NaN();
        const QString kappa = std::isinf(condition) ? QStringLiteral("∞") : exists ? shortNumber(condition, 4) : dash();
        const QString determinant = exists ? tr("%1 mm").arg(shortNumber(equations.Cq.determinant(), 4)) : dash();
        const auto swatch = [this](double tint) { return tintColour(tint, palette()).name(); };
        m_jacobianNote->setText(tr("κ(C_q) = %1<br>det C_q = −b cos θ³<br>= %2<br><br><span style='color:%3'>■</span> "
                                   "positive<br><span style='color:%4'>■</span> negative<br>in mm below θ")
                                    .arg(kappa, determinant, swatch(1.0), swatch(-1.0)));
        break;
    }
    case Iterations: fillIterations(); break;
    case Coordinates: table->setRows(coordinateRows(mechanism, equations.state)); break;
    }
}

void NewtonPanel::fillIterations()
{
    const Mechanism &mechanism = m_result->mechanism;
    const Sampling &run = m_result->sampling;
    const NewtonOptions &options = m_result->solver.newton;
    IterationHistory fromAfar;
    solve(mechanism, m_time, options, {}, &fromAfar);
    const double step = run.duration / run.steps;
    const NewtonInstant before = solve(mechanism, m_time - step, options);
    IterationHistory fromBefore;
    if (before.positionStatus == Status::Solved) {
        solve(mechanism, m_time, options, before, &fromBefore);
    }
    m_plot->setHistories(fromAfar, fromBefore, options, step);
    m_iterations->setRows(iterationRows(fromAfar, fromBefore));
}

void NewtonPanel::explain(Status status)
{
    QString text;
    switch (status) {
    case Status::Solved: break;
    case Status::Singular:
        text = tr("The coupler is perpendicular to the slider's line: C_q is singular. The position exists, velocity "
                  "and acceleration do not.");
        break;
    case Status::IterationLimit:
        text = tr("Not converged within %1 iterations: what is shown is the last one. Allow more iterations or a "
                  "larger tolerance.")
                   .arg(QLocale().toString(m_result->solver.newton.maxIterations));
        break;
    case Status::NotAssemblable: text = tr("It cannot be assembled here: the coupler is too short."); break;
    case Status::NotFinite: text = tr("The result is too large to be a number here."); break;
    }
    setInk(*m_remark, seriesColours(palette()).warning);
    m_remark->setText(text.isEmpty() ? text : tr("⚠ %1").arg(text));
    m_remark->setVisible(!text.isEmpty());
}

} // namespace slidercrank
