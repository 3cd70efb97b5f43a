// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pixels.h"
#include "tests/support/suite.h"
#include "ui/plots/plot_drawing.h"
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
#include <QRubberBand>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>

using namespace slidercrank;

namespace tst_plot_grid
{

const QString kAngle = "plot_theta3";
const QString kSlider = "plot_R4_x";
const QString kErrors = "plot_error_velocity";

enum class DragEnd { Release, Escape };

/// A visible grid that counts how often one of its plots is painted completely.
class ShownGrid : public QObject
{
public:
    explicit ShownGrid(const PlotInput &shown = {}, const QSize &size = QSize(900, 600))
    {
        grid.resize(size);
        show(shown);
        grid.show();
        settle();
        if (QWidget *focus = QApplication::focusWidget()) {
            focus->clearFocus(); // so that no focus frame is painted
        }
        settle();
        for (PlotPane *pane : grid.findChildren<PlotPane *>()) {
            pane->installEventFilter(this);
        }
    }

    void show(const PlotInput &shown)
    {
        grid.setResult(resultOf(shown));
        settle();
    }

    PlotPane &pane(const QString &name) const { return *grid.findChild<PlotPane *>(name); }

    /// Returns a position (px) in the plot. `x` and `y`: fractions (0 … 1) of the axes, from their upper left corner.
    QPoint at(const QString &name, double x, double y = 0.5) const
    {
        const QRect axes = pane(name).axes();
        return axes.topLeft() + QPointF(x * axes.width(), y * axes.height()).toPoint();
    }

    void turnWheel(const QString &name, const QPoint &at, int notches)
    {
        const QPoint place = pane(name).mapTo(&grid, at);
        QWheelEvent event(place, grid.mapToGlobal(place), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&grid, &event);
        settle();
    }

    void drag(const QString &name, const QPoint &from, const QPoint &to, DragEnd end = DragEnd::Release,
              Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&pane(name), button, modifiers, from);
        QTest::mouseMove(&pane(name), to);
        hasDrawnBox = box().isVisible();
        if (end == DragEnd::Escape) {
            QTest::keyClick(&pane(name), Qt::Key_Escape);
        }
        QTest::mouseRelease(&pane(name), button, modifiers, to);
        settle();
    }

    void setTime(double t)
    {
        Pose pose;
        pose.time = t;
        grid.setPose(pose);
        settle();
    }

    const QWidget &box() const { return *grid.findChild<QRubberBand *>(); }
    Interval time() const { return grid.zoom().time.value_or(Interval{0.0, 1.0}); }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Paint) {
            const QRegion &region = static_cast<const QPaintEvent *>(event)->region();
            repaints += region == static_cast<const QWidget *>(watched)->rect() ? 1 : 0;
            mostRectangles = std::max(mostRectangles, region.rectCount());
        }
        return false;
    }

    PlotGrid grid;
    bool hasDrawnBox = false; ///< in the middle of the last drag
    int repaints = 0;
    int mostRectangles = 0; ///< in the region of a paint event
};

/// Counts the saturated pixels with about the hue of the colour.
int countPixelsOfHue(const QImage &image, const QColor &wanted)
{
    int count = 0;
    for (int i = 0; i < image.width() * image.height(); ++i) {
        const QColor pixel = image.pixelColor(i % image.width(), i / image.width());
        count += std::abs(pixel.hue() - wanted.hue()) < 10 && pixel.saturation() > 60 ? 1 : 0;
    }
    return count;
}

class TestPlotGrid : public QObject
{
    Q_OBJECT

private slots:
    void paintsAllNineInTheColoursOfThePalette()
    {
        ShownGrid shown({.reference = referenceOf(65.0)});
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            shown.grid.setPalette(paletteFor(theme));
            settle();
            const SeriesColours colours = seriesColours(paletteFor(theme));
            for (const QString &name : PlotGrid::plotNames()) {
                const bool isError = name.contains("error");
                const QImage image = shown.grid.grab(shown.pane(name).geometry()).toImage();
                QVERIFY2(countPixelsOfHue(image, isError ? colours.sliderError : colours.model) > 50, qPrintable(name));
                QVERIFY2(countPixelsOfHue(image, isError ? colours.couplerError : colours.reference) > 50,
                         qPrintable(name));
                QCOMPARE(image.pixelColor(1, 1), colours.background);
                QVERIFY(!shown.pane(name).accessibleName().isEmpty());
                QVERIFY(!shown.pane(name).accessibleDescription().isEmpty());
            }
            QCOMPARE(shown.grid.grab().toImage().pixelColor(1, 1), colours.background);
        }
    }

    void severalResultsMakeOneRepaintAndNoneWhileHidden()
    {
        ShownGrid shown;
        shown.repaints = 0;
        for (const double b : {61.0, 62.0, 63.0}) {
            shown.grid.setResult(resultOf({withCoupler(b)}));
        }
        settle();
        QCOMPARE(shown.repaints, 6); // without a reference there are no errors
        shown.grid.hide();
        shown.repaints = 0;
        shown.show({withCoupler(64.0)});
        QCOMPARE(shown.repaints, 0);
        shown.grid.show();
        settle();
        QVERIFY(shown.repaints >= 6);
    }

    void valuesStandBesideTheirDots()
    {
        // In all rows of a figure of six plots, every value has room next to its dot.
        constexpr double kFarInHeights = 2.5; // heights of a value, between its centre and its dot
        ShownGrid shown;
        for (const double t : {0.1, 0.25, 0.5, 0.8}) {
            shown.setTime(t);
            int values = 0;
            for (PlotPane *pane : shown.grid.findChildren<PlotPane *>()) {
                for (const PlotCursor &cursor : pane->cursors()) {
                    const PlotCursor::Label &label = cursor.labels.at(0);
                    const double distance = std::abs(label.place.center().y() - label.dot->y());
                    QVERIFY2(distance < kFarInHeights * label.place.height(), qPrintable(pane->objectName()));
                    ++values;
                }
            }
            QCOMPARE(values, 6);
        }
    }

    void everyCurveHasADotAndItsValueAtTheCurrentTime()
    {
        ShownGrid shown({.reference = referenceOf(65.0), .pinned = {withCoupler(80.0)}});
        shown.setTime(0.1);
        shown.repaints = 0;
        const QColor line = seriesColours(shown.grid.palette()).cursor;
        for (const double t : {0.25, 0.75}) {
            shown.setTime(t);
            QCOMPARE(shown.repaints, 0);
            for (PlotPane *pane : shown.grid.findChildren<PlotPane *>()) {
                const PlotCursor &cursor = pane->cursors().at(0);
                QCOMPARE(cursor.labels.size(), pane->objectName().contains("error") ? 2U : 3U);
                QVERIFY(std::abs(cursor.x - shown.at(pane->objectName(), t).x()) < 2.0);
                const QImage image = pane->grab().toImage();
                const auto colourAt = [&](int y) { return image.pixelColor(static_cast<int>(cursor.x), y); };
                // a dot or a value may be at one end of the line
                QVERIFY(colourAt(pane->axes().bottom() - 1) == line || colourAt(pane->axes().top() + 1) == line);
            }
            shown.repaints = 0;
        }
        QCOMPARE(shown.mostRectangles, 1); // Qt paints a region of several much slower
        for (const double b : {60.0, 65.0, 80.0}) {
            const QString value = QString::number(positionsAt(0.75, b)[1], 'f', 2);
            QVERIFY(textOf(shown.pane(kSlider)).split(u'\n').contains(value));
        }
        shown.setTime(1.5);
        QVERIFY(shown.pane(kSlider).cursors().empty());
    }

    /// A former defect: where the numbers of an axis became narrower, the line moved by some pixels as if the motion
    /// was played, and the value of the lower dot stayed above that of the upper one.
    void valuesChangeTheirPlacesWithTheAxes()
    {
        const QPixmap none;
        PlotPane pane(none, nullptr);
        const auto isRedAboveBlue = [&pane](const QRect &axes, double redDot, double blueDot) {
            PlotCursor cursor{axes.left() + 1.0};
            cursor.labels.push_back({QStaticText("22.62"), Qt::red, QPointF(cursor.x, redDot)});
            cursor.labels.push_back({QStaticText("24.62"), Qt::blue, QPointF(cursor.x, blueDot)});
            pane.setCursors({cursor}, axes);
            const std::vector<PlotCursor::Label> &labels = pane.cursors().front().labels;
            const auto topOf = [&labels](const QColor &colour) {
                return std::ranges::find(labels, colour, &PlotCursor::Label::colour)->place.top();
            };
            return topOf(Qt::red) < topOf(Qt::blue);
        };
        QVERIFY(isRedAboveBlue({56, 20, 200, 160}, 100.0, 106.0));
        QVERIFY(!isRedAboveBlue({50, 20, 206, 160}, 106.0, 100.0));
    }

    void hoveringShowsALighterCursorInAllNinePlots()
    {
        for (const QSize size : {QSize(960, 570), QSize(585, 595), QSize(420, 230)}) {
            ShownGrid shown({.reference = referenceOf(65.0)}, size);
            shown.setTime(0.1);
            shown.repaints = 0;
            for (const double part : {0.02, 0.98, 0.5}) {
                QTest::mouseMove(&shown.pane(kAngle), shown.at(kAngle, part));
                settle();
                for (const PlotPane *pane : shown.grid.findChildren<PlotPane *>()) {
                    QVERIFY(pane->cursors().size() == 2 && pane->cursors()[1].followsPointer &&
                            !pane->cursors()[0].followsPointer);
                    QCOMPARE(pane->cursors()[1].labels.size(), std::size_t(pane == &shown.pane(kAngle) ? 4 : 2));
                    for (const PlotCursor &cursor : pane->cursors()) {
                        for (const PlotCursor::Label &label : cursor.labels) {
                            const bool isCovered = !cursor.followsPointer && label.text.text().isEmpty();
                            QVERIFY(isCovered || QRectF(pane->rect()).contains(label.place));
                            for (const PlotCursor::Label &light : pane->cursors()[1].labels) {
                                QVERIFY(cursor.followsPointer || !label.place.intersects(light.place));
                            }
                        }
                    }
                }
            }
            QCOMPARE(shown.repaints, 0);
            for (const char *wanted : {"t = 0.5000 s", "Δt = 0.4000 s", "24.62", "22.62"}) {
                QVERIFY2(textOf(shown.pane(kAngle)).contains(QString::fromUtf8(wanted)), wanted);
            }
            shown.drag(kAngle, shown.at(kAngle, 0.4),
                       shown.at(kAngle, 0.6)); // zooms: then the pointer is at a different time
            QVERIFY(std::ranges::none_of(shown.pane(kAngle).cursors(), &PlotCursor::followsPointer));
            shown.grid.showAll();
            settle();
            QEvent leave(QEvent::Leave);
            QCoreApplication::sendEvent(&shown.grid, &leave);
            QCOMPARE(shown.pane(kAngle).cursors().size(), std::size_t(1));
        }
    }

    void sixPlotsFillTheFigureWithoutAReference()
    {
        ShownGrid shown;
        auto *hint = shown.grid.findChild<QLabel *>("no_reference_hint");
        QVERIFY(hint->isVisible() && !shown.pane(kErrors).isVisible());
        QVERIFY(std::abs(shown.pane(kAngle).width() - shown.grid.width() / 2) < 10);
        QSignalSpy requested(&shown.grid, &PlotGrid::openReferenceRequested);
        emit hint->linkActivated("open");
        QCOMPARE(requested.count(), 1);
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            QApplication::setPalette(paletteFor(theme));
            settle();
            QVERIFY(countPixels(hint->grab().toImage(), hint->palette().color(QPalette::Link)) > 20); // underlined
        }
        shown.show({.reference = referenceOf(65.0)});
        QVERIFY(!hint->isVisible() && shown.pane(kErrors).isVisible());
        QVERIFY(std::abs(shown.pane(kAngle).width() - shown.grid.width() / 3) < 10);
    }

    void axesOfAColumnAreAlignedAndDoNotMove()
    {
        ShownGrid shown({}, QSize(620, 480));
        const auto axes = [&](qsizetype plot) {
            const PlotPane &pane = shown.pane(PlotGrid::plotNames()[plot]);
            return pane.axes().translated(pane.pos());
        };
        const QRect before = axes(6);
        for (const double b : {46.0, 50.0, 60.0, 90.0, 150.0}) {
            shown.show({withCoupler(b)});
            QCOMPARE(axes(6), before);
            for (const qsizetype plot : {3, 4, 6, 7}) {
                QVERIFY(axes(plot).left() == axes(plot - 3).left() && axes(plot).width() == axes(plot - 3).width());
                QVERIFY(std::abs(axes(plot).height() - axes(plot - 3).height()) <= 2);
            }
        }
    }

    void theWheelZoomsAllTimeAxesOrOneAxisOfValuesAndKeysZoomTheTime()
    {
        ShownGrid shown({.reference = referenceOf(65.0)});
        shown.turnWheel(kSlider, shown.at(kSlider, 0.5), 3);
        QVERIFY(shown.time().length() < 0.7 && shown.time().contains(0.5));
        shown.show({withCoupler(61.0), referenceOf(65.0)}); // this does not change the zoom
        QVERIFY(shown.time().length() < 0.7);
        shown.turnWheel(kSlider, shown.at(kSlider, 0.5), -30);
        QVERIFY(!shown.grid.zoom().time);
        shown.turnWheel(kSlider, shown.at(kSlider, 0.0) - QPoint(10, 0), 2);
        QVERIFY(!shown.grid.zoom().time && shown.grid.zoom().values[1] && !shown.grid.zoom().values[0]);
        QTest::mouseDClick(&shown.pane(kSlider), Qt::LeftButton, {}, shown.at(kSlider, 0.5));
        QVERIFY(shown.grid.zoom() == PlotZoom());
        shown.setTime(0.25);
        QTest::keyClick(&shown.pane(kSlider), Qt::Key_Plus);
        QVERIFY(shown.time().length() < 0.8);
        QVERIFY(std::abs((0.25 - shown.time().lower) / shown.time().length() - 0.25) <
                1e-12); // zooming does not move the cursor
    }

    void shiftOrTheMiddleButtonPans()
    {
        ShownGrid shown;
        for (const auto &[button, modifiers] :
             {std::pair<Qt::MouseButton, Qt::KeyboardModifiers>{Qt::LeftButton, Qt::ShiftModifier},
              {Qt::MiddleButton, Qt::NoModifier}}) {
            shown.grid.setZoom({Interval{0.3, 0.5}, {}});
            settle();
            shown.drag(kAngle, shown.at(kAngle, 0.6), shown.at(kAngle, 0.4), DragEnd::Escape, button, modifiers);
            QCOMPARE(shown.time(), (Interval{0.3, 0.5})); // Escape
            shown.drag(kAngle, shown.at(kAngle, 0.6), shown.at(kAngle, 0.4), DragEnd::Release, button, modifiers);
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
        ShownGrid shown({.reference = referenceOf(65.0)});
        QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
        for (const Row &row : {Row{"a box", {0.2, 0.3}, {0.6, 0.8}, true, true},
                               Row{"the other way", {0.6, 0.8}, {0.2, 0.3}, true, true},
                               Row{"beyond the axes", {0.2, 0.3}, {1.2, 1.5}, true, true},
                               Row{"a flat one", {0.2, 0.5}, {0.6, 0.51}, true, false},
                               Row{"along the time axis", {0.2, 1.02}, {0.6, 1.02}, true, false},
                               Row{"a narrow one", {0.5, 0.3}, {0.505, 0.8}, false, true},
                               Row{"along the axis of the values", {-0.05, 0.3}, {-0.05, 0.8}, false, true}}) {
            const QPoint from = shown.at(kErrors, row.from.x(), row.from.y());
            const QPoint to = shown.at(kErrors, row.to.x(), row.to.y());
            shown.drag(kErrors, from, to, DragEnd::Escape);
            QVERIFY2(shown.hasDrawnBox && shown.grid.zoom() == PlotZoom(), row.name);
            shown.drag(kErrors, from, to);
            QVERIFY2(!QWidget::keyboardGrabber() && !shown.box().isVisible(), row.name);
            QVERIFY2(shown.grid.zoom().time.has_value() == row.zoomsTime, row.name);
            QVERIFY2(shown.grid.zoom().values[5].has_value() == row.zoomsValues, row.name);
            if (row.zoomsTime) {
                QVERIFY(std::abs(shown.time().lower - 0.2) < 0.01);
                QVERIFY(std::abs(shown.time().upper - std::min(1.0, std::max(row.from.x(), row.to.x()))) < 0.01);
            }
            QTest::keyClick(&shown.pane(kErrors), Qt::Key_0);
            QVERIFY(shown.grid.zoom() == PlotZoom());
            settle();
        }
        QCOMPARE(requested.count(), 0); // a drag is no click
    }

    void aClickRequestsItsTimeAndWithAFileOneOfItsTimeStamps()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        ShownGrid shown({.reference = reference});
        QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
        QTest::mouseClick(&shown.pane(kErrors), Qt::LeftButton, {}, shown.at(kErrors, 0.255));
        QCOMPARE(requested.takeFirst()[0].toDouble(), reference->data.time[10]);
        QTest::mouseClick(&shown.pane(kAngle), Qt::LeftButton, {}, QPoint(3, 3)); // outside the axes
        QCOMPARE(requested.count(), 0);
    }

    void showTimePansAZoomedAxis()
    {
        ShownGrid shown({.reference = referenceOf(65.0)});
        shown.grid.setZoom({Interval{0.31, 0.69}, {}});
        shown.grid.showTime(0.5);
        QCOMPARE(shown.time(), (Interval{0.31, 0.69}));
        shown.grid.showTime(0.75);
        QVERIFY(std::abs(shown.time().lower - 0.56) < 1e-9 && std::abs(shown.time().length() - 0.38) < 1e-9);
        shown.grid.showAll();
        shown.grid.showTime(0.75);
        QVERIFY(!shown.grid.zoom().time);
    }

    void doubleClickOnATitleMaximizesItsPlotUntilEscape()
    {
        ShownGrid shown;
        const QSize small = shown.pane(kSlider).size();
        QTest::mouseDClick(&shown.pane(kSlider), Qt::LeftButton, {}, QPoint(60, 4));
        settle();
        QVERIFY(shown.pane(kSlider).width() > 1.8 * small.width() && !shown.pane(kAngle).isVisible());
        QCOMPARE(shown.grid.focusWidget(), &shown.pane(kSlider));
        QTest::keyClick(shown.grid.focusWidget(), Qt::Key_Escape);
        settle();
        QCOMPARE(shown.pane(kSlider).size(), small);
    }

    /// A former defect: the first of the two clicks moved the time.
    void doubleClickResetsTheZoomAndLeavesTheTime()
    {
        ShownGrid shown;
        shown.setTime(0.2);
        QSignalSpy requested(&shown.grid, &PlotGrid::timeRequested);
        QObject::connect(&shown.grid, &PlotGrid::timeRequested, &shown, [&shown](double t) { shown.setTime(t); });
        const QPoint place = shown.at(kSlider, 0.7);
        QTest::mouseClick(&shown.pane(kSlider), Qt::LeftButton, {}, place);
        QVERIFY(std::abs(requested.back()[0].toDouble() - 0.7) < 0.01);
        QTest::mouseDClick(&shown.pane(kSlider), Qt::LeftButton, {}, place);
        QCOMPARE(requested.back()[0].toDouble(), 0.2);
    }

    void errorsAreOfferedOnlyWhereSomethingIsCompared()
    {
        for (const PlotInput &content : {PlotInput(), PlotInput{.reference = referenceOf(65.0)}}) {
            ShownGrid shown(content);
            const auto isOffered = [](const QAction *choice) { return choice->isVisible(); };
            const auto offered = std::ranges::count_if(shown.grid.choices(), isOffered);
            QCOMPARE(offered, content.reference ? shown.grid.choices().size() : 1);
        }
    }

    void itsMenuCopiesValuesAndExportsThePlot()
    {
        ShownGrid shown;
        QSignalSpy requested(&shown.grid, &PlotGrid::exportPlotRequested);
        shown.setTime(0.25);
        const QPoint place = shown.pane(kSlider).mapTo(&shown.grid, QPoint(50, 50));
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, shown.grid.mapToGlobal(place));
        QCoreApplication::sendEvent(&shown.grid, &event);
        for (QAction *action : shown.grid.findChild<QMenu *>()->actions()) {
            if (action->text().contains("xport") || action->text().contains("alues here")) {
                action->trigger();
            }
        }
        QCOMPARE(requested.takeFirst()[0].toString(), kSlider);
        const QStringList cells = QApplication::clipboard()->text().split(u'\t');
        QCOMPARE(cells.size(), 2);
        QVERIFY(std::abs(cells[1].toDouble() - positionsAt(0.25, 60.0)[1]) < 1e-12);
    }

    void paintsANewResultAtOnceAfterACursorHasMoved()
    {
        ShownGrid shown;
        shown.setTime(0.3);
        shown.grid.setResult(resultOf({.model = withCoupler(70.0)}));
        const QImage atOnce = shown.grid.grab().toImage();
        settle();
        QCOMPARE(atOnce, shown.grid.grab().toImage());
    }

    /// Former defects: a long legend made the plots of a narrow figure low, and a figure whose last row is short had
    /// empty lines below it.
    void plotsOfAFigureKeepTheirProportions()
    {
        ShownGrid shown({.reference = referenceOf(65.0)});
        QFont font;
        font.setPixelSize(12);
        const int line = QFontMetrics(font).height();
        constexpr double kMinRatio = 0.4; // height of the axes over their width
        for (const FigureContent &content :
             {FigureContent{.plots = {5}}, FigureContent{.plots = {5}, .cursorTime = 0.13},
              FigureContent{.plots = {0, 1, 2, 3, 4}}, FigureContent{.cursorTime = 0.13}}) {
            for (const int width : {302, 605, 945}) {
                const QSize size(width, shown.grid.figureHeight(content, width, font));
                TextRecorder recorder(size);
                QPainter painter(&recorder);
                painter.setFont(font);
                shown.grid.paintFigure(painter, content, size, paletteFor(Theme::Light));
                painter.end();
                const QCPAxisRect &axes = *shown.grid.shownPlot(shown.grid.plots().front()).axes;
                QVERIFY2(axes.height() > kMinRatio * axes.width(), qPrintable(QString::number(axes.height())));
                double lowest = 0.0;
                for (const auto &[text, box] : recorder.texts) {
                    lowest = std::max(lowest, box.bottom());
                }
                QVERIFY2(lowest > size.height() - line, qPrintable(QString::number(size.height() - lowest)));
            }
        }
    }

    void anExportedFigureLeavesTheScreenAsItWas()
    {
        ShownGrid shown({.reference = referenceOf(65.0)});
        const QImage before = shown.grid.grab().toImage();
        for (const FigureContent &content :
             {FigureContent(), FigureContent{.plots = {1}}, FigureContent{.time = Interval{0.2, 0.6}}}) {
            TextRecorder recorder({900, 700});
            QPainter painter(&recorder);
            shown.grid.paintFigure(painter, content, {900, 700}, paletteFor(Theme::Light));
            painter.end();
            QString text;
            for (const auto &[part, place] : recorder.texts) {
                text += part;
            }
            for (const char *wanted : {"model", "simulation.csv", "t [s]"}) {
                QVERIFY2(text.contains(QLatin1String(wanted)), qPrintable(text));
            }
            QCOMPARE(text.contains("0.8"), !content.time); // a number on the time axis
        }
        QCOMPARE(shown.grid.grab().toImage(), before);
    }
};

const Suite<TestPlotGrid> suite("tst_plot_grid");

} // namespace tst_plot_grid

#include "tst_plot_grid.moc"
