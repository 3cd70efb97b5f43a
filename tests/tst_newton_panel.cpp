// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/newton_panel.h"
#include "ui/number_box.h"
#include "ui/session.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

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

} // namespace

class TestNewtonPanel : public QObject
{
    Q_OBJECT

private:
    Sampling m_sampling;
    SolverSettings m_solver;
    int m_edits = 0;

    void listenTo(const NewtonPanel &panel)
    {
        m_edits = 0;
        connect(&panel, &NewtonPanel::edited, this, [this](const Sampling &sampling, const SolverSettings &solver) {
            m_sampling = sampling;
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
        panel.setSettings({0.5, 2.5, 400}, {Method::Newton, {25, 1e-10}});
        QCOMPARE(m_edits, 0);
        QCOMPARE(child<QComboBox>(panel, "methodBox")->currentText(), QString("Newton-Raphson"));
        QCOMPARE(child<QSpinBox>(panel, "stepsBox")->value(), 400);
        QCOMPARE(child<NumberBox>(panel, "durationBox")->value(), 2.5);
        QCOMPARE(child<NumberBox>(panel, "startBox")->value(), 0.5);
        QCOMPARE(child<QLineEdit>(panel, "toleranceBox")->text(), QString("1e-10"));
        QCOMPARE(child<QSpinBox>(panel, "iterationsBox")->value(), 25);
    }

    void eachControlChangesItsOwnSettingOnly()
    {
        const Sampling sampling{0.5, 2.5, 400};
        const SolverSettings solver{Method::Newton, {25, 1e-10}};
        NewtonPanel panel;
        panel.setSettings(sampling, solver);
        listenTo(panel);

        type(child<QSpinBox>(panel, "stepsBox"), "500");
        QCOMPARE(m_edits, 1);
        QCOMPARE(m_sampling, (Sampling{0.5, 2.5, 500}));
        QCOMPARE(m_solver, solver);
        type(child<NumberBox>(panel, "durationBox"), "3.25");
        QCOMPARE(m_sampling, (Sampling{0.5, 3.25, 500}));
        type(child<NumberBox>(panel, "startBox"), "-1");
        QCOMPARE(m_sampling, (Sampling{-1.0, 3.25, 500}));
        QCOMPARE(m_solver, solver);
        type(child<QLineEdit>(panel, "toleranceBox"), "3e-7");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {25, 3e-7}}));
        type(child<QLineEdit>(panel, "toleranceBox"), "0");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {25, 0.0}}));
        type(child<QSpinBox>(panel, "iterationsBox"), "40");
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {40, 0.0}}));
        QCOMPARE(m_sampling, (Sampling{-1.0, 3.25, 500}));
        QCOMPARE(m_edits, 6);
        QTest::keyClick(child<QComboBox>(panel, "toleranceKindBox"), Qt::Key_Down);
        QCOMPARE(m_edits, 7);
        QCOMPARE(m_solver, (SolverSettings{Method::Newton, {40, 0.0, ToleranceKind::Relative}}));
        auto *method = child<QComboBox>(panel, "methodBox");
        QTest::keyClick(method, Qt::Key_Down);
        QCOMPARE(m_edits, 8);
        QCOMPARE(m_solver, (SolverSettings{Method::ClosedForm, {40, 0.0, ToleranceKind::Relative}}));
        QVERIFY(!child<QComboBox>(panel, "toleranceKindBox")->isEnabled());
        QVERIFY(!child<QLineEdit>(panel, "toleranceBox")->isEnabled());
    }

    void whatCannotBeIsNotTakenOver()
    {
        NewtonPanel panel;
        panel.setSettings({}, {});
        listenTo(panel);
        type(child<QLineEdit>(panel, "toleranceBox"), "small");
        type(child<QLineEdit>(panel, "toleranceBox"), "-1e-8");
        type(child<NumberBox>(panel, "durationBox"), "0");
        type(child<NumberBox>(panel, "durationBox"), "-2");
        type(child<NumberBox>(panel, "startBox"), "1e13");
        QCOMPARE(m_edits, 0);
        QCOMPARE(child<QLineEdit>(panel, "toleranceBox")->text(), QString("1e-8"));
        QCOMPARE(child<NumberBox>(panel, "durationBox")->value(), 1.0);
        QCOMPARE(child<NumberBox>(panel, "startBox")->value(), 0.0);
    }

    void listenersMayAnswerAtOnce()
    {
        // As the session does: after the solver it publishes settings with the old sampling.
        NewtonPanel panel;
        panel.setSettings({}, {});
        int steps = 0;
        connect(&panel, &NewtonPanel::edited, &panel, [&](const Sampling &sampling, const SolverSettings &solver) {
            panel.setSettings({}, solver);
            steps = sampling.steps;
        });
        type(child<QSpinBox>(panel, "stepsBox"), "300");
        QCOMPARE(steps, 300);
    }

    void tellsWhatCameOut()
    {
        Session session;
        session.setSolver({Method::Newton, {}});
        NewtonPanel panel;
        panel.setResult(session.result());
        const Trajectory &run = session.result()->trajectory;
        QVERIFY(child<QLabel>(panel, "iterationsLabel")->text().contains(QString::number(run.iterations)));
        QVERIFY(child<QLabel>(panel, "iterationsLabel")->text().contains(QString::number(run.mostIterations)));
        QCOMPARE(child<QLabel>(panel, "instantsLabel")->text(), QString("all 201 solved"));
        QVERIFY(child<QLabel>(panel, "explanationLabel")->text().isEmpty());
        session.setSolver({Method::ClosedForm, {}});
        panel.setResult(session.result());
        QCOMPARE(child<QLabel>(panel, "residualLabel")->text(), QString("–"));
    }

    void explainsWhatFailed()
    {
        Session session;
        session.setSolver({Method::Newton, {2, 1e-8}});
        NewtonPanel panel;
        panel.setResult(session.result());
        const auto failed = session.result()->trajectory.count(Status::IterationLimit);
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
        const auto missing = session.result()->trajectory.count(Status::NotAssemblable);
        QVERIFY(missing > 0);
        QVERIFY2(text.contains(QString("%1 of 201 instants cannot be assembled").arg(missing)), qPrintable(text));
        QVERIFY(!text.contains("%"));
    }

    void everyControlHasANameForThoseWhoCannotSee()
    {
        NewtonPanel panel;
        for (const char *name : {"methodBox", "stepsBox", "durationBox", "startBox", "toleranceBox", "toleranceKindBox",
                                 "iterationsBox"}) {
            QVERIFY2(!child<QWidget>(panel, name)->accessibleName().isEmpty(), name);
        }
    }
};

QTEST_MAIN(TestNewtonPanel)
#include "tst_newton_panel.moc"
