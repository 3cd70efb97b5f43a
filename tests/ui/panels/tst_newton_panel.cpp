// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/mechanism/mechanism_part.h"
#include "core/newton/constraints.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_table.h"
#include "ui/document/session.h"
#include "ui/panels/iteration_plot.h"
#include "ui/panels/newton_panel.h"
#include "ui/text/theme.h"

#include "tests/support/waiting.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <cmath>

using namespace slidercrank;

namespace
{

template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

template <typename Widget>
void type(Widget *field, const QString &text)
{
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

enum Page { Settings, Equations, Jacobian, Iterations, Coordinates };

/// A panel on show, with a session's motion at an instant.
struct Shown {
    Session session;
    NewtonPanel panel;

    explicit Shown(Page page, double time = 0.2, const Parameters &parameters = {})
    {
        session.setParameters(parameters);
        panel.resize(960, 200);
        panel.setSolver(session.solver());
        panel.setResult(session.result());
        moveTo(time);
        panel.show();
        choose(page);
    }

    void choose(Page page) { child<QToolButton>(panel, QString("segment%1").arg(page))->click(); }
    void moveTo(double time) { panel.setPose(poseAt(session.parameters(), time)); }
    NumberTable *table(const QString &name) const { return child<NumberTable>(panel, name); }
};

QString textOf(const QTableView *table, int row, int column)
{
    return table->model()->index(row, column).data().toString();
}

/// The fields of a line of CSV that quotes nothing.
QStringList fieldsOf(const QString &csv, int line)
{
    return csv.split(u'\n')[line].split(u',');
}

} // namespace

Q_DECLARE_METATYPE(slidercrank::MechanismPart)

class TestNewtonPanel : public QObject
{
    Q_OBJECT

private:
    SolverSettings m_solver;
    int m_edits = 0;

    void listenTo(const NewtonPanel &panel)
    {
        m_edits = 0;
        connect(&panel, &NewtonPanel::edited, this, [this](const SolverSettings &solver) {
            m_solver = solver;
            ++m_edits;
        });
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void showsSettingsWithoutEcho()
    {
        NewtonPanel panel;
        listenTo(panel);
        panel.setSolver({Method::Newton, {25, 1e-10}});
        QCOMPARE(m_edits, 0);
        QCOMPARE(child<QComboBox>(panel, "methodBox")->currentText(), QString("Newton-Raphson"));
        QCOMPARE(child<NumberBox>(panel, "toleranceBox")->text(), QString("10⁻¹⁰"));
        QCOMPARE(child<NumberBox>(panel, "iterationsBox")->value(), 25.0);
    }

    void eachControlChangesItsOwnSettingOnly()
    {
        const SolverSettings solver{Method::Newton, {25, 1e-10}};
        NewtonPanel panel;
        panel.setSolver(solver);
        listenTo(panel);

        type(child<NumberBox>(panel, "toleranceBox"), "3e-7");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {25, 3e-7}}));
        type(child<NumberBox>(panel, "toleranceBox"), "0");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {25, 0.0}}));
        type(child<NumberBox>(panel, "iterationsBox"), "40");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {40, 0.0}}));
        QCOMPARE(m_edits, 3);
        QTest::keyClick(child<QComboBox>(panel, "toleranceKindBox"), Qt::Key_Down);
        QCOMPARE(m_edits, 4);
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {40, 0.0, ToleranceKind::Relative}}));
        auto *method = child<QComboBox>(panel, "methodBox");
        QTest::keyClick(method, Qt::Key_Down);
        QCOMPARE(m_edits, 5);
        QCOMPARE(m_solver, (SolverSettings{Method::ClosedForm, {40, 0.0, ToleranceKind::Relative}}));
        QVERIFY(!child<QComboBox>(panel, "toleranceKindBox")->isEnabled());
        QVERIFY(!child<NumberBox>(panel, "toleranceBox")->isEnabled());
    }

    void whatCannotBeIsNotTakenOver()
    {
        NewtonPanel panel;
        panel.setSolver({});
        listenTo(panel);
        type(child<NumberBox>(panel, "toleranceBox"), "small");
        type(child<NumberBox>(panel, "toleranceBox"), "-1e-8");
        QCOMPARE(m_edits, 0);
        QCOMPARE(child<NumberBox>(panel, "toleranceBox")->value(), 1e-8);
    }

    void tellsWhatCameOut()
    {
        Session session;
        session.setSolver({Method::Newton, {}});
        NewtonPanel panel;
        panel.setResult(session.result());
        const SamplingSummary &run = session.result()->summary;
        QVERIFY(child<QLabel>(panel, "iterationsLabel")->text().contains(QString::number(run.iterations)));
        QVERIFY(child<QLabel>(panel, "iterationsLabel")->text().contains(QString::number(run.mostIterations)));
        QCOMPARE(child<QLabel>(panel, "instantsLabel")->text(), QString("all 201 solved"));
        QVERIFY(child<QLabel>(panel, "explanationLabel")->text().isEmpty());
        session.setSolver({Method::ClosedForm, {}});
        panel.setResult(session.result());
        QCOMPARE(child<QLabel>(panel, "residualLabel")->text(), QString("–"));
    }

    /// "At most 60 an instant, largest residual 0" was said of 106 instants without an answer, with a limit of 10.
    void countsOnlyWhatWasFound()
    {
        for (const int most : {1, 2, 3, 10}) {
            Session session;
            session.setSampling({0.0, 1.0, 20});
            session.setSolver({Method::Newton, {most, 1e-8}});
            NewtonPanel panel;
            panel.setResult(session.result());
            const SamplingSummary &run = session.result()->summary;
            const auto failed = run.count(Status::IterationLimit);
            const QString iterations = child<QLabel>(panel, "iterationsLabel")->text();
            const QString instants = child<QLabel>(panel, "instantsLabel")->text();
            QVERIFY2(run.mostWarmIterations <= most, qPrintable(iterations));
            QVERIFY2(!iterations.contains("60"), qPrintable(iterations));
            QVERIFY2(instants.startsWith(failed == 0 ? QString("all 21") : QString("%1 of 21").arg(21 - failed)),
                     qPrintable(instants));
            if (failed == 21) {
                QCOMPARE(iterations, QString("–"));
                QCOMPARE(child<QLabel>(panel, "residualLabel")->text(), QString("–"));
            } else {
                const bool isWithin = run.mostIterations <= most;
                const int said = isWithin || run.mostWarmIterations == 0 ? run.mostIterations : run.mostWarmIterations;
                QVERIFY2(iterations.contains(QString("at most %1 ").arg(said)), qPrintable(iterations));
                QCOMPARE(iterations.contains("a rough start"), !isWithin);
            }
            if (most == 2) {
                QVERIFY(failed > 0);
            }
        }
    }

    void explainsWhatFailed()
    {
        Session session;
        session.setSolver({Method::Newton, {2, 1e-8}});
        NewtonPanel panel;
        panel.setResult(session.result());
        const auto failed = session.result()->trajectory.summary.count(Status::IterationLimit);
        QVERIFY(failed > 0);
        QString text = child<QLabel>(panel, "explanationLabel")->text();
        QVERIFY2(text.contains(QString("%1 of 201 instants did not converge within 2 iterations").arg(failed)),
                 qPrintable(text));

        Parameters rocker;
        rocker.b = 40.0;
        session.setSolver({Method::ClosedForm, {}});
        session.setParameters(rocker);
        panel.setResult(session.result());
        text = child<QLabel>(panel, "explanationLabel")->text();
        const auto missing = session.result()->trajectory.summary.count(Status::NotAssemblable);
        QVERIFY(missing > 0);
        QVERIFY2(text.contains(QString("%1 of 201 instants cannot be assembled").arg(missing)), qPrintable(text));
        QVERIFY(!text.contains("%"));
    }

    void theMethodsNameIsReadWhole()
    {
        Shown shown(Settings);
        const auto *method = child<QComboBox>(shown.panel, "methodBox");
        QVERIFY(method->width() >= method->sizeHint().width());
    }

    void listsTheTwelveEquationsWithWhatIsLeftOfThem()
    {
        Shown shown(Equations, 0.2);
        const NumberTable *table = shown.table("equationTable");
        QCOMPARE(table->model()->rowCount(), 12);
        QCOMPARE(textOf(table, 11, 0), QString("drive"));
        QCOMPARE(textOf(table, 5, 0), QString("pin A, x"));
        QCOMPARE(textOf(table, 11, 3), QString("-6.283"));
        const State state = ClosedForm(Mechanism()).stateAt(0.2);
        const Vector12 Qd = quadraticVelocityTerm(Mechanism(), state.q, state.qDot);
        const QString csv = table->csv();
        QVERIFY(csv.startsWith("joint,equation,C,C_t,Q_d,unit\n"));
        for (int row = 0; row < 12; ++row) {
            // "pin A, x" and "C(q, t)" may hold commas: the numbers stand before the last field.
            const QStringList fields = fieldsOf(csv, row + 1);
            QVERIFY(std::abs(fields[fields.size() - 4].toDouble()) <= 1e-12);
            QVERIFY(std::abs(fields[fields.size() - 2].toDouble() - Qd[row]) <= 1e-9);
        }
    }

    void showsTheJacobianWithItsZerosEmptyAndItsSignsInTwoColours()
    {
        Shown shown(Jacobian, 0.2);
        const NumberTable *table = shown.table("jacobianTable");
        const State state = ClosedForm(Mechanism()).stateAt(0.2);
        const Matrix12 Cq = constraintJacobian(Mechanism(), state.q);
        const QString csv = table->csv();
        for (int row = 0; row < 12; ++row) {
            const QStringList fields = fieldsOf(csv, row + 1);
            for (int column = 0; column < 12; ++column) {
                const double value = Cq(row, column);
                QCOMPARE(textOf(table, row, column + 1).isEmpty(), value == 0.0);
                QVERIFY(std::abs(fields[fields.size() - 12 + column].toDouble() - value) <= 1e-12);
            }
        }
        QCOMPARE(textOf(table, 5, 1 + R3x), QString("-1"));
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            // Blue against orange: apart in the blue channel, which no common colour blindness takes away.
            const QColor positive = tintColour(1.0, paletteFor(theme));
            const QColor negative = tintColour(-1.0, paletteFor(theme));
            QVERIFY(positive.blue() > positive.red() && negative.blue() < negative.red());
            QCOMPARE(tintColour(0.0, paletteFor(theme)), seriesColours(paletteFor(theme)).background);
        }
        QVERIFY(child<QLabel>(shown.panel, "jacobianNote")->text().contains("κ"));
    }

    void showsTheIterationsFromAfarAndFromTheStepBefore()
    {
        Shown shown(Iterations, 0.6);
        const NumberTable *table = shown.table("iterationTable");
        const NewtonOptions options = shown.session.solver().newton;
        IterationHistory fromAfar;
        IterationHistory fromBefore;
        solve(Mechanism(), 0.6, options, {}, &fromAfar);
        solve(Mechanism(), 0.6, options, solve(Mechanism(), 0.595, options), &fromBefore);
        QCOMPARE(table->model()->rowCount(), int(fromAfar.size()));
        const QString csv = table->csv();
        for (std::size_t k = 0; k < fromAfar.size(); ++k) {
            const QStringList fields = fieldsOf(csv, int(k) + 1);
            QCOMPARE(fields[1].toDouble(), fromAfar[k].residual);
            QCOMPARE(fields[3].isEmpty(), k >= fromBefore.size());
            if (k < fromBefore.size()) {
                QCOMPARE(fields[3].toDouble(), fromBefore[k].residual);
            }
        }
        const QString described = child<IterationPlot>(shown.panel, "iterationPlot")->accessibleDescription();
        QVERIFY2(described.startsWith("From a rough start: ") && described.contains("From 0.005 s earlier: "),
                 qPrintable(described));
    }

    void copiesTheCoordinatesWithEveryDigit()
    {
        Shown shown(Coordinates, 0.3);
        QApplication::clipboard()->clear();
        child<QToolButton>(shown.panel, "copyTableButton")->click();
        const QString csv = QApplication::clipboard()->text();
        QCOMPARE(csv.count(u'\n'), 13);
        const State state = ClosedForm(Mechanism()).stateAt(0.3);
        for (int row = 0; row < 12; ++row) {
            const QStringList fields = fieldsOf(csv, row + 1);
            const double scale = isAngle(static_cast<Coordinate>(row)) ? kDegreesPerRadian : 1.0;
            QVERIFY(std::abs(fields[2].toDouble() - scale * state.q[row]) <= 1e-12 * (1.0 + std::abs(scale * 100.0)));
            QVERIFY(std::abs(fields[3].toDouble() - scale * state.qDot[row]) <= 1e-9);
            QVERIFY(std::abs(fields[4].toDouble() - scale * state.qDDot[row]) <= 1e-8);
        }
        QCOMPARE(fieldsOf(csv, 10)[0], QString("Rₓ⁴"));
    }

    void theCopyKeyInATableCopiesTheTable()
    {
        Shown shown(Coordinates);
        NumberTable *table = shown.table("coordinateTable");
        QApplication::clipboard()->clear();
        QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), table->csv());
    }

    void numbersInTheClipboardHaveAPointInAnyLocale()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        Shown shown(Coordinates, 0.3);
        const NumberTable *table = shown.table("coordinateTable");
        const QString shownText = textOf(table, 9, 2);
        const QString copied = fieldsOf(table->csv(), 10)[2];
        QLocale::setDefault(QLocale::c());
        QVERIFY2(shownText.contains(u','), qPrintable(shownText));
        QVERIFY2(copied.contains(u'.'), qPrintable(copied));
    }

    void theRowPointedAtTellsItsJoint()
    {
        qRegisterMetaType<MechanismPart>();
        Shown shown(Equations);
        NumberTable *table = shown.table("equationTable");
        QSignalSpy spy(&shown.panel, &NewtonPanel::partHovered);
        const auto told = [&spy] { return spy.isEmpty() ? MechanismPart::None : spy.last()[0].value<MechanismPart>(); };
        const auto centreOf = [table](int row) { return table->visualRect(table->model()->index(row, 1)).center(); };
        QTest::mouseMove(table->viewport(), centreOf(5));
        QCOMPARE(told(), MechanismPart::PinA);
        QTest::mouseMove(table->viewport(), centreOf(3));
        QCOMPARE(told(), MechanismPart::Pivot);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(table->viewport(), &leave);
        QCOMPARE(told(), MechanismPart::None);

        table->setFocus();
        table->setCurrentIndex(table->model()->index(6, 0));
        AWAIT_COMPARE(told(), MechanismPart::PinA);
        QTest::keyClick(table, Qt::Key_Down);
        QCOMPARE(told(), MechanismPart::PinB);
        shown.choose(Settings);
        QCOMPARE(told(), MechanismPart::None);
    }

    void arrowKeysGoFromSegmentToSegment()
    {
        Shown shown(Settings);
        auto *settings = child<QToolButton>(shown.panel, "segment0");
        shown.panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&shown.panel));
        settings->setFocus();
        QTest::keyClick(settings, Qt::Key_Down);
        QVERIFY(child<QToolButton>(shown.panel, "segment1")->isChecked());
        QVERIFY(shown.table("equationTable")->isVisible());
    }

    void everyConstraintAndCoordinateBelongsToAPart()
    {
        for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
            QVERIFY(partOf(static_cast<Constraint>(i)) != MechanismPart::None);
            QVERIFY(partOf(static_cast<Coordinate>(i)) != MechanismPart::None);
        }
        QCOMPARE(partOf(SliderLine), MechanismPart::Guide);
        QCOMPARE(partOf(CrankDrive), MechanismPart::Drive);
        QCOMPARE(partOf(R3y), MechanismPart::Coupler);
    }

    void nothingIsComputedWhileNobodyLooks()
    {
        Shown shown(Settings);
        NumberTable *table = shown.table("coordinateTable");
        letTimePass(shown.panel);
        shown.moveTo(0.4);
        QCOMPARE(table->model()->rowCount(), 0);
        shown.choose(Coordinates);
        QCOMPARE(table->model()->rowCount(), 12);
        shown.panel.hide();
        letTimePass(shown.panel);
        const QString before = table->csv();
        shown.moveTo(0.5);
        letTimePass(shown.panel);
        settle();
        QCOMPARE(table->csv(), before);
        shown.panel.show();
        QVERIFY(table->csv() != before);
    }

    void instantsThatFollowEachOtherTooFastAreSkippedButTheLast()
    {
        Shown shown(Coordinates, 0.0);
        NumberTable *table = shown.table("coordinateTable");
        letTimePass(shown.panel);
        QSignalSpy changes(table->model(), &QAbstractItemModel::dataChanged);
        for (int i = 1; i <= 100; ++i) {
            shown.moveTo(0.004 * i);
        }
        QVERIFY(changes.size() <= 36); // of one instant
        letTimePass(shown.panel);
        const double shownAngle = fieldsOf(table->csv(), 6)[2].toDouble();
        QVERIFY(std::abs(shownAngle - 0.4 * 360.0) <= 1e-9);
    }

    void saysWhyThereIsNothingToShow()
    {
        Parameters rocker;
        rocker.b = 40.0;
        Shown shown(Coordinates, 0.75, rocker);
        auto *remark = child<QLabel>(shown.panel, "instantRemark");
        QVERIFY(remark->isVisible());
        QVERIFY2(remark->text().contains("too short"), qPrintable(remark->text()));
        const NumberTable *table = shown.table("coordinateTable");
        QCOMPARE(textOf(table, 9, 2), QString("–"));
        for (const Page page : {Equations, Jacobian, Iterations}) {
            letTimePass(shown.panel);
            shown.choose(page);
        }
        letTimePass(shown.panel);
        shown.moveTo(0.25);
        QVERIFY(!remark->isVisible());
    }

    void segmentsStandAboveThePageWhereItIsNarrow()
    {
        Shown shown(Jacobian);
        auto *segment = child<QToolButton>(shown.panel, "segment2");
        auto *table = shown.table("jacobianTable");
        const auto leftOf = [&](QWidget *widget) { return widget->mapTo(&shown.panel, QPoint()).x(); };
        QVERIFY(leftOf(table) >= leftOf(segment) + segment->width());
        shown.panel.resize(580, 200);
        settle();
        QVERIFY(leftOf(table) < leftOf(segment));
        QVERIFY(table->height() > 100);
    }

    void whatCameOutIsReadWholeWhereItIsNarrow()
    {
        Shown shown(Settings);
        shown.panel.resize(580, 200);
        for (const QString name : {"iterationsLabel", "instantsLabel"}) {
            const auto *label = child<QLabel>(shown.panel, name);
            AWAIT2(label->width() >= label->fontMetrics().horizontalAdvance(label->text()),
                   qPrintable(QString("%1: %2").arg(label->text()).arg(label->width())));
        }
    }

    void everyControlHasANameForThoseWhoCannotSee()
    {
        NewtonPanel panel;
        for (const char *name :
             {"equationTable", "jacobianTable", "iterationTable", "iterationPlot", "coordinateTable"}) {
            QVERIFY2(!child<QWidget>(panel, name)->accessibleName().isEmpty(), name);
        }
        for (const char *name : {"methodBox", "toleranceBox", "toleranceKindBox", "iterationsBox"}) {
            QVERIFY2(!child<QWidget>(panel, name)->accessibleName().isEmpty(), name);
        }
    }
};

QTEST_MAIN(TestNewtonPanel)
#include "tst_newton_panel.moc"
