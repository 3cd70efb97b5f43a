// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/panels/study_page.h"
#include "ui/panels/study_panel.h"

#include "tests/support/page_text.h"
#include "tests/support/study_of_a_turn.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace slidercrank;

namespace
{

MethodResult methodRow(MethodName::Kind kind, int channels, double time, double error)
{
    MethodResult row;
    row.method.kind = kind;
    row.channels = channels;
    row.nsPerState = time;
    row.maxError = error;
    row.errorBound = 1e-15;
    row.counts[0] = 10;
    return row;
}

} // namespace

class TestStudyPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void separatesMethodsOf36And6Channels()
    {
        CaseResult result;
        result.methods = {methodRow(MethodName::Kind::NewtonDense, 36, 3000.0, 3e-15),
                          methodRow(MethodName::Kind::ClosedFormBatch, 6, 5.0, 0.0),
                          methodRow(MethodName::Kind::ClosedForm, 36, 50.0, 5e-16)};
        result.methods[0].silentFailures = 2;
        const Page page = studyPage(result);
        QCOMPARE(page.tables.size(), 2u);
        QCOMPARE(rowTexts(page.tables[0]),
                 (QStringList{"Newton-Raphson, dense|–|3000|3.00·10⁻¹⁵|–|solved, 2 wrong but called solved",
                              "closed form|–|50.0|5.00·10⁻¹⁶|–|solved"}));
        QCOMPARE(rowTexts(page.tables[1]), QStringList("closed form, batch|–|5.00|0|–|solved"));
        QCOMPARE(page.tables[0].rows[0].cells[5].tone, Tone::Bad);
        const ChartContent &chart = page.chart->content;
        QCOMPARE(chart.series[0].points[0], QPointF(3000.0, 3e-15));
        QVERIFY(chart.series[1].isHollow && !chart.series[2].isHollow);
        QVERIFY(chart.series[1].points[0].y() >= chart.y.range.lower); // an error of 0 is drawn, too
        QVERIFY(chart.x.range.contains(3000.0) && chart.x.range.contains(5.0));
        QVERIFY(emptyStudyPage().tables.empty());
    }

    void drawsEveryMethodAsAPoint()
    {
        const std::shared_ptr<const StudyResult> study = studyOfATurn();
        const Page page = studyPage(study->cases[0]);
        std::size_t points = 0;
        for (const ChartSeries &series : page.chart->content.series) {
            QVERIFY(std::ranges::is_sorted(series.points, {}, &QPointF::x));
            QVERIFY(series.mark.isEmpty() || series.tips.size() == static_cast<qsizetype>(series.points.size()));
            points += series.mark.isEmpty() ? 0 : series.points.size(); // the effect of rounded input has no mark
        }
        QCOMPARE(points, study->cases[0].methods.size());
        QCOMPARE(page.tables[0].rows.size() + page.tables[1].rows.size(), points);
    }

    void runsInTheBackgroundAndShowsEveryMethod()
    {
        Session session;
        StudyPanel panel(&session);
        panel.show();
        QSignalSpy busy(&session, &Session::busyChanged);
        child<QPushButton>(panel, "runThisButton")->click();
        QCOMPARE(busy.takeLast(), QVariantList{true}); // the call returned at once
        AWAIT(!busy.isEmpty());
        for (const char *table : {"studyTable36", "studyTable6"}) {
            QVERIFY(child<QTableView>(panel, table)->model()->rowCount() > 0);
        }
        const auto *summary = child<QLabel>(panel, "studySummary");
        QVERIFY(!summary->text().contains("run again"));
        session.setParameter(Parameter::B, 70.0);
        QVERIFY(summary->text().contains("run again"));

        child<QPushButton>(panel, "runHardButton")->click();
        QCOMPARE(busy.takeLast(), QVariantList{true});
        session.cancel();
        QCOMPARE(busy.takeLast(), QVariantList{false});
        QVERIFY(!child<QComboBox>(panel, "caseBox")->isVisible()); // the former result is still shown
    }
};

const Suite suite("tst_study_panel", runWithWidgets<TestStudyPanel>);
#include "tst_study_panel.moc"
