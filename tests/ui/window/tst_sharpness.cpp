// SPDX-License-Identifier: GPL-3.0-or-later

// At every device pixel ratio (QT_SCALE_FACTOR; ctest runs it at 1, 1.5 and 2) what is painted is painted with all the
// pixels there are, not made larger from fewer: neighbouring pixels may differ as much as anywhere, wherever they are.
// Also on another screen, with twice the ratio, to which the window is moved.

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

/// The sharpest step in grey from a pixel to its right neighbour, by where in the pattern of a scaled picture the pair
/// is: of two columns at a ratio of 2, of three at 1.5. A picture scaled up has pairs that hardly differ.
std::array<int, 6> sharpestSteps(const QImage &picture)
{
    std::array<int, 6> sharpest{};
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x + 1 < picture.width(); ++x) {
            const int step = std::abs(qGray(picture.pixel(x + 1, y)) - qGray(picture.pixel(x, y)));
            int &most = sharpest[static_cast<std::size_t>(x % 6)];
            most = std::max(most, step);
        }
    }
    return sharpest;
}

/// Where Qt's offscreen platform shows windows: two screens, the right one with twice the pixels.
constexpr const char *kScreens = R"({"synchronousWindowSystemEvents": true, "windowFrameMargins": false, "screens": [
    {"name": "left", "x": 0, "y": 0, "width": 2000, "height": 1200, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1},
    {"name": "right", "x": 2000, "y": 0, "width": 2000, "height": 1200, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 2}
]})";

/// At the edges there are numbers only: what moves, and is painted over the rest, is not judged.
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
    /// As a person moves it.
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
        constexpr int kEdge = 26; // px, numbers and a title
        return edge == Qt::BottomEdge ? QRect(0, widget.height() - kEdge, widget.width(), kEdge)
                                      : QRect(0, 0, 3 * kEdge, widget.height());
    }

    void judge(const QString &name, const QImage &picture)
    {
        const std::array<int, 6> sharpest = sharpestSteps(picture);
        const int most = *std::max_element(sharpest.begin(), sharpest.end());
        QVERIFY(most > 60); // there is something
        for (const int step : sharpest) {
            QVERIFY2(step > 0.6 * most, qPrintable(QStringLiteral("%1: %2 of %3").arg(name).arg(step).arg(most)));
        }
    }

private slots:
    void initTestCase()
    {
        openWindow();
        m_window->resize(1900, 1100); // many numbers on each edge
        openSample();
        showTab(3);
        part<QAbstractButton>("segment3")->click();
        settle(*m_window);
    }

    void cleanupTestCase() { m_window.reset(); }

    void theRatioIsTheOneAskedFor()
    {
        bool told = false;
        const double asked = qEnvironmentVariable("QT_SCALE_FACTOR").toDouble(&told);
        QCOMPARE(m_window->devicePixelRatio(), told ? asked : 1.0);
    }

    void paintsWithAllThePixelsThereAre()
    {
        for (const auto &[name, edge] : kEdges) {
            const QRect area = edgeOf(*part(name), edge);
            const QImage picture = part(name)->grab(area).toImage();
            QCOMPARE(picture.size(), area.size() * m_window->devicePixelRatio());
            judge(name, picture);
        }
    }

    void followsTheWindowToAnotherScreen()
    {
        const QList<QScreen *> screens = QGuiApplication::screens();
        QCOMPARE(screens.size(), 2);
        QWidget plain;
        plain.show();
        moveTo(screens[1], plain);
        if (plain.devicePixelRatio() != screens[1]->devicePixelRatio()) {
            QSKIP("This Qt's offscreen platform tells no window of another screen's ratio.");
        }
        for (const auto &[name, edge] : kEdges) {
            const QRect area = edgeOf(*part(name), edge);
            moveTo(screens[0]);
            const QImage before = part(name)->grab(area).toImage();
            moveTo(screens[1]);
            const QImage there = part(name)->grab(area).toImage();
            QCOMPARE(there.size(), area.size() * screens[1]->devicePixelRatio());
            judge(name, there);
            moveTo(screens[0]);
            QCOMPARE(part(name)->grab(area).toImage(), before);
        }
    }

    void aPictureMadeLargerIsFoundOut()
    {
        const double ratio = m_window->devicePixelRatio();
        if (ratio == 1.0) {
            QSKIP("At a ratio of 1 nothing is made larger.");
        }
        const QImage full = m_window->findChild<QWidget *>(QStringLiteral("mechanismView"))->grab().toImage();
        const QImage few = full.scaled(full.size() / ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        for (const Qt::TransformationMode mode : {Qt::FastTransformation, Qt::SmoothTransformation}) {
            const std::array<int, 6> blurred = sharpestSteps(few.scaled(full.size(), Qt::IgnoreAspectRatio, mode));
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
    QDir::setCurrent(folder.path()); // a colon of a full name would end it
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=screens.json");
    QApplication application(argc, argv);
    TestSharpness test;
    return QTest::qExec(&test, argc, argv);
}
const Suite suite("tst_sharpness", run);
#include "tst_sharpness.moc"
