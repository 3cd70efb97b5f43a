// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/document/scene_link.h"
#include "ui/document/with.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/column_mapping.h"
#include "ui/panels/design_form.h"
#include "ui/panels/error_page.h"
#include "ui/panels/limits_page.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/panels/newton_pages.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/polygon_view.h"
#include "ui/panels/reference_page.h"
#include "ui/panels/response_view.h"
#include "ui/panels/segmented_pages.h"
#include "ui/panels/solver_form.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/table_panel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/named.h"
#include "ui/widgets/open_dialog.h"
#include "ui/widgets/scrollable.h"
#include "ui/window/exports.h"
#include "ui/window/ghost.h"
#include "ui/window/key_filter.h"
#include "ui/window/menus.h"
#include "ui/window/messages.h"
#include "ui/window/presentation.h"
#include "ui/window/recovery.h"
#include "ui/window/scene_file.h"
#include "ui/window/status_bar.h"
#include "ui/window/window_settings.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QFrame>
#include <QMimeData>
#include <QScreen>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace slidercrank
{

namespace
{

const QString kSamplePath = ":/data/inventor_sample.csv";

constexpr QSize kInitialSize(1400, 900); // px

/// Returns a height (px) at which the error table and its text are visible, also with a large font.
int panelHeight(const QWidget &tabs)
{
    constexpr int kMinHeight = 230; // px
    constexpr int kMinLines = 15;   // of text
    return std::max(kMinHeight, kMinLines * tabs.fontMetrics().height());
}

QStringList droppedFiles(const QDropEvent &event)
{
    QStringList paths;
    for (const QUrl &url : event.mimeData()->urls()) {
        paths += isSceneLink(url.toString()) ? url.toString() : url.toLocalFile();
    }
    paths.removeAll(QString()); // the path of a URL that is not a local file
    return paths;
}

QSplitter *makeSplitter(const QString &name, Qt::Orientation orientation, QWidget *first, QWidget *second)
{
    auto *splitter = new QSplitter(orientation);
    splitter->setObjectName(name);
    splitter->addWidget(first);
    splitter->addWidget(second);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

/// Puts the mechanism and its controls on the left, and the plots above the tabs on the right.
QSplitter *layOut(const Views &views)
{
    auto *left = new QWidget;
    auto *leftColumn = new QVBoxLayout(left);
    constexpr QMargins kBesideSplitter{6, 6, 3, 6}; // px; the splitter is on the right
    leftColumn->setContentsMargins(kBesideSplitter);
    leftColumn->addWidget(views.mechanism, 1);
    leftColumn->addWidget(views.timeline);
    leftColumn->addWidget(views.parameters);
    constexpr int kMinWidth = 340; // px, of the controls in the longest language
    left->setMinimumWidth(kMinWidth);

    QSplitter *right = makeSplitter("plotsAndTabs", Qt::Vertical, views.plots, views.tabs);
    right->setStretchFactor(0, 1);
    right->setStretchFactor(1, 0);
    constexpr int kUsualPlotHeight = 600; // px
    right->setSizes({kUsualPlotHeight, panelHeight(*views.tabs)});
    QObject::connect(views.tabs, &FoldingTabs::foldedChanged, right, [right](bool folded) {
        const int height = right->sizes().value(0) + right->sizes().value(1);
        const int tabs = folded ? 0 : panelHeight(*right->widget(1));
        right->setSizes({height - tabs, tabs});
    });

    QSplitter *columns = makeSplitter("columns", Qt::Horizontal, left, right);
    columns->setStretchFactor(0, 2);
    columns->setStretchFactor(1, 3);
    columns->setSizes({2 * kInitialSize.width() / 5, 3 * kInitialSize.width() / 5});
    return columns;
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_session(new Session(this))
    , m_scene(new SceneFile(m_session, m_views, this))
    , m_exports(new Exports(m_session, m_views, this))
    , m_status(new StatusBar(this))
{
    setAcceptDrops(true);
    resize(kInitialSize);
    if (chosenTheme() != Theme::System) {
        QApplication::setPalette(paletteFor(chosenTheme()));
    }
    slidercrank::setNotation(chosenNotation());
    auto *page = new QWidget; // with the message bar over it
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    setCentralWidget(page);
    auto *messageBar = new MessageBar(page);
    showMessages(this, messageBar);
    m_presentation = new Presentation(m_views, messageBar, this);
    makeViews();
    column->addWidget(m_views.columns);
    setStatusBar(m_status);
    setMenuBar(new Menus(*this, m_views));
    // The shortcuts of the window also work in the form of the time range.
    m_views.timeline->form()->addActions(menuBar()->findChildren<QAction *>());
    m_views.timeline->refreshNotation();
    connectDocument();
    showTitle();
    showResult(m_session->result());
    restoreLayout(*this);
    new KeyFilter(this);
    m_session->setTime(m_session->sampling().start);
    new Recovery(m_session, m_scene, messageBar, this);
    m_views.mechanism->setFocus();
}

/// Takes the focus away first, so that a number box enters its text while the views still exist.
MainWindow::~MainWindow()
{
    if (QWidget *widget = focusWidget()) {
        widget->clearFocus();
    }
}

void MainWindow::connectDocument()
{
    connect(m_session, &Session::resultChanged, this, &MainWindow::showResult);
    connect(m_session, &Session::referenceLoaded, this, &MainWindow::followReference);
    connect(m_scene, &SceneFile::changed, this, &MainWindow::showTitle);
    connect(m_scene, &SceneFile::notationChosen, this, &MainWindow::setNotation);
    connect(m_session, &Session::busyChanged, m_status, &StatusBar::setBusy);
    connect(m_session, &Session::progressed, m_status, &StatusBar::setProgress);
    connect(m_status, &StatusBar::cancelled, m_session, &Session::cancel);
}

void MainWindow::makeViews()
{
    m_views.mechanism = new MechanismView;
    m_views.timeline = new Timeline(m_session);
    m_views.parameters = new ParameterPanel(m_session);
    m_views.parameters->refreshNotation();
    connect(m_views.parameters, &ParameterPanel::crankSpeedUnitChosen, this, [this](CrankSpeedUnit unit) {
        if (unit != notation().crankSpeed) {
            setNotation(with(notation(), &Notation::crankSpeed, unit));
        }
    });
    m_views.plots = new PlotGrid;
    m_views.tabs = new FoldingTabs;
    makeTabs();
    m_views.columns = layOut(m_views);
    connectMechanism();
    connectPlots();
    m_views.ghost = new Ghost(m_session, m_views.mechanism);
}

void MainWindow::makeTabs()
{
    m_views.errors = makePanel("errorPanel", tr("Errors against the reference"),
                               [this] { return errorPage(*m_session->result(), m_session->identification().get()); });
    m_views.tabs->addTab(makeMotionTable(), tr("Table"));
    m_views.tabs->addTab(makeLimitsPanel(), tr("Motion limits"));
    m_views.tabs->addTab(m_views.errors, QString());
    m_views.tabs->addTab(
        makePanel("referencePanel", tr("Reference"),
                  [this] { return referencePage(*m_session->result(), m_session->identification().get()); }),
        tr("Reference"));
    m_views.tabs->addPage(tr("Newton-Raphson"), [this] { return makeNewtonPanel(); });
    m_views.tabs->addPage(tr("Speed and accuracy"), [this] { return new StudyPanel(m_session); });
}

void MainWindow::connectMechanism()
{
    MechanismView *view = m_views.mechanism;
    view->setResult(m_session->result());
    connect(m_session, &Session::resultChanged, view, &MechanismView::setResult);
    connect(m_session, &Session::timeChanged, view, &MechanismView::setPose);
    connect(view, &MechanismView::timeRequested, m_session, &Session::setTime);
    connect(view, &MechanismView::lengthRequested, m_session, &Session::setParameter);
    connect(view, &MechanismView::branchRequested, m_session, [this](Branch branch) {
        m_session->setParameters(with(m_session->parameters(), &Parameters::branch, branch));
    });
    connect(view, &MechanismView::dragBegan, m_session, &Session::beginDrag);
    connect(view, &MechanismView::dragEnded, m_session, &Session::endDrag);
    connect(view, &MechanismView::fullWindowToggleRequested, m_presentation,
            [this] { m_presentation->setMechanismAlone(m_views.plots->isVisible()); });
}

void MainWindow::connectPlots()
{
    PlotGrid *plots = m_views.plots;
    plots->setResult(m_session->result());
    connect(m_session, &Session::resultChanged, plots, &PlotGrid::setResult);
    connect(m_session, &Session::timeChanged, plots, &PlotGrid::setPose);
    connect(plots, &PlotGrid::timeRequested, m_session, &Session::setTime);
    connect(plots, &PlotGrid::openReferenceRequested, this, &MainWindow::chooseFiles);
    connect(plots, &PlotGrid::exportPlotRequested, m_exports,
            [this](const QString &name) { m_exports->choose(m_exports->plot(name)); });
    connect(plots, &PlotGrid::copyPlotRequested, m_exports,
            [this](const QString &name) { m_exports->copy(m_exports->plot(name)); });
}

/// Creates a panel whose page is made again whenever the result or the identification changes.
TablePanel *MainWindow::makePanel(const QString &name, const QString &title, const std::function<Page()> &makePage)
{
    auto *panel = new TablePanel(m_session, name, title, makePage);
    connect(m_session, &Session::resultChanged, panel, &TablePanel::refresh);
    connect(m_session, &Session::identificationChanged, panel, &TablePanel::refresh);
    connect(panel, &TablePanel::timeRequested, m_session, &Session::setTime);
    connect(panel, &TablePanel::timeRequested, m_views.plots, &PlotGrid::showTime);
    connect(panel, &TablePanel::remedyRequested, this, &MainWindow::applyRemedy);
    return panel;
}

QWidget *MainWindow::makeMotionTable()
{
    auto *table = m_views.table = new MotionTablePanel(m_session);
    connect(table, &MotionTablePanel::timeRequested, m_session, &Session::setTime);
    connect(table, &MotionTablePanel::timeRequested, m_views.plots, &PlotGrid::showTime);
    connect(table, &MotionTablePanel::symbolsChosen, this,
            [this](Symbols symbols) { setNotation(with(notation(), &Notation::symbols, symbols)); });
    if (!isNotationChosen()) {
        table->offerTextbookNotation();
    }
    // While the window is destroyed, the table is hidden and reports that no row is hovered. That does not use
    // `session`.
    const auto mark = [session = m_session, view = m_views.mechanism](const std::optional<double> &theta2) {
        view->setMarkedPose(theta2 ? referencePoseAt(withCrankAt(Mechanism(session->parameters()), *theta2), 0.0)
                                   : ReferencePose());
    };
    connect(table, &MotionTablePanel::positionHovered, m_views.mechanism, mark);
    return scrollable(table); // otherwise a window on a small screen would become higher than the screen
}

QWidget *MainWindow::makeLimitsPanel()
{
    auto *panel = named("limits", new SegmentedPages("limitsPages"), tr("Motion limits"));
    panel->addPage(tr("Values"),
                   makePanel("limitsPanel", tr("Motion limits"), [this] { return limitsPage(*m_session->result()); }));
    auto *response = new ResponseView(m_session);
    constexpr int kResponsePage = 1; // index of the page that is added next
    panel->addPage(tr("Response"), response);
    auto *polygons = new PolygonView(m_session);
    panel->addPage(tr("Polygons"), polygons);
    panel->addPage(tr("Design"), new DesignForm(m_session));
    connect(m_views.parameters, &ParameterPanel::responseRequested, panel,
            [this, panel, response](Parameter parameter) {
                response->setParameter(parameter);
                panel->setCurrent(kResponsePage);
                m_views.tabs->setCurrentWidget(panel);
                m_views.tabs->setFolded(false);
            });
    return panel;
}

QWidget *MainWindow::makeNewtonPanel()
{
    auto *panel = named("newtonPanel", new SegmentedPages("newtonPages"), tr("Newton-Raphson"));
    panel->addPage(tr("Settings"), new SolverForm(m_session));
    const auto addPage = [this, panel](const char *name, const QString &title,
                                       Page (*makePage)(const Result &, double)) {
        const auto make = [this, makePage] { return makePage(*m_session->result(), m_session->time()); };
        TablePanel *page = makePanel(QString::fromLatin1(name), title, make);
        connect(m_session, &Session::timeChanged, page, &TablePanel::refresh);
        connect(page, &TablePanel::partHovered, m_views.mechanism, &MechanismView::highlight);
        panel->addPage(title, page);
    };
    addPage("equationPanel", tr("Equations"), NewtonPages::equations);
    addPage("jacobianPanel", tr("Jacobian"), NewtonPages::jacobian);
    addPage("iterationPanel", tr("Iterations"), NewtonPages::iterations);
    addPage("coordinatePanel", tr("Coordinates"), NewtonPages::coordinates);
    return panel;
}

void MainWindow::showWithinScreen()
{
    constexpr QSize kMaxFrame(20, 60); // px; the size of the frame is known only once the window is shown
    const QSize available = screen()->availableSize() - kMaxFrame;
    if (!isMaximized() && size().boundedTo(available) != size()) {
        resize(size().boundedTo(available)); // for window managers that do not maximize
        setWindowState(Qt::WindowMaximized);
    }
    show();
}

std::unique_ptr<MainWindow> MainWindow::makeReplacement()
{
    m_scene->enterTypedNumber();
    m_presentation->setOn(false); // so that the layout is that of the window
    saveLayout(*this);
    setLanguage(chosenLanguage());
    auto window = std::make_unique<MainWindow>();
    window->m_scene->takeOver(*m_scene);
    window->m_views.tabs->setCurrentIndex(m_views.tabs->currentIndex());
    window->m_views.tabs->setFolded(m_views.tabs->isFolded());
    return window;
}

void MainWindow::openFiles(const QStringList &paths)
{
    const auto scene = std::ranges::find_if(paths, isNamedAsScene);
    if (scene == paths.end()) {
        openReference(paths);
    } else if (paths.size() == 1) {
        m_scene->open(*scene);
    } else {
        m_session->reportFailure(tr("%1 is a scene: open it alone, and the files of one motion together.")
                                     .arg(QFileInfo(*scene).fileName()));
    }
}

void MainWindow::openReference(const QStringList &paths)
{
    QStringList sorted;
    for (const QString &path : paths) {
        sorted += QFileInfo(path).absoluteFilePath(); // scenes and settings store it
    }
    sorted.sort(); // the order in which files are picked does not matter
    m_session->loadReference(sorted);
}

void MainWindow::followReference(const std::shared_ptr<const Reference> &reference)
{
    showTitle();
    const std::shared_ptr<const Reference> &shownReference = m_session->result()->choices.reference;
    if (!reference || (shownReference && shownReference->source.paths ==
                                             reference->source.paths)) { // the same file is interpreted differently
        return;
    }
    m_views.tabs->setCurrentWidget(m_views.errors);
    if (!m_presentation->isOn()) {
        m_views.tabs->setFolded(false); // the verdict would be hidden on a small screen
    }
    if (reference->source.paths != QStringList(kSamplePath)) {
        rememberFiles(reference->source.paths);
    }
}

void MainWindow::openSample()
{
    openReference(kSamplePath);
}

void MainWindow::chooseFiles()
{
    chooseFilesToOpen(
        this, {tr("Open"), recentFolder(),
               tr("Scenes and simulation results (*.slidercrank *.json *.csv *.txt *.tsv *.tab *.dat *.dta *.mot);;"
                  "All files (*)"),
               [this](const QStringList &paths) { openFiles(paths); }});
}

void MainWindow::chooseColumns(const QStringList &paths)
{
    if (auto *open = findChild<ColumnMapping *>()) {
        open->close();
    }
    auto *dialog = new ColumnMapping(paths, readBeginnings(paths), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ColumnMapping::chosen, m_session, qOverload<const QStringList &>(&Session::loadReference));
    dialog->show();
}

void MainWindow::applyRemedy(const Finding &finding)
{
    switch (finding.remedy) {
    case Remedy::None:
    case Remedy::RunStudy: break;
    case Remedy::UseFoundMechanism: m_session->useFoundMechanism(); break;
    case Remedy::ApplyConvention: m_session->apply(finding.convention); break;
    case Remedy::ReadAsPrinted: m_session->readAsPrinted(); break;
    case Remedy::ChooseColumns: chooseColumns(m_session->reference()->source.paths); break;
    case Remedy::OpenFile: chooseFiles(); break;
    }
}

void MainWindow::showTitle()
{
    const std::shared_ptr<const Reference> &reference = m_session->reference();
    QString document = QFileInfo(m_scene->path()).fileName();
    if (document.isEmpty() && reference) {
        document = reference->name;
    }
    setWindowTitle(document.isEmpty() ? tr("Slider-crank[*]") : tr("%1[*] – Slider-crank").arg(document));
    setWindowModified(m_session->isModified());
}

void MainWindow::showResult(const std::shared_ptr<const Result> &result)
{
    const int tab = m_views.tabs->indexOf(m_views.errors);
    if (const QString title = errorTitle(*result);
        title != m_views.tabs->tabText(tab)) { // setting the text lays out the window again
        m_views.tabs->setTabText(tab, title);
    }
    m_status->showMessage(samplingText(*result)); // unlike a label, this does not lay out the window
}

/// Shows everything in the notation, and remembers it.
void MainWindow::setNotation(const Notation &notation)
{
    slidercrank::setNotation(notation);
    rememberNotation(notation);
    m_views.parameters->refreshNotation();
    m_views.table->refreshNotation();
    m_views.timeline->refreshNotation();
    m_views.mechanism->refreshNotation();
    emit m_session->resultChanged(m_session->result()); // the views read the notation again
    emit m_session->timeChanged(m_session->pose());
}

void MainWindow::setTheme(Theme theme)
{
    QApplication::setPalette(paletteFor(theme));
    rememberTheme(theme);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    m_scene->enterTypedNumber();
    if (m_exports->isWriting()) {
        event->ignore();
        m_session->reportFailure(tr("A file is still being written. Close the window when it is done, or cancel it "
                                    "below."));
        return;
    }
    if (m_session->isModified()) {
        event->ignore();
        m_scene->askThen([this] {
            m_session->undoStack().setClean(); // the changes are saved or discarded
            close();
        });
        return;
    }
    m_presentation->setOn(false);
    saveLayout(*this);
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

/// Ignores status tips, so that menus do not clear the status line.
bool MainWindow::event(QEvent *event)
{
    return event->type() == QEvent::StatusTip || QMainWindow::event(event);
}

} // namespace slidercrank

#include "moc_main_window.cpp"
