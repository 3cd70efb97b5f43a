// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/menus.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/limits_panel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/exports.h"
#include "ui/window/ghost.h"
#include "ui/window/help_page.h"
#include "ui/window/main_window.h"
#include "ui/window/presentation.h"
#include "ui/window/remembered.h"
#include "ui/window/scene_file.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDir>
#include <QKeyEvent>
#include <QMessageBox>

#include <functional>
#include <initializer_list>
#include <utility>

namespace slidercrank
{

namespace
{

QAction *addSwitch(QMenu *menu, const QString &text, bool on)
{
    QAction *action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

/// One of them at a time.
template <typename Choice>
void addChoices(QMenu *menu, std::initializer_list<std::pair<Choice, QString>> choices, Choice chosen,
                const std::function<void(Choice)> &choose)
{
    auto *group = new QActionGroup(menu);
    for (const auto &[choice, text] : choices) {
        QAction *action = addSwitch(menu, text, choice == chosen);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, menu, [choose, value = choice] { choose(value); });
    }
}

/// What one can do with each of the nine plots.
void addPlots(QMenu *menu, const PlotGrid &plots, const std::function<void(const QString &plotName)> &act)
{
    for (const QString &name : PlotGrid::plotNames()) {
        const auto *plot = plots.findChild<QWidget *>(name);
        menu->addAction(plot ? plot->accessibleName() : name, menu, [act, name] { act(name); });
    }
}

/// Enabled while there is a reference.
void needsReference(QAction *action, const Session &session)
{
    action->setEnabled(session.reference() != nullptr);
    QObject::connect(
        &session, &Session::referenceLoaded, action,
        [action](const std::shared_ptr<const Reference> &reference) { action->setEnabled(reference != nullptr); });
}

/// Enabled while that holds of what is on show.
void enableWhile(QAction *action, const Session &session, const std::function<bool(const Result &)> &holds)
{
    action->setEnabled(holds(*session.result()));
    QObject::connect(
        &session, &Session::resultChanged, action,
        [action, holds](const std::shared_ptr<const Result> &result) { action->setEnabled(holds(*result)); });
}

} // namespace

Menus::Menus(MainWindow &window, const Rooms &rooms)
    : QMenuBar(&window)
    , m_window(window)
    , m_rooms(rooms)
{
    addFile();
    addEdit();
    addView();
    addPlayback();
    addHelp();
}

void Menus::addFile()
{
    SceneFile *scene = &m_window.scene();
    Exports *exports = &m_window.exports();
    QMenu *file = addMenu(tr("&File"));
    file->addAction(tr("&Open reference…"), QKeySequence::Open, &m_window, &MainWindow::chooseReference);
    file->addAction(tr("Open sc&ene…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), scene,
                    &SceneFile::chooseAndOpen);
    QMenu *recent = file->addMenu(tr("Open &recent"));
    recent->setObjectName(QStringLiteral("recentMenu"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    file->addAction(tr("Open the samp&le"), &m_window, &MainWindow::openSample);
    QAction *closeReference = file->addAction(tr("&Close reference"), QKeySequence::Close, this,
                                              [this] { m_window.session().setReference(nullptr); });
    needsReference(closeReference, m_window.session());
    file->addSeparator();
    file->addAction(tr("&Save scene"), QKeySequence::Save, scene, [scene] { scene->save(); });
    file->addAction(tr("Save scene &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), scene,
                    [scene] { scene->saveAs(); });
    file->addSeparator();
    QMenu *exporting = file->addMenu(tr("E&xport"));
    exporting->addAction(tr("&Figure…"), QKeySequence(Qt::CTRL | Qt::Key_E), exports,
                         [exports] { exports->choose(exports->figure()); });
    addPlots(exporting->addMenu(tr("&Plot")), *m_rooms.plots,
             [exports](const QString &name) { exports->choose(exports->plot(name)); });
    exporting->addAction(tr("&Mechanism…"), exports, [exports] { exports->choose(exports->mechanism()); });
    exporting->addAction(tr("&Data…"), exports, &Exports::chooseData);
    exporting->addAction(tr("&Report…"), exports, &Exports::chooseReport);
    exporting->addAction(tr("&Animation…"), exports, &Exports::chooseAnimation);
    file->addSeparator();
    file->addAction(tr("&Quit"), QKeySequence::Quit, &m_window, &QWidget::close);
}

void Menus::fillRecent(QMenu *menu)
{
    menu->clear();
    for (const QString &path : recentFiles(kRecentScenes)) {
        menu->addAction(QDir::toNativeSeparators(path), this, [this, path] { m_window.scene().open(path); });
    }
    menu->addSeparator();
    for (const QStringList &paths : recentReferences()) {
        const QString first = QDir::toNativeSeparators(paths.first());
        menu->addAction(paths.size() == 1 ? first : tr("%1 + %2 more").arg(first, QString::number(paths.size() - 1)),
                        this, [this, paths] { m_window.openReference(paths); });
    }
    if (menu->isEmpty()) {
        menu->addAction(tr("No file yet"))->setEnabled(false);
    }
}

void Menus::addEdit()
{
    Session &session = m_window.session();
    Exports *exports = &m_window.exports();
    QMenu *edit = addMenu(tr("&Edit"));
    QAction *undo = session.undoStack().createUndoAction(edit, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    undo->setIconText(tr("&Undo").remove(u'&')); // its text says what as well
    edit->addAction(undo);
    QAction *redo = session.undoStack().createRedoAction(edit, tr("&Redo"));
    redo->setIconText(tr("&Redo").remove(u'&'));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addAction(redo);
    edit->addSeparator();
    edit->addAction(tr("&Copy figure"), QKeySequence::Copy, exports, [exports] { exports->copy(exports->figure()); });
    addPlots(edit->addMenu(tr("Copy &plot")), *m_rooms.plots,
             [exports](const QString &name) { exports->copy(exports->plot(name)); });
    edit->addAction(tr("Copy &mechanism"), exports, [exports] { exports->copy(exports->mechanism()); });
    edit->addSeparator();
    edit->addAction(tr("P&in this motion"), QKeySequence(Qt::CTRL | Qt::Key_K), &session, &Session::keep);
    QAction *forget = edit->addAction(tr("Remo&ve pinned motions"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
                                      &session, &Session::forgetKept);
    enableWhile(forget, session, [](const Result &result) { return !result.kept.empty(); });
    edit->addAction(tr("Rese&t all parameters"), &session, [&session] { session.setParameters(Parameters()); });
}

void Menus::addView()
{
    FoldingTabs *tabs = m_rooms.tabs;
    QMenu *view = addMenu(tr("&View"));
    view->addAction(tr("&Reset plot zoom"), QKeySequence(Qt::CTRL | Qt::Key_0), m_rooms.plots, &PlotGrid::showAll);
    view->addMenu(tr("M&echanism"))->addActions(m_rooms.mechanism->choices());
    view->addMenu(tr("Pl&ots"))->addActions(m_rooms.plots->choices());
    tabs->findChild<LimitsPanel *>()->fillMenu(view->addMenu(tr("Respo&nse to")));
    Presentation *presentation = &m_window.presentation();
    QAction *present = addSwitch(view, tr("Presentation &mode"), presentation->isOn());
    present->setShortcut(QKeySequence(Qt::Key_F11));
    connect(present, &QAction::triggered, presentation, &Presentation::setOn);
    connect(presentation, &Presentation::changed, present, &QAction::setChecked);
    QAction *fold = addSwitch(view, tr("Show the &panels below"), true);
    fold->setShortcut(QKeySequence(Qt::Key_F9));
    connect(fold, &QAction::triggered, tabs, [tabs](bool shown) { tabs->setFolded(!shown); });
    connect(tabs, &FoldingTabs::foldedChanged, fold, [fold](bool folded) { fold->setChecked(!folded); });
    QAction *ghost = addSwitch(view, tr("Show the mo&tion of the file or pinned"), m_rooms.ghost->isWanted());
    connect(ghost, &QAction::triggered, m_rooms.ghost, &Ghost::setWanted);
    enableWhile(ghost, m_window.session(), &Result::isCompared);
    view->addSeparator();
    addChoices<Theme>(
        view, {{Theme::System, tr("&System colours")}, {Theme::Light, tr("&Light")}, {Theme::Dark, tr("&Dark")}},
        chosenTheme(), [this](Theme theme) { m_window.setTheme(theme); });
    addChoices<Language>( // each by its own name, for who does not read the other
        view->addMenu(tr("Lan&guage")),
        {{Language::System, tr("&System")},
         {Language::English, QStringLiteral("&English")},
         {Language::Spanish, QStringLiteral("Es&pañol")}},
        chosenLanguage(), [](Language language) {
            rememberLanguage(language);
            slidercrank::setLanguage(language);
        });
}

void Menus::addPlayback()
{
    QMenu *playback = addMenu(tr("&Playback"));
    m_rooms.timeline->fillMenu(playback);
}

void Menus::addHelp()
{
    QMenu *help = addMenu(tr("&Help"));
    help->addAction(tr("&Theory and help"), QKeySequence::HelpContents, this,
                    [this] { (new HelpPage(tr("Theory and help"), formulasText(), &m_window))->show(); });
    help->addAction(tr("&Keyboard and mouse"), QKeySequence(Qt::CTRL | Qt::Key_F1), this,
                    [this] { (new HelpPage(tr("Keyboard and mouse"), shortcutsText(*this), &m_window))->show(); });
    help->addSeparator();
    help->addAction(tr("&About"), this, &Menus::showAbout);
}

/// From a closed menu's title the Tab key leads on from where the focus was, as one Escape would.
void Menus::keyPressEvent(QKeyEvent *event)
{
    if (event->key() != Qt::Key_Tab && event->key() != Qt::Key_Backtab) {
        QMenuBar::keyPressEvent(event);
        return;
    }
    QKeyEvent leave(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QMenuBar::keyPressEvent(&leave);
    if (QWidget *focus = m_window.focusWidget(); focus && focus != this) {
        QCoreApplication::sendEvent(focus, event);
    }
}

void Menus::showAbout()
{
    auto *about = new QMessageBox(
        QMessageBox::NoIcon, tr("About"),
        tr("<h3>slidercrank %1</h3><p>The motion of an offset slider-crank: computed, shown, and compared "
           "with a simulation.</p><p>Formulation after A. A. Shabana, <i>Computational Dynamics</i>.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, &m_window);
    about->setObjectName(QStringLiteral("aboutBox"));
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->setIconPixmap(m_window.windowIcon().pixmap(64));
    about->open(); // does not wait: what plays goes on
}

} // namespace slidercrank
