// SPDX-License-Identifier: GPL-3.0-or-later

// Sends seeded random events to the window: mouse, keys, drops, menus, dialogs, sizes, screens, themes and languages.
// It also opens correct and wrong files, and cancels tasks. The window must not crash, hang or reach an invalid state.
// The test is most useful with the sanitizers. SLIDERCRANK_MONKEY_EVENTS sets the number of events, and
// SLIDERCRANK_MONKEY_SEED the seed.

#include "ui/document/session.h"
#include "ui/window/main_window.h"
#include "ui/window/status_bar.h"

#include "tests/support/long_tests.h"
#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QSettings>
#include <QStandardPaths>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

using namespace slidercrank;

namespace
{

constexpr int kEvents = 1500;
constexpr int kManyEvents = 100'000;
constexpr int kSeed = 1;

const char *const kTexts[] = {"60", "0",   "-25", "1e-9",   "1e300", "1e999", "nan", "12,5",         "90°",
                              "",   "abc", "1/3", "20 rpm", "65 in", ".5",    "1e",  "\u0663\u0662", "999999999999",
                              "∞"};

constexpr int kKeys[] = {Qt::Key_Tab, Qt::Key_Space, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Left, Qt::Key_Right,
                         Qt::Key_Up,  Qt::Key_Down,  Qt::Key_Home,   Qt::Key_PageUp, Qt::Key_Plus, Qt::Key_A,
                         Qt::Key_7,   Qt::Key_Z,     Qt::Key_Y,      Qt::Key_F9,     Qt::Key_Menu, Qt::Key_F11,
                         Qt::Key_K,   Qt::Key_R,     Qt::Key_Delete};

constexpr Qt::KeyboardModifiers kModifiers[] = {Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,
                                                Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};

class Monkey
{
public:
    Monkey(unsigned seed, const QString &folder)
        : m_random(seed)
        , m_folder(folder)
    {
        writeFiles();
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1024, 700);
        m_window->show();
        // The timer answers open dialogs, also while one runs its own event loop. The answer is queued, because an
        // answer that opens another dialog would otherwise block the timer.
        QObject::connect(&m_answerTimer, &QTimer::timeout, &m_answerTimer, [this] {
            QMetaObject::invokeMethod(
                &m_answerTimer, [this] { answer(); }, Qt::QueuedConnection);
        });
        m_answerTimer.start(5);
    }

    MainWindow &window() { return *m_window; }
    const QString &lastAction() const { return m_lastAction; }

    void act()
    {
        struct Action {
            const char *name;
            int weight;
            void (Monkey::*act)();
        };
        static constexpr Action kActions[] = {
            {"a slider", 20, &Monkey::moveSlider}, {"text", 12, &Monkey::type},
            {"the mouse", 34, &Monkey::useMouse},  {"the wheel", 8, &Monkey::turnWheel},
            {"a key", 16, &Monkey::press},         {"a tab", 4, &Monkey::switchTab},
            {"a menu", 8, &Monkey::trigger},       {"a context menu", 2, &Monkey::openContextMenu},
            {"a file", 5, &Monkey::drop},          {"cancel", 3, &Monkey::cancel},
            {"the size", 4, &Monkey::resize},      {"a moment", 3, &Monkey::wait}};
        int choice = randomBelow(119); // the sum of the weights
        const Action *action = std::begin(kActions);
        for (; choice >= action->weight; ++action) {
            choice -= action->weight;
        }
        m_lastAction = QLatin1String(action->name);
        (this->*action->act)();
        QCoreApplication::processEvents();
    }

private:
    /// Returns a random number from 0 to end − 1.
    int randomBelow(int end) { return static_cast<int>(m_random() % static_cast<unsigned>(std::max(1, end))); }
    template <class Container>
    auto randomElement(const Container &elements)
    {
        return elements[static_cast<std::size_t>(randomBelow(static_cast<int>(std::size(elements))))];
    }

    QString path(const QString &name) const { return QDir(m_folder).filePath(name); }

    void writeFiles()
    {
        QByteArray noise;
        for (int i = 0; i < 4000; ++i) {
            noise += static_cast<char>(randomBelow(256));
        }
        QByteArray large = "time,theta3,R4_x\n";
        for (int i = 0; i < 100'000; ++i) {
            large += QByteArray::number(i * 1e-5, 'f', 5) + ',' + QByteArray::number(randomBelow(40)) + ",80.5\n";
        }
        QFile sample(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"));
        QVERIFY(sample.open(QIODevice::ReadOnly));
        const std::pair<const char *, QByteArray> files[] = {
            {"noise.csv", noise},
            {"empty.csv", {}},
            {"unclear.csv", "Time (s),Linear Displacement1 (mm),velocidad\n0,1,2\n1,2,3\n2,1,0\n3,5,1\n"},
            {"none.json", "{\"version\": 1, \"parameters\": {\"a\": -1}}"},
            {"broken.json", "{\"ver"},
            {"large.csv", large},
            {"half written.csv", large},
            {"sample.csv", sample.readAll()}}; // a copy, because exported files are proposed in its folder
        for (const auto &[name, bytes] : files) {
            QFile file(path(QLatin1String(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
            m_files << file.fileName();
        }
        QFile::resize(path("half written.csv"), qint64{1} << 32); // a sparse file, which takes no space on most disks
        m_files << path("not there.csv") << path("saved.json") << m_folder;
    }

    /// Returns a random visible and enabled widget of the window or of the modal dialog, or null if there is none.
    template <class Kind>
    Kind *randomWidget()
    {
        QWidget *top = QApplication::activeModalWidget() ? QApplication::activeModalWidget() : m_window.get();
        QList<Kind *> widgets = top->findChildren<Kind *>();
        erase_if(widgets, [](const Kind *widget) { return !widget->isVisible() || !widget->isEnabled(); });
        return widgets.isEmpty() ? nullptr : widgets[randomBelow(static_cast<int>(widgets.size()))];
    }

    QPoint randomPointIn(const QWidget &widget) { return {randomBelow(widget.width()), randomBelow(widget.height())}; }

    void moveSlider()
    {
        if (auto *slider = randomWidget<QAbstractSlider>()) {
            slider->setValue(slider->minimum() + randomBelow(slider->maximum() - slider->minimum() + 1));
        }
    }

    void type()
    {
        const QPointer<QLineEdit> line = randomWidget<QLineEdit>();
        if (!line) {
            return;
        }
        line->setFocus();
        line->selectAll();
        for (const QChar letter : QString::fromUtf8(randomElement(kTexts))) {
            QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, letter);
            if (line) {
                QCoreApplication::sendEvent(line, &event);
            }
        }
        if (line) {
            QTest::sendKeyEvent(QTest::Click, line, randomBelow(4) == 0 ? Qt::Key_Escape : Qt::Key_Return, QString(),
                                {});
        }
    }

    /// Clicks, double-clicks or drags.
    void useMouse()
    {
        const QPointer<QWidget> widget = randomWidget<QWidget>();
        const Qt::KeyboardModifiers modifiers = randomElement(kModifiers);
        const Qt::MouseButton button = randomBelow(5) == 0 ? Qt::MiddleButton : Qt::LeftButton;
        QPoint at = widget ? randomPointIn(*widget) : QPoint();
        const auto send = [&](QEvent::Type type, Qt::MouseButtons buttons) {
            if (widget) {
                QMouseEvent event(type, at, widget->mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                                  buttons, modifiers);
                QCoreApplication::sendEvent(widget, &event);
            }
        };
        send(QEvent::MouseMove, Qt::NoButton);
        send(randomBelow(9) == 0 ? QEvent::MouseButtonDblClick : QEvent::MouseButtonPress, button);
        for (int i = randomBelow(2) * randomBelow(7); i > 0 && widget; --i) {
            at = randomPointIn(*widget) * 2 - QPoint(20, 20);
            send(QEvent::MouseMove, button);
            if (randomBelow(3) == 0) {
                QCoreApplication::processEvents();
            }
        }
        send(QEvent::MouseButtonRelease, Qt::NoButton);
    }

    void turnWheel()
    {
        if (auto *widget = randomWidget<QWidget>()) {
            const QPoint at = randomPointIn(*widget);
            QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * (randomBelow(9) - 4)}, Qt::NoButton,
                              randomElement(kModifiers), Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(widget, &event);
        }
    }

    void press()
    {
        QWidget *target =
            QApplication::activePopupWidget() ? QApplication::activePopupWidget() : QApplication::focusWidget();
        if (!target) {
            target = m_window.get();
        }
        QTest::sendKeyEvent(QTest::Click, target, static_cast<Qt::Key>(randomElement(kKeys)), QString(),
                            randomElement(kModifiers));
    }

    void switchTab()
    {
        if (auto *bar = randomWidget<QTabBar>(); bar && bar->count() > 0) {
            bar->setCurrentIndex(randomBelow(bar->count()));
        }
    }

    void trigger()
    {
        QList<QAction *> actions;
        for (const QMenu *menu : m_window->menuBar()->findChildren<QMenu *>()) {
            actions += menu->actions();
        }
        erase_if(actions, [](const QAction *action) { return action->menu() || !action->isEnabled(); });
        QAction *action = actions[randomBelow(static_cast<int>(actions.size()))];
        m_lastAction += QStringLiteral(" \"%1\"").arg(action->text());
        action->trigger();
    }

    void openContextMenu()
    {
        if (auto *widget = randomWidget<QWidget>()) {
            const QPoint at = randomPointIn(*widget);
            QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget->mapToGlobal(at));
            QCoreApplication::sendEvent(widget, &event);
        }
    }

    void cancel() { emit m_window->findChild<StatusBar *>()->cancelled(); }

    void drop()
    {
        QMimeData data;
        const QString file = m_files[randomBelow(static_cast<int>(m_files.size()))];
        m_lastAction += QLatin1Char(' ') + file;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDropEvent event(m_window->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
    }

    /// Resizes the window, and sometimes moves it to another screen or partly beyond an edge.
    void resize()
    {
        m_window->resize(500 + randomBelow(1200), 400 + randomBelow(800));
        if (randomBelow(4) == 0) {
            m_window->move(randomBelow(3000) - 100, randomBelow(900) - 50);
        }
    }

    /// Lets the time of a random active timer elapse.
    void wait()
    {
        QList<QTimer *> timers = m_window->findChildren<QTimer *>();
        erase_if(timers, [](const QTimer *timer) { return !timer->isActive(); });
        if (!timers.isEmpty()) {
            letTimePass(*timers[randomBelow(static_cast<int>(timers.size()))]->parent());
        }
        settle();
    }

    void answer()
    {
        if (QWidget *popup = QApplication::activePopupWidget()) {
            if (randomBelow(3) == 0) {
                popup->close();
            } else {
                QTest::sendKeyEvent(QTest::Click, popup, randomBelow(2) == 0 ? Qt::Key_Down : Qt::Key_Return, QString(),
                                    {});
            }
            return;
        }
        QWidget *modal = QApplication::activeModalWidget();
        if (auto *files = qobject_cast<QFileDialog *>(modal)) {
            static constexpr const char *kNames[] = {"saved.json",   "x.png",     "x.svg",
                                                     "x.pdf",        "x.csv",     "x.gif",
                                                     "frames/x.png", "x.unknown", "no/such/folder.png"};
            const bool isSaved = files->acceptMode() == QFileDialog::AcceptSave;
            files->selectFile(isSaved ? path(QLatin1String(randomElement(kNames)))
                                      : m_files[randomBelow(static_cast<int>(m_files.size()))]);
            QDialog &dialog = *files; // declares these functions as public
            randomBelow(2) == 0 ? dialog.reject() : dialog.accept();
        } else if (auto *box = qobject_cast<QMessageBox *>(modal)) {
            const QList<QAbstractButton *> buttons = box->buttons();
            buttons[randomBelow(static_cast<int>(buttons.size()))]->click();
        } else if (modal && randomBelow(4) == 0) {
            modal->close();
        }
    }

    std::mt19937 m_random;
    QString m_folder;
    QStringList m_files;
    QTimer m_answerTimer;
    QString m_lastAction;
    std::unique_ptr<MainWindow> m_window;
};

int numberFrom(const char *variable, int otherwise)
{
    bool isNumber = false;
    const int value = qEnvironmentVariableIntValue(variable, &isNumber);
    return isNumber ? value : otherwise;
}

} // namespace

class TestMonkey : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("HOME",
                m_folder.path()
                    .toLocal8Bit()); // so that files that are saved under their proposed names are in this folder
        QVERIFY(QDir::setCurrent(m_folder.path()));
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.filePath("settings"));
        QApplication::setStyle("Fusion");
        QApplication::setQuitOnLastWindowClosed(false);
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    }

    void survivesRandomEvents()
    {
        const int events = numberFrom("SLIDERCRANK_MONKEY_EVENTS", caseCount(kEvents, kManyEvents));
        const int seed = numberFrom("SLIDERCRANK_MONKEY_SEED", kSeed);
        qInfo("%d events of seed %d", events, seed);
        Monkey monkey(static_cast<unsigned>(seed), m_folder.path());
        for (int i = 0; i < events; ++i) {
            monkey.act();
            const QString where = QStringLiteral("event %1 of seed %2: %3").arg(i).arg(seed).arg(monkey.lastAction());
            const Session &session = monkey.window().session();
            QVERIFY2(!findFault(session.parameters()), qPrintable(where));
            QVERIFY2(session.result(), qPrintable(where));
            QVERIFY2(std::isfinite(session.time()), qPrintable(where));
            if (!monkey.window().isVisible()) {
                monkey.window().show(); // an event has closed it
            }
        }
    }

private:
    QTemporaryDir m_folder;
};

/// Configures two screens of different resolution side by side if the platform is offscreen.
void configureTwoScreens(const QString &file)
{
    QFile screens(file);
    if (qgetenv("QT_QPA_PLATFORM") == "offscreen" && screens.open(QIODevice::WriteOnly)) {
        screens.write(R"({"synchronousWindowSystemEvents": false, "windowFrameMargins": false, "screens": [
            {"name": "coarse", "x": 0, "y": 0, "width": 1500, "height": 1000, "logicalDpi": 96, "logicalBaseDpi": 96,
             "dpr": 1},
            {"name": "fine", "x": 1500, "y": 0, "width": 1500, "height": 1000, "logicalDpi": 96, "logicalBaseDpi": 96,
             "dpr": 1.5}]})");
        qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + QFile::encodeName(file));
    }
}

int main(int argc, char *argv[])
{
    const QTemporaryDir folder;
    configureTwoScreens(folder.filePath("screens.json"));
    const QApplication application(argc, argv);
    TestMonkey test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_monkey.moc"
