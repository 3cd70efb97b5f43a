// SPDX-License-Identifier: GPL-3.0-or-later

// The main window, operated with mouse and keys. Most tests check what is painted.

#include "tests/support/suite.h"
#include "tests/ui/window/window_fixture.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/solver_form.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/table_panel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/exports.h"
#include "ui/window/messages.h"
#include "ui/window/scene_file.h"
#include "ui/window/window_settings.h"

#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QStatusBar>
#include <QTableView>
#include <QTextBrowser>

#include <map>

using namespace slidercrank;

namespace
{

bool isBlank(const QImage &image)
{
    QImage uniform = image;
    uniform.fill(image.pixelColor(0, 0));
    return image == uniform;
}

/// Writes the columns of the sample into three files, as CAD programs export plots. Returns the paths.
QStringList plotsOfSample(const QTemporaryDir &folder)
{
    const QByteArrayList lines = contentOf(kSample).mid(3).trimmed().split('\n');
    QStringList paths;
    for (const auto &[name, columns] :
         {std::pair{"coupler.csv", QList<int>{0, 4, 5, 6}}, std::pair{"position.csv", QList<int>{0, 1}},
          std::pair{"rates.csv", QList<int>{0, 2, 3}}}) {
        QByteArray text;
        for (const QByteArray &line : lines) {
            QByteArrayList cells;
            for (const int column : columns) {
                cells << line.trimmed().split(',').value(column);
            }
            text += cells.join(',') + '\n';
        }
        paths += writeFile(folder, QLatin1String(name), text);
    }
    return paths;
}

} // namespace

class TestMainWindow : public WindowFixture
{
    Q_OBJECT

private slots:
    void init()
    {
        resetSettings();
        openWindow();
    }

    void cleanup() { m_window.reset(); }

    void startsStoppedWithEverythingDrawn()
    {
        QCOMPARE(session().time(), 0.0);
        QVERIFY(!part<Timeline>("timeline")->isPlaying());
        QVERIFY(!messages()->isVisible());
        QCOMPARE(part<QTabBar>("tabBar")->currentIndex(), 0);
        for (const QString &name : PlotGrid::plotNames() + QStringList("mechanismView")) {
            QVERIFY2(name.contains("error") || !isBlank(picture(name)), qPrintable(name));
        }
    }

    void greetsTheFirstTimeOnly()
    {
        m_window->messages().greetOnce();
        QVERIFY(messages()->isVisible() && messages()->text().contains("Space"));
        child<QAbstractButton>(*messages(), "messageRemedy")->click();
        AWAIT(session().reference());
        QVERIFY(!messages()->text().contains("Space"));
        openWindow();
        m_window->messages().greetOnce();
        QVERIFY(!messages()->isVisible());
    }

    void anUnreadProblemStaysUntilItIsDismissed()
    {
        const QSize columns = part("columns")->size();
        m_window->exports().write(m_window->exports().figure(), "/no/such/folder/figure.png");
        QVERIFY(messages()->isVisible() && messages()->text().contains("figure.png cannot be written"));
        openSample();
        session().setParameter(Parameter::B, -1.0); // a problem of another kind
        m_window->exports().copy(m_window->exports().figure());
        QCOMPARE(messages()->text().count('\n'), 2);
        session().setParameter(Parameter::B, 64.0);
        QVERIFY(!messages()->text().contains("at least")); // the length is valid again
        letTimePass(*part("confirmation"));                // until the hint disappears
        settle();
        QVERIFY(messages()->text().startsWith("/no/such/folder/figure.png cannot be written"));
        QCOMPARE(messages()->text().count('\n'), 0);
        QCOMPARE(part("columns")->size(), columns); // messages do not change the layout
        child<QAbstractButton>(*messages(), "messageDismiss")->click();
        QVERIFY(!messages()->isVisible() && messages()->text().isEmpty());
    }

    void movingASliderChangesWhatIsPainted()
    {
        for (const char *name : {"slider_a", "slider_b", "slider_c", "slider_omega2", "slider_theta20"}) {
            auto *slider = part<QSlider>(QLatin1String(name));
            const QImage before = picture("plot_theta3_diff");
            slider->setValue(slider->value() + (slider->maximum() - slider->minimum()) / 20);
            QVERIFY2(picture("plot_theta3_diff") != before, name);
        }
        auto *time = part<QSlider>("timeSlider");
        const QImage before = picture("mechanismView");
        time->setValue(time->maximum() / 4);
        QCOMPARE(session().time(), 0.25);
        QVERIFY(picture("mechanismView") != before);
        QWidget *plot = part("plot_R4_x");
        QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, plot->rect().center());
        AWAIT(session().time() > 0.4 && session().time() < 0.7);
    }

    void theTabOfTheErrorsShowsTheVerdict()
    {
        const QImage curve = picture("plot_theta3");
        drop({kSample});
        AWAIT(session().diagnosis());
        settle(*m_window);
        QVERIFY(picture("plot_theta3") != curve && !isBlank(picture("plot_error_position")));
        auto *errors = part<TablePanel>("errorPanel");
        QVERIFY(errors->isVisible() && !messages()->isVisible());
        QVERIFY(part<QTabBar>("tabBar")->tabText(1).contains(QStringLiteral("✗")));
        QCOMPARE(part<QTableView>("errorTable")->model()->rowCount(), 6);
        const QString sentence = child<QLabel>(*errors, "findingLabel")->text();
        QVERIFY2(sentence.contains("60") && sentence.contains("65 mm"), qPrintable(sentence));
        QTest::mouseClick(child<QPushButton>(*errors, "remedyButton"), Qt::LeftButton);
        QVERIFY(std::abs(session().parameters().b - 60.0) < 1e-5);
        for (const ChannelComparison &channel : session().result()->comparison) {
            QCOMPARE(channel.verdict, Verdict::Agrees);
        }
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session().parameters(), Parameters());
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        AWAIT(session().diagnosis() && session().diagnosis()->parameters == session().parameters());
        settle(*m_window);
        QVERIFY(!errors->findChild<QLabel *>("findingLabel")); // there is no error to explain
        action("Close reference")->trigger();
        QVERIFY(!session().reference() && !action("Close reference")->isEnabled());
    }

    /// A former defect: a click had no visible effect while the plots were zoomed to another time range.
    void aRowOfTheErrorTableShowsItsTime()
    {
        openSample();
        auto *plots = m_window->findChild<PlotGrid *>();
        const double time = session().result()->comparison[0].timeOfMaxAbs;
        PlotZoom zoom;
        zoom.time = time < 0.5 ? Interval{0.6, 0.9} : Interval{0.1, 0.4};
        plots->setZoom(zoom);
        auto *table = part<QTableView>("errorTable");
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(0, 0)).center());
        QCOMPARE(session().time(), time);
        QVERIFY(!plots->zoom().time || (plots->zoom().time->lower <= time && time <= plots->zoom().time->upper));
    }

    /// The heading of the first file does not say that its first column is the crank angle; that of the second one
    /// does.
    void theFirstColumnIsTheTimeOrTheCrankAngle()
    {
        const QTemporaryDir folder;
        QByteArray rows;
        for (int angle = 0; angle <= 360; angle += 15) {
            const double theta2 = angle / kDegreesPerRadian;
            const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
            rows += QByteArray::number(angle) + ',' +
                    QByteArray::number(20.0 * std::cos(theta2) + 65.0 * std::cos(theta3), 'f', 6) + '\n';
        }
        QSignalSpy loaded(&session(), &Session::referenceLoaded);
        drop({writeFile(folder, "table.csv", "phi,R4_x\n" + rows)});
        AWAIT(loaded.count() == 1);
        QCOMPARE(session().result()->comparison.front().verdict, Verdict::Differs); // the angles were read as seconds
        QVERIFY(messages()->text().contains("The time range is now that of table.csv: 0 s to 360 s."));
        session().setSampling({0.0, 3.0, 200});
        QVERIFY(!messages()->text().contains("The time range"));
        showTab(2);
        const auto remedies = part("referencePanel")->findChildren<QPushButton *>();
        const auto byAngle =
            std::ranges::find(remedies, QString("First column is the crank angle"), &QPushButton::text);
        QVERIFY(byAngle != remedies.end());
        (*byAngle)->click();
        AWAIT(session().reference()->data.crank.has_value());
        QCOMPARE(session().result()->comparison.front().verdict, Verdict::Agrees);
        session().undoStack().undo();
        QVERIFY(!session().reference()->data.crank);

        drop({writeFile(folder, "named.csv", "Crank angle,R4_x\n" + rows)});
        AWAIT(session().reference()->name == "named.csv");
        QCOMPARE(session().result()->comparison.front().verdict, Verdict::Agrees);
        QVERIFY(messages()->text().contains("named.csv is a table by crank angle: ω₂ and θ₂₀ give its time."));
    }

    void aWrongFileIsReportedAndTheReferenceRemains()
    {
        const QTemporaryDir folder;
        openSample();
        drop({writeFile(folder, "bad.csv", "hello\n")});
        AWAIT(messages()->text().contains("bad.csv"));
        QCOMPARE(session().result()->comparison.size(), std::size_t(6));
        drop({writeFile(folder, "bad.csv", "time,R4_x\n0,85\n1,85\n")}); // the user has corrected the file
        AWAIT(session().reference()->name == "bad.csv");
        QVERIFY2(!messages()->text().contains("cannot"), qPrintable(messages()->text()));
    }

    void asksForTheMeaningOfUnclearColumns()
    {
        const QTemporaryDir folder;
        m_window->openReference(writeFile(folder, "columns.csv", "time,J1_x,J2_x\n0,80,1\n1,70,2\n2,75,1\n"));
        AWAIT(messages()->isVisible());
        const auto *choose = child<QAbstractButton>(*messages(), "messageRemedy");
        QCOMPARE(choose->text(), QStringLiteral("Choose columns…"));
        QTest::mouseClick(const_cast<QAbstractButton *>(choose), Qt::LeftButton);
        auto *dialog = part<QDialog>("columnMapping");
        auto *second = child<QComboBox>(*dialog, "meaning2");
        second->setCurrentIndex(second->findText("(R4_x)", Qt::MatchContains));
        QTest::mouseClick(child<QAbstractButton>(*dialog, "useButton"), Qt::LeftButton);
        const Channel slider{R4x, Order::Position};
        AWAIT(session().reference() && session().reference()->data.find(slider) &&
              session().reference()->data.find(slider)->values.front() == 1.0);
    }

    void severalFilesOfOneMotionAreJoined()
    {
        const QTemporaryDir folder;
        const QStringList plots = plotsOfSample(folder);
        const auto errors = [this] {
            std::map<std::size_t, std::pair<std::optional<double>, Verdict>> byChannel;
            for (const ChannelComparison &channel : session().result()->comparison) {
                byChannel[indexOf(channel.channel)] = {channel.maxAbs, channel.verdict};
            }
            return byChannel;
        };
        openSample();
        const auto whole = errors();
        QCOMPARE(whole.size(), std::size_t(6));
        drop({plots[2], plots[0], plots[1]}); // not in alphabetical order
        AWAIT(session().reference()->paths == plots && session().diagnosis());
        QVERIFY(errors() == whole);
        QCOMPARE(session().reference()->name, QStringLiteral("coupler.csv + 2 more"));
        QCOMPARE(recentFiles(), (QList<QStringList>{plots, {kSample}}));
        drop({plots[1]});
        AWAIT_COMPARE(session().reference()->paths, QStringList(plots[1]));
        emit part<QMenu>("recentMenu")->aboutToShow();
        action(QDir::toNativeSeparators(plots[0]) + " + 2 more")->trigger();
        AWAIT_COMPARE(session().reference()->paths, plots);

        const auto shown = session().reference();
        struct Row {
            QStringList paths;
            const char *says;
        };
        for (const Row &row : {Row{{plots[1], kSample}, "both this file and"},
                               Row{{plots[1], folder.filePath("gone.csv")}, "gone.csv cannot be opened"},
                               Row{{plots[1], folder.filePath("rig.slidercrank")}, "rig.slidercrank is a scene"}}) {
            drop(row.paths);
            AWAIT2(messages()->text().contains(row.says), row.says);
            QVERIFY(session().reference() == shown);
        }
    }

    void showsThePinnedMotionBelowTheCurrentOne()
    {
        const QImage linkage = picture("mechanismView");
        press(Qt::Key_K, Qt::ControlModifier);
        QVERIFY(session().pinned() == std::vector<Parameters>{Parameters()});
        QCOMPARE(picture("mechanismView"), linkage); // the pinned motion is the current one
        session().setParameter(Parameter::B, 80.0);
        const QImage both = picture("plot_R4_x");
        const QImage ghost = picture("mechanismView");
        action("Show the motion of the file or pinned")->trigger();
        QVERIFY(picture("mechanismView") != ghost);
        action("Show the motion of the file or pinned")->trigger();
        QCOMPARE(picture("mechanismView"), ghost);
        showTab(1);
        QVERIFY(part<QLabel>("errorPanelSentence")->text().contains("b = 65 mm"));
        QVERIFY(!isBlank(picture("plot_error_velocity")));
        press(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(session().pinned().empty() && picture("plot_R4_x") != both && picture("mechanismView") != ghost);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(picture("plot_R4_x"), both);
        emit m_window->findChild<PlotGrid *>()->pinRequested(); // by the menu of the plots
        QCOMPARE(session().pinned().size(), std::size_t(2));
    }

    void theStatusLineShowsWhatWasComputed()
    {
        const auto said = [this] { return m_window->statusBar()->currentMessage(); };
        QVERIFY2(!said().contains("form"), qPrintable(said())); // closed form is the default and is not mentioned
        session().setSampling({0.0, 1.0, 1'000'000});
        QVERIFY2(!said().contains(" ms"), qPrintable(said())); // so many samples are not computed in advance
        session().setSampling({0.0, 1.0, 200});
        SolverSettings solver{Method::Newton, {}};
        session().setSolver(solver);
        QVERIFY2(said().contains("201 samples in ") && said().contains("Newton-Raphson"), qPrintable(said()));
        solver.newton.maxIterations = 2;
        session().setSolver(solver);
        const std::size_t unsolved = session().result()->summary.count(Status::IterationLimit);
        QVERIFY(unsolved > 0);
        QVERIFY2(said().contains(QString("%1 of 201 time steps not solved").arg(unsolved)), qPrintable(said()));
        session().setParameter(Parameter::B, 40.0);
        QVERIFY2(said().contains("cannot be assembled at "), qPrintable(said()));
    }

    void showsAMechanismThatCannotBeAssembledAndRecovers()
    {
        session().setParameter(Parameter::B, 4.0); // less than |c| - a = 5; changed twice, because the view may grow
        session().setParameter(Parameter::B, 65.0);
        const QImage possible = picture("mechanismView");
        session().setParameter(Parameter::B, 4.0);
        QVERIFY(picture("mechanismView") != possible);
        session().setParameter(Parameter::B, 65.0);
        QCOMPARE(picture("mechanismView"), possible);
    }

    void createsPanelsWhenTheyAreFirstShown()
    {
        QVERIFY(!m_window->findChild<SolverForm *>());
        auto *bar = part<QTabBar>("tabBar");
        for (int tab = 0; tab < bar->count(); ++tab) {
            QTest::mouseClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(tab).center());
        }
        auto *method = part<QComboBox>("methodBox");
        method->setCurrentIndex(1 - method->currentIndex());
        emit method->activated(method->currentIndex());
        QCOMPARE(session().solver().method, Method::Newton);

        showTab(3);
        part<QAbstractButton>("segment1")->click(); // the page of the equations
        settle(*m_window);
        const QImage before = picture("mechanismView");
        auto *table = part<QTableView>("equationTable");
        table->setFocus();
        table->setCurrentIndex(table->model()->index(CrankPinX, 0)); // its joint is highlighted
        const QImage crankPin = picture("mechanismView");
        table->setCurrentIndex(table->model()->index(SliderPinX, 0));
        QVERIFY(crankPin != before && picture("mechanismView") != crankPin);
        showTab(0);
        QCOMPARE(picture("mechanismView"), before);
    }

    void runningTheStudyKeepsTheFocus()
    {
        showTab(4);
        part("runThisButton")->setFocus(Qt::TabFocusReason);
        press(Qt::Key_Return);
        settle();
        QVERIFY(m_window->focusWidget() && part("studyPanel")->isAncestorOf(m_window->focusWidget()));
        press(Qt::Key_Return); // the same button cancels
        finishAside();
        QVERIFY(part("studyPanel")->isAncestorOf(m_window->focusWidget()));
    }

    void foldsThePanelsOfASmallWindowUntilTheUserChooses()
    {
        auto *tabs = m_window->findChild<FoldingTabs *>();
        m_window->resize(1024, 700);
        AWAIT(tabs->isFolded());
        AWAIT(part("plotsAndTabs")->height() - m_window->findChild<PlotGrid *>()->height() < 60);
        QCOMPARE(m_window->size(), QSize(1024, 700));
        m_window->resize(1400, 900);
        AWAIT(!tabs->isFolded());
        press(Qt::Key_F9);
        QVERIFY(tabs->isFolded() && !action("Show the panels below")->isChecked());
        m_window->resize(1400, 910);
        settle();
        QVERIFY(tabs->isFolded());
        auto *bar = part<QTabBar>("tabBar");
        for (int click = 0; click < 2; ++click) { // the second click, on the current tab, does not fold the panels
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(0).center());
            QVERIFY(!tabs->isFolded());
        }
    }

    void aThemeLooksTheSameWhetherChosenBeforeOrLater()
    {
        const auto look = [this](Theme first, Theme then) {
            m_window->setTheme(first);
            session().setParameter(Parameter::B, 64.0);
            openSample();
            onEveryPage(*m_window, [](const QString &) {});
            m_window->setTheme(then);
            QList<QImage> pictures;
            onEveryPage(*m_window, [&](const QString &) {
                m_window->statusBar()->clearMessage(); // it shows a duration, which varies
                pictures << m_window->grab().toImage();
            });
            return pictures;
        };
        const QList<QImage> live = look(Theme::Light, Theme::Dark);
        init();
        const QList<QImage> before = look(Theme::Dark, Theme::Dark);
        QVERIFY(qGray(picture("plot_theta3").pixel(2, 2)) < 80);
        m_window->setTheme(Theme::Light);
        settle(*m_window);
        QVERIFY(qGray(picture("plot_theta3").pixel(2, 2)) > 200);
        m_window->setTheme(Theme::System);
        QVERIFY(live.size() > 10);
        for (qsizetype i = 0; i < live.size(); ++i) {
            QVERIFY2(live[i] == before[i], qPrintable(QString::number(i)));
        }
    }

    void mechanismAndPlotsFillTheScreenInPresentationMode()
    {
        m_window->resize(1250, 850);
        openSample();
        auto *columns = part<QSplitter>("columns");
        auto *mechanism = m_window->findChild<MechanismView *>();
        const auto fontSize = [this](const char *name) { return QFontInfo(part(name)->font()).pixelSize(); };
        const auto header = [this] { return part<QTableView>("errorTable")->horizontalHeader()->font().toString(); };
        const QList<int> sizes = columns->sizes();
        const int usual = fontSize("mechanismView");
        const QString usualHeader = header();
        const QImage errors = picture("errorPanel");

        press(Qt::Key_F11);
        QVERIFY(m_window->isFullScreen() && mechanism->settings().angles);
        QVERIFY(m_window->menuBar()->height() <= 1 && !m_window->statusBar()->isVisible());
        auto *tabs = m_window->findChild<FoldingTabs *>();
        QVERIFY(tabs->isFolded() && !part("plot_error_position")->isVisible());
        press(Qt::Key_F9);
        QVERIFY(!tabs->isFolded() && part("errorTable")->isVisible());
        press(Qt::Key_F9);
        const int large = std::max(usual, m_window->screen()->size().height() / 45);
        QCOMPARE(fontSize("mechanismView"), large);
        QCOMPARE(QFontInfo(m_window->findChild<PlotGrid *>()->font()).pixelSize(), large);
        QVERIFY(part("parameterBox")->isVisible() && !part("box_a")->isVisible() && !part("box_c")->isVisible());
        part<QComboBox>("parameterBox")->setCurrentIndex(2);
        part("box_c")->setFocus();
        press(Qt::Key_Up);
        QCOMPARE(session().parameters().c, 26.0);
        press(Qt::Key_Z, Qt::ControlModifier); // the shortcuts work although the menus are hidden
        QCOMPARE(session().parameters().c, 25.0);
        m_window->exports().copy(m_window->exports().figure());
        QVERIFY(!messages()->isVisible());
        press(Qt::Key_K, Qt::ControlModifier);
        press(Qt::Key_Escape);
        settle(*m_window);
        QVERIFY(!m_window->isFullScreen() && !mechanism->settings().angles && messages()->isVisible());
        QVERIFY(!tabs->isFolded() && part("box_a")->isVisible() && !part("parameterBox")->isVisible());
        QVERIFY(m_window->menuBar()->height() > 1 && m_window->statusBar()->isVisible());
        AWAIT_COMPARE(columns->sizes().first(), sizes.first());
        QCOMPARE(QFontInfo(m_window->findChild<PlotGrid *>()->font()).pixelSize(), usual);
        QCOMPARE(header(), usualHeader); // a former defect: it stayed large
        session().unpinMotions();
        settle(*m_window);
        QCOMPARE(picture("errorPanel"), errors);

        m_window->resize(1240, 850);
        settle(*m_window);
        QVERIFY(!tabs->isFolded()); // F9 in presentation mode does not affect the usual window
        m_window->setWindowState(Qt::WindowMaximized);
        press(Qt::Key_F11);
        QCOMPARE(m_window->windowState(), Qt::WindowMaximized | Qt::WindowFullScreen);
        press(Qt::Key_F11);
        QCOMPARE(m_window->windowState(), Qt::WindowMaximized);
        m_window->setWindowState(Qt::WindowNoState);
        session().undoStack().setClean();
        press(Qt::Key_F11);
        m_window->close(); // presentation mode is not saved
        openWindow();
        QVERIFY(!m_window->isFullScreen());
    }

    void theEnlargedMechanismFillsTheWindow()
    {
        auto *mechanism = m_window->findChild<MechanismView *>();
        const int width = mechanism->width();
        emit mechanism->enlarged();
        QVERIFY(!part("plot_R4_x")->isVisible());
        AWAIT(mechanism->width() > width + 100);
        mechanism->setFocus();
        press(Qt::Key_Escape);
        QVERIFY(part("plot_R4_x")->isVisible());
    }

    void restoresItsLayout()
    {
        const QSize size(780, 740); // smaller than the screen
        const auto box = [this](const char *name) { return part<QComboBox>(QLatin1String(name)); };
        m_window->resize(size);
        part<QSplitter>("columns")->setSizes({360, 420});
        const MechanismSettings drawing{true, false, false, true};
        m_window->findChild<MechanismView *>()->setSettings(drawing);
        box("unit_theta20")->setCurrentIndex(1);
        box("unit_omega2")->setCurrentIndex(2);
        showTab(4);
        press(Qt::Key_F9); // the tabs were folded, because the window is low
        QVERIFY(!m_window->findChild<FoldingTabs *>()->isFolded());
        part<Timeline>("timeline")->setSpeed(0.005);
        const QList<int> sizes = part<QSplitter>("columns")->sizes();
        m_window->close();
        openWindow();
        QCOMPARE(m_window->size(), size);
        QCOMPARE(part<QSplitter>("columns")->sizes(), sizes);
        QVERIFY(m_window->findChild<MechanismView *>()->settings() == drawing);
        QCOMPARE(box("unit_theta20")->currentIndex(), 1);
        QCOMPARE(box("unit_omega2")->currentIndex(), 2);
        QCOMPARE(part<QTabBar>("tabBar")->currentIndex(), 4);
        QVERIFY(!m_window->findChild<FoldingTabs *>()->isFolded());
        QCOMPARE(part<Timeline>("timeline")->speed(), 0.005);
        QVERIFY(!m_window->isWindowModified());
        m_window->close();
        QSettings().setValue("view/speed", "fast"); // invalid values, as if edited by hand
        QSettings().setValue("view/tab", 99);
        QSettings().setValue("view/unit_theta20", -7);
        openWindow();
        QVERIFY(part<Timeline>("timeline")->speed() > 0.0 && box("unit_theta20")->currentIndex() >= 0);
    }

    void exclusiveChoicesAreRadioActions()
    {
        int groups = 0;
        for (const QAction *action : m_window->findChildren<QAction *>()) {
            if (action->actionGroup() && action->actionGroup()->actions().first() == action) {
                QVERIFY2(action->actionGroup()->isExclusive(), qPrintable(action->text()));
                ++groups;
            }
        }
        QVERIFY(groups >= 4); // theme, language, error, speed
    }

    void theLanguageChangesAtTheNextStart()
    {
        action(QStringLiteral("Español"))->trigger();
        QVERIFY(messages()->text().contains("start the program again"));
        QCOMPARE(chosenLanguage(), Language::Spanish);
        setLanguage(chosenLanguage());
        openWindow();
        QCOMPARE(m_window->menuBar()->actions().first()->text(), QStringLiteral("&Archivo"));
        action("English")->trigger();
        setLanguage(chosenLanguage());
        QLocale::setDefault(QLocale::c());
    }

    void theHelpDescribesEveryKeyAndFormatsFormulas()
    {
        for (const char *name : {":/help/english.html", ":/help/spanish.html"}) {
            const QString page = QString::fromUtf8(contentOf(name));
            QVERIFY(page.contains("C<sub>q</sub>") && !page.contains(QChar(0x307)) && !page.contains(u'_'));
            int keys = 0;
            for (const QAction *action : m_window->findChildren<QAction *>()) {
                for (const QKeySequence &key : action->shortcuts()) {
                    QVERIFY2(page.contains(key.toString(QKeySequence::PortableText)), qPrintable(key.toString()));
                    ++keys;
                }
            }
            QVERIFY(keys > 20);
        }
        for (const char *title : {"Theory and help", "Keyboard and mouse"}) {
            action(title)->trigger();
            auto *page = m_window->findChild<QDialog *>("help");
            QVERIFY(page && page->isVisible() && !page->isModal());
            QCOMPARE(page->windowTitle(), QString(title));
            QVERIFY(page->findChild<QTextBrowser *>()->toPlainText().contains(title));
            QTest::keyClick(page, Qt::Key_Escape);
            AWAIT(!m_window->findChild<QDialog *>("help"));
        }
    }
};

const Suite suite("tst_main_window", runWithWidgets<TestMainWindow>);
#include "tst_main_window.moc"
