// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_grid.h"

#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "tests/ui/plots/plot_results.h"

#include <QApplication>
#include <QClipboard>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

using namespace slidercrank;

namespace
{

std::shared_ptr<const Result> resultWith(double b, const std::shared_ptr<const Reference> &reference = nullptr,
                                         const std::vector<Parameters> &pinned = {})
{
    return resultOf({.model = withCoupler(b), .reference = reference, .pinned = pinned});
}

/// A grid on the (offscreen) screen, and how often each of its plots was painted as a whole since.
class ShownGrid : public QObject
{
public:
    explicit ShownGrid(const std::shared_ptr<const Result> &result, QSize size = QSize(900, 600))
    {
        grid.resize(size);
        grid.setResult(result);
        grid.show();
        settle();
        if (QWidget *focus = QApplication::focusWidget()) {
            focus->clearFocus(); // its frame is no part of a plot
        }
        settle();
        for (const QString &name : PlotGrid::plotNames()) {
            pane(name).installEventFilter(this);
        }
    }

    PlotPane &pane(const QString &name) const { return *grid.findChild<PlotPane *>(name); }

    /// At parts of the axes, from their upper left corner.
    QPoint at(const QString &name, double x, double y = 0.5) const
    {
        const QRect axes = pane(name).axes();
        return axes.topLeft() + QPointF(x * axes.width(), y * axes.height()).toPoint();
    }

    void turnWheel(const QString &name, QPoint at, int notches)
    {
        const QPoint place = pane(name).mapTo(&grid, at);
        QWheelEvent event(place, grid.mapToGlobal(place), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&grid, &event);
        settle();
    }

    void drag(const QString &name, const QPoint &from, const QPoint &to, bool isCancelled = false,
              Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mousePress(&pane(name), button, modifiers, from);
        QTest::mouseMove(&pane(name), to);
        if (isCancelled) {
            QTest::keyClick(&pane(name), Qt::Key_Escape);
        }
        QTest::mouseRelease(&pane(name), button, modifiers, to);
        settle();
    }

    void point(const QString &name, const QPoint &to) const
    {
        QMouseEvent move(QEvent::MouseMove, to, pane(name).mapToGlobal(to), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&pane(name), &move);
        settle();
    }

    void setTime(double t)
    {
        Pose pose;
        pose.time = t;
        grid.setPose(pose);
        settle();
    }

    Interval time() const { return grid.zoom().time.value_or(Interval{0.0, 1.0}); }

    QImage pictureOf(const QString &name) const { return pane(name).grab().toImage(); }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        const auto *widget = static_cast<const QWidget *>(watched);
        if (event->type() == QEvent::Paint &&
            static_cast<QPaintEvent *>(event)->region().contains(widget->rect().center()) &&
            static_cast<QPaintEvent *>(event)->rect() == widget->rect()) {
            ++repaints;
        }
        return false;
    }

    PlotGrid grid;
    int repaints = 0;
};

int pixelsLike(const QImage &image, const QColor &wanted)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            count += std::abs(pixel.hue() - wanted.hue()) < 10 && pixel.saturation() > 60 ? 1 : 0;
        }
    }
    return count;
}

const QString kAngle = QStringLiteral("plot_theta3");
const QString kSlider = QStringLiteral("plot_R4_x");
const QString kSpeed = QStringLiteral("plot_R4_x_diff");
const QString kErrors = QStringLiteral("plot_error_velocity");

} // namespace

class TestPlotGrid : public QObject
{
    Q_OBJECT

private slots:
    void paintsAllNineInTheColoursOfThePalette()
    {
        const QStringList names{"plot_theta3",       "plot_R4_x",       "plot_error_position",
                                "plot_theta3_diff",  "plot_R4_x_diff",  "plot_error_velocity",
                                "plot_theta3_diff2", "plot_R4_x_diff2", "plot_error_acceleration"};
        QCOMPARE(PlotGrid::plotNames(), names);
        ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            shown.grid.setPalette(paletteFor(theme));
            settle();
            const SeriesColours colours = seriesColours(paletteFor(theme));
            for (const QString &name : names) {
                const bool isError = name.contains(QStringLiteral("error"));
                const QImage image = shown.pictureOf(name);
                QVERIFY2(pixelsLike(image, isError ? colours.errorOther : colours.model) > 50, qPrintable(name));
                QVERIFY2(pixelsLike(image, isError ? colours.error : colours.reference) > 50, qPrintable(name));
                QCOMPARE(image.pixelColor(1, 1), colours.background);
                QVERIFY(!shown.pane(name).accessibleName().isEmpty());
                QVERIFY(!shown.pane(name).accessibleDescription().isEmpty());
            }
            QCOMPARE(shown.grid.grab().toImage().pixelColor(1, 1), colours.background);
        }
    }

    void severalResultsMakeOneRepaintAndNoneWhileHidden()
    {
        ShownGrid shown(resultWith(60.0));
        shown.repaints = 0;
        for (const double b : {61.0, 62.0, 63.0}) {
            shown.grid.setResult(resultWith(b));
        }
        settle();
        QCOMPARE(shown.repaints, 6); // without a reference there are no errors
        shown.grid.hide();
        shown.repaints = 0;
        shown.grid.setResult(resultWith(64.0));
        settle();
        QCOMPARE(shown.repaints, 0);
        shown.grid.show();
        settle();
        QVERIFY(shown.repaints >= 6);
    }

    void everyCurveCarriesADotAndItsValueAtTheTimeOnShow()
    {
        ShownGrid shown(resultWith(60.0, referenceOf(65.0), {withCoupler(80.0)}));
        shown.setTime(0.1);
        const SeriesColours colours = seriesColours(shown.grid.palette());
        for (const double t : {0.25, 0.75}) {
            shown.repaints = 0;
            shown.setTime(t);
            QCOMPARE(shown.repaints, 0);
            for (const QString &name : PlotGrid::plotNames()) {
                const PlotPane &pane = shown.pane(name);
                const PlotPane::Cursor &cursor = pane.cursors().at(0);
                QCOMPARE(cursor.dots.size(), std::size_t(name.contains(QStringLiteral("error")) ? 2 : 3));
                const double part = (cursor.x - pane.axes().left()) / pane.axes().width();
                QVERIFY(std::abs(part - t) < 2.0 / pane.axes().width());
                QVERIFY(pane.rect().contains(cursor.dots[0].place.toPoint()));
                const QImage image = shown.pictureOf(name); // a dot or a value may be at one end of the line
                const auto isLine = [&](int y) {
                    return image.pixelColor(static_cast<int>(cursor.x), y) == colours.cursor;
                };
                QVERIFY(isLine(pane.axes().bottom() - 1) || isLine(pane.axes().top() + 1));
            }
        }
        // Rₓ⁴ = √(b² − (c − a sin θ₂)²) at 270°
        const QStringList values = shown.pane(kSlider).text().split(u'\n');
        for (const double b : {60.0, 65.0, 80.0}) {
            QVERIFY(values.contains(QString::number(std::sqrt(b * b - 45.0 * 45.0), 'f', 2)));
        }
        shown.setTime(1.5);
        QVERIFY(shown.pane(kSlider).cursors().empty());
    }

    void hoveringReadsAllNineByASecondLighterCursor()
    {
        ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
        shown.setTime(0.1);
        shown.repaints = 0;
        shown.point(kAngle, shown.at(kAngle, 0.5));
        for (const QString &name : PlotGrid::plotNames()) {
            QCOMPARE(shown.pane(name).cursors().size(), std::size_t(2));
            QVERIFY(shown.pane(name).cursors()[1].isLight && !shown.pane(name).cursors()[0].isLight);
            QCOMPARE(shown.pane(name).cursors()[1].dots.size(), std::size_t(2));
        }
        const QString text = shown.pane(kAngle).text();
        QVERIFY2(text.contains(QStringLiteral("t = 0.5 s")) && text.contains(QStringLiteral("θ₃ = 204.6°")) &&
                     text.contains(QStringLiteral("24.62")) && text.contains(QStringLiteral("22.62")),
                 qPrintable(text));
        QCOMPARE(shown.repaints, 0);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&shown.grid, &leave);
        QCOMPARE(shown.pane(kAngle).cursors().size(), std::size_t(1));
    }

    void valuesStayWithinNarrowPlots()
    {
        for (const QSize size : {QSize(960, 570), QSize(585, 595), QSize(420, 230)}) {
            ShownGrid shown(resultWith(60.0, referenceOf(65.0)), size);
            for (const double part : {0.02, 0.5, 0.98}) {
                shown.point(kSpeed, shown.at(kSpeed, part));
                for (const QString &name : PlotGrid::plotNames()) {
                    const PlotPane &pane = shown.pane(name);
                    for (const PlotPane::Label &label : pane.labels()) {
                        QVERIFY2(QRectF(pane.rect()).contains(label.place), qPrintable(name));
                    }
                }
            }
        }
    }

    void sixPlotsHaveAllTheRoomWithoutAReference()
    {
        ShownGrid shown(resultWith(60.0));
        auto *hint = shown.grid.findChild<QLabel *>(QStringLiteral("no_reference_hint"));
        QVERIFY(hint && hint->isVisible());
        QVERIFY(!shown.pane(kErrors).isVisible());
        QVERIFY(std::abs(shown.pane(kAngle).width() - shown.grid.width() / 2) < 10);
        QSignalSpy requested(&shown.grid, &PlotGrid::openReferenceRequested);
        emit hint->linkActivated(QStringLiteral("open"));
        QCOMPARE(requested.count(), 1);
        shown.grid.setResult(resultWith(60.0, referenceOf(65.0)));
        settle();
        QVERIFY(!hint->isVisible() && shown.pane(kErrors).isVisible());
        QVERIFY(std::abs(shown.pane(kAngle).width() - shown.grid.width() / 3) < 10);
    }

    void axesOfAColumnAreAlignedAndStandStill()
    {
        ShownGrid shown(resultWith(46.0), QSize(620, 480));
        const QStringList names = PlotGrid::plotNames();
        const auto axes = [&](int plot) {
            const PlotPane &pane = shown.pane(names[plot]);
            return pane.axes().translated(pane.pos());
        };
        const QRect before = axes(6);
        for (const double b : {46.0, 50.0, 60.0, 90.0, 150.0}) {
            shown.grid.setResult(resultWith(b));
            settle();
            QCOMPARE(axes(6), before);
            for (const int plot : {3, 4, 6, 7}) {
                QCOMPARE(axes(plot).left(), axes(plot - 3).left());
                QCOMPARE(axes(plot).width(), axes(plot - 3).width());
                QVERIFY(std::abs(axes(plot).height() - axes(plot - 3).height()) <= 2);
            }
        }
    }

    void theWheelZoomsAllTimeAxesOrOneAxisOfValuesAndKeysZoomTheTime()
    {
        ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
        shown.turnWheel(kSpeed, shown.at(kSpeed, 0.5), 3);
        QVERIFY(shown.time().length() < 0.7 && shown.time().contains(0.5));
        shown.grid.setResult(resultWith(61.0, referenceOf(65.0))); // the zoom stays
        QVERIFY(shown.time().length() < 0.7);
        shown.turnWheel(kSpeed, shown.at(kSpeed, 0.5), -30);
        QVERIFY(!shown.grid.zoom().time);
        shown.turnWheel(kSpeed, shown.at(kSpeed, 0.0) - QPoint(10, 0), 2);
        QVERIFY(!shown.grid.zoom().time && shown.grid.zoom().values[4] && !shown.grid.zoom().values[3]);
        QTest::mouseDClick(&shown.pane(kSpeed), Qt::LeftButton, {}, shown.at(kSpeed, 0.5));
        QVERIFY(shown.grid.zoom() == PlotZoom());
        shown.setTime(0.25);
        QTest::keyClick(&shown.pane(kSlider), Qt::Key_Plus);
        QVERIFY(shown.time().length() < 0.8);
        QVERIFY(std::abs((0.25 - shown.time().lower) / shown.time().length() - 0.25) < 1e-12); // it stays where it is
    }

    void shiftOrTheMiddleButtonPans()
    {
        for (const auto &[button, modifiers] :
             {std::pair<Qt::MouseButton, Qt::KeyboardModifiers>{Qt::LeftButton, Qt::ShiftModifier},
              {Qt::MiddleButton, Qt::NoModifier}}) {
            ShownGrid shown(resultWith(60.0));
            shown.grid.setZoom({Interval{0.3, 0.5}, {}});
            settle();
            shown.drag(kAngle, shown.at(kAngle, 0.6), shown.at(kAngle, 0.4), true, button, modifiers);
            QCOMPARE(shown.time(), (Interval{0.3, 0.5})); // Escape
            shown.drag(kAngle, shown.at(kAngle, 0.6), shown.at(kAngle, 0.4), false, button, modifiers);
            QVERIFY(std::abs(shown.time().lower - 0.34) < 2e-3 && std::abs(shown.time().length() - 0.2) < 1e-9);
        }
    }

    void aDragZoomsIntoTheBoxThatItDraws()
    {
        struct Row {
            const char *name;
            QPointF from; // parts of the axes
            QPointF to;
            bool zoomsTime;
            bool zoomsValues;
        };
        for (const Row &row : {Row{"a box", {0.2, 0.3}, {0.6, 0.8}, true, true},
                               Row{"the other way", {0.6, 0.8}, {0.2, 0.3}, true, true},
                               Row{"beyond the axes", {0.2, 0.3}, {1.2, 1.5}, true, true},
                               Row{"a flat one", {0.2, 0.5}, {0.6, 0.51}, true, false},
                               Row{"along the time axis", {0.2, 1.02}, {0.6, 1.02}, true, false},
                               Row{"a narrow one", {0.5, 0.3}, {0.505, 0.8}, false, true},
                               Row{"along the axis of the values", {-0.05, 0.3}, {-0.05, 0.8}, false, true},
                               Row{"too small", {0.5, 0.5}, {0.51, 0.52}, false, false}}) {
            ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
            QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
            const QPoint from = shown.at(kErrors, row.from.x(), row.from.y());
            const QPoint to = shown.at(kErrors, row.to.x(), row.to.y());
            shown.drag(kErrors, from, to, true);
            QVERIFY2(shown.grid.zoom() == PlotZoom(), row.name);
            QTest::mousePress(&shown.pane(kErrors), Qt::LeftButton, {}, from);
            QTest::mouseMove(&shown.pane(kErrors), to);
            QCOMPARE(shown.pane(kErrors).frame().isNull(), !row.zoomsTime && !row.zoomsValues);
            QTest::mouseRelease(&shown.pane(kErrors), Qt::LeftButton, {}, to);
            settle();
            QVERIFY(!QWidget::keyboardGrabber() && shown.pane(kErrors).frame().isNull());
            QVERIFY2(shown.grid.zoom().time.has_value() == row.zoomsTime, row.name);
            QVERIFY2(shown.grid.zoom().values[5].has_value() == row.zoomsValues, row.name);
            if (row.zoomsTime) {
                QVERIFY(std::abs(shown.time().lower - 0.2) < 0.01);
                QVERIFY(std::abs(shown.time().upper - std::min(1.0, std::max(row.from.x(), row.to.x()))) < 0.01);
            }
            QVERIFY(!(row.zoomsTime || row.zoomsValues) || requested.count() == 0);
            shown.pane(kErrors).setFocus();
            QTest::keyClick(&shown.pane(kErrors), Qt::Key_0);
            QVERIFY(shown.grid.zoom() == PlotZoom());
        }
    }

    void aClickRequestsItsTimeAndWithAFileOneOfItsTimeStamps()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        ShownGrid shown(resultWith(60.0, reference));
        QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
        QTest::mouseClick(&shown.pane(kErrors), Qt::LeftButton, {}, shown.at(kErrors, 0.25));
        QCOMPARE(requested.count(), 1);
        const double t = requested[0][0].toDouble();
        QVERIFY(std::abs(t - 0.25) < 0.01);
        QVERIFY(std::ranges::find(reference->data.time, t) != reference->data.time.end());
        QTest::mouseClick(&shown.pane(kAngle), Qt::LeftButton, {}, QPoint(3, 3)); // outside the axes
        shown.drag(kAngle, shown.at(kAngle, 0.6), shown.at(kAngle, 0.3));
        QCOMPARE(requested.count(), 1);
    }

    void aTimeThatIsNotInViewIsBroughtThere()
    {
        ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
        shown.grid.setZoom({Interval{0.31, 0.69}, {}});
        shown.grid.showTime(0.5);
        QCOMPARE(shown.time(), (Interval{0.31, 0.69}));
        shown.grid.showTime(0.75);
        QVERIFY(std::abs(shown.time().lower - 0.56) < 1e-9 && std::abs(shown.time().length() - 0.38) < 1e-9);
        shown.grid.showAll();
        shown.grid.showTime(0.75);
        QVERIFY(!shown.grid.zoom().time);
    }

    void measuresBetweenTwoTimesInSecondsOrDegrees()
    {
        // Rₓ⁴ of Table 1 with b = 60: 20 + 60 cos(asin(25/60)) at 0°, −20 + the same at 180°.
        ShownGrid shown(resultWith(60.0));
        shown.grid.setMeasuring(true);
        shown.pane(kSlider).setFocus();
        for (const auto &[time, key] : {std::pair(0.0, Qt::Key_1), std::pair(0.5, Qt::Key_2)}) {
            shown.setTime(time);
            QTest::keyClick(&shown.pane(kSlider), key);
        }
        QCOMPARE(shown.grid.measured(), (std::optional{std::array{0.0, 0.5}}));
        shown.setTime(2.0);
        QCOMPARE(shown.pane(kSlider).text(), QStringLiteral("1\n74.54\n2\n34.54"));
        QCOMPARE(shown.grid.measuredText(), QStringLiteral("1: t = 0 s · 2: t = 0.5 s · Δ = 0.5 s"));
        PlotSettings settings;
        settings.abscissa = Abscissa::CrankAngle;
        shown.grid.setSettings(settings);
        settle();
        QCOMPARE(shown.grid.measuredText(), QStringLiteral("1: θ₂ = 0° · 2: θ₂ = 180° · Δ = 180°"));
        shown.drag(kSlider, shown.at(kSlider, 0.5), shown.at(kSlider, 0.25));
        QVERIFY(std::abs((*shown.grid.measured())[1] - 0.25) < 0.01);
        shown.grid.setMeasuring(false);
        QVERIFY(shown.pane(kSlider).text().isEmpty());
    }

    void aTitleMaximizesItsPlotAndEscapeBringsAllBack()
    {
        ShownGrid shown(resultWith(60.0));
        const QSize small = shown.pane(kSpeed).size();
        QTest::mouseDClick(&shown.pane(kSpeed), Qt::LeftButton, {}, QPoint(60, 4));
        settle();
        QVERIFY(shown.pane(kSpeed).width() > 1.8 * small.width() && !shown.pane(kAngle).isVisible());
        QCOMPARE(shown.grid.maximized(), kSpeed);
        QCOMPARE(shown.grid.focusWidget(), &shown.pane(kSpeed));
        QTest::keyClick(shown.grid.focusWidget(), Qt::Key_Escape);
        settle();
        QCOMPARE(shown.pane(kSpeed).size(), small);
    }

    void itsMenuCopiesValuesAndExportsThePlot()
    {
        ShownGrid shown(resultWith(60.0));
        QSignalSpy requested(&shown.grid, &PlotGrid::exportPlotRequested);
        shown.setTime(0.25);
        QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(50, 50),
                                shown.pane(kSlider).mapToGlobal(QPoint(50, 50)));
        QCoreApplication::sendEvent(&shown.pane(kSlider), &event);
        auto *menu = shown.grid.findChild<QMenu *>();
        QVERIFY(menu);
        for (QAction *action : menu->actions()) {
            if (action->text().contains(QStringLiteral("xport")) ||
                action->text().contains(QStringLiteral("alues here"))) {
                action->trigger();
            }
        }
        menu->close();
        QCOMPARE(requested.count(), 1);
        QCOMPARE(requested[0][0].toString(), kSlider);
        const QStringList cells = QApplication::clipboard()->text().split(u'\t');
        QCOMPARE(cells.size(), 2);
        QVERIFY(std::abs(cells[1].toDouble() - std::sqrt(60.0 * 60.0 - 25.0)) < 1e-12);
    }

    void anExportedFigureNamesItsParameters()
    {
        ShownGrid shown(resultWith(60.0, referenceOf(65.0)));
        for (const bool isFigure : {true, false}) {
            TextRecorder recorder({900, 700});
            QPainter painter(&recorder);
            if (isFigure) {
                shown.grid.paintFigure(painter, {900, 700}, paletteFor(Theme::Light));
            } else {
                shown.grid.paintPlot(painter, kSlider, {900, 700}, paletteFor(Theme::Light));
            }
            painter.end();
            QString text;
            for (const auto &[part, place] : recorder.texts) {
                text += part;
            }
            for (const char *wanted : {"a = 20 mm, b = 60 mm, c = 25 mm", "model", "simulation.csv", "t [s]"}) {
                QVERIFY2(text.contains(QLatin1String(wanted)), qPrintable(text));
            }
        }
    }
};

QTEST_MAIN(TestPlotGrid)
#include "tst_plot_grid.moc"
