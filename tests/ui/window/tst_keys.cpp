// SPDX-License-Identifier: GPL-3.0-or-later

// Keys and wheel as a person uses them: pressed on the window, wherever the focus is.

#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/panels/timeline.h"
#include "ui/window/main_window.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QSlider>
#include <QStandardPaths>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

QString described(const QWidget *widget)
{
    return QStringLiteral("%1 \"%2\"").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
}

/// What Space could have changed.
QVariantList stateOf(const QWidget *widget)
{
    const auto *button = qobject_cast<const QAbstractButton *>(widget);
    const auto *list = qobject_cast<const QComboBox *>(widget);
    const auto *box = qobject_cast<const QAbstractSpinBox *>(widget);
    const auto *table = qobject_cast<const QAbstractItemView *>(widget);
    return {button ? button->isChecked() : false,
            button ? button->isDown() : false,
            list ? list->currentIndex() : -1,
            box ? box->text() : QString(),
            table ? table->currentIndex().row() : -1,
            QApplication::activePopupWidget() != nullptr,
            QApplication::activeModalWidget() != nullptr};
}

} // namespace

class TestKeys : public QObject
{
    Q_OBJECT

private:
    const QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;
    Timeline *m_timeline = nullptr;

    template <typename Widget>
    Widget *child(const QString &name) const
    {
        auto *widget = m_window->findChild<Widget *>(name);
        if (!widget) {
            qFatal("no widget named %s", qPrintable(name));
        }
        return widget;
    }

    /// As the window system delivers it: to the window, which finds the focus.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QWindow *window = QApplication::activePopupWidget() ? QApplication::activePopupWidget()->windowHandle()
                                                            : m_window->windowHandle();
        QTest::keyClick(window, key, modifiers);
    }

    void typeInto(const QString &box, const QString &text) const
    {
        child<QWidget>(box)->setFocus(Qt::TabFocusReason);
        for (const QChar letter : text) {
            QTest::keyClick(m_window->windowHandle(), letter.toLatin1());
        }
    }

    static void turnWheelOver(QWidget *widget)
    {
        const QPointF centre = widget->rect().center();
        QWheelEvent wheel(centre, widget->mapToGlobal(centre), QPoint(), QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &wheel);
    }

    /// Every place that the Tab key comes to.
    void atEveryStop(const std::function<void(QWidget *)> &look) const
    {
        QSet<QWidget *> seen;
        press(Qt::Key_Tab);
        for (QWidget *stop = QApplication::focusWidget(); stop && !seen.contains(stop);
             stop = QApplication::focusWidget()) {
            seen << stop;
            look(stop);
            stop->setFocus();
            press(Qt::Key_Tab);
            if (stop->hasFocus()) {
                press(Qt::Key_Tab); // from a label to its link, and on
            }
        }
        QVERIFY(seen.size() > 20);
    }

    QStringList m_faults;

    void pressSpaceAtEveryStop()
    {
        atEveryStop([this](QWidget *stop) {
            for (const bool before : {false, true}) {
                const QVariantList state = stateOf(stop);
                press(Qt::Key_Space);
                if (m_timeline->isPlaying() == before) {
                    m_faults << QStringLiteral("at %1 Space does not %2")
                                    .arg(described(stop), before ? QStringLiteral("pause") : QStringLiteral("play"));
                }
                if (stop != child<QWidget>(QStringLiteral("playButton")) && stateOf(stop) != state) {
                    m_faults << QStringLiteral("Space changes %1").arg(described(stop));
                }
                if (m_timeline->isPlaying() == before) {
                    m_timeline->togglePlaying();
                }
            }
        });
    }

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
        QLocale::setDefault(QLocale::c());
    }

    void init()
    {
        QSettings().clear();
        m_faults.clear();
        m_window = std::make_unique<MainWindow>();
        m_timeline = m_window->findChild<Timeline *>();
        m_timeline->setClock([] { return 0.0; });
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void spacePlaysFromTheFirstSecondOn()
    {
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
    }

    void spacePausesAfterAClickOnPlay()
    {
        auto *play = child<QAbstractButton>(QStringLiteral("playButton"));
        QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                          play->mapTo(m_window.get(), play->rect().center()));
        QVERIFY(m_timeline->isPlaying());
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
    }

    void spacePlaysWhateverHasTheFocus_data()
    {
        QTest::addColumn<QString>("reference");
        QTest::addColumn<int>("tab");
        QTest::addColumn<int>("page");
        const char *const tabs[] = {"limits", "errors", "reference", "newton", "study"};
        for (int tab = 0; tab < 5; ++tab) {
            for (const QString &file : {QString(), kSample}) {
                const QByteArray with = file.isEmpty() ? QByteArray() : QByteArray(", with a file");
                for (int page = 0; page < (tab == 3 ? 5 : 1); ++page) {
                    QTest::newRow(QByteArray(tabs[tab]) + ' ' + QByteArray::number(page) + with) << file << tab << page;
                }
            }
        }
    }

    void spacePlaysWhateverHasTheFocus()
    {
        QFETCH(const QString, reference);
        QFETCH(const int, tab);
        QFETCH(const int, page);
        if (!reference.isEmpty()) {
            m_window->openReference(reference);
            AWAIT(m_window->session().diagnosis());
        }
        child<QTabBar>(QStringLiteral("tabBar"))->setCurrentIndex(tab);
        if (page > 0) {
            child<QAbstractButton>(QStringLiteral("segment%1").arg(page))->click();
        }
        settle(*m_window);
        pressSpaceAtEveryStop();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void spaceIsPartOfWhatIsTyped()
    {
        typeInto(QStringLiteral("box_b"), QStringLiteral("25 mm"));
        QVERIFY(!m_timeline->isPlaying());
        QCOMPARE(child<QAbstractSpinBox>(QStringLiteral("box_b"))->text(), QStringLiteral("25 mm"));
        press(Qt::Key_Return);
        QCOMPARE(m_window->session().parameters().b, 25.0);
        press(Qt::Key_Space); // taken over: the box only has the focus
        QVERIFY(m_timeline->isPlaying());
    }

    void spacePlaysWhereATypedTextWasRefused()
    {
        typeInto(QStringLiteral("box_b"), QStringLiteral("20/3"));
        press(Qt::Key_Return);
        QVERIFY(child<QLabel>(QStringLiteral("refusalLabel"))->isVisible());
        QCOMPARE(child<QAbstractSpinBox>(QStringLiteral("box_b"))->text(), QStringLiteral("65 mm"));
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
    }

    /// Home set b to 1 mm after its slider had been dragged.
    void homeAndEndBelongToThePlaybackUnlessATextIsEdited()
    {
        Session &session = m_window->session();
        for (const char *name : {"slider_b", "timeSlider", "positionTable", "unit_theta20", "playButton"}) {
            child<QWidget>(QString::fromLatin1(name))->setFocus();
            press(Qt::Key_End);
            QCOMPARE(session.time(), 1.0);
            press(Qt::Key_Home);
            QCOMPARE(session.time(), 0.0);
            QCOMPARE(session.parameters(), Parameters());
        }
        session.setTime(0.5);
        typeInto(QStringLiteral("box_b"), QStringLiteral("7"));
        press(Qt::Key_Home);
        press(Qt::Key_6);
        QCOMPARE(child<QAbstractSpinBox>(QStringLiteral("box_b"))->text(), QStringLiteral("67 mm"));
        QCOMPARE(session.time(), 0.5);
    }

    void spaceBelongsToAnOpenList()
    {
        auto *list = child<QComboBox>(QStringLiteral("unit_theta20"));
        list->setFocus();
        press(Qt::Key_Return); // opens it
        AWAIT(QApplication::activePopupWidget());
        press(Qt::Key_Down);
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
        press(Qt::Key_Return);
        AWAIT(!QApplication::activePopupWidget());
        QCOMPARE(list->currentIndex(), 1);
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
    }

    void theRunsFormHasTheKeysOfTheWindow()
    {
        press(Qt::Key_R, Qt::ControlModifier);
        auto *start = child<QAbstractSpinBox>(QStringLiteral("startBox"));
        AWAIT(start->hasFocus());
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
        QCOMPARE(start->text(), QStringLiteral("0 s"));
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
        press(Qt::Key_3); // in place of what is there
        QCOMPARE(start->text(), QStringLiteral("3 s"));
        press(Qt::Key_Return);
        QCOMPARE(m_window->session().sampling().start, 3.0);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().sampling().start, 0.0);
        child<QWidget>(QStringLiteral("oneTurnButton"))->setFocus();
        press(Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(m_window->session().sampling().start, 3.0);
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
        press(Qt::Key_Escape);
        QVERIFY(!QApplication::activePopupWidget());
        press(Qt::Key_R, Qt::ControlModifier); // once more
        AWAIT(start->hasFocus());
        press(Qt::Key_4);
        QCOMPARE(start->text(), QStringLiteral("4 s"));
        press(Qt::Key_Escape);
        press(Qt::Key_Escape);
    }

    void aHeldSpaceIsPressedOnce_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"playButton", "loopButton", "mechanismView", "box_b"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void aHeldSpaceIsPressedOnce()
    {
        QFETCH(const QString, name);
        child<QWidget>(name)->setFocus();
        QWindow *window = m_window->windowHandle();
        const QVariantList state = stateOf(child<QWidget>(name));
        for (const bool repeated : {false, true, true}) {
            QTest::simulateEvent(window, true, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), repeated);
            QTest::simulateEvent(window, false, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), repeated);
            QVERIFY(m_timeline->isPlaying());
        }
        QCOMPARE(stateOf(child<QWidget>(name)), state);
    }

    void anIdleKeyOfABoxIsTheWindows()
    {
        auto *line = child<QAbstractSpinBox>(QStringLiteral("box_b"))->findChild<QLineEdit *>();
        typeInto(QStringLiteral("box_b"), QStringLiteral("7"));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(line->text(), QStringLiteral("65 mm"));
        press(Qt::Key_Y, Qt::ControlModifier); // the window has nothing to redo: nothing comes back
        QCOMPARE(line->text(), QStringLiteral("65 mm"));
        press(Qt::Key_End);
        press(Qt::Key_Space, Qt::ShiftModifier); // no number begins so
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
    }

    void keysThatAControlHasNoUseForAreTheTimelines()
    {
        m_window->session().setTime(0.5);
        child<QWidget>(QStringLiteral("tabBar"))->setFocus();
        press(Qt::Key_Right);
        QCOMPARE(child<QTabBar>(QStringLiteral("tabBar"))->currentIndex(), 1);
        QCOMPARE(m_window->session().time(), 0.5);
        press(Qt::Key_Home);
        QCOMPARE(m_window->session().time(), 0.0);
        auto *list = child<QComboBox>(QStringLiteral("unit_theta20"));
        list->setFocus();
        press(Qt::Key_Right);
        QCOMPARE(m_window->session().time(), 0.005);
        press(Qt::Key_End);
        QCOMPARE(m_window->session().time(), 1.0);
        QCOMPARE(list->currentIndex(), 0);
    }

    void theTabKeyLeavesAClosedMenu()
    {
        auto *box = child<QWidget>(QStringLiteral("box_b"));
        box->setFocus();
        press(Qt::Key_E, Qt::AltModifier);
        AWAIT(QApplication::activePopupWidget());
        press(Qt::Key_Escape);
        AWAIT(!QApplication::activePopupWidget());
        QVERIFY(!box->hasFocus());
        press(Qt::Key_Right); // along the bar
        QCOMPARE(m_window->session().time(), 0.0);
        press(Qt::Key_Tab);
        QVERIFY2(child<QWidget>(QStringLiteral("reset_b"))->hasFocus() ||
                     child<QWidget>(QStringLiteral("slider_c"))->hasFocus(),
                 qPrintable(described(QApplication::focusWidget())));
    }

    void enterPressesAButton_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"playButton", "loopButton", "startButton", "endButton", "forwardButton", "segment2",
                                 "newtonTablesCopy", "messageRemedy"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void enterPressesAButton()
    {
        QFETCH(const QString, name);
        child<QTabBar>(QStringLiteral("tabBar"))->setCurrentIndex(3);
        child<QAbstractButton>(QStringLiteral("segment1"))->click();
        settle(*m_window);
        auto *button = child<QAbstractButton>(name);
        QVERIFY(button->isVisible());
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
            button->setFocus();
            QSignalSpy clicked(button, &QAbstractButton::clicked);
            press(key);
            QCOMPARE(clicked.count(), 1);
            if (!button->isVisible()) {
                break; // a message that was answered
            }
        }
    }

    void theLoopHasAKey()
    {
        const auto *button = child<QAbstractButton>(QStringLiteral("loopButton"));
        QVERIFY(button->isChecked());
        press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(!button->isChecked() && !m_timeline->isLooping());
        press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(button->isChecked());
        child<QAbstractButton>(QStringLiteral("loopButton"))->click(); // the menu follows
        for (const QAction *action : m_window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_L)) {
                QVERIFY(action->isCheckable() && !action->isChecked());
            }
        }
    }

    void theSpeedHasKeysAndItsMenuFollows()
    {
        const auto chosen = [this] {
            QStringList speeds;
            for (const QAction *action : m_window->findChildren<QAction *>()) {
                if (action->isCheckable() && action->isChecked() && action->text().endsWith(u'×')) {
                    speeds << action->text();
                }
            }
            return speeds;
        };
        child<QWidget>(QStringLiteral("playButton"))->setFocus();
        QCOMPARE(chosen(), QStringList{QStringLiteral("1×")});
        press(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(chosen(), QStringList{QStringLiteral("2×")});
        press(Qt::Key_Left, Qt::ShiftModifier);
        press(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(chosen(), QStringList{QStringLiteral("0.5×")});
        QCOMPARE(m_timeline->speed(), 0.5);
        m_timeline->setSpeed(0.3); // none of them
        QCOMPARE(chosen(), QStringList());
        press(Qt::Key_R, Qt::ControlModifier);
        QVERIFY(child<QWidget>(QStringLiteral("runForm"))->isVisible());
        child<QWidget>(QStringLiteral("runForm"))->close();
    }

    void theWindowsKeysWorkInEveryBox_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name :
             {"box_a", "box_omega2", "box_theta20", "timeBox", "angleBox", "unit_theta20", "runButton", "unit_omega2",
              "toleranceBox", "iterationsBox", "methodBox", "toleranceKindBox", "slider_b"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void theWindowsKeysWorkInEveryBox()
    {
        QFETCH(const QString, name);
        child<QTabBar>(QStringLiteral("tabBar"))->setCurrentIndex(3);
        m_window->session().setSolver({Method::Newton, {}});
        m_window->session().setParameter(Parameter::B, 70.0);
        child<QWidget>(name)->setFocus(Qt::TabFocusReason);
        QVERIFY(child<QWidget>(name)->hasFocus());
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters().b, 65.0);
        press(Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QAction *figure = nullptr;
        for (QAction *action : m_window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_E)) {
                figure = action;
            }
        }
        QVERIFY(figure);
        figure->disconnect(); // it would ask for a file
        QSignalSpy asked(figure, &QAction::triggered);
        press(Qt::Key_E, Qt::ControlModifier);
        QCOMPARE(asked.count(), 1);
    }

    void whatIsBeingTypedIsUndoneInItsBox()
    {
        m_window->session().setParameter(Parameter::B, 70.0);
        typeInto(QStringLiteral("box_a"), QStringLiteral("33"));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QCOMPARE(child<QAbstractSpinBox>(QStringLiteral("box_a"))->text(), QStringLiteral("20 mm"));
        press(Qt::Key_Z, Qt::ControlModifier); // nothing of its own is left
        QCOMPARE(m_window->session().parameters().b, 65.0);
    }

    void theWheelScrollsAndTurnsNothingThatHasNoFocus_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"slider_b", "box_b", "timeSlider", "timeBox", "angleBox", "unit_theta20", "unit_omega2",
                                 "iterationsBox", "methodBox"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void theWheelScrollsAndTurnsNothingThatHasNoFocus()
    {
        QFETCH(const QString, name);
        child<QTabBar>(QStringLiteral("tabBar"))->setCurrentIndex(3);
        m_window->session().setSolver({Method::Newton, {}});
        m_window->session().setTime(0.5);
        auto *control = child<QWidget>(name);
        const auto stateNow = [&] {
            const Session &session = m_window->session();
            return QVariantList{stateOf(control), session.parameters().b, session.time(),
                                session.solver().newton.maxIterations};
        };
        const QVariantList state = stateNow();
        child<QWidget>(QStringLiteral("mechanismView"))->setFocus();
        turnWheelOver(control);
        QCOMPARE(stateNow(), state);
        QVERIFY(!control->hasFocus() && !(control->focusPolicy() & (Qt::WheelFocus & ~Qt::StrongFocus)));
        control->setFocus();
        turnWheelOver(control);
        QVERIFY(stateNow() != state);
    }

    void copiesTheRowsThatAreChosen_data()
    {
        QTest::addColumn<int>("tab");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("heading");
        QTest::addColumn<QString>("second");
        QTest::newRow("errors") << 1 << QStringLiteral("errorTable")
                                << QStringLiteral("channel,verdict,max_error,percent_of_peak,max_error_at [s]")
                                << QStringLiteral("R4_x_diff [mm/s],differs,9.46935096");
        QTest::newRow("columns of the file")
            << 2 << QStringLiteral("columnTable") << QStringLiteral("heading,unit,read_as,rounded_to,values,why")
            << QStringLiteral("R4_x,mm");
        QTest::newRow("motion limits") << 0 << QStringLiteral("positionTable")
                                       << QStringLiteral("limit,value,theta2 [°],time [s]")
                                       << QStringLiteral("inner dead centre [mm],37.4165738");
        QTest::newRow("peaks") << 0 << QStringLiteral("peakTable") << QStringLiteral("limit,value,theta2 [°],time [s]")
                               << QStringLiteral("slider acceleration [mm/s²],-1109.55770");
    }

    void copiesTheRowsThatAreChosen()
    {
        QFETCH(const int, tab);
        QFETCH(const QString, name);
        QFETCH(const QString, heading);
        QFETCH(const QString, second);
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        child<QTabBar>(QStringLiteral("tabBar"))->setCurrentIndex(tab);
        settle(*m_window);
        auto *table = child<QTableView>(name);
        const auto copied = [&] {
            press(Qt::Key_C, Qt::ControlModifier);
            return QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        };
        const auto said = [this] { return m_window->findChild<MessageBar *>()->text(); };
        table->setFocus();
        table->clearSelection();
        QCOMPARE(copied().size(), 1 + table->model()->rowCount());
        QVERIFY(said().startsWith(QString::number(table->model()->rowCount()) + QStringLiteral(" rows are in the")));

        table->selectRow(1);
        QCOMPARE(copied().size(), 2);
        QCOMPARE(copied()[0], heading);
        QVERIFY2(copied()[1].startsWith(second), qPrintable(copied()[1]));
        QVERIFY(said().startsWith(QStringLiteral("The row is in the clipboard, as CSV")));

        press(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(copied().size(), 3);
        QVERIFY(said().startsWith(QStringLiteral("2 rows are in the clipboard, as CSV")));

        child<QWidget>(QStringLiteral("mechanismView"))->setFocus(); // anywhere else the figure
        press(Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void copiesWhatIsMarkedInASentence()
    {
        auto *sentence = child<QLabel>(QStringLiteral("messageText"));
        QTest::mouseDClick(sentence, Qt::LeftButton, Qt::NoModifier, QPoint(10, sentence->height() / 2));
        QVERIFY(sentence->hasSelectedText());
        press(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), sentence->selectedText());
        sentence->setSelection(0, 0);
        press(Qt::Key_C, Qt::ControlModifier); // nothing is marked
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void aClickOnTheCurrentTabHidesNothing()
    {
        auto *tabs = m_window->findChild<FoldingTabs *>();
        auto *bar = child<QTabBar>(QStringLiteral("tabBar"));
        const auto click = [bar](int tab) {
            QTest::mouseClick(bar, Qt::LeftButton, Qt::NoModifier, bar->tabRect(tab).center());
        };
        click(1);
        click(1);
        QVERIFY(!tabs->isFolded());
        press(Qt::Key_F9);
        QVERIFY(tabs->isFolded());
        click(1); // the current one also folds out
        QVERIFY(!tabs->isFolded());
    }

    void aClickInASlidersLineIsOneStepToUndo()
    {
        auto *slider = child<QSlider>(QStringLiteral("slider_b"));
        const QPoint there(slider->width() * 3 / 4, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, there);
        QTest::mouseMove(slider, there + QPoint(9, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, there + QPoint(9, 0));
        const double b = m_window->session().parameters().b;
        const double underMouse = 200.0 * (there.x() + 9) / slider->width();
        QVERIFY2(std::abs(b - underMouse) < 12.0, qPrintable(QStringLiteral("%1, not %2").arg(b).arg(underMouse)));
        QCOMPARE(m_window->session().undoStack().count(), 1);
    }
};

QTEST_MAIN(TestKeys)
#include "tst_keys.moc"
