// SPDX-License-Identifier: GPL-3.0-or-later

// Recovery after a crash: the tests kill windows in other processes, and check what the next window offers.

#include "tests/ui/window/window_fixture.h"

#include "ui/text/notation.h"
#include "ui/window/recovery.h"
#include "ui/window/scene_file.h"

#include <QAbstractButton>
#include <QDateTime>
#include <QFileInfo>
#include <QMessageBox>
#include <QProcess>

using namespace slidercrank;

namespace
{

/// Uses the settings in that folder, under the name of the program.
void useSettingsIn(const QString &path)
{
    QCoreApplication::setOrganizationName("slidercrank");
    QCoreApplication::setApplicationName("slidercrank");
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path);
}

/// Runs in another process: opens the scene, if any, sets b = 70 mm, and waits to be killed.
int editAndWait(const QString &settings, const QString &scene)
{
    useSettingsIn(settings);
    MainWindow window;
    window.show();
    if (!scene.isEmpty()) {
        window.scene().open(scene);
        // Waits until the recent files are written. If this process were killed before, it would leave a lock for 30 s.
        finishBackgroundTasks();
    }
    window.session().setParameter(Parameter::B, 70.0);
    letTimePass(*window.findChild<Recovery *>());
    return QApplication::exec();
}

} // namespace

class TestRecovery : public WindowFixture
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        useSettingsIn(m_folder->path());
    }

    void cleanup()
    {
        m_window.reset();
        m_other.kill();
        m_other.waitForFinished();
    }

    void writesACopyUntilChangesAreSavedOrDiscarded()
    {
        openWindow();
        setB(70.0);
        writeCopy();
        QCOMPARE(keptB(), 70.0);
        session().setTime(0.5); // changing the time is not an edit
        QVERIFY(!recovery().findChild<QTimer *>()->isActive());
        QVERIFY(m_window->scene().saveTo(m_folder->filePath("rig.json")));
        QVERIFY(!hasCopy());
        for (const bool isUndone : {true, false}) {
            session().setParameter(Parameter::A, 21.0);
            writeCopy();
            QVERIFY(hasCopy());
            if (isUndone) {
                session().undoStack().undo();
                QVERIFY(!hasCopy());
            }
        }
        m_window->close();
        answer(QMessageBox::Discard);
        m_window.reset();
        QVERIFY(!hasCopy());
        openWindow();
        QVERIFY(offer().isEmpty());
    }

    void offersTheCopyAfterACrash()
    {
        const QString rig = m_folder->filePath("rig.json");
        Scene scene;
        scene.parameters.a = 12.0;
        scene.reference = ReferenceSource{{kSample}, {}, {}};
        scene.pinned = {Parameters()};
        scene.time = 0.25;
        scene.table = MotionTableSettings{.step = TableStep::Time, .columns = {Channel{R4x, Order::Position}}};
        scene.notation = Notation();
        QCOMPARE(writeScene(scene, rig), std::nullopt);
        editElsewhere(rig);
        crash();
        openWindow();
        QVERIFY(offer().contains("ended before your changes were saved"));
        const QString time = QLocale::c().toString(QDateTime::currentDateTime(), "d MMMM yyyy, HH:");
        QVERIFY2(offer().contains("as of " + time), qPrintable(offer())); // a time of 12 hours may end with a full stop
        press("messageRemedy");
        AWAIT(session().reference());
        scene.parameters.b = 70.0;
        QVERIFY(m_window->scene().scene() == scene);
        QVERIFY(m_window->isWindowModified() && offer().isEmpty());
        QCOMPARE(m_window->scene().path(), QString()); // saving asks for a name, because the file may be newer
        QVERIFY(hasCopy());                            // the restored changes are still unsaved
        QVERIFY(m_window->scene().saveTo(rig));
        QCOMPARE(std::get<Scene>(readScene(rig)).parameters.b, 70.0);
        QVERIFY(!hasCopy());
    }

    void theOfferWaitsForAnAnswer()
    {
        editElsewhere();
        crash();
        for (int start = 0; start < 2; ++start) {
            openWindow();
            QVERIFY(!offer().isEmpty());
            openSample(); // shows and removes other messages
            QVERIFY(!offer().isEmpty());
        }
        press("messageDismiss");
        QVERIFY(!hasCopy() && offer().isEmpty());
        openWindow();
        QVERIFY(offer().isEmpty());
    }

    void restoringAsksBeforeItDiscardsEdits()
    {
        editElsewhere();
        crash();
        openWindow();
        session().setParameter(Parameter::A, 11.0);
        writeCopy();
        for (const auto button : {QMessageBox::Cancel, QMessageBox::Discard}) {
            press("messageRemedy");
            QCOMPARE(session().parameters().a, 11.0);
            answer(button);
            const bool isRestored = button == QMessageBox::Discard;
            QCOMPARE(session().parameters().b, isRestored ? 70.0 : 65.0);
            QCOMPARE(offer().isEmpty(), isRestored);
        }
        QCOMPARE(session().parameters().a, Parameters().a);
        QVERIFY(hasCopy());
    }

    void everyWindowKeepsACopyOfItsOwn()
    {
        editElsewhere();
        openWindow();
        QVERIFY(offer().isEmpty()); // the other window still runs
        setB(80.0);
        writeCopy();
        QCOMPARE(keptB(), 70.0);
        QCOMPARE(keptB(kSecondCopy), 80.0);
        m_window->close();
        answer(QMessageBox::Discard);
        m_window.reset();
        QVERIFY(hasCopy() && !hasCopy(kSecondCopy));
        crash();
        openWindow();
        QVERIFY(!offer().isEmpty());
        const MainWindow second;
        QVERIFY(!second.findChild<QWidget *>("recovery")); // a copy is offered by one window only
    }

    void aCopyIsKeptWhileAnotherOneIsOffered()
    {
        editElsewhere();
        crash();
        openWindow();
        setB(80.0);
        writeCopy();
        QCOMPARE(keptB(), 70.0);
        QCOMPARE(keptB(kSecondCopy), 80.0);
        press("messageRemedy");
        answer(QMessageBox::Discard);
        QCOMPARE(session().parameters().b, 70.0);
        QVERIFY(hasCopy() && !hasCopy(kSecondCopy)); // the restored copy is now that of the window
    }

    void offersTheCopiesOfAllCrashedWindows()
    {
        editElsewhere();
        crash();
        QVERIFY(QFile::copy(copyPath(), copyPath(kSecondCopy)));
        openWindow();
        press("messageDismiss");
        QVERIFY(!hasCopy() && hasCopy(kSecondCopy) && !offer().isEmpty());
        press("messageDismiss");
        QVERIFY(!hasCopy(kSecondCopy) && offer().isEmpty());
    }

private:
    Recovery &recovery() const { return *m_window->findChild<Recovery *>(); }

    /// Lets the delay elapse after which the copy is written.
    void writeCopy() const { letTimePass(recovery()); }

    QString offer() const
    {
        const auto *row = m_window->findChild<QWidget *>("recovery");
        return row && row->isVisible() ? shownMessages() : QString();
    }

    void press(const QString &button) const
    {
        QTest::mouseClick(child<QAbstractButton>(*part("recovery"), button), Qt::LeftButton);
    }

    void answer(QMessageBox::StandardButton button) const
    {
        part<QMessageBox>("unsavedQuestion")->button(button)->click();
        settle();
    }

    static constexpr const char *kFirstCopy = "recovery.json";
    static constexpr const char *kSecondCopy = "recovery-2.json";

    static QString copyPath(const char *name = kFirstCopy)
    {
        return QFileInfo(QSettings().fileName()).absoluteDir().filePath(name);
    }
    static bool hasCopy(const char *name = kFirstCopy) { return QFile::exists(copyPath(name)); }
    static double keptB(const char *name = kFirstCopy)
    {
        return std::get<Scene>(readScene(copyPath(name))).parameters.b;
    }

    void editElsewhere(const QString &scene = {})
    {
        m_other.start(QCoreApplication::applicationFilePath(), {"--edit", m_folder->path(), scene});
        AWAIT(hasCopy());
    }

    void crash()
    {
        m_other.kill();
        QVERIFY(m_other.waitForFinished(kPatience));
        QCOMPARE(m_other.exitStatus(), QProcess::CrashExit);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QProcess m_other;
};

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == "--edit") {
        return editAndWait(arguments.value(2), arguments.value(3));
    }
    TestRecovery tests;
    return QTest::qExec(&tests, argc, argv);
}

#include "tst_recovery.moc"
