// SPDX-License-Identifier: GPL-3.0-or-later

// The program as a web page: the window alone. main() returns at once, and the browser goes on to call Qt's event loop.
// The differences between a page and a desktop program are here, in ui/widgets/page_dialogs.cpp, and in
// ui/document/background_task.cpp, which needs no threads.

#include "ui/document/scene_link.h"
#include "ui/document/whole_file.h"
#include "ui/text/language.h"
#include "ui/window/main_window.h"
#include "ui/window/window_settings.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QIcon>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSplitter>
#include <QTextEdit>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include <chrono>
#include <cstdlib>
#include <emscripten.h>
#include <emscripten/html5.h>

using namespace slidercrank;

namespace
{

// clang-format off
EM_JS(char *, addressOfPage, (), {
    return stringToNewUTF8(location.href);
});

/// Lets the browser save a file of the page's memory.
EM_JS(void, handOver, (const char *path, const char *name), {
    const link = document.createElement("a");
    link.download = UTF8ToString(name);
    link.href = URL.createObjectURL(new Blob([FS.readFile(UTF8ToString(path))]));
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000); // ms, in which the browser reads the file
});
// clang-format on

/// Copies dropped files, because Qt removes them as soon as the event has been handled.
QStringList copiesOf(const QList<QUrl> &urls)
{
    QStringList copies;
    for (const QUrl &url : urls) {
        const QString path = url.toLocalFile();
        const QString copy = QDir::home().filePath(QFileInfo(path).fileName());
        QFile::remove(copy);
        if (QFile::copy(path, copy)) {
            copies += copy;
        }
    }
    return copies;
}

/// Replaces the functions that the window does not have in a page.
class BrowserPage : public QObject
{
public:
    explicit BrowserPage(MainWindow *window)
        : QObject(window)
        , m_window(window)
    {
        qApp->installEventFilter(this);
        connect(&window->session(), &Session::fileWritten, this,
                [](const QString &path) { handOver(path.toUtf8(), QFileInfo(path).fileName().toUtf8()); });
        hideDesktopActions();
    }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        switch (event->type()) {
        case QEvent::ContextMenu: // Qt's own context menus wait in an event loop, which never ends in a page
            return qobject_cast<QAbstractSpinBox *>(watched) || qobject_cast<QScrollBar *>(watched) ||
                   openMenuOfActions(qobject_cast<QWidget *>(watched),
                                     static_cast<const QContextMenuEvent *>(event)->globalPos());
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            forgetSelection(watched, *static_cast<const QMouseEvent *>(event));
            return openMenuOf(qobject_cast<QToolButton *>(watched));
        case QEvent::KeyPress:
            return static_cast<const QKeyEvent *>(event)->key() == Qt::Key_Space &&
                   openMenuOf(qobject_cast<QToolButton *>(watched));
        case QEvent::DragEnter: // a browser tells what is dragged only when it is dropped
            if (watched == m_window) {
                static_cast<QDropEvent *>(event)->acceptProposedAction();
            }
            return watched == m_window;
        case QEvent::Drop: return watched == m_window && drop(*static_cast<QDropEvent *>(event));
        case QEvent::Resize:
            if (watched == m_window) {
                fitWidth();
            }
            return false;
        default: return false;
        }
    }

private:
    /// Opens the menu of a button where the button itself would open it, but without waiting.
    static bool openMenuOf(QToolButton *button)
    {
        if (!button || !button->menu() || !button->isEnabled() || button->popupMode() != QToolButton::InstantPopup) {
            return false;
        }
        button->menu()->popup(button->mapToGlobal(QPoint(0, button->height())));
        return true;
    }

    /// Opens the context menu with the actions of a widget, also without waiting.
    static bool openMenuOfActions(QWidget *widget, QPoint position)
    {
        if (!widget || widget->contextMenuPolicy() != Qt::ActionsContextMenu || widget->actions().isEmpty()) {
            return false;
        }
        auto *menu = new QMenu(widget);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addActions(widget->actions());
        menu->popup(position);
        return true;
    }

    /// Removes the selection, because Qt would wait in an event loop if the selection were dragged.
    static void forgetSelection(QObject *watched, const QMouseEvent &press)
    {
        if (press.modifiers() & Qt::ShiftModifier) { // extends the selection
            return;
        }
        if (auto *label = qobject_cast<QLabel *>(watched); label && label->hasSelectedText()) {
            label->setSelection(0, 0);
        }
        if (auto *text = qobject_cast<QTextEdit *>(watched->parent())) {
            QTextCursor cursor = text->textCursor();
            cursor.clearSelection();
            text->setTextCursor(cursor);
        }
    }

    bool drop(QDropEvent &event)
    {
        event.acceptProposedAction();
        if (const QStringList files = copiesOf(event.mimeData()->urls()); !files.isEmpty()) {
            m_window->openFiles(files);
        }
        return true;
    }

    /// Puts the plots below the mechanism where the page is narrow.
    void fitWidth()
    {
        constexpr int kNarrow = 760; // px
        // The heights or widths of both parts, which the splitter scales to the space that there is.
        const QList<int> equalHeights{500, 500};
        const QList<int> widerPlots{560, 840};
        const bool isNarrow = m_window->width() < kNarrow;
        auto *columns = m_window->findChild<QSplitter *>("columns");
        const Qt::Orientation orientation = isNarrow ? Qt::Vertical : Qt::Horizontal;
        if (columns && columns->orientation() != orientation) {
            columns->setOrientation(orientation);
            columns->setSizes(isNarrow ? equalHeights : widerPlots);
        }
    }

    /// Hides the actions that need folders, ffmpeg or a program that can end, and frees Ctrl+W, with which the browser
    /// closes the page.
    void hideDesktopActions()
    {
        m_window->findChild<QMenu *>("recentMenu")->menuAction()->setVisible(false);
        for (const char *name : {"exportAnimation", "quit"}) {
            auto *action = m_window->findChild<QAction *>(name);
            action->setVisible(false);
            action->setShortcuts(QList<QKeySequence>());
        }
        m_window->findChild<QAction *>("closeReference")->setShortcuts(QList<QKeySequence>());
    }

    MainWindow *m_window;
};

/// Stores the layout when the page is hidden, because nothing tells the page that it is left.
bool storeLayout(int, const EmscriptenVisibilityChangeEvent *change, void *window)
{
    if (change->hidden) {
        saveLayout(*static_cast<const MainWindow *>(window));
    }
    return false;
}

/// Shows the window in the whole page, and replaces it whenever another language is chosen in it.
void fillPage(MainWindow *window)
{
    new BrowserPage(window);
    window->setWindowFlag(Qt::FramelessWindowHint);
    window->showMaximized();
    // Otherwise the first picture would show an unfinished layout for a moment: the legend of the plots was cut off.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    emscripten_set_visibilitychange_callback(window, false, storeLayout);
    const auto remake = [window] {
        fillPage(window->makeReplacement().release());
        window->deleteLater();
    };
    // Queued, because the menu in which the language was chosen belongs to the window that `remake` deletes.
    QObject::connect(window, &MainWindow::languageChosen, qApp, remake, Qt::QueuedConnection);
}

} // namespace

int main(int argc, char *argv[])
{
    static int count = argc; // QApplication refers to it after main() has returned
    new QApplication(count, argv);
    QCoreApplication::setOrganizationName("slidercrank"); // names the settings
    QCoreApplication::setApplicationName("slidercrank");
    QCoreApplication::setApplicationVersion(SLIDERCRANK_VERSION);
    setLanguage(chosenLanguage());
    QApplication::setStyle("Fusion");
    QDir::setCurrent(QDir::homePath());
    setUnnamedFolder(QDir::homePath());

    char *const text = addressOfPage();
    const QString address = QString::fromUtf8(text);
    std::free(text);
    if (!address.startsWith("file:")) { // a link to a file on this computer is of no use to other people
        setPageAddress(address.section(u'#', 0, 0));
    }
    auto *window = new MainWindow;
    fillPage(window);
    // Title bars of dialogs show the icon. It is drawn after the window has been painted.
    constexpr std::chrono::seconds kAfterStart(2);
    QTimer::singleShot(kAfterStart, qApp, [] { QApplication::setWindowIcon(QIcon(":/slidercrank.svg")); });
    if (isSceneLink(address)) {
        window->openFiles({address});
    }
    return 0;
}
