// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/document/with.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/column_mapping.h"
#include "ui/panels/error_page.h"
#include "ui/panels/limits_page.h"
#include "ui/panels/limits_panel.h"
#include "ui/panels/newton_panel.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/reference_page.h"
#include "ui/panels/run_form.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/table_panel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/application.h"
#include "ui/window/exports.h"
#include "ui/window/ghost.h"
#include "ui/window/key_owner.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/presentation.h"
#include "ui/window/recovery.h"
#include "ui/window/remembered.h"
#include "ui/window/scene_file.h"
#include "ui/window/status_bar.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontMetrics>
#include <QLocale>
#include <QMimeData>
#include <QScreen>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr int kFoldBelowHeight = 800; // px: under this the nine plots need all the room there is

/// The table of six channels with its sentence, and with large letters as many lines.
int panelHeight()
{
    constexpr int kUsual = 230; // px
    constexpr int kLines = 15;
    return std::max(kUsual, kLines * QFontMetrics(QApplication::font()).height());
}

const QString kSamplePath = QStringLiteral(":/data/inventor_sample.csv");

QStringList droppedFiles(const QDropEvent &event)
{
    QStringList paths;
    for (const QUrl &url : event.mimeData()->urls()) {
        paths += url.toLocalFile();
    }
    paths.removeAll(QString()); // what is not on this machine
    return paths;
}

/// To the left the mechanism and the hands on it, to the right the plots above the tabs.
QSplitter *columnsOf(const Rooms &rooms)
{
    auto *left = new QWidget;
    auto *leftColumn = new QVBoxLayout(left);
    leftColumn->setContentsMargins(6, 6, 3, 6);
    leftColumn->addWidget(rooms.mechanism, 1);
    leftColumn->addWidget(rooms.timeline);
    leftColumn->addWidget(rooms.parameters);
    left->setMinimumWidth(340);

    auto *right = new QSplitter(Qt::Vertical);
    right->setObjectName(QStringLiteral("plotsAndTabs"));
    right->addWidget(rooms.plots);
    right->addWidget(rooms.tabs);
    right->setStretchFactor(0, 1);
    right->setStretchFactor(1, 0);
    right->setChildrenCollapsible(false);
    right->setSizes({600, panelHeight()});
    QObject::connect(rooms.tabs, &FoldingTabs::foldedChanged, right, [right](bool folded) {
        const int all = right->sizes().value(0) + right->sizes().value(1);
        right->setSizes(folded ? QList<int>{all, 0} : QList<int>{all - panelHeight(), panelHeight()});
    });

    auto *columns = new QSplitter(Qt::Horizontal);
    columns->setObjectName(QStringLiteral("columns"));
    columns->addWidget(left);
    columns->addWidget(right);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setChildrenCollapsible(false);
    columns->setSizes({430, 970});
    return columns;
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_session(new Session(this))
    , m_scene(new SceneFile(m_session, m_rooms, this))
    , m_exports(new Exports(m_session, m_rooms, this))
    , m_presentation(new Presentation(m_rooms, this))
    , m_status(new StatusBar(this))
{
    setWindowIcon(QIcon(QStringLiteral(":/slidercrank.svg")));
    setAcceptDrops(true);
    resize(1400, 900);
    if (chosenTheme() != Theme::System) {
        QApplication::setPalette(paletteFor(chosenTheme()));
    }
    m_rooms.messageBar = new MessageBar(this);
    m_messages = new Messages(m_session, m_scene, m_rooms.messageBar);
    auto *page = new QWidget(this);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_rooms.messageBar);
    setCentralWidget(page);
    setStatusBar(m_status);
    connectDocument();
    makeRooms(true);
    arrange(*this, rememberedLayout());
    new KeyOwner(this);
    m_session->setTime(m_session->sampling().start);
    m_messages->greetOnce();
    m_recovery = new Recovery(m_session, m_scene, column, this);
    if (auto *play = m_rooms.timeline->findChild<QAbstractButton *>(QStringLiteral("playButton"))) {
        play->setFocus();
    }
}

/// A number box that still has the focus passes on what was typed while everything that follows it exists.
MainWindow::~MainWindow()
{
    if (QWidget *widget = focusWidget()) {
        widget->clearFocus();
    }
}

/// What does not change with the language.
void MainWindow::connectDocument()
{
    connect(m_session, &Session::resultChanged, this, &MainWindow::showResult);
    connect(m_session, &Session::referenceLoaded, this, [this](const std::shared_ptr<const Reference> &reference) {
        showTitle();
        if (reference && reference->paths != QStringList(kSamplePath)) {
            rememberReference(sourceOf(*reference).paths);
        }
        if (reference) {
            if (reference->paths == m_asked) {
                m_rooms.tabs->setCurrentWidget(m_rooms.errors);
            }
            askWhereNothingTells(reference->paths, reference->data.layout);
        }
    });
    connect(m_session, &Session::referenceRefused, this,
            [this](const QStringList &paths) { askWhereNothingTells(paths, layoutOf(paths)); });
    connect(m_scene, &SceneFile::changed, this, &MainWindow::showTitle);

    connect(m_session, &Session::busyChanged, m_status, &StatusBar::setBusy);
    connect(m_session, &Session::readingProgressed, m_status, &StatusBar::setProgress);
    connect(m_session, &Session::referenceLoaded, m_status, &StatusBar::setProgressUnknown); // now it is compared
    connect(m_exports, &Exports::busyChanged, m_status, &StatusBar::setBusy);
    connect(m_exports, &Exports::progressed, m_status, &StatusBar::setProgress);
    connect(m_status, &StatusBar::cancelled, this, [this] {
        const bool isFromBefore = m_session->cancel();
        if (m_exports->cancel()) {
            m_messages->tell(tr("Cancelled: nothing was written."));
        } else if (isFromBefore) {
            m_messages->tellForNow(tr("Cancelled: what is on show is from before."));
        }
    });

    if (auto *application = qobject_cast<Application *>(qApp)) { // in most tests it is another
        connect(application, &Application::memoryEnded, m_messages, [this] {
            m_messages->tellProblem(tr("There is not enough memory for that: try fewer steps, or a smaller file."));
        });
    }
    connect(m_exports, &Exports::done, m_messages, &Messages::tell);
    connect(m_exports, &Exports::problemFound, m_messages, &Messages::tellProblem);
    connect(m_messages, &Messages::openReferenceRequested, this, &MainWindow::chooseReference);
    connect(m_messages, &Messages::openSampleRequested, this, &MainWindow::openSample);
    connect(m_messages, &Messages::columnsRequested, this, &MainWindow::chooseColumns);
}

/// All that speaks, but for what says it anew by itself.
void MainWindow::makeRooms(bool withGhost)
{
    m_rooms.mechanism = new MechanismView(this);
    m_rooms.timeline = new Timeline(this);
    m_rooms.parameters = new ParameterPanel(this);
    m_rooms.plots = new PlotGrid(this);
    m_rooms.tabs = new FoldingTabs(this);
    m_rooms.tabs->addPage(makeLimitsPanel(), tr("Motion limits"));
    m_rooms.errors = makePanel(QStringLiteral("errorPanel"), tr("Errors against the reference"),
                               [this] { return errorPage(*m_session->result(), m_session->diagnosis().get()); });
    m_rooms.tabs->addPage(m_rooms.errors, errorTitle(*m_session->result()));
    m_rooms.tabs->addPage(
        makePanel(QStringLiteral("referencePanel"), tr("Reference: what was read, and how"),
                  [this] { return referencePage(*m_session->result(), m_session->diagnosis().get()); }),
        tr("Reference"));
    m_rooms.tabs->addPage([this] { return makeNewtonPanel(); }, tr("Newton-Raphson"));
    m_rooms.tabs->addPage([this] { return makeStudyPanel(); }, tr("Speed and accuracy"));
    m_rooms.columns = columnsOf(m_rooms);
    static_cast<QVBoxLayout *>(centralWidget()->layout())->addWidget(m_rooms.columns, 1);
    connectRooms();
    m_rooms.ghost = new Ghost(m_session, m_rooms.mechanism, withGhost); // behind a mechanism that is up to date
    setMenuBar(new Menus(*this, m_rooms));
    m_rooms.timeline->findChild<RunForm *>()->addActions(menuBar()->findChildren<QAction *>()); // for their keys
    m_status->retranslate();
    showTitle();
    showResult(m_session->result());
}

/// In the language now in use: of the same session, and arranged as they were.
void MainWindow::remakeRooms()
{
    m_presentation->setOn(false);
    WindowLayout layout = windowLayoutOf(*this, m_foldedByHand);
    layout.window.clear(); // it stays where it is
    const PlotSettings plots = m_rooms.plots->settings();
    const PlotZoom zoom = m_rooms.plots->zoom();
    const QString maximized = m_rooms.plots->maximized();
    const auto measured = m_rooms.plots->measured();
    const MechanismSettings drawing = m_rooms.mechanism->settings();
    const MechanismFrame frame = m_rooms.mechanism->frame();
    const bool hasGhost = m_rooms.ghost->isWanted();
    const bool isPlaying = m_rooms.timeline->isPlaying();
    auto *study = m_rooms.tabs->findChild<StudyPanel *>(); // made anew only where it has been opened
    const int studyTab = m_rooms.tabs->indexOf(study);
    if (study) {
        study->hide();
        study->setParent(this);
    }

    setUpdatesEnabled(false); // nobody sees the window without them
    delete m_rooms.columns;
    delete menuBar();
    setLocale(QLocale());
    m_session->endDrag(); // what was held is gone
    m_session->retranslateEdits();
    makeRooms(hasGhost);

    m_rooms.plots->setSettings(plots);
    m_rooms.plots->setZoom(zoom);
    m_rooms.plots->maximize(maximized);
    m_rooms.plots->setMeasured(measured);
    m_rooms.mechanism->setSettings(drawing);
    m_rooms.mechanism->setFrame(frame);
    if (study) {
        m_rooms.tabs->setCurrent(studyTab);
        m_rooms.tabs->findChild<StudyPanel *>()->takeOver(*study);
        delete study;
    }
    arrange(*this, layout);
    foldWhereLow();
    m_session->setTime(m_session->time());
    if (isPlaying) {
        m_rooms.timeline->play();
    }
    m_messages->sayAgain();
    m_recovery->sayAgain();
    setUpdatesEnabled(true);
}

template <typename Changed, typename Room, typename Slot, typename... Now>
void MainWindow::follow(Changed changed, Room *room, Slot slot, const Now &...now)
{
    (room->*slot)(now...);
    connect(m_session, changed, room, slot);
}

/// With the session, of which they show what there is.
void MainWindow::connectRooms()
{
    follow(&Session::parametersChanged, m_rooms.parameters, &ParameterPanel::setParameters, m_session->parameters());
    connect(m_rooms.parameters, &ParameterPanel::edited, m_session, &Session::setParameters);
    connect(m_rooms.parameters, &ParameterPanel::dragBegan, m_session, &Session::beginDrag);
    connect(m_rooms.parameters, &ParameterPanel::dragEnded, m_session, &Session::endDrag);

    follow(&Session::parametersChanged, m_rooms.timeline, &Timeline::setParameters, m_session->parameters());
    follow(&Session::settingsChanged, m_rooms.timeline, &Timeline::setSampling, m_session->sampling());
    connect(m_session, &Session::timeChanged, m_rooms.timeline, &Timeline::setPose);
    connect(m_rooms.timeline, &Timeline::timeRequested, m_session, &Session::setTime);
    connect(m_rooms.timeline, &Timeline::samplingEdited, m_session, &Session::setSampling);

    follow(&Session::resultChanged, m_rooms.mechanism, &MechanismView::setResult, m_session->result());
    connect(m_session, &Session::timeChanged, m_rooms.mechanism, &MechanismView::setPose);
    connect(m_rooms.mechanism, &MechanismView::timeRequested, m_session, &Session::setTime);
    connect(m_rooms.mechanism, &MechanismView::lengthRequested, m_session, &Session::setParameter);
    connect(m_rooms.mechanism, &MechanismView::branchRequested, m_session, [this](Branch branch) {
        m_session->setParameters(with(m_session->parameters(), &Parameters::branch, branch));
    });
    connect(m_rooms.mechanism, &MechanismView::dragBegan, m_session, &Session::beginDrag);
    connect(m_rooms.mechanism, &MechanismView::dragEnded, m_session, &Session::endDrag);
    connect(m_rooms.mechanism, &MechanismView::enlarged, m_presentation,
            [this] { m_presentation->setAlone(m_rooms.plots->isVisible()); });

    follow(&Session::resultChanged, m_rooms.plots, &PlotGrid::setResult, m_session->result());
    connect(m_session, &Session::timeChanged, m_rooms.plots, &PlotGrid::setPose);
    connect(m_rooms.plots, &PlotGrid::timeRequested, m_session, &Session::setTime);
    connect(m_rooms.plots, &PlotGrid::keepRequested, m_session, &Session::keep);
    connect(m_rooms.plots, &PlotGrid::openReferenceRequested, this, &MainWindow::chooseReference);
    connect(m_rooms.plots, &PlotGrid::exportPlotRequested, m_exports,
            [this](const QString &name) { m_exports->choose(m_exports->plot(name)); });
    connect(m_rooms.plots, &PlotGrid::copyPlotRequested, m_exports,
            [this](const QString &name) { m_exports->copy(m_exports->plot(name)); });

    connect(m_rooms.tabs, &FoldingTabs::foldedChanged, this, [this] { m_foldedByHand = true; });
}

/// A panel whose page follows the session.
TablePanel *MainWindow::makePanel(const QString &name, const QString &title, const std::function<Page()> &makePage)
{
    auto *panel = new TablePanel(name, title, makePage, this);
    connect(m_session, &Session::resultChanged, panel, &TablePanel::refresh);
    connect(m_session, &Session::diagnosisChanged, panel, &TablePanel::refresh);
    connect(panel, &TablePanel::timeRequested, m_session, &Session::setTime);
    connect(panel, &TablePanel::timeRequested, m_rooms.plots, &PlotGrid::showTime);
    connect(panel, &TablePanel::rowsCopied, m_messages, &Messages::tellRowsCopied);
    connect(panel, &TablePanel::remedyRequested, m_messages, &Messages::remedy);
    connect(panel, &TablePanel::problemFound, m_messages, &Messages::tellProblem);
    return panel;
}

QWidget *MainWindow::makeLimitsPanel()
{
    auto *panel = new LimitsPanel(makePanel(QStringLiteral("limitsPanel"), tr("Motion limits"),
                                            [this] { return limitsPage(*m_session->result()); }));
    follow(&Session::resultChanged, panel, &LimitsPanel::setResult, m_session->result());
    connect(panel, &LimitsPanel::edited, m_session, &Session::setParameters);
    connect(panel, &LimitsPanel::parameterRequested, m_session, &Session::setParameter);
    connect(panel, &LimitsPanel::dragBegan, m_session, &Session::beginDrag);
    connect(panel, &LimitsPanel::dragEnded, m_session, &Session::endDrag);
    connect(panel, &LimitsPanel::responseShown, m_rooms.tabs, [this, panel] { m_rooms.tabs->showPage(panel); });
    connect(panel, &LimitsPanel::copied, m_messages, &Messages::tell);
    connect(panel, &LimitsPanel::problemFound, m_messages, &Messages::tellProblem);
    connect(m_rooms.parameters, &ParameterPanel::responseRequested, panel, &LimitsPanel::showResponse);
    return panel;
}

QWidget *MainWindow::makeNewtonPanel()
{
    auto *panel = new NewtonPanel(this);
    connect(panel, &NewtonPanel::edited, m_session, &Session::setSolver);
    panel->setSolver(m_session->solver());
    connect(m_session, &Session::settingsChanged, panel,
            [panel](const Sampling &, const SolverSettings &solver) { panel->setSolver(solver); });
    follow(&Session::resultChanged, panel, &NewtonPanel::setResult, m_session->result());
    follow(&Session::timeChanged, panel, &NewtonPanel::setPose, m_session->pose());

    connect(panel, &NewtonPanel::rowsCopied, m_messages, &Messages::tellRowsCopied);
    connect(panel, &NewtonPanel::problemFound, m_messages, &Messages::tellProblem);
    connect(panel, &NewtonPanel::partHovered, m_rooms.mechanism, &MechanismView::highlight);
    return panel;
}

QWidget *MainWindow::makeStudyPanel()
{
    auto *panel = new StudyPanel(this);
    follow(&Session::parametersChanged, panel, &StudyPanel::setParameters, m_session->parameters());
    connect(panel, &StudyPanel::problemFound, m_messages, &Messages::tellProblem);
    connect(panel, &StudyPanel::rowsCopied, m_messages, &Messages::tellRowsCopied);
    return panel;
}

void MainWindow::showWithinScreen()
{
    constexpr QSize kFrame(20, 60); // px, at most; how large it is is known only when it is there
    const QSize room = screen()->availableSize() - kFrame;
    if (!isMaximized() && size().boundedTo(room) != size()) {
        resize(size().boundedTo(room)); // not every screen has a window manager that maximizes
        setWindowState(Qt::WindowMaximized);
    }
    show();
}

void MainWindow::openFiles(const QStringList &paths)
{
    const auto scene = std::ranges::find_if(paths, isNamedAsScene);
    if (scene == paths.end()) {
        openReference(paths);
    } else if (paths.size() == 1) {
        m_scene->open(*scene);
    } else {
        m_messages->tellProblem(tr("%1 is a scene: open it by itself, and files of one motion together.")
                                    .arg(QFileInfo(*scene).fileName()));
    }
}

void MainWindow::openReference(const QStringList &paths)
{
    m_asked = paths;
    m_asked.sort(); // in whatever order they were picked
    m_session->loadReference(m_asked);
}

void MainWindow::openReference(const QString &path)
{
    openReference(QStringList(path));
}

/// Names that differ only in what they belong to: the person who opened the file knows.
void MainWindow::askWhereNothingTells(const QStringList &paths, const FileLayout &layout)
{
    const bool isAsked = paths == m_asked && layout.isOpen();
    m_asked.clear();
    if (isAsked) {
        chooseColumns(paths);
    }
}

void MainWindow::openSample()
{
    openReference(kSamplePath);
}

void MainWindow::chooseReference()
{
    const QList<QStringList> recent = recentReferences();
    const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.first().first()).absolutePath();
    const QStringList paths = QFileDialog::getOpenFileNames(
        this, tr("Open reference: one file, or the plots of one motion together"), folder,
        tr("Simulation results (*.csv *.txt *.tsv *.tab *.dat *.dta *.mot);;All files (*)"));
    if (!paths.isEmpty()) {
        openReference(paths);
    }
}

void MainWindow::chooseColumns(const QStringList &paths)
{
    if (auto *open = findChild<ColumnMapping *>()) {
        open->close();
    }
    auto *dialog = new ColumnMapping(paths, beginningsOf(paths), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ColumnMapping::chosen, m_session, &Session::readColumnsAnew);
    dialog->show();
}

void MainWindow::showTitle()
{
    const std::shared_ptr<const Reference> &reference = m_session->reference();
    QString document = QFileInfo(m_scene->path()).fileName();
    if (document.isEmpty() && reference) {
        document = reference->name;
    }
    setWindowTitle(document.isEmpty() ? tr("Slider-crank[*]") : tr("%1[*] – Slider-crank").arg(document));
    setWindowModified(m_scene->isModified());
}

void MainWindow::showResult(const std::shared_ptr<const Result> &result)
{
    m_rooms.tabs->setTitle(m_rooms.errors, errorTitle(*result));
    m_status->showRun(*result);
}

void MainWindow::setTheme(Theme theme)
{
    QApplication::setPalette(paletteFor(theme));
    rememberTheme(theme);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    m_scene->takeWhatIsTyped();
    if (!m_isLeaving && (m_scene->isModified() || m_exports->isWriting())) {
        event->ignore();
        m_scene->askThen([this] {
            m_exports->finishThen([this] {
                m_isLeaving = true;
                close();
                m_isLeaving = false;
            });
        });
        return;
    }
    m_presentation->setOn(false);
    rememberLayout(windowLayoutOf(*this, m_foldedByHand));
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!droppedFiles(*event).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent *event)
{
    if (const QStringList paths = droppedFiles(*event); !paths.isEmpty()) {
        event->acceptProposedAction();
        openFiles(paths);
    }
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    foldWhereLow();
}

void MainWindow::foldWhereLow()
{
    if (!m_foldedByHand && !m_presentation->isOn()) {
        m_rooms.tabs->setFolded(height() < kFoldBelowHeight);
        m_foldedByHand = false;
    }
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange) {
        remakeRooms();
    }
    QMainWindow::changeEvent(event);
}

/// The status line is the session's; menus do not clear it.
bool MainWindow::event(QEvent *event)
{
    return event->type() == QEvent::StatusTip || QMainWindow::event(event);
}

} // namespace slidercrank
