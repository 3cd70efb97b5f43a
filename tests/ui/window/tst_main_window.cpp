// SPDX-License-Identifier: GPL-3.0-or-later

// The window as its user has it: hands on the controls, eyes on what is painted.

#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/export/animation_export.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/newton_panel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/table_panel.h"
#include "ui/window/exports.h"
#include "ui/window/help_page.h"
#include "ui/window/main_window.h"
#include "ui/window/remembered.h"
#include "ui/window/scene_file.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QSplitter>
#include <QStandardPaths>
#include <QStatusBar>
#include <QStyleOptionSlider>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <map>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

const QStringList kPlots = {"plot_theta3",       "plot_R4_x",       "plot_error_position",
                            "plot_theta3_diff",  "plot_R4_x_diff",  "plot_error_velocity",
                            "plot_theta3_diff2", "plot_R4_x_diff2", "plot_error_acceleration"};

QImage pictureOf(QWidget &window, const QString &name)
{
    QWidget *widget = window.findChild<QWidget *>(name);
    if (!widget) {
        qFatal("no widget named %s", qPrintable(name));
    }
    QCoreApplication::processEvents();
    return widget->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

bool isBlank(const QImage &image)
{
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) != image.pixel(0, 0)) {
                return false;
            }
        }
    }
    return true;
}

void drop(QWidget &window, const QStringList &paths)
{
    QMimeData data;
    QList<QUrl> urls;
    for (const QString &path : paths) {
        urls += QUrl::fromLocalFile(path);
    }
    data.setUrls(urls);
    const QPointF middle = window.rect().center();
    QDragEnterEvent enter(middle.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    QVERIFY(event.isAccepted());
}

void drop(QWidget &window, const QString &path)
{
    drop(window, QStringList(path));
}

/// The sample's columns, two to three a file.
QStringList plotsOfSample(const QTemporaryDir &folder)
{
    QFile file(kSample);
    const QByteArrayList lines =
        file.open(QIODevice::ReadOnly) ? file.readAll().mid(3).trimmed().split('\n') : QByteArrayList();
    QStringList paths;
    for (const auto &[name, columns] :
         {std::pair{"coupler.csv", QList<int>{0, 4, 5, 6}}, std::pair{"position.csv", QList<int>{0, 1}},
          std::pair{"rates.csv", QList<int>{0, 2, 3}}}) {
        paths += folder.filePath(QLatin1String(name));
        QFile plot(paths.last());
        if (!plot.open(QIODevice::WriteOnly)) {
            qFatal("cannot write %s", name);
        }
        for (const QByteArray &line : lines) {
            QByteArrayList cells;
            for (const int column : columns) {
                cells << line.trimmed().split(',').value(column);
            }
            plot.write(cells.join(',') + '\n');
        }
    }
    return paths;
}

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

} // namespace

class TestMainWindow : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setCursorFlashTime(0);
    }

    void init()
    {
        QSettings().clear();
        QSettings().setValue(QStringLiteral("greeted"), true);
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void startsCalmWithEverythingDrawn()
    {
        QCOMPARE(m_window->session().time(), 0.0);
        QVERIFY(!m_window->findChild<Timeline *>()->isPlaying());
        QVERIFY(!m_window->findChild<MessageBar *>()->isVisible());
        for (const QString &name : kPlots) {
            QVERIFY2(!isBlank(pictureOf(*m_window, name)), qPrintable(name));
        }
        QVERIFY(!isBlank(pictureOf(*m_window, QStringLiteral("mechanismView"))));
    }

    void everyControlHasAName()
    {
        for (QWidget *widget : m_window->findChildren<QWidget *>()) {
            const bool control = qobject_cast<QAbstractButton *>(widget) || qobject_cast<QAbstractSlider *>(widget) ||
                                 qobject_cast<QComboBox *>(widget) || qobject_cast<QLineEdit *>(widget);
            const bool ours = !widget->objectName().startsWith(QLatin1String("qt_"));
            if (control && ours && widget->isVisibleTo(m_window.get())) {
                const auto *button = qobject_cast<QAbstractButton *>(widget);
                const QString name =
                    widget->accessibleName().isEmpty() && button ? button->text() : widget->accessibleName();
                const QWidget *owner = widget->parentWidget(); // a box's own line edit speaks with the box's name
                QVERIFY2(!name.isEmpty() || !owner->accessibleName().isEmpty() || owner->inherits("QScrollBar") ||
                             widget->inherits("QScrollBar"),
                         qPrintable(widget->objectName() + QLatin1String(widget->metaObject()->className())));
            }
        }
    }

    void saysWhatToDoTheFirstTimeOnly()
    {
        QSettings().remove(QStringLiteral("greeted"));
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        const auto *bar = m_window->findChild<MessageBar *>();
        QVERIFY(bar->isVisible() && bar->text().contains(QLatin1String("Space")));
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        m_window->findChild<QAbstractButton *>(QStringLiteral("messageRemedy"))->click();
        QVERIFY(loaded.wait(kPatience));
        QVERIFY(m_window->session().reference());

        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(!m_window->findChild<MessageBar *>()->isVisible());
    }

    void listsEveryKeyOfItsMenusInTheHelp()
    {
        const QString page = shortcutsText(*m_window->menuBar());
        int keys = 0;
        for (const QAction *action : m_window->findChildren<QAction *>()) {
            for (const QKeySequence &key : action->shortcuts()) {
                const QString row =
                    QStringLiteral("<tr><td>[^<]*%1</td><td[^>]*>[^<]*%2")
                        .arg(QRegularExpression::escape(action->text().remove(u'&').toHtmlEscaped()),
                             QRegularExpression::escape(key.toString(QKeySequence::NativeText).toHtmlEscaped()));
                QVERIFY2(page.contains(QRegularExpression(row)), qPrintable(action->text()));
                ++keys;
            }
        }
        QVERIFY(keys > 15);

        m_window->session().setParameter(Parameter::B, 70.0);
        QVERIFY(m_window->session().undoStack().canUndo());
        QCOMPARE(shortcutsText(*m_window->menuBar()), page);
    }

    void helpStandsBesideTheWindow()
    {
        for (const QString &name : {QStringLiteral("Theory and help"), QStringLiteral("Keyboard and mouse")}) {
            for (QAction *action : m_window->findChildren<QAction *>()) {
                if (action->text().remove(u'&') == name) {
                    action->trigger();
                }
            }
            auto *page = m_window->findChild<HelpPage *>();
            QVERIFY(page && page->isVisible() && !page->isModal());
            QCOMPARE(page->windowTitle(), name);
            QTest::keyClick(page, Qt::Key_Escape);
            AWAIT(!m_window->findChild<HelpPage *>());
        }
    }

    void movingASliderChangesWhatIsPainted_data()
    {
        QTest::addColumn<QString>("slider");
        QTest::addColumn<QString>("plot");
        for (const char *name : {"a", "b", "c", "omega2", "theta20"}) {
            QTest::newRow(name) << QStringLiteral("slider_%1").arg(QLatin1String(name))
                                << QStringLiteral("plot_theta3_diff");
        }
    }

    void movingASliderChangesWhatIsPainted()
    {
        QFETCH(const QString, slider);
        QFETCH(const QString, plot);
        auto *control = m_window->findChild<QSlider *>(slider);
        QVERIFY(control);
        const QImage before = pictureOf(*m_window, plot);
        const Parameters parameters = m_window->session().parameters();
        control->setValue(control->value() + (control->maximum() - control->minimum()) / 20);
        QVERIFY(!(m_window->session().parameters() == parameters));
        QVERIFY(pictureOf(*m_window, plot) != before);
    }

    void aDragOfASliderIsUndoneByItsKey()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto *slider = m_window->findChild<QSlider *>(QStringLiteral("slider_b"));
        QStyleOptionSlider option;
        option.initFrom(slider);
        option.orientation = Qt::Horizontal;
        option.minimum = slider->minimum();
        option.maximum = slider->maximum();
        option.sliderPosition = option.sliderValue = slider->sliderPosition();
        const QPoint handle =
            slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, handle);
        for (const int pixels : {5, 10, 15}) {
            QTest::mouseMove(slider, handle + QPoint(pixels, 0));
        }
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, handle + QPoint(15, 0));
        const double dragged = m_window->session().parameters().b;
        QVERIFY(dragged > 65.0);
        QCOMPARE(m_window->session().undoStack().count(), 1);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters().b, 65.0);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(m_window->session().parameters().b, dragged);
    }

    void aTypedNumberIsUndoneWithTheFocusStillInItsBox()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto *box = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("box_b"));
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QStringLiteral("70"));
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters().b, 65.0);
    }

    void scrubbingMovesThePose()
    {
        auto *slider = m_window->findChild<QSlider *>(QStringLiteral("timeSlider"));
        const QImage before = pictureOf(*m_window, QStringLiteral("mechanismView"));
        slider->setValue((slider->minimum() + slider->maximum()) / 4);
        QVERIFY(m_window->session().time() > 0.2);
        QVERIFY(m_window->session().time() < 0.3);
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) != before);
    }

    void clickingAPlotScrubs()
    {
        auto *plot = m_window->findChild<QWidget *>(QStringLiteral("plot_R4_x"));
        QTest::mouseClick(plot, Qt::LeftButton, Qt::NoModifier, plot->rect().center());
        AWAIT(m_window->session().time() > 0.3 && m_window->session().time() < 0.7);
    }

    void playingFollowsTheClock()
    {
        auto *timeline = m_window->findChild<Timeline *>();
        double clock = 77.0; // s
        timeline->setClock([&clock] { return clock; });
        QTest::mouseClick(m_window->findChild<QAbstractButton *>(QStringLiteral("playButton")), Qt::LeftButton);
        QVERIFY(timeline->isPlaying());
        clock += 0.4;
        letTimePass(*timeline);
        QVERIFY(std::abs(m_window->session().time() - 0.4) < 1e-9);
        timeline->pause();
        clock += 0.1;
        letTimePass(*timeline);
        settle();
        QVERIFY(std::abs(m_window->session().time() - 0.4) < 1e-9);
    }

    void playbackKeysWorkFromAnywhereButWhereTheyAreNeeded()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto *view = m_window->findChild<QWidget *>(QStringLiteral("mechanismView"));
        view->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_End);
        QCOMPARE(m_window->session().time(), 1.0);
        QTest::keyClick(m_window.get(), Qt::Key_Left);
        QVERIFY(std::abs(m_window->session().time() - 0.995) < 1e-9);
        QTest::keyClick(m_window.get(), Qt::Key_Home);
        QCOMPARE(m_window->session().time(), 0.0);

        auto *slider = m_window->findChild<QSlider *>(QStringLiteral("slider_b"));
        slider->setFocus();
        const double b = m_window->session().parameters().b;
        QTest::keyClick(slider, Qt::Key_Right);
        QVERIFY(m_window->session().parameters().b > b);
        QCOMPARE(m_window->session().time(), 0.0);

        auto *box = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("box_b")); // a number has no spaces
        box->setFocus();
        const QString text = box->text();
        const auto *timeline = m_window->findChild<Timeline *>();
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(timeline->isPlaying());
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(!timeline->isPlaying());
        QCOMPARE(box->text(), text);
    }

    void droppingACsvFillsOverlayAndTable()
    {
        const QImage curve = pictureOf(*m_window, QStringLiteral("plot_theta3"));
        const QImage error = pictureOf(*m_window, QStringLiteral("plot_error_position"));
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        drop(*m_window, kSample);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(m_window->session().result()->comparison.size(), std::size_t(6));
        QVERIFY(pictureOf(*m_window, QStringLiteral("plot_theta3")) != curve);
        QVERIFY(pictureOf(*m_window, QStringLiteral("plot_error_position")) != error);
        const auto *table = m_window->findChild<QTableView *>(QStringLiteral("errorTable"));
        AWAIT((table = m_window->findChild<QTableView *>(QStringLiteral("errorTable"))) && table->isVisible());
        QCOMPARE(table->model()->rowCount(), 6);
    }

    /// A table by the crank's angle under a name that does not say so.
    void theFirstColumnIsTheTimeOrTheCranksAngle()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("table.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("phi,R4_x\n");
        for (int angle = 0; angle <= 360; angle += 15) {
            const double theta2 = angle / kDegreesPerRadian;
            const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
            const double x = 20.0 * std::cos(theta2) + 65.0 * std::cos(theta3);
            file.write(QByteArray::number(angle) + ',' + QByteArray::number(x, 'f', 6) + '\n');
        }
        file.close();
        Session &session = m_window->session();
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        drop(*m_window, path);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.result()->comparison.front().verdict, Verdict::Differs); // 0, 15, 30 s
        auto *panel = m_window->findChild<TablePanel *>(QStringLiteral("referencePanel"));
        m_window->findChild<FoldingTabs *>()->showPage(panel);
        const auto button = [panel](const QString &text) {
            const auto buttons = panel->findChildren<QPushButton *>();
            const auto found = std::ranges::find(buttons, text, &QPushButton::text);
            return found == buttons.end() ? nullptr : *found;
        };
        const Sampling before = session.sampling();
        QVERIFY(button(QStringLiteral("First column is the crank angle")));
        button(QStringLiteral("First column is the crank angle"))->click();
        AWAIT(session.reference()->data.crank.has_value());
        AWAIT(button(QStringLiteral("First column is the time")));
        QCOMPARE(session.result()->comparison.front().verdict, Verdict::Agrees);
        session.setParameter(Parameter::Omega2, 21.0);
        QCOMPARE(session.result()->comparison.front().verdict, Verdict::Agrees);
        QVERIFY(m_window->scene().saveTo(folder.filePath(QStringLiteral("rig.slidercrank"))));

        // Back, step by step.
        session.undoStack().undo();
        session.undoStack().undo();
        QVERIFY(!session.reference()->data.crank);
        QCOMPARE(session.sampling(), before);

        // Files with these headings are read so from now on.
        loaded.clear();
        drop(*m_window, path);
        QVERIFY(loaded.wait(kPatience));
        QVERIFY(session.reference()->data.crank);

        // One that is named so is known by itself, and it is said.
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray table = file.readAll().replace("phi", "Crank angle");
        QFile named(folder.filePath(QStringLiteral("named.csv")));
        QVERIFY(named.open(QIODevice::WriteOnly) && named.write(table) == table.size());
        named.close();
        drop(*m_window, named.fileName());
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.result()->comparison.front().verdict, Verdict::Agrees);
        const QString said = m_window->findChild<MessageBar *>()->text();
        QVERIFY2(said.contains(QStringLiteral("named.csv is a table by crank angle: ω₂ and θ₂₀ give its time.")),
                 qPrintable(said));

        init(); // another window, which knows it of the scene
        QSignalSpy opened(&m_window->session(), &Session::opened);
        drop(*m_window, folder.filePath(QStringLiteral("rig.slidercrank")));
        QVERIFY(opened.wait(kPatience));
        QCOMPARE(opened.first().first().toString(), QString());
        QCOMPARE(m_window->session().parameters().omega2, 21.0);
        QCOMPARE(m_window->session().result()->comparison.front().verdict, Verdict::Agrees);
    }

    /// The verdict is in the errors' tab, which comes to the front, and nowhere else.
    void saysWhoseMotionAFileIsAndTakesItOver()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto *bar = m_window->findChild<MessageBar *>();
        bar->hide();
        m_window->openReference(kSample); // b = 60, on show is 65
        auto *errors = m_window->findChild<TablePanel *>(QStringLiteral("errorPanel"));
        AWAIT(errors->findChild<QPushButton *>(QStringLiteral("remedyButton")));
        QVERIFY(errors->isVisible());
        QVERIFY(!bar->isVisible());
        const QString sentence = errors->findChild<QLabel *>(QStringLiteral("findingLabel"))->text();
        QVERIFY2(sentence.contains(QStringLiteral("60")) && sentence.contains(QStringLiteral("65 mm")), qPrintable(sentence));

        QTest::mouseClick(errors->findChild<QPushButton *>(QStringLiteral("remedyButton")), Qt::LeftButton);
        QVERIFY(std::abs(m_window->session().parameters().b - 60.0) < 1e-5);
        for (const ChannelComparison &channel : m_window->session().result()->comparison) {
            QCOMPARE(channel.verdict, Verdict::Agrees);
        }
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters(), Parameters());
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(std::abs(m_window->session().parameters().b - 60.0) < 1e-5);
    }

    void noSentenceIsCutOffInASmallWindow()
    {
        m_window->resize(1024, 700);
        m_window->findChild<FoldingTabs *>()->setFolded(false);
        m_window->openReference(kSample);
        const auto *errors = m_window->findChild<TablePanel *>(QStringLiteral("errorPanel"));
        AWAIT(errors->findChild<QLabel *>(QStringLiteral("findingLabel")));
        settle(*m_window); // everything has its place
        for (const QString &name : {QStringLiteral("findingLabel"), QStringLiteral("errorPanelSentence")}) {
            const auto *label = errors->findChild<QLabel *>(name);
            QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(name));
        }
        QCOMPARE(m_window->size(), QSize(1024, 700));
    }

    void whatIsFoundInAFileDoesNotHideANewerProblem()
    {
        Session &session = m_window->session();
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        m_window->openReference(kSample);
        QVERIFY(loaded.wait(kPatience));
        session.setParameters(withCoupler(-1.0)); // before the diagnosis is there
        AWAIT(session.diagnosis());
        QVERIFY(m_window->findChild<MessageBar *>()->text().contains(QLatin1String("greater than 0")));
    }

    void aRefusedNumberIsForgottenWithTheNextOne()
    {
        const auto *bar = m_window->findChild<MessageBar *>();
        m_window->session().setParameters(withCoupler(-1.0));
        QVERIFY(bar->isVisible() && bar->text().contains(QLatin1String("greater than 0")));
        m_window->session().setParameters(withCoupler(64.0));
        QVERIFY(!bar->isVisible());
    }

    void saysNothingOfAFileThatAgrees()
    {
        m_window->session().setParameters(withCoupler(60.0));
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        QVERIFY(!m_window->findChild<MessageBar *>()->isVisible());
        QVERIFY(!m_window->findChild<TablePanel *>(QStringLiteral("errorPanel"))->findChild<QLabel *>(QStringLiteral("findingLabel")));
    }

    void theFilesMotionIsShownOrNot()
    {
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        QAction *ghost = nullptr;
        for (QAction *action : m_window->findChildren<QAction *>()) {
            if (action->text().remove(u'&') == QLatin1String("Show the motion of the file or pinned")) {
                ghost = action;
            }
        }
        QVERIFY(ghost && ghost->isEnabled());
        const QImage with = pictureOf(*m_window, QStringLiteral("mechanismView"));
        ghost->trigger();
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) != with);
        ghost->trigger();
        QCOMPARE(pictureOf(*m_window, QStringLiteral("mechanismView")), with);
        m_window->session().setReference(nullptr);
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) != with);
        QVERIFY(!ghost->isEnabled());
    }

    /// "1,000,001 samples in 0.0076 ms": none of them had been computed.
    void tellsNoTimeThatWasNotMeasured()
    {
        const QStatusBar *status = m_window->statusBar();
        m_window->session().setSampling({0.0, 1.0, 1'000'000});
        QVERIFY2(!status->currentMessage().contains(QLatin1String(" ms")), qPrintable(status->currentMessage()));
        m_window->session().setSampling({0.0, 1.0, 200});
        SolverSettings solver;
        solver.method = Method::Newton;
        m_window->session().setSolver(solver);
        QVERIFY2(status->currentMessage().contains(QLatin1String("201 samples in ")),
                 qPrintable(status->currentMessage()));
        QVERIFY(m_window->session().result()->sampleSeconds.value() > 0.0);
    }

    /// "At most 60 iterations, residual 0" was said of a run without an answer.
    void tellsHowManyInstantsHaveNoAnswer()
    {
        SolverSettings solver;
        solver.method = Method::Newton;
        solver.newton.maxIterations = 2;
        m_window->session().setSolver(solver);
        const SamplingSummary &run = m_window->session().result()->summary;
        const std::size_t unsolved = run.count(Status::IterationLimit);
        QVERIFY(unsolved > 0);
        const QString said = m_window->statusBar()->currentMessage();
        QVERIFY2(said.contains(QStringLiteral("%1 of 201 instants not solved").arg(unsolved)), qPrintable(said));
        QVERIFY2(!said.contains(QLatin1String("60")), qPrintable(said));
    }

    /// The largest error of a file longer than the run was out of reach, without a word.
    void aFileLongerThanTheRunBringsItsOwnAndSaysSo()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("ten.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time,R4_x\n");
        for (int i = 0; i <= 200; ++i) { // as it moves, but for one instant
            const double t = 0.05 * i;
            const Pose pose = poseAt({}, t);
            file.write(QByteArray::number(t) + ',' + QByteArray::number(pose.sliderX + (i == 53 ? 5.0 : 0.0), 'g', 9) +
                       '\n');
        }
        file.close();
        m_window->openReference(path);
        const auto *bar = m_window->findChild<MessageBar *>();
        AWAIT(bar->isVisible() && bar->text().contains(QLatin1String("The run is now that of ten.csv: 0 s to 10 s.")));
        AWAIT(m_window->session().diagnosis());
        QVERIFY(bar->text().contains(QLatin1String("The run is now")));
        Session &session = m_window->session();
        session.setTime(session.result()->comparison[0].timeOfMaxAbs);
        QVERIFY(std::abs(session.time() - 2.65) < 1e-9);

        // It is not said of another run.
        session.setSampling({0.0, 3.0, 200});
        QVERIFY(!bar->isVisible() || !bar->text().contains(QLatin1String("The run is now")));
    }

    void aBadFileIsToldAndNothingIsLost()
    {
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        m_window->openReference(kSample);
        QVERIFY(loaded.wait(kPatience));
        QTemporaryDir folder;
        const QString bad = folder.filePath(QStringLiteral("bad.csv"));
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("hello\n");
        file.close();
        auto *bar = m_window->findChild<MessageBar *>();
        drop(*m_window, bad);
        AWAIT(bar->isVisible() && bar->text().contains(QLatin1String("bad.csv")));
        QCOMPARE(m_window->session().result()->comparison.size(), std::size_t(6));
        QTest::mouseClick(bar->findChild<QAbstractButton *>(QStringLiteral("messageDismiss")), Qt::LeftButton);
        QVERIFY(!bar->isVisible());
    }

    /// Nobody writes into the pipe, and nobody waits for that.
    void asksWhatTheColumnsAreWhereNothingTells_data()
    {
        QTest::addColumn<QByteArray>("names");
        QTest::addColumn<bool>("asks");
        QTest::newRow("of two points") << QByteArray("time,J1_x,J2_x\n") << true;
        QTest::newRow("one of them known") << QByteArray("time,R4_x,J2_x\n") << false;
        QTest::newRow("of another kind") << QByteArray("time,temperature,humidity\n") << false;
    }

    void asksWhatTheColumnsAreWhereNothingTells()
    {
        QFETCH(const QByteArray, names);
        QFETCH(const bool, asks);
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("columns.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(names + "0,80,1\n1,70,2\n2,75,1\n");
        file.close();
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        QSignalSpy refused(&m_window->session(), &Session::referenceRefused);
        m_window->openReference(file.fileName());
        AWAIT(loaded.count() + refused.count() == 1);
        auto *dialog = m_window->findChild<QDialog *>(QStringLiteral("columnMapping"));
        QCOMPARE(dialog != nullptr && dialog->isVisible(), asks);
        if (!asks) {
            return;
        }
        auto *second = dialog->findChild<QComboBox *>(QStringLiteral("meaning2"));
        second->setCurrentIndex(second->findData(static_cast<int>(indexOf({R4x, Order::Position}))));
        loaded.clear();
        QTest::mouseClick(dialog->findChild<QAbstractButton *>(QStringLiteral("useButton")), Qt::LeftButton);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(m_window->session().reference()->data.find({R4x, Order::Position})->values.front(), 1.0);
        AWAIT(!m_window->findChild<QDialog *>(QStringLiteral("columnMapping"))); // it asks once
    }

    void aSceneThatIsNoFileIsToldAndNotWaitedFor()
    {
#ifdef Q_OS_UNIX
        QTemporaryDir folder;
        const QString pipe = folder.filePath(QStringLiteral("pipe.json"));
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        drop(*m_window, pipe);
        const auto *bar = m_window->findChild<MessageBar *>();
        AWAIT(bar->isVisible() && bar->text().contains(QLatin1String("pipe.json")));
#endif
    }

    void showsTheImpossibleAndRecovers()
    {
        // Once there and back first: the view may have become a larger one on the way.
        m_window->session().setParameters(withCoupler(4.0));
        m_window->session().setParameters(withCoupler(65.0));
        const QImage possible = pictureOf(*m_window, QStringLiteral("mechanismView"));
        m_window->session().setParameters(withCoupler(4.0)); // under |c| - a = 5
        const QImage impossible = pictureOf(*m_window, QStringLiteral("mechanismView"));
        QVERIFY(impossible != possible);
        m_window->session().setParameters(withCoupler(65.0));
        QCOMPARE(pictureOf(*m_window, QStringLiteral("mechanismView")), possible);
    }

    void makesItsPanelsWhenTheyAreShown()
    {
        QVERIFY(!m_window->findChild<NewtonPanel *>());
        auto *bar = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
        Parameters parameters;
        parameters.b = 70.0;
        m_window->session().setParameters(parameters);
        for (int tab = 0; tab < bar->count(); ++tab) {
            QTest::mouseClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(tab).center());
        }
        QVERIFY(m_window->findChild<StudyPanel *>());
        auto *method = m_window->findChild<QComboBox *>(QStringLiteral("methodBox"));
        QVERIFY(method);
        method->setCurrentIndex(1 - method->currentIndex());
        emit method->activated(method->currentIndex());
        QCOMPARE(m_window->session().solver().method, Method::Newton);
        QVERIFY(m_window->session().result()->trajectory.summary.iterations > 0);
    }

    void theJointOfTheEquationPointedAtLightsUp()
    {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        auto *bar = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
        const QImage before = pictureOf(*m_window, QStringLiteral("mechanismView"));
        QTest::mouseClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(3).center());
        m_window->findChild<QAbstractButton *>(QStringLiteral("segment1"))->click(); // the equations
        auto *table = m_window->findChild<QTableView *>(QStringLiteral("equationTable"));
        QCOMPARE(pictureOf(*m_window, QStringLiteral("mechanismView")), before);
        table->setFocus();
        table->setCurrentIndex(table->model()->index(CrankPinX, 0));
        const QImage lit = pictureOf(*m_window, QStringLiteral("mechanismView"));
        QVERIFY(lit != before);
        table->setCurrentIndex(table->model()->index(SliderPinX, 0));
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) != lit);
        bar->setCurrentIndex(0);
        QCOMPARE(pictureOf(*m_window, QStringLiteral("mechanismView")), before);
    }

    void exportsImagesOfTheRightSize_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QByteArray>("start");
        QTest::newRow("PNG") << QStringLiteral("png") << QByteArray("\x89PNG");
        QTest::newRow("SVG") << QStringLiteral("svg") << QByteArray("<?xml");
        QTest::newRow("PDF") << QStringLiteral("pdf") << QByteArray("%PDF");
    }

    void exportsImagesOfTheRightSize()
    {
        QFETCH(const QString, suffix);
        QFETCH(const QByteArray, start);
        QTemporaryDir folder;
        const QString figure = folder.filePath(QStringLiteral("figure.") + suffix);
        const QString plot = folder.filePath(QStringLiteral("plot.") + suffix);
        const QString mechanism = folder.filePath(QStringLiteral("mechanism.") + suffix);
        m_window->exports().write(m_window->exports().figure(), figure);
        m_window->exports().write(m_window->exports().plot(QStringLiteral("plot_R4_x")), plot);
        m_window->exports().write(m_window->exports().mechanism(), mechanism);
        for (const QString &path : {figure, plot, mechanism}) {
            QFile file(path);
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(path));
            QVERIFY2(file.read(start.size()) == start, qPrintable(path));
            if (suffix == QLatin1String("png")) {
                const QImage image(path);
                QVERIFY2(!isBlank(image), qPrintable(path));
                QVERIFY2(path != plot || image.size() == QSize(1800, 1200), qPrintable(path)); // 900×600, scale 2
            }
        }
    }

    void exportsTheAnimation()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("motion"));
        m_window->exports().writeAnimation(path, m_window->exports().animationOnShow());
        const QStringList frames = QDir(path).entryList(QDir::Files, QDir::Name);
        QCOMPARE(frames.size(), 30);
        const QImage first(QDir(path).filePath(frames.first()));
        QVERIFY(first != QImage(QDir(path).filePath(frames[15])));
        QVERIFY(first != QImage(QDir(path).filePath(frames.last()))); // which is not the first again
        QVERIFY(first.width() > first.height());
        m_window->exports().writeAnimation(path, m_window->exports().animationOnShow());
        const auto *bar = m_window->findChild<MessageBar *>();
        AWAIT2(bar->text().contains(QStringLiteral("cannot be written")), qPrintable(bar->text()));
    }

    void aFailedExportIsTold()
    {
        m_window->exports().write(m_window->exports().figure(), QStringLiteral("/no/such/folder/figure.png"));
        QVERIFY(m_window->findChild<MessageBar *>()->isVisible());
    }

    void foldsThePanelsAwayWhenSmallUntilToldOtherwise()
    {
        auto *tabs = m_window->findChild<FoldingTabs *>();
        QVERIFY(!tabs->isFolded());
        m_window->resize(1024, 700);
        AWAIT(tabs->isFolded());
        const auto *grid = m_window->findChild<PlotGrid *>();
        AWAIT(grid->height() > 550); // the room is the plots' now
        QVERIFY(m_window->width() <= 1024 && m_window->height() <= 700);
        m_window->resize(1400, 900);
        AWAIT(!tabs->isFolded());
        tabs->setFolded(true);
        m_window->resize(1400, 910);
        settle();
        QVERIFY(tabs->isFolded());
    }

    void themesSwitchLive()
    {
        m_window->setTheme(Theme::Light);
        const QImage light = pictureOf(*m_window, QStringLiteral("plot_theta3"));
        m_window->setTheme(Theme::Dark);
        const QImage dark = pictureOf(*m_window, QStringLiteral("plot_theta3"));
        QVERIFY(qGray(light.pixel(2, 2)) > 200);
        QVERIFY(qGray(dark.pixel(2, 2)) < 80);
        m_window->setTheme(Theme::Light);
    }

    void aThemeChosenLiveLooksLikeOneChosenBefore_data()
    {
        QTest::addColumn<Theme>("from");
        QTest::addColumn<Theme>("to");
        QTest::newRow("light to dark") << Theme::Light << Theme::Dark;
        QTest::newRow("dark to light") << Theme::Dark << Theme::Light;
        QTest::newRow("dark to the system's") << Theme::Dark << Theme::System;
    }

    void aThemeChosenLiveLooksLikeOneChosenBefore()
    {
        QFETCH(const Theme, from);
        QFETCH(const Theme, to);
        const auto look = [this](QList<QImage> &pictures, const std::function<void()> &between) {
            m_window->session().setParameters(withCoupler(64.0));
            m_window->openReference(kSample);
            AWAIT(m_window->session().diagnosis());
            auto *bar = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
            for (int tab = 0; tab < bar->count(); ++tab) {
                bar->setCurrentIndex(tab);
                settle();
            }
            const auto segment = [this](int page) {
                m_window->findChild<QAbstractButton *>(QStringLiteral("segment%1").arg(page))->click();
            };
            segment(3);
            between();
            for (int tab = 0; tab < bar->count(); ++tab) {
                bar->setCurrentIndex(tab);
                for (const int page : tab == 2 ? QList<int>{0, 2, 3} : QList<int>{0}) {
                    segment(page);
                    settle(*m_window);                     // the numbers are there
                    m_window->statusBar()->clearMessage(); // it tells a time, which is never the same
                    pictures << m_window->grab().toImage();
                }
            }
        };
        m_window->setTheme(from);
        QList<QImage> live;
        look(live, [&] { m_window->setTheme(to); });
        init();
        m_window->setTheme(to);
        QList<QImage> before;
        look(before, [] {});
        QCOMPARE(live.size(), before.size());
        for (qsizetype i = 0; i < live.size(); ++i) {
            QVERIFY2(live[i] == before[i], qPrintable(QString::number(i)));
        }
        m_window->setTheme(Theme::System);
    }

    void savesASceneAndOpensItAgain()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.slidercrank"));
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        m_window->openReference(kSample);
        QVERIFY(loaded.wait(kPatience));
        m_window->session().setParameters(withCoupler(61.25));
        m_window->session().setTime(0.3);
        auto *grid = m_window->findChild<PlotGrid *>();
        PlotSettings settings;
        settings.error = ErrorMeasure::OfPeak;
        settings.abscissa = Abscissa::CrankAngle;
        PlotZoom zoom;
        zoom.time = Interval{0.25, 0.5};
        zoom.values[4] = Interval{-10.0, 20.0};
        grid->setSettings(settings);
        grid->setZoom(zoom);
        auto *mechanism = m_window->findChild<MechanismView *>();
        const MechanismSettings drawing{true, false, true, false, true, true, true};
        const QRectF part(-15.0, -10.0, 60.0, 40.0); // mm
        mechanism->setSettings(drawing);
        mechanism->setZoom(part);
        QVERIFY(m_window->isWindowModified());
        QVERIFY(m_window->scene().saveTo(path));
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->windowTitle().startsWith(QLatin1String("rig.slidercrank[*]")));
        const Trajectory before = m_window->session().result()->trajectory;
        m_window->findChild<MessageBar *>()->hide(); // it says that the scene is saved
        settle(*m_window);
        const QImage picture = pictureOf(*m_window, QStringLiteral("plot_R4_x_diff"));

        init(); // another window
        QSignalSpy opened(&m_window->session(), &Session::opened);
        drop(*m_window, path);
        QVERIFY(opened.wait(kPatience));
        grid = m_window->findChild<PlotGrid *>();
        QCOMPARE(m_window->session().parameters(), withCoupler(61.25));
        QCOMPARE(m_window->session().time(), 0.3);
        QVERIFY(grid->settings() == settings);
        QVERIFY(grid->zoom() == zoom);
        mechanism = m_window->findChild<MechanismView *>();
        QVERIFY(mechanism->settings() == drawing);
        QVERIFY(mechanism->zoom() == part);
        QCOMPARE(m_window->session().reference()->name, QStringLiteral("inventor_sample.csv"));
        for (const Channel channel : kPlottedChannels) {
            QVERIFY(m_window->session().result()->trajectory[channel] == before[channel]);
        }
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(!m_window->session().undoStack().canUndo());
        QCOMPARE(recentFiles(kRecentScenes), QStringList{path});
        AWAIT_COMPARE(pictureOf(*m_window, QStringLiteral("plot_R4_x_diff")), picture);
    }

    /// "Consider the effect of another coupler length."
    void aKeptMotionStaysUnderWhatFollows()
    {
        auto *grid = m_window->findChild<PlotGrid *>();
        const QImage curves = pictureOf(*m_window, QStringLiteral("plot_R4_x"));
        const QImage linkage = pictureOf(*m_window, QStringLiteral("mechanismView"));
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier);
        QVERIFY(m_window->session().kept() == std::vector<Parameters>{Parameters()});
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) == linkage); // it is this one
        m_window->session().setParameters(withCoupler(80.0));
        const QImage both = pictureOf(*m_window, QStringLiteral("plot_R4_x"));
        const QImage ghost = pictureOf(*m_window, QStringLiteral("mechanismView"));
        m_window->findChild<FoldingTabs *>()->showPage(m_window->findChild<TablePanel *>(QStringLiteral("errorPanel")));
        auto *title = m_window->findChild<QLabel *>(QStringLiteral("errorPanelSentence"));
        AWAIT_COMPARE(title->text(), QStringLiteral("This mechanism − pinned (b = 65 mm)."));
        QVERIFY(!m_window->findChild<QLabel *>(QStringLiteral("no_reference_hint"))->isVisible());
        QVERIFY(!isBlank(pictureOf(*m_window, QStringLiteral("plot_error_velocity"))));
        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(m_window->session().kept().empty());
        QVERIFY(pictureOf(*m_window, QStringLiteral("plot_R4_x")) != both);
        QVERIFY(pictureOf(*m_window, QStringLiteral("mechanismView")) != ghost);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(pictureOf(*m_window, QStringLiteral("plot_R4_x")), both);
        QCOMPARE(pictureOf(*m_window, QStringLiteral("mechanismView")), ghost);

        const QTemporaryDir folder; // as a scene, too
        const QString path = folder.filePath(QStringLiteral("kept.json"));
        QVERIFY(m_window->scene().saveTo(path));
        init();
        grid = m_window->findChild<PlotGrid *>();
        m_window->openFiles({path});
        QVERIFY(m_window->session().kept() == std::vector<Parameters>{Parameters()});
        AWAIT_COMPARE(pictureOf(*m_window, QStringLiteral("plot_R4_x")), both);
        while (m_window->session().undoStack().canUndo()) {
            m_window->session().undoStack().undo();
        }
        emit grid->keepRequested(); // as from its menu
        QCOMPARE(m_window->session().kept().size(), std::size_t(2));
        m_window->session().forgetKept();
        m_window->session().setParameters({});
        AWAIT_COMPARE(pictureOf(*m_window, QStringLiteral("plot_R4_x")), curves); // as if nothing had ever been kept
    }

    void saysWhatIsModified()
    {
        const QTemporaryDir folder;
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->scene().saveTo(folder.filePath(QStringLiteral("rig.json"))));
        m_window->session().setParameters(withCoupler(70.0));
        QVERIFY(m_window->isWindowModified());
        m_window->session().undoStack().undo();
        QVERIFY(!m_window->isWindowModified());
        m_window->session().undoStack().redo();
        QVERIFY(m_window->isWindowModified());
        m_window->session().setTime(0.5); // looking is no edit
        m_window->scene().save();
        QVERIFY(!m_window->isWindowModified());
        m_window->session().undoStack().undo();
        QVERIFY(m_window->isWindowModified());
    }

    void asksBeforeItCloses_data()
    {
        QTest::addColumn<int>("answer");
        QTest::addColumn<bool>("closes");
        QTest::addColumn<double>("saved");
        QTest::newRow("cancel") << int(QMessageBox::Cancel) << false << 65.0;
        QTest::newRow("discard") << int(QMessageBox::Discard) << true << 65.0;
        QTest::newRow("save") << int(QMessageBox::Save) << true << 70.0;
    }

    void asksBeforeItCloses()
    {
        QFETCH(const int, answer);
        QFETCH(const bool, closes);
        QFETCH(const double, saved);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.json"));
        QVERIFY(m_window->scene().saveTo(path));
        m_window->session().setParameters(withCoupler(70.0));
        m_window->close();
        QVERIFY(m_window->isVisible());
        auto *question = m_window->findChild<QMessageBox *>(QStringLiteral("unsavedQuestion"));
        QVERIFY(question && question->isVisible() && question->text().contains(QLatin1String("rig.json")));
        question->button(static_cast<QMessageBox::StandardButton>(answer))->click();
        QCOMPARE(m_window->isVisible(), !closes);
        QCOMPARE(std::get<Scene>(readScene(path)).parameters.b, saved);
    }

    void closesWithoutAWordWhenNothingIsLost()
    {
        m_window->close();
        QVERIFY(!m_window->isVisible());
        QVERIFY(!m_window->findChild<QMessageBox *>());
    }

    void asksBeforeItOpensAnother()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.json"));
        QVERIFY(m_window->scene().saveTo(path));
        m_window->session().setParameters(withCoupler(70.0));
        drop(*m_window, path);
        QCOMPARE(m_window->session().parameters(), withCoupler(70.0));
        auto *question = m_window->findChild<QMessageBox *>(QStringLiteral("unsavedQuestion"));
        QVERIFY(question);
        question->button(QMessageBox::Discard)->click();
        QCOMPARE(m_window->session().parameters(), withCoupler(65.0));
        QVERIFY(!m_window->isWindowModified());
    }

    void severalFilesOfOneMotionAreReadAsOne()
    {
        const QTemporaryDir folder;
        const QStringList plots = plotsOfSample(folder);
        Session &session = m_window->session();
        const auto errors = [&session] {
            std::map<std::size_t, std::pair<std::optional<double>, Verdict>> byChannel;
            for (const ChannelComparison &channel : session.result()->comparison) {
                byChannel[indexOf(channel.channel)] = {channel.maxAbs, channel.verdict};
            }
            return byChannel;
        };
        drop(*m_window, kSample);
        AWAIT(session.diagnosis());
        const auto whole = errors();
        const Parameters found = session.diagnosis()->found.rounded;
        QCOMPARE(whole.size(), std::size_t(6));

        drop(*m_window, {plots[2], plots[0], plots[1]}); // as a person picked them
        AWAIT(session.reference()->paths == plots && session.diagnosis());
        QVERIFY(errors() == whole);
        QCOMPARE(session.diagnosis()->found.rounded, found);
        QCOMPARE(session.reference()->name, QStringLiteral("coupler.csv + 2 more"));
        const auto *tabs = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
        QVERIFY(tabs->tabText(1).contains(QStringLiteral("✗"))); // the title of the errors carries the verdict
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("opening of coupler.csv + 2 more"));
        session.undoStack().undo();
        QCOMPARE(session.reference()->paths, QStringList(kSample));
        session.undoStack().redo();
        QCOMPARE(session.reference()->paths, plots);

        // In a scene, and among the recent files, as one.
        const QString scene = folder.filePath(QStringLiteral("rig.slidercrank"));
        QVERIFY(m_window->scene().saveTo(scene));
        QCOMPARE(recentReferences(), (QList<QStringList>{plots, {kSample}}));
        init();
        m_window->openFiles({scene});
        AWAIT(m_window->session().reference());
        QCOMPARE(m_window->session().reference()->paths, plots);
        QCOMPARE(m_window->session().result()->comparison.size(), std::size_t(6));
        QVERIFY(!m_window->isWindowModified());
        drop(*m_window, plots[1]); // one is one
        AWAIT_COMPARE(m_window->session().reference()->paths, QStringList(plots[1]));
        auto *recent = m_window->findChild<QMenu *>(QStringLiteral("recentMenu"));
        emit recent->aboutToShow();
        const QString entry = QDir::toNativeSeparators(plots[0]) + QStringLiteral(" + 2 more");
        for (QAction *action : recent->actions()) {
            if (action->text() == entry) {
                action->trigger();
                break;
            }
        }
        AWAIT_COMPARE(m_window->session().reference()->paths, plots);
    }

    void whatIsNotOfOneMotionIsToldAndChangesNothing()
    {
        const QTemporaryDir folder;
        const QStringList plots = plotsOfSample(folder);
        const auto *bar = m_window->findChild<MessageBar *>();
        drop(*m_window, plots);
        AWAIT(m_window->session().diagnosis());
        const auto shown = m_window->session().reference();
        const int edits = m_window->session().undoStack().index();
        const auto refused = [&](const QStringList &paths, const QString &sentence) {
            drop(*m_window, paths);
            AWAIT(bar->isVisible() && bar->text().contains(sentence));
            QVERIFY(m_window->session().reference() == shown);
            QCOMPARE(m_window->session().undoStack().index(), edits);
        };
        refused({plots[1], kSample}, QStringLiteral("does, too: leave one of the two out"));
        QVERIFY(
            !bar->findChild<QAbstractButton *>(QStringLiteral("messageRemedy"))->isHidden()); // which of them is what
        refused({plots[1], plots[1]}, QStringLiteral("is named twice"));
        refused({plots[1], folder.filePath(QStringLiteral("gone.csv"))}, QStringLiteral("gone.csv cannot be opened"));
        refused({plots[1], folder.path()}, QStringLiteral("is a folder"));
        refused({plots[1], folder.filePath(QStringLiteral("rig.slidercrank"))},
                QStringLiteral("rig.slidercrank is a scene: open it by itself"));
    }

    void asksForANameTheFirstTime()
    {
        const QTemporaryDir folder;
        m_window->session().setParameters(withCoupler(70.0));
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
        auto *dialog = m_window->findChild<QFileDialog *>();
        QVERIFY(dialog);
        dialog->setDirectory(folder.path());
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("rig"));
        QMetaObject::invokeMethod(dialog, "accept");
        AWAIT_COMPARE(m_window->scene().path(), folder.filePath(QStringLiteral("rig.slidercrank")));
        QVERIFY(!m_window->isWindowModified());
    }

    void aBadSceneIsToldAndChangesNothing()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"version\": 99}");
        file.close();
        m_window->session().setParameters(withCoupler(70.0));
        QSignalSpy results(&m_window->session(), &Session::resultChanged);
        drop(*m_window, path);
        const auto *bar = m_window->findChild<MessageBar *>();
        QVERIFY(bar->isVisible() && bar->text().contains(QLatin1String("rig.json")));
        QVERIFY(!m_window->findChild<QMessageBox *>());
        QCOMPARE(results.count(), 0);
        QVERIFY(m_window->session().undoStack().canUndo());
        QCOMPARE(m_window->scene().path(), QString());
    }

    void aSceneThatCannotBeSavedIsToldAndStaysModified()
    {
        m_window->session().setParameters(withCoupler(70.0));
        QVERIFY(!m_window->scene().saveTo(QStringLiteral("/no/such/folder/rig.json")));
        QVERIFY(m_window->findChild<MessageBar *>()->text().contains(QLatin1String("rig.json")));
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(m_window->scene().path(), QString());
    }

    void opensWithoutAReferenceThatIsGoneAndKeepsItsName()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.json"));
        Scene scene;
        scene.parameters.b = 70.0;
        scene.reference = ReferenceSource{{folder.filePath(QStringLiteral("gone.csv"))}, {}, {}};
        QCOMPARE(writeScene(scene, path), std::nullopt);
        m_window->openFiles({path});
        const auto *bar = m_window->findChild<MessageBar *>();
        AWAIT(bar->isVisible() && bar->text().contains(QLatin1String("gone.csv")));
        QCOMPARE(m_window->session().parameters(), withCoupler(70.0));
        m_window->scene().save();
        const Scene again = std::get<Scene>(readScene(path));
        QVERIFY(again.reference && again.reference->paths == scene.reference->paths);
    }

    void opensASceneWithAnotherReference()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("rig.json"));
        Scene scene;
        scene.reference = ReferenceSource{{folder.filePath(QStringLiteral("gone.csv"))}, {}, {}};
        QCOMPARE(writeScene(scene, path), std::nullopt);
        QSignalSpy loaded(&m_window->session(), &Session::referenceLoaded);
        m_window->scene().open(path, {kSample});
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(m_window->session().reference()->paths, QStringList(kSample));
        QCOMPARE(m_window->scene().path(), path);
    }

    void inFrontOfAClassMechanismAndPlotsFillTheScreen()
    {
        m_window->resize(1250, 850);
        QCoreApplication::processEvents();
        auto *columns = m_window->findChild<QSplitter *>(QStringLiteral("columns"));
        auto *tabs = m_window->findChild<FoldingTabs *>();
        auto *plots = m_window->findChild<PlotGrid *>();
        auto *mechanism = m_window->findChild<MechanismView *>();
        const auto *chosen = m_window->findChild<QComboBox *>(QStringLiteral("parameterBox"));
        const auto *boxA = m_window->findChild<QWidget *>(QStringLiteral("box_a"));
        auto *boxC = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("box_c"));
        const QList<int> sizes = columns->sizes();
        const int letters = QFontInfo(plots->font()).pixelSize();
        QVERIFY(!chosen->isVisible() && !mechanism->settings().angles);

        const auto key = [this](Qt::Key pressed, Qt::KeyboardModifiers modifiers = {}) {
            QTest::keyClick(m_window->focusWidget() ? m_window->focusWidget() : m_window.get(), pressed, modifiers);
            QCoreApplication::processEvents();
        };
        key(Qt::Key_F11);
        QVERIFY(m_window->isFullScreen());
        QVERIFY(plots->isVisible() && mechanism->isVisible() && !tabs->isVisible());
        QVERIFY(mechanism->settings().angles);
        QVERIFY(m_window->menuBar()->height() <= 1 && !m_window->statusBar()->isVisible());
        const int largest = m_window->screen()->size().height() / 45;
        QCOMPARE(QFontInfo(plots->font()).pixelSize(), std::max(letters, largest));
        QCOMPARE(QFontInfo(mechanism->font()).pixelSize(), std::max(letters, largest));
        const auto *message = m_window->findChild<QLabel *>(QStringLiteral("messageText"));
        QCOMPARE(QFontInfo(message->font()).pixelSize(), std::max(letters, largest));
        QVERIFY(chosen->isVisible() && !boxA->isVisible() && !boxC->isVisible()); // one of them at a time
        m_window->findChild<QComboBox *>(QStringLiteral("parameterBox"))->setCurrentIndex(2);
        QVERIFY(boxC->isVisible());
        boxC->setFocus();
        key(Qt::Key_Up);
        QCOMPARE(m_window->session().parameters().c, 26.0);
        key(Qt::Key_Z, Qt::ControlModifier); // the menus' keys are there all the same
        QCOMPARE(m_window->session().parameters().c, 25.0);
        key(Qt::Key_Escape);
        QVERIFY(!m_window->isFullScreen() && !mechanism->settings().angles);
        QVERIFY(tabs->isVisible() && boxA->isVisible() && boxC->isVisible() && !chosen->isVisible());
        QVERIFY(m_window->menuBar()->height() > 1 && m_window->statusBar()->isVisible());
        QCOMPARE(QFontInfo(plots->font()).pixelSize(), letters);
        AWAIT_COMPARE(columns->sizes().first(), sizes.first());

        m_window->setWindowState(Qt::WindowMaximized);
        key(Qt::Key_F11);
        QCOMPARE(m_window->windowState(), Qt::WindowMaximized | Qt::WindowFullScreen);
        key(Qt::Key_F11);
        QCOMPARE(m_window->windowState(), Qt::WindowMaximized);
        QVERIFY(tabs->isVisible());
        m_window->setWindowState(Qt::WindowNoState);
        key(Qt::Key_F11);
        m_window->close(); // nothing of it is remembered
        init();
        QVERIFY(m_window->findChild<FoldingTabs *>()->isVisible() && !m_window->isFullScreen());
    }

    void theMechanismFillsTheWindowByADoubleClick()
    {
        auto *mechanism = m_window->findChild<MechanismView *>();
        auto *plots = m_window->findChild<PlotGrid *>();
        const int width = mechanism->width();
        QVERIFY(plots->isVisible());
        emit mechanism->enlarged();
        QVERIFY(!plots->isVisible());
        AWAIT(mechanism->width() > width + 100);
        mechanism->setFocus();
        QTest::keyClick(mechanism, Qt::Key_Escape);
        QVERIFY(plots->isVisible());
        QTest::keyClick(mechanism, Qt::Key_Return);
        QVERIFY(!plots->isVisible());
        QTest::keyClick(mechanism, Qt::Key_Return);
        QVERIFY(plots->isVisible());
    }

    void remembersWhatIsDrawnTheUnitsTheTabAndTheSpeed()
    {
        const auto box = [this](const char *name) { return m_window->findChild<QComboBox *>(QLatin1String(name)); };
        QCOMPARE(m_window->findChild<FoldingTabs *>()->current(), 0);
        const MechanismSettings drawing{true, false, false, true};
        m_window->findChild<MechanismView *>()->setSettings(drawing);
        box("unit_theta20")->setCurrentIndex(1);
        box("unit_omega2")->setCurrentIndex(2);
        m_window->findChild<FoldingTabs *>()->setCurrent(4);
        m_window->findChild<Timeline *>()->setSpeed(0.005);
        m_window->close();
        m_window = std::make_unique<MainWindow>();
        QVERIFY(m_window->findChild<MechanismView *>()->settings() == drawing);
        QCOMPARE(box("unit_theta20")->currentIndex(), 1);
        QCOMPARE(box("unit_omega2")->currentIndex(), 2);
        QCOMPARE(m_window->findChild<FoldingTabs *>()->current(), 4);
        QCOMPARE(m_window->findChild<Timeline *>()->speed(), 0.005);
        QVERIFY(!m_window->isWindowModified());
        m_window->close();
        QSettings().setValue(QStringLiteral("view/speed"), QStringLiteral("fast")); // somebody's hand
        QSettings().setValue(QStringLiteral("view/tab"), 99);
        QSettings().setValue(QStringLiteral("view/unit_theta20"), -7);
        m_window = std::make_unique<MainWindow>();
        QVERIFY(m_window->findChild<Timeline *>()->speed() > 0.0);
        QVERIFY(box("unit_theta20")->currentIndex() >= 0);
    }

    void remembersItsLayout()
    {
        const QSize size(780, 740); // on the screen: what is remembered of another is made to fit
        m_window->resize(size);
        auto *columns = m_window->findChild<QSplitter *>(QStringLiteral("columns"));
        columns->setSizes({360, 420});
        m_window->findChild<FoldingTabs *>()->setFolded(true);
        QCoreApplication::processEvents();
        const QList<int> sizes = columns->sizes();
        m_window->close();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QCOMPARE(m_window->size(), size);
        QCOMPARE(m_window->findChild<QSplitter *>(QStringLiteral("columns"))->sizes(), sizes);
        QVERIFY(m_window->findChild<FoldingTabs *>()->isFolded());
        m_window->findChild<FoldingTabs *>()->setFolded(false);
        AWAIT(m_window->findChild<FoldingTabs *>()->height() > 150);
    }

private:
    const QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"
