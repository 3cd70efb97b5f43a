// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/panels/study_page.h"
#include "ui/panels/study_panel.h"
#include "ui/text/study_text.h"

#include "tests/support/page_text.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace slidercrank;

namespace tst_study_panel
{

MethodResult methodRow(MethodName::Kind kind, int channels, double time, double error)
{
    MethodResult row;
    row.method.kind = kind;
    row.channels = channels;
    row.nanosecondsPerState = time;
    row.maxError = error;
    row.errorBound = 1e-15;
    row.counts[0] = 10;
    return row;
}

class TestStudyPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    /// A former defect: the Spanish text contained "GNU C++ version 12.2.0".
    void namesTheCompilerWithoutAWord() { QVERIFY2(!machineText().contains("version"), qPrintable(machineText())); }

    void listsMethodsWithTheirChannels()
    {
        CaseResult result;
        result.methods = {methodRow(MethodName::Kind::NewtonDense, 36, 3000.0, 3e-15),
                          methodRow(MethodName::Kind::ClosedFormBatch, 6, 5.0, 0.0),
                          methodRow(MethodName::Kind::ClosedForm, 36, 50.0, 5e-16),
                          methodRow(MethodName::Kind::ClosedForm, 36, 40.0, 6e-16)};
        result.methods[0].silentFailures = 2;
        const Page page = studyPage(result);
        QCOMPARE(rowTexts(page.tables.at(0)),
                 (QStringList{"Newton-Raphson, dense|36|–|3000|3.00·10⁻¹⁵|–|10 solved, 2 reported as solved but wrong",
                              "closed form, batch|6|–|5.00|0|–|solved", "closed form|36|–|50.0|5.00·10⁻¹⁶|–|solved",
                              "closed form|36|–|40.0|6.00·10⁻¹⁶|–|solved"}));
        QCOMPARE(page.tables[0].rows[0].cells[6].tone, Tone::Bad);
        const ChartContent &chart = page.chart->content;
        QCOMPARE(chart.series[0].points[0], QPointF(3000.0, 3e-15));
        QCOMPARE(chart.series[2].points, (std::vector{QPointF(40.0, 6e-16), QPointF(50.0, 5e-16)})); // ascending
        QVERIFY(chart.series[2].tips[0].contains("40.0 ns") && chart.series[2].tips[1].contains("50.0 ns"));
        QVERIFY(chart.series[1].isHollow && !chart.series[2].isHollow);
        QVERIFY(chart.series[1].points[0].y() >= chart.y.range.lower); // an error of 0 is drawn, too
        QVERIFY(chart.x.range.contains(3000.0) && chart.x.range.contains(5.0));
    }

    void runsInTheBackgroundAndShowsEveryMethod()
    {
        Session session;
        session.setParameter(Parameter::B, 6.0); // the study is short, because the mechanism can hardly be assembled
        StudyPanel panel(&session);
        panel.show();
        QSignalSpy busy(&session, &Session::busyChanged);
        const auto run = [&] { child<QPushButton>(panel, "remedyButton")->click(); };
        run();
        QCOMPARE(busy.takeLast(), QVariantList{true}); // the call returned at once
        AWAIT(!busy.isEmpty());
        QVERIFY(child<QTableView>(panel, "studyTable")->model()->rowCount() > 0);
        const auto *note = child<QLabel>(panel, "studyPanelNote");
        QVERIFY(!note->text().contains("run again"));
        session.setParameter(Parameter::B, 70.0);
        letTimePass(panel);
        QVERIFY(note->text().contains("run again"));

        busy.clear();
        run();
        session.cancel();
        QCOMPARE(busy.takeLast(), QVariantList{false});
        QVERIFY(note->text().contains("run again")); // the former result is still shown
    }
};

const Suite<TestStudyPanel> suite("tst_study_panel");

} // namespace tst_study_panel

#include "tst_study_panel.moc"
