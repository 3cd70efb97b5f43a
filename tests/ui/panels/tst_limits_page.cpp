// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"
#include "tests/support/page_text.h"
#include "tests/support/suite.h"
#include "ui/panels/limits_page.h"
#include "ui/text/motion_facts.h"

#include <QLocale>
#include <QScopeGuard>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_limits_page
{

enum Column { Name, Value, Angle, Time };
enum Section { Positions, Peaks };

Page pageOf(const Parameters &parameters, const Sampling &sampling = {})
{
    Result result;
    result.mechanism = Mechanism(parameters);
    result.sampling = sampling;
    result.limits = motionLimits(result.mechanism);
    return limitsPage(result);
}

TableRow rowNamed(const Page &page, const QString &name)
{
    const std::vector<TableRow> &rows = page.tables[0].rows;
    return *std::ranges::find(rows, name, [](const TableRow &row) { return row.cells[Name].text; });
}

class TestLimitsPage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    /// A former defect: the file had the names of the language of the window.
    void filesHaveTheNamesOfTheCommandLine()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const auto namesOf = [](const Page &page) {
            QStringList names;
            for (const TableRow &row : page.tables[0].rows) {
                names << row.cells[Name].csv;
            }
            return names;
        };
        const QStringList names = namesOf(pageOf({}));
        QVERIFY2(names.contains("outer-dead-centre [mm]") && names.contains("time-ratio") &&
                     names.contains("minimum-coupler-angle [deg]"),
                 qPrintable(names.join(", ")));
        QVERIFY(namesOf(pageOf({20, 40, 25})).contains("crank-limit [mm]"));
        setNotation({.symbols = Symbols::Textbook});
        QVERIFY(namesOf(pageOf({})).contains("minimum-coupler-angle at B [deg]"));
    }

    void saysWhetherTheCrankMakesFullTurnsAndWhy()
    {
        const QString jump = "Where the coupler is perpendicular to the slider's line, the velocities jump.";
        struct Row {
            Parameters parameters;
            QString sentence;
        };
        for (const Row &row :
             {Row{{20, 65, 25}, "The crank can make full turns: b = 65 mm ≥ a + |c| = 45 mm."},
              Row{{20, 65, -25}, "The crank can make full turns: b = 65 mm ≥ a + |c| = 45 mm."},
              Row{{.omega2 = 0.0}, "The crank can make full turns: b = 65 mm ≥ a + |c| = 45 mm."},
              Row{{20, 40, 25}, "The crank oscillates and cannot make a full turn: b = 40 mm < a + |c| = 45 mm."},
              Row{{20, 10, 5},
                  "The crank oscillates within one of two arcs and cannot make a full turn: b = 10 mm < a + |c| = 25 "
                  "mm, and also less than a − |c| = 15 mm."},
              Row{{20, 5, 25},
                  "The crank is locked in a single position: b = |c| − a = 5 mm. It makes full turns if b ≥ a + |c| = "
                  "45 mm."},
              Row{{20, 4, 25},
                  "The mechanism cannot be assembled: b = 4 mm < |c| − a = 5 mm. The crank makes full turns if b ≥ a + "
                  "|c| = 45 mm."},
              Row{{20, 45, 25}, "The crank can make full turns: b = 45 mm ≥ a + |c| = 45 mm. " + jump},
              Row{{20, 45, -25}, "The crank can make full turns: b = 45 mm ≥ a + |c| = 45 mm. " + jump},
              Row{{20, 20, 0}, "The crank can make full turns: b = 20 mm ≥ a + |c| = 20 mm. " + jump},
              Row{{20, 45 * (1 - 1e-8), 25},
                  "The crank oscillates and cannot make a full turn: b = 44.99999955 mm < a + |c| = 45 mm."}}) {
            QCOMPARE(pageOf(row.parameters).sentence, row.sentence);
        }
    }

    void roundsTheShortestCouplerUp()
    {
        const Mechanism mechanism({17.1234561, 40.0, -31.9876543});
        QCOMPARE(atLeastText(shortestCouplerForFullTurn(mechanism)), "49.1112 mm"); // 49.1111104
        QCOMPARE(atLeastText(0.1 + 0.2), "0.3 mm");
    }

    void listsLimitsAndPeaksForEveryMobility()
    {
        struct Row {
            Parameters parameters;
            Section section;
            QStringList rows;
        };
        for (const Row &row :
             {Row{{20, 65, 25},
                  Positions,
                  {"outer dead centre|81.24 mm|17.10|0.04751", "inner dead centre|37.42 mm|213.75|0.5937",
                   "stroke|43.82 mm||", "crank angle, forward stroke|163.4°||", "time, forward stroke|0.4538 s||",
                   "mean speed, forward stroke|96.58 mm/s||", "crank angle, return stroke|196.6°||",
                   "time, return stroke|0.5462 s||", "mean speed, return stroke|80.23 mm/s||", "time ratio|1.204||",
                   "minimum transmission angle|46.19°|270.00|0.75", "maximum transmission angle|85.59°|90.00|0.25",
                   "minimum coupler angle|4.412°|90.00|0.25", "maximum coupler angle|43.81°|270.00|0.75",
                   "swing of the coupler|39.40°||"}},
              Row{{20, 65, 25},
                  Peaks,
                  {"peak slider velocity|162.9 mm/s|301.81|0.8384", "peak slider acceleration|−1110 mm/s²|6.41|0.0178",
                   "peak coupler angular velocity|121.4 °/s|189.22|0.5256",
                   "peak coupler angular velocity|−121.4 °/s|350.78|0.9744",
                   "peak coupler angular acceleration|−964.5 °/s²|270.00|0.75"}},
              Row{{20, 65, 0},
                  Peaks, // peaks that are reached twice are ordered by their angle
                  {"peak slider velocity|−131.5 mm/s|74.21|0.2061", "peak slider velocity|131.5 mm/s|285.79|0.7939",
                   "peak slider acceleration|−1033 mm/s²|0.00|0", "peak coupler angular velocity|−110.8 °/s|0.00|0",
                   "peak coupler angular velocity|110.8 °/s|180.00|0.5",
                   "peak coupler angular acceleration|731.5 °/s²|90.00|0.25",
                   "peak coupler angular acceleration|−731.5 °/s²|270.00|0.75"}},
              Row{{20, 40, 25},
                  Positions,
                  {"outer dead centre|54.54 mm|24.62|0.0684", "crank limit position|−13.23 mm|228.59|0.635",
                   "crank limit position|13.23 mm|311.41|0.865", "stroke|67.77 mm||",
                   "minimum transmission angle|0°|228.59|0.635", "minimum transmission angle|0°|311.41|0.865",
                   "maximum transmission angle|82.82°|90.00|0.25", "minimum coupler angle|7.181°|90.00|0.25",
                   "maximum coupler angle|90.00°|228.59|0.635", "maximum coupler angle|90.00°|311.41|0.865",
                   "swing of the coupler|82.82°||"}},
              Row{{20, 40, 25},
                  Peaks,
                  {"peak slider velocity|∞ mm/s|228.59|0.635", "peak slider velocity|∞ mm/s|311.41|0.865",
                   "peak slider acceleration|∞ mm/s²|228.59|0.635", "peak slider acceleration|∞ mm/s²|311.41|0.865",
                   "peak coupler angular velocity|∞ °/s|228.59|0.635",
                   "peak coupler angular velocity|∞ °/s|311.41|0.865",
                   "peak coupler angular acceleration|∞ °/s²|228.59|0.635",
                   "peak coupler angular acceleration|∞ °/s²|311.41|0.865"}},
              Row{{20, 45, 25},
                  Peaks,
                  {"peak slider velocity|314.2 mm/s|270.00|0.75", "peak slider acceleration|∞ mm/s²|270.00|0.75",
                   "peak coupler angular velocity|240.0 °/s|270.00|0.75",
                   "peak coupler angular acceleration|∞ °/s²|270.00|0.75"}},
              Row{{20, 20, 0},
                  Peaks,
                  {"peak slider velocity|−251.3 mm/s|90.00|0.25", "peak slider velocity|251.3 mm/s|270.00|0.75",
                   "peak slider acceleration|∞ mm/s²|90.00|0.25", "peak slider acceleration|∞ mm/s²|270.00|0.75",
                   "peak coupler angular velocity|360.0 °/s|throughout|",
                   "peak coupler angular acceleration|∞ °/s²|90.00|0.25",
                   "peak coupler angular acceleration|∞ °/s²|270.00|0.75"}},
              Row{{20, 5, 25},
                  Positions,
                  {"outer dead centre|0 mm|90.00|0.25", "crank limit position|0 mm|90.00|0.25", "stroke|0 mm||",
                   "minimum transmission angle|0°|90.00|0.25", "maximum transmission angle|0°|90.00|0.25",
                   "minimum coupler angle|90.00°|90.00|0.25", "maximum coupler angle|90.00°|90.00|0.25",
                   "swing of the coupler|0°||"}},
              Row{{20, 4, 25}, Positions, {}}, Row{{20, 4, 25}, Peaks, {}},
              Row{{.omega2 = 0.0},
                  Peaks,
                  {"peak slider velocity|0 mm/s|crank at rest|", "peak slider acceleration|0 mm/s²|crank at rest|",
                   "peak coupler angular velocity|0 °/s|crank at rest|",
                   "peak coupler angular acceleration|0 °/s²|crank at rest|"}}}) {
            QStringList rows = rowTexts(pageOf(row.parameters).tables[0]);
            rows.removeIf([&](const QString &text) { return text.startsWith("peak ") != (row.section == Peaks); });
            QCOMPARE(rows, row.rows);
        }
    }

    void copiesEveryDigitAndKnowsTheTimeOfEachRow()
    {
        // Crank and coupler are in one line at the dead centres, where Pythagoras' theorem gives R4x.
        const double stroke = std::sqrt(80.0 * 80.0 - 625.0) - std::sqrt(40.0 * 40.0 - 625.0);
        const Page of60 = pageOf({20, 60, 25});
        const TableRow row = rowNamed(of60, "stroke");
        QVERIFY(!row.time && std::abs(row.cells[Value].number.value() / stroke - 1.0) < 1e-12);
        QCOMPARE(row.cells[Name].csv, "stroke [mm]");
        const ClosedForm motion{Mechanism()};
        const Page page = pageOf({});
        QVERIFY(std::abs(motion.motionAt(rowNamed(page, "outer dead centre").time.value()).R4xDot) < 1e-11);
        QVERIFY(std::abs(motion.motionAt(rowNamed(page, "peak slider velocity").time.value()).R4xDDot) < 1e-10);
    }

    void hasNoTimeForRowsOutsideTheTimeRange()
    {
        Sampling half;
        half.duration = 0.5;
        const Page page = pageOf({}, half);
        QCOMPARE(rowNamed(page, "outer dead centre").cells[Time].text, "0.04751");
        const TableRow inner = rowNamed(page, "inner dead centre");
        QVERIFY(!inner.time);
        QCOMPARE(inner.cells[Angle].text, "213.75");
        QVERIFY(inner.explanation.contains("Outside"));

        Sampling justEnough; // includes the last time step
        justEnough.duration = 0.75;
        QVERIFY(rowNamed(pageOf({}, justEnough), "peak coupler angular acceleration").time);
        Parameters steepest; // at rest where the coupler is steepest
        steepest.omega2 = 0.0;
        steepest.theta20 = 1.5 * std::numbers::pi;
        QCOMPARE(rowNamed(pageOf(steepest), "minimum transmission angle").time, std::optional(0.0));
    }

    void canBeAssembledAtTheTimeOfEveryRow()
    {
        for (int i = 0; i < 50; ++i) {
            const Parameters parameters{20.0 + 0.37 * i, 30.0 + 0.11 * i, (i % 2 == 0 ? 1.0 : -1.0) * 15.3};
            const ClosedForm motion{Mechanism(parameters)};
            const Page page = pageOf(parameters);
            for (const TableRow &row : page.tables[0].rows) {
                const Status status = row.time ? motion.motionAt(*row.time).status : Status::Solved;
                QVERIFY2(status == Status::Solved || status == Status::Singular, qPrintable(row.cells[Name].text));
            }
        }
    }
};

const Suite<TestLimitsPage> suite("tst_limits_page");

} // namespace tst_limits_page

#include "tst_limits_page.moc"
