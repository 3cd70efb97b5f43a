// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/study_figure.h"
#include "ui/panels/study_panel.h"
#include "ui/text/study_text.h"
#include "ui/text/theme.h"
#include "ui/widgets/number_table.h"

#include "tests/support/study_of_a_turn.h"
#include "tests/support/waiting.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QImage>
#include <QJsonDocument>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>

#include <cmath>
#include <limits>

using namespace slidercrank;

namespace
{

template <class Widget>
Widget *part(const StudyPanel &panel, const char *name)
{
    return panel.findChild<Widget *>(QLatin1String(name));
}

void runOnce(StudyPanel &panel)
{
    QSignalSpy finished(&panel, &StudyPanel::finished);
    QTest::mouseClick(part<QPushButton>(panel, "runThisButton"), Qt::LeftButton);
    QVERIFY(finished.wait(kPatience));
}

CaseResult smallCase()
{
    CaseResult result;
    const auto add = [&](MethodName method, double time, double error) {
        MethodResult row;
        row.method = method;
        row.nsPerState = time;
        row.maxError = error;
        row.errorBound = 1e-15;
        row.counts[0] = 10;
        row.silentFailures = 0;
        result.methods.push_back(row);
    };
    add({MethodName::Kind::NewtonDense}, 3000.0, 3e-15);
    add({MethodName::Kind::ClosedForm}, 50.0, 5e-16);
    add({MethodName::Kind::ClosedFormBatch}, 5.0, 0.0);
    add({MethodName::Kind::Harmonics, 2}, 40.0, 0.1);
    return result;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_study_panel : public QObject
{
    Q_OBJECT

private slots:
    void showsThePurposeBeforeTheFirstRun();
    void runsBesideTheWindowAndShowsEveryMethod();
    void cancelsAtOnce();
    void mayBeClosedWhileItRuns();
    void anotherPanelGoesOnWithWhatRuns();
    void saysThatTheMechanismHasChanged();
    void pointsAnswerToTheMouse();
    void theTableMarksItsPoint();
    void copiesTheRowsThatAreChosen();
    void exportsThePictureAndTheNumbers();
    void refusesToExportNothing();
    void placesPointsByTimeAndError();
    void drawsAtAnySize_data();
    void drawsAtAnySize();
    void namesItsParts();
    void everyMarkHasItsOwnShape();
    void namesAndOutcomesAreWholeInAUsualWindow();
    void answersInOneSentence_data();
    void answersInOneSentence();
};

void tst_study_panel::showsThePurposeBeforeTheFirstRun()
{
    StudyPanel panel;
    panel.show();
    QCOMPARE(panel.objectName(), QString("studyPanel"));
    QVERIFY(part<QTableView>(panel, "studyTable")->isHidden());
    QVERIFY(part<QPushButton>(panel, "cancelStudyButton")->isHidden());
    QVERIFY(part<QPushButton>(panel, "runThisButton")->isEnabled());
}

void tst_study_panel::runsBesideTheWindowAndShowsEveryMethod()
{
    StudyPanel panel;
    panel.show();
    QSignalSpy finished(&panel, &StudyPanel::finished);
    panel.runThisMechanism();
    QCOMPARE(finished.count(), 0); // it came back at once
    QVERIFY(part<QPushButton>(panel, "cancelStudyButton")->isVisible());
    QVERIFY(!part<QPushButton>(panel, "runHardButton")->isEnabled());
    QVERIFY(finished.wait(kPatience));
    QCOMPARE(part<QProgressBar>(panel, "studyProgress")->value(),
             part<QProgressBar>(panel, "studyProgress")->maximum());
    QVERIFY(part<QPushButton>(panel, "runThisButton")->isEnabled());
    QVERIFY(!part<QPushButton>(panel, "cancelStudyButton")->isVisible());
    const auto *table = part<QTableView>(panel, "studyTable");
    QVERIFY(table->isVisible());
    QCOMPARE(table->model()->rowCount(), 24);
    QVERIFY(part<QLabel>(panel, "studySummary")->text().contains("silently wrong"));
    QVERIFY(part<QLabel>(panel, "studyAnswer")->text().startsWith("Closed form: ")); // of what was measured
}

void tst_study_panel::cancelsAtOnce()
{
    StudyPanel panel;
    panel.show();
    QSignalSpy finished(&panel, &StudyPanel::finished);
    panel.runHardCases();
    QTest::mouseClick(part<QPushButton>(panel, "cancelStudyButton"), Qt::LeftButton);
    QVERIFY(finished.wait(kPatience));
    QVERIFY(part<QProgressBar>(panel, "studyProgress")->value() <
            part<QProgressBar>(panel, "studyProgress")->maximum());
    QVERIFY(part<QPushButton>(panel, "runThisButton")->isEnabled());
}

void tst_study_panel::mayBeClosedWhileItRuns()
{
    auto panel = std::make_unique<StudyPanel>();
    panel->show();
    auto *progress = part<QProgressBar>(*panel, "studyProgress");
    panel->runHardCases();
    AWAIT(progress->value() > 0);
    panel.reset();
    finishAside(); // whatever is still on its way arrives
}

void tst_study_panel::anotherPanelGoesOnWithWhatRuns()
{
    StudyPanel panel;
    QSignalSpy finished(&panel, &StudyPanel::finished);
    {
        StudyPanel before;
        before.runThisMechanism();
        panel.takeOver(before);
    }
    QVERIFY(!part<QPushButton>(panel, "runThisButton")->isEnabled());
    QVERIFY(finished.wait(kPatience));
    QCOMPARE(part<QTableView>(panel, "studyTable")->model()->rowCount(), 24);
}

void tst_study_panel::saysThatTheMechanismHasChanged()
{
    StudyPanel panel;
    panel.show();
    runOnce(panel);
    const auto *summary = part<QLabel>(panel, "studyAnswer");
    QVERIFY(!summary->text().contains("run again"));
    Parameters other;
    other.b = 70.0;
    panel.setParameters(other);
    QVERIFY(summary->text().contains("run again"));
    runOnce(panel);
    QVERIFY(!summary->text().contains("run again"));
}

void tst_study_panel::pointsAnswerToTheMouse()
{
    StudyPanel panel;
    panel.resize(960, 300);
    panel.show();
    panel.setResult(studyOfATurn());
    settle();
    auto *picture = part<QWidget>(panel, "studyPicture");
    QTest::mouseMove(picture, QPoint(1, 1));

    // Every point lies where the bare function says.
    const auto *table = part<QTableView>(panel, "studyTable");
    int batch = -1;
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        if (table->model()->index(row, 0).data().toString() == "closed form, batch") {
            batch = row;
        }
    }
    QVERIFY(batch >= 0);
    bool pointed = false;
    for (int y = 0; y < picture->height() && !pointed; y += 4) {
        for (int x = 0; x < picture->width() && !pointed; x += 4) {
            QMouseEvent move(QEvent::MouseMove, QPointF(x, y), picture->mapToGlobal(QPointF(x, y)), Qt::NoButton,
                             Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(picture, &move);
            pointed = table->currentIndex().row() == batch;
        }
    }
    QVERIFY(pointed);
    QVERIFY(QToolTip::text().contains("ns per state"));
}

void tst_study_panel::theTableMarksItsPoint()
{
    StudyPanel panel;
    panel.resize(960, 300);
    panel.show();
    panel.setResult(studyOfATurn());
    settle();
    auto *picture = part<QWidget>(panel, "studyPicture");
    const QImage before = picture->grab().toImage();
    auto *table = part<QTableView>(panel, "studyTable");
    table->setCurrentIndex(table->model()->index(3, 0));
    QVERIFY(picture->grab().toImage() != before);
}

void tst_study_panel::copiesTheRowsThatAreChosen()
{
    StudyPanel panel;
    auto result = std::make_shared<StudyResult>();
    result->cases.push_back(smallCase());
    panel.setResult(result);
    QSignalSpy copied(&panel, &StudyPanel::rowsCopied);
    auto *table = part<QTableView>(panel, "studyTable");
    table->selectRow(1);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(copied.count(), 1);
    const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 2);
    QCOMPARE(lines[0], QStringLiteral("method,tolerance,time [ns],error,iterations,instants"));
    QVERIFY2(lines[1].contains(QStringLiteral(",,50,5e-16,,")), qPrintable(lines[1]));
}

void tst_study_panel::exportsThePictureAndTheNumbers()
{
    StudyPanel panel;
    panel.show();
    panel.setResult(studyOfATurn());
    QTemporaryDir folder;
    for (const char *name : {"x.png", "x.svg", "x.pdf"}) {
        QCOMPARE(panel.exportPicture(folder.filePath(name)), std::nullopt);
    }
    QCOMPARE(QImage(folder.filePath("x.png")).size(), QSize(1800, 1200));
    const QByteArray drawn = contentOf(folder.filePath("x.svg"));
    for (const char *name : {"Newton dense (report)", "Newton dense, Taylor", "Newton structured",
                             "Newton structured, Taylor", "closed form", "closed form, batch", "differences",
                             "so many harmonics", ">32<", "fastest for its error", "cost of rounded input"}) {
        QVERIFY2(drawn.contains(name), name);
    }
    QCOMPARE(panel.exportNumbers(folder.filePath("x.json")), std::nullopt);
    QVERIFY(QJsonDocument::fromJson(contentOf(folder.filePath("x.json"))).isObject());
    QCOMPARE(panel.exportNumbers(folder.filePath("x.csv")), std::nullopt);
    QVERIFY(contentOf(folder.filePath("x.csv")).startsWith("case,method,"));
    QVERIFY(panel.exportNumbers(folder.filePath("none/x.csv")).has_value());
}

void tst_study_panel::refusesToExportNothing()
{
    const StudyPanel panel;
    QVERIFY(panel.exportPicture("x.png").has_value());
    QVERIFY(panel.exportNumbers("x.csv").has_value());
}

void tst_study_panel::placesPointsByTimeAndError()
{
    const QSize size(400, 300);
    const std::vector<StudyPoint> points = studyPoints(smallCase(), size);
    QCOMPARE(points.size(), std::size_t(4)); // an error of 0 has its place too
    for (const StudyPoint &point : points) {
        QVERIFY(QRectF(QPointF(0, 0), size).contains(point.at));
    }
    QVERIFY(points[0].at.x() > points[1].at.x() && points[1].at.x() > points[3].at.x() &&
            points[3].at.x() > points[2].at.x());
    QVERIFY(points[3].at.y() < points[0].at.y() && points[0].at.y() < points[1].at.y() &&
            points[1].at.y() < points[2].at.y());
}

void tst_study_panel::drawsAtAnySize_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("tiny") << QSize(10, 10);
    QTest::newRow("flat") << QSize(960, 120);
    QTest::newRow("narrow") << QSize(120, 600);
    QTest::newRow("large") << QSize(1400, 900);
}

void tst_study_panel::drawsAtAnySize()
{
    QFETCH(QSize, size);
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        const SeriesColours colours = seriesColours(paletteFor(theme));
        QImage image(size, QImage::Format_RGB32);
        QPainter painter(&image);
        drawStudy(painter, size, smallCase(), colours, 1);
        drawStudy(painter, size, CaseResult(), colours);
        painter.end();
        QCOMPARE(image.pixelColor(0, 0), colours.background);
    }
}

void tst_study_panel::namesItsParts()
{
    StudyPanel panel;
    QVERIFY(!panel.accessibleName().isEmpty());
    for (const char *name : {"studyPicture", "studyTable", "caseBox", "studyProgress"}) {
        QVERIFY2(!part<QWidget>(panel, name)->accessibleName().isEmpty(), name);
    }
}

void tst_study_panel::everyMarkHasItsOwnShape()
{
    SeriesColours black;
    black.model = black.reference = black.error = black.errorOther = Qt::black;
    black.background = Qt::white;
    QList<QImage> marks;
    const std::shared_ptr<const StudyResult> study = studyOfATurn();
    for (const MethodResult &row : study->cases.front().methods) {
        QImage image(13, 13, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        drawMark(painter, {6.5, 6.5}, row, black);
        painter.end();
        if (!marks.contains(image)) {
            for (const QImage &other : std::as_const(marks)) {
                int different = 0;
                for (int i = 0; i < 169; ++i) {
                    different += image.pixel(i % 13, i / 13) != other.pixel(i % 13, i / 13) ? 1 : 0;
                }
                QVERIFY2(different >= 9, qPrintable(titleOf(row)));
            }
            marks.append(image);
        }
    }
    QCOMPARE(marks.size(), 8); // a kind of method each; tolerances and numbers of harmonics share one

    MethodResult stuck = smallCase().methods.front();
    stuck.status = Status::Singular;
    QImage hollow(13, 13, QImage::Format_RGB32);
    hollow.fill(Qt::white);
    QPainter painter(&hollow);
    drawMark(painter, {6.5, 6.5}, stuck, black);
    painter.end();
    QVERIFY(!marks.contains(hollow));
}

void tst_study_panel::namesAndOutcomesAreWholeInAUsualWindow()
{
    StudyPanel panel;
    panel.resize(960, 215); // its room in a window of 1400 x 900
    panel.show();
    panel.setResult(studyOfATurn());
    settle();
    const auto *table = part<NumberTable>(panel, "studyTable");
    const QAbstractItemModel &model = *table->model();
    for (int row = 0; row < model.rowCount(); ++row) {
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex index = model.index(row, column);
            QCOMPARE(table->shownText(index), index.data().toString());
        }
    }
    QVERIFY(table->horizontalHeader()->length() <= table->viewport()->width()); // nothing to scroll sideways
    const auto *picture = part<QWidget>(panel, "studyPicture");
    double rightmost = 0.0;
    const std::shared_ptr<const StudyResult> study = studyOfATurn();
    for (const StudyPoint &point : studyPoints(study->cases.front(), picture->size())) {
        rightmost = std::max(rightmost, point.at.x());
    }
    QVERIFY(rightmost < picture->width() - 120); // where the legend is
}

void tst_study_panel::answersInOneSentence_data()
{
    QTest::addColumn<double>("reportTime");
    QTest::addColumn<double>("reportError"); // NaN: solves nothing
    QTest::addColumn<double>("error");
    QTest::addColumn<int>("reportSolves"); // of 10
    QTest::addColumn<QString>("sentence");
    const double none = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("faster, more exact")
        << 3250.0 << 4e-16 << 1e-16 << 10
        << "Closed form: 65 times as fast as the report's way and 4 times as exact here.";
    QTest::newRow("alike") << 51.0 << 1.02e-16 << 1e-16 << 10
                           << "Closed form: as fast as the report's way and as exact here.";
    QTest::newRow("slower, less exact")
        << 25.0 << 1e-16 << 3e-16 << 10
        << "Closed form: takes 2 times as long as the report's way, but its error is 3 times as large here.";
    QTest::newRow("without an error") << 500.0 << 1e-16 << 0.0 << 10
                                      << "Closed form: 10 times as fast as the report's way and right to the last "
                                         "digit here.";
    QTest::newRow("both without") << 500.0 << 0.0 << 0.0 << 10
                                  << "Closed form: 10 times as fast as the report's way and as exact here.";
    QTest::newRow("only the report without")
        << 500.0 << 0.0 << 1e-16 << 10
        << "Closed form: 10 times as fast as the report's way, which is right to the last digit here.";
    QTest::newRow("only the closed form") << 500.0 << none << 1e-16 << 0
                                          << "Closed form: 10 times as fast as the report's way, which solves no "
                                             "instant here.";
    QTest::newRow("only the report") << 500.0 << 1e-16 << none << 10
                                     << "Closed form: 10 times as fast as the report's way, but it solves no instant "
                                        "here.";
    QTest::newRow("neither") << 500.0 << none << none << 0
                             << "Neither the closed form nor the report's way solves an instant here.";
    QTest::newRow("not of the same instants")
        << 500.0 << 2e-16 << 1e-16 << 7
        << "Closed form: 10 times as fast as the report's way and 2 times as exact here. It solves 10 of 10 instants, "
           "the report's way 7.";
}

void tst_study_panel::answersInOneSentence()
{
    QFETCH(double, reportTime);
    QFETCH(double, reportError);
    QFETCH(double, error);
    QFETCH(int, reportSolves);
    QFETCH(QString, sentence);
    const auto given = [](double value) { return std::isnan(value) ? std::nullopt : std::optional(value); };
    CaseResult which = smallCase();
    MethodResult &report = which.methods[0];
    report.tolerance = 1e-8;
    report.errorBound.reset();
    report.nsPerState = reportTime;
    report.maxError = given(reportError);
    report.counts[0] = static_cast<std::size_t>(reportSolves);
    which.methods[1].maxError = given(error);
    auto result = std::make_shared<StudyResult>();
    result->cases = {which};
    StudyPanel panel;
    panel.show();
    panel.setResult(result);
    QCOMPARE(part<QLabel>(panel, "studyAnswer")->text(), sentence);

    // Errors of 4.6 times each other are alike where the rounding of the data alone causes 1.9e-15; times have a range.
    report.nsPerState = 5000.0;
    report.spread = 1000.0;
    report.maxError = 3.2e-15;
    report.errorBound = 1.9e-15;
    which.methods[1].spread = 0.0;
    which.methods[1].maxError = 7e-16;
    QVERIFY(closedFormSentence(which).startsWith(
        "Closed form: 100 (90 to 110) times as fast as the report's way; both are as "
        "exact as the rounding of the data allows."));

    which.methods.erase(which.methods.begin()); // without the one there is nothing to compare
    result = std::make_shared<StudyResult>();
    result->cases = {which};
    panel.setResult(result);
    QVERIFY(part<QLabel>(panel, "studyAnswer")->isHidden());
}

QTEST_MAIN(tst_study_panel)
#include "tst_study_panel.moc"
