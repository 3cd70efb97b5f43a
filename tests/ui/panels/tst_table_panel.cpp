// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/panels/table_panel.h"
#include "ui/plots/chart.h"
#include "ui/text/record.h"

#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace slidercrank;

namespace tst_table_panel
{

/// A table of two columns; its rows have the times 0.5, 1.5, … s and describe pin A.
PageTable tableOf(const QString &name, const std::vector<double> &numbers)
{
    PageTable table{name, name, {{"name", {}, "name", false}, {"number", {}, "number"}}, {}};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        table.rows.push_back(
            {{{.text = QString("row, %1").arg(i)}, {.text = QString::number(numbers[i], 'g', 3), .number = numbers[i]}},
             0.5 + static_cast<double>(i),
             MechanismPart::PinA});
    }
    return table;
}

struct ShownTable {
    Page page;
    int madePages = 0;
    Session session;
    TablePanel panel{&session, "panel", "Panel", [this] {
                         ++madePages;
                         return page;
                     }};

    explicit ShownTable(const Page &first, const QSize &size = QSize(900, 220))
        : page(first)
    {
        panel.resize(size);
        panel.show();
    }

    void show(const Page &next)
    {
        page = next;
        panel.refresh();
        letTimePass(panel);
    }
    NumberTable *table(const QString &name = "table") const { return child<NumberTable>(panel, name); }
    QModelIndex index(int row) const { return table()->model()->index(row, 1); }
    QString text(int row) const { return index(row).data().toString(); }
};

Page pageWith(const std::vector<double> &numbers)
{
    Page page;
    page.sentence = "15.4 % of 3 mm, 2 of 6.";
    page.tables = {tableOf("table", numbers)};
    return page;
}

class TestTablePanel : public QObject
{
    Q_OBJECT

private slots:
    /// A former defect: in narrow tabs a line ended behind "b =".
    void sentencesAreNotBrokenWithinAnEquation()
    {
        Page page = pageWith({1.0});
        page.sentence = "b = 65 mm ≥ a + |c| = 4.5 in: c = 24.99 ± 0.01 cm.";
        ShownTable shown(page);
        QCOMPARE(child<QLabel>(shown.panel, "panelSentence")->text(),
                 "b\u00a0=\u00a065\u00a0mm\u00a0≥\u00a0a\u00a0+\u00a0|\u2060c|\u2060\u00a0=\u00a04.5\u00a0in: "
                 "c\u00a0=\u00a024.99\u00a0±\u00a00.01\u00a0cm.");
    }

    void showsTheSentenceAndTheTablesOfThePage()
    {
        ShownTable shown(pageWith({1.0, 2.5}));
        QCOMPARE(child<QLabel>(shown.panel, "panelSentence")->text(), "15.4\u00a0% of 3\u00a0mm, 2 of 6.");
        QCOMPARE(shown.text(1), "2.5");
        Page other;
        other.tables = {tableOf("other", {1.0})};
        shown.show(other);
        QVERIFY(!shown.table()->isVisible() && shown.table("other")->isVisible());
        shown.show({});
        QVERIFY(!shown.table("other")->isVisible());
        QVERIFY(!child<QToolButton>(shown.panel, "panelCopy")->isVisible());
    }

    void computesNothingWhileHiddenAndRarelyDuringADrag()
    {
        ShownTable shown(pageWith({1.0}));
        QCOMPARE(shown.madePages, 1);
        for (int i = 0; i < 50; ++i) {
            shown.panel.refresh();
        }
        QCOMPARE(shown.madePages, 1);
        letTimePass(shown.panel);
        QCOMPARE(shown.madePages, 2);
        shown.panel.hide();
        shown.page = pageWith({1.0, 2.0});
        letTimePass(shown.panel);
        shown.panel.refresh();
        letTimePass(shown.panel);
        QCOMPARE(shown.madePages, 2);
        shown.panel.show();
        QCOMPARE(shown.table()->model()->rowCount(), 2);
    }

    /// Only cells whose text changes are reported, so that a drag costs little.
    void repaintsOnlyTheCellsThatChange()
    {
        ShownTable shown(pageWith({1.0, 2.0, 3.0}));
        QSignalSpy changes(shown.table()->model(), &QAbstractItemModel::dataChanged);
        QSignalSpy removals(shown.table()->model(), &QAbstractItemModel::rowsRemoved);
        shown.show(pageWith({1.0, 2.0001, 4.0})); // one number has the same text
        QCOMPARE(changes.count(), 1);
        QCOMPARE(removals.count(), 0);
        shown.show(pageWith({1.0}));
        QCOMPARE(removals.count(), 1);
    }

    void requestsTheTimeAndReportsThePartOfARow()
    {
        ShownTable shown(pageWith({1.0, 2.0}));
        shown.panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&shown.panel));
        QSignalSpy times(&shown.panel, &TablePanel::timeRequested);
        QSignalSpy parts(&shown.panel, &TablePanel::partHovered);
        shown.table()->setFocus();
        shown.table()->setCurrentIndex(shown.index(0));
        QTest::keyClick(shown.table(), Qt::Key_Return);
        QCOMPARE(times.takeFirst()[0].toDouble(), 0.5);
        shown.page.tables[0].rows[0].time.reset();
        shown.show(shown.page);
        QTest::keyClick(shown.table(), Qt::Key_Return);
        QVERIFY(times.isEmpty());
        QTest::mouseMove(shown.table()->viewport(), shown.table()->visualRect(shown.index(1)).center());
        QCOMPARE(parts.takeLast()[0].value<MechanismPart>(), MechanismPart::PinA);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(shown.table(), &leave);
        QCOMPARE(parts.takeLast()[0].value<MechanismPart>(), MechanismPart::None);
    }

    void exportsTheTablesAndTheChart()
    {
        Page page = pageWith({1.0 / 3.0});
        page.chart = PageChart{"chart", "Chart", {{"x", {0.0, 1.0}}, {"y", {0.0, 1.0}}}};
        const ShownTable shown(page);
        QVERIFY(child<Chart>(shown.panel, "chart")->isVisible());
        const QTemporaryDir folder;
        QCOMPARE(shown.panel.exportTo(folder.filePath("x.csv")), std::nullopt);
        QFile file(folder.filePath("x.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), "name,number\n\"row, 0\",0.3333333333333333\n");
        child<QToolButton>(shown.panel, "panelCopy")->click();
        QCOMPARE(QApplication::clipboard()->text(), QString::fromUtf8(csvOf(page)));
        page.tables.push_back(tableOf("second", {2.0}));
        QCOMPARE(csvOf(page).count("name"), 1); // one line of headings
        QCOMPARE(shown.panel.exportTo(folder.filePath("x.png")), std::nullopt);
        QCOMPARE(QImage(folder.filePath("x.png")).size(), QSize(1800, 1200));
        QVERIFY(shown.panel.exportTo(folder.filePath("none/x.csv")).value_or("").contains("cannot be written"));
    }

    /// A former defect: where the columns were wider than the panel, the values were cut off.
    void namesAreShortenedBeforeValuesAreCutOff()
    {
        Page page = pageWith({1234.5});
        page.tables[0].rows[0].cells[0].text = "a name that is as long as that of the longest limit";
        ShownTable shown(page);
        const auto edgeOfValues = [&shown] { return shown.table()->columnWidth(0) + shown.table()->columnWidth(1); };
        shown.panel.resize(900, 300);
        settle(shown.panel);
        const int whole = shown.table()->columnWidth(0);
        QVERIFY(whole > shown.table()->fontMetrics().horizontalAdvance(page.tables[0].rows[0].cells[0].text));
        shown.panel.resize(260, 300);
        settle(shown.panel);
        QVERIFY(shown.table()->columnWidth(0) < whole);
        QVERIFY2(edgeOfValues() <= shown.table()->viewport()->width(), qPrintable(QString::number(edgeOfValues())));
        shown.panel.resize(900, 300);
        settle(shown.panel);
        QCOMPARE(shown.table()->columnWidth(0), whole);
    }

    /// A former defect: in a Spanish window of 1024 px, a few pixels of the last column were cut off.
    void namesAreShortenedALittleBeforeTheLastColumnIsCutOff()
    {
        Page page = pageWith({1234.5});
        page.tables[0].rows[0].cells[0].text = "a name that is as long as that of the longest limit";
        page.tables[0].columns.push_back({"second number", {}, "second"});
        page.tables[0].rows[0].cells.push_back({.text = "12345.678", .number = 12345.678});
        ShownTable shown(page);
        const NumberTable *table = shown.table();
        settle(shown.panel);
        const int names = table->columnWidth(0);
        const int panelMargins = shown.panel.width() - table->viewport()->width();
        const int wholeWidth = names + table->columnWidth(1) + table->columnWidth(2);
        for (const int missing : {1, names / 10, names / 6}) { // px
            shown.panel.resize(panelMargins + wholeWidth - missing, 300);
            settle(shown.panel);
            QCOMPARE(table->columnWidth(0), names - missing);
            QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
        }
        shown.panel.resize(panelMargins + wholeWidth - names / 2, 300); // the first number is more important
        settle(shown.panel);
        QVERIFY(table->horizontalScrollBar()->maximum() > 0);
    }

    /// A former defect: only the table of the motion had the separators of the language.
    void writesTheChosenSeparators()
    {
        const auto restore = qScopeGuard([] {
            setCsvSeparators(CsvSeparators::Standard);
            QLocale::setDefault(QLocale::c());
        });
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        QCOMPARE(csvOf(pageWith({0.25})), "name,number\n\"row, 0\",0.25\n");
        setCsvSeparators(CsvSeparators::OfLanguage);
        QCOMPARE(csvOf(pageWith({0.25})), "name;number\n\"row, 0\";0,25\n");
        QLocale::setDefault(QLocale::c());
        QCOMPARE(csvOf(pageWith({0.25})), "name,number\n\"row, 0\",0.25\n");
    }

    void offersTheRemedyOfAFindingAndDisablesItDuringASearch()
    {
        Page page = pageWith({1.0});
        page.findings = {{"Only a sentence."},
                         {"It is another mechanism.", Remedy::UseFoundMechanism, "Use it", "details"}};
        ShownTable shown(page);
        auto *button = child<QPushButton>(shown.panel, "remedyButton");
        QCOMPARE(button->toolTip(), "details");
        QSignalSpy remedies(&shown.panel, &TablePanel::remedyRequested);
        // The slot replaces the findings while the button is still handling its click.
        connect(&shown.panel, &TablePanel::remedyRequested, &shown.panel, [&shown] { shown.show(pageWith({1.0})); });
        button->click();
        QCOMPARE(remedies.value(0).value(0).value<Finding>().remedy, Remedy::UseFoundMechanism);
        settle();
        QVERIFY(shown.panel.findChildren<QPushButton *>("remedyButton").isEmpty());

        shown.show(page);
        QVERIFY(child<QLabel>(shown.panel, "findingLabel")->isEnabled());
        page.isSearching = true;
        shown.show(page);
        QVERIFY(!child<QLabel>(shown.panel, "findingLabel")->isEnabled());
    }

    void placesSeveralTablesSideBySideOrScrollsThemTogether()
    {
        Page page = pageWith({1.0, 2.0, 3.0, 4.0});
        page.tables.push_back(tableOf("second", {1.0, 2.0, 3.0, 4.0}));
        ShownTable shown(page);
        settle();
        QCOMPARE(shown.table()->y(), shown.table("second")->y());
        shown.panel.resize(210, 140);
        settle();
        NumberTable *second = shown.table("second");
        QVERIFY(second->y() > shown.table()->y());
        const QModelIndex last = second->model()->index(3, 0);
        const auto isVisible = [&] {
            return second->viewport()->visibleRegion().contains(second->visualRect(last).center());
        };
        QVERIFY(!isVisible());
        second->setCurrentIndex(last);
        QVERIFY(isVisible());
    }

    /// A former defect: the table of errors had a scroll bar although all rows were visible.
    void hasNoScrollBarIfAllRowsFit()
    {
        Page page = pageWith({1.0, 2.0, 3.0});
        page.findings = {{"It is another mechanism.", Remedy::UseFoundMechanism, "Use it"}};
        ShownTable shown(page);
        settle(shown.panel);
        for (const auto *scroll : shown.panel.findChildren<QScrollBar *>()) {
            QVERIFY(!scroll->isVisible());
        }
    }
};

const Suite<TestTablePanel> suite("tst_table_panel");

} // namespace tst_table_panel

#include "tst_table_panel.moc"
