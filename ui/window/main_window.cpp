// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/controls/folding_tabs.h"
#include "ui/controls/message_bar.h"
#include "ui/export/animation_export.h"
#include "ui/export/motion_csv.h"
#include "ui/export/report_pages.h"
#include "ui/limits/limits_panel.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/mechanism/part_highlight.h"
#include "ui/newton/newton_panel.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/reference/column_mapping.h"
#include "ui/reference/error_panel.h"
#include "ui/reference/reference_panel.h"
#include "ui/study/study_panel.h"
#include "ui/window/control_states.h"
#include "ui/window/help_page.h"
#include "ui/window/scene_file.h"
#include "ui/words/axis_scale.h"
#include "ui/words/language.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QProgressBar>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr int kRecentFiles = 8;
constexpr int kFoldBelowHeight = 800; // px: under this the nine plots need all the room there is
constexpr int kPanelHeight = 230;     // px: the table of six channels with its sentence
constexpr int kBusyShownAfter = 250;  // ms: what is done sooner is not worth a flicker

constexpr double kExportScale = 2.0; // of what is on screen, for documents
constexpr QSize kPlotSize(900, 600);

const QString kSamplePath = QStringLiteral(":/data/inventor_sample.csv");

QStringList recentFiles()
{
    return QSettings().value(QStringLiteral("recentReferences")).toStringList();
}

QString mobilityText(const MotionLimits &limits)
{
    switch (limits.mobility) {
    case Mobility::FullTurn: return MainWindow::tr("crank turns round");
    case Mobility::Rocker: return MainWindow::tr("crank rocks");
    case Mobility::Locked: return MainWindow::tr("locked in one pose");
    case Mobility::Impossible: return MainWindow::tr("cannot be assembled");
    }
    return {};
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_session(new Session(this))
{
    setWindowIcon(QIcon(QStringLiteral(":/slidercrank.svg")));
    setAcceptDrops(true);
    resize(1400, 900);
    m_foundation = children();
    makeRooms();
    restoreLayout();
    qApp->installEventFilter(this);
    m_session->setTime(m_session->sampling().start);
    greetOnce();
    if (QAbstractButton *play = m_timeline->findChild<QAbstractButton *>(QStringLiteral("playButton"))) {
        play->setFocus();
    }
}

MainWindow::~MainWindow() = default;

/// Everything but the session, whose state it shows, and the scene.
void MainWindow::makeRooms()
{
    m_messageBar = new MessageBar(this);
    m_mechanismView = new MechanismView(this);
    m_timeline = new Timeline(this);
    m_parameterPanel = new ParameterPanel(this);
    m_plotGrid = new PlotGrid(this);
    if (m_scene) {
        m_scene->setViews(m_plotGrid, m_mechanismView);
    } else {
        m_scene = new SceneFile(m_session, m_plotGrid, m_mechanismView, this);
    }
    m_tabs = new FoldingTabs(this);
    m_errorPanel = new ErrorPanel(this);
    m_progress = new QProgressBar(this);
    m_cancelButton = new QToolButton(this);
    m_busyTimer = new QTimer(this);
    buildLayout();
    buildMenus();
    buildStatusBar();
    connectRooms();
    showTitle();

    m_parameterPanel->setParameters(m_session->parameters());
    m_timeline->setParameters(m_session->parameters());
    m_timeline->setSampling(m_session->sampling());
    const std::shared_ptr<const Result> &result = m_session->result();
    m_mechanismView->setResult(result);
    m_plotGrid->setResult(result);
    m_errorPanel->setResult(result);
    m_errorPanel->setDiagnosis(m_session->diagnosis());
    m_closeReferenceAction->setEnabled(m_session->reference() != nullptr);
    m_ghostAction->setEnabled(m_session->reference() != nullptr);
    findGhost();
    showAgreement(result);
    showStatus(result);
}

/// In the language now in use; what a person made of the old rooms is made of the new ones.
void MainWindow::remakeRooms()
{
    const ControlStates states = controlStatesOf(*this);
    const PlotSettings plots = m_plotGrid->settings();
    const PlotZoom zoom = m_plotGrid->zoom();
    const QString maximized = m_plotGrid->maximized();
    const MechanismView::Look drawing = m_mechanismView->look();
    const auto measured = m_plotGrid->measured();
    const bool isPlaying = m_timeline->isPlaying();
    const bool isFolded = m_tabs->isFolded();
    const bool wasFoldedByHand = m_foldedByHand;
    const bool hasMessage = m_messageBar->isVisibleTo(this);
    const bool greets = hasMessage && m_messageBar->text() == m_greeting;
    const int tab = m_tabs->current();
    auto *study = findChild<StudyPanel *>(); // made anew only where it has been opened
    const int studyTab = study ? m_tabs->indexOf(study) : tab;
    if (study) {
        study->hide();
        study->setParent(this);
    }

    m_session->disconnect(this);
    m_session->undoStack().disconnect(this);
    m_scene->disconnect(this);
    QList<QPointer<QObject>> rooms; // one may be gone with another
    for (QObject *child : children()) {
        const auto *widget = qobject_cast<QWidget *>(child);
        const bool isDialog = widget && widget->isWindow(); // stays open as it is
        const bool isWork = child == m_scene || child == m_animation || child == m_export || child == study;
        if (!m_foundation.contains(child) && !isWork && !isDialog) {
            rooms += child;
        }
    }
    setUpdatesEnabled(false); // nobody sees the window without them
    for (const QPointer<QObject> &room : rooms) {
        delete room.data();
    }
    setLocale(QLocale());
    m_session->endDrag(); // what was held is gone
    m_session->retranslateEdits();
    makeRooms();

    m_plotGrid->setSettings(plots);
    m_plotGrid->setZoom(zoom);
    m_plotGrid->maximize(maximized);
    m_mechanismView->setLook(drawing);
    m_plotGrid->setMeasured(measured);
    if (study) {
        m_tabs->setCurrent(studyTab);
        m_tabs->findChild<StudyPanel *>()->takeOver(*study);
        delete study;
    }
    m_tabs->setCurrent(tab);
    m_tabs->setFolded(isFolded);
    m_foldedByHand = wasFoldedByHand;
    setControlStates(*this, states);
    if (m_busy > 0) {
        m_busyTimer->start();
    }
    m_session->setTime(m_session->time());
    if (isPlaying) {
        m_timeline->play();
    }
    m_announceReference = hasMessage; // said again
    announce(m_session->diagnosis());
    if (greets) {
        greet();
    }
    setUpdatesEnabled(true);
}

void MainWindow::buildLayout()
{
    auto *left = new QWidget(this);
    auto *leftColumn = new QVBoxLayout(left);
    leftColumn->setContentsMargins(6, 6, 3, 6);
    leftColumn->addWidget(m_mechanismView, 1);
    leftColumn->addWidget(m_timeline);
    leftColumn->addWidget(m_parameterPanel);
    left->setMinimumWidth(340);

    m_tabs->addPage(m_errorPanel, tr("Errors"));
    m_tabs->addPage([this] { return makeReferencePanel(); }, tr("Reference"));
    m_tabs->addPage([this] { return makeNewtonPanel(); }, tr("Newton-Raphson"));
    m_tabs->addPage([this] { return makeStudyPanel(); }, tr("Speed and accuracy"));
    m_tabs->addPage([this] { return makeLimitsPanel(); }, tr("Motion limits"));

    auto *right = new QSplitter(Qt::Vertical, this);
    right->setObjectName(QStringLiteral("plotsAndTabs"));
    right->addWidget(m_plotGrid);
    right->addWidget(m_tabs);
    right->setStretchFactor(0, 1);
    right->setStretchFactor(1, 0);
    right->setChildrenCollapsible(false);
    right->setSizes({600, kPanelHeight});
    connect(m_tabs, &FoldingTabs::foldedChanged, right, [right](bool folded) {
        const int all = right->sizes().value(0) + right->sizes().value(1);
        right->setSizes(folded ? QList<int>{all, 0} : QList<int>{all - kPanelHeight, kPanelHeight});
    });

    auto *columns = new QSplitter(Qt::Horizontal, this);
    columns->setObjectName(QStringLiteral("columns"));
    columns->addWidget(left);
    columns->addWidget(right);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setChildrenCollapsible(false);
    columns->setSizes({430, 970});

    auto *page = new QWidget(this);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_messageBar);
    column->addWidget(columns, 1);
    setCentralWidget(page);
}

void MainWindow::buildMenus()
{
    QMenu *file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("&Open reference…"), QKeySequence::Open, this, &MainWindow::chooseReference);
    file->addAction(tr("Open sc&ene…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), m_scene,
                    &SceneFile::chooseAndOpen);
    m_recentMenu = file->addMenu(tr("Open &recent"));
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    file->addAction(tr("Open the samp&le"), this, &MainWindow::openSample);
    m_closeReferenceAction = file->addAction(tr("&Close reference"), QKeySequence::Close, this,
                                             [this] { m_session->setReference(nullptr); });
    m_closeReferenceAction->setEnabled(false);
    file->addSeparator();
    file->addAction(tr("&Save scene"), QKeySequence::Save, m_scene, [this] { m_scene->save(); });
    file->addAction(tr("Save scene &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), m_scene,
                    [this] { m_scene->saveAs(); });
    file->addSeparator();
    QMenu *exporting = file->addMenu(tr("E&xport"));
    exporting->addAction(tr("&Figure…"), QKeySequence(Qt::CTRL | Qt::Key_E), this,
                         [this] { exportFigureTo(chooseExportFile(QStringLiteral("figure.png"))); });
    QMenu *exportPlot = exporting->addMenu(tr("&Plot"));
    exporting->addAction(tr("&Mechanism…"), this,
                         [this] { exportMechanismTo(chooseExportFile(QStringLiteral("mechanism.png"))); });
    exporting->addAction(tr("&Data…"), this, &MainWindow::chooseData);
    exporting->addAction(tr("&Report…"), this, &MainWindow::chooseReport);
    exporting->addAction(tr("&Animation…"), this, &MainWindow::chooseAnimation);
    file->addSeparator();
    file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);

    QMenu *edit = menuBar()->addMenu(tr("&Edit"));
    QAction *undo = m_session->undoStack().createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    undo->setIconText(tr("&Undo").remove(u'&')); // its text says what as well
    edit->addAction(undo);
    QAction *redo = m_session->undoStack().createRedoAction(this, tr("&Redo"));
    redo->setIconText(tr("&Redo").remove(u'&'));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addAction(redo);
    edit->addSeparator();
    edit->addAction(tr("&Copy figure"), QKeySequence::Copy, this, &MainWindow::copyFigure);
    QMenu *copyPlotMenu = edit->addMenu(tr("Copy &plot"));
    for (const QString &name : m_plotGrid->plotNames()) {
        const QWidget *plot = m_plotGrid->findChild<QWidget *>(name);
        const QString title = plot ? plot->accessibleName() : name;
        exportPlot->addAction(title, this,
                              [this, name] { exportPlotTo(name, chooseExportFile(name + QStringLiteral(".png"))); });
        copyPlotMenu->addAction(title, this, [this, name] { copyPlot(name); });
    }
    edit->addAction(tr("Copy &mechanism"), this, &MainWindow::copyMechanism);
    edit->addSeparator();
    edit->addAction(tr("Rese&t parameters to Table 1"), this, [this] { m_session->setParameters(Parameters()); });

    QMenu *view = menuBar()->addMenu(tr("&View"));
    view->addAction(tr("Show &all of the plots"), QKeySequence(Qt::CTRL | Qt::Key_0), m_plotGrid, &PlotGrid::showAll);
    view->addMenu(tr("M&echanism"))->addActions(m_mechanismView->choices());
    QMenu *plots = view->addMenu(tr("Pl&ots"));
    plots->addActions(m_plotGrid->choices());
    QAction *fold = view->addAction(tr("Show the &panels below"), QKeySequence(Qt::Key_F9));
    fold->setCheckable(true);
    fold->setChecked(true);
    connect(fold, &QAction::triggered, this, [this](bool shown) { m_tabs->setFolded(!shown); });
    connect(m_tabs, &FoldingTabs::foldedChanged, fold, [fold](bool folded) { fold->setChecked(!folded); });
    m_ghostAction = view->addAction(tr("Show the file's &motion"), this, &MainWindow::findGhost);
    m_ghostAction->setCheckable(true);
    m_ghostAction->setChecked(true);
    m_ghostAction->setEnabled(false);
    view->addSeparator();
    auto *themes = new QActionGroup(this);
    const std::pair<Theme, QString> choices[] = {
        {Theme::System, tr("&System colours")}, {Theme::Light, tr("&Light")}, {Theme::Dark, tr("&Dark")}};
    const auto chosen = static_cast<Theme>(QSettings().value(QStringLiteral("theme"), 0).toInt());
    if (chosen != Theme::System) {
        QApplication::setPalette(paletteFor(chosen));
    }
    for (const auto &[theme, text] : choices) {
        QAction *action = view->addAction(text);
        action->setCheckable(true);
        action->setChecked(theme == chosen);
        themes->addAction(action);
        connect(action, &QAction::triggered, this, [this, value = theme] { setTheme(value); });
    }
    QMenu *languageMenu = view->addMenu(tr("Lan&guage"));
    auto *languages = new QActionGroup(this);
    const std::pair<Language, QString> languageNames[] = {{Language::System, tr("&System")},
                                                          {Language::English, QStringLiteral("&English")},
                                                          {Language::Spanish, QStringLiteral("Es&pañol")}};
    for (const auto &[language, text] : languageNames) { // each by its own name, for who does not read the other
        QAction *action = languageMenu->addAction(text);
        action->setCheckable(true);
        action->setChecked(language == chosenLanguage());
        languages->addAction(action);
        connect(action, &QAction::triggered, this, [value = language] {
            rememberLanguage(value);
            slidercrank::setLanguage(value);
        });
    }

    QMenu *playback = menuBar()->addMenu(tr("&Playback"));
    playback->addAction(tr("&Play or pause"), QKeySequence(Qt::Key_Space), m_timeline, &Timeline::togglePlaying);
    playback->addAction(tr("Step &forward"), QKeySequence(Qt::Key_Right), m_timeline, &Timeline::stepForward);
    playback->addAction(tr("Step &back"), QKeySequence(Qt::Key_Left), m_timeline, &Timeline::stepBack);
    playback->addAction(tr("To the &start"), QKeySequence(Qt::Key_Home), m_timeline, &Timeline::toStart);
    playback->addAction(tr("To the &end"), QKeySequence(Qt::Key_End), m_timeline, &Timeline::toEnd);

    QMenu *help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&What is this program"), QKeySequence::HelpContents, this,
                    [this] { (new HelpPage(tr("What is this program"), formulasText(), this))->show(); });
    help->addAction(tr("&Keyboard and mouse"), QKeySequence(Qt::CTRL | Qt::Key_F1), this,
                    [this] { (new HelpPage(tr("Keyboard and mouse"), shortcutsText(*menuBar()), this))->show(); });
    help->addSeparator();
    help->addAction(tr("&About"), this, &MainWindow::showAbout);
}

void MainWindow::buildStatusBar()
{
    m_progress->setRange(0, 0);
    m_progress->setMaximumWidth(140);
    m_progress->setAccessibleName(tr("Computing"));
    m_cancelButton->setText(tr("Cancel"));
    m_cancelButton->setObjectName(QStringLiteral("cancelButton"));
    for (QWidget *busy : {static_cast<QWidget *>(m_progress), static_cast<QWidget *>(m_cancelButton)}) {
        statusBar()->addPermanentWidget(busy);
        busy->hide();
    }
    statusBar()->setSizeGripEnabled(false);

    m_busyTimer->setSingleShot(true);
    m_busyTimer->setInterval(kBusyShownAfter);
    connect(m_busyTimer, &QTimer::timeout, this, [this] {
        m_progress->show();
        m_cancelButton->show();
    });
    connect(m_session, &Session::busyChanged, this, &MainWindow::setBusy);
    connect(m_session, &Session::readingProgressed, this, [this](double part) {
        m_progress->setRange(0, 100);
        m_progress->setValue(static_cast<int>(100.0 * part));
    });
    connect(m_session, &Session::referenceLoaded, this, [this] { m_progress->setRange(0, 0); }); // then it is compared
    connect(m_cancelButton, &QToolButton::clicked, this, [this] {
        const bool writes = m_animation || m_export;
        m_session->cancel();
        if (m_animation) {
            m_animation->cancel();
        }
        if (m_export) {
            m_export->cancel();
        }
        m_messageBar->showMessage(MessageBar::Kind::Hint, writes ? tr("Cancelled: nothing was written.")
                                                                 : tr("Cancelled: what is on show is from before."));
    });
}

void MainWindow::setBusy(bool busy)
{
    m_busy += busy ? 1 : -1;
    if (busy && m_busy == 1) {
        m_busyTimer->start();
    } else if (m_busy == 0) {
        m_busyTimer->stop();
        m_progress->hide();
        m_cancelButton->hide();
        m_progress->setRange(0, 0);
    }
}

void MainWindow::connectRooms()
{
    connect(m_parameterPanel, &ParameterPanel::edited, m_session, &Session::setParameters);
    connect(m_parameterPanel, &ParameterPanel::dragBegan, m_session, &Session::beginDrag);
    connect(m_parameterPanel, &ParameterPanel::dragEnded, m_session, &Session::endDrag);
    connect(m_session, &Session::parametersChanged, m_parameterPanel, &ParameterPanel::setParameters);
    connect(m_session, &Session::parametersChanged, m_timeline, &Timeline::setParameters);
    connect(m_session, &Session::settingsChanged, m_timeline,
            [this](const Sampling &sampling) { m_timeline->setSampling(sampling); });

    connect(m_session, &Session::resultChanged, m_mechanismView, &MechanismView::setResult);
    connect(m_session, &Session::resultChanged, m_plotGrid, &PlotGrid::setResult);
    connect(m_session, &Session::resultChanged, m_errorPanel, &ErrorPanel::setResult);
    connect(m_session, &Session::resultChanged, this, &MainWindow::showStatus);
    connect(m_session, &Session::resultChanged, this, &MainWindow::showAgreement);
    connect(m_session, &Session::diagnosisChanged, m_errorPanel, &ErrorPanel::setDiagnosis);
    connect(m_session, &Session::diagnosisChanged, this, &MainWindow::announce);
    connect(m_session, &Session::resultChanged, this, &MainWindow::findGhost);
    connect(m_session, &Session::diagnosisChanged, this, &MainWindow::findGhost);
    connect(m_session, &Session::timeChanged, this, &MainWindow::showGhost);
    connect(m_errorPanel, &ErrorPanel::remedyRequested, this, &MainWindow::remedy);

    connect(m_session, &Session::timeChanged, m_mechanismView, &MechanismView::setPose);
    connect(m_session, &Session::timeChanged, m_timeline, &Timeline::setPose);
    connect(m_session, &Session::timeChanged, m_plotGrid, &PlotGrid::setPose);
    connect(m_timeline, &Timeline::timeRequested, m_session, &Session::setTime);
    connect(m_plotGrid, &PlotGrid::timeRequested, m_session, &Session::setTime);
    connect(m_mechanismView, &MechanismView::timeRequested, m_session, &Session::setTime);
    connect(m_mechanismView, &MechanismView::lengthRequested, m_session, &Session::setParameter);
    connect(m_mechanismView, &MechanismView::dragBegan, m_session, &Session::beginDrag);
    connect(m_mechanismView, &MechanismView::dragEnded, m_session, &Session::endDrag);
    connect(m_errorPanel, &ErrorPanel::timeRequested, m_session, &Session::setTime);

    connect(m_plotGrid, &PlotGrid::openReferenceRequested, this, &MainWindow::chooseReference);
    connect(m_plotGrid, &PlotGrid::exportPlotRequested, this, [this](const QString &plotName) {
        exportPlotTo(plotName, chooseExportFile(plotName + QStringLiteral(".png")));
    });
    connect(m_plotGrid, &PlotGrid::copyPlotRequested, this, &MainWindow::copyPlot);
    connect(m_errorPanel, &ErrorPanel::openReferenceRequested, this, &MainWindow::chooseReference);
    connect(m_errorPanel, &ErrorPanel::openSampleRequested, this, &MainWindow::openSample);
    connect(m_session, &Session::problemFound, this,
            [this](const QString &sentence) { m_messageBar->showMessage(MessageBar::Kind::Problem, sentence); });
    connect(m_session, &Session::referenceRefused, this, [this](const QString &path, const QString &sentence) {
        const bool hasColumns = !layoutOf(beginningOf(path)).columns.empty(); // which of them is what may help
        m_messageBar->showMessage(MessageBar::Kind::Problem, sentence, hasColumns ? tr("Choose columns…") : QString(),
                                  hasColumns ? [this, path] { chooseColumns(path); } : std::function<void()>());
    });
    connect(m_session, &Session::referenceLoaded, this, [this](const std::shared_ptr<const Reference> &reference) {
        m_closeReferenceAction->setEnabled(reference != nullptr);
        m_ghostAction->setEnabled(reference != nullptr);
        const bool guessed = reference && !reference->asPrinted && reference->data.layout.isGuessed();
        m_announceReference = reference && !guessed; // with wrong columns it would be another mechanism's
        showTitle();
        m_messageBar->hide();
        if (guessed) {
            m_messageBar->showMessage(
                MessageBar::Kind::Hint,
                tr("The names in %1 do not tell what all of its columns are: some are guessed.").arg(reference->name),
                tr("Choose columns…"), [this] { chooseColumns(m_session->reference()->path); });
        }
        if (reference && reference->path != kSamplePath) {
            rememberReference(reference->path);
        }
    });
    connect(m_tabs, &FoldingTabs::foldedChanged, this, [this] { m_foldedByHand = true; });

    connect(m_scene, &SceneFile::changed, this, &MainWindow::showTitle);
    connect(m_scene, &SceneFile::problemFound, this,
            [this](const QString &sentence) { m_messageBar->showMessage(MessageBar::Kind::Problem, sentence); });
    connect(m_scene, &SceneFile::saved, this, [this](const QString &path) {
        m_messageBar->showMessage(MessageBar::Kind::Hint, tr("Saved: %1").arg(QDir::toNativeSeparators(path)));
    });
    connect(m_scene, &SceneFile::referenceMissing, this, [this](const QString &sentence) {
        m_messageBar->showMessage(MessageBar::Kind::Problem,
                                  tr("The scene is open without its reference. %1").arg(sentence),
                                  tr("Open reference…"), [this] { chooseReference(); });
    });
}

QWidget *MainWindow::makeReferencePanel()
{
    auto *panel = new ReferencePanel(this);
    panel->setReference(m_session->reference());
    panel->setDiagnosis(m_session->diagnosis());
    connect(m_session, &Session::referenceLoaded, panel, &ReferencePanel::setReference);
    connect(m_session, &Session::diagnosisChanged, panel, &ReferencePanel::setDiagnosis);
    connect(panel, &ReferencePanel::openReferenceRequested, this, &MainWindow::chooseReference);
    connect(panel, &ReferencePanel::openSampleRequested, this, &MainWindow::openSample);
    connect(panel, &ReferencePanel::columnsRequested, this, [this] { chooseColumns(m_session->reference()->path); });
    connect(panel, &ReferencePanel::applyRequested, m_session, &Session::apply);
    connect(panel, &ReferencePanel::readAsPrintedRequested, m_session, &Session::readAsPrinted);
    connect(panel, &ReferencePanel::takeOverRequested, m_session, &Session::takeOver);
    return panel;
}

QWidget *MainWindow::makeNewtonPanel()
{
    auto *panel = new NewtonPanel(this);
    panel->setSettings(m_session->sampling(), m_session->solver());
    panel->setResult(m_session->result());
    connect(panel, &NewtonPanel::edited, m_session, [this](const Sampling &sampling, const SolverSettings &solver) {
        m_session->setSolver(solver);
        m_session->setSampling(sampling);
    });
    connect(m_session, &Session::settingsChanged, panel, &NewtonPanel::setSettings);
    panel->setPose(m_session->pose());
    connect(m_session, &Session::resultChanged, panel, &NewtonPanel::setResult);
    connect(m_session, &Session::timeChanged, panel, &NewtonPanel::setPose);

    auto *highlight = new PartHighlight(m_mechanismView);
    highlight->setResult(m_session->result());
    highlight->setPose(m_session->pose());
    connect(panel, &NewtonPanel::partHovered, highlight, &PartHighlight::setPart);
    connect(m_session, &Session::resultChanged, highlight, &PartHighlight::setResult);
    connect(m_session, &Session::timeChanged, highlight, &PartHighlight::setPose);
    return panel;
}

QWidget *MainWindow::makeStudyPanel()
{
    auto *panel = new StudyPanel(this);
    panel->setParameters(m_session->parameters());
    connect(m_session, &Session::parametersChanged, panel, &StudyPanel::setParameters);
    return panel;
}

QWidget *MainWindow::makeLimitsPanel()
{
    auto *panel = new LimitsPanel(this);
    panel->setResult(m_session->result());
    connect(m_session, &Session::resultChanged, panel, &LimitsPanel::setResult);
    connect(panel, &LimitsPanel::timeRequested, m_session, &Session::setTime);
    return panel;
}

void MainWindow::openFile(const QString &path)
{
    if (path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) {
        m_scene->open(path);
    } else {
        openReference(path);
    }
}

void MainWindow::openReference(const QString &path)
{
    m_session->loadReference(path);
}

void MainWindow::openSample()
{
    openReference(kSamplePath);
}

void MainWindow::chooseReference()
{
    const QStringList recent = recentFiles();
    const QString folder = recent.isEmpty() ? QDir::homePath() : QFileInfo(recent.first()).absolutePath();
    const QString path = QFileDialog::getOpenFileName(this, tr("Open reference"), folder,
                                                      tr("Simulation results (*.csv *.txt *.tsv);;All files (*)"));
    if (!path.isEmpty()) {
        openReference(path);
    }
}

void MainWindow::chooseColumns(const QString &path)
{
    if (auto *open = findChild<ColumnMapping *>()) {
        open->close();
    }
    auto *dialog = new ColumnMapping(path, beginningOf(path), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ColumnMapping::chosen, m_session, &Session::readColumnsAnew);
    dialog->show();
}

void MainWindow::rememberReference(const QString &path)
{
    QStringList recent = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    recent.removeAll(absolute);
    recent.prepend(absolute);
    QSettings().setValue(QStringLiteral("recentReferences"), recent.mid(0, kRecentFiles));
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    for (const QString &path : SceneFile::recent()) {
        m_recentMenu->addAction(QDir::toNativeSeparators(path), this, [this, path] { m_scene->open(path); });
    }
    m_recentMenu->addSeparator();
    for (const QString &path : recentFiles()) {
        m_recentMenu->addAction(QDir::toNativeSeparators(path), this, [this, path] { openReference(path); });
    }
    if (m_recentMenu->isEmpty()) {
        m_recentMenu->addAction(tr("No file yet"))->setEnabled(false);
    }
}

void MainWindow::chooseAnimation()
{
    QStringList patterns;
    for (const QString &suffix : AnimationExport::suffixes()) {
        patterns << QStringLiteral("*.") + suffix;
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
    exportAnimationTo(QFileDialog::getSaveFileName(this, tr("Export animation"),
                                                   QDir(folder).filePath(QStringLiteral("motion.png")),
                                                   tr("Numbered frames, videos (%1)").arg(patterns.join(u' '))));
}

void MainWindow::exportAnimationTo(const QString &path)
{
    if (path.isEmpty() || m_animation) {
        return;
    }
    const Sampling &sampling = m_session->sampling();
    Animation animation;
    animation.start = sampling.start;
    animation.duration = sampling.duration;
    animation.size.size = m_mechanismView->size();
    animation.size.scale = kExportScale;
    animation.speed = m_timeline->speed();
    const auto view = std::make_shared<MechanismView>();
    view->setResult(m_session->result());
    view->setLook(m_mechanismView->look());
    const auto draw = [view, parameters = m_session->parameters(), ghost = m_ghost](QPainter &painter,
                                                                                    const QSize &size, double time) {
        view->setPose(poseAt(parameters, time));
        view->setGhost(ghost ? ghost(time) : ReferencePose());
        view->paintMechanism(painter, size, paletteFor(Theme::Light));
    };
    m_animation = new AnimationExport(animation, draw, this);
    connect(m_animation, &AnimationExport::progressed, this, [this](int done, int all) {
        m_progress->setRange(0, all);
        m_progress->setValue(done);
    });
    connect(m_animation, &AnimationExport::finished, this, [this, path](const QString &problem) {
        const bool complete = m_progress->value() == m_progress->maximum();
        m_animation->deleteLater();
        m_animation = nullptr;
        setBusy(false);
        if (complete || !problem.isEmpty()) {
            tellWritten(path, problem);
        }
    });
    setBusy(true);
    m_animation->start(path);
}

void MainWindow::exportAside(const QString &path, const ExportJob::Work &work,
                             const std::function<std::optional<QString>()> &finish)
{
    if (m_export) {
        m_messageBar->showMessage(MessageBar::Kind::Problem,
                                  tr("Another file is still being written: wait for it, or cancel it below."));
        return;
    }
    m_export = new ExportJob(this);
    connect(m_export, &ExportJob::progressed, this, [this](double part) {
        m_progress->setRange(0, 100);
        m_progress->setValue(static_cast<int>(100.0 * part));
    });
    connect(m_export, &ExportJob::finished, this, [this, path, finish](const QString &problem) {
        const bool isCancelled = m_export->isCancelled();
        m_export->deleteLater();
        m_export = nullptr;
        setBusy(false);
        if (!isCancelled) {
            tellWritten(path, problem.isEmpty() && finish ? finish().value_or(QString()) : problem);
        }
    });
    setBusy(true);
    m_export->start(work);
}

void MainWindow::tellWritten(const QString &path, const QString &problem)
{
    if (problem.isEmpty()) {
        m_messageBar->showMessage(MessageBar::Kind::Hint, tr("Written: %1").arg(QDir::toNativeSeparators(path)));
    } else {
        m_messageBar->showMessage(MessageBar::Kind::Problem, problem);
    }
}

void MainWindow::chooseData()
{
    const QString plotted = tr("The six channels of the plots (*.csv)");
    auto *dialog =
        new QFileDialog(this, tr("Export data"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({plotted, tr("All 36 channels (*.csv)")});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(QStringLiteral("motion.csv"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, plotted](const QString &path) {
        exportDataTo(path, dialog->selectedNameFilter() == plotted ? plottedChannels() : allChannels());
    });
    dialog->open();
}

void MainWindow::exportDataTo(const QString &path, const ChannelSet &channels)
{
    exportAside(path, [path, channels, result = m_session->result()](const std::stop_token &stop,
                                                                     const std::function<void(double)> &progress) {
        return exportMotion(path, *result, channels, stop, progress);
    });
}

void MainWindow::chooseReport()
{
    auto *dialog =
        new QFileDialog(this, tr("Export report"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                        tr("Reports (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->selectFile(QStringLiteral("report.pdf"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::exportReportTo);
    dialog->open();
}

void MainWindow::exportReportTo(const QString &path)
{
    const auto content = std::make_shared<ReportContent>();
    content->result = m_session->result();
    const auto write = [this, path, content]() -> std::optional<QString> {
        if (content->result != m_session->result()) {
            return tr("No report was written: the mechanism was changed meanwhile. Export it again.");
        }
        content->hasGhost = m_mechanismView->hasGhost();
        const QPalette palette = paletteFor(Theme::Light);
        const ReportDrawings drawings{
            [this, palette](QPainter &painter, const QSize &size) {
                m_mechanismView->paintMechanism(painter, size, palette);
            },
            [this, palette](QPainter &painter, const QSize &size) { m_plotGrid->paintFigure(painter, size, palette); }};
        return exportReport(path, *content, drawings);
    };
    const Result &result = *content->result;
    const std::shared_ptr<const Diagnosis> &diagnosis = m_session->diagnosis();
    const bool isKnown =
        diagnosis && diagnosis->reference == result.reference && diagnosis->parameters == result.mechanism.parameters();
    if (isKnown) {
        content->interpretation = diagnosis->found;
    }
    if (isKnown || !result.reference) {
        tellWritten(path, write().value_or(QString()));
        return;
    }
    const auto interpretAside = [content](const std::stop_token &stop, const auto &) -> std::optional<QString> {
        content->interpretation = interpret(content->result->reference->data, content->result->mechanism, stop);
        return std::nullopt;
    };
    exportAside(path, interpretAside, write);
}

QString MainWindow::chooseExportFile(const QString &proposal)
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileDialog::getSaveFileName(this, tr("Export"), QDir(folder).filePath(proposal),
                                        tr("Images and drawings (*.png *.svg *.pdf)"));
}

void MainWindow::exportTo(const QString &path, const QSize &size, const FigureDrawing &draw)
{
    if (path.isEmpty()) {
        return; // the person changed their mind
    }
    const FigureSize figureSize{size, kExportScale};
    tellWritten(path, exportFigure(path, figureSize, tr("Motion of an offset slider-crank"), draw).value_or(QString()));
}

void MainWindow::exportFigureTo(const QString &path)
{
    exportTo(path, m_plotGrid->size(), [this](QPainter &painter, const QSize &size) {
        m_plotGrid->paintFigure(painter, size, paletteFor(Theme::Light));
    });
}

void MainWindow::exportPlotTo(const QString &plotName, const QString &path)
{
    exportTo(path, kPlotSize, [this, plotName](QPainter &painter, const QSize &size) {
        m_plotGrid->paintPlot(painter, plotName, size, paletteFor(Theme::Light));
    });
}

void MainWindow::exportMechanismTo(const QString &path)
{
    exportTo(path, m_mechanismView->size(), [this](QPainter &painter, const QSize &size) {
        m_mechanismView->paintMechanism(painter, size, paletteFor(Theme::Light));
    });
}

void MainWindow::copy(const QSize &size, const FigureDrawing &draw, const QString &done)
{
    const std::optional<QString> problem = copyFigureToClipboard({size, kExportScale}, draw);
    m_messageBar->showMessage(problem ? MessageBar::Kind::Problem : MessageBar::Kind::Hint, problem.value_or(done));
}

void MainWindow::copyFigure()
{
    const auto draw = [this](QPainter &painter, const QSize &size) {
        m_plotGrid->paintFigure(painter, size, paletteFor(Theme::Light));
    };
    copy(m_plotGrid->size(), draw, tr("The figure is in the clipboard."));
}

void MainWindow::copyPlot(const QString &plotName)
{
    const auto draw = [this, plotName](QPainter &painter, const QSize &size) {
        m_plotGrid->paintPlot(painter, plotName, size, paletteFor(Theme::Light));
    };
    copy(kPlotSize, draw, tr("The plot is in the clipboard."));
}

void MainWindow::copyMechanism()
{
    const auto draw = [this](QPainter &painter, const QSize &size) {
        m_mechanismView->paintMechanism(painter, size, paletteFor(Theme::Light));
    };
    copy(m_mechanismView->size(), draw, tr("The mechanism is in the clipboard."));
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

void MainWindow::rememberLayout() const
{
    QSettings settings;
    settings.beginGroup(QStringLiteral("layout"));
    settings.setValue(QStringLiteral("window"), saveGeometry());
    for (const QSplitter *splitter : findChildren<QSplitter *>()) {
        const bool folded = splitter == m_tabs->parentWidget() && m_tabs->isFolded(); // then it tells no height
        if (!splitter->objectName().isEmpty() && !folded) {
            settings.setValue(splitter->objectName(), splitter->saveState());
        }
    }
    if (m_foldedByHand) {
        settings.setValue(QStringLiteral("folded"), m_tabs->isFolded());
    }
}

void MainWindow::restoreLayout()
{
    QSettings settings;
    settings.beginGroup(QStringLiteral("layout"));
    restoreGeometry(settings.value(QStringLiteral("window")).toByteArray());
    for (QSplitter *splitter : findChildren<QSplitter *>()) {
        splitter->restoreState(settings.value(splitter->objectName()).toByteArray());
    }
    const QVariant folded = settings.value(QStringLiteral("folded"));
    if (folded.isValid()) {
        m_tabs->setFolded(folded.toBool());
        m_foldedByHand = true;
    }
}

void MainWindow::setTheme(Theme theme)
{
    QApplication::setPalette(paletteFor(theme));
    QSettings().setValue(QStringLiteral("theme"), static_cast<int>(theme));
}

void MainWindow::showStatus(const std::shared_ptr<const Result> &result)
{
    const QLocale locale;
    const RunSummary &run = result->summary;
    const std::size_t samples = run.instants;
    const std::size_t missing = run.count(Status::NotAssemblable);
    const QString branch = result->mechanism.branch() == Branch::Open ? tr("Open assembly") : tr("Crossed assembly");
    QString assembly = QStringLiteral("%1, %2").arg(branch, mobilityText(result->limits));
    if (missing > 0 && result->limits.mobility != Mobility::Impossible) {
        assembly += tr(", no pose at %1 of %2 instants").arg(missing).arg(samples);
    }
    QString method = tr("closed form (exact)");
    if (result->solver.method == Method::Newton) {
        method =
            tr("Newton-Raphson, at most %1 iterations, residual %2")
                .arg(QString::number(run.mostIterations), locale.toString(run.largestResidual, 'g', 2));
    }
    const QString cost = tr("%1 samples in %2 ms")
                             .arg(locale.toString(static_cast<qulonglong>(samples)),
                                  shortNumber(result->computeSeconds * 1e3, 2, locale));
    // A message, not labels: those would lay the whole window out anew with every move of a slider.
    statusBar()->showMessage(QStringLiteral("%1  ·  %2  ·  %3").arg(assembly, method, cost));
}

void MainWindow::showAgreement(const std::shared_ptr<const Result> &result)
{
    const auto differing =
        std::count_if(result->comparison.begin(), result->comparison.end(),
                      [](const ChannelComparison &channel) { return channel.verdict == Verdict::Differs; });
    m_tabs->setTitle(m_errorPanel, differing > 0 ? tr("Errors ⚠") : tr("Errors"));
}

/// Said once, when a file is opened or read otherwise: what it says about itself, with the remedy at hand.
void MainWindow::announce(const std::shared_ptr<const Diagnosis> &diagnosis)
{
    const Result &result = *m_session->result();
    if (!diagnosis || !m_announceReference || diagnosis->reference != result.reference) {
        return;
    }
    m_announceReference = false;
    if (!m_messageBar->isHidden()) {
        return; // opening the file cleared it: what it says is newer
    }
    const std::vector<Finding> findings = findingsOf(result, diagnosis.get());
    if (findings.empty() || findings.front().remedy == Finding::Remedy::ReadAsPrinted) {
        return; // it agrees
    }
    const Finding &first = findings.front();
    const QString sentence = tr("%1 differs from this mechanism. %2").arg(result.reference->name, first.sentence);
    if (findings.size() == 1 && first.remedy != Finding::Remedy::None) {
        m_messageBar->showMessage(MessageBar::Kind::Problem, sentence, first.remedyText,
                                  [this, first] { remedy(first); });
    } else {
        m_messageBar->showMessage(MessageBar::Kind::Problem, sentence, tr("Show the errors"),
                                  [this] { m_tabs->showPage(m_errorPanel); });
    }
}

void MainWindow::remedy(const Finding &finding)
{
    m_messageBar->hide();
    switch (finding.remedy) {
    case Finding::Remedy::None: break;
    case Finding::Remedy::TakeOver: m_session->takeOver(); break;
    case Finding::Remedy::Apply: m_session->apply(finding.convention); break;
    case Finding::Remedy::ReadAsPrinted: m_session->readAsPrinted(); break;
    }
}

/// The linkage as the file has it, where that is another one; its lengths, which the file does not tell, those of the
/// mechanism found for it.
void MainWindow::findGhost()
{
    const Result &result = *m_session->result();
    const bool differs = std::ranges::any_of(
        result.comparison, [](const ChannelComparison &channel) { return channel.verdict == Verdict::Differs; });
    if (differs && m_ghostAction->isChecked()) {
        const std::shared_ptr<const Diagnosis> &diagnosis = m_session->diagnosis();
        const bool found = diagnosis && diagnosis->found.identification.status == Identification::Status::Found;
        const Mechanism lengths(found ? diagnosis->found.identification.parameters : m_session->parameters());
        m_ghost = [lengths, reference = result.reference](double time) {
            return referencePoseAt(reference->data, lengths, time);
        };
        m_mechanismView->setGhostReach(reachOf(result.reference->data, lengths));
    } else {
        m_ghost = nullptr;
        m_mechanismView->setGhostReach(QRectF());
    }
    showGhost();
}

void MainWindow::showGhost()
{
    m_mechanismView->setGhost(m_ghost ? m_ghost(m_session->time()) : ReferencePose());
}

void MainWindow::showAbout()
{
    auto *about = new QMessageBox(
        QMessageBox::NoIcon, tr("About"),
        tr("<h3>slidercrank %1</h3><p>The motion of an offset slider-crank: computed, shown, and compared "
           "with a simulation.</p><p>Formulation after A. A. Shabana, <i>Computational Dynamics</i>.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, this);
    about->setObjectName(QStringLiteral("aboutBox"));
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->setIconPixmap(windowIcon().pixmap(64));
    about->open(); // does not wait: what plays goes on
}

/// The first time ever: what there is to do.
void MainWindow::greetOnce()
{
    const QString key = QStringLiteral("greeted");
    if (QSettings().value(key).toBool()) {
        return;
    }
    QSettings().setValue(key, true);
    greet();
}

void MainWindow::greet()
{
    m_greeting = tr("Move a slider and everything follows; Space plays. Drop a simulation's CSV here to see "
                    "how far it is from this mechanism, or try it with the sample.");
    m_messageBar->showMessage(MessageBar::Kind::Hint, m_greeting, tr("Open the sample"), [this] { openSample(); });
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_scene->isModified() && !m_isLeaving) {
        event->ignore();
        m_scene->askThen([this] {
            m_isLeaving = true;
            close();
            m_isLeaving = false;
        });
        return;
    }
    rememberLayout();
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent *event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) {
        event->acceptProposedAction();
        openFile(urls.first().toLocalFile());
    }
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    if (!m_foldedByHand) {
        m_tabs->setFolded(height() < kFoldBelowHeight);
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

/// The playback keys (Space, arrows, Home, End) belong to the control that has the focus where it has a use for them.
bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        const bool activates = key == Qt::Key_Space && qobject_cast<QAbstractButton *>(watched);
        const bool moves = (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End) &&
                           (qobject_cast<QAbstractSlider *>(watched) || qobject_cast<QComboBox *>(watched) ||
                            qobject_cast<QAbstractItemView *>(watched) || watched->inherits("QTabBar"));
        if (activates || moves) {
            event->accept();
            return true;
        }
        const bool isInNumber = qobject_cast<QAbstractSpinBox *>(watched) ||
                                qobject_cast<QAbstractSpinBox *>(watched->parent()); // or in the line within
        if (key == Qt::Key_Space && isInNumber) {
            event->ignore(); // no number has a space
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

} // namespace slidercrank
