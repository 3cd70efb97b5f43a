// SPDX-License-Identifier: GPL-3.0-or-later

// English and Spanish: the translation is complete, the window speaks one language, switching loses nothing.

#include "ui/folding_tabs.h"
#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/timeline.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QMenuBar>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace slidercrank;

namespace
{

void speak(Language language)
{
    setLanguage(language);
    QCoreApplication::processEvents();
}

} // namespace

class TestTranslation : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void init()
    {
        QSettings().clear();
        speak(Language::English);
    }

    void switchingKeepsWhatAPersonChose()
    {
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        Parameters parameters;
        parameters.b = 70.0;
        window.session().setParameters(parameters);
        window.session().setTime(0.25);
        auto *unit = window.findChild<QComboBox *>(QStringLiteral("unit_omega2"));
        unit->setCurrentIndex(2);
        emit unit->activated(2);
        window.findChild<FoldingTabs *>()->setCurrent(4);
        speak(Language::Spanish);
        QCOMPARE(window.menuBar()->actions().first()->text(), QStringLiteral("&Archivo"));
        QCOMPARE(window.session().parameters().b, 70.0);
        QCOMPARE(window.session().time(), 0.25);
        QCOMPARE(window.findChild<QComboBox *>(QStringLiteral("unit_omega2"))->currentIndex(), 2);
        QCOMPARE(window.findChild<FoldingTabs *>()->current(), 4);
        QVERIFY(window.session().undoStack().undoText().contains(QStringLiteral("cambio")));
        speak(Language::English);
        QCOMPARE(window.menuBar()->actions().first()->text(), QStringLiteral("&File"));
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestTranslation)
#include "tst_translation.moc"
