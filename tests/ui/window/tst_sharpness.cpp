// SPDX-License-Identifier: GPL-3.0-or-later

// The views are painted at the full resolution for every device pixel ratio (QT_SCALE_FACTOR; ctest uses 1, 1.5 and 2),
// also after the window was moved to a screen with a different ratio. In a picture that was scaled up, some
// neighbouring columns of pixels hardly differ.

#include "tests/ui/window/window_fixture.h"
#include "ui/widgets/folding_tabs.h"

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
                                               {"plots", Qt::BottomEdge},
                                               {"iterationPlot", Qt::LeftEdge},
                                               {"iterationTable", Qt::LeftEdge}};

} // namespace

class TestSharpness : public WindowFixture
{
    Q_OBJECT

private:
    void moveTo(QScreen *screen)
    {
        m_window->windowHandle()->setScreen(screen);
        m_window->move(screen->geometry().topLeft() + QPoint(10, 10));
        settle(*m_window);
    }

    static QRect edgeOf(const QWidget &widget, Qt::Edge edge)
    {
        constexpr int kEdge = 26; // px, the height of numbers and a title
        return edge == Qt::BottomEdge ? QRect(0, widget.height() - kEdge, widget.width(), kEdge)
                                      : QRect(0, 0, 3 * kEdge, widget.height());
    }

    /// Returns a picture of the edge, after checking that it is sharp.
    QImage sharpPictureOf(const QString &name, Qt::Edge edge)
    {
        const QRect area = edgeOf(*part(name), edge);
        const QImage picture = part(name)->grab(area).toImage();
        const std::array<int, 6> sharpest = sharpestSteps(picture);
        const auto [least, largest] = std::minmax_element(sharpest.begin(), sharpest.end());
        const bool isSharp = *largest > 60 && *least > 0.6 * *largest; // otherwise the picture is empty or scaled up
        if (picture.size() != area.size() * m_window->devicePixelRatio() || !isSharp) {
            m_faults << QStringLiteral("%1: %2 of %3").arg(name).arg(*least).arg(*largest);
        }
        return picture;
    }

    QStringList m_faults;

private slots:
    void initTestCase()
    {
        openWindow();
        m_window->resize(1900, 1100); // large enough for many numbers on each edge
        openSample();
        m_window->findChild<FoldingTabs *>()->setFolded(false);
        showTab(NewtonTab);
        part<QListWidget>("newtonPages")->setCurrentRow(3);
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
            sharpPictureOf(name, edge);
        }
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void paintsAtFullResolutionOnAnotherScreen()
    {
        const QList<QScreen *> screens = QGuiApplication::screens();
        QCOMPARE(screens.size(), 2);
        moveTo(screens[1]);
        if (m_window->devicePixelRatio() != screens[1]->devicePixelRatio()) {
            QSKIP("This Qt's offscreen platform does not tell windows the ratio of another screen.");
        }
        for (const auto &[name, edge] : kEdges) {
            moveTo(screens[0]);
            const QImage before = sharpPictureOf(name, edge);
            moveTo(screens[1]);
            sharpPictureOf(name, edge);
            moveTo(screens[0]);
            QCOMPARE(sharpPictureOf(name, edge), before);
        }
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }
};

int main(int argc, char *argv[])
{
    const QTemporaryDir folder;
    QFile screens(folder.filePath("screens.json"));
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

#include "tst_sharpness.moc"
