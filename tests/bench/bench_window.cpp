// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the window: the time from moving a slider until nine plots are painted, the processor share of playing and
// of an idle window, the start and the memory. The figures in ui/README.md are measured with QT_QPA_PLATFORM=offscreen.
// SLIDERCRANK_BENCH_SIZE=1920x1080 and QT_SCALE_FACTOR=2 correspond to a large display.

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QPainter>
#include <QProcess>
#include <QSet>
#include <QSlider>
#include <QStandardPaths>
#include <QTimer>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

using namespace slidercrank;

namespace
{

/// Observes whether all visible plots have been painted since reset().
class PaintWatch : public QObject
{
public:
    explicit PaintWatch(QWidget &window)
        : m_panes(window.findChildren<PlotPane *>())
    {
        for (PlotPane *pane : m_panes) {
            pane->installEventFilter(this);
        }
    }

    void reset() { m_painted.clear(); }
    bool allPainted() const
    {
        return std::ranges::all_of(m_panes,
                                   [this](PlotPane *pane) { return pane->isHidden() || m_painted.contains(pane); });
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::Paint) {
            m_painted.insert(watched);
        }
        return false;
    }

private:
    QList<PlotPane *> m_panes;
    QSet<QObject *> m_painted;
};

void waitUntilPainted(const PaintWatch &watch)
{
    while (!watch.allPainted()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QCoreApplication::processEvents();
}

std::unique_ptr<MainWindow> openWindow()
{
    auto window = std::make_unique<MainWindow>();
    const QStringList size = qEnvironmentVariable("SLIDERCRANK_BENCH_SIZE").split(u'x');
    if (size.size() == 2) {
        window->resize(size[0].toInt(), size[1].toInt());
    }
    PaintWatch watch(*window);
    window->show();
    waitUntilPainted(watch);
    return window;
}

void handleEventsFor(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
    loop.exec();
}

double processorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

enum class ReferenceFile { None, Sample };

/// A window whose slider of b is moved. Each curve has `samples` samples, and the sample file may be open.
class MovingSlider
{
public:
    MovingSlider(int samples, ReferenceFile reference)
        : m_window(openWindow())
        , m_slider(m_window->findChild<QSlider *>(QStringLiteral("slider_b")))
        , m_watch(*m_window)
        , m_start(m_slider->value())
    {
        if (reference == ReferenceFile::Sample) {
            m_window->session().loadReference(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"));
            handleEventsFor(500); // until it has been read, compared and identified
        }
        Sampling sampling;
        sampling.steps = samples - 1;
        m_window->session().setSampling(sampling);
        move(); // makes pending results obsolete
    }

    /// Moves the slider and waits until all nine plots are painted.
    void move()
    {
        m_watch.reset();
        m_slider->setValue(m_start + 1 + ++m_moves % 20);
        waitUntilPainted(m_watch);
    }

    QSize plotsSize() const { return m_window->findChild<PlotGrid *>()->size(); }

private:
    std::unique_ptr<MainWindow> m_window;
    QSlider *m_slider;
    PaintWatch m_watch;
    int m_start;
    int m_moves = 0;
};

void moveSliderAndPaintNinePlots(benchmark::State &state)
{
    MovingSlider slider(static_cast<int>(state.range(0)), static_cast<ReferenceFile>(state.range(1)));
    for (auto _ : state) {
        slider.move();
    }
}
BENCHMARK(moveSliderAndPaintNinePlots)
    ->ArgNames({"samples", "reference"})
    ->ArgsProduct({{201, 20'001, 1'000'001}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->MinTime(1.0)
    ->Repetitions(5)
    ->ReportAggregatesOnly();

/// Compares the median time of MovingSlider::move() with that of a redraw by a plot library, which draws the same nine
/// plots from precomputed curves. Requires Python ($PYTHON, or python3) with that library.
void compareWithLibrary(benchmark::State &state, const char *library)
{
    constexpr int kMoves = 31;
    const int samples = static_cast<int>(state.range(0));
    MovingSlider slider(samples, ReferenceFile::Sample);
    std::vector<double> windowTimes; // ms
    QProcess python;
    const QString python3 = qEnvironmentVariable("PYTHON", QStringLiteral("python3"));
    for (auto _ : state) {
        for (int i = 0; i < kMoves; ++i) {
            QElapsedTimer clock;
            clock.start();
            slider.move();
            windowTimes.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        }
        python.start(python3,
                     {QStringLiteral(SLIDERCRANK_SOURCE_DIR "/tests/bench/nine_plots.py"), QLatin1String(library),
                      QString::number(samples), QString::number(slider.plotsSize().width()),
                      QString::number(slider.plotsSize().height()), QString::number(kMoves)});
        python.waitForFinished(-1);
    }
    if (python.exitStatus() != QProcess::NormalExit || python.exitCode() != 0) {
        state.SkipWithError("Cannot run Python with this library.");
        return;
    }
    std::nth_element(windowTimes.begin(), windowTimes.begin() + kMoves / 2, windowTimes.end());
    const double libraryTime = python.readAllStandardOutput().trimmed().toDouble();
    state.counters["ours_ms"] = windowTimes[kMoves / 2];
    state.counters["theirs_ms"] = libraryTime;
    state.counters["times"] = libraryTime / windowTimes[kMoves / 2];
}
BENCHMARK_CAPTURE(compareWithLibrary, matplotlib, "matplotlib")
    ->ArgName("samples")
    ->Arg(201)
    ->Arg(20'001)
    ->Arg(1'000'001)
    ->Iterations(1);
BENCHMARK_CAPTURE(compareWithLibrary, pyqtgraph, "pyqtgraph")
    ->ArgName("samples")
    ->Arg(201)
    ->Arg(20'001)
    ->Arg(1'000'001)
    ->Iterations(1);

/// Measures the processor share during three seconds, in percent of one core.
void processorShare(benchmark::State &state)
{
    const bool playing = state.range(0) != 0;
    const std::unique_ptr<MainWindow> window = openWindow();
    auto *timeline = window->findChild<Timeline *>();
    if (playing) {
        timeline->play();
    }
    handleEventsFor(500);
    for (auto _ : state) {
        const double before = processorSeconds();
        QElapsedTimer clock;
        clock.start();
        handleEventsFor(3000);
        const double elapsed = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
        state.counters["percent_of_a_core"] = 100.0 * (processorSeconds() - before) / elapsed;
    }
}
BENCHMARK(processorShare)->ArgName("playing")->Arg(1)->Arg(0)->Iterations(1)->Repetitions(3);

/// Measures one frame of playing, with the pose and nine cursors, without and with arrows, path, names and dimensions.
void playingFrame(benchmark::State &state)
{
    const std::unique_ptr<MainWindow> window = openWindow();
    if (state.range(0) != 0) {
        window->findChild<MechanismView *>()->setSettings(
            {.velocity = true, .acceleration = true, .path = true, .names = true, .dimensions = true});
    }
    double t = 0.0;
    for (auto _ : state) {
        t = t > 0.98 ? 0.0 : t + 0.0167; // s, 60 frames per second
        window->session().setTime(t);
        QCoreApplication::processEvents();
    }
}
BENCHMARK(playingFrame)->ArgName("arrows")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

const QString kProbe = QStringLiteral("--start-probe");

/// Runs in the process that startToNinthPlot() starts. Prints a line when the ninth plot is painted, and the resident
/// memory.
int startProbe()
{
    MainWindow window;
    PaintWatch watch(window);
    window.show();
    waitUntilPainted(watch);
    std::fputs("painted\n", stdout);
    std::fflush(stdout);
    QFile status(QStringLiteral("/proc/self/status")); // exists on Linux only
    if (status.open(QIODevice::ReadOnly)) {
        for (const QByteArray &line : status.readAll().split('\n')) {
            if (line.startsWith("VmRSS:")) {
                std::fputs((line + '\n').constData(), stdout);
            }
        }
    }
    return 0;
}

/// Measures the time from starting the program until its ninth plot is painted.
void startToNinthPlot(benchmark::State &state)
{
    double kibibytes = 0.0;
    for (auto _ : state) {
        QElapsedTimer clock;
        QProcess process;
        clock.start();
        process.start(QCoreApplication::applicationFilePath(), {kProbe});
        process.waitForReadyRead();
        state.SetIterationTime(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
        process.waitForFinished();
        for (const QByteArray &line : process.readAllStandardOutput().split('\n')) {
            if (line.startsWith("VmRSS:")) {
                kibibytes = line.simplified().split(' ').value(1).toDouble();
            }
        }
    }
    state.counters["resident_MB"] = kibibytes * 1024.0 / 1e6;
}
BENCHMARK(startToNinthPlot)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1)->Repetitions(21);

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QApplication::setStyle(QStringLiteral("Fusion"));
    if (QCoreApplication::arguments().contains(kProbe)) {
        return startProbe();
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
