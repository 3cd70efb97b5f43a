// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/waiting.h"
#include "ui/document/result.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/theme.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/extremes.h"

#include <QImage>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kTurnAngle = 2.0 * std::numbers::pi;
constexpr double kHalfPen = 1.0; // px
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPerPixel = 4; // what is looked at apart in a pixel column

std::shared_ptr<const Result> resultOf(const Parameters &parameters, const Sampling &sampling,
                                       Method method = Method::ClosedForm)
{
    SolverSettings solver;
    solver.method = method;
    solver.newton.elimination = Elimination::Structured;
    return compute({Mechanism(parameters), sampling, solver, nullptr}, {});
}

double valueAt(const ClosedForm &motion, std::size_t channel, double t)
{
    const Motion m = motion.motionAt(t);
    const std::array<double, 6> values{m.theta3, m.R4x, m.theta3Dot, m.R4xDot, m.theta3DDot, m.R4xDDot};
    return m.status == Status::Solved || m.status == Status::Singular
               ? toFileUnit(kPlottedChannels[channel], values[channel])
               : std::numeric_limits<double>::quiet_NaN();
}

/// What the motion passes within a quarter of a pixel column, in pixels from the top.
struct Passed {
    std::vector<Interval> rows;

    void add(double one, double other)
    {
        Interval row{std::min(one, other), std::max(one, other)};
        std::erase_if(rows, [&row](const Interval &known) {
            const bool meets = known.lower <= row.upper && row.lower <= known.upper;
            if (meets) {
                row = {std::min(row.lower, known.lower), std::max(row.upper, known.upper)};
            }
            return meets;
        });
        rows.push_back(row);
    }
};

/// The motion over the axes of a plot, looked at densely: at many instants of each quarter of a pixel column; where
/// that holds more than a turn, at as many of one turn.
class Truth
{
public:
    Truth(const Result &result, std::size_t channel, const QCPAxisRect &plot)
        : m_axes(plot.rect())
        , m_passed(static_cast<std::size_t>(kPerPixel * (m_axes.width() + 2 * kMargin)))
    {
        const ClosedForm motion(result.mechanism);
        const double speed = std::abs(result.mechanism.omega2());
        const Sampling &run = result.sampling;
        const double runEnd = run.start + run.duration;
        // Beside a toggle what happens is as narrow as the root of what the coupler has to spare.
        const Parameters &p = result.mechanism.parameters();
        const double width = std::sqrt(2.0 * std::abs(p.b - p.a - std::abs(p.c)) / p.a);
        const double looksPerRadian = 30.0 / std::clamp(width, 0.01, 0.3);
        Passed ofATurn;
        const auto rowOf = [&plot](double value) {
            return std::isinf(value) ? -1e9 * value
                                     : std::clamp(plot.axis(QCPAxis::atLeft)->coordToPixel(value), -1e9, 1e9);
        };
        for (std::size_t i = 0; i < m_passed.size(); ++i) {
            double from = plot.axis(QCPAxis::atBottom)->pixelToCoord(xOf(i));
            double to = plot.axis(QCPAxis::atBottom)->pixelToCoord(xOf(i + 1));
            from = std::max(from, std::min(run.start, runEnd));
            to = std::min(to, std::max(run.start, runEnd));
            if (!(from <= to)) {
                continue;
            }
            const bool holdsTurns = speed * (to - from) > kTurnAngle;
            if (holdsTurns && !ofATurn.rows.empty()) {
                m_passed[i] = ofATurn;
                continue;
            }
            const int looks = holdsTurns ? 20'000 : 12 + static_cast<int>(looksPerRadian * speed * (to - from));
            const double end = holdsTurns ? from + kTurnAngle / speed : to;
            double before = valueAt(motion, channel, from);
            for (int look = 1; look <= looks; ++look) {
                const double t = from + (end - from) * look / looks;
                const double value = valueAt(motion, channel, t);
                if (std::isfinite(before) && std::isfinite(value)) {
                    m_passed[i].add(rowOf(before), rowOf(value));
                } else if (std::isfinite(before) != std::isfinite(value)) {
                    const double tBefore = from + (end - from) * (look - 1) / looks;
                    const double last = std::isfinite(before) ? lastValue(motion, channel, tBefore, t)
                                                              : lastValue(motion, channel, t, tBefore);
                    const bool isBounded = kPlottedChannels[channel].order == Order::Position;
                    m_passed[i].add(rowOf(std::isfinite(before) ? before : value),
                                    rowOf(isBounded ? last : std::copysign(kInfinity, last)));
                }
                before = value;
            }
            if (holdsTurns) {
                ofATurn = m_passed[i];
            }
        }
    }

    bool isEmpty() const
    {
        return std::ranges::all_of(m_passed, [](const Passed &passed) { return passed.rows.empty(); });
    }

    /// How far (px) a pixel is from what the motion passes.
    double distance(int x, int y) const
    {
        constexpr int kReach = 4; // px
        double nearest = kInfinity;
        for (int i = kPerPixel * (x - m_axes.left() + kMargin - kReach);
             i <= kPerPixel * (x - m_axes.left() + kMargin + kReach); ++i) {
            if (i < 0 || i >= static_cast<int>(m_passed.size())) {
                continue;
            }
            const auto index = static_cast<std::size_t>(i);
            const double dx = std::max({0.0, xOf(index) - x, x - xOf(index + 1)});
            for (const Interval &row : m_passed[index].rows) {
                const double dy = std::max({0.0, row.lower - y, y - row.upper});
                nearest = std::min(nearest, std::hypot(dx, dy));
            }
            if (nearest == 0.0) {
                return nearest;
            }
        }
        return nearest;
    }

    /// visit(x, y) for a pixel of each row that the motion passes within the axes.
    template <class Visit>
    void visitPixels(const Visit &visit) const
    {
        for (std::size_t i = 0; i < m_passed.size(); ++i) {
            const double x = 0.5 * (xOf(i) + xOf(i + 1));
            if (x < m_axes.left() + 1 || x > m_axes.right() - 1) {
                continue;
            }
            for (const Interval &row : m_passed[i].rows) {
                const double top = std::max(row.lower, m_axes.top() + 1.0);
                const double bottom = std::min(row.upper, m_axes.bottom() - 1.0);
                for (double y = top; y <= bottom; y += 1.0) {
                    visit(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
                }
                if (top <= bottom) {
                    visit(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(bottom)));
                }
            }
        }
    }

private:
    static constexpr int kMargin = 4; // px, beyond the axes

    double xOf(std::size_t i) const { return m_axes.left() - kMargin + static_cast<double>(i) / kPerPixel; }

    /// Beside the limit of a rocker between an instant at which it is there and one at which it is not.
    static double lastValue(const ClosedForm &motion, std::size_t channel, double there, double notThere)
    {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (there + notThere);
            (std::isfinite(valueAt(motion, channel, middle)) ? there : notThere) = middle;
        }
        return valueAt(motion, channel, there);
    }

    QRect m_axes;
    std::vector<Passed> m_passed;
};

/// The six plots of the motion with nothing but their curves.
struct BareFigure {
    explicit BareFigure(const std::shared_ptr<const Result> &result) { show(result); }

    void show(const std::shared_ptr<const Result> &result, const PlotZoom &zoom = {})
    {
        figure.setPlots({0, 1, 3, 4, 6, 7}, PlotFonts(QFont()), colours);
        figure.setResult(result);
        figure.zoom = zoom;
        figure.show(size);
        for (const std::size_t index : figure.plots()) {
            for (QCPAxis *axis : axes(index).axes()) {
                axis->grid()->setVisible(false);
                axis->setBasePen(Qt::NoPen);
                axis->setTickPen(Qt::NoPen);
            }
        }
        QPixmap pixmap(size);
        figure.drawInto(pixmap);
        picture = pixmap.toImage();
    }

    const QCPAxisRect &axes(std::size_t index) const { return *figure.plot(index).axes; }

    const QSize size{720, 480};
    SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    PlotFigure figure;
    QImage picture;
};

class Strength
{
public:
    Strength(const QColor &background, const QColor &curve)
        : m_background(background.lightnessF())
        , m_curve(curve.lightnessF())
    {
    }
    double of(const QColor &pixel) const { return (pixel.lightnessF() - m_background) / (m_curve - m_background); }

private:
    double m_background;
    double m_curve;
};

/// What is wrong with a plot; empty: nothing.
QString faultOf(const BareFigure &shown, const Result &result, std::size_t plot)
{
    const QImage &image = shown.picture;
    const QRect axes = shown.axes(plot).rect();
    const Strength strength(shown.colours.background, shown.colours.model);
    const Truth truth(result, channelOf(plot), shown.axes(plot));
    if (!shown.figure.plot(plot).values) {
        return truth.isEmpty() ? QString() : QStringLiteral("it is said not to exist");
    }
    constexpr double kPainted = 0.3;
    std::vector<bool> painted; // row by row
    for (int y = axes.top(); y <= axes.bottom(); ++y) {
        for (int x = axes.left(); x <= axes.right(); ++x) {
            painted.push_back(strength.of(image.pixelColor(x, y)) >= kPainted);
        }
    }
    const auto isPainted = [&](int x, int y) {
        return axes.contains(x, y) &&
               painted[static_cast<std::size_t>((y - axes.top()) * axes.width() + x - axes.left())];
    };
    for (int y = axes.top(); y <= axes.bottom(); ++y) {
        for (int x = axes.left(); x <= axes.right(); ++x) {
            if (isPainted(x, y) && !(truth.distance(x, y) <= kHalfPen + 1.0)) {
                return QStringLiteral("pixel %1, %2 is %3 px from the motion")
                    .arg(x - axes.left())
                    .arg(y - axes.top())
                    .arg(truth.distance(x, y));
            }
        }
    }
    QString fault;
    truth.visitPixels([&](int x, int y) {
        bool isNear = isPainted(x, y);
        for (int dx = -1; dx <= 1 && !isNear; ++dx) {
            for (int dy = -1; dy <= 1 && !isNear; ++dy) {
                isNear = isPainted(x + dx, y + dy);
            }
        }
        if (!isNear) {
            fault =
                QStringLiteral("the motion at pixel %1, %2 is not painted").arg(x - axes.left()).arg(y - axes.top());
        }
    });
    return fault;
}

} // namespace

/// A curve of the model is the motion, whatever the run's speed, duration and steps.
class TestTrueCurves : public QObject
{
    Q_OBJECT

private slots:
    void everyPaintedPixelIsOfTheMotionAndAllOfItIsPainted()
    {
        RandomMechanisms random(8);
        BareFigure shown(resultOf({}, {}));
        for (int i = 0; i < numericRuns(100, 3000); ++i) {
            Parameters p = random.next();
            if (i % 4 == 1) { // rockers, some of two arcs
                const double shortest = std::max(0.0, std::abs(p.c) - p.a);
                p.b = shortest + random.uniform(0.02, 0.98) * (p.a + std::abs(p.c) - shortest);
            } else if (i % 4 == 2) { // beside a toggle
                p.b = (p.a + std::abs(p.c)) * (1.0 + std::pow(10.0, random.uniform(-4.0, -1.0)));
            }
            p.omega2 = std::copysign(std::exp(random.uniform(std::log(0.1), std::log(1e4))), p.omega2);
            Sampling run;
            run.start = random.uniform(-1.0, 1.0);
            run.duration = std::exp(random.uniform(std::log(1e-2), std::log(1e2)));
            run.steps = static_cast<int>(std::exp(random.uniform(std::log(2.0), std::log(1e6))));
            PlotZoom zoom;
            if (i % 3 == 0) {
                const double from = random.uniform(0.0, 0.9);
                zoom.time = Interval{run.start + from * run.duration, run.start + (from + 0.1) * run.duration};
            }
            const std::shared_ptr<const Result> result = resultOf(p, run);
            shown.show(result, zoom);
            for (const std::size_t plot : shown.figure.plots()) {
                const QString fault = faultOf(shown, *result, plot);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(QStringLiteral("%1, %2: %3; a %4 b %5 c %6 ω %7 θ %8 %9, run %10 + "
                                                   "%11 in %12")
                                        .arg(i)
                                        .arg(plotName(plot), fault)
                                        .arg(p.a)
                                        .arg(p.b)
                                        .arg(p.c)
                                        .arg(p.omega2)
                                        .arg(p.theta20)
                                        .arg(p.branch == Branch::Open ? "open" : "crossed")
                                        .arg(run.start)
                                        .arg(run.duration)
                                        .arg(run.steps)));
            }
        }
    }

    /// With 200 steps: at 3000 rpm four to a turn, at 6000 rpm two.
    void axesReachThePeaks()
    {
        for (const double turnsPerMinute : {60.0, 3000.0, 6000.0, 60'000.0}) {
            Parameters p;
            p.omega2 = kTurnAngle * turnsPerMinute / 60.0;
            const BareFigure shown(resultOf(p, {}));
            const std::vector<Peak> peaks = motionPeaks(Mechanism(p));
            for (const std::size_t plot : shown.figure.plots()) {
                const auto peak = std::ranges::find(peaks, kPlottedChannels[channelOf(plot)], &Peak::channel);
                if (peak == peaks.end()) {
                    continue; // positions have no peak
                }
                const QCPRange axis = shown.axes(plot).axis(QCPAxis::atLeft)->range();
                for (const PeakPlace &place : peak->places) {
                    QVERIFY(axis.contains(toFileUnit(peak->channel, place.value)));
                }
                QVERIFY(std::max(-axis.lower, axis.upper) <= 1.3 * toFileUnit(peak->channel, peak->magnitude));
            }
        }
    }

    void stepsChangeNoPixel()
    {
        Parameters p;
        p.omega2 = kTurnAngle * 50.0;
        BareFigure shown(resultOf(p, {0.0, 1.0, 200}));
        const QImage before = shown.picture;
        for (const int steps : {2, 999, 1'000'000}) {
            shown.show(resultOf(p, {0.0, 1.0, steps}));
            QCOMPARE(shown.picture, before);
        }
    }

    /// Newton-Raphson's samples are what it found and no more.
    void samplesAreNotJoinedWhereTheyAreFew()
    {
        Parameters p;
        p.omega2 = kTurnAngle * 50.0;
        const auto curveOf = [&](int steps) {
            return BareFigure(resultOf(p, {0.0, 1.0, steps}, Method::Newton)).figure.plot(0).curves.front();
        };
        const std::shared_ptr<const Result> result = resultOf(p, {0.0, 1.0, 200}, Method::Newton);
        const PlotCurve few = curveOf(200);
        QVERIFY(few.points.empty());
        QCOMPARE(few.dots.size(), result->trajectory.time.size());
        for (std::size_t i = 0; i < few.dots.size(); ++i) {
            QCOMPARE(few.dots[i].value, result->trajectory[kPlottedChannels[0]][i]);
        }
        QVERIFY(!curveOf(1000).points.empty());
        p.omega2 *= 100.0; // so many turns that the samples are as good as a band
        QVERIFY(!curveOf(1000).points.empty());
    }

    /// At 6000 rpm the samples of 200 steps all show the same angle.
    void readsTheMotionAtTheInstantThatIsWritten()
    {
        Parameters p;
        p.omega2 = kTurnAngle * 100.0;
        PlotGrid grid;
        grid.resize(720, 480);
        grid.setResult(resultOf(p, {0.0, 1.0, 200}));
        grid.show();
        settle();
        const auto *pane = grid.findChild<PlotPane *>(plotName(0));
        const ClosedForm motion{Mechanism(p)};
        for (const int x : {11, 40, 77, 101}) {
            QTest::mouseMove(const_cast<PlotPane *>(pane), pane->axes().topLeft() + QPoint(x, 20));
            AWAIT(!pane->text().isEmpty());
            settle();
            const QStringList lines = pane->text().split(u'\n');
            const double t = lines[0].section(u' ', 2, 2).toDouble();
            const double value = lines.last().toDouble();
            QVERIFY(std::abs(t - static_cast<double>(x) / pane->axes().width()) <= 1.0 / pane->axes().width());
            QVERIFY2(std::abs(value - valueAt(motion, 0, t)) <= 6e-3, qPrintable(pane->text()));
        }
    }

    void aLongRunInClosedFormIsCountedButNotKept()
    {
        for (const double b : {65.0, 40.0, 45.0, 4.0}) {
            Parameters p;
            p.b = b;
            const Sampling run{0.0, 2.0, 120'000};
            const std::shared_ptr<const Result> result = resultOf(p, run);
            QVERIFY(!result->isKept());
            const Trajectory whole = sample(result->mechanism, run.instants(), plottedChannels(), result->solver);
            for (std::size_t i = 0; i < kStatusCount; ++i) {
                QCOMPARE(result->summary.statusCounts[i], whole.summary.count(static_cast<Status>(i)));
            }
        }
    }
};

QTEST_MAIN(TestTrueCurves)
#include "tst_true_curves.moc"
