// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "ui/document/session.h"
#include "ui/plots/plot_arrangement.h"
#include "ui/text/theme.h"

#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const Result> resultOf(const Parameters &parameters, int steps = 200,
                                       const std::shared_ptr<const Reference> &reference = nullptr)
{
    Session session;
    Sampling sampling;
    sampling.steps = steps;
    session.setSampling(sampling);
    session.setParameters(parameters);
    if (reference) {
        session.setReference(reference);
    }
    return session.result();
}

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

/// The motion of another mechanism, as if a file had been read: all six channels, or only some of them.
std::shared_ptr<Reference> referenceOf(const Parameters &parameters, std::size_t channels = kPlottedChannels.size())
{
    const std::shared_ptr<const Result> result = resultOf(parameters, 50);
    auto reference = std::make_shared<Reference>();
    reference->name = QStringLiteral("simulation.csv");
    reference->paths = {QStringLiteral("/folder/simulation.csv")};
    reference->data.time = result->trajectory.time;
    for (std::size_t i = 0; i < channels; ++i) {
        reference->data.series.push_back({kPlottedChannels[i], result->trajectory[kPlottedChannels[i]], {}});
    }
    return reference;
}

/// A grid on the (offscreen) screen, its plots up to date, and how often each was replotted since.
struct ShownGrid {
    explicit ShownGrid(const std::shared_ptr<const Result> &result, QSize size = QSize(900, 600))
    {
        grid.resize(size);
        grid.setResult(result);
        grid.show();
        settle();
        if (QWidget *focus = QApplication::focusWidget()) {
            focus->clearFocus(); // its frame is no part of a plot
        }
        for (const QString &name : PlotGrid::plotNames()) {
            QObject::connect(plot(name), &QCustomPlot::afterReplot, &grid, [this] { ++replots; });
        }
    }

    QCustomPlot *plot(const QString &name) const { return grid.findChild<QCustomPlot *>(name); }

    PlotOverlay *overlay(const QString &name) const { return plot(name)->findChild<PlotOverlay *>(); }

    QPoint pointAt(const QString &name, double part) const
    {
        const QRect axes = plot(name)->axisRect()->rect();
        return {axes.left() + static_cast<int>(part * axes.width()), axes.center().y()};
    }

    void turnWheel(const QString &name, QPoint at, int notches) const
    {
        QCustomPlot *target = plot(name);
        QWheelEvent event(at, target->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(target, &event);
        settle();
    }

    PlotGrid grid;
    int replots = 0;
};

std::size_t gapsIn(const QCPGraph &graph)
{
    return static_cast<std::size_t>(std::count_if(graph.data()->constBegin(), graph.data()->constEnd(),
                                                  [](const QCPGraphData &point) { return std::isnan(point.value); }));
}

QImage pictureOf(const ShownGrid &shown, const QString &name)
{
    return shown.plot(name)->grab().toImage();
}

} // namespace

class TstPlotGrid : public QObject
{
    Q_OBJECT

private slots:
    void namesItsNinePlots();
    void paintsAllNine();
    void changesThePictureWithTheParameters();
    void mergesSeveralResultsIntoOneReplot();
    void leavesAHiddenGridAlone();
    void movesTheCursorWithoutAReplot();
    void hidesTheCursorOutsideTheRange();
    void leavesAGapWhereTheModelDoesNotExist();
    void saysSoWhereNothingExists();
    void labelsTimeAtTheBottomOnlyWhereThereIsLittleRoom();
    void leavesAGapWhereTheReferenceIsZero();
    void showsTheLargestFinitePercentage();
    void givesSixPlotsAllTheRoomWithoutAReference();
    void drawsTheReferenceOverTheModel();
    void sparesAChannelThatTheFileLacks();
    void drawsARunBackwardsInTime();
    void zoomsAllNineTimeAxesWithTheWheel();
    void zoomsOneValueAxisWithTheWheelOverIt();
    void pansAllNineTimeAxes_data();
    void pansAllNineTimeAxes();
    void zoomsIntoTheBoxOfADrag_data();
    void zoomsIntoTheBoxOfADrag();
    void fitsTheValuesToTheTimeOnShow_data();
    void fitsTheValuesToTheTimeOnShow();
    void showsAllAfterADoubleClick();
    void keepsTheZoomWhileAParameterChanges();
    void requestsTheTimeOfAClick();
    void requestsNoTimeAfterADrag();
    void readsValuesWhereOneHovers();
    void readsAllNineAtOnce();
    void readsBesideTheCurves_data();
    void readsBesideTheCurves();
    void measuresBetweenTwoInstants();
    void showsErrorsInTheChosenMeasure_data();
    void showsErrorsInTheChosenMeasure();
    void labelsTheAxisWithTheCrankAngle();
    void maximizesAPlotByItsTitle();
    void zoomsByKeysAboutTheInstant();
    void offersToExportAPlot();
    void drawsAsManyPointsAsPixelsAtMost();
    void keepsTheAxesInPlaceWhileValuesChange();
    void hasRoomForTheTitleOfShortTimes();
    void alignsThePlotsOfAColumn();
    void keepsReadingsWithinNarrowPlots();
    void framesThePlotWithTheFocusAndNoMore();
    void keepsTheLegendWithinTheFigure();
    void saysInWordsWhatAPlotIsOfWhereThereIsRoom();
    void recoloursWithThePalette();
};

void TstPlotGrid::namesItsNinePlots()
{
    const QStringList expected{"plot_theta3",       "plot_R4_x",       "plot_error_position",
                               "plot_theta3_diff",  "plot_R4_x_diff",  "plot_error_velocity",
                               "plot_theta3_diff2", "plot_R4_x_diff2", "plot_error_acceleration"};
    QCOMPARE(PlotGrid::plotNames(), expected);
    PlotGrid grid;
    for (const QString &name : expected) {
        const auto *plot = grid.findChild<QCustomPlot *>(name);
        QVERIFY(plot);
        QVERIFY(!plot->accessibleName().isEmpty());
    }
}

void TstPlotGrid::paintsAllNine()
{
    const ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const SeriesColours colours = seriesColours(shown.grid.palette());
    for (const QString &name : PlotGrid::plotNames()) {
        const QImage image = pictureOf(shown, name);
        const QColor wanted = name.contains(QStringLiteral("error")) ? colours.errorOther : colours.model;
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                pixels += std::abs(pixel.hue() - wanted.hue()) < 8 && pixel.saturation() > 60 ? 1 : 0;
            }
        }
        QVERIFY2(pixels > 50, qPrintable(name));
    }
}

void TstPlotGrid::changesThePictureWithTheParameters()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    std::vector<QImage> before;
    for (const QString &name : PlotGrid::plotNames()) {
        before.push_back(pictureOf(shown, name));
    }
    shown.grid.setResult(resultOf(withCoupler(64.0)));
    settle();
    for (qsizetype i = 0; i < PlotGrid::plotNames().size(); ++i) {
        const QString name = PlotGrid::plotNames()[i];
        if (!name.contains(QStringLiteral("error"))) {
            QVERIFY2(pictureOf(shown, name) != before[static_cast<std::size_t>(i)], qPrintable(name));
        }
    }
}

void TstPlotGrid::mergesSeveralResultsIntoOneReplot()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    for (const double b : {61.0, 62.0, 63.0}) {
        shown.grid.setResult(resultOf(withCoupler(b)));
    }
    settle();
    QCOMPARE(shown.replots, 6); // without a reference there are no errors
}

void TstPlotGrid::leavesAHiddenGridAlone()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    shown.grid.hide();
    shown.grid.setResult(resultOf(withCoupler(63.0)));
    settle();
    QCOMPARE(shown.replots, 0);
    shown.grid.show();
    settle();
    QCOMPARE(shown.replots, 6);
}

void TstPlotGrid::movesTheCursorWithoutAReplot()
{
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const SeriesColours colours = seriesColours(shown.grid.palette());
    Pose pose;
    for (const double t : {0.25, 0.75}) {
        pose.time = t;
        shown.grid.setPose(pose);
        settle();
        for (const QString &name : PlotGrid::plotNames()) {
            const QCustomPlot *plot = shown.plot(name);
            const int x = static_cast<int>(std::lround(plot->xAxis->coordToPixel(t)));
            const QImage image = pictureOf(shown, name);
            QCOMPARE(image.pixelColor(x, plot->axisRect()->top() + 2), colours.cursor);
            QCOMPARE(image.pixelColor(x, plot->axisRect()->bottom() - 2), colours.cursor);
            QVERIFY(image.pixelColor(x, plot->axisRect()->top() - 2) != colours.cursor);
        }
    }
    QCOMPARE(shown.replots, 0);
}

void TstPlotGrid::hidesTheCursorOutsideTheRange()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    Pose pose;
    pose.time = 1.5;
    shown.grid.setPose(pose);
    const QImage after = pictureOf(shown, QStringLiteral("plot_theta3"));
    pose.time = 0.5;
    shown.grid.setPose(pose);
    QVERIFY(pictureOf(shown, QStringLiteral("plot_theta3")) != after);
    pose.time = -1.0;
    shown.grid.setPose(pose);
    QCOMPARE(pictureOf(shown, QStringLiteral("plot_theta3")), after);
}

void TstPlotGrid::leavesAGapWhereTheModelDoesNotExist()
{
    for (const int steps : {200, 20000}) {
        const ShownGrid shown(resultOf(withCoupler(30.0), steps)); // a rocker
        const QCPGraph *curve = shown.plot(QStringLiteral("plot_theta3"))->graph(0);
        QVERIFY(gapsIn(*curve) >= 1);
        QVERIFY(gapsIn(*curve) < static_cast<std::size_t>(curve->dataCount()));
    }
}

void TstPlotGrid::saysSoWhereNothingExists()
{
    const ShownGrid shown(resultOf(withCoupler(1.0)));
    const QCustomPlot *plot = shown.plot(QStringLiteral("plot_theta3"));
    QVERIFY(!plot->yAxis->tickLabels());
}

/// At 1024×700 with the tabs folded, and as large as it usually is.
void TstPlotGrid::labelsTimeAtTheBottomOnlyWhereThereIsLittleRoom()
{
    for (const bool small : {true, false}) {
        const std::shared_ptr<const Result> result = resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0)));
        const ShownGrid shown(result, small ? QSize(585, 595) : QSize(900, 600));
        QCOMPARE(shown.plot(QStringLiteral("plot_theta3"))->xAxis->tickLabels(), !small);
        QCOMPARE(shown.plot(QStringLiteral("plot_R4_x_diff"))->xAxis->tickLabels(), !small);
        QVERIFY(shown.plot(QStringLiteral("plot_theta3_diff2"))->xAxis->tickLabels());
        QVERIFY(shown.plot(QStringLiteral("plot_R4_x_diff2"))->xAxis->tickLabels());
    }
}

void TstPlotGrid::leavesAGapWhereTheReferenceIsZero()
{
    const std::shared_ptr<Reference> reference = referenceOf(withCoupler(65.0));
    constexpr std::size_t kZero = 20;
    reference->data.series[0].values[kZero] = 0.0; // θ³
    const ShownGrid shown(resultOf(withCoupler(60.0), 200, reference));
    const QCustomPlot *plot = shown.plot(QStringLiteral("plot_error_position"));
    QCOMPARE(gapsIn(*plot->graph(0)), std::size_t(1));
    QCOMPARE(gapsIn(*plot->graph(1)), std::size_t(0));
    const auto gap = plot->graph(0)->data()->findBegin(reference->data.time[kZero], false);
    QVERIFY(std::isnan(gap->value));
    QVERIFY(gap->key <= reference->data.time[kZero + 1]);
    QVERIFY(plot->yAxis->range().upper < 1000.0);

    // The mark stands at the top of the axes.
    const QRect axes = plot->axisRect()->rect();
    const QPoint mark(static_cast<int>(plot->xAxis->coordToPixel(reference->data.time[kZero])), axes.top() + 5);
    const QColor pixel = pictureOf(shown, QStringLiteral("plot_error_position")).pixelColor(mark);
    QVERIFY(std::abs(pixel.hue() - seriesColours(shown.grid.palette()).error.hue()) < 8);

    std::ranges::fill(reference->data.series[0].values, 0.0);
    reference->data.series.resize(1);
    ShownGrid still(resultOf(withCoupler(60.0), 200, reference));
    TextRecorder recorder({600, 300});
    QPainter painter(&recorder);
    still.grid.paintPlot(painter, QStringLiteral("plot_error_position"), {600, 300}, paletteFor(Theme::Light));
    painter.end();
    QVERIFY(std::ranges::any_of(recorder.texts, [](const auto &text) { return text.first.startsWith("infinite"); }));
}

void TstPlotGrid::showsTheLargestFinitePercentage()
{
    const std::shared_ptr<const Result> result = resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0)));
    const ShownGrid shown(result);
    double largest = 0.0;
    for (const ChannelComparison &comparison : result->comparison) {
        if (comparison.channel.order == Order::Velocity) {
            largest = std::max(largest, comparison.maxPercent.value_or(0.0));
        }
    }
    QVERIFY(largest > 1.0);
    const QCPRange range = shown.plot(QStringLiteral("plot_error_velocity"))->yAxis->range();
    QVERIFY(range.upper >= largest);
    QVERIFY(range.upper < 1.3 * largest);
    QCOMPARE(range.lower, 0.0);
}

void TstPlotGrid::givesSixPlotsAllTheRoomWithoutAReference()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    auto *hint = shown.grid.findChild<QLabel *>(QStringLiteral("no_reference_hint"));
    const auto shownPlots = [&shown] {
        QRegion region;
        for (const QString &name : PlotGrid::plotNames()) {
            if (shown.plot(name)->isVisible()) {
                region += shown.plot(name)->geometry();
            }
        }
        return region;
    };
    const int legend = PlotTypography(shown.grid.font()).legendHeight();
    const QRect room = shown.grid.rect().adjusted(0, legend, 0, 0);
    QCOMPARE(shownPlots().rectCount(), 1);
    QVERIFY(shownPlots().boundingRect().height() > room.height() - 3);
    QCOMPARE(shown.plot(QStringLiteral("plot_theta3"))->width(), room.width() / 2);
    QVERIFY(!shown.plot(QStringLiteral("plot_error_position"))->isVisible());
    QVERIFY(hint && hint->isVisible() && hint->geometry().bottom() < legend);
    QVERIFY(hint->width() >= hint->sizeHint().width()); // in one line
    QSignalSpy requested(&shown.grid, &PlotGrid::openReferenceRequested);
    emit hint->linkActivated(QStringLiteral("open"));
    QCOMPARE(requested.count(), 1);

    shown.grid.setResult(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    QVERIFY(!hint->isVisible());
    QVERIFY(shown.plot(QStringLiteral("plot_error_position"))->isVisible());
    QCOMPARE(shown.plot(QStringLiteral("plot_theta3"))->width(), room.width() / 3);
    shown.grid.setResult(resultOf(withCoupler(60.0)));
    QVERIFY(hint->isVisible());
    QVERIFY(!shown.plot(QStringLiteral("plot_error_position"))->isVisible());
}

void TstPlotGrid::drawsTheReferenceOverTheModel()
{
    // They coincide: both colours must be there along the curve.
    const ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(60.0))));
    const SeriesColours colours = seriesColours(shown.grid.palette());
    const QImage image = pictureOf(shown, QStringLiteral("plot_theta3"));
    int model = 0;
    int reference = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (pixel.saturation() > 100) {
                model += std::abs(pixel.hue() - colours.model.hue()) < 15 ? 1 : 0;
                reference += std::abs(pixel.hue() - colours.reference.hue()) < 15 ? 1 : 0;
            }
        }
    }
    QVERIFY(model > 60);
    QVERIFY(reference > 60);
}

void TstPlotGrid::sparesAChannelThatTheFileLacks()
{
    const ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0), 1))); // θ³ alone
    QVERIFY(shown.plot(QStringLiteral("plot_theta3"))->graph(1)->dataCount() > 0);
    QCOMPARE(shown.plot(QStringLiteral("plot_R4_x"))->graph(1)->dataCount(), 0);
    QVERIFY(shown.plot(QStringLiteral("plot_error_position"))->graph(0)->dataCount() > 0);
    QCOMPARE(shown.plot(QStringLiteral("plot_error_position"))->graph(1)->dataCount(), 0);
    QCOMPARE(shown.plot(QStringLiteral("plot_error_velocity"))->graph(0)->dataCount(), 0);
}

void TstPlotGrid::drawsARunBackwardsInTime()
{
    Session session;
    Sampling sampling;
    sampling.start = 1.0;
    sampling.duration = -1.0;
    session.setSampling(sampling);
    const ShownGrid backwards(session.result());
    const ShownGrid forwards(resultOf(Parameters()));
    const auto *one = backwards.plot(QStringLiteral("plot_theta3"))->graph(0);
    const auto *other = forwards.plot(QStringLiteral("plot_theta3"))->graph(0);
    QCOMPARE(one->dataCount(), other->dataCount());
    for (int i = 0; i < one->dataCount(); ++i) {
        QVERIFY(std::abs(one->data()->at(i)->key - other->data()->at(i)->key) < 1e-12);
        QVERIFY(std::abs(one->data()->at(i)->value - other->data()->at(i)->value) < 1e-9);
    }
}

void TstPlotGrid::zoomsAllNineTimeAxesWithTheWheel()
{
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const QString over = QStringLiteral("plot_R4_x_diff");
    const double about = shown.plot(over)->xAxis->pixelToCoord(shown.pointAt(over, 0.5).x());
    shown.turnWheel(over, shown.pointAt(over, 0.5), 3);
    const QCPRange range = shown.plot(over)->xAxis->range();
    QVERIFY(range.size() < 0.7);
    QVERIFY(range.contains(about));
    for (const QString &name : PlotGrid::plotNames()) {
        QCOMPARE(shown.plot(name)->xAxis->range(), range);
    }
    shown.turnWheel(over, shown.pointAt(over, 0.5), -30);
    QCOMPARE(shown.plot(over)->xAxis->range(), QCPRange(0.0, 1.0));
}

void TstPlotGrid::zoomsOneValueAxisWithTheWheelOverIt()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const QCPRange time = shown.plot(QStringLiteral("plot_theta3"))->xAxis->range();
    const QCPRange other = shown.plot(QStringLiteral("plot_theta3_diff"))->yAxis->range();
    const QCPRange before = shown.plot(QStringLiteral("plot_theta3"))->yAxis->range();
    QPoint onAxis = shown.pointAt(QStringLiteral("plot_theta3"), 0.0);
    onAxis.rx() -= 10;
    shown.turnWheel(QStringLiteral("plot_theta3"), onAxis, 2);
    QVERIFY(shown.plot(QStringLiteral("plot_theta3"))->yAxis->range().size() < 0.8 * before.size());
    QCOMPARE(shown.plot(QStringLiteral("plot_theta3"))->xAxis->range(), time);
    QCOMPARE(shown.plot(QStringLiteral("plot_theta3_diff"))->yAxis->range(), other);
}

void TstPlotGrid::pansAllNineTimeAxes_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("Shift and the left button") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
    QTest::newRow("the middle button") << Qt::MiddleButton << Qt::KeyboardModifiers();
}

void TstPlotGrid::pansAllNineTimeAxes()
{
    QFETCH(const Qt::MouseButton, button);
    QFETCH(const Qt::KeyboardModifiers, modifiers);
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const QString over = QStringLiteral("plot_theta3");
    shown.turnWheel(over, shown.pointAt(over, 0.5), 5);
    const QCPRange before = shown.plot(over)->xAxis->range();
    for (const bool isCancelled : {true, false}) {
        QTest::mousePress(shown.plot(over), button, modifiers, shown.pointAt(over, 0.6));
        QTest::mouseMove(shown.plot(over), shown.pointAt(over, 0.4));
        if (isCancelled) {
            QTest::keyClick(shown.plot(over), Qt::Key_Escape);
        }
        QTest::mouseRelease(shown.plot(over), button, modifiers, shown.pointAt(over, 0.4));
        settle();
        const QCPRange after = shown.plot(over)->xAxis->range();
        QCOMPARE(after.lower > before.lower + 0.1 * before.size(), !isCancelled);
        QVERIFY(std::abs(after.size() - before.size()) < 1e-9);
        for (const QString &name : PlotGrid::plotNames()) {
            QCOMPARE(shown.plot(name)->xAxis->range(), after);
        }
    }
}

void TstPlotGrid::zoomsIntoTheBoxOfADrag_data()
{
    QTest::addColumn<QPointF>("from"); // parts of the axes, from their upper left corner
    QTest::addColumn<QPointF>("to");
    QTest::addColumn<bool>("zoomsTime");
    QTest::addColumn<bool>("zoomsValues");
    QTest::newRow("a box") << QPointF(0.2, 0.3) << QPointF(0.6, 0.8) << true << true;
    QTest::newRow("the other way") << QPointF(0.6, 0.8) << QPointF(0.2, 0.3) << true << true;
    QTest::newRow("beyond the axes: up to them") << QPointF(0.2, 0.3) << QPointF(1.2, 1.5) << true << true;
    QTest::newRow("a flat one: the time alone") << QPointF(0.2, 0.5) << QPointF(0.6, 0.51) << true << false;
    QTest::newRow("along the time axis") << QPointF(0.2, 1.05) << QPointF(0.6, 1.05) << true << false;
    QTest::newRow("a narrow one: the values alone") << QPointF(0.5, 0.3) << QPointF(0.505, 0.8) << false << true;
    QTest::newRow("along the axis of the values") << QPointF(-0.05, 0.3) << QPointF(-0.05, 0.8) << false << true;
    QTest::newRow("too small") << QPointF(0.5, 0.5) << QPointF(0.515, 0.53) << false << false;
}

void TstPlotGrid::zoomsIntoTheBoxOfADrag()
{
    QFETCH(const QPointF, from);
    QFETCH(const QPointF, to);
    QFETCH(const bool, zoomsTime);
    QFETCH(const bool, zoomsValues);
    for (const QString &over : {QStringLiteral("plot_R4_x_diff"), QStringLiteral("plot_error_position")}) {
        ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
        QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
        QCustomPlot *plot = shown.plot(over);
        const QRect axes = plot->axisRect()->rect();
        const auto pixel = [&axes](QPointF part) {
            return QPointF(axes.left() + part.x() * axes.width(), axes.top() + part.y() * axes.height()).toPoint();
        };
        const QPoint press = pixel(from);
        const QPoint release = pixel(to);
        const auto rangeOf = [](const QCPAxis &axis, int one, int other) {
            const double a = axis.pixelToCoord(one);
            const double b = axis.pixelToCoord(other);
            return QCPRange(std::max(std::min(a, b), axis.range().lower), std::min(std::max(a, b), axis.range().upper));
        };
        const QCPRange time =
            zoomsTime ? rangeOf(*plot->xAxis, press.x(), release.x()) : QCPRange(plot->xAxis->range());
        const QCPRange values = zoomsValues ? rangeOf(*plot->yAxis, press.y(), release.y()) : plot->yAxis->range();
        const auto isShown = [plot](const QCPRange &expectedTime, const QCPRange &expectedValues) {
            const auto isNear = [](const QCPRange &one, const QCPRange &other) {
                constexpr double kPixel = 0.012;
                return std::abs(one.lower - other.lower) < kPixel * other.size() &&
                       std::abs(one.upper - other.upper) < kPixel * other.size();
            };
            return isNear(plot->xAxis->range(), expectedTime) && isNear(plot->yAxis->range(), expectedValues);
        };
        const QCPRange allTime = plot->xAxis->range();
        const QCPRange allValues = plot->yAxis->range();
        const auto drag = [&](bool isCancelled) {
            QTest::mousePress(plot, Qt::LeftButton, {}, press);
            QTest::mouseMove(plot, release);
            const QRect frame = shown.overlay(over)->content().frame;
            if (isCancelled) {
                QTest::keyClick(QWidget::keyboardGrabber() ? QWidget::keyboardGrabber() : plot, Qt::Key_Escape);
            }
            QTest::mouseRelease(plot, Qt::LeftButton, {}, release);
            settle();
            return frame;
        };
        QCOMPARE(drag(true).isNull(), !zoomsTime && !zoomsValues); // one sees what one will get
        QVERIFY(isShown(allTime, allValues));
        drag(false);
        QVERIFY(!QWidget::keyboardGrabber());
        QVERIFY(shown.overlay(over)->content().frame.isNull());
        QVERIFY(isShown(time, zoomsValues || !zoomsTime ? values : plot->yAxis->range()));
        QCOMPARE(shown.grid.zoom().values[static_cast<std::size_t>(PlotGrid::plotNames().indexOf(over))].has_value(),
                 zoomsValues);
        for (const QString &name : PlotGrid::plotNames()) {
            QCOMPARE(shown.plot(name)->xAxis->range(), plot->xAxis->range());
        }
        QCOMPARE(requested.count(), zoomsTime || zoomsValues ? 0 : requested.count());
        plot->setFocus();
        QTest::keyClick(plot, Qt::Key_0);
        settle();
        QVERIFY(isShown(allTime, allValues));
    }
}

/// R4x = a cos θ2 + √(b² − (c − a sin θ2)²), looked at a thousand times.
void TstPlotGrid::fitsTheValuesToTheTimeOnShow_data()
{
    QTest::addColumn<int>("steps"); // of Newton-Raphson; 0: closed form
    QTest::newRow("the motion") << 0;
    QTest::newRow("samples") << 400;
    QTest::newRow("fewer samples than are in view") << 8;
}

void TstPlotGrid::fitsTheValuesToTheTimeOnShow()
{
    QFETCH(const int, steps);
    Session session;
    session.setParameters(withCoupler(60.0));
    if (steps > 0) {
        SolverSettings solver = session.solver();
        solver.method = Method::Newton;
        session.setSolver(solver);
        session.setSampling({0.0, 1.0, steps});
    }
    session.setReference(referenceOf(withCoupler(65.0)));
    ShownGrid shown(session.result());
    const QCustomPlot *plot = shown.plot(QStringLiteral("plot_R4_x"));
    const QCPRange whole = plot->yAxis->range();
    for (const Interval &time : {Interval{0.3, 0.4}, Interval{0.55, 0.62}, Interval{0.81, 0.83}}) {
        double least = 1e9;
        double most = -1e9;
        for (int i = 0; i <= 1000; ++i) {
            const double angle = 2.0 * std::numbers::pi * (time.lower + time.length() * i / 1000.0);
            const double h = 25.0 - 20.0 * std::sin(angle);
            for (const double b : {60.0, 65.0}) { // the file's is on show, too
                const double value = 20.0 * std::cos(angle) + std::sqrt(b * b - h * h);
                least = std::min(least, value);
                most = std::max(most, value);
            }
        }
        shown.grid.setZoom({time, {}});
        settle();
        const QCPRange seen = plot->yAxis->range();
        const double chord = steps == 8 ? 4.0 : 0.1; // mm between eight samples' lines and the motion
        QVERIFY2(seen.lower <= least + chord && seen.upper >= most - chord, qPrintable(QString::number(seen.lower)));
        QVERIFY2(seen.size() < 1.5 * (most - least) + 4.0 * chord, qPrintable(QString::number(seen.size())));
        QVERIFY(seen.size() < 0.8 * whole.size());
    }

    // Chosen values stay, whatever the time on show; those of the other plots go with it.
    PlotZoom zoom{Interval{0.3, 0.4}, {}};
    zoom.values[1] = Interval{10.0, 20.0};
    shown.grid.setZoom(zoom);
    settle();
    QCOMPARE(plot->yAxis->range(), QCPRange(10.0, 20.0));
    const QCPRange other = shown.plot(QStringLiteral("plot_theta3"))->yAxis->range();
    shown.turnWheel(QStringLiteral("plot_R4_x"), shown.pointAt(QStringLiteral("plot_R4_x"), 0.5), 4);
    QCOMPARE(plot->yAxis->range(), QCPRange(10.0, 20.0));
    QVERIFY(shown.plot(QStringLiteral("plot_theta3"))->yAxis->range().size() < other.size());
    shown.grid.showAll();
    settle();
    QCOMPARE(plot->yAxis->range(), whole);
}

void TstPlotGrid::showsAllAfterADoubleClick()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const QString over = QStringLiteral("plot_theta3");
    const QCPRange values = shown.plot(over)->yAxis->range();
    shown.turnWheel(over, shown.pointAt(over, 0.5), 5);
    QPoint onAxis = shown.pointAt(over, 0.0);
    onAxis.rx() -= 10;
    shown.turnWheel(over, onAxis, 2);
    QTest::mouseDClick(shown.plot(over), Qt::LeftButton, {}, shown.pointAt(over, 0.5));
    settle();
    QCOMPARE(shown.plot(over)->xAxis->range(), QCPRange(0.0, 1.0));
    QCOMPARE(shown.plot(over)->yAxis->range(), values);
}

void TstPlotGrid::keepsTheZoomWhileAParameterChanges()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const QString over = QStringLiteral("plot_theta3");
    shown.turnWheel(over, shown.pointAt(over, 0.5), 5);
    const QCPRange range = shown.plot(over)->xAxis->range();
    shown.grid.setResult(resultOf(withCoupler(61.0)));
    settle();
    QCOMPARE(shown.plot(over)->xAxis->range(), range);
}

void TstPlotGrid::requestsTheTimeOfAClick()
{
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
    QTest::mouseClick(shown.plot(QStringLiteral("plot_error_velocity")), Qt::LeftButton, {},
                      shown.pointAt(QStringLiteral("plot_error_velocity"), 0.25));
    QCOMPARE(requested.count(), 1);
    QVERIFY(std::abs(requested[0][0].toDouble() - 0.25) < 0.01);
    // Outside the axes there is no instant.
    QTest::mouseClick(shown.plot(QStringLiteral("plot_theta3")), Qt::LeftButton, {}, QPoint(3, 3));
    QCOMPARE(requested.count(), 1);
}

void TstPlotGrid::requestsNoTimeAfterADrag()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const QString over = QStringLiteral("plot_theta3");
    QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
    QTest::mousePress(shown.plot(over), Qt::LeftButton, {}, shown.pointAt(over, 0.6));
    QTest::mouseMove(shown.plot(over), shown.pointAt(over, 0.3));
    QTest::mouseMove(shown.plot(over), shown.pointAt(over, 0.6));
    QTest::mouseRelease(shown.plot(over), Qt::LeftButton, {}, shown.pointAt(over, 0.6));
    QCOMPARE(requested.count(), 0);
}

void TstPlotGrid::readsValuesWhereOneHovers()
{
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const QString theta3 = QStringLiteral("plot_theta3");
    QTest::mouseMove(shown.plot(theta3), shown.pointAt(theta3, 0.5));
    AWAIT(shown.overlay(theta3)->text().contains(QStringLiteral("θ³ = 24.")));
    QVERIFY(shown.overlay(theta3)->text().contains(QStringLiteral("textbook's θ₃ = 204.")));
    QVERIFY(shown.overlay(theta3)->text().contains(QStringLiteral("reference: 22.")));
    const QString error = QStringLiteral("plot_error_velocity");
    QTest::mouseMove(shown.plot(error), shown.pointAt(error, 0.5));
    AWAIT(shown.overlay(error)->text().contains(QStringLiteral("error of dθ³/dt: ")));
    QVERIFY(shown.overlay(error)->text().contains(u'%'));
}

void TstPlotGrid::readsAllNineAtOnce()
{
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0))));
    const QString theta3 = QStringLiteral("plot_theta3");
    QTest::mouseMove(shown.plot(theta3), shown.pointAt(theta3, 0.5));
    AWAIT(shown.overlay(theta3)->isVisible());
    for (const QString &name : PlotGrid::plotNames()) {
        QVERIFY2(!shown.overlay(name)->text().isEmpty(), qPrintable(name));
    }
    QCOMPARE(shown.replots, 0);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(shown.plot(theta3), &leave);
    QVERIFY(!shown.overlay(theta3)->isVisible());
}

void TstPlotGrid::readsBesideTheCurves_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<Parameters>("parameters");
    const QSize usual(960, 570); // at 1400×900
    Parameters crossed = withCoupler(60.0);
    crossed.branch = Branch::Crossed;
    QTest::newRow("Table 1") << usual << Parameters();
    QTest::newRow("a rocker") << usual << withCoupler(40.0);
    QTest::newRow("beside a toggle") << usual << withCoupler(45.01);
    QTest::newRow("crossed") << usual << crossed;
    QTest::newRow("a small screen") << QSize(585, 595) << Parameters();
}

/// At 40 instants of each plot, a dot is on the curve where it is read and no box hides that place.
void TstPlotGrid::readsBesideTheCurves()
{
    QFETCH(const QSize, size);
    QFETCH(const Parameters, parameters);
    ShownGrid shown(resultOf(parameters, 200, referenceOf(withCoupler(60.0))), size);
    int boxes = 0;
    int overCurves = 0;
    for (const QString &over : {QStringLiteral("plot_theta3"), QStringLiteral("plot_R4_x_diff2")}) {
        for (int i = 0; i <= 20; ++i) {
            const QPointF at = shown.pointAt(over, i / 20.0);
            QMouseEvent move(QEvent::MouseMove, at, shown.plot(over)->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
            QCoreApplication::sendEvent(shown.plot(over), &move);
            for (const QString &name : PlotGrid::plotNames()) {
                const QCustomPlot &plot = *shown.plot(name);
                const OverlayContent &content = shown.overlay(name)->content();
                if (content.lines.empty()) {
                    continue; // the last pixel's instant may lie beyond the run
                }
                const QRectF box(content.boxPlace, shown.overlay(name)->sizeOf(content.box));
                QVERIFY(QRectF(plot.rect()).contains(box));
                for (const OverlayContent::Dot &dot : content.dots) {
                    QVERIFY2(!box.adjusted(-3.0, -3.0, 3.0, 3.0).contains(dot.at), qPrintable(name));
                }
                ++boxes;
                bool hides = false;
                for (int graph = 0; graph < plot.graphCount(); ++graph) {
                    for (const QCPGraphData &point : *plot.graph(graph)->data()) {
                        hides = hides || (!std::isnan(point.value) &&
                                          box.contains(plot.graph(graph)->coordsToPixels(point.key, point.value)));
                    }
                }
                overCurves += hides ? 1 : 0;
            }
            const double t = shown.plot(over)->xAxis->pixelToCoord(at.x());
            const double h = parameters.c - parameters.a * std::sin(parameters.omega2 * t);
            const double along = std::sqrt(parameters.b * parameters.b - h * h);
            const OverlayContent &content = shown.overlay(QStringLiteral("plot_R4_x"))->content();
            if (std::isfinite(along) && !content.lines.empty()) {
                const double value = parameters.a * std::cos(parameters.omega2 * t) +
                                     (parameters.branch == Branch::Crossed ? -along : along);
                const QPointF expected = shown.plot(QStringLiteral("plot_R4_x"))->graph(0)->coordsToPixels(t, value);
                QVERIFY(!content.dots.empty());
                QVERIFY(QLineF(content.dots.front().at, expected).length() < 2.0);
            }
        }
    }
    QVERIFY(boxes > 300);
    const int seldom = size.width() < 700 ? 4 : 10; // where there is little room it cannot always stand free
    QVERIFY2(overCurves * seldom <= boxes, qPrintable(QStringLiteral("%1 of %2").arg(overCurves).arg(boxes)));
}

void TstPlotGrid::measuresBetweenTwoInstants()
{
    // R4x of Table 1 with b = 60: 20 + 60 cos(asin(25/60)) at 0°, -20 + the same at 180°.
    ShownGrid shown(resultOf(withCoupler(60.0), 200));
    shown.grid.setMeasuring(true);
    Pose pose;
    const QString slider = QStringLiteral("plot_R4_x");
    QCustomPlot *plot = shown.plot(slider);
    plot->setFocus();
    for (const auto &[time, key] : {std::pair(0.0, Qt::Key_1), std::pair(0.5, Qt::Key_2)}) {
        pose.time = time;
        shown.grid.setPose(pose);
        QTest::keyClick(plot, key);
    }
    const QString text = shown.overlay(slider)->text();
    QVERIFY2(text.contains(QStringLiteral("1:  74.5436 mm")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("2:  34.5436 mm")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("Δ:  -40.0000 mm")), qPrintable(text));

    const QPoint atB(static_cast<int>(std::lround(plot->xAxis->coordToPixel(0.5))), plot->axisRect()->center().y());
    const QPoint to(static_cast<int>(std::lround(plot->xAxis->coordToPixel(0.25))), atB.y());
    QTest::mousePress(plot, Qt::LeftButton, {}, atB);
    QTest::mouseMove(plot, to);
    QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
    AWAIT(shown.overlay(slider)->text().contains(QStringLiteral("2:  59."))); // 60 cos(asin(5/60)), to a pixel
    shown.grid.setMeasuring(false);
    QVERIFY(!shown.overlay(slider)->isVisible() || shown.overlay(slider)->text().isEmpty());
}

void TstPlotGrid::showsErrorsInTheChosenMeasure_data()
{
    QTest::addColumn<int>("measure");
    QTest::addColumn<bool>("logarithmic");
    QTest::newRow("percent") << static_cast<int>(ErrorMeasure::Percent) << false;
    QTest::newRow("absolute") << static_cast<int>(ErrorMeasure::Absolute) << false;
    QTest::newRow("of peak") << static_cast<int>(ErrorMeasure::OfPeak) << false;
    QTest::newRow("percent, logarithmic") << static_cast<int>(ErrorMeasure::Percent) << true;
    QTest::newRow("absolute, logarithmic") << static_cast<int>(ErrorMeasure::Absolute) << true;
}

void TstPlotGrid::showsErrorsInTheChosenMeasure()
{
    QFETCH(int, measure);
    QFETCH(bool, logarithmic);
    PlotSettings settings;
    settings.error = static_cast<ErrorMeasure>(measure);
    settings.logarithmicError = logarithmic;
    const Parameters theirs = withCoupler(65.0);
    ShownGrid shown(resultOf(withCoupler(60.0), 200, referenceOf(theirs)));
    shown.grid.setSettings(settings);
    settle();

    // The textbook's formulas, at t = 0: θ3 = asin(25/b), R4x = 20 + √(b² - 25²).
    constexpr double kDegree = 180.0 / std::numbers::pi;
    const std::array<double, 2> model{std::asin(25.0 / 60.0) * kDegree, 20.0 + std::sqrt(60.0 * 60.0 - 625.0)};
    const std::array<double, 2> reference{std::asin(25.0 / 65.0) * kDegree, 20.0 + std::sqrt(65.0 * 65.0 - 625.0)};
    // Peaks: at 270° θ3 = asin(45/65); R4x is largest where crank and coupler are in line, √((20 + 65)² - 25²).
    const std::array<double, 2> peak{std::asin(45.0 / 65.0) * kDegree, std::sqrt(85.0 * 85.0 - 625.0)};
    const QCustomPlot *plot = shown.plot(QStringLiteral("plot_error_position"));
    for (std::size_t i = 0; i < 2; ++i) {
        double expected = std::abs(model[i] - reference[i]);
        switch (settings.error) {
        case ErrorMeasure::Percent: expected *= 100.0 / reference[i]; break;
        case ErrorMeasure::Absolute: break;
        case ErrorMeasure::OfPeak: expected *= 100.0 / peak[i]; break;
        }
        expected = logarithmic ? std::log10(expected) : expected;
        const double shownValue = plot->graph(static_cast<int>(i))->data()->constBegin()->value;
        constexpr double kPeakIsSampled = 2e-3; // of 51 samples none is just at the peak
        QVERIFY2(std::abs(shownValue - expected) <= kPeakIsSampled * std::abs(expected),
                 qPrintable(QStringLiteral("%1 instead of %2").arg(shownValue).arg(expected)));
    }
    QCOMPARE(plot->yAxis2->visible(), settings.error == ErrorMeasure::Absolute);
}

void TstPlotGrid::labelsTheAxisWithTheCrankAngle()
{
    Parameters parameters;
    parameters.omega2 = -2.0 * std::numbers::pi;
    parameters.theta20 = 0.5 * std::numbers::pi;
    ShownGrid shown(resultOf(parameters));
    PlotSettings settings;
    settings.abscissa = Abscissa::CrankAngle;
    shown.grid.setSettings(settings);
    settle();
    const QCPAxis &axis = *shown.plot(QStringLiteral("plot_theta3_diff2"))->xAxis;
    const QVector<double> ticks = axis.ticker()->tickOrigin() == 0.25 ? QVector<double>{0.25} : QVector<double>{};
    QCOMPARE(ticks.size(), 1); // θ2 is 0 a quarter of a second after it was 90°
    QVector<double> positions;
    QVector<QString> labels;
    axis.ticker()->generate(axis.range(), QLocale(), u'f', 6, positions, nullptr, &labels);
    const qsizetype atNothing = labels.indexOf(QStringLiteral("0"));
    QVERIFY(atNothing >= 0);
    QVERIFY(std::abs(positions[atNothing] - 0.25) < 1e-12);
    QVERIFY(labels.contains(QStringLiteral("90")) && labels.contains(QStringLiteral("-90")));
}

void TstPlotGrid::maximizesAPlotByItsTitle()
{
    ShownGrid shown(resultOf(Parameters()));
    const QString name = QStringLiteral("plot_R4_x_diff");
    const QSize small = shown.plot(name)->size();
    QTest::mouseDClick(shown.plot(name), Qt::LeftButton, {}, QPoint(60, 4));
    settle();
    QVERIFY(shown.plot(name)->width() >= 2 * small.width());
    QVERIFY(!shown.plot(QStringLiteral("plot_theta3"))->isVisible());
    QCOMPARE(shown.grid.focusWidget(), shown.plot(name)); // whose key Escape is
    QTest::keyClick(shown.grid.focusWidget(), Qt::Key_Escape);
    settle();
    QCOMPARE(shown.plot(name)->size(), small);
    QVERIFY(shown.plot(QStringLiteral("plot_theta3"))->isVisible());
}

void TstPlotGrid::zoomsByKeysAboutTheInstant()
{
    ShownGrid shown(resultOf(Parameters()));
    Pose pose;
    pose.time = 0.25;
    shown.grid.setPose(pose);
    QCustomPlot *plot = shown.plot(QStringLiteral("plot_R4_x"));
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_Plus);
    const std::optional<Interval> zoomed = shown.grid.zoom().time;
    QVERIFY(zoomed && zoomed->length() < 0.8);
    QVERIFY(std::abs((0.25 - zoomed->lower) / zoomed->length() - 0.25) < 1e-12); // it stays where it is
    QTest::keyClick(plot, Qt::Key_Minus);
    QVERIFY(std::abs(shown.grid.zoom().time.value_or(Interval{0.0, 1.0}).length() - 1.0) < 1e-12);
}

void TstPlotGrid::offersToExportAPlot()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    QSignalSpy requested(&shown.grid, &PlotGrid::exportPlotRequested);
    QCustomPlot *plot = shown.plot(QStringLiteral("plot_R4_x"));
    QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(50, 50), plot->mapToGlobal(QPoint(50, 50)));
    QCoreApplication::sendEvent(plot, &event);
    auto *menu = shown.grid.findChild<QMenu *>();
    QVERIFY(menu);
    for (QAction *action : menu->actions()) {
        if (action->text().contains(QStringLiteral("xport"))) {
            action->trigger();
        }
    }
    menu->close();
    QCOMPARE(requested.count(), 1);
    QCOMPARE(requested[0][0].toString(), QStringLiteral("plot_R4_x"));
}

void TstPlotGrid::drawsAsManyPointsAsPixelsAtMost()
{
    const ShownGrid shown(resultOf(withCoupler(60.0), 20000));
    const QCustomPlot *plot = shown.plot(QStringLiteral("plot_R4_x"));
    QVERIFY(plot->graph(0)->dataCount() <= 2 * plot->axisRect()->width() + 2);
    QVERIFY(plot->graph(0)->dataCount() >= 20); // what a smooth curve needs
}

void TstPlotGrid::keepsTheAxesInPlaceWhileValuesChange()
{
    ShownGrid shown(resultOf(withCoupler(46.0)));
    const QRect before = shown.plot(QStringLiteral("plot_theta3_diff2"))->axisRect()->rect();
    for (const double b : {50.0, 60.0, 90.0, 150.0}) {
        shown.grid.setResult(resultOf(withCoupler(b)));
        settle();
        QCOMPARE(shown.plot(QStringLiteral("plot_theta3_diff2"))->axisRect()->rect(), before);
    }
}

void TstPlotGrid::hasRoomForTheTitleOfShortTimes()
{
    Session session;
    Sampling sampling;
    sampling.duration = 6e-5;
    session.setSampling(sampling);
    ShownGrid shown(session.result());
    TextRecorder recorder({300, 200});
    QPainter painter(&recorder);
    shown.grid.paintPlot(painter, QStringLiteral("plot_theta3"), {300, 200}, paletteFor(Theme::Light));
    painter.end();
    bool isThere = false;
    for (const auto &[text, place] : recorder.texts) {
        isThere = isThere || text.startsWith(QLatin1String("t ["));
        QVERIFY2(place.left() >= 0.0, qPrintable(text));
    }
    QVERIFY(isThere);
}

void TstPlotGrid::alignsThePlotsOfAColumn()
{
    const ShownGrid shown(resultOf(withCoupler(60.0)), QSize(620, 480));
    const QStringList names = PlotGrid::plotNames();
    for (int i = 3; i < 9; ++i) {
        const QRect above = shown.plot(names[i - 3])->axisRect()->rect();
        const QRect below = shown.plot(names[i])->axisRect()->rect();
        QCOMPARE(below.left(), above.left());
        QCOMPARE(below.size(), above.size());
    }
}

void TstPlotGrid::keepsReadingsWithinNarrowPlots()
{
    const std::shared_ptr<const Result> result = resultOf(withCoupler(60.0), 200, referenceOf(withCoupler(65.0)));
    const QSize small(580, 600);
    const auto keepsWithin = [](const ShownGrid &shown) {
        const QFontMetricsF metrics(PlotTypography(shown.grid.font()).tick);
        for (const QString &name : PlotGrid::plotNames()) {
            const PlotOverlay *overlay = shown.overlay(name);
            const QStringList rows = overlay->text().split(u'\n', Qt::SkipEmptyParts);
            for (const QString &row : rows) {
                if (metrics.horizontalAdvance(row) > overlay->width()) {
                    qWarning() << name << row;
                    return false;
                }
            }
            if (rows.isEmpty()) {
                return false;
            }
        }
        return true;
    };
    ShownGrid measuring(result, small);
    measuring.grid.setMeasuring(true);
    QVERIFY(keepsWithin(measuring));
    for (const QString &name : {QStringLiteral("plot_theta3"), QStringLiteral("plot_R4_x_diff2")}) {
        const ShownGrid shown(result, small);
        const QPointF at = shown.pointAt(name, 0.9);
        QMouseEvent move(QEvent::MouseMove, at, shown.plot(name)->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(shown.plot(name), &move);
        QVERIFY(keepsWithin(shown));
    }
}

void TstPlotGrid::framesThePlotWithTheFocusAndNoMore()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const QString name = QStringLiteral("plot_R4_x");
    shown.grid.setMeasuring(true); // the box over the plot stays
    settle();
    const QImage before = pictureOf(shown, name);
    shown.grid.activateWindow();
    shown.plot(name)->setFocus(Qt::TabFocusReason);
    AWAIT(shown.plot(name)->hasFocus());
    settle();
    const QImage after = pictureOf(shown, name);
    QVERIFY(after != before);
    const QRect inside = before.rect().adjusted(3, 3, -3, -3);
    QCOMPARE(after.copy(inside), before.copy(inside));
}

void TstPlotGrid::keepsTheLegendWithinTheFigure()
{
    QFont large = QApplication::font();
    large.setPixelSize(20);
    const PlotTypography typography(large);
    const SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    using Sample = LegendEntry::Sample;
    const std::vector<LegendEntry> entries{{Sample::Solid, Ink::Model, "model"},
                                           {Sample::Dashed, Ink::Reference, "simulation_of_june.csv", true},
                                           {Sample::Solid, Ink::Error, "error of θ³", false, true},
                                           {Sample::Solid, Ink::ErrorOther, "error of Rₓ⁴", false, true},
                                           {Sample::Band, Ink::Error, "file's rounding", false, true},
                                           {Sample::Mark, Ink::Text, "reference is 0", false, true}};
    for (int width = 1400; width >= 525; width -= 5) {
        const QRect rect(0, 0, width, typography.legendHeight());
        TextRecorder recorder(rect.size());
        QPainter painter(&recorder);
        drawLegend(painter, rect, entries, typography, colours);
        painter.end();
        QString shown; // in pieces where a sign is of another font
        double right = 0.0;
        for (const auto &[text, place] : recorder.texts) {
            QVERIFY2(place.left() > right && place.right() <= width, qPrintable(text + QString::number(width)));
            right = place.right();
            shown += text;
        }
        for (const char *needed : {"model", "error of θ³", "error of Rₓ⁴"}) {
            QVERIFY2(shown.contains(QString::fromUtf8(needed)), needed);
        }
        QVERIFY(width < 1400 || shown.endsWith(QLatin1String("file's roundingreference is 0")));
    }
}

void TstPlotGrid::saysInWordsWhatAPlotIsOfWhereThereIsRoom()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    const auto titleAt = [&](int width) {
        TextRecorder recorder({width, 300});
        QPainter painter(&recorder);
        shown.grid.paintPlot(painter, QStringLiteral("plot_theta3_diff2"), {width, 300}, paletteFor(Theme::Light));
        painter.end();
        QString drawn; // in pieces where a sign is of another font
        for (const auto &[text, place] : recorder.texts) {
            drawn += text;
        }
        return drawn.contains(QString::fromUtf8("coupler angular acceleration d²")) ? 2
               : drawn.contains(QString::fromUtf8("acceleration d²"))               ? 1
               : drawn.contains(QString::fromUtf8("d²θ³/dt²"))                      ? 0
                                                                                    : -1;
    };
    QCOMPARE(titleAt(600), 2);
    QCOMPARE(titleAt(300), 1);
    QCOMPARE(titleAt(180), 0);
}

void TstPlotGrid::recoloursWithThePalette()
{
    ShownGrid shown(resultOf(withCoupler(60.0)));
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const QPalette palette = paletteFor(theme);
        shown.grid.setPalette(palette);
        settle();
        QCOMPARE(shown.plot(QStringLiteral("plot_theta3"))->graph(0)->pen().color(), seriesColours(palette).model);
        QCOMPARE(pictureOf(shown, QStringLiteral("plot_theta3")).pixelColor(1, 1), palette.color(QPalette::Base));
        QCOMPARE(shown.grid.grab().toImage().pixelColor(1, 1), palette.color(QPalette::Base));
    }
}

QTEST_MAIN(TstPlotGrid)
#include "tst_plot_grid.moc"
