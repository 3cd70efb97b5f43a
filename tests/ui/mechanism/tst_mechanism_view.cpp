// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "ui/document/session.h"
#include "ui/mechanism/mechanism_labels.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/text/theme.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPicture>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

using namespace slidercrank;

namespace
{

/// A view in its place: it shows the session, and what it asks for is done.
struct Bench {
    Session session;
    MechanismView view;

    explicit Bench(const Parameters &parameters = {})
    {
        QObject::connect(&session, &Session::resultChanged, &view, &MechanismView::setResult);
        QObject::connect(&session, &Session::timeChanged, &view, &MechanismView::setPose);
        QObject::connect(&view, &MechanismView::timeRequested, &session, &Session::setTime);
        view.resize(450, 340);
        session.setParameters(parameters);
        view.setResult(session.result());
        session.setTime(0.0);
    }

    QImage picture() { return view.grab().toImage(); }

    QPointF pin() const
    {
        const Pose pose = session.pose();
        return view.toPixels({pose.pinX, pose.pinY});
    }
};

Parameters rocker()
{
    Parameters parameters;
    parameters.b = 40.0;
    return parameters;
}

/// Another mechanism's pose than any that the tests show.
constexpr ReferencePose kGhost{true, 10.0, -12.0, 70.0, 20.0};

constexpr double kPoseOfRocker = 0.2;    // s; θ2 = 72°
constexpr double kNoPoseOfRocker = 0.75; // s; θ2 = 270°, where the coupler would have to be 45 mm long

void drag(MechanismView &view, QPointF from, QPointF to)
{
    QTest::mousePress(&view, Qt::LeftButton, {}, from.toPoint());
    QTest::mouseMove(&view, to.toPoint());
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to.toPoint());
}

int countOf(const QImage &image, const QColor &colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += image.pixelColor(x, y) == colour ? 1 : 0;
        }
    }
    return count;
}

/// Letters of other than the usual height.
void setLetters(MechanismView &view, double ofUsual)
{
    QFont font = view.font();
    font.setPixelSize(static_cast<int>(std::lround(ofUsual * QFontInfo(font).pixelSize())));
    view.setFont(font);
}

/// How thick the link is that lies there across the picture's columns.
int thicknessAt(const QImage &image, QPoint at)
{
    const QColor paper = seriesColours(paletteFor(Theme::Light)).background;
    int top = at.y();
    int bottom = at.y();
    while (top > 0 && image.pixelColor(at.x(), top) != paper) {
        --top;
    }
    while (bottom < image.height() - 1 && image.pixelColor(at.x(), bottom) != paper) {
        ++bottom;
    }
    return bottom - top - 1;
}

/// Between pixels of two pictures, in levels of a colour.
int largestDifference(const QImage &one, const QImage &other)
{
    int largest = 0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x) {
            const QRgb p = one.pixel(x, y);
            const QRgb q = other.pixel(x, y);
            largest = std::max(
                {largest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    }
    return largest;
}

} // namespace

class TestMechanismView : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(paletteFor(Theme::Light));
    }

    void paintsEachPoseDifferently()
    {
        Bench bench;
        const QImage first = bench.picture();
        bench.session.setTime(0.1);
        const QImage second = bench.picture();
        QVERIFY(first != second);
        bench.session.setTime(0.0);
        QCOMPARE(bench.picture(), first);
    }

    void drawsToScale()
    {
        Bench bench;
        const QPointF origin = bench.view.toPixels({0.0, 0.0});
        const QPointF right = bench.view.toPixels({10.0, 0.0});
        const QPointF up = bench.view.toPixels({0.0, 10.0});
        QCOMPARE(right.y(), origin.y());
        QCOMPARE(up.x(), origin.x());
        QVERIFY(right.x() > origin.x());
        QCOMPARE(right.x() - origin.x(), origin.y() - up.y());
    }

    void keepsTheWholeRunInView_data()
    {
        QTest::addColumn<double>("a");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::addColumn<Branch>("branch");
        QTest::newRow("Table 1") << 20.0 << 65.0 << 25.0 << Branch::Open;
        QTest::newRow("crossed") << 20.0 << 65.0 << 25.0 << Branch::Crossed;
        QTest::newRow("offset below") << 20.0 << 65.0 << -25.0 << Branch::Open;
        QTest::newRow("no offset") << 20.0 << 65.0 << 0.0 << Branch::Open;
        QTest::newRow("rocker") << 20.0 << 40.0 << 25.0 << Branch::Open;
        QTest::newRow("two arcs") << 40.0 << 20.0 << 5.0 << Branch::Crossed;
        QTest::newRow("hundredths of a millimetre") << 0.02 << 0.065 << 0.025 << Branch::Open;
        QTest::newRow("kilometres") << 2e6 << 6.5e6 << 2.5e6 << Branch::Open;
    }
    void keepsTheWholeRunInView()
    {
        QFETCH(double, a);
        QFETCH(double, b);
        QFETCH(double, c);
        QFETCH(Branch, branch);
        Parameters parameters;
        parameters.a = a;
        parameters.b = b;
        parameters.c = c;
        parameters.branch = branch;
        Bench bench(parameters);
        const QRectF inside = QRectF(bench.view.rect()).adjusted(8.0, 8.0, -8.0, -8.0);
        const QPointF origin = bench.view.toPixels({0.0, 0.0});
        int poses = 0;
        for (int i = 0; i <= 100; ++i) {
            bench.session.setTime(i / 100.0);
            const Pose pose = bench.session.pose();
            if (pose.exists()) {
                ++poses;
                QVERIFY(inside.contains(bench.view.toPixels({pose.pinX, pose.pinY})));
                QVERIFY(inside.contains(bench.view.toPixels({pose.sliderX, c})));
            }
            QCOMPARE(bench.view.toPixels({0.0, 0.0}), origin); // and does not jump
        }
        QVERIFY(poses > 20);
        const double crank = std::abs(bench.view.toPixels({a, 0.0}).x() - origin.x());
        QVERIFY2(crank > 20.0, qPrintable(QString::number(crank))); // nor is it lost in the view
    }

    void movesInCoarseStepsWhileALengthIsDragged()
    {
        Bench bench;
        Parameters parameters;
        int changes = 0;
        double scale = bench.view.toPixels({1.0, 0.0}).x() - bench.view.toPixels({0.0, 0.0}).x();
        for (int i = 0; i <= 200; ++i) {
            parameters.b = 65.0 + 0.5 * i;
            bench.session.setParameters(parameters);
            const double now = bench.view.toPixels({1.0, 0.0}).x() - bench.view.toPixels({0.0, 0.0}).x();
            changes += std::abs(now - scale) > 1e-9 ? 1 : 0;
            scale = now;
        }
        QVERIFY2(changes >= 1 && changes <= 5, qPrintable(QString::number(changes)));
        // To and fro by a little: it settles.
        changes = 0;
        for (const double wiggle : {1.0, -1.0, 2.0, -2.0, 2.0, -2.0, 0.0}) {
            const QPointF before = bench.view.toPixels({50.0, 10.0});
            parameters.b = 165.0 + wiggle;
            bench.session.setParameters(parameters);
            changes += bench.view.toPixels({50.0, 10.0}) != before ? 1 : 0;
        }
        QVERIFY2(changes <= 1, qPrintable(QString::number(changes)));
    }

    void fitsAnotherMechanismOnceItRests()
    {
        Bench bench;
        auto *delay = bench.view.findChild<QTimer *>(QStringLiteral("refitDelay"));
        QVERIFY(delay);
        const QRectF fitted = bench.view.look().frame.fitted();
        const auto passThrough = [&bench] { // far off and back: the frame follows in coarse steps
            for (const double b : {300.0, 80.0, 65.0}) {
                Parameters parameters;
                parameters.b = b;
                bench.session.setParameters(parameters);
            }
            return bench.view.look().frame.fitted();
        };
        const QRectF left = passThrough();
        QVERIFY(left != fitted);
        AWAIT(bench.view.look().frame.fitted() == fitted);
        QVERIFY(!delay->isActive()); // and stands still

        // Not while something is held, nor while it moves.
        passThrough();
        delay->start(0);
        QTest::mousePress(&bench.view, Qt::LeftButton, {}, bench.view.toPixels({-15.0, -15.0}).toPoint());
        for (int i = 0; i < 20; ++i) {
            QCoreApplication::processEvents();
            QCOMPARE(bench.view.look().frame.fitted(), left);
        }
        QTest::mouseRelease(&bench.view, Qt::LeftButton, {}, bench.view.toPixels({-15.0, -15.0}).toPoint());
        AWAIT(bench.view.look().frame.fitted() == fitted);
        delay->setTimerType(Qt::PreciseTimer);
        delay->setInterval(30'000);
        passThrough();
        const int before = delay->remainingTime();
        QTest::qSleep(5);
        bench.session.setTime(0.1);
        QVERIFY(delay->isActive() && delay->remainingTime() > before - 5);

        // Not what a person zoomed to.
        const QRectF zoom(-10.0, -10.0, 20.0, 20.0);
        bench.view.setZoom(zoom);
        const QPointF there = bench.view.toPixels({5.0, 5.0});
        delay->start(0);
        AWAIT(bench.view.look().frame.fitted() == fitted);
        QCOMPARE(bench.view.toPixels({5.0, 5.0}), there);
    }

    void saysWhyThereIsNoPoseAndRecovers()
    {
        Bench bench(rocker());
        bench.session.setTime(kPoseOfRocker);
        const QImage existing = bench.picture();
        const SeriesColours colours = seriesColours(bench.view.palette());
        QVERIFY(countOf(existing, colours.model) > 100);
        bench.session.setTime(kNoPoseOfRocker);
        const QImage missing = bench.picture();
        QCOMPARE(countOf(missing, colours.model), 0); // the last pose, greyed
        QVERIFY(countOf(missing, colours.warning) > countOf(existing, colours.warning) + 100);
        bench.session.setTime(kPoseOfRocker);
        QCOMPARE(bench.picture(), existing);
    }

    void hasAPictureWhereThereNeverWasAPose()
    {
        Parameters impossible;
        impossible.b = 4.0;
        impossible.c = 30.0;
        Session session;
        session.setParameters(impossible);
        MechanismView view;
        view.resize(450, 340);
        view.setResult(session.result());
        view.setPose(session.pose());
        const QImage picture = view.grab().toImage();
        const SeriesColours colours = seriesColours(view.palette());
        QCOMPARE(countOf(picture, colours.model), 0);
        QVERIFY(countOf(picture, colours.warning) > 100);
    }

    void isEmptyWithoutAResult()
    {
        MechanismView view;
        view.resize(200, 150);
        const QImage picture = view.grab().toImage();
        QCOMPARE(countOf(picture, view.palette().color(QPalette::Base)), picture.width() * picture.height());
    }

    void draggingTheCrankPinScrubs_data()
    {
        QTest::addColumn<double>("omega2");
        QTest::addColumn<double>("duration");
        QTest::addColumn<double>("from");  // s
        QTest::addColumn<double>("angle"); // °, where A is dragged to
        QTest::addColumn<double>("time");  // s
        const double turn = 2.0 * std::numbers::pi;
        QTest::newRow("onwards") << turn << 1.0 << 0.1 << 72.0 << 0.2;
        QTest::newRow("backwards") << turn << 1.0 << 0.3 << 72.0 << 0.2;
        QTest::newRow("back past the start: same angle, a turn later") << turn << 1.0 << 0.05 << -36.0 << 0.9;
        QTest::newRow("in the second turn") << turn << 2.0 << 1.1 << 72.0 << 1.2;
        QTest::newRow("clockwise") << -turn << 1.0 << 0.1 << -72.0 << 0.2;
        QTest::newRow("past the end of a quarter turn") << turn << 0.25 << 0.2 << 120.0 << 0.25;
        QTest::newRow("past the start of a quarter turn") << turn << 0.25 << 0.05 << -30.0 << 0.0;
    }
    void draggingTheCrankPinScrubs()
    {
        QFETCH(double, omega2);
        QFETCH(double, duration);
        QFETCH(double, from);
        QFETCH(double, angle);
        QFETCH(double, time);
        Parameters parameters;
        parameters.omega2 = omega2;
        Bench bench(parameters);
        bench.session.setSampling({0.0, duration, 200});
        bench.session.setTime(from);
        QSignalSpy spy(&bench.view, &MechanismView::timeRequested);
        const double radians = angle / kDegreesPerRadian;
        drag(bench.view, bench.pin(), bench.view.toPixels({30.0 * std::cos(radians), 30.0 * std::sin(radians)}));
        QVERIFY(spy.count() > 0);
        const double requested = spy.last()[0].toDouble();
        QVERIFY2(std::abs(requested - time) < 0.005, qPrintable(QString::number(requested))); // pixels are coarse
        QVERIFY(requested >= 0.0 && requested <= duration);
    }

    void draggingElsewhereDoesNothing()
    {
        Bench bench;
        QSignalSpy spy(&bench.view, &MechanismView::timeRequested);
        drag(bench.view, bench.view.toPixels({-15.0, -15.0}), bench.view.toPixels({0.0, 20.0}));
        QCOMPARE(spy.count(), 0);
    }

    void aCrankThatStandsStillCannotBeDragged()
    {
        Parameters parameters;
        parameters.omega2 = 0.0;
        Bench bench(parameters);
        QSignalSpy spy(&bench.view, &MechanismView::timeRequested);
        drag(bench.view, bench.pin(), bench.view.toPixels({0.0, 20.0}));
        QCOMPARE(spy.count(), 0);
    }

    void followsThePalette()
    {
        Bench bench;
        bench.view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
        const QImage light = bench.picture();
        bench.view.setPalette(paletteFor(Theme::Dark));
        const QImage dark = bench.picture();
        QVERIFY(dark != light);
        QCOMPARE(dark.pixelColor(2, 2), paletteFor(Theme::Dark).color(QPalette::Base));
    }

    void exportsVectors()
    {
        Bench bench;
        QPicture recorded;
        QPainter painter(&recorded);
        bench.view.paintMechanism(painter, {900, 600}, paletteFor(Theme::Light));
        painter.end();
        QVERIFY(recorded.size() > 1000);
        QVERIFY2(recorded.size() < 60'000, qPrintable(QString::number(recorded.size()))); // no picture within
        QImage image(900, 600, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter replay(&image);
        replay.drawPicture(0, 0, recorded);
        replay.end();
        QCOMPARE(countOf(image, Qt::magenta), 0);
        QVERIFY(countOf(image, seriesColours(paletteFor(Theme::Light)).model) > 100);
    }

    void linksGrowWithTheLetters()
    {
        Bench bench;
        const auto crank = [&] { return bench.view.toPixels({7.0, 0.0}).toPoint(); };
        const auto turnsByADragFromBelowThePin = [&] {
            const QSignalSpy requested(&bench.view, &MechanismView::timeRequested);
            const QPointF below = bench.pin() + QPointF(0.0, 21.0);
            drag(bench.view, below, below - QPointF(0.0, 60.0));
            bench.session.setTime(0.0);
            bench.view.setZoom({}); // elsewhere it moves the drawing
            return !requested.isEmpty();
        };
        const QPoint at = crank();
        const int usual = thicknessAt(bench.picture(), at);
        QVERIFY(usual >= 8 && usual <= 13);
        QVERIFY(!turnsByADragFromBelowThePin());
        setLetters(bench.view, 2.0);
        QCOMPARE(crank(), at); // and nothing moves
        const int doubled = thicknessAt(bench.picture(), at);
        QVERIFY2(std::abs(doubled - 2 * usual) <= 2, qPrintable(QString::number(doubled)));
        setLetters(bench.view, 0.25);
        QCOMPARE(thicknessAt(bench.picture(), at), usual); // never thinner than usual
        setLetters(bench.view, 8.0);
        QVERIFY(turnsByADragFromBelowThePin()); // what is drawn larger is grasped farther off
    }

    void aPoseRepaintsWhatItLeft_data()
    {
        QTest::addColumn<double>("letters");
        QTest::newRow("usual letters") << 1.0;
        QTest::newRow("large letters") << 1.7;
    }

    void aPoseRepaintsWhatItLeft()
    {
        QFETCH(const double, letters);
        Bench bench;
        setLetters(bench.view, letters);
        if (bench.view.devicePixelRatioF() != 1.0) {
            QSKIP("the offscreen platform's screen has one pixel a point");
        }
        bench.view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
        // The screen, repainted piece by piece, must end as a picture painted at once.
        for (int i = 0; i <= 40; ++i) {
            bench.session.setTime(i / 40.0);
            QCoreApplication::processEvents();
        }
        QCOMPARE(bench.view.screen()->grabWindow(bench.view.winId()).toImage().convertToFormat(QImage::Format_RGB32),
                 bench.picture().convertToFormat(QImage::Format_RGB32));
    }

    void drawsTheReferencesLinkageThinOverTheModels()
    {
        Bench bench;
        const SeriesColours colours = seriesColours(bench.view.palette());
        const QImage without = bench.picture();
        QCOMPARE(countOf(without, colours.reference), 0);
        bench.view.setGhost(kGhost);
        const QImage with = bench.picture();
        QVERIFY(with.pixelColor(bench.view.toPixels({kGhost.pinX, kGhost.pinY}).toPoint()) == colours.reference);
        QVERIFY(with.pixelColor(bench.view.toPixels({kGhost.sliderX, kGhost.sliderY}).toPoint()) == colours.reference);
        QVERIFY(countOf(with, colours.model) > countOf(without, colours.model) / 2); // the model is still the thicker
        bench.view.setGhost({});
        QCOMPARE(bench.picture(), without);
    }

    void widensTheViewToAReferenceThatReachesBeyondIt()
    {
        Bench bench;
        const QRectF beyond(QPointF(-20.0, -20.0), QPointF(120.0, 25.0)); // mm
        const auto isInView = [&bench](QPointF model) {
            return QRectF(bench.view.rect()).contains(bench.view.toPixels(model));
        };
        QVERIFY(!isInView(beyond.bottomRight()));
        bench.view.setGhostReach(beyond);
        QVERIFY(isInView(beyond.topLeft()) && isInView(beyond.bottomRight()));
        QVERIFY(isInView({84.0, 25.0}) && isInView({-20.0, 0.0})); // the model's own
        bench.view.setZoom(QRectF(-10.0, -10.0, 20.0, 20.0));
        bench.view.fit();
        QVERIFY(isInView(beyond.bottomRight()));
    }

    void doesNotShrinkTheModelToNothingForAReferenceInAnotherUnit()
    {
        Bench bench;
        const QPointF before = bench.view.toPixels({20.0, 0.0});
        bench.view.setGhostReach(QRectF(QPointF(-2e4, -2e4), QPointF(8e4, 2.5e4)));
        QCOMPARE(bench.view.toPixels({20.0, 0.0}), before);
        bench.view.setGhostReach(QRectF(QPointF(0.0, 0.0), QPointF(qInf(), 0.0)));
        QCOMPARE(bench.view.toPixels({20.0, 0.0}), before);
        bench.view.setGhostReach(QRectF());
        QCOMPARE(bench.view.toPixels({20.0, 0.0}), before);
    }

    void namesLengthsThatDo_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::addColumn<QString>("words");
        QTest::newRow("full turn") << 40.0 << 25.00001 << QStringLiteral("is at least 45.0001 mm");
        QTest::newRow("any pose") << 40.0 << 100.00001 << QStringLiteral("must be at least 80.0001 mm");
    }

    void namesLengthsThatDo()
    {
        QFETCH(const double, b);
        QFETCH(const double, c);
        QFETCH(const QString, words);
        Parameters parameters;
        parameters.b = b;
        parameters.c = c;
        Bench bench(parameters);
        bench.session.setTime(kNoPoseOfRocker);
        TextRecorder recorder(bench.view.size());
        QPainter painter(&recorder);
        bench.view.paintMechanism(painter, bench.view.size(), bench.view.palette());
        painter.end();
        QStringList lines;
        for (const auto &[text, place] : recorder.texts) {
            lines << text.trimmed();
        }
        QVERIFY2(lines.join(u' ').contains(words), qPrintable(lines.join(u' ')));
    }

    void namesTheReferenceOffItsCoupler()
    {
        Bench bench;
        for (const double pinY : {-12.0, 45.0}) { // below the slider's line, and above it
            ReferencePose ghost = kGhost;
            ghost.pinY = pinY;
            ghost.pinX = ghost.sliderX - 10.0; // steep
            bench.view.setGhost(ghost);
            TextRecorder recorder(bench.view.size());
            QPainter painter(&recorder);
            bench.view.paintMechanism(painter, bench.view.size(), bench.view.palette());
            painter.end();
            const auto word = std::ranges::find(recorder.texts, QStringLiteral("file"), &TextRecorder::Text::first);
            QVERIFY(word != recorder.texts.end());
            const QPointF slider = bench.view.toPixels({ghost.sliderX, ghost.sliderY});
            const QPointF crank = bench.view.toPixels({ghost.pinX, ghost.pinY});
            QVERIFY((word->second.center().y() < slider.y()) == (crank.y() > slider.y()));
        }
        for (const int pixels : {11, 13, 20, 30}) { // whole in every language, also in front of a class
            MechanismCanvas canvas;
            canvas.smallFont.setPixelSize(pixels);
            QVERIFY(ghostWordPlace(canvas, kGhost).width() >=
                    QFontMetricsF(canvas.smallFont).horizontalAdvance(QStringLiteral("conservado")));
        }
    }

    void keepsLabelsOffLinksAndApart_data()
    {
        QTest::addColumn<Parameters>("parameters");
        const auto row = [](const char *name, double a, double b, double c, Branch branch = Branch::Open) {
            Parameters parameters;
            parameters.a = a;
            parameters.b = b;
            parameters.c = c;
            parameters.branch = branch;
            QTest::newRow(name) << parameters;
        };
        row("Table 1", 20.0, 65.0, 25.0);
        row("the reference's", 20.0, 60.0, 25.0);
        row("crossed", 20.0, 60.0, 25.0, Branch::Crossed);
        row("no offset", 20.0, 65.0, 0.0);
        row("offset below", 20.0, 65.0, -25.0);
        row("long coupler", 20.0, 200.0, 10.0);
        row("beside a toggle", 20.0, 45.01, 25.0);
        row("rocker", 20.0, 40.0, 25.0);
    }

    void keepsLabelsOffLinksAndApart()
    {
        QFETCH(const Parameters, parameters);
        Bench bench(parameters);
        bench.view.resize(430, 560); // as in the window
        bench.view.fit();
        MechanismSettings settings;
        settings.names = settings.dimensions = settings.angles = true;
        bench.view.setSettings(settings);
        constexpr int kInstants = 120;
        int labels = 0;
        int overLinks = 0;
        int overEachOther = 0;
        for (int i = 0; i < kInstants; ++i) {
            bench.session.setTime(static_cast<double>(i) / kInstants);
            if (!bench.session.pose().exists()) {
                continue;
            }
            TextRecorder recorder(bench.view.size());
            QPainter painter(&recorder);
            bench.view.paintMechanism(painter, bench.view.size(), bench.view.palette());
            painter.end();
            std::erase_if(recorder.texts, [](const TextRecorder::Text &text) {
                bool isNumber = false;
                QLocale::c().toDouble(text.first, &isNumber);
                return isNumber || text.first.endsWith(QLatin1String("mm")); // the grid's, and the corner's
            });
            const Pose pose = bench.session.pose();
            const QPointF pivot = bench.view.toPixels({0.0, 0.0});
            const QPointF crank = bench.view.toPixels({pose.pinX, pose.pinY});
            const QPointF slider = bench.view.toPixels({pose.sliderX, parameters.c});
            const auto isOver = [](const QRectF &place, QPointF from, QPointF to, double halfWidth) {
                const QRectF wide = place.adjusted(-halfWidth, -halfWidth, halfWidth, halfWidth);
                constexpr int kPieces = 400;
                for (int k = 0; k <= kPieces; ++k) {
                    if (wide.contains(from + (to - from) * k / kPieces)) {
                        return true;
                    }
                }
                return false;
            };
            for (std::size_t k = 0; k < recorder.texts.size(); ++k) {
                const auto &[name, place] = recorder.texts[k];
                ++labels;
                if (isOver(place, pivot, crank, 4.0) || isOver(place, crank, slider, 3.0)) {
                    ++overLinks;
                    qWarning("%s over a link at %d", qPrintable(name), i);
                }
                for (std::size_t other = 0; other < k; ++other) {
                    if (place.intersects(recorder.texts[other].second)) {
                        ++overEachOther;
                        qWarning("%s over %s at %d", qPrintable(name), qPrintable(recorder.texts[other].first), i);
                    }
                }
            }
        }
        constexpr int kLeast = 11 * 60; // O₂, A, B, G₃, a, b, c, two angles, two dead centres
        QVERIFY2(labels >= kLeast, qPrintable(QString::number(labels)));
        QCOMPARE(overLinks, 0);
        QCOMPARE(overEachOther, 0);
    }

    void tellsTheInstantCentreAndTheVelocitiesItExplains_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("time");
        QTest::addColumn<QStringList>("told");
        QTest::addColumn<bool>("isNamed");
        // At θ2 = 0, P is at (R4x, 0): PA = √(b² − c²) = 60 mm, PB = c = 25 mm, ω3 = −a ω2 / PA = −2π/3 rad/s.
        QTest::newRow("beside the drawing") << 65.0 << 0.0
                                            << QStringList{"-2.094 rad/s", "A: 2.094 rad/s · 60.00 mm = 125.7 mm/s",
                                                           "B: 2.094 rad/s · 25.00 mm = 52.36 mm/s"}
                                            << true;
        QTest::newRow("far above it: the way there") << 65.0 << 0.24 << QStringList{"= 125.7 mm/s"} << true;
        QTest::newRow("at infinity") << 65.0 << 0.25 << QStringList{"infinity", "125.7 mm/s"} << false;
        QTest::newRow("no pose: nothing") << 40.0 << 0.75 << QStringList() << false;
    }

    void tellsTheInstantCentreAndTheVelocitiesItExplains()
    {
        QFETCH(const double, b);
        QFETCH(const double, time);
        QFETCH(const QStringList, told);
        QFETCH(const bool, isNamed);
        Parameters parameters;
        parameters.b = b;
        Bench bench(parameters);
        MechanismSettings settings;
        settings.instantCentre = true;
        bench.session.setTime(time);
        for (const bool isOn : {false, true}) {
            settings.instantCentre = isOn;
            bench.view.setSettings(settings);
            TextRecorder recorder(bench.view.size());
            QPainter painter(&recorder);
            bench.view.paintMechanism(painter, bench.view.size(), bench.view.palette());
            painter.end();
            QString all;
            bool isThere = false;
            for (const auto &[text, place] : recorder.texts) {
                all += text;
                isThere = isThere || (text == QLatin1String("P") && QRectF(bench.view.rect()).contains(place));
            }
            for (const QString &words : told) {
                QVERIFY2(all.contains(words) == isOn, qPrintable(all));
            }
            QCOMPARE(isThere, isOn && isNamed);
        }
    }

    void aGhostRepaintsWhatItLeft()
    {
        Bench bench;
        if (bench.view.devicePixelRatioF() != 1.0) {
            QSKIP("the offscreen platform's screen has one pixel a point");
        }
        bench.view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.view));
        // The screen, repainted piece by piece, against a picture painted at once.
        const auto difference = [&bench] {
            QCoreApplication::processEvents();
            return largestDifference(bench.view.screen()->grabWindow(bench.view.winId()).toImage(), bench.picture());
        };
        constexpr int kRasterizer = 8; // levels of 255: lines that are clipped come out a little different
        for (int i = 0; i <= 20; ++i) {
            ReferencePose ghost = kGhost;
            ghost.sliderX -= 2.0 * i;
            ghost.pinY += 1.0 * i;
            bench.view.setGhost(ghost);
            QVERIFY2(difference() <= kRasterizer, qPrintable(QString::number(difference())));
        }
        bench.view.setGhost({});
        QVERIFY2(difference() <= kRasterizer, qPrintable(QString::number(difference())));
    }

    void tellsItsNameAndWhatItShows()
    {
        Bench bench;
        QVERIFY(!bench.view.accessibleName().isEmpty());
        QVERIFY(bench.view.accessibleDescription().contains("65"));
    }
};

QTEST_MAIN(TestMechanismView)
#include "tst_mechanism_view.moc"
