// SPDX-License-Identifier: GPL-3.0-or-later

// The views are painted at the full resolution for every device pixel ratio (QT_SCALE_FACTOR; ctest uses 1, 1.5 and 2),
// also after the window was moved to a screen with another ratio. In a picture that was scaled up, some neighbouring
// columns of pixels hardly differ.

#include "tests/support/suite.h"
#include "tests/ui/window/window_fixture.h"

#include <QAbstractButton>
#include <QDir>
#include <QScreen>

#include <algorithm>
#include <array>
#include <cmath>

using namespace slidercrank;

namespace
{

/// Returns the largest differences in grey between a pixel and its right neighbour, by the column modulo 6. The pattern
/// of a picture that was scaled up repeats every two columns at a ratio of 2, and every three at 1.5.
std::array<int, 6> sharpestSteps(const QImage &picture)
{
    std::array<int, 6> sharpest{};
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x + 1 < picture.width(); ++x) {
            const int step = std::abs(qGray(picture.pixel(x + 1, y)) - qGray(picture.pixel(x, y)));
            int &largest = sharpest[static_cast<std::size_t>(x % 6)];
            largest = std::max(largest, step);
        }
    }
    return sharpest;
}

/// The configuration of Qt's offscreen platform: two screens, the right one with a device pixel ratio of 2.
constexpr const char *kScreens = R"({"synchronousWindowSystemEvents": true, "windowFrameMargins": false, "screens": [
    {"name": "left", "x": 0, "y": 0, "width": 2000, "height": 1200, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1},
    {"name": "right", "x": 2000, "y": 0, "width": 2000, "height": 1200, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 2}
]})";

/// The edges of the views that are checked. They contain only numbers and titles, and no moving parts.
const std::pair<QString, Qt::Edge> kEdges[] = {{"mechanismView", Qt::BottomEdge},
                                               {"plot_theta3", Qt::LeftEdge},
                                               {"plot_theta3_diff2", Qt::BottomEdge},
                                               {"iterationPlot", Qt::LeftEdge},
                                               {"iterationTable", Qt::LeftEdge}};

} // namespace

class TestSharpness : public WindowFixture
{
    Q_OBJECT

private:
    /// Moves the window to the screen.
    static void moveTo(const QScreen *screen, QWidget &window)
    {
        window.windowHandle()->setScreen(const_cast<QScreen *>(screen));
        window.move(screen->geometry().topLeft() + QPoint(10, 10));
        settle(window);
    }

    void moveTo(const QScreen *screen)
    {
        moveTo(screen, *m_window);
        QCOMPARE(m_window->devicePixelRatio(), screen->devicePixelRatio());
    }

    static QRect edgeOf(const QWidget &widget, Qt::Edge edge)
    {
        constexpr int kEdge = 26; // px, the height of numbers and a title
        return edge == Qt::BottomEdge ? QRect(0, widget.height() - kEdge, widget.width(), kEdge)
                                      : QRect(0, 0, 3 * kEdge, widget.height());
    }

    void checkSharpness(const QString &name, const QImage &picture)
    {
        const std::array<int, 6> sharpest = sharpestSteps(picture);
        const int largest = *std::max_element(sharpest.begin(), sharpest.end());
        QVERIFY(largest > 60); // the picture is not empty
        for (const int step : sharpest) {
            QVERIFY2(step > 0.6 * largest, qPrintable(QStringLiteral("%1: %2 of %3").arg(name).arg(step).arg(largest)));
        }
    }

private slots:
    void initTestCase()
    {
        openWindow();
        m_window->resize(1900, 1100); // large enough for many numbers on each edge
        openSample();
        showTab(3);
        part<QAbstractButton>("segment3")->click();
        settle(*m_window);
    }

    void cleanupTestCase() { m_window.reset(); }

    void hasTheRequestedRatio()
    {
        bool isRequested = false;
        const double requested = qEnvironmentVariable("QT_SCALE_FACTOR").toDouble(&isRequested);
        QCOMPARE(m_window->devicePixelRatio(), isRequested ? requested : 1.0);
    }

    void paintsAtFullResolution()
    {
        for (const auto &[name, edge] : kEdges) {
            const QRect area = edgeOf(*part(name), edge);
            const QImage picture = part(name)->grab(area).toImage();
            QCOMPARE(picture.size(), area.size() * m_window->devicePixelRatio());
            checkSharpness(name, picture);
        }
    }

    void paintsAtFullResolutionOnAnotherScreen()
    {
        const QList<QScreen *> screens = QGuiApplication::screens();
        QCOMPARE(screens.size(), 2);
        QWidget plain;
        plain.show();
        moveTo(screens[1], plain);
        if (plain.devicePixelRatio() != screens[1]->devicePixelRatio()) {
            QSKIP("This Qt's offscreen platform does not tell windows the ratio of another screen.");
        }
        for (const auto &[name, edge] : kEdges) {
            const QRect area = edgeOf(*part(name), edge);
            moveTo(screens[0]);
            const QImage before = part(name)->grab(area).toImage();
            moveTo(screens[1]);
            const QImage there = part(name)->grab(area).toImage();
            QCOMPARE(there.size(), area.size() * screens[1]->devicePixelRatio());
            checkSharpness(name, there);
            moveTo(screens[0]);
            QCOMPARE(part(name)->grab(area).toImage(), before);
        }
    }

    void detectsAPictureThatWasScaledUp()
    {
        const double ratio = m_window->devicePixelRatio();
        if (ratio == 1.0) {
            QSKIP("At a ratio of 1, nothing is scaled up.");
        }
        const QImage full = m_window->findChild<QWidget *>(QStringLiteral("mechanismView"))->grab().toImage();
        const QImage reduced = full.scaled(full.size() / ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        for (const Qt::TransformationMode mode : {Qt::FastTransformation, Qt::SmoothTransformation}) {
            const std::array<int, 6> blurred = sharpestSteps(reduced.scaled(full.size(), Qt::IgnoreAspectRatio, mode));
            const std::array<int, 6> sharp = sharpestSteps(full);
            QVERIFY(*std::min_element(blurred.begin(), blurred.end()) <
                    0.6 * *std::max_element(sharp.begin(), sharp.end()));
        }
    }
};

static int run(int argc, char *argv[])
{
    const QTemporaryDir folder;
    QFile screens(folder.filePath(QStringLiteral("screens.json")));
    if (!screens.open(QIODevice::WriteOnly) || screens.write(kScreens) < 0) {
        return EXIT_FAILURE;
    }
    screens.close();
    QDir::setCurrent(folder.path()); // the full path may contain a colon, which would end the option
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=screens.json");
    QApplication application(argc, argv);
    TestSharpness test;
    return QTest::qExec(&test, argc, argv);
}
const Suite suite("tst_sharpness", run);
#include "tst_sharpness.moc"
