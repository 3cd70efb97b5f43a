// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"
#include "tests/ui/plots/plot_results.h"
#include "ui/plots/plot_drawing.h"
#include "ui/plots/plot_figure.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/extremes.h"
#include "core/mechanism/turn.h"

#include <QImage>
#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace tst_true_curves
{

constexpr std::array<std::size_t, 6> kMotionPlots{0, 1, 3, 4, 6, 7};

/// The cells, a quarter of a pixel in size, through which the exact motion passes in a plot and slightly beyond the
/// plot. The motion is evaluated at many times in each column of cells. If a column contains more than a turn, only one
/// turn is evaluated.
class MotionCells
{
public:
    MotionCells(const Result &result, std::size_t channel, const Plot &plot)
        : m_motion(result.mechanism)
        , m_channel(channel)
        , m_plot(plot)
        , m_columns(kPerPixel * (plot.axes->width() + 2 * kMargin))
        , m_rows(kPerPixel * (plot.axes->height() + 2 * kMargin))
        , m_passed(m_columns * m_rows, '\0')
    {
        const Parameters &p = result.mechanism.parameters();
        const double speed = std::abs(p.omega2);
        const auto [start, end] =
            std::minmax({result.sampling.start, result.sampling.start + result.sampling.duration});
        // Near a toggle, the features of the motion are about this wide (rad).
        const double width = std::sqrt(2.0 * std::abs(p.b - p.a - std::abs(p.c)) / p.a);
        const double stepsPerRadian = 30.0 / std::clamp(width, 0.01, 0.3);
        int turnColumn = -1; // the first column that contains a turn
        for (int column = 0; column < m_columns; ++column) {
            const double from = std::max(start, timeAt(column));
            const double to = std::min(end, timeAt(column + 1));
            const bool containsTurn = speed * (to - from) > kTurn;
            if (containsTurn && turnColumn >= 0) {
                std::copy_n(m_passed.begin() + cell(turnColumn, 0), m_rows, m_passed.begin() + cell(column, 0));
            } else if (from <= to) {
                turnColumn = containsTurn ? column : turnColumn;
                const int steps = containsTurn ? 20'000 : 12 + static_cast<int>(stepsPerRadian * speed * (to - from));
                markValues(column, from, containsTurn ? from + kTurn / speed : to, steps);
            }
        }
    }

    bool isEmpty() const { return !m_passed.contains('\1'); }

    /// Whether the motion comes within `distance` (px) of the pixel at x, y of the plot.
    bool isNear(int x, int y, double distance) const
    {
        const int reach = static_cast<int>(distance * kPerPixel);
        for (int column = -reach; column <= reach; ++column) {
            for (int row = -reach; row <= reach; ++row) {
                if (column * column + row * row <= reach * reach &&
                    isPassed(kPerPixel * (x + kMargin) + column, kPerPixel * (y + kMargin) + row)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Returns a pixel that the motion passes although neither the pixel nor any of its neighbours is painted.
    std::optional<QPoint> missingPixel(const auto &isPainted) const
    {
        const QRect inside(1, 1, m_plot.axes->width() - 2, m_plot.axes->height() - 2);
        for (qsizetype cell = m_passed.indexOf('\1'); cell >= 0; cell = m_passed.indexOf('\1', cell + 1)) {
            const QPoint pixel(pixelOf(static_cast<int>(cell) / m_rows), pixelOf(static_cast<int>(cell) % m_rows));
            bool isSeen = !inside.contains(pixel) || isPainted(pixel.x(), pixel.y());
            for (int i = 0; i < 9 && !isSeen; ++i) {
                isSeen = isPainted(pixel.x() + i % 3 - 1, pixel.y() + i / 3 - 1);
            }
            if (!isSeen) {
                return pixel;
            }
        }
        return std::nullopt;
    }

private:
    static constexpr int kPerPixel = 4; // cells along the side of a pixel
    static constexpr int kMargin = 4;   // px, beyond the axes

    int cell(int column, int row) const { return column * m_rows + row; }
    bool isPassed(int column, int row) const { return m_passed[cell(column, row)] != 0; }
    int pixelOf(int columnOrRow) const { return (columnOrRow + kPerPixel / 2) / kPerPixel - kMargin; }
    double timeAt(int column) const
    {
        return m_plot.timeAxis->pixelToCoord(m_plot.axes->left() - kMargin + double(column) / kPerPixel);
    }
    int rowAt(double value) const
    {
        const double y =
            m_plot.valueAxis->coordToPixel(std::clamp(toFileUnit(kPlottedChannels[m_channel], value), -1e200, 1e200));
        return static_cast<int>(
            std::clamp(std::round(kPerPixel * (y - m_plot.axes->top() + kMargin)), -1.0, double(m_rows)));
    }

    /// Marks the values between two times in the column, from samples in equal steps.
    void markValues(int column, double from, double to, int steps)
    {
        std::vector<double> times(static_cast<std::size_t>(steps) + 1);
        for (std::size_t i = 0; i < times.size(); ++i) {
            times[i] = from + (to - from) * static_cast<double>(i) / steps;
        }
        std::vector<double> values(times.size());
        std::vector<Status> statuses(times.size());
        PlottedColumns columns{};
        columns[m_channel] = values.data();
        m_motion.evaluate(times, columns, statuses);
        const auto exists = [](double value) { return std::isfinite(value); };
        for (auto end = values.begin(); end != values.end();) {
            const auto begin = std::find_if(end, values.end(), exists);
            end = std::find_if_not(begin, values.end(), exists);
            if (begin == end) {
                return;
            }
            const auto [least, greatest] = std::minmax_element(begin, end);
            mark(column, *least, *greatest);
            const double *first = times.data() + (begin - values.begin());
            const double *next = times.data() + (end - values.begin());
            if (begin != values.begin()) {
                mark(column, *begin, lastValue(first[0], first[-1]));
            }
            if (end != values.end()) {
                mark(column, end[-1], lastValue(next[-1], next[0]));
            }
        }
    }

    /// Marks the cells of the column from one value to the other.
    void mark(int column, double first, double second)
    {
        const auto [top, bottom] = std::minmax({rowAt(first), rowAt(second)});
        char *rows = m_passed.data() + cell(column, 0);
        std::fill(rows + std::max(0, top), rows + std::min(bottom + 1, m_rows), '\1');
    }

    /// Returns the value at the limit of an oscillating crank, between a time at which the motion exists and one at
    /// which it does not. Derivatives are infinite there.
    double lastValue(double existing, double missing) const
    {
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (existing + missing);
            (std::isfinite(valueAt(middle)) ? existing : missing) = middle;
        }
        const double last = valueAt(existing);
        return kPlottedChannels[m_channel].order == Order::Position ? last : std::copysign(kInfinity, last);
    }

    double valueAt(double t) const { return m_motion.motionAt(t).plotted()[m_channel]; }

    ClosedForm m_motion;
    std::size_t m_channel;
    const Plot &m_plot;
    int m_columns;
    int m_rows;
    QByteArray m_passed; ///< 1 for each cell that the motion passes
};

/// The six plots of the motion, with curves but without axes and grid.
struct BareFigure {
    void show(const std::shared_ptr<const Result> &result, const PlotZoom &zoom = {})
    {
        figure.setResult(result);
        figure.setZoom(zoom);
        figure.compose({{kMotionPlots.begin(), kMotionPlots.end()}, QFont(), paletteFor(Theme::Light)}, {720, 480});
        for (const std::size_t plot : kMotionPlots) {
            for (QCPAxis *axis : figure.shownPlot(plot).axes->axes()) {
                axis->grid()->setVisible(false);
                axis->setBasePen(Qt::NoPen);
                axis->setTickPen(Qt::NoPen);
            }
        }
        QPixmap pixmap(720, 480);
        figure.drawInto(pixmap);
        picture = pixmap.toImage().convertToFormat(QImage::Format_Grayscale8);
    }

    /// Returns what is wrong with a plot; empty if nothing is.
    QString fault(std::size_t plot) const
    {
        const Plot &shown = figure.shownPlot(plot);
        const MotionCells motion(*figure.result(), channelIndex(plot), shown);
        if (!shown.values) {
            return motion.isEmpty() ? QString() : "it is said not to exist";
        }
        const int paper = qGray(colours.background.rgb());
        const int painted = paper - static_cast<int>(0.3 * (paper - qGray(colours.model.rgb())));
        const QImage axes = picture.copy(shown.axes->rect());
        const auto isPainted = [&](int x, int y) { return axes.constScanLine(y)[x] <= painted; };
        for (int y = 0; y < axes.height(); ++y) {
            for (int x = 0; x < axes.width(); ++x) {
                constexpr double kHalfPen = 1.0; // px
                if (isPainted(x, y) && !motion.isNear(x, y, kHalfPen + 1.0)) {
                    return QStringLiteral("pixel %1, %2 is far from the motion").arg(x).arg(y);
                }
            }
        }
        const std::optional<QPoint> missing = motion.missingPixel(isPainted);
        return missing ? QStringLiteral("the motion at pixel %1, %2 is not painted").arg(missing->x()).arg(missing->y())
                       : QString();
    }

    SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    PlotFigure figure;
    QImage picture;
};

Parameters turningAt(double turnsPerSecond)
{
    Parameters parameters;
    parameters.omega2 = kTurn * turnsPerSecond;
    return parameters;
}

/// A curve of the model shows the exact motion at every speed, duration and number of steps.
class TestTrueCurves : public QObject
{
    Q_OBJECT

private slots:
    void paintsExactlyThePixelsOfTheMotion()
    {
        RandomMechanisms random(8);
        BareFigure shown;
        for (int i = 0; i < numericCaseCount(40, 3000); ++i) {
            Parameters p = random.next();
            if (i % 4 == 1) { // oscillating cranks, some of two arcs
                const double shortest = std::max(0.0, std::abs(p.c) - p.a);
                p.b = shortest + random.uniform(0.02, 0.98) * (p.a + std::abs(p.c) - shortest);
            } else if (i % 4 == 2) { // near a toggle
                p.b = (p.a + std::abs(p.c)) * (1.0 + std::pow(10.0, random.uniform(-4.0, -1.0)));
            }
            p.omega2 = std::copysign(std::exp(random.uniform(std::log(0.1), std::log(1e4))), p.omega2);
            Sampling sampling;
            sampling.start = random.uniform(-1.0, 1.0);
            sampling.duration = std::exp(random.uniform(std::log(1e-2), std::log(1e2)));
            sampling.steps = static_cast<int>(std::exp(random.uniform(std::log(2.0), std::log(1e6))));
            PlotZoom zoom;
            if (i % 3 == 0) {
                const double from = sampling.start + random.uniform(0.0, 0.9) * sampling.duration;
                zoom.time = Interval{from, from + 0.1 * sampling.duration};
            }
            shown.show(resultOf({.model = p, .sampling = sampling}), zoom);
            for (const std::size_t plot : kMotionPlots) {
                const QString fault = shown.fault(plot);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(QStringLiteral("mechanism %1, %2: %3").arg(i).arg(plotName(plot), fault)));
            }
        }
    }

    /// The 200 steps of one second are four per turn at 3000 rpm and two at 6000 rpm.
    void axesReachThePeaks()
    {
        for (const double turnsPerSecond : {1.0, 50.0, 100.0, 1000.0}) {
            const Parameters p = turningAt(turnsPerSecond);
            BareFigure shown;
            shown.show(resultOf({.model = p}));
            for (const Peak &peak : motionPeaks(Mechanism(p))) {
                const auto channel = std::ranges::find(kPlottedChannels, peak.channel) - kPlottedChannels.begin();
                const Interval axis = *shown.figure.shownPlot(kMotionPlots[static_cast<std::size_t>(channel)]).values;
                for (const PeakPoint &point : peak.points) {
                    QVERIFY(axis.contains(toFileUnit(peak.channel, point.value)));
                }
                QVERIFY(std::max(-axis.lower, axis.upper) <= 1.3 * toFileUnit(peak.channel, peak.magnitude));
            }
        }
    }

    /// With Newton-Raphson only the samples are known.
    void fewSamplesAreNotConnectedAndTheLegendWarns()
    {
        const auto resultWith = [](double turns, int steps, Method method) {
            return resultOf({.model = turningAt(turns), .sampling = {0.0, 1.0, steps}, .method = method});
        };
        BareFigure shown;
        const auto curveOf = [&shown](const std::shared_ptr<const Result> &result) {
            shown.show(result);
            return shown.figure.shownPlot(0).curves.front();
        };
        const std::shared_ptr<const Result> sparse = resultWith(50.0, 200, Method::Newton);
        const PlotCurve dots = curveOf(sparse);
        QCOMPARE(dots.name, "4 samples per revolution are too few for a curve: at least 20 are needed.");
        QVERIFY(dots.points.empty());
        const std::vector<double> &samples = sparse->trajectory[kPlottedChannels[0]];
        QVERIFY(std::ranges::equal(dots.dots, samples, {}, &CurvePoint::value));

        const PlotCurve line = curveOf(resultWith(50.0, 1000, Method::Newton));
        QVERIFY(!line.points.empty() && line.name == "model");
        const PlotCurve band = curveOf(resultWith(5000.0, 1000, Method::Newton)); // samples so dense look like a band
        QVERIFY(!band.points.empty());
        QCOMPARE(curveOf(resultWith(50.0, 2, Method::ClosedForm)).name, "model");
    }

    void aLongMotionInClosedFormIsCountedButNotStored()
    {
        for (const double b : {65.0, 40.0, 45.0, 4.0}) {
            const Sampling sampling{0.0, 2.0, 120'000};
            const std::shared_ptr<const Result> result = resultOf({.model = withCoupler(b), .sampling = sampling});
            QVERIFY(result->trajectory.time.empty());
            const Trajectory whole =
                sample(result->mechanism, sampling.timeStamps(), plottedChannels(), result->solver);
            QVERIFY(result->summary == whole.summary);
        }
    }
};

const Suite<TestTrueCurves> suite("tst_true_curves");

} // namespace tst_true_curves

#include "tst_true_curves.moc"
