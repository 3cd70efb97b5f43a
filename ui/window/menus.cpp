// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/menus.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/exports.h"
#include "ui/window/ghost.h"
#include "ui/window/main_window.h"
#include "ui/window/presentation.h"
#include "ui/window/scene_file.h"
#include "ui/window/window_settings.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDialog>
#include <QDir>
#include <QMessageBox>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include <functional>
#include <vector>

namespace slidercrank
{

namespace
{

/// Adds an action that can be checked, and is not checked at first.
QAction *addSwitch(QMenu *menu, const QString &text, const QKeySequence &key = {})
{
    QAction *action = menu->addAction(text);
    action->setCheckable(true);
    action->setShortcut(key);
    return action;
}

/// A value of an enumeration as an entry of a menu.
template <typename Value>
struct Choice {
    Value value;
    QString text;
};

/// Adds an action for each choice to the menu. Each action stores its value as a number; only the action of the value
/// `chosen` is checked.
template <typename Value>
QActionGroup *addChoices(QMenu *menu, const std::vector<Choice<Value>> &choices, Value chosen,
                         const std::function<void(Value)> &choose)
{
    auto *group = new QActionGroup(menu);
    for (const auto &[value, text] : choices) {
        QAction *action = group->addAction(addSwitch(menu, text));
        action->setChecked(value == chosen);
        action->setData(static_cast<int>(value));
        QObject::connect(action, &QAction::triggered, menu, [choose, choice = value] { choose(choice); });
    }
    return group;
}

/// Enables the action while the current result satisfies the condition.
void enableWhile(QAction *action, const Session &session, const std::function<bool(const Result &)> &condition)
{
    const auto update = [action, condition](const std::shared_ptr<const Result> &result) {
        action->setEnabled(condition(*result));
    };
    update(session.result());
    QObject::connect(&session, &Session::resultChanged, action, update);
}

/// Opens the help at the section with that anchor, in a separate window that Escape closes.
void showHelp(const QString &title, const QString &anchor, QWidget *window)
{
    auto *dialog = new QDialog(window);
    dialog->setObjectName("help");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto *text = new QTextBrowser;
    text->setAccessibleName(title);
    text->setSource(QUrl(Menus::tr("qrc:/help/english.html", "a resource of the program") + u'#' + anchor));
    auto *rows = new QVBoxLayout(dialog);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(text);
    constexpr int kSide = 90; // characters
    const int side = kSide * dialog->fontMetrics().averageCharWidth();
    dialog->resize(side, side);
    dialog->show();
}

} // namespace

Menus::Menus(MainWindow &window, const Views &views)
    : QMenuBar(&window)
    , m_window(window)
    , m_views(views)
{
    addFileMenu();
    addEditMenu();
    addViewMenu();
    views.timeline->fillMenu(addMenu(tr("&Playback")));
    addHelpMenu();
}

void Menus::addFileMenu()
{
    Session *session = &m_window.session();
    SceneFile *scene = &m_window.scene();
    QMenu *menu = addMenu(tr("&File"));
    menu->addAction(tr("&Open…"), QKeySequence::Open, &m_window, &MainWindow::chooseFiles);
    QMenu *recent = menu->addMenu(tr("Open &recent"));
    recent->setObjectName("recentMenu");
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { fillRecent(recent); });
    menu->addAction(tr("Open the samp&le"), &m_window, &MainWindow::openSample);
    QAction *close = menu->addAction(tr("&Close reference"), Qt::CTRL | Qt::Key_W, session,
                                     [session] { session->setReference(nullptr); });
    close->setObjectName("closeReference");
    enableWhile(close, *session, [](const Result &result) { return result.choices.reference != nullptr; });
    menu->addSeparator();
    menu->addAction(tr("&Save scene"), QKeySequence::Save, scene, [scene] { scene->save(); });
    menu->addAction(tr("Save scene &as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S, scene, [scene] { scene->saveAs(); });
    menu->addAction(tr("Copy lin&k"), scene, &SceneFile::copyLink);
    menu->addSeparator();
    addExportMenu(menu->addMenu(tr("E&xport")));
    menu->addSeparator();
    menu->addAction(tr("&Quit"), QKeySequence::Quit, &m_window, &QWidget::close)->setObjectName("quit");
}

void Menus::addExportMenu(QMenu *menu)
{
    Exports *exports = &m_window.exports();
    menu->addAction(tr("&Figure…"), Qt::CTRL | Qt::Key_E, exports, [exports] { exports->choose(exports->plot()); });
    menu->addAction(tr("&Mechanism…"), exports, [exports] { exports->choose(exports->mechanism()); });
    menu->addAction(tr("&Polygons…"), exports, [exports] { exports->choose(exports->polygons()); });
    menu->addAction(tr("&Data…"), exports, &Exports::chooseData);
    menu->addAction(tr("&Report…"), exports, &Exports::chooseReport);
    menu->addAction(tr("&Animation…"), exports, &Exports::chooseAnimation)->setObjectName("exportAnimation");
}

void Menus::fillRecent(QMenu *menu)
{
    menu->clear();
    for (const QStringList &paths : recentFiles()) {
        const QString first = QDir::toNativeSeparators(paths.first());
        menu->addAction(paths.size() == 1 ? first : tr("%1 + %2 more").arg(first, QString::number(paths.size() - 1)),
                        &m_window, [this, paths] { m_window.openFiles(paths); });
    }
    if (menu->isEmpty()) {
        menu->addAction(tr("No file yet"))->setEnabled(false);
    }
}

void Menus::addEditMenu()
{
    Session *session = &m_window.session();
    Exports *exports = &m_window.exports();
    QMenu *menu = addMenu(tr("&Edit"));
    QAction *undo = session->undoStack().createUndoAction(menu, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction *redo = session->undoStack().createRedoAction(menu, tr("&Redo"));
    redo->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
    menu->addActions({undo, redo});
    menu->addSeparator();
    menu->addAction(tr("&Copy figure"), QKeySequence::Copy, exports, [exports] { exports->copy(exports->plot()); });
    menu->addAction(tr("Copy &mechanism"), exports, [exports] { exports->copy(exports->mechanism()); });
    menu->addSeparator();
    menu->addAction(tr("P&in this motion"), Qt::CTRL | Qt::Key_K, session, &Session::pinMotion);
    QAction *unpin = menu->addAction(tr("Remo&ve pinned motions"), Qt::CTRL | Qt::SHIFT | Qt::Key_K, session,
                                     &Session::unpinMotions);
    enableWhile(unpin, *session, [](const Result &result) { return !result.pinned.empty(); });
    menu->addAction(tr("Rese&t all parameters"), session, [session] { session->setParameters(Parameters()); });
}

void Menus::addViewMenu()
{
    FoldingTabs *tabs = m_views.tabs;
    Presentation *presentation = &m_window.presentation();
    QMenu *menu = addMenu(tr("&View"));
    menu->addAction(tr("&Reset plot zoom"), Qt::CTRL | Qt::Key_0, m_views.plots, &PlotGrid::showAll);
    menu->addMenu(tr("M&echanism"))->addActions(m_views.mechanism->choices());
    menu->addMenu(tr("Pl&ots"))->addActions(m_views.plots->choices());
    addNotationMenu(menu->addMenu(tr("&Notation and units")));
    QAction *presentationSwitch = addSwitch(menu, tr("Presentation &mode"), Qt::Key_F11);
    connect(presentationSwitch, &QAction::triggered, presentation, &Presentation::setOn);
    connect(presentation, &Presentation::changed, presentationSwitch, &QAction::setChecked);
    QAction *panelsSwitch = addSwitch(menu, tr("Show the &panels below"), Qt::Key_F9);
    panelsSwitch->setChecked(!tabs->isFolded());
    connect(panelsSwitch, &QAction::triggered, tabs, [tabs](bool shown) { tabs->setFolded(!shown); });
    connect(tabs, &FoldingTabs::foldedChanged, panelsSwitch,
            [panelsSwitch](bool folded) { panelsSwitch->setChecked(!folded); });
    QAction *ghostSwitch = addSwitch(menu, tr("Show the mo&tion of the file or the pinned one"));
    ghostSwitch->setChecked(true);
    connect(ghostSwitch, &QAction::triggered, m_views.ghost, &Ghost::setShown);
    enableWhile(ghostSwitch, m_window.session(), &Result::isCompared);
    menu->addSeparator();
    addChoices<Theme>(
        menu, {{Theme::System, tr("&System colours")}, {Theme::Light, tr("&Light")}, {Theme::Dark, tr("&Dark")}},
        chosenTheme(), [this](Theme theme) { m_window.setTheme(theme); });
    const auto setLanguage = [this](Language language) {
        storeLanguage(language);
        if (m_window.exports().isWriting() || m_window.session().isReading()) { // a new window would not finish it
            emit m_window.session().failed(tr("A file is still being read or written. Choose the language again when "
                                              "it is done; otherwise it changes when the program is next started."));
            return;
        }
        emit m_window.languageChosen();
    };
    addChoices<Language>(
        menu->addMenu(tr("Lan&guage")),
        {{Language::System, tr("&System")}, {Language::English, "&English"}, {Language::Spanish, "Es&pañol"}},
        chosenLanguage(), setLanguage);
}

void Menus::addNotationMenu(QMenu *menu)
{
    const auto addGroup = [this, menu]<typename Value>(const std::vector<Choice<Value>> &choices,
                                                       const std::function<Value &(Notation &)> &member) {
        Notation shownNotation = notation();
        const QActionGroup *group =
            addChoices<Value>(menu, choices, member(shownNotation), [this, member](Value value) {
                Notation changed = notation();
                member(changed) = value;
                m_window.setNotation(changed);
            });
        connect(menu, &QMenu::aboutToShow, group, [group, member] { // the notation may have been chosen elsewhere
            Notation chosen = notation();
            for (QAction *action : group->actions()) {
                if (action->data() == static_cast<int>(member(chosen))) {
                    action->setChecked(true);
                }
            }
        });
    };
    addGroup.operator()<Symbols>({{Symbols::AbsoluteCoordinates, tr("&Absolute coordinates (θ³ measured at A)")},
                                  {Symbols::Textbook, tr("&Textbook (θ₃ measured at B)")}},
                                 [](Notation &shown) -> Symbols & { return shown.symbols; });
    menu->addSeparator();
    addGroup.operator()<AngleUnit>({{AngleUnit::Degree, tr("&Degrees")},
                                    {AngleUnit::Radian, tr("&Radians")},
                                    {AngleUnit::DegreeAndRadianPerSecond, tr("Degrees, with rad/&s and rad/s²")}},
                                   [](Notation &shown) -> AngleUnit & { return shown.units.angle; });
    menu->addSeparator();
    addGroup.operator()<LengthUnit>({{LengthUnit::Millimetre, tr("&mm")},
                                     {LengthUnit::Centimetre, tr("&cm")},
                                     {LengthUnit::Metre, tr("m")},
                                     {LengthUnit::Inch, tr("&in")}},
                                    [](Notation &shown) -> LengthUnit & { return shown.units.length; });
}

void Menus::addHelpMenu()
{
    QMenu *menu = addMenu(tr("&Help"));
    menu->addAction(tr("&Theory and help"), QKeySequence::HelpContents, this,
                    [this] { showHelp(tr("Theory and help"), "theory", &m_window); });
    menu->addAction(tr("&Keyboard and mouse"), Qt::CTRL | Qt::Key_F1, this,
                    [this] { showHelp(tr("Keyboard and mouse"), "keys", &m_window); });
    menu->addSeparator();
    menu->addAction(tr("&About"), this, &Menus::showAbout);
}

void Menus::showAbout()
{
    auto *about = new QMessageBox(
        QMessageBox::NoIcon, tr("About"),
        tr("<h3>slidercrank %1</h3><p>The motion of an offset slider-crank: computed, shown, and compared "
           "with a simulation.</p><p>Formulation after A. A. Shabana, <i>Computational Dynamics</i>.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Ok, &m_window);
    about->setAttribute(Qt::WA_DeleteOnClose);
    about->open();
}

} // namespace slidercrank

#include "moc_menus.cpp"
