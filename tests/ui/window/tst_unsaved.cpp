// SPDX-License-Identifier: GPL-3.0-or-later

// What would be lost is asked about first: edits made while a scene is on its way, and files still being written.

#include "ui/widgets/message_bar.h"
#include "ui/widgets/number_box.h"
#include "ui/export/animation_export.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"
#include "ui/window/status_bar.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <array>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

} // namespace

class TestUnsaved : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings().setValue(QStringLiteral("greeted"), true);
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void init()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void editsWhileASceneIsOnItsWayAreAskedAbout_data()
    {
        QTest::addColumn<int>("answer");
        QTest::addColumn<double>("a");
        QTest::newRow("cancel") << int(QMessageBox::Cancel) << 21.0;
        QTest::newRow("discard") << int(QMessageBox::Discard) << 12.0;
    }

    void editsWhileASceneIsOnItsWayAreAskedAbout()
    {
        QFETCH(const int, answer);
        QFETCH(const double, a);
        m_window->scene().open(sceneWithReference());
        m_window->session().setParameter(Parameter::A, 21.0); // before the file is read
        QVERIFY(m_window->isWindowModified());
        QMessageBox *asked = nullptr;
        AWAIT(asked = question("unsavedQuestion"));
        QCOMPARE(m_window->session().parameters().a, 21.0);
        asked->button(static_cast<QMessageBox::StandardButton>(answer))->click();
        QCOMPARE(m_window->session().parameters().a, a);
        const bool isOpen = answer == QMessageBox::Discard;
        QCOMPARE(m_window->isWindowModified(), !isOpen);
        QCOMPARE(m_window->session().reference() != nullptr, isOpen);
        QCOMPARE(m_window->scene().path().isEmpty(), !isOpen);
    }

    void whatWasDiscardedIsNotAskedAboutTwice()
    {
        m_window->session().setParameter(Parameter::A, 21.0);
        m_window->scene().open(sceneWithReference());
        question("unsavedQuestion")->button(QMessageBox::Discard)->click();
        AWAIT(m_window->session().reference());
        QCOMPARE(m_window->session().parameters().a, 12.0);
        QVERIFY(!question("unsavedQuestion"));
    }

    void whatAnotherWindowSavedIsAskedAbout()
    {
        const QString path = sceneWithReference();
        const auto savedA = [&path] {
            const auto outcome = readScene(path);
            return std::get<Scene>(outcome).parameters.a;
        };
        m_window->scene().open(path);
        AWAIT(m_window->session().reference());
        m_window->session().setParameter(Parameter::A, 13.0);
        m_window->scene().save(); // its own
        QVERIFY(!question("changedQuestion"));
        QCOMPARE(savedA(), 13.0);

        Scene other;
        other.parameters.a = 14.5;
        QCOMPARE(writeScene(other, path), std::nullopt);
        m_window->session().setParameter(Parameter::A, 15.0);
        m_window->scene().save();
        QVERIFY(question("changedQuestion"));
        question("changedQuestion")->button(QMessageBox::Cancel)->click();
        QCOMPARE(savedA(), 14.5);
        QVERIFY(m_window->isWindowModified());
        settle();

        m_window->scene().save();
        for (QAbstractButton *button : question("changedQuestion")->buttons()) {
            if (button->text() == QLatin1String("Replace")) {
                button->click();
            }
        }
        QCOMPARE(savedA(), 15.0);
        QVERIFY(!m_window->isWindowModified());
    }

    void aCancelSaysWhatIsOnShowAsLongAsItIs()
    {
        const auto *bar = m_window->findChild<MessageBar *>(QStringLiteral("messageBar"));
        const auto cancel = [this] { emit m_window->findChild<StatusBar *>()->cancelled(); };
        Scene scene;
        scene.solver.method = Method::Newton;
        scene.sampling.steps = 1'000'000; // takes seconds
        const QString path = m_folder.filePath(QStringLiteral("long.json"));
        QCOMPARE(writeScene(scene, path), std::nullopt);
        m_window->scene().open(path);
        cancel();
        QVERIFY2(bar->isVisible() && bar->text().contains(QLatin1String("Undo computes it")), qPrintable(bar->text()));
        m_window->session().setParameter(Parameter::A, 21.0);
        QVERIFY(!bar->isVisible());
        m_window->session().setSolver(scene.solver);
        m_window->session().setSampling(scene.sampling);
        cancel();
        QVERIFY2(bar->isVisible() && bar->text().contains(QLatin1String("from before")), qPrintable(bar->text()));
        m_window->session().setParameter(Parameter::A, 22.0);
        QVERIFY(!bar->isVisible());
        m_window->session().undoStack().setClean();
    }

    void whatIsTypedAndNotEnteredCounts()
    {
        const QString path = m_folder.filePath(QStringLiteral("typed.json"));
        QVERIFY(m_window->scene().saveTo(path));
        const auto type = [this](const QString &text) {
            auto *box = m_window->findChild<NumberBox *>(QStringLiteral("box_b"));
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
        };
        type(QStringLiteral("70"));
        QVERIFY(!m_window->isWindowModified());
        m_window->scene().save();
        QCOMPARE(std::get<Scene>(readScene(path)).parameters.b, 70.0);
        type(QStringLiteral("71"));
        m_window->close();
        QVERIFY(m_window->isVisible() && question("unsavedQuestion"));
        question("unsavedQuestion")->button(QMessageBox::Save)->click();
        QVERIFY(!m_window->isVisible());
        QCOMPARE(std::get<Scene>(readScene(path)).parameters.b, 71.0);
    }

    void aCloseWaitsForTheFileThatIsBeingWritten()
    {
        const QString path = startWriting();
        m_window->close();
        QVERIFY(m_window->isVisible() && question("writingQuestion"));
        AWAIT(!m_window->isVisible());
        QVERIFY(QFile::exists(path));
    }

    void aCloseMayStopTheWriting()
    {
        m_window->session().setSampling({0.0, 1.0, 1'000'000}); // takes seconds
        m_window->session().undoStack().setClean();
        const QString path = startWriting();
        m_window->close();
        press("Stop writing and close");
        QVERIFY(!m_window->isVisible());
        finishAside();
        QVERIFY(!QFile::exists(path));
    }

    void aCloseMayBeThoughtBetterOf()
    {
        const QString path = startWriting();
        m_window->close();
        press("Keep the window open");
        AWAIT(!m_window->exports().isWriting());
        settle();
        QVERIFY(m_window->isVisible());
        QVERIFY(QFile::exists(path));
        m_window->close();
        QVERIFY(!m_window->isVisible());
    }

    void aFailureIsSeen()
    {
        startWriting(QStringLiteral("/no/such/folder/motion.csv"));
        m_window->close();
        QVERIFY(question("writingQuestion"));
        AWAIT(!m_window->exports().isWriting());
        settle();
        QVERIFY(m_window->isVisible() && !question("writingQuestion"));
        QVERIFY(m_window->findChild<MessageBar *>()->text().contains(QLatin1String("motion.csv")));
    }

    void bothAreAskedAbout()
    {
        startWriting();
        m_window->session().setParameter(Parameter::A, 21.0);
        m_window->close();
        QVERIFY(!question("writingQuestion"));
        question("unsavedQuestion")->button(QMessageBox::Discard)->click();
        QVERIFY(m_window->isVisible() && question("writingQuestion"));
        press("Stop writing and close");
        QVERIFY(!m_window->isVisible());
    }

private:
    QMessageBox *question(const char *name)
    {
        auto *box = m_window->findChild<QMessageBox *>(QLatin1String(name));
        return box && box->isVisible() ? box : nullptr;
    }

    void press(const char *text)
    {
        for (QAbstractButton *button : question("writingQuestion")->buttons()) {
            if (button->text() == QLatin1String(text)) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        QFAIL(text);
    }

    QString sceneWithReference() const
    {
        Scene scene;
        scene.parameters.a = 12.0;
        scene.reference = ReferenceSource{{kSample}, {}, {}};
        QString path = m_folder.filePath(QStringLiteral("rig.json"));
        writeScene(scene, path);
        return path;
    }

    /// That it is done is heard when events are.
    QString startWriting(const QString &to = {})
    {
        QString path = to.isEmpty() ? m_folder.filePath(QStringLiteral("motion.csv")) : to;
        QFile::remove(path);
        m_window->exports().writeData(path, allChannels());
        return path;
    }

    const QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestUnsaved)
#include "tst_unsaved.moc"
