// SPDX-License-Identifier: GPL-3.0-or-later

// The names of the files that are written, as a person types them into the dialogs.

#include "ui/export/animation_form.h"
#include "ui/panels/study_panel.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include "tests/support/waiting.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QScopeGuard>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QSpinBox>
#include <QTest>
#include <QWheelEvent>

using namespace slidercrank;

namespace
{

QByteArray startOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(5) : QByteArray();
}

} // namespace

class TestSaveDialogs : public QObject
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
        QSettings().setValue(QStringLiteral("greeted"), true);
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void completesANameOrRefusesIt_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("completed"); // empty: refused
        QTest::newRow("no suffix") << QStringLiteral("fig") << QStringLiteral("fig.svg");
        QTest::newRow("that of the filter") << QStringLiteral("fig.svg") << QStringLiteral("fig.svg");
        QTest::newRow("that of another filter") << QStringLiteral("fig.png") << QStringLiteral("fig.png");
        QTest::newRow("in capitals") << QStringLiteral("FIG.SVG") << QStringLiteral("FIG.SVG");
        QTest::newRow("a dot at the end") << QStringLiteral("fig.") << QStringLiteral("fig.svg");
        QTest::newRow("a dot within") << QStringLiteral("fig.final") << QStringLiteral("fig.final.svg");
        QTest::newRow("a number") << QStringLiteral("b = 67.5") << QStringLiteral("b = 67.5.svg");
        QTest::newRow("a page") << QStringLiteral("fig.html") << QString();
        QTest::newRow("another image") << QStringLiteral("fig.jpg") << QString();
        QTest::newRow("another image in capitals") << QStringLiteral("FIG.JPG") << QString();
    }

    void completesANameOrRefusesIt()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, completed);
        const QStringList filters{QStringLiteral("Images (*.png)"), QStringLiteral("Drawings (*.svg)")};
        const std::optional<QString> outcome = completedName(name, filters[1], filters);
        QCOMPARE(outcome.value_or(QString()), completed);
    }

    void everyDialogCompletesTheSuffixOfItsFilter_data()
    {
        QTest::addColumn<QStringList>("menus");
        QTest::addColumn<int>("filter");
        QTest::addColumn<QString>("written");
        QTest::addColumn<QByteArray>("beginning");
        const QString exporting = QStringLiteral("Export");
        const QString figure = QStringLiteral("Figure…");
        QTest::newRow("PNG") << QStringList{exporting, figure} << 0 << "new.png" << QByteArray("\x89PNG\r");
        QTest::newRow("SVG") << QStringList{exporting, figure} << 1 << "new.svg" << QByteArray("<?xml");
        QTest::newRow("PDF") << QStringList{exporting, figure} << 2 << "new.pdf" << QByteArray("%PDF-");
        QTest::newRow("mechanism") << QStringList{exporting, QStringLiteral("Mechanism…")} << 1 << "new.svg"
                                   << QByteArray("<?xml");
        QTest::newRow("data") << QStringList{exporting, QStringLiteral("Data…")} << 1 << "new.csv"
                              << QByteArray("time,");
        QTest::newRow("report") << QStringList{exporting, QStringLiteral("Report…")} << 0 << "new.pdf"
                                << QByteArray("%PDF-");
        QTest::newRow("animation") << QStringList{exporting, QStringLiteral("Animation…")} << 0 << "new/frame_0001.png"
                                   << QByteArray("\x89PNG\r");
        QTest::newRow("scene") << QStringList{QStringLiteral("Save scene as…")} << 0 << "new.slidercrank"
                               << QByteArray("{\n   ");
        QTest::newRow("scene as JSON") << QStringList{QStringLiteral("Save scene as…")} << 1 << "new.json"
                                       << QByteArray("{\n   ");
    }

    void everyDialogCompletesTheSuffixOfItsFilter()
    {
        QFETCH(const QStringList, menus);
        QFETCH(const int, filter);
        QFETCH(const QString, written);
        QFETCH(const QByteArray, beginning);
        trigger(menus);
        if (auto *form = m_window->findChild<AnimationForm *>()) {
            form->accept();
            settle();
        }
        choose(QStringLiteral("new"), filter);
        AWAIT(QFile::exists(m_folder->filePath(written)));
        AWAIT(!m_window->exports().isWriting());
        QCOMPARE(startOf(m_folder->filePath(written)), beginning);
        QCOMPARE(lastFolder(QStandardPaths::HomeLocation), m_folder->path());
    }

    void writesAPictureWhileTheLanguageChanges_data()
    {
        QTest::addColumn<QString>("menu");
        QTest::newRow("figure") << QStringLiteral("Figure…");
        QTest::newRow("mechanism") << QStringLiteral("Mechanism…");
    }

    void writesAPictureWhileTheLanguageChanges()
    {
        QFETCH(const QString, menu);
        trigger({QStringLiteral("Export"), menu});
        QEvent change(QEvent::LanguageChange); // the system's, with the dialog open
        QCoreApplication::sendEvent(m_window.get(), &change);
        settle(*m_window);
        choose(QStringLiteral("new"), 0);
        AWAIT(QFile::exists(m_folder->filePath(QStringLiteral("new.png"))));
    }

    void theAnimationIsAsItsFormSays()
    {
        trigger({QStringLiteral("Export"), QStringLiteral("Animation…")});
        auto *form = m_window->findChild<AnimationForm *>();
        QVERIFY(form);
        const auto *outcome = form->findChild<QLabel *>(QStringLiteral("outcomeLabel"));
        QVERIFY(outcome->text().startsWith(QLatin1String("30 frames: 1 s")));
        form->findChild<QSpinBox *>(QStringLiteral("rateBox"))->setValue(8);
        form->findChild<QSpinBox *>(QStringLiteral("widthBox"))->setValue(201); // videos need even sides
        form->findChild<QSpinBox *>(QStringLiteral("heightBox"))->setValue(120);
        form->findChild<QDoubleSpinBox *>(QStringLiteral("lengthBox"))->setValue(1.5);
        QVERIFY(outcome->text().startsWith(QLatin1String("12 frames: 1.5 s")));
        form->accept();
        settle();
        choose(QStringLiteral("new"));
        const QDir frames(m_folder->filePath(QStringLiteral("new")));
        AWAIT(frames.exists());
        QCOMPARE(frames.entryList(QDir::Files).size(), 12);
        const auto frame = [&frames](const char *name) { return QImage(frames.filePath(QLatin1String(name))); };
        QCOMPARE(frame("frame_0001.png").size(), QSize(200, 120));
        QVERIFY(frame("frame_0001.png") != frame("frame_0012.png"));
        QCOMPARE(frame("frame_0001.png"), frame("frame_0009.png")); // a revolution later
    }

    void theNameFollowsTheFilter()
    {
        trigger({QStringLiteral("Export"), QStringLiteral("Figure…")});
        QCOMPARE(name()->text(), QStringLiteral("figure.png"));
        chooseFilter(1);
        QCOMPARE(name()->text(), QStringLiteral("figure.svg"));
        name()->setText(QStringLiteral("b = 67.5"));
        chooseFilter(2);
        QCOMPARE(name()->text(), QStringLiteral("b = 67.5"));
    }

    void refusesASuffixThatWouldLie()
    {
        trigger({QStringLiteral("Export"), QStringLiteral("Report…")});
        choose(QStringLiteral("report.html"));
        QMessageBox *refusal = box("suffixRefusal");
        QVERIFY(refusal);
        QCOMPARE(refusal->text(), QStringLiteral("This cannot be written as .html: choose a name that ends in .pdf."));
        refusal->button(QMessageBox::Close)->click();
        settle();
        QCOMPARE(name()->text(), QStringLiteral("report.html")); // to be corrected
        choose(QStringLiteral("report"));
        AWAIT_COMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{QStringLiteral("report.pdf")});
    }

    void writesToTheNameAsTyped_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("written");
        QTest::newRow("inches") << QStringLiteral("b = 2\" and 3\" %1")
                                << QStringLiteral("b = 2\" and 3\" %1.slidercrank");
        QTest::newRow("all of it quoted") << QStringLiteral("\"my rig\"") << QStringLiteral("my rig.slidercrank");
        QTest::newRow("letters of all kinds")
            << QStringLiteral("'θ₂ ñ 曲柄 <b>&") << QStringLiteral("'θ₂ ñ 曲柄 <b>&.slidercrank");
    }

    void writesToTheNameAsTyped()
    {
        QFETCH(const QString, typed);
        QFETCH(const QString, written);
        trigger({QStringLiteral("Save scene as…")});
        choose(typed);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{written});
        QCOMPARE(m_window->scene().path(), m_folder->filePath(written));
    }

    void asksBeforeAnOlderFileGoes()
    {
        QFile older(m_folder->filePath(QStringLiteral("rig.slidercrank")));
        QVERIFY(older.open(QIODevice::WriteOnly) && older.write("older") == 5);
        older.close();
        trigger({QStringLiteral("Save scene as…")});
        choose(QStringLiteral("rig"));
        QMessageBox *question = box("replaceQuestion");
        QVERIFY(question && question->text().contains(QLatin1String("rig.slidercrank")));
        question->button(QMessageBox::Cancel)->click();
        settle();
        QCOMPARE(startOf(older.fileName()), QByteArray("older"));
        QCOMPARE(m_window->scene().path(), QString());

        choose(QStringLiteral("rig")); // it asks again
        for (QAbstractButton *button : box("replaceQuestion")->buttons()) {
            if (button->text() == QLatin1String("Replace")) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
        settle();
        QCOMPARE(startOf(older.fileName()), QByteArray("{\n   "));
        QCOMPARE(m_window->scene().path(), older.fileName());
    }

    void beginsInTheLastFolder()
    {
        trigger({QStringLiteral("Export"), QStringLiteral("Figure…")});
        choose(QStringLiteral("new"));
        AWAIT(QFile::exists(m_folder->filePath(QStringLiteral("new.png"))));
        trigger({QStringLiteral("Export"), QStringLiteral("Report…")});
        QCOMPARE(dialog()->directory().path(), m_folder->path());
        m_window.reset();
        m_folder.reset(); // gone
        QCOMPARE(lastFolder(QStandardPaths::HomeLocation), QDir::homePath());
    }

private:
    QFileDialog *dialog()
    {
        for (auto *open : m_window->findChildren<QFileDialog *>()) {
            if (open->isVisible()) {
                return open;
            }
        }
        qFatal("no dialog");
    }

    QLineEdit *name() { return dialog()->findChild<QLineEdit *>(QStringLiteral("fileNameEdit")); }

    QMessageBox *box(const char *name)
    {
        for (auto *open : m_window->findChildren<QMessageBox *>(QLatin1String(name))) {
            if (open->isVisible()) {
                return open;
            }
        }
        return nullptr;
    }

    void chooseFilter(int index)
    {
        auto *types = dialog()->findChild<QComboBox *>(QStringLiteral("fileTypeCombo"));
        types->setCurrentIndex(index);
        emit types->textActivated(types->currentText());
    }

    void choose(const QString &file, int filter = 0)
    {
        dialog()->setDirectory(m_folder->path());
        chooseFilter(filter);
        name()->setText(file);
        QMetaObject::invokeMethod(dialog(), "accept");
        settle();
    }

    /// What stands last, in the menus before.
    void trigger(const QStringList &menus)
    {
        for (QAction *action : m_window->findChildren<QAction *>()) {
            const auto *menu = qobject_cast<QMenu *>(action->parent());
            if (action->text().remove(u'&') == menus.last() && !action->menu() &&
                (menus.size() == 1 || (menu && menu->title().remove(u'&') == menus.first()))) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(menus.last()));
    }

    const QTemporaryDir m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestSaveDialogs)
#include "tst_save_dialogs.moc"
