// SPDX-License-Identifier: GPL-3.0-or-later

// What a crash leaves: windows in other processes are killed, and the next one is asked what it offers.

#include "ui/widgets/message_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/recovery.h"
#include "ui/window/scene_file.h"
#include "ui/text/language.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QLockFile>
#include <QMessageBox>
#include <QProcess>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#ifdef Q_OS_UNIX
#include <csignal>

#include <sys/resource.h>
#endif

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

/// As the program has them, whose settings are then in `path`.
void introduce(const QString &path)
{
    QCoreApplication::setOrganizationName(QStringLiteral("slidercrank"));
    QCoreApplication::setApplicationName(QStringLiteral("slidercrank"));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path);
    QSettings().setValue(QStringLiteral("greeted"), true);
}

/// In another process: opens the scene, if any, sets b = 70 mm, and waits to be killed.
int editAndWait(const QString &settings, const QString &scene)
{
    introduce(settings);
    MainWindow window;
    window.show();
    if (!scene.isEmpty()) {
        QSignalSpy opened(&window.session(), &Session::opened);
        window.scene().open(scene);
        if (opened.empty()) {
            opened.wait(kPatience);
        }
    }
    window.session().setParameter(Parameter::B, 70.0);
    letTimePass(*window.findChild<Recovery *>());
    return QApplication::exec();
}

} // namespace

class TestRecovery : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_settings = std::make_unique<QTemporaryDir>();
        introduce(m_settings->path());
    }

    void cleanup()
    {
        m_window.reset();
        m_other.kill();
        m_other.waitForFinished();
    }

    void keepsWhatIsUnsavedUntilItIsSaved()
    {
        openWindow();
        QVERIFY(files().isEmpty());
        m_window->session().setParameter(Parameter::B, 70.0);
        m_window->session().setParameter(Parameter::C, 4.0);
        keep();
        QCOMPARE(kept().size(), 1);
        const Scene scene = std::get<Scene>(readScene(kept().first()));
        QCOMPARE(scene.parameters, m_window->session().parameters());
        m_window->session().setTime(0.5); // looking is no edit: nothing is under way
        QVERIFY(!recovery().findChild<QTimer *>()->isActive());
        QVERIFY(m_window->scene().saveTo(m_settings->filePath(QStringLiteral("rig.json"))));
        QVERIFY(files().isEmpty());
        m_window->session().setParameter(Parameter::B, 71.0);
        keep();
        QCOMPARE(kept().size(), 1);
        m_window->session().undoStack().undo();
        QVERIFY(files().isEmpty());
    }

    void aSlowDiskKeepsNobodyWaiting()
    {
        openWindow();
        settle(); // large areas are filled by threads of the pool: nothing is painted while they are held
        QThreadPool *pool = QThreadPool::globalInstance();
        pool->setMaxThreadCount(1);
        const auto disk = std::make_shared<QSemaphore>();
        pool->start([disk] { disk->acquire(); });
        const auto end = qScopeGuard([pool, disk] {
            disk->release();
            pool->setMaxThreadCount(QThread::idealThreadCount());
        });
        m_window->session().setParameter(Parameter::B, 70.0);
        letTimePass(recovery());
        QVERIFY(kept().isEmpty());
        m_window->session().setParameter(Parameter::B, 71.0);
        letTimePass(recovery()); // one at a time
        disk->release();
        finishAside();
        QCOMPARE(std::get<Scene>(readScene(kept().value(0))).parameters.b, 70.0);
        keep();
        QCOMPARE(std::get<Scene>(readScene(kept().value(0))).parameters.b, 71.0);

        m_window->session().setParameter(Parameter::B, 72.0);
        letTimePass(recovery());
        m_window->session().undoStack().setIndex(0); // while it is written
        finishAside();
        QVERIFY(files().isEmpty());
    }

    void aProperEndLeavesNothing()
    {
        openWindow();
        m_window->session().setParameter(Parameter::B, 70.0);
        keep();
        QCOMPARE(kept().size(), 1);
        m_window->close();
        m_window->findChild<QMessageBox *>(QStringLiteral("unsavedQuestion"))->button(QMessageBox::Discard)->click();
        m_window.reset();
        QVERIFY(files().isEmpty());
        openWindow();
        QVERIFY(!offer());
    }

    void offersWhatACrashLeft()
    {
        const QString rig = m_settings->filePath(QStringLiteral("rig.json"));
        QByteArray height = "time,R4_y\n"; // of the same motion, in a file of its own
        for (int i = 0; i <= 200; ++i) {
            height += QByteArray::number(0.005 * i, 'f', 6) + ",25\n";
        }
        QFile plot(m_settings->filePath(QStringLiteral("height.csv")));
        QVERIFY(plot.open(QIODevice::WriteOnly) && plot.write(height) == height.size());
        plot.close();
        Scene scene;
        scene.parameters.a = 12.0;
        scene.reference = ReferenceSource{{kSample, plot.fileName()}, {}, {}};
        scene.kept = {Parameters()};
        QCOMPARE(writeScene(scene, rig), std::nullopt);
        editElsewhere(rig);
        crash();
        openWindow();
        QVERIFY(offer() && offer()->isVisible());
        QVERIFY2(offer()->text().contains(QLatin1String("rig.json")), qPrintable(offer()->text()));
        QCOMPARE(m_window->session().parameters(), Parameters());
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        AWAIT(m_window->session().reference());
        QCOMPARE(m_window->session().reference()->paths, (QStringList{kSample, plot.fileName()}));
        QCOMPARE(m_window->session().parameters().a, 12.0);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QVERIFY(m_window->session().kept() == scene.kept);
        QVERIFY(m_window->isWindowModified());
        QVERIFY(!offer()->isVisible());
        QCOMPARE(m_window->scene().path(), rig);
        finishAside();
        QCOMPARE(kept().size(), 1); // it is still not saved

        m_window->scene().save();
        const Scene saved = std::get<Scene>(readScene(rig));
        QCOMPARE(saved.parameters.b, 70.0);
        QCOMPARE(saved.asRead.keys(), jsonKeys());
        QVERIFY(files().isEmpty());
        openWindow();
        QVERIFY(!offer());
    }

    void whatIsRestoredIsOfferedAgainAfterTheNextCrash()
    {
        editElsewhere();
        crash();
        openWindow();
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QCOMPARE(kept().size(), 1);
        m_window->close();
        QVERIFY(m_window->isVisible()); // it asks
        m_window->session().setParameter(Parameter::B, 65.0);
        m_window->session().undoStack().undo();
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(kept().size(), 1);
    }

    void whatIsDiscardedIsGone()
    {
        editElsewhere();
        crash();
        openWindow();
        press(QStringLiteral("messageDismiss"), QStringLiteral("Discard"));
        QVERIFY(files().isEmpty());
        QVERIFY(!offer()->isVisible());
        QVERIFY(!m_window->isWindowModified());
        openWindow();
        QVERIFY(!offer());
    }

    void aDoubleClickDiscardsNoneUnread()
    {
        editElsewhere();
        crash();
        QVERIFY(QFile::copy(kept().first(), m_settings->filePath(QStringLiteral("slidercrank/recovery_x.json"))));
        openWindow();
        QCOMPARE(kept().size(), 2);
        const auto *discard = offer()->findChild<QAbstractButton *>(QStringLiteral("messageDismiss"));
        const QPoint there = discard->mapTo(m_window.get(), discard->rect().center());
        for (int i = 0; i < 2; ++i) { // whatever is there by then
            QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, {}, there);
        }
        QCOMPARE(kept().size(), 1);
        AWAIT(offer()->isVisible());
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        QCOMPARE(m_window->session().parameters().b, 70.0);
    }

    void anOfferThatIsNotAnsweredStays()
    {
        editElsewhere();
        crash();
        openWindow();
        QVERIFY(offer());
        m_window->openReference(kSample); // messages come and go beside it
        AWAIT(m_window->session().diagnosis());
        QVERIFY(offer()->isVisible());
        openWindow();
        QVERIFY(offer() && offer()->isVisible());
    }

    void theOfferSpeaksTheLanguageInUse()
    {
        editElsewhere();
        crash();
        openWindow();
        setLanguage(Language::Spanish);
        settle();
        const QString said = offer()->text();
        const QString restore = offer()->findChild<QAbstractButton *>(QStringLiteral("messageRemedy"))->text();
        setLanguage(Language::English);
        QVERIFY2(said.startsWith(QLatin1String("El programa")), qPrintable(said));
        QCOMPARE(restore, QStringLiteral("Recuperar"));
    }

    void restoringAsksAboutWhatWasEditedSince()
    {
        editElsewhere();
        crash();
        openWindow();
        m_window->session().setParameter(Parameter::A, 11.0);
        keep();
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        QCOMPARE(m_window->session().parameters().a, 11.0);
        const auto answer = [this](QMessageBox::StandardButton button) {
            m_window->findChild<QMessageBox *>(QStringLiteral("unsavedQuestion"))->button(button)->click();
            settle();
        };
        answer(QMessageBox::Cancel);
        QCOMPARE(m_window->session().parameters().a, 11.0);
        QVERIFY(offer()->isVisible()); // as before
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        answer(QMessageBox::Discard);
        QCOMPARE(m_window->session().parameters().a, Parameters().a);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QVERIFY(!offer()->isVisible());
        QCOMPARE(kept().size(), 1);
    }

    void isOfferedWhileItsReferenceIsRead()
    {
        const QString rig = m_settings->filePath(QStringLiteral("rig.json"));
        Scene scene;
        scene.reference = ReferenceSource{{kSample}, {}, {}};
        QCOMPARE(writeScene(scene, rig), std::nullopt);
        editElsewhere(rig);
        crash();
        openWindow();
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        m_window->session().cancel();
        finishAside();
        QVERIFY(!m_window->session().reference());
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        press(QStringLiteral("messageDismiss"), QStringLiteral("Discard"));
        AWAIT(m_window->session().reference()); // it is there all the same, and kept
        finishAside();
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QVERIFY(m_window->isWindowModified());
        QVERIFY(!offer()->isVisible());
        QCOMPARE(kept().size(), 1);
    }

    void whatWasChangedElsewhereSinceIsAskedAbout()
    {
        const QString rig = m_settings->filePath(QStringLiteral("rig.json"));
        QCOMPARE(writeScene(Scene(), rig), std::nullopt);
        editElsewhere(rig);
        crash();
        Scene other;
        other.parameters.b = 81.25;
        QCOMPARE(writeScene(other, rig), std::nullopt);
        openWindow();
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        m_window->scene().save();
        auto *asked = m_window->findChild<QMessageBox *>(QStringLiteral("changedQuestion"));
        QVERIFY(asked && asked->isVisible());
        QCOMPARE(std::get<Scene>(readScene(rig)).parameters.b, 81.25);
    }

    void isOfferedOnceWhereTwoStartAtOnce()
    {
        editElsewhere();
        crash();
        QLockFile other(kept().first() + QStringLiteral(".lock.rmlock")); // as one who is just taking what a crash left
        QVERIFY(other.tryLock());
        openWindow();
        QVERIFY(!offer());
        other.unlock();
        openWindow();
        QVERIFY(offer());
    }

    void isOfferedWhereThereIsNoRoom()
    {
#ifdef Q_OS_UNIX
        const auto openWithoutRoom = [this] {
            m_window.reset();
            std::signal(SIGXFSZ, SIG_IGN);
            rlimit before{};
            getrlimit(RLIMIT_FSIZE, &before);
            const rlimit none{0, before.rlim_max};
            setrlimit(RLIMIT_FSIZE, &none);
            openWindow();
            setrlimit(RLIMIT_FSIZE, &before);
        };
        editElsewhere();
        openWithoutRoom();
        QVERIFY(!offer()); // it is another window's
        crash();
        openWithoutRoom();
        QVERIFY(offer() && offer()->isVisible());
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        QCOMPARE(m_window->session().parameters().b, 70.0);
#else
        QSKIP("a small disk is made by what only Unix has");
#endif
    }

    void offersNothingThatIsOnShowAnyway()
    {
        const QString rig = m_settings->filePath(QStringLiteral("rig.json"));
        Scene scene;
        scene.parameters.b = 70.0;
        scene.solver.method = Method::ClosedForm;
        scene.solver.newton.elimination = Elimination::Structured;
        QCOMPARE(writeScene(scene, rig), std::nullopt);
        editElsewhere();
        crash();
        openWindow();
        QVERIFY(offer() && offer()->isVisible());
        m_window->scene().open(rig);
        QVERIFY(!offer()->isVisible());
        QVERIFY(files().isEmpty());
    }

    void twoWindowsTakeNothingFromEachOther()
    {
        editElsewhere();
        openWindow();
        QVERIFY(!offer());
        m_window->session().setParameter(Parameter::B, 80.0);
        keep();
        QCOMPARE(kept().size(), 2);
        m_window.reset();
        QCOMPARE(kept().size(), 1);
        crash();
        openWindow();
        QVERIFY(offer());
        press(QStringLiteral("messageRemedy"), QStringLiteral("Restore"));
        QCOMPARE(m_window->session().parameters().b, 70.0);
    }

    void theProgramHoldsWhatItOffersUntilItIsKilled()
    {
        editElsewhere();
        crash();
        const QString lock = kept().first() + QStringLiteral(".lock");
        QVERIFY(QFile::remove(lock));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_settings->path());
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        m_other.setProcessEnvironment(environment);
        m_other.start(QStringLiteral(SLIDERCRANK_PROGRAM), QStringList());
        AWAIT(QFile::exists(lock));
        openWindow();
        QVERIFY(!offer());
        crash();
        openWindow();
        QVERIFY(offer());
    }

private:
    void openWindow()
    {
        m_window.reset();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    /// What would be kept in a moment.
    void keep()
    {
        letTimePass(recovery());
        finishAside();
    }

    Recovery &recovery()
    {
        return *m_window->findChild<Recovery *>();
    }

    const MessageBar *offer()
    {
        return m_window->findChild<MessageBar *>(QStringLiteral("recoveryBar"));
    }

    void press(const QString &name, const QString &text)
    {
        auto *button = offer()->findChild<QAbstractButton *>(name);
        QVERIFY(button->isVisible());
        QCOMPARE(button->text(), text);
        QTest::mouseClick(button, Qt::LeftButton);
    }

    QStringList files(const QString &pattern = QStringLiteral("recovery_*")) const
    {
        QStringList paths;
        for (const QFileInfo &info : QFileInfo(QSettings().fileName()).dir().entryInfoList({pattern}, QDir::Files)) {
            paths += info.filePath();
        }
        return paths;
    }
    QStringList kept() const
    {
        return files(QStringLiteral("recovery_*.json"));
    }

    /// Of a scene's file.
    static QStringList jsonKeys()
    {
        return {QStringLiteral("kept"),     QStringLiteral("mechanism"), QStringLiteral("reference"),
                QStringLiteral("sampling"), QStringLiteral("solver"),    QStringLiteral("version"),
                QStringLiteral("view")};
    }

    void editElsewhere(const QString &scene = {})
    {
        m_other.setProcessEnvironment(QProcessEnvironment::systemEnvironment());
        m_other.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--edit"), m_settings->path(), scene});
        AWAIT(!kept().isEmpty());
    }

    void crash()
    {
        m_other.kill();
        QVERIFY(m_other.waitForFinished(kPatience));
        QCOMPARE(m_other.exitStatus(), QProcess::CrashExit);
    }

    std::unique_ptr<QTemporaryDir> m_settings;
    std::unique_ptr<MainWindow> m_window;
    QProcess m_other;
};

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QLatin1String("--edit")) {
        return editAndWait(arguments.value(2), arguments.value(3));
    }
    TestRecovery tests;
    return QTest::qExec(&tests, argc, argv);
}

#include "tst_recovery.moc"
