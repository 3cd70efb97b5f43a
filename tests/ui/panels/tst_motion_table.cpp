// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"
#include "tests/support/accelerating_motion.h"
#include "tests/support/suite.h"
#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"
#include "ui/document/session.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/text/notation.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/scrollable.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <cmath>

using namespace slidercrank;

namespace tst_motion_table
{

struct ShownTable {
    Session session;
    MotionTablePanel panel{&session};

    ShownTable()
    {
        QObject::connect(&panel, &MotionTablePanel::timeRequested, &session, &Session::setTime);
        panel.resize(1200, 400);
        panel.show();
        settle(panel);
    }

    void type(const char *box, const QString &text) const { typeNumber(child<NumberBox>(panel, box), text); }
    void choose(const char *name) const
    {
        auto *quantity = child<QComboBox>(panel, "findQuantity");
        quantity->setCurrentIndex(quantity->findData(name));
        emit quantity->activated(quantity->currentIndex());
    }
    void click(const char *button) const { child<QToolButton>(panel, button)->click(); }

    /// Returns the texts of a row of a table.
    QStringList rowOf(const char *table, int row) const
    {
        const QAbstractItemModel *model = child<NumberTable>(panel, table)->model();
        QStringList texts;
        for (int column = 0; column < model->columnCount(); ++column) {
            texts << model->index(row, column).data().toString();
        }
        return texts;
    }
};

std::vector<int> widthsOf(const NumberTable &table)
{
    std::vector<int> widths;
    for (int column = 0; column < table.model()->columnCount(); ++column) {
        widths.push_back(table.columnWidth(column));
    }
    return widths;
}

/// Restores the notation at the end of a test.
struct NotationForTest {
    explicit NotationForTest(const Notation &chosen) { setNotation(chosen); }
    ~NotationForTest() { setNotation({}); }
};

class TestMotionTable : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanup()
    {
        QLocale::setDefault(QLocale::c());
        setNotation({});
    }

    /// Row g of Norton's tables, in the textbook's notation and in its units, against 115 digits.
    void showsTheTextbooksValuesInItsNotation()
    {
        for (const AngleUnit unit : {AngleUnit::Degree, AngleUnit::Radian, AngleUnit::DegreeAndRadianPerSecond}) {
            showsTheTextbooksValuesIn(unit);
        }
    }

    void hasARowEvery15DegreesOrForTimeSteps()
    {
        MotionTableSettings settings;
        settings.columns = usualTableChannels();
        const std::vector<TablePosition> positions = tablePositions(settings, Mechanism(), {});
        QCOMPARE(positions.size(), std::size_t(25));
        QVERIFY(std::abs(positions[4].theta2 - std::numbers::pi / 3.0) < 1e-15);
        QVERIFY(std::abs(*positions[4].time - 1.0 / 6.0) < 1e-15);
        QVERIFY(!tablePositions(settings, Mechanism(), {0.0, 0.25, 10}).back().time.has_value() ||
                *tablePositions(settings, Mechanism(), {0.0, 0.25, 10}).back().time == 0.0);
        settings.step = TableStep::Time;
        settings.timeStep = 0.1;
        QCOMPARE(tablePositions(settings, Mechanism(), {}).size(), std::size_t(11));
        settings.timeStep = 1e-9;
        QCOMPARE(tablePositions(settings, Mechanism(), {}).size(), std::size_t(kMaxTableRows));
    }

    /// A former defect: the last row of a revolution, 360°, had t = 0 as the first one.
    void theLastRowEndsTheRevolution()
    {
        MotionTableSettings settings;
        const auto lastTime = [&settings](const Parameters &parameters, const Sampling &sampling) {
            return tablePositions(settings, Mechanism(parameters), sampling).back().time.value_or(-1.0);
        };
        constexpr double kTurn = 2.0 * std::numbers::pi;
        QVERIFY(std::abs(lastTime({}, {}) - 1.0) < 1e-12);
        QVERIFY(lastTime({}, {}) <= 1.0); // the end of the time range
        QVERIFY(std::abs(lastTime({.omega2 = 2.0 * kTurn}, {}) - 0.5) < 1e-12);
        QVERIFY(std::abs(lastTime({.theta20 = kTurn / 12.0}, {}) - 11.0 / 12.0) < 1e-12); // begins at 30°
        QVERIFY(std::abs(lastTime({.omega2 = -kTurn}, {})) < 1e-12);                      // ends at 0°
        QVERIFY(std::abs(lastTime({}, {.start = 3.0, .duration = 2.0}) - 4.0) < 1e-9);
        settings.angleStep = 360.0;
        QVERIFY(std::abs(lastTime({}, {}) - 1.0) < 1e-12);
        settings.angleStep = 7.0; // the last row is 357°
        QVERIFY(std::abs(lastTime({}, {}) - 357.0 / 360.0) < 1e-12);
    }

    /// A former defect: the row that was clicked stayed highlighted when the crank was elsewhere.
    void theClickedRowIsHighlightedWhileTheCrankIsThere()
    {
        ShownTable shown;
        auto *table = child<NumberTable>(shown.panel, "motionTable");
        const auto clickRow = [table](int row, Qt::KeyboardModifiers keys = {}) {
            const QPoint cell = table->visualRect(table->model()->index(row, 1)).center();
            QTest::mouseClick(table->viewport(), Qt::LeftButton, keys, cell);
        };
        const auto selected = [table] { return table->selectionModel()->selectedRows().size(); };
        clickRow(2);
        QCOMPARE(selected(), 1);
        shown.session.setTime(0.5);
        QCOMPARE(selected(), 0);
        clickRow(1);
        clickRow(3, Qt::ControlModifier); // two rows, to be copied
        shown.session.setTime(0.5);
        QCOMPARE(selected(), 2);
    }

    void theListOfQuantitiesShowsSubscripts()
    {
        const NotationForTest chosen({Symbols::Textbook, {}});
        const ShownTable shown;
        shown.choose("R4_x_diff");
        auto *list = child<QComboBox>(shown.panel, "findQuantity");
        TextRecorder recorder(list->size());
        list->render(&recorder);
        QStringList texts;
        for (const auto &[text, box] : recorder.texts) {
            texts << text;
        }
        QCOMPARE(list->currentText(), "v_B");
        QCOMPARE(texts, (QStringList{"v", "B"}));
    }

    /// The drawing and the timeline also show angles from 0° to 360°.
    void theCrankAngleIsWithinARevolution()
    {
        for (const auto &[degrees, shown] : {std::pair{-30.0, 330.0}, {-300.0, 60.0}, {360.0, 360.0}, {4321.0, 1.0}}) {
            const TableRow row = motionTableRow({}, Mechanism(), 0.0, {degrees / kDegreesPerRadian, 0.0});
            QVERIFY(std::abs(*row.cells[1].number - shown) < 1e-11);
        }
    }

    /// A former defect: the table had one of two velocities without a word.
    void aRowWhereVelocitiesJumpSaysSo()
    {
        MotionTableSettings settings;
        settings.columns = {Channel{R4x, Order::Position}, Channel{R4x, Order::Velocity},
                            Channel{R4x, Order::Acceleration}};
        for (const double degrees : {255.0, 270.0}) {
            const TableRow row = motionTableRow(settings, Mechanism({.a = 40.0, .b = 60.0, .c = 20.0}), 0.0,
                                                {degrees / kDegreesPerRadian, 0.0});
            QCOMPARE(row.cells[3].text == "–", degrees == 270.0);
            QCOMPARE(row.cells[4].text == "–", degrees == 270.0);
            QCOMPARE(row.explanation.contains("velocities jump"), degrees == 270.0);
            QVERIFY(row.cells[2].text != "–");
        }
    }

    void showsRoundingNoiseAsZero()
    {
        MotionTableSettings settings;
        settings.columns = {Channel{R4x, Order::Velocity}, DerivedChannel{DerivedQuantity::PinY, Order::Position}};
        const TableRow row = motionTableRow(settings, Mechanism({.c = 0.0}), 0.0, {std::numbers::pi, {}});
        QCOMPARE(row.cells[2].text, QStringLiteral("0"));
        QCOMPARE(row.cells[3].text, QStringLiteral("0"));
        QVERIFY(row.cells[0].text != u"0"); // the crank is never there
        const TableRow impossible = motionTableRow(settings, Mechanism({.b = 40.0}), 0.0, {-1.5, {}});
        QVERIFY(!impossible.cells[2].number);
    }

    void writesDigitsAndSeparatorsAsChosen()
    {
        const std::vector<TableColumn> columns{{"x", {}, "R4_x [mm]"}, {"v", {}, "R4_x_diff [mm/s]"}};
        const std::vector<TableRow> rows{{{{.text = "0.3333", .number = 1.0 / 3.0}, {.text = "—"}}}};
        QCOMPARE(csvText(columns, rows, {}), QByteArray("R4_x [mm],R4_x_diff [mm/s]\n0.333333,\n"));
        QCOMPARE(csvText(columns, rows, {.hasEveryDigit = true}),
                 QByteArray("R4_x [mm],R4_x_diff [mm/s]\n0.3333333333333333,\n"));
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Colombia));
        QCOMPARE(csvText(columns, rows, {.isLocal = true}), QByteArray("R4_x [mm];R4_x_diff [mm/s]\n0,333333;\n"));
        QCOMPARE(csvText(columns, rows, {}), QByteArray("R4_x [mm],R4_x_diff [mm/s]\n0.333333,\n"));
    }

    /// The file says at which joint θ3 is measured, and reads back as the mechanism, also where the time decreases.
    void aTableInTheTextbooksNotationIsReadBack()
    {
        constexpr double kInch = 25.4;
        for (const Symbols symbols : {Symbols::AbsoluteCoordinates, Symbols::Textbook}) {
            const NotationForTest chosen({symbols, {LengthUnit::Inch, AngleUnit::DegreeAndRadianPerSecond}});
            for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                const Mechanism mechanism({2.0 * kInch, 6.0 * kInch, -3.0 * kInch, -12.0, 0.3, branch});
                MotionTableSettings settings;
                settings.columns = {Channel{R4x, Order::Velocity}, Channel{Theta3, Order::Position}};
                std::vector<TableRow> rows;
                for (const TablePosition &place : tablePositions(settings, mechanism, {0.0, 1.0, 100})) {
                    rows.push_back(motionTableRow(settings, mechanism, 0.0, place));
                }
                const QByteArray text = csvText(motionTableColumns(settings), rows, {.hasEveryDigit = true});
                QCOMPARE(text.startsWith("first time [s],theta2 [deg],R4_x_diff [in/s],theta3 at B [deg]\n"),
                         symbols == Symbols::Textbook);
                const FileBytes file{std::string_view(text.data(), static_cast<std::size_t>(text.size()))};
                const std::variant<ReferenceData, ReadError> read = readFiles({&file, 1});
                const auto *data = std::get_if<ReferenceData>(&read);
                QVERIFY(data && data->crank && data->crank->degrees.size() == rows.size());
                const ReferenceSeries *angles = data->find({Theta3, Order::Position});
                const ReferenceSeries *speeds = data->find({R4x, Order::Velocity});
                QVERIFY(angles && speeds);
                for (std::size_t row = 0; row < rows.size(); ++row) {
                    Parameters p = mechanism.parameters();
                    p.theta20 = data->crank->degrees[row] / kDegreesPerRadian;
                    const ExactOutputs exact = exactMotion(p, 0.0);
                    const double angle = kDegreesPerRadian * static_cast<double>(exact.at("theta3"));
                    const double speed = static_cast<double>(exact.at("R4_x_diff"));
                    QVERIFY(std::abs(angles->values[row] - angle) < 1e-9 &&
                            std::abs(speeds->values[row] - speed) < 1e-9);
                }
            }
        }
    }

    /// Otherwise, both tables would show different columns when they are scrolled to the right end.
    void thePresentPositionIsAsWideAsTheRows()
    {
        const ShownTable table;
        QCOMPARE(child<NumberTable>(table.panel, "presentPosition")->viewport()->width(),
                 child<NumberTable>(table.panel, "motionTable")->viewport()->width());
    }

    void showsThePresentPositionAndTheRows()
    {
        ShownTable shown;
        shown.session.setTime(0.25);
        QCOMPARE(shown.rowOf("presentPosition", 0).mid(0, 2), (QStringList{"0.25000", "90.000"}));
        QCOMPARE(shown.rowOf("motionTable", 6).mid(0, 2), (QStringList{"0.25000", "90.000"}));
        QCOMPARE(shown.rowOf("presentPosition", 0), shown.rowOf("motionTable", 6));
        shown.type("tableAlpha2", "5");
        const QString acceleration = shown.rowOf("presentPosition", 0)[7];
        const double exact =
            static_cast<double>(exactMotion({.theta20 = 0.5 * std::numbers::pi}, 5.0).at("R4_x_diff2"));
        QVERIFY(std::abs(QString(acceleration).replace(u'−', '-').toDouble() / exact - 1.0) < 1e-4);
        shown.type("tableStep", "30");
        QCOMPARE(child<NumberTable>(shown.panel, "motionTable")->model()->rowCount(), 13);
        child<QToolButton>(shown.panel, "motionTableCopy")->click();
        QCOMPARE(QApplication::clipboard()->text().count('\n'), qsizetype(14));
    }

    /// A former defect: while the motion was played, the columns of the present position became wider than those of the
    /// table below, whose numbers then stood under other headings.
    void columnsStayAligned()
    {
        ShownTable shown;
        shown.session.setParameters({.a = 40.0, .b = 120.0, .c = 20.0, .omega2 = 628.0});
        const auto *present = child<NumberTable>(shown.panel, "presentPosition");
        const auto *table = child<NumberTable>(shown.panel, "motionTable");
        for (const double time : {0.0, 0.00036, 0.0015, 0.0023, 0.0041}) {
            shown.session.setTime(time);
            settle(shown.panel);
            QCOMPARE(widthsOf(*table), widthsOf(*present));
        }
        shown.session.setTime(0.0);
        shown.session.setParameters({});
        shown.panel.setFont(QFont("DejaVu Sans", 20)); // as in presentation mode
        settle(shown.panel);
        QCOMPARE(widthsOf(*table), widthsOf(*present));
        shown.panel.setFont({});
        settle(shown.panel);
        QCOMPARE(widthsOf(*table), widthsOf(*present));
        QWidget *header = present->horizontalHeader()->viewport();
        const QPoint border(present->columnViewportPosition(3) - 1, header->height() / 2);
        QTest::mouseMove(header, border);
        QTest::mousePress(header, Qt::LeftButton, {}, border);
        QTest::mouseMove(header, border - QPoint(20, 0));
        QTest::mouseRelease(header, Qt::LeftButton, {}, border - QPoint(20, 0));
        QCOMPARE(widthsOf(*table), widthsOf(*present));
    }

    /// A former defect: in a low window, the first line of the judgement was hidden.
    void aLowPanelShowsTheWholeJudgement()
    {
        ShownTable shown;
        const auto *judgement = child<QLabel>(shown.panel, "judgement");
        QAbstractItemModel *values = child<NumberTable>(shown.panel, "presentPosition")->model();
        shown.type("findValue", "100");
        shown.click("findNext");
        values->setData(values->index(1, 2), "22 1/2");
        values->setData(values->index(1, 5), "3.15");
        values->setData(values->index(1, 6), "-4.9");
        QCoreApplication::processEvents();
        QCOMPARE(shown.rowOf("presentPosition", 1)[6], "−4.9"); // as in the row of the exact values
        QScrollArea *area = scrollable(&shown.panel);
        area->resize(430, 190);
        area->show();
        settle(*area);
        QVERIFY(judgement->height() >= judgement->heightForWidth(judgement->width()));
        area->takeWidget();
        delete area;
    }

    /// By a pocket calculator: x = 139.1 mm, v = -233.1 mm/s and ω3 = -60.45 °/s at 60°.
    void judgesTypedValuesByTheirDigits()
    {
        ShownTable shown;
        shown.session.setParameters({.a = 40.0, .b = 120.0, .c = 20.0});
        shown.session.setTime(1.0 / 6.0);
        const auto *judgement = child<QLabel>(shown.panel, "judgement");
        QVERIFY(judgement->isHidden());
        const auto type = [&shown](int column, const char *text) {
            auto *table = child<NumberTable>(shown.panel, "presentPosition");
            table->model()->setData(table->model()->index(1, column), QString::fromUtf8(text));
            settle(shown.panel);
        };
        type(5, "139.1");
        QVERIFY2(judgement->isVisible() && judgement->text().contains("All values are right"),
                 qPrintable(judgement->text()));
        type(6, "233.1");
        QVERIFY2(judgement->text().contains("off by 466 mm/s"), qPrintable(judgement->text()));
        type(3, "60.45"); // the coupler turns the other way, too
        QVERIFY2(judgement->text().contains("ω₂ with the opposite sign"), qPrintable(judgement->text()));
        type(6, "nine");
        QVERIFY2(judgement->text().contains("v⁴: “nine” is not a number"), qPrintable(judgement->text()));
        type(6, "1/2");
        QVERIFY2(judgement->text().contains("v⁴: “1/2” does not show to which digit it is rounded"),
                 qPrintable(judgement->text()));
        type(3, "");
        QVERIFY2(!judgement->text().contains("All values are right"), qPrintable(judgement->text()));
        for (const int column : {5, 6}) {
            type(column, "");
        }
        QVERIFY(judgement->isHidden());
        QCOMPARE(shown.rowOf("presentPosition", 1).mid(1), QStringList(9, QString()));
    }

    /// A former defect: the values stayed when the crank turned, and were judged at a different position.
    void typedValuesBelongToTheirPosition()
    {
        ShownTable shown;
        shown.session.setParameters({.a = 40.0, .b = 120.0, .c = 20.0});
        shown.session.setTime(1.0 / 6.0); // θ2 = 60°
        const auto *judgement = child<QLabel>(shown.panel, "judgement");
        const auto type = [&shown](const char *text) {
            auto *table = child<NumberTable>(shown.panel, "presentPosition");
            table->model()->setData(table->model()->index(1, 5), QString::fromUtf8(text));
            settle(shown.panel);
        };
        const auto typedHere = [&shown] { return shown.rowOf("presentPosition", 1)[5]; };
        type("139.1");
        shown.session.setTime(0.25);
        settle(shown.panel);
        QCOMPARE(typedHere(), QString());
        QVERIFY2(judgement->isVisible() && judgement->text().contains("at θ₂ = 60.00°."),
                 qPrintable(judgement->text()));
        type("17");
        QVERIFY2(judgement->text().contains("off by"), qPrintable(judgement->text()));
        shown.session.setTime(1.0 / 6.0);
        settle(shown.panel);
        QCOMPARE(typedHere(), QString("139.1"));
        QVERIFY2(judgement->text().contains("All values are right"), qPrintable(judgement->text()));
        // A corrected length is judged at the same position.
        shown.session.setParameters({.a = 40.0, .b = 121.0, .c = 20.0});
        settle(shown.panel);
        QCOMPARE(typedHere(), QString("139.1"));
        QVERIFY2(judgement->text().contains("off by"), qPrintable(judgement->text()));
        type("");
        QVERIFY2(judgement->text().contains("at θ₂ = 90.00°."), qPrintable(judgement->text()));
    }

    /// A former defect: the table kept its height in a low panel, and the first line of the sentences was cut off.
    void sentencesAboutTypedValuesAreNotCutOff()
    {
        ShownTable shown;
        shown.panel.setMinimumHeight(1); // as in the tabs of a window
        shown.panel.resize(560, 190);
        auto *table = child<NumberTable>(shown.panel, "presentPosition");
        for (int column = 2; column < 7; ++column) {
            table->model()->setData(table->model()->index(1, column), QString::number(column));
            settle(shown.panel);
        }
        const auto *judgement = child<QLabel>(shown.panel, "judgement");
        QVERIFY(judgement->heightForWidth(judgement->width()) > judgement->fontMetrics().height()); // several lines
        QVERIFY2(judgement->height() >= judgement->heightForWidth(judgement->width()),
                 qPrintable(QString::number(judgement->height())));
        const auto *rows = child<NumberTable>(shown.panel, "motionTable"); // lower than it is by itself
        QVERIFY2(rows->height() < rows->minimumSizeHint().height(), qPrintable(QString::number(rows->height())));
    }

    /// A former defect: neither the key nor the click had an effect on the cell that had just been typed into.
    void aSelectedCellIsErasedByAKeyAndOpenedByAClick()
    {
        for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace}) {
            ShownTable shown;
            auto *table = child<NumberTable>(shown.panel, "presentPosition");
            const QModelIndex cell = table->model()->index(1, 3);
            const auto editors = [table] { return table->viewport()->findChildren<QLineEdit *>().size(); };
            const auto click = [&] {
                QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(cell).center());
            };
            click();
            QCOMPARE(editors(), 1);
            QTest::keyClicks(table->viewport()->findChild<QLineEdit *>(), "33.3");
            QTest::keyClick(table->viewport()->findChild<QLineEdit *>(), Qt::Key_Return);
            settle(shown.panel);
            QCOMPARE(cell.data().toString(), "33.3");
            QCOMPARE(editors(), 0);
            click();
            QCOMPARE(editors(), 1);
            QTest::keyClick(table->viewport()->findChild<QLineEdit *>(), Qt::Key_Escape);
            settle(shown.panel);
            QTest::keyClick(table, key);
            settle(shown.panel);
            QCOMPARE(cell.data().toString(), QString());
            QVERIFY(child<QLabel>(shown.panel, "judgement")->isHidden());
            table->setCurrentIndex(table->model()->index(0, 3));
            QTest::keyClick(table, key);
            QVERIFY(!table->model()->index(0, 3).data().toString().isEmpty());
        }
    }

    /// A former defect: at 764×450 the note was a column of letters, which pushed the table out of sight.
    void theNoteAboutTheSpeedIsAsWideAsThePanel()
    {
        ShownTable shown;
        shown.panel.resize(390, 300);
        shown.session.setAlpha2(30.0);
        settle(shown.panel);
        const auto *note = child<QLabel>(shown.panel, "constantSpeed");
        QVERIFY(note->isVisible());
        QVERIFY2(note->height() < 2 * note->fontMetrics().height(), qPrintable(QString::number(note->height())));
    }

    void aDoubleClickOnMyValueReplacesAllOfIt()
    {
        ShownTable shown;
        auto *table = child<NumberTable>(shown.panel, "presentPosition");
        const QModelIndex cell = table->model()->index(1, 3);
        table->model()->setData(cell, "33.3");
        settle(shown.panel);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(cell).center());
        auto *editor = table->viewport()->findChild<QLineEdit *>();
        QVERIFY(editor);
        QTest::mouseDClick(editor, Qt::LeftButton, {}, QPoint(editor->width() - 8, editor->height() / 2));
        settle(shown.panel);
        QCOMPARE(editor->selectedText(), "33.3");
    }

    void offersTheTextbooksNotation()
    {
        ShownTable shown;
        shown.panel.offerTextbookNotation();
        QSignalSpy chosen(&shown.panel, &MotionTablePanel::symbolsChosen);
        child<QPushButton>(shown.panel, "textbookNotation")->click();
        QCOMPARE(chosen.size(), qsizetype(1));
        QCOMPARE(chosen.first().first().value<Symbols>(), Symbols::Textbook);
        AWAIT(!shown.panel.findChild<QWidget *>("notationOffer"));
    }

    void findsTheNextPositionAndTheCrankSpeed()
    {
        ShownTable shown;
        shown.choose("R4_x");
        shown.type("findValue", "60");
        shown.click("findNext");
        QVERIFY(std::abs(shown.session.pose().motion.R4x - 60.0) < 1e-9);
        const double first = shown.session.time();
        shown.click("findNext");
        QVERIFY(std::abs(shown.session.pose().motion.R4x - 60.0) < 1e-9 && shown.session.time() != first);
        shown.click("findNext"); // continues at the start
        QVERIFY(std::abs(shown.session.time() - first) < 1e-9);
        QTest::keyClick(child<NumberBox>(shown.panel, "findValue"), Qt::Key_Return); // as the button
        QVERIFY(std::abs(shown.session.pose().motion.R4x - 60.0) < 1e-9 && shown.session.time() != first);
        shown.type("findValue", "90");
        shown.click("findNext");
        // sqrt((20 + 65)² - 25²) = 81.2404 and sqrt((65 - 20)² - 25²) = 37.4166, both rounded inwards
        QCOMPARE(child<QLabel>(shown.panel, "findAnswer")->text(),
                 QString("There is no such position: Rₓ⁴ lies between 37.417 mm and 81.24 mm."));

        shown.session.setTime(1.0 / 6.0); // 60°
        shown.choose("R4_x_diff");
        shown.type("findValue", "-8m/s");
        shown.click("findUseAsSpeed");
        QVERIFY(std::abs(shown.session.pose().motion.R4xDot + 8000.0) < 1e-6);
        const auto isAt60Degrees = [&shown] {
            return std::abs(std::remainder(shown.session.pose().motion.theta2 - std::numbers::pi / 3.0,
                                           2.0 * std::numbers::pi)) < 1e-9;
        };
        QVERIFY(isAt60Degrees());
        shown.session.undoStack().undo(); // a former defect: this turned the crank
        QVERIFY(isAt60Degrees() && std::abs(shown.session.parameters().omega2 - 2.0 * std::numbers::pi) < 1e-12);
        shown.session.undoStack().redo();
        QVERIFY(isAt60Degrees() && std::abs(shown.session.pose().motion.R4xDot + 8000.0) < 1e-6);
    }

    /// A former defect: accelerations were found for a constant speed only, and the table shows those with α₂.
    void findsTheAccelerationsOfTheTable()
    {
        ShownTable shown;
        shown.choose("R4_x_diff2");
        shown.type("findValue", "100");
        for (const double alpha2 : {0.0, 5.0, -5.0}) {
            shown.session.setAlpha2(alpha2);
            shown.click("findNext");
            const Motion motion = shown.session.pose().motion;
            const double omega2 = shown.session.parameters().omega2;
            QVERIFY(std::abs(motion.R4xDDot + motion.R4xDot / omega2 * alpha2 - 100.0) < 1e-6);
        }
    }

    /// A former defect: a crank that stands still was turned to the first of the positions only.
    void turnsARestingCrankToEveryPosition()
    {
        ShownTable shown;
        shown.session.setParameter(Parameter::Omega2, 0.0);
        shown.choose("R4_x");
        shown.type("findValue", "60");
        std::vector<double> angles;
        for (int i = 0; i < 3; ++i) {
            shown.click("findNext");
            QVERIFY(std::abs(shown.session.pose().motion.R4x - 60.0) < 1e-9);
            angles.push_back(shown.session.parameters().theta20);
        }
        QVERIFY(angles[1] != angles[0] && angles[2] == angles[0]);
    }

    /// A former defect: in the textbook's notation, -170° was no position, although 190° was one.
    void findsAnAngleThatIsOffByWholeTurns()
    {
        const NotationForTest textbook({.symbols = Symbols::Textbook});
        ShownTable shown;
        shown.choose("theta3");
        for (const char *angle : {"190", "-170", "550"}) {
            shown.session.setTime(0.0);
            shown.type("findValue", angle);
            shown.click("findNext");
            QVERIFY2(std::abs(shown.session.pose().motion.theta3 * kDegreesPerRadian - 10.0) < 1e-9, angle);
        }
        shown.type("findValue", "10"); // at A
        shown.click("findNext");
        QVERIFY(child<QLabel>(shown.panel, "findAnswer")->text().contains("measured at B"));
        shown.type("findValue", "100");
        shown.click("findNext");
        // asin((25 ± 20)/65) = 43.8131° and 4.41171°, at B 180° more
        QCOMPARE(child<QLabel>(shown.panel, "findAnswer")->text(),
                 QString("There is no such position: θ₃ lies between 184.42° and 223.81°."));
        shown.choose("R4_x");
        shown.type("findValue", "90");
        shown.click("findNext");
        QVERIFY(child<QLabel>(shown.panel, "findAnswer")->text().contains("x<sub>B</sub> lies between 37.417 mm"));
    }

private:
    void showsTheTextbooksValuesIn(AngleUnit unit)
    {
        const NotationForTest chosen({Symbols::Textbook, {LengthUnit::Inch, unit}});
        constexpr double kInch = 25.4;
        constexpr double kAlpha2 = 18.0;
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            const Parameters p{7.0 * kInch, 25.0 * kInch, 10.0 * kInch, 100.0, 330.0 / kDegreesPerRadian, branch};
            MotionTableSettings settings;
            settings.columns = usualTableChannels();
            const TableRow row = motionTableRow(settings, Mechanism(p), kAlpha2, {p.theta20, 0.0});
            const ExactOutputs exact = exactMotion(p, kAlpha2);
            for (std::size_t i = 0; i < settings.columns.size(); ++i) {
                const OutputChannel &channel = settings.columns[i];
                const bool isAngle = isAngular(measureOf(channel));
                double expected = static_cast<double>(exact.at(nameOf(channel))) / (isAngle ? 1.0 : kInch);
                if (channel == OutputChannel(Channel{Theta3, Order::Position})) { // measured at B
                    expected += branch == Branch::Open ? std::numbers::pi : -std::numbers::pi;
                }
                constexpr double kLengths = 42.0; // in, a + b + c
                double size = (isAngle ? 1.0 : kLengths) * std::pow(p.omega2, static_cast<int>(orderOf(channel)));
                const bool isRate = orderOf(channel) != Order::Position;
                if (isAngle && unit != AngleUnit::Radian && !(isRate && unit != AngleUnit::Degree)) {
                    expected *= kDegreesPerRadian;
                    size *= kDegreesPerRadian;
                }
                QVERIFY2(std::abs(*row.cells[i + 2].number - expected) <= 1e-12 * size,
                         std::string(nameOf(channel)).c_str());
            }
            const std::vector<TableColumn> columns = motionTableColumns(settings);
            QCOMPARE(columns[2].title, QString(unit == AngleUnit::Radian ? "θ₃ [rad]" : "θ₃ [°]"));
            QCOMPARE(columns[3].title, QString(unit == AngleUnit::Degree ? "ω₃ [°/s]" : "ω₃ [rad/s]"));
            QCOMPARE(columns[5].title, QStringLiteral("x_B [in]"));
            QCOMPARE(columns[7].csvName, QStringLiteral("R4_x_diff2 [in/s^2]"));
        }
    }
};

const Suite<TestMotionTable> suite("tst_motion_table");

} // namespace tst_motion_table

#include "tst_motion_table.moc"
