// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/closed_form.h"
#include "ui/panels/limits_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace
{

enum Column { Name, Value, Angle, Instant };

template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

std::shared_ptr<const Result> resultOf(const Parameters &parameters, const Sampling &sampling = {})
{
    auto result = std::make_shared<Result>();
    result->mechanism = Mechanism(parameters);
    result->sampling = sampling;
    result->limits = motionLimits(result->mechanism);
    return result;
}

Parameters lengths(double a, double b, double c)
{
    Parameters parameters;
    parameters.a = a;
    parameters.b = b;
    parameters.c = c;
    return parameters;
}

QString textOf(const QTableView *table, int row, int column)
{
    return table->model()->index(row, column).data().toString();
}

int rowCountOf(const QTableView *table)
{
    return table->model()->rowCount();
}

/// A panel on show with that mechanism.
struct Shown {
    LimitsPanel panel;

    explicit Shown(const Parameters &parameters, const Sampling &sampling = {})
    {
        panel.resize(960, 200);
        panel.show();
        panel.setResult(resultOf(parameters, sampling));
    }

    QString reason() const { return child<QLabel>(panel, "mobilityLabel")->text(); }
    QTableView *positions() const { return child<QTableView>(panel, "positionTable"); }
    QTableView *peaks() const { return child<QTableView>(panel, "peakTable"); }

    /// The rows as text: "stroke|43.8238 mm||–".
    static QStringList rowsOf(const QTableView *table)
    {
        QStringList rows;
        for (int row = 0; row < rowCountOf(table); ++row) {
            QStringList cells;
            for (int column = 0; column < 4; ++column) {
                cells << textOf(table, row, column);
            }
            rows << cells.join('|');
        }
        return rows;
    }
};

int rowStarting(const QTableView *table, const QString &name)
{
    for (int row = 0; row < rowCountOf(table); ++row) {
        if (textOf(table, row, Name) == name) {
            return row;
        }
    }
    return -1;
}

} // namespace

class TestLimitsPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void saysWhetherTheCrankTurnsAndWhy_data()
    {
        QTest::addColumn<double>("a");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("Table 1") << 20.0 << 65.0 << 25.0 << "The crank turns round: b = 65 mm ≥ a + |c| = 45 mm.";
        QTest::newRow("c < 0") << 20.0 << 65.0 << -25.0 << "The crank turns round: b = 65 mm ≥ a + |c| = 45 mm.";
        QTest::newRow("rocker") << 20.0 << 40.0 << 25.0
                                << "The crank rocks: b = 40 mm < a + |c| = 45 mm. It would turn round with b ≥ 45 mm, "
                                   "a ≤ 15 mm or |c| ≤ 20 mm.";
        QTest::newRow("rocker that turns without its offset")
            << 20.0 << 20.0 << 5.0
            << "The crank rocks: b = 20 mm < a + |c| = 25 mm. It would turn round with b ≥ 25 mm, a ≤ 15 mm or c = 0.";
        QTest::newRow("rocker, two arcs") << 20.0 << 10.0 << 5.0
                                          << "The crank rocks within one of two arcs: b = 10 mm < a + |c| = 25 mm, and "
                                             "less than a − |c| = 15 mm too. "
                                             "It would turn round with b ≥ 25 mm or a ≤ 5 mm.";
        QTest::newRow("locked") << 20.0 << 5.0 << 25.0
                                << "The crank is locked in one pose: b = |c| − a = 5 mm. It would turn round with b ≥ "
                                   "45 mm.";
        QTest::newRow("impossible") << 20.0 << 4.0 << 25.0
                                    << "It cannot be assembled: b = 4 mm < |c| − a = 5 mm. There is a pose with b ≥ 5 "
                                       "mm, a ≥ 21 mm or |c| ≤ 24 mm. It would turn round with b ≥ 45 mm.";
        QTest::newRow("exact toggle") << 20.0 << 45.0 << 25.0
                                      << "The crank just turns round: b = a + |c| = 45 mm. At θ₂ = 270° the coupler is "
                                         "perpendicular to the slider's line, and the speeds jump.";
        QTest::newRow("change point")
            << 20.0 << 20.0 << 0.0
            << "The crank just turns round: b = a = 20 mm, c = 0, a change point. At θ₂ = 90° and 270° the coupler is "
               "perpendicular to the slider's line, and the speeds jump.";
        QTest::newRow("by a hair")
            << 20.0 << 45.0 * (1.0 - 1e-8) << 25.0
            << "The crank rocks: b = 44.9999995 mm < a + |c| = 45 mm. It would turn round with b ≥ "
               "45 mm, a ≤ 19.9999 mm or |c| ≤ 24.9999 mm.";
    }
    void saysWhetherTheCrankTurnsAndWhy()
    {
        QFETCH(double, a);
        QFETCH(double, b);
        QFETCH(double, c);
        QFETCH(QString, sentence);
        QCOMPARE(Shown(lengths(a, b, c)).reason(), sentence);
    }

    void aCrankWithoutSpeedStandsStill()
    {
        Parameters parameters = lengths(20.0, 65.0, 25.0);
        parameters.omega2 = 0.0;
        QCOMPARE(Shown(parameters).reason(),
                 QStringLiteral("The crank stands still, ω₂ = 0; it could turn round: b = 65 mm ≥ a + |c| = 45 mm."));
    }

    void theReasonOfAToggleDoesNotDependOnTheSpeed()
    {
        Parameters parameters = lengths(20.0, 45.0, -25.0);
        const QString turning = Shown(parameters).reason();
        QVERIFY(turning.contains("At θ₂ = 90° the coupler"));
        parameters.omega2 = 0.0;
        QCOMPARE(Shown(parameters).reason(), turning);
    }

    void theHelpOfferedHelps()
    {
        const double a = 17.1234567;
        const double b = 40.7654321;
        const double c = -31.9876543;
        const QString reason = Shown(lengths(a, b, c)).reason();
        const auto limitOf = [&reason](const QString &symbol) {
            const qsizetype start = reason.indexOf(symbol, reason.indexOf("with")) + symbol.size();
            return reason.mid(start, reason.indexOf(" mm", start) - start).toDouble();
        };
        const auto turns = [](double crank, double coupler, double offset) {
            return motionLimits(Mechanism(lengths(crank, coupler, offset))).mobility == Mobility::FullTurn;
        };
        QVERIFY(!turns(a, b, c));
        QVERIFY2(turns(a, limitOf("b ≥ "), c), qPrintable(reason));
        QVERIFY2(turns(limitOf("a ≤ "), b, c), qPrintable(reason));
        QVERIFY2(turns(a, b, -limitOf("|c| ≤ ")), qPrintable(reason));
    }

    void table1()
    {
        const Shown shown{Parameters()};
        const QStringList positions = Shown::rowsOf(shown.positions());
        QCOMPARE(positions, QStringList({"outer dead centre|81.2404 mm|17.10|0.0475",
                                         "inner dead centre|37.4166 mm|213.75|0.5937", "stroke|43.8238 mm||–",
                                         "forward stroke|163.36°|in 0.4538 s|–", "return stroke|196.64°|in 0.5462 s|–",
                                         "mean speed forward|96.5781 mm/s||–", "mean speed back|80.229 mm/s||–",
                                         "time ratio|1.20378||–", "least transmission angle|46.19°|270.00|0.7500"}));
        const QStringList peaks = Shown::rowsOf(shown.peaks());
        QCOMPARE(peaks, QStringList({"slider speed|162.859 mm/s|301.81|0.8384",
                                     "slider acceleration|-1109.56 mm/s²|6.41|0.0178",
                                     "coupler speed|121.358 °/s|189.22|0.5256", "|-121.358 °/s|350.78|0.9744",
                                     "coupler acceleration|-964.497 °/s²|270.00|0.7500"}));
    }

    void aRowLeadsToItsInstant()
    {
        Shown shown{Parameters()};
        QVERIFY(QTest::qWaitForWindowExposed(&shown.panel));
        QSignalSpy spy(&shown.panel, &LimitsPanel::timeRequested);
        const auto click = [](QTableView *table, int row, int column) {
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                              table->visualRect(table->model()->index(row, column)).center());
        };
        const ClosedForm motion{Mechanism()};

        click(shown.positions(), rowStarting(shown.positions(), "outer dead centre"), Name);
        QCOMPARE(spy.count(), 1);
        QVERIFY(std::abs(motion.motionAt(spy.takeFirst()[0].toDouble()).R4xDot) < 1e-11);

        const int speed = rowStarting(shown.peaks(), "slider speed");
        click(shown.peaks(), speed, Instant);
        QVERIFY(std::abs(motion.motionAt(spy.takeFirst()[0].toDouble()).R4xDDot) < 1e-10);

        const int turning = rowStarting(shown.peaks(), "coupler speed");
        shown.peaks()->setCurrentIndex(shown.peaks()->model()->index(turning + 1, Value));
        QTest::keyClick(shown.peaks(), Qt::Key_Return);
        QCOMPARE(spy.count(), 1);
        QVERIFY(std::abs(spy.takeFirst()[0].toDouble() - 0.9744) < 1e-4);

        click(shown.positions(), rowStarting(shown.positions(), "stroke"), Value);
        QCOMPARE(spy.count(), 0); // of no instant
    }

    void whatTheRunDoesNotReachCannotBeVisited()
    {
        Sampling half;
        half.duration = 0.5;
        const Shown shown(Parameters(), half);
        QTableView *table = shown.positions();
        const int outer = rowStarting(table, "outer dead centre");
        const int inner = rowStarting(table, "inner dead centre");
        QCOMPARE(textOf(table, outer, Instant), QString("0.04751"));
        QCOMPARE(textOf(table, inner, Instant), QString("–"));
        QCOMPARE(textOf(table, inner, Angle), QString("213.75"));
        QVERIFY(table->model()->index(inner, Instant).data(Qt::ToolTipRole).toString().contains("does not come there"));
        QSignalSpy spy(&shown.panel, &LimitsPanel::timeRequested);
        table->setCurrentIndex(table->model()->index(inner, Name));
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(spy.count(), 0);
    }

    void theRunsLastInstantCounts()
    {
        Sampling run; // the coupler's acceleration peaks at 270°, three quarters of a second on
        run.duration = 0.75;
        const Shown shown(Parameters(), run);
        const int row = rowStarting(shown.peaks(), "coupler acceleration");
        QVERIFY(textOf(shown.peaks(), row, Instant) != QString("–"));
    }

    void whatGrowsWithoutBoundIsNoNumber_data()
    {
        QTest::addColumn<Parameters>("parameters");
        QTest::addColumn<QStringList>("peaks");
        QTest::newRow("rocker") << lengths(20.0, 40.0, 25.0)
                                << QStringList(
                                       {"speeds, accelerations|unbounded|228.59|0.6350", "|unbounded|311.41|0.8650"});
        QTest::newRow("exact toggle") << lengths(20.0, 45.0, 25.0)
                                      << QStringList({"slider speed|314.159 mm/s|270.00|0.7500",
                                                      "coupler speed|240 °/s|270.00|0.7500",
                                                      "accelerations|unbounded|270.00|0.7500"});
        QTest::newRow("change point") << lengths(20.0, 20.0, 0.0)
                                      << QStringList(
                                             {"slider speed|-251.327 mm/s|90.00|0.2500", "|251.327 mm/s|270.00|0.7500",
                                              "coupler speed|360 °/s|throughout|–",
                                              "accelerations|unbounded|90.00|0.2500", "|unbounded|270.00|0.7500"});
    }
    void whatGrowsWithoutBoundIsNoNumber()
    {
        QFETCH(Parameters, parameters);
        QFETCH(QStringList, peaks);
        QCOMPARE(Shown::rowsOf(Shown(parameters).peaks()), peaks);
    }

    void aPeakReachedTwiceIsReadFromZeroOn()
    {
        const Shown shown(lengths(20.0, 65.0, 0.0));
        QCOMPARE(Shown::rowsOf(shown.peaks()),
                 QStringList({"slider speed|-131.522 mm/s|74.21|0.2061", "|131.522 mm/s|285.79|0.7939",
                              "slider acceleration|-1032.51 mm/s²|0.00|0.0000",
                              "coupler speed|-110.769 °/s|0.00|0.0000", "|110.769 °/s|180.00|0.5000",
                              "coupler acceleration|731.47 °/s²|90.00|0.2500", "|-731.47 °/s²|270.00|0.7500"}));
        QCOMPARE(textOf(shown.positions(), rowStarting(shown.positions(), "least transmission angle"), Angle),
                 QString("90.00"));
    }

    void aRockerHasLimitsInsteadOfStrokeTimes()
    {
        const Shown shown(lengths(20.0, 40.0, 25.0));
        QCOMPARE(Shown::rowsOf(shown.positions()),
                 QStringList({"outer dead centre|54.5436 mm|24.62|0.0684", "crank from|13.2288 mm|311.41|0.8650",
                              "crank to|-13.2288 mm|228.59|0.6350", "stroke|67.7723 mm||–"}));
        const Shown twoArcs(lengths(20.0, 10.0, 5.0));
        QCOMPARE(rowStarting(twoArcs.positions(), "inner dead centre"), 1);
        QCOMPARE(rowCountOf(twoArcs.peaks()), 4);
    }

    void thereIsAPoseAtEveryInstantThatARowLeadsTo()
    {
        for (int i = 0; i < 50; ++i) {
            const Parameters parameters = lengths(20.0 + 0.37 * i, 30.0 + 0.11 * i, (i % 2 == 0 ? 1.0 : -1.0) * 15.3);
            const Shown shown(parameters);
            const ClosedForm motion{Mechanism(parameters)};
            for (const QTableView *table : {shown.positions(), shown.peaks()}) {
                for (int row = 0; row < rowCountOf(table); ++row) {
                    const QVariant instant = table->model()->index(row, Instant).data(Qt::UserRole);
                    const Status status =
                        instant.isValid() ? motion.motionAt(instant.toDouble()).status : Status::Solved;
                    QVERIFY2(status == Status::Solved || status == Status::Singular,
                             qPrintable(textOf(table, row, Name)));
                }
            }
        }
    }

    void nothingMovesWhereNothingCan()
    {
        Parameters parameters;
        parameters.omega2 = 0.0;
        const Shown still(parameters);
        QCOMPARE(Shown::rowsOf(still.peaks()),
                 QStringList({"slider speed|0 mm/s|crank at rest|–", "slider acceleration|0 mm/s²|crank at rest|–",
                              "coupler speed|0 °/s|crank at rest|–", "coupler acceleration|0 °/s²|crank at rest|–"}));
        QCOMPARE(textOf(still.positions(), 0, Instant), QString("–"));
        QCOMPARE(textOf(still.positions(), rowStarting(still.positions(), "forward stroke"), Angle), QString());
        parameters.theta20 = 1.5 * std::numbers::pi; // at rest where the coupler is steepest
        const Shown there(parameters);
        QCOMPARE(textOf(there.positions(), rowStarting(there.positions(), "least transmission angle"), Instant),
                 QString("0.0000"));

        const Shown locked(lengths(20.0, 5.0, 25.0));
        QCOMPARE(Shown::rowsOf(locked.positions()), QStringList({"only pose|0 mm|90.00|0.2500"}));
        QVERIFY(!locked.peaks()->isVisible());

        Shown impossible(lengths(20.0, 4.0, 25.0));
        QVERIFY(!impossible.positions()->isVisible());
        QVERIFY(!impossible.peaks()->isVisible());
        impossible.panel.setResult(resultOf(Parameters()));
        QVERIFY(impossible.positions()->isVisible());
        QVERIFY(impossible.peaks()->isVisible());
    }

    void waitsUntilItIsOnShow()
    {
        LimitsPanel panel;
        panel.setResult(resultOf(lengths(20.0, 40.0, 25.0)));
        panel.setResult(resultOf(Parameters()));
        QCOMPARE(rowCountOf(child<QTableView>(panel, "peakTable")), 0);
        panel.show();
        QVERIFY(rowCountOf(child<QTableView>(panel, "peakTable")) > 0);
        panel.hide();
        panel.setResult(resultOf(lengths(20.0, 40.0, 25.0)));
        QVERIFY(child<QLabel>(panel, "mobilityLabel")->text().contains("turns round"));
        panel.show();
        QVERIFY(child<QLabel>(panel, "mobilityLabel")->text().contains("rocks"));
    }

    void fitsIntoTheTab_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<bool>("scrolls");
        QTest::newRow("1400 px") << 955 << false;
        QTest::newRow("1024 px") << 578 << true;
    }
    void fitsIntoTheTab()
    {
        QFETCH(int, width);
        QFETCH(bool, scrolls);
        LimitsPanel panel;
        panel.resize(width, 200);
        panel.setResult(resultOf(Parameters()));
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QCOMPARE(panel.width(), width);
        const auto *scroll = panel.findChild<QScrollArea *>();
        QCOMPARE(scroll->verticalScrollBar()->maximum() > 0, scrolls);
        QCOMPARE(scroll->horizontalScrollBar()->maximum(), 0);
        for (const QString name : {"positionTable", "peakTable"}) {
            const auto *table = child<QTableView>(panel, name);
            const QModelIndex last = table->model()->index(rowCountOf(table) - 1, Name);
            QVERIFY(table->visualRect(last).bottom() < table->viewport()->height());
            for (int row = 0; row < rowCountOf(table); ++row) {
                for (int column = 0; column < 4; ++column) {
                    const QRect cell = table->visualRect(table->model()->index(row, column));
                    const QString text = textOf(table, row, column);
                    if (table->columnSpan(row, column) == 1 || column == Angle) {
                        QVERIFY2(table->fontMetrics().horizontalAdvance(text) <= cell.width() - 8, qPrintable(text));
                    }
                }
            }
        }
    }

    void theCurrentRowIsInSight()
    {
        Shown shown{Parameters()};
        shown.panel.resize(578, 200);
        QVERIFY(QTest::qWaitForWindowExposed(&shown.panel));
        QTableView *table = shown.peaks();
        const int last = rowCountOf(table) - 1;
        const auto inSight = [&] {
            const QPoint centre = table->visualRect(table->model()->index(last, Value)).center();
            return table->viewport()->visibleRegion().contains(centre);
        };
        QVERIFY(!inSight());
        table->setFocus();
        for (int row = 0; row <= last; ++row) {
            QTest::keyClick(table, Qt::Key_Down);
        }
        QCOMPARE(table->currentIndex().row(), last);
        QVERIFY(inSight());
    }

    void everythingHasANameForThoseWhoCannotSee()
    {
        const Shown shown{Parameters()};
        QVERIFY(!shown.panel.accessibleName().isEmpty());
        for (const QTableView *table : {shown.positions(), shown.peaks()}) {
            QVERIFY(!table->accessibleName().isEmpty());
            for (int row = 0; row < rowCountOf(table); ++row) {
                QVERIFY(!table->model()->index(row, Name).data(Qt::AccessibleTextRole).toString().isEmpty());
            }
        }
    }

    void copiesAndExportsBothTables()
    {
        const Parameters parameters = lengths(20.0, 60.0, 25.0);
        Shown shown{parameters};
        QSignalSpy copied(&shown.panel, &LimitsPanel::rowsCopied);
        QTest::mouseClick(child<QToolButton>(shown.panel, "copyLimitsButton"), Qt::LeftButton);
        const QString text = QApplication::clipboard()->text();
        QCOMPARE(copied.value(0).value(0).toInt(), rowCountOf(shown.positions()) + rowCountOf(shown.peaks()));
        const QStringList lines = text.trimmed().split('\n');
        QCOMPARE(lines.size(), 1 + copied[0][0].toInt());
        QCOMPARE(lines[0], QString("limit,value,theta2 [°],time [s]"));
        // Crank and coupler in one line: what Pythagoras leaves of c.
        const double stroke = std::sqrt(80.0 * 80.0 - 625.0) - std::sqrt(40.0 * 40.0 - 625.0);
        const QStringList rows = lines.filter(QRegularExpression("^stroke \\[mm\\],"));
        QCOMPARE(rows.size(), 1);
        QVERIFY(std::abs(rows[0].split(',')[1].toDouble() / stroke - 1.0) < 1e-12);
        QVERIFY(lines.last().startsWith("coupler acceleration [°/s²],"));

        QTemporaryDir folder;
        const QString path = folder.filePath("limits.csv");
        QCOMPARE(shown.panel.exportCsv(path), std::nullopt);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), text);
        QVERIFY(shown.panel.exportCsv(folder.filePath("none/limits.csv")).value_or("").contains("cannot be written"));

        shown.panel.hide(); // what it has not shown yet is exported all the same
        shown.panel.setResult(resultOf(lengths(20.0, 65.0, 25.0)));
        QCOMPARE(shown.panel.exportCsv(path), std::nullopt);
        QFile other(path);
        QVERIFY(other.open(QIODevice::ReadOnly));
        QVERIFY(QString::fromUtf8(other.readAll()) != text);
    }

    /// A drag is to be cheap: nothing is laid out or made anew, and no cell told of but those whose text changes.
    void onlyWhatChangesIsToldWhileDragged()
    {
        Shown shown{Parameters()};
        QVERIFY(QTest::qWaitForWindowExposed(&shown.panel));
        int changes = 0;
        int resets = 0;
        for (const QTableView *table : {shown.positions(), shown.peaks()}) {
            connect(table->model(), &QAbstractItemModel::dataChanged, this,
                    [&changes](const QModelIndex &first, const QModelIndex &last) {
                        changes += (last.row() - first.row() + 1) * (last.column() - first.column() + 1);
                    });
            connect(table->model(), &QAbstractItemModel::modelReset, this, [&resets] { ++resets; });
        }
        const auto texts = [&shown] {
            QStringList cells;
            for (const QTableView *table : {shown.positions(), shown.peaks()}) {
                for (int row = 0; row < rowCountOf(table); ++row) {
                    for (int column = 0; column < 4; ++column) {
                        cells << textOf(table, row, column);
                    }
                }
            }
            return cells;
        };
        for (int i = 0; i < 40; ++i) {
            const QStringList before = texts();
            changes = 0;
            shown.panel.setResult(resultOf(lengths(20.0, 65.0 + 0.5 * (i % 20), 25.0)));
            const QStringList after = texts();
            QCOMPARE(after.size(), before.size());
            int different = 0;
            for (qsizetype k = 0; k < after.size(); ++k) {
                different += after[k] == before[k] ? 0 : 1;
            }
            QCOMPARE(changes, different);
        }
        QVERIFY(changes > 0);
        QCOMPARE(resets, 0);
    }
};

QTEST_MAIN(TestLimitsPanel)
#include "tst_limits_panel.moc"
