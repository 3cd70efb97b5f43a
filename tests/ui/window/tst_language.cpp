// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/text/language.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/number_box.h"
#include "ui/window/scene_file.h"

#include <QMenuBar>

using namespace slidercrank;

namespace tst_language
{

class TestLanguage : public WindowFixture
{
    Q_OBJECT

private slots:
    void init()
    {
        resetSettings();
        setLanguage(Language::English);
        openWindow();
    }
    void cleanup()
    {
        m_window.reset();
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }

    void theMenuAsksForAWindowInTheChosenLanguage()
    {
        const QSignalSpy chosen(m_window.get(), &MainWindow::languageChosen);
        action("Español")->trigger();
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosenLanguage(), Language::Spanish);
    }

    /// A former defect: the number was converted to an enumerator without a check.
    void aDamagedSettingIsALanguage()
    {
        struct Row {
            QVariant stored;
            Language language;
        };
        const Row rows[] = {{-7, Language::System}, {0, Language::System},   {1, Language::English},
                            {2, Language::Spanish}, {99, Language::Spanish}, {"Klingon", Language::System}};
        for (const Row &row : rows) {
            QSettings().setValue("language", row.stored);
            QCOMPARE(chosenLanguage(), row.language);
        }
    }

    void theNewWindowSpeaksTheLanguageAndShowsTheSame()
    {
        const QString scene = m_settings.filePath("rig.json");
        QVERIFY(m_window->scene().saveTo(scene));
        openSample();
        session().pinMotion();
        setB(61.25);
        session().setTime(0.3);
        session().setAlpha2(12.5);
        showTab(ReferenceTab);
        const Choices before = session().result()->choices;
        QVERIFY(m_window->isWindowModified());

        action("Español")->trigger();
        m_window = m_window->makeReplacement();
        m_window->show();
        settle(*m_window);
        QCOMPARE(m_window->menuBar()->actions().front()->text(), QString("&Archivo"));
        QCOMPARE(part<QTabBar>("tabBar")->tabText(TableTab), QString("Tabla"));
        QVERIFY(session().result()->choices == before); // with the same reference, which is not read again
        QCOMPARE(session().time(), 0.3);
        QCOMPARE(part<NumberBox>("tableAlpha2")->value(), 12.5);
        QCOMPARE(shownTab(), static_cast<int>(ReferenceTab));
        QCOMPARE(m_window->scene().path(), scene);
        QVERIFY(m_window->isWindowModified() && session().isModified());

        action("English")->trigger();
        m_window = m_window->makeReplacement();
        QCOMPARE(m_window->menuBar()->actions().front()->text(), QString("&File"));
        QVERIFY(session().result()->choices == before);
    }

    void theStepsCanBeUndoneInTheNewWindow()
    {
        setB(61.25);
        QVERIFY(m_window->scene().saveTo(m_settings.filePath("rig.json")));
        session().pinMotion();
        session().setParameter(Parameter::A, 21.5);
        session().undoStack().undo();
        storeLanguage(Language::Spanish);
        m_window = m_window->makeReplacement();
        QUndoStack &steps = session().undoStack();
        QCOMPARE(steps.redoText(), QStringLiteral("cambio de a"));
        QVERIFY(session().isModified() && session().parameters() == Parameters({.b = 61.25}));
        steps.redo();
        QCOMPARE(session().parameters().a, 21.5);
        steps.setIndex(1);
        QVERIFY(!session().isModified() && session().pinned().empty());
        steps.undo();
        QVERIFY(session().parameters() == Parameters());
    }

    void theMenuAsksForNoWindowWhileAFileIsRead()
    {
        const QSignalSpy chosen(m_window.get(), &MainWindow::languageChosen);
        m_window->openSample();
        action("Español")->trigger();
        QCOMPARE(chosen.count(), 0);
        QVERIFY(messageText(*view<MessageBar>()).contains("still being read"));
        AWAIT(!session().isReading());
        action("Español")->trigger();
        QCOMPARE(chosen.count(), 1);
    }

    void anUnchangedSceneStaysUnchanged()
    {
        view<FoldingTabs>()->setFolded(true);
        storeLanguage(Language::Spanish);
        m_window = m_window->makeReplacement();
        QVERIFY(!m_window->isWindowModified() && view<FoldingTabs>()->isFolded());
    }
};

const Suite<TestLanguage> suite("tst_language");

} // namespace tst_language

#include "tst_language.moc"
