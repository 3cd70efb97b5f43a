// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_figure.h"
#include "ui/study/study_panel.h"
#include "ui/words/theme.h"

#include "tests/support/study_of_a_turn.h"
#include "tests/support/waiting.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
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
    void exportsThePictureAndTheNumbers();
    void refusesToExportNothing();
    void placesPointsByTimeAndError();
    void drawsAtAnySize_data();
    void drawsAtAnySize();
    void namesItsParts();
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
    QVERIFY(part<QLabel>(panel, "studySummary")->text().contains("nothing silently wrong"));
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
    const auto *summary = part<QLabel>(panel, "studySummary");
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
    QVERIFY(contentOf(folder.filePath("x.svg")).contains("closed form"));
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

QTEST_MAIN(tst_study_panel)
#include "tst_study_panel.moc"
