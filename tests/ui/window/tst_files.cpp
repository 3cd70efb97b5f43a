// SPDX-License-Identifier: GPL-3.0-or-later

// Scene files and exported files: opening, saving, file dialogs, and the questions before changes are lost.

#include "tests/ui/window/window_fixture.h"

#include "tests/support/suite.h"
#include "ui/export/animation_export.h"
#include "ui/export/animation_form.h"
#include "ui/export/figure_form.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/notation.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/exports.h"
#include "ui/window/scene_file.h"
#include "ui/window/status_bar.h"
#include "ui/window/window_settings.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QScopeGuard>
#include <QSettings>
#include <QSpinBox>

#include <utility>

using namespace slidercrank;

namespace tst_files
{

class TestFiles : public WindowFixture
{
    Q_OBJECT

private slots:
    void init()
    {
        resetSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        openWindow();
    }

    void cleanup() { m_window.reset(); }

    void savesASceneAndOpensItAgain()
    {
        constexpr MechanismSettings kDrawn{
            .velocity = true, .path = true, .dimensions = true, .angles = true, .instantCentre = true};
        const QString rig = path("rig.slidercrank");
        openSample();
        setB(61.25);
        session().pinMotion();
        session().setTime(0.3);
        PlotZoom zoom;
        zoom.time = Interval{0.25, 0.5};
        zoom.values[4] = Interval{-10.0, 20.0};
        view<PlotGrid>()->setSettings({.error = ErrorMeasure::Absolute, .abscissa = Abscissa::CrankAngle});
        view<PlotGrid>()->setZoom(zoom);
        view<MechanismView>()->setSettings(kDrawn);
        view<MechanismView>()->setZoom(QRectF(-15.0, -10.0, 60.0, 40.0)); // mm
        const MotionTableSettings table{TableStep::Time, 30.0, 0.02, {Channel{R4x, Order::Velocity}}};
        view<MotionTablePanel>()->setSettings(table);
        QVERIFY(m_window->isWindowModified());
        QVERIFY(m_window->scene().saveTo(rig));
        QVERIFY(!m_window->isWindowModified() && m_window->windowTitle().startsWith("rig.slidercrank[*]"));
        const QJsonObject saved = QJsonDocument::fromJson(contentOf(rig)).object();
        QCOMPARE(saved["kept"].toArray().size(), 1);
        QCOMPARE(saved["view"]["time"].toDouble(), 0.3);
        const Trajectory before = session().result()->trajectory;
        settle(*m_window);
        const QImage shown = picture("plot_R4_x_diff");

        openWindow();
        view<MotionTablePanel>()->setSettings({.columns = usualTableChannels()}); // as in a new installation
        drop({rig});
        AWAIT(session().reference());
        QVERIFY(view<MotionTablePanel>()->settings() == table);
        QCOMPARE(shownTab(), ErrorsTab); // the errors against its reference
        QCOMPARE(sceneToJson(m_window->scene().scene(), rig), contentOf(rig));
        for (const Channel channel : kPlottedChannels) {
            QVERIFY(session().result()->trajectory[channel] == before[channel]);
        }
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(recentFiles().contains(QStringList(rig)));
        AWAIT_COMPARE(picture("plot_R4_x_diff"), shown);
    }

    /// A former defect: a scene had neither units nor notation.
    void aSceneStoresUnitsAndNotation()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const Notation inches{Symbols::Textbook, {LengthUnit::Inch, AngleUnit::Radian}, CrankSpeedUnit::TurnPerMinute};
        m_window->setNotation(inches);
        QVERIFY(m_window->scene().saveTo(path("inches.json")));
        m_window->setNotation({});
        m_window->scene().open(path("inches.json"));
        QCOMPARE(notation(), inches);
        Scene older = m_window->scene().scene();
        older.notation.reset();
        QCOMPARE(writeScene(older, path("older.json")), std::nullopt);
        m_window->scene().open(path("older.json"));
        QCOMPARE(notation(), inches);
        m_window->setNotation({});
    }

    /// Stored positions of enumerators would change their meaning with a new unit.
    void theSettingsStoreTheNotationInWords()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const Notation inches{Symbols::Textbook, {LengthUnit::Inch, AngleUnit::Radian}, CrankSpeedUnit::TurnPerMinute};
        QVERIFY(!isNotationChosen());
        m_window->setNotation(inches);
        QVERIFY(isNotationChosen());
        QCOMPARE(chosenNotation(), inches);
        const QJsonObject stored = QJsonDocument::fromJson(QSettings().value("notation").toByteArray()).object();
        QCOMPARE(stored["length"].toString(), QString("in"));
        QCOMPARE(stored["crankSpeed"].toString(), QString("rpm"));
        QSettings().setValue("notation", "damaged");
        QCOMPARE(chosenNotation(), Notation());
        m_window->setNotation({});
    }

    void copiesALinkThatOpensTheSameMechanism()
    {
        openSample();
        setB(61.25);
        action("Copy link")->trigger();
        const QString link = QApplication::clipboard()->text();
        QCOMPARE(link, "slidercrank.html#a=20&b=61.25&c=25&omega2=60rpm");
        QVERIFY2(shownMessages().contains("no file"), qPrintable(shownMessages()));

        openWindow();
        const MechanismSettings drawn = view<MechanismView>()->settings();
        m_window->openFiles({link});
        AWAIT_COMPARE(session().parameters().b, 61.25);
        QVERIFY(!m_window->isWindowModified() && m_window->scene().path().isEmpty());
        QVERIFY(!recentFiles().contains(QStringList(link)));
        QVERIFY(view<MechanismView>()->settings() == drawn); // a link does not say what is drawn
        m_window->openFiles({"slidercrank.html#a=40&d=3"});
        QVERIFY2(shownMessages().contains("“d”"), qPrintable(shownMessages()));
    }

    /// Exported data have a row for each time step. The tab Table exports rows for crank angles.
    void dataAreTheMotionAtTheTimeSteps()
    {
        m_window->exports().chooseData();
        auto *dialog = m_window->findChild<QFileDialog *>();
        QVERIFY(dialog && dialog->nameFilters().size() == 2);
        dialog->selectNameFilter(dialog->nameFilters().last());
        emit dialog->fileSelected(path("all.csv"));
        AWAIT(QFile::exists(path("all.csv")));
        QCOMPARE(contentOf(path("all.csv")).count('\n'), 202);
    }

    void knowsWhatIsModified()
    {
        QVERIFY(m_window->scene().saveTo(path("rig.json")));
        openSample();
        session().undoStack().setClean();
        session().setTime(0.5); // changing the time is not an edit
        QVERIFY(!m_window->isWindowModified());
        setB(70.0);
        QVERIFY(m_window->isWindowModified());
        session().undoStack().undo();
        QVERIFY(!m_window->isWindowModified());
        session().undoStack().redo();
        m_window->scene().save();
        QVERIFY(!m_window->isWindowModified());
        session().undoStack().undo();
        QVERIFY(m_window->isWindowModified());
    }

    void asksBeforeItCloses()
    {
        struct Row {
            QMessageBox::StandardButton answer;
            bool closes;
            double saved;
        };
        m_window->close();
        QVERIFY(!m_window->isVisible()); // there are no changes to lose
        for (const Row &row : {Row{QMessageBox::Cancel, false, 65.0}, Row{QMessageBox::Discard, true, 65.0},
                               Row{QMessageBox::Save, true, 70.0}}) {
            openWindow();
            QVERIFY(m_window->scene().saveTo(path("rig.json")));
            setB(70.0);
            m_window->close();
            QVERIFY(m_window->isVisible() && question("unsavedQuestion")->text().contains("rig.json"));
            question("unsavedQuestion")->button(row.answer)->click();
            QCOMPARE(m_window->isVisible(), !row.closes);
            QCOMPARE(savedIn("rig.json").b, row.saved);
        }
    }

    void asksBeforeItOpensAnotherScene()
    {
        const QString rig = sceneWithReference();
        session().setParameter(Parameter::A, 21.0);
        drop({rig});
        QCOMPARE(session().parameters().a, 21.0);
        question("unsavedQuestion")->button(QMessageBox::Discard)->click();
        AWAIT(session().reference());
        QCOMPARE(session().parameters().a, 12.0);
        QVERIFY(!m_window->isWindowModified() && !question("unsavedQuestion")); // it is asked once
    }

    void asksBeforeItReplacesWhatAnotherProgramSaved()
    {
        m_window->scene().open(sceneWithReference());
        AWAIT(session().reference());
        session().setParameter(Parameter::A, 13.0);
        m_window->scene().save(); // does not ask about its own changes of the file
        QCOMPARE(savedIn("rig.json").a, 13.0);
        Scene other;
        other.parameters.a = 14.5;
        QCOMPARE(writeScene(other, path("rig.json")), std::nullopt);
        session().setParameter(Parameter::A, 15.0);
        m_window->scene().save();
        question("replaceQuestion")->button(QMessageBox::No)->click();
        QCOMPARE(savedIn("rig.json").a, 14.5);
        QVERIFY(m_window->isWindowModified());
        settle();
        m_window->scene().save();
        question("replaceQuestion")->button(QMessageBox::Yes)->click();
        QCOMPARE(savedIn("rig.json").a, 15.0);
    }

    void savesANumberThatIsStillBeingTyped()
    {
        QVERIFY(m_window->scene().saveTo(path("rig.json")));
        for (const bool isClosed : {false, true}) {
            auto *box = part<QAbstractSpinBox>("box_b");
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, isClosed ? "71" : "70");
            if (isClosed) {
                m_window->close();
                question("unsavedQuestion")->button(QMessageBox::Save)->click();
            } else {
                m_window->scene().save();
            }
            QCOMPARE(m_window->isVisible(), !isClosed);
            QCOMPARE(savedIn("rig.json").b, isClosed ? 71.0 : 70.0);
        }
    }

    void reportsFilesThatCannotBeOpenedOrSaved()
    {
        setB(70.0);
        drop({writeFile(*m_folder, "rig.json", "{\"version\": 99}")});
        QVERIFY(shownMessages().contains("rig.json") && !question("unsavedQuestion"));
        QVERIFY(session().undoStack().canUndo());
        QVERIFY(!m_window->scene().saveTo("/no/such/folder/other.json"));
        QVERIFY(shownMessages().contains("other.json") && m_window->isWindowModified());
        QCOMPARE(m_window->scene().path(), QString());
        rememberFiles({"/no/such/folder/deleted.csv"});
        QCOMPARE(recentFolder(), QDir::homePath()); // a dialog would take a missing folder for the name of a file
    }

    void opensASceneWithoutItsReferenceOrWithAnother()
    {
        Scene scene;
        scene.parameters.b = 70.0;
        scene.reference = ReferenceSource{{path("gone.csv")}, {}, {}};
        QCOMPARE(writeScene(scene, path("rig.json")), std::nullopt);
        m_window->openFiles({path("rig.json")});
        AWAIT(shownMessages().contains("gone.csv"));
        QCOMPARE(session().parameters().b, 70.0);
        m_window->scene().save();
        const Scene again = std::get<Scene>(readScene(path("rig.json")));
        QVERIFY(again.reference && again.reference->paths == scene.reference->paths);
    }

    void explainsWhatIsShownAfterACancel()
    {
        const auto cancel = [this] { emit view<StatusBar>()->cancelled(); };
        Scene scene;
        scene.solver.method = Method::Newton;
        scene.sampling.steps = 1'000'000; // takes seconds
        QCOMPARE(writeScene(scene, path("long.json")), std::nullopt);
        m_window->scene().open(path("long.json"));
        cancel();
        QCOMPARE(shownMessages(), "Cancelled."); // the result is that of the simplified scene
        QCOMPARE(session().result()->choices.solver.method, Method::ClosedForm);
        session().setParameter(Parameter::A, 21.0);
        session().setSolver(scene.solver);
        session().setSampling(scene.sampling);
        cancel();
        QCOMPARE(shownMessages(), "Cancelled.");
    }

    void theWindowStaysOpenWhileAFileIsWritten()
    {
        m_window->exports().writeData(path("motion.csv"), allChannels());
        m_window->close();
        QVERIFY(m_window->isVisible() && shownMessages().contains("still being written"));
        AWAIT(!m_window->exports().isWriting());
        QVERIFY(QFile::exists(path("motion.csv")));
        m_window->close();
        QVERIFY(!m_window->isVisible());
    }

    void completesAName()
    {
        const QStringList filters{"Images (*.png)", "Drawings (*.svg)"};
        for (const auto &[name, completed] : {std::pair{"fig", "fig.svg"},
                                              {"fig.svg", "fig.svg"},
                                              {"fig.png", "fig.png"},
                                              {"FIG.SVG", "FIG.SVG"},
                                              {"fig.", "fig.svg"},
                                              {"fig.final", "fig.final.svg"},
                                              {"b = 67.5", "b = 67.5.svg"}}) {
            QCOMPARE(completedName(name, filters[1], filters), QString(completed));
        }
        QCOMPARE(completedName("fig", "Folder (*)", filters), QString("fig"));
    }

    void everyDialogCompletesTheSuffixOfItsFilter()
    {
        struct Row {
            const char *action;
            int filter;
            const char *written;
            const char *beginning;
        };
        session().setSampling({0.0, 0.1, 200}); // few frames
        for (const Row &row :
             {Row{"Figure…", 0, "new.png", "\x89PNG\r"}, Row{"Figure…", 1, "new.svg", "<?xml"},
              Row{"Figure…", 2, "new.pdf", "%PDF-"}, Row{"Mechanism…", 1, "mechanism.svg", "<?xml"},
              Row{"Polygons…", 1, "polygons.svg", "<?xml"}, Row{"Data…", 1, "new.csv", "time,"},
              Row{"Report…", 0, "report.pdf", "%PDF-"},
              Row{"Animation…", framesFilter(), "motion/frame_0001.png", "\x89PNG\r"},
              Row{"Save scene as…", 0, "new.slidercrank", "{\n   "}, Row{"Save scene as…", 1, "new.json", "{\n   "}}) {
            action(QString::fromUtf8(row.action))->trigger();
            int filter = row.filter;
            if (auto *form = view<FigureForm>()) { // the format that is chosen there comes first
                child<QComboBox>(*form, "formatBox")->setCurrentIndex(std::exchange(filter, 0));
                form->accept();
                settle();
            } else if (auto *animation = view<AnimationForm>()) {
                animation->accept();
                settle();
            }
            const QString written = path(row.written);
            choose(QString(row.written).section(u'/', 0, 0).section(u'.', 0, 0), filter);
            AWAIT2(QFile::exists(written), row.written);
            AWAIT(!m_window->exports().isWriting());
            QVERIFY2(contentOf(written).startsWith(row.beginning), row.written);
            QCOMPARE(QSettings().value("lastFolder").toString(), m_folder->path());
        }
        for (const char *figure : {"new.svg", "mechanism.svg", "polygons.svg"}) {
            QVERIFY(contentOf(path(figure)).contains("a = 20 mm"));
        }
        action("Figure…")->trigger();
        view<FigureForm>()->accept();
        settle();
        QCOMPARE(dialog()->directory().path(), m_folder->path()); // the folder of the last saved file
    }

    /// A former defect: on small screens, the names of the plots left the preview a width of a few millimetres.
    void thePreviewOfAFigureIsLarge()
    {
        openSample(); // nine plots
        action("Figure…")->trigger();
        const auto *form = view<FigureForm>();
        settle();
        const auto *preview = child<QLabel>(*form, "previewLabel");
        QVERIFY2(2 * preview->width() > form->width(), qPrintable(QString::number(preview->width())));
        QVERIFY(form->width() <= form->screen()->availableSize().width());
        QVERIFY(form->height() <= form->screen()->availableSize().height());
        view<FigureForm>()->reject();
    }

    /// A former defect: "3.15in" was a width of 315 mm in Spanish, and impossible numbers vanished without a word.
    void theWidthOfAFigureMayHaveAUnit()
    {
        action("Figure…")->trigger();
        auto *form = view<FigureForm>();
        settle();
        const auto type = [&](const QString &box, const QString &text, Qt::Key last) {
            auto *number = child<NumberBox>(*form, box);
            number->setFocus();
            number->selectAll();
            QTest::keyClicks(number, text);
            QTest::keyClick(number, last);
            return number->accessibleDescription();
        };
        QCOMPARE(type("widthBox", "3.15in", Qt::Key_Tab), QString());
        QVERIFY(std::abs(form->options().width - 80.01) < 1e-9);
        QCOMPARE(type("fontSizeBox", "10pt", Qt::Key_Tab), QString());
        QCOMPARE(form->options().fontSize, 10.0);
        QVERIFY(type("widthBox", "5", Qt::Key_Return).contains("20")); // the smallest width
        QVERIFY(form->isVisible());                                    // and not closed
        QVERIFY(type("widthBox", "80 kg", Qt::Key_Tab).contains("mm"));
        QVERIFY(std::abs(form->options().width - 80.01) < 1e-9);
        child<QComboBox>(*form, "unitBox")->setCurrentIndex(1);
        QCOMPARE(form->options().width, 302.0);
        QVERIFY(type("widthBox", "99", Qt::Key_Tab).contains("100"));
        form->reject();
    }

    void theAnimationHasTheSettingsOfItsForm()
    {
        view<MechanismView>()->setSettings({}); // without the angle, which counts the revolutions
        action("Animation…")->trigger();
        auto *form = view<AnimationForm>();
        const auto *outcome = child<QLabel>(*form, "outcomeLabel");
        QVERIFY(outcome->text().startsWith("30 frames: 1 s"));
        child<QSpinBox>(*form, "rateBox")->setValue(8);
        child<QSpinBox>(*form, "widthBox")->setValue(201);
        child<QSpinBox>(*form, "heightBox")->setValue(120);
        child<QDoubleSpinBox>(*form, "lengthBox")->setValue(1.5);
        QVERIFY(outcome->text().startsWith("12 frames: 1.5 s"));
        form->accept();
        settle();
        choose("new", framesFilter());
        const auto frame = [this](const char *name) { return QImage(path(QString("new/") + name)); };
        AWAIT(QFile::exists(path("new")));
        QCOMPARE(QDir(path("new")).entryList(QDir::Files).size(), 12);
        QCOMPARE(frame("frame_0001.png").size(), QSize(201, 120));
        QVERIFY(frame("frame_0001.png") != frame("frame_0012.png"));
        // One revolution later, apart from the crank angle in the upper line, which counts on.
        const auto belowTheAngle = [&frame](const char *name) { return frame(name).copy(0, 22, 201, 98); };
        QCOMPARE(belowTheAngle("frame_0001.png"), belowTheAngle("frame_0009.png"));
    }

    void asksForANameAndBeforeReplacingAFile()
    {
        setB(70.0);
        const QString older = writeFile(*m_folder, "θ₂ ñ 曲柄.slidercrank", "older");
        press(Qt::Key_S, Qt::ControlModifier);
        answerWith(QMessageBox::No);
        choose("θ₂ ñ 曲柄");
        QCOMPARE(contentOf(older), QByteArray("older"));
        answerWith(QMessageBox::Yes);
        choose("θ₂ ñ 曲柄");
        AWAIT_COMPARE(m_window->scene().path(), older);
        QVERIFY(contentOf(older).startsWith("{\n"));
        QVERIFY(!m_window->isWindowModified());

        writeFile(*m_folder, "a.html.pdf", "older");
        action("Report…")->trigger();
        choose("a.html"); // the dialog checked this name, not that of the file that exists
        question("replaceQuestion")->button(QMessageBox::No)->click();
        QCOMPARE(contentOf(path("a.html.pdf")), QByteArray("older"));
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    Parameters savedIn(const QString &name) const { return std::get<Scene>(readScene(path(name))).parameters; }

    QString sceneWithReference() const
    {
        Scene scene;
        scene.parameters.a = 12.0;
        scene.reference = ReferenceSource{{kSample}, {}, {}};
        writeScene(scene, path("rig.json"));
        return path("rig.json");
    }

    /// Returns the question, or null if it is not open.
    QMessageBox *question(const char *name) const
    {
        settle();
        auto *box = m_window->findChild<QMessageBox *>(name);
        return box && box->isVisible() ? box : nullptr;
    }

    QFileDialog *dialog() const
    {
        for (auto *open : m_window->findChildren<QFileDialog *>()) {
            if (open->isVisible()) {
                return open;
            }
        }
        qFatal("no dialog");
    }

    QLineEdit *nameEdit() const { return dialog()->findChild<QLineEdit *>("fileNameEdit"); }

    void chooseFilter(int index) const
    {
        auto *types = dialog()->findChild<QComboBox *>("fileTypeCombo");
        types->setCurrentIndex(index);
        emit types->textActivated(types->currentText());
    }

    /// Returns the position of numbered frames among the file types of animations. Videos come first if they can be
    /// made.
    static int framesFilter() { return hasVideoEncoder() ? 3 : 0; }

    void choose(const QString &file, int filter = 0) const
    {
        dialog()->setDirectory(m_folder->path());
        chooseFilter(filter);
        nameEdit()->setText(file);
        QMetaObject::invokeMethod(dialog(), "accept");
        settle();
    }

    /// Answers the question that the file dialog itself will ask in an event loop of its own.
    static void answerWith(QMessageBox::StandardButton button)
    {
        QTimer::singleShot(100, qApp, [button] {
            auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(box);
            box->button(button)->click();
        });
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

const Suite<TestFiles> suite("tst_files");

} // namespace tst_files

#include "tst_files.moc"
