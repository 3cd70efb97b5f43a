// SPDX-License-Identifier: GPL-3.0-or-later

// On a screen of 800×600, with a title bar: nothing is out of reach, though it need not be beautiful.

#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/document/scene.h"
#include "ui/window/main_window.h"
#include "ui/text/language.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");
constexpr QSize kRoom(800, 570); // under a title bar

} // namespace

class TestSmallScreen : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void cleanupTestCase() { setLanguage(Language::English); }

    void everythingHasRoom_data()
    {
        QTest::addColumn<Language>("language");
        QTest::newRow("English") << Language::English;
        QTest::newRow("Spanish") << Language::Spanish;
    }

    void everythingHasRoom()
    {
        QFETCH(const Language, language);
        setLanguage(language);
        QSettings().clear();
        Scene left; // by a crash
        left.parameters.b = 70.0;
        const QDir folder = QFileInfo(QSettings().fileName()).dir();
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        QCOMPARE(writeScene(left, folder.filePath(QStringLiteral("recovery_left.json"))), std::nullopt);
        MainWindow window; // the first ever: it greets
        window.resize(kRoom);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        settle(window);
        const auto bars = window.findChildren<MessageBar *>();
        QCOMPARE(std::ranges::count(bars, true, &MessageBar::isVisible), 2);
        auto *bar = window.findChild<QTabBar *>(QStringLiteral("tabBar"));
        const auto fits = [&](const QString &page) {
            settle(window);
            QVERIFY2(window.size() == kRoom, qPrintable(QStringLiteral("%1: %2×%3")
                                                            .arg(page)
                                                            .arg(window.minimumSizeHint().width())
                                                            .arg(window.minimumSizeHint().height())));
            window.resize(kRoom);
            const QRect status(window.statusBar()->mapTo(&window, QPoint()), window.statusBar()->size());
            QVERIFY(window.statusBar()->isVisible() && window.rect().contains(status));
        };
        fits(QStringLiteral("folded"));
        for (int tab = 0; tab < bar->count(); ++tab) {
            bar->setCurrentIndex(tab);
            window.findChild<FoldingTabs *>()->setFolded(false);
            fits(bar->tabText(tab));
        }
        const QString file = m_settings.filePath(QString(240, u'x') + QStringLiteral(".csv")); // of one long word
        QVERIFY(QFile::exists(file) || QFile::copy(kSample, file));
        window.openReference(file);
        AWAIT(window.session().diagnosis());
        for (int tab = 0; tab < bar->count(); ++tab) {
            bar->setCurrentIndex(tab);
            fits(bar->tabText(tab));
        }
        bar->setCurrentIndex(3);
        for (int segment = 0; segment < 5; ++segment) {
            window.findChild<QAbstractButton *>(QStringLiteral("segment%1").arg(segment))->click();
            fits(QStringLiteral("segment%1").arg(segment));
        }
    }

    void theFirstWindowIsWithinItsScreen()
    {
        setLanguage(Language::English);
        QSettings().clear();
        MainWindow window;
        const QRect room = window.screen()->availableGeometry();
        QVERIFY(!room.contains(QRect(room.topLeft(), window.size()))); // the screen has 800×800
        window.showWithinScreen();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        settle(window);
        QVERIFY(window.isMaximized());
        const QStatusBar &status = *window.statusBar();
        QVERIFY(status.isVisible() && room.contains(QRect(status.mapToGlobal(QPoint()), status.size())));

        QSettings().clear();
        MainWindow small;
        small.resize(kRoom - QSize(20, 60));
        small.showWithinScreen();
        QVERIFY(QTest::qWaitForWindowExposed(&small));
        QVERIFY(!small.isMaximized());
    }

private:
    const QTemporaryDir m_settings;
};

QTEST_MAIN(TestSmallScreen)
#include "tst_small_screen.moc"
