// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/newton/constraints.h"
#include "core/newton/newton.h"
#include "ui/document/session.h"
#include "ui/panels/newton_pages.h"
#include "ui/panels/solver_form.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"
#include "ui/widgets/number_box.h"

#include "tests/support/suite.h"
#include "tests/support/widget_parts.h"

#include <QComboBox>
#include <QLabel>
#include <QScopeGuard>
#include <QTest>

#include <Eigen/SVD>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_newton_panel
{

const TableCell &cell(const Page &page, Eigen::Index row, Eigen::Index column)
{
    return page.tables[0].rows[static_cast<std::size_t>(row)].cells[static_cast<std::size_t>(column)];
}

double number(const Page &page, Eigen::Index row, Eigen::Index column)
{
    return cell(page, row, column).number.value_or(NAN);
}

std::shared_ptr<const Result> resultOf(const SolverSettings &solver, double b = 65.0)
{
    Session session;
    session.setParameter(Parameter::B, b);
    session.setSolver(solver);
    return session.result();
}

/// The columns of the table of equations.
enum EquationColumn : Eigen::Index { Joint, Equation, Residual, TimeDerivative, RightHandSide };

class TestNewtonPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void showsEquationsAndJacobianOfTheMotion()
    {
        const auto result = resultOf({});
        const State state = ClosedForm(Mechanism()).stateAt(0.2);
        const Page equations = NewtonPages::equations(*result, 0.2);
        const Vector12 Qd = quadraticVelocityTerm(Mechanism(), state.q, state.qDot);
        QCOMPARE(cell(equations, CrankPinX, Joint).text, "pin A, x");
        QCOMPARE(cell(equations, CrankDrive, Joint).text, "drive");
        QCOMPARE(cell(equations, CrankDrive, TimeDerivative).text, "−6.283");
        QCOMPARE(equations.tables[0].rows[CrankPinX].part, MechanismPart::PinA);
        const Page jacobian = NewtonPages::jacobian(*result, 0.2);
        const Matrix12 Cq = constraintJacobian(Mechanism(), state.q);
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            QVERIFY(std::abs(number(equations, i, Residual)) <= 1e-12);
            QVERIFY(std::abs(number(equations, i, RightHandSide) - Qd[i]) <= 1e-9);
            for (Eigen::Index j = 0; j < kCoordinateCount; ++j) {
                const TableCell &entry = cell(jacobian, i, j + 1);
                QVERIFY(std::abs(*entry.number - Cq(i, j)) <= 1e-12);
                QCOMPARE(entry.text.isEmpty(), Cq(i, j) == 0.0);
                QVERIFY(Cq(i, j) == 0.0 || entry.tone == (Cq(i, j) > 0.0 ? Tone::Model : Tone::Fair));
            }
        }
        QVERIFY(jacobian.note.contains("κ"));
    }

    void showsTheCoordinatesInTheUnitsOfTheReferenceReport()
    {
        const Page page = NewtonPages::coordinates(*resultOf({}), 0.3);
        const State state = ClosedForm(Mechanism()).stateAt(0.3);
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            const double scale = isAngle(static_cast<Coordinate>(i)) ? kDegreesPerRadian : 1.0;
            QVERIFY(std::abs(number(page, i, 2) - scale * state.q[i]) <= 1e-10);
            QVERIFY(std::abs(number(page, i, 3) - scale * state.qDot[i]) <= 1e-9);
            QVERIFY(std::abs(number(page, i, 4) - scale * state.qDDot[i]) <= 1e-8);
        }
        QCOMPARE(cell(page, R4x, 0).csv, "R4_x");
        QCOMPARE(cell(page, R4x, 2).text.size(), 5); // four digits and the point
    }

    void showsTheIterationsFromARoughStartAndFromTheTimeStepBefore()
    {
        const auto result = resultOf({});
        const NewtonOptions options = result->solver.newton;
        IterationHistory rough;
        IterationHistory warm;
        solve(Mechanism(), 0.6, options, {}, &rough);
        solve(Mechanism(), 0.6, options, solve(Mechanism(), 0.595, options), &warm);
        const Page page = NewtonPages::iterations(*result, 0.6);
        QCOMPARE(page.tables[0].rows.size(), rough.size());
        for (std::size_t k = 0; k < rough.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(k);
            QCOMPARE(number(page, row, 1), rough[k].residual);
            QCOMPARE(cell(page, row, 3).number.has_value(), k < warm.size());
        }
        QCOMPARE(number(page, 0, 3), warm[0].residual);
        const std::vector<ChartSeries> &series = page.chart->content.series;
        QCOMPARE(series.size(), 3u); // and the tolerance
        QCOMPARE(series[0].points.size(), page.tables[0].rows.size());
        QCOMPARE(series[2].points[0].y(), options.tolerance);
    }

    /// A former defect: the Jacobian stayed in mm in a window in inches.
    void theJacobianIsInTheChosenUnitOfLength()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const auto result = resultOf({});
        const Page mm = NewtonPages::jacobian(*result, 0.3);
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Degree}});
        const Page inches = NewtonPages::jacobian(*result, 0.3);
        const auto entry = [](const Page &page, Constraint row, Coordinate column) {
            return number(page, row, column + 1);
        };
        for (const auto &[row, column] : {std::pair{CrankPinX, Theta3}, {SliderPinY, Theta3}, {CrankPivotX, Theta2}}) {
            QVERIFY(std::abs(entry(mm, row, column) / entry(inches, row, column) - 25.4) < 1e-12);
        }
        QCOMPARE(entry(inches, SliderAngle, Theta4), 1.0);
        QCOMPARE(entry(inches, SliderPinX, R4x), 1.0);
        const double angle = std::asin((25.0 - 20.0 * std::sin(0.6 * std::numbers::pi)) / 65.0); // of the coupler
        const QString determinant = shortNumber(-65.0 * std::cos(angle) / 25.4);
        QVERIFY2(inches.note.contains("= " + determinant + " in") && inches.note.contains("Lengths in in."),
                 qPrintable(inches.note));
        QVERIFY(mm.note.contains("Lengths in mm."));
    }

    /// A former defect: in a window in inches and rad/s, equations and coordinates stayed in mm and °/s, and the crank
    /// angle was −30° where the drawing said 330°.
    void equationsAndCoordinatesAreInTheChosenUnits()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        Session session;
        session.setParameters({.a = 76.2, .b = 203.2, .c = 50.8, .omega2 = -15.0});
        const auto &result = *session.result();
        constexpr double kTime = std::numbers::pi / 6.0 / 15.0; // at −30°
        const Page mmEquations = NewtonPages::equations(result, kTime);
        setNotation({.units = {LengthUnit::Inch, AngleUnit::DegreeAndRadianPerSecond}});
        const Page equations = NewtonPages::equations(result, kTime);
        QCOMPARE(cell(equations, CrankPinX, RightHandSide + 1).text, "in");
        QCOMPARE(cell(equations, SliderAngle, RightHandSide + 1).text, "rad");
        QVERIFY(std::abs(number(mmEquations, CrankPinX, RightHandSide) / number(equations, CrankPinX, RightHandSide) -
                         25.4) < 1e-12);
        QCOMPARE(number(equations, CrankDrive, TimeDerivative), 15.0);
        const Page coordinates = NewtonPages::coordinates(result, kTime);
        enum CoordinateColumn : Eigen::Index { Position = 2, Velocity, Acceleration, UnitText };
        QVERIFY(std::abs(number(coordinates, Theta2, Position) - 330.0) < 1e-9);
        QCOMPARE(number(coordinates, Theta2, Velocity), -15.0);
        QCOMPARE(cell(coordinates, Theta2, UnitText).text, "°, rad/s, rad/s²");
        // the crank's centre: 3/2 in · cos 30°, and −ω² times that
        QVERIFY(std::abs(number(coordinates, R2x, Position) - 1.5 * std::sqrt(0.75)) < 1e-9);
        QVERIFY(std::abs(number(coordinates, R2x, Acceleration) + 225.0 * 1.5 * std::sqrt(0.75)) < 1e-6);
        QCOMPARE(cell(coordinates, R2x, UnitText).text, "in, in/s, in/s²");
    }

    /// The condition number is that of the matrix that is shown, in the units of the notation.
    void theConditionNumberIsThatOfTheShownJacobian()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Degree}});
        const Page page = NewtonPages::jacobian(*resultOf({}), 0.3);
        Matrix12 shown;
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            for (Eigen::Index j = 0; j < kCoordinateCount; ++j) {
                shown(i, j) = *cell(page, i, j + 1).number;
            }
        }
        const Vector12 singularValues = Eigen::JacobiSVD<Matrix12>(shown).singularValues();
        const double condition = singularValues.maxCoeff() / singularValues.minCoeff();
        QVERIFY2(page.note.contains("κ = " + shortNumber(condition) + ';'), qPrintable(page.note));
    }

    void saysWhyNumbersAreMissing()
    {
        const auto rocker = resultOf({}, 40.0);
        for (const auto page :
             {NewtonPages::equations, NewtonPages::jacobian, NewtonPages::iterations, NewtonPages::coordinates}) {
            QVERIFY(page(*rocker, 0.75).sentence.contains("too short"));
            QVERIFY(!page(*rocker, 0.25).sentence.contains("⚠"));
        }
        const Page nothing = NewtonPages::coordinates(*rocker, 0.75);
        QCOMPARE(cell(nothing, R4x, 2).text, "–");
        QVERIFY(!cell(nothing, R4x, 2).number);
        const auto limited = resultOf({Method::Newton, {1, 1e-14}});
        QVERIFY(NewtonPages::coordinates(*limited, 0.3).sentence.contains("did not converge within 1 iterations"));
    }

    void changesOneSettingAtATime()
    {
        Session session;
        SolverSettings expected{Method::Newton, {25, 1e-10}};
        session.setSolver(expected);
        const SolverForm form(&session);
        auto *tolerance = child<NumberBox>(form, "toleranceBox");
        auto *iterations = child<NumberBox>(form, "iterationsBox");
        QCOMPARE(tolerance->text(), "10⁻¹⁰");
        typeNumber(tolerance, "3e-7");
        expected.newton.tolerance = 3e-7;
        QCOMPARE(session.solver(), expected);
        typeNumber(iterations, "40");
        expected.newton.maxIterations = 40;
        QCOMPARE(session.solver(), expected);
        QTest::keyClick(child<QComboBox>(form, "toleranceKindBox"), Qt::Key_Down);
        expected.newton.toleranceKind = ToleranceKind::Relative;
        QCOMPARE(session.solver(), expected);
        typeNumber(tolerance, "-1e-8"); // refused
        QCOMPARE(session.solver(), expected);
        QTest::keyClick(child<QComboBox>(form, "methodBox"), Qt::Key_Down);
        expected.method = Method::ClosedForm;
        QCOMPARE(session.solver(), expected);
        QVERIFY(!tolerance->isEnabled() && !iterations->isEnabled());
    }

    void showsTheOutcomeOfTheSolver()
    {
        Session session;
        const SolverForm form(&session);
        const auto says = [&form](const QString &part) {
            return child<QLabel>(form, "outcomeLabel")->text().contains(part);
        };
        const auto run = [&session](const SolverSettings &solver, double b = 65.0, int steps = 200) {
            session.setParameter(Parameter::B, b);
            session.setSampling({0.0, 1.0, steps});
            session.setSolver(solver);
            return session.result()->summary;
        };
        SamplingSummary summary = run({Method::Newton, {}});
        QVERIFY(says(QString::number(summary.iterations)) && says("All 201") && !says("⚠"));
        run({Method::ClosedForm, {}});
        QVERIFY(!says("residual"));

        const auto warns = [&](Status status, const char *reason) {
            return says(QString("⚠ %1 of 201 time steps: %2").arg(QString::number(summary.count(status)), reason));
        };
        summary = run({Method::Newton, {2, 1e-8}});
        QVERIFY(warns(Status::IterationLimit, "Newton-Raphson did not converge within 2 iterations"));
        summary = run({Method::ClosedForm, {}}, 40.0);
        QVERIFY(warns(Status::NotAssemblable, "The mechanism cannot be assembled") && !says("All"));

        summary = run({Method::Newton, {1, 1e-8}}, 65.0, 20); // counts only the solved time steps
        QCOMPARE(says("All 21"), summary.count(Status::Solved) == 21);
        QCOMPARE(says("iterations: "), summary.positionCount() > 0);
    }
};

const Suite<TestNewtonPanel> suite("tst_newton_panel");

} // namespace tst_newton_panel

#include "tst_newton_panel.moc"
