// SPDX-License-Identifier: GPL-3.0-or-later

// Keys and mouse wheel: the events are sent to the window, with the focus on different controls.

#include "tests/support/suite.h"
#include "tests/ui/window/window_fixture.h"

#include "ui/panels/timeline.h"
#include "ui/window/messages.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QTableView>
#include <QWheelEvent>

using namespace slidercrank;

namespace
{

QString described(const QWidget *widget)
{
    return QStringLiteral("%1 \"%2\"").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
}

/// Returns everything that the Space key could change.
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

void turnWheelOver(QWidget *widget)
{
    const QPointF centre = widget->rect().center();
    QWheelEvent wheel(centre, widget->mapToGlobal(centre), QPoint(), QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
}

} // namespace

class TestKeys : public WindowFixture
{
    Q_OBJECT

private:
    Timeline *m_timeline = nullptr;

    QString textIn(const QString &box) const { return part<QAbstractSpinBox>(box)->text(); }

    void typeInto(const QString &box, const QString &text) const
    {
        part(box)->setFocus(Qt::TabFocusReason);
        for (const QChar letter : text) {
            QTest::keyClick(m_window->windowHandle(), letter.toLatin1());
        }
    }

    /// Presses Space at every control that the Tab key reaches. Space must only start and stop the playback.
    void pressSpaceAtEveryStop(const QString &page)
    {
        QSet<QWidget *> seen;
        press(Qt::Key_Tab);
        for (QWidget *stop = QApplication::focusWidget(); stop && !seen.contains(stop);
             stop = QApplication::focusWidget()) {
            seen << stop;
            const QVariantList state = stateOf(stop);
            for (const bool plays : {true, false}) {
                press(Qt::Key_Space);
                QVERIFY2(m_timeline->isPlaying() == plays, qPrintable(page + ": at " + described(stop)));
            }
            QVERIFY2(stop == part("playButton") || stateOf(stop) == state, qPrintable(page + ": " + described(stop)));
            stop->setFocus();
            press(Qt::Key_Tab);
            if (stop->hasFocus()) {
                press(Qt::Key_Tab); // the first key moved the focus to the link of the label
            }
        }
        QVERIFY(seen.size() > 20);
    }

private slots:
    void init()
    {
        resetSettings();
        openWindow();
        m_timeline = part<Timeline>("timeline");
        m_timeline->setClock([] { return 0.0; });
    }

    void cleanup() { m_window.reset(); }

    void spacePlaysFromTheStartAndAfterAClick()
    {
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
        for (const bool plays : {false, true}) {
            const auto *play = part("playButton");
            QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                              play->mapTo(m_window.get(), play->rect().center()));
            QCOMPARE(m_timeline->isPlaying(), plays);
        }
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
        QTest::simulateEvent(m_window->windowHandle(), true, Qt::Key_Space, Qt::NoModifier, " ", false);
        QTest::simulateEvent(m_window->windowHandle(), true, Qt::Key_Space, Qt::NoModifier, " ",
                             true); // repeated while it is held down
        QVERIFY(m_timeline->isPlaying());
    }

    void spacePlaysWhateverHasTheFocus()
    {
        const auto tryEveryPage = [this] {
            onEveryPage(*m_window, [this](const QString &page) { pressSpaceAtEveryStop(page); });
        };
        tryEveryPage();
        openSample();
        tryEveryPage();
    }

    void spaceIsPartOfWhatIsTyped()
    {
        typeInto("box_b", "25 mm");
        QVERIFY(!m_timeline->isPlaying());
        QCOMPARE(textIn("box_b"), QStringLiteral("25 mm"));
        press(Qt::Key_Return);
        QCOMPARE(session().parameters().b, 25.0);
        press(Qt::Key_Space); // the number is entered, so the box no longer uses Space
        QVERIFY(m_timeline->isPlaying());
        typeInto("box_b", "20/3");
        press(Qt::Key_Return);
        QVERIFY(part<QLabel>("refusalLabel")->isVisible());
        QCOMPARE(textIn("box_b"), QStringLiteral("25 mm"));
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
    }

    /// A former defect: Home set b to 1 mm after its slider had been dragged.
    void homeAndEndMoveTheTimeUnlessATextIsEdited()
    {
        for (const char *name : {"slider_b", "timeSlider", "positionTable", "unit_theta20", "playButton", "tabBar"}) {
            part(QLatin1String(name))->setFocus();
            press(Qt::Key_End);
            QCOMPARE(session().time(), 1.0);
            press(Qt::Key_Home);
            QCOMPARE(session().time(), 0.0);
            QCOMPARE(session().parameters(), Parameters());
        }
        session().setTime(0.5);
        typeInto("box_b", "7");
        press(Qt::Key_Home);
        press(Qt::Key_6);
        QCOMPARE(textIn("box_b"), QStringLiteral("67 mm"));
        QCOMPARE(session().time(), 0.5);
    }

    void leftAndRightMoveTheTimeUnlessTheControlUsesThem()
    {
        session().setTime(0.5);
        part("slider_b")->setFocus();
        press(Qt::Key_Right);
        QVERIFY(session().parameters().b > 65.0);
        part("tabBar")->setFocus();
        press(Qt::Key_Right);
        QCOMPARE(part<QTabBar>("tabBar")->currentIndex(), 1);
        QCOMPARE(session().time(), 0.5);
        part("unit_theta20")->setFocus();
        press(Qt::Key_Right);
        QCOMPARE(session().time(), 0.505);
        press(Qt::Key_Left);
        QCOMPARE(session().time(), 0.5);
        QCOMPARE(part<QComboBox>("unit_theta20")->currentIndex(), 0);
    }

    void anOpenListUsesItsOwnKeys()
    {
        auto *list = part<QComboBox>("unit_theta20");
        list->setFocus();
        press(Qt::Key_Return); // opens the list
        AWAIT(QApplication::activePopupWidget());
        press(Qt::Key_Down);
        press(Qt::Key_Space);
        press(Qt::Key_Return);
        AWAIT(!QApplication::activePopupWidget());
        QVERIFY(!m_timeline->isPlaying());
        QCOMPARE(list->currentIndex(), 1);
    }

    void theKeysOfTheWindowWorkInTheTimeRange()
    {
        press(Qt::Key_R, Qt::ControlModifier);
        AWAIT(part("startBox")->hasFocus());
        press(Qt::Key_Space);
        QVERIFY(m_timeline->isPlaying());
        press(Qt::Key_3); // replaces the selected number
        QCOMPARE(textIn("startBox"), QStringLiteral("3 s"));
        press(Qt::Key_Return);
        QCOMPARE(session().sampling().start, 3.0);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session().sampling().start, 0.0);
        part("oneTurnButton")->setFocus();
        press(Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(session().sampling().start, 3.0);
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
        press(Qt::Key_Escape);
        QVERIFY(!QApplication::activePopupWidget());
    }

    void enterPressesAButton()
    {
        m_window->messages().greetOnce(); // shows a button
        showTab(3);
        part<QAbstractButton>("segment1")->click();
        settle(*m_window);
        for (const char *name :
             {"playButton", "loopButton", "startButton", "forwardButton", "segment2", "jacobianPanelCopy"}) {
            auto *button = part<QAbstractButton>(QLatin1String(name));
            QVERIFY2(button->isVisible(), name);
            QSignalSpy clicked(button, &QAbstractButton::clicked);
            for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
                button->setFocus();
                press(key);
            }
            QCOMPARE(clicked.count(), 2);
        }
        while (messages()->isVisible()) {
            part("messageDismiss")->setFocus();
            const qsizetype length = messages()->text().size();
            press(Qt::Key_Return);
            QVERIFY(messages()->text().size() < length);
        }
    }

    void keysChangeLoopAndSpeedAndTheirMenuItems()
    {
        press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(!part<QAbstractButton>("loopButton")->isChecked() && !m_timeline->isLooping());
        part<QAbstractButton>("loopButton")->click();
        QVERIFY(action("Loop")->isChecked());
        const auto chosen = [this] {
            QStringList speeds;
            for (const QAction *action : m_window->findChildren<QAction *>()) {
                if (action->isChecked() && action->text().endsWith(u'×')) {
                    speeds << action->text();
                }
            }
            return speeds;
        };
        QCOMPARE(chosen(), QStringList(QStringLiteral("1×")));
        press(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(chosen(), QStringList(QStringLiteral("2×")));
        press(Qt::Key_Left, Qt::ShiftModifier);
        press(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(m_timeline->speed(), 0.5);
        m_timeline->setSpeed(0.3); // not a speed of the menu
        QCOMPARE(chosen(), QStringList());
    }

    void theKeysOfTheWindowWorkInEveryBox()
    {
        showTab(3);
        session().setSolver({Method::Newton, {}});
        QAction *figure = action(QStringLiteral("Figure…"));
        figure->disconnect(); // otherwise it opens a file dialog
        QSignalSpy asked(figure, &QAction::triggered);
        int boxes = 0;
        for (const char *name : {"box_a", "box_omega2", "timeBox", "angleBox", "unit_theta20", "runButton",
                                 "toleranceBox", "iterationsBox", "methodBox", "toleranceKindBox", "slider_b"}) {
            session().setParameter(Parameter::B, 70.0);
            part(QLatin1String(name))->setFocus(Qt::TabFocusReason);
            press(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY2(session().parameters().b == 65.0, name);
            press(Qt::Key_Y, Qt::ControlModifier);
            QVERIFY2(session().parameters().b == 70.0, name);
            press(Qt::Key_Z, Qt::ControlModifier);
            press(Qt::Key_E, Qt::ControlModifier);
            QCOMPARE(asked.count(), ++boxes);
        }
    }

    void undoesTypingInTheBox()
    {
        session().setParameter(Parameter::B, 70.0);
        typeInto("box_a", "33");
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session().parameters().b, 70.0);
        QCOMPARE(textIn("box_a"), QStringLiteral("20 mm"));
        press(Qt::Key_Y, Qt::ControlModifier); // nothing is restored
        QCOMPARE(textIn("box_a"), QStringLiteral("20 mm"));
        press(Qt::Key_Z, Qt::ControlModifier); // the box has nothing to undo, so the session undoes b
        QCOMPARE(session().parameters().b, 65.0);
        typeInto("box_a", "33");
        press(Qt::Key_Return);
        press(Qt::Key_Z, Qt::ControlModifier); // while the box still has the focus
        QCOMPARE(session().parameters().a, 20.0);
    }

    void theWheelChangesOnlyTheControlWithTheFocus()
    {
        showTab(3);
        session().setSolver({Method::Newton, {}});
        for (const char *name : {"slider_b", "box_b", "timeSlider", "timeBox", "angleBox", "unit_theta20",
                                 "unit_omega2", "iterationsBox", "methodBox"}) {
            session().setTime(0.5);
            auto *control = part(QLatin1String(name));
            const auto state = [&] {
                return QVariantList{stateOf(control), session().parameters().b, session().time(),
                                    session().solver().newton.maxIterations};
            };
            const QVariantList before = state();
            part("mechanismView")->setFocus();
            turnWheelOver(control);
            QVERIFY2(state() == before && !control->hasFocus(), name);
            control->setFocus();
            turnWheelOver(control);
            QVERIFY2(state() != before, name);
        }
    }

    void copiesTheSelectedRows()
    {
        struct Row {
            int tab;
            const char *table;
            const char *heading;
            const char *second;
        };
        openSample();
        for (const Row &row :
             {Row{1, "errorTable", "channel,verdict,max_error,percent_of_peak,max_error_at [s]",
                  "R4_x_diff [mm/s],differs,9.46935096"},
              Row{2, "columnTable", "heading,unit,read_as,rounded_to,values,why", "R4_x,mm"},
              Row{0, "positionTable", "limit,value,theta2 [°],time [s]", "inner dead centre [mm],37.4165738"},
              Row{0, "peakTable", "limit,value,theta2 [°],time [s]", "slider acceleration [mm/s²],-1109.55770"}}) {
            showTab(row.tab);
            auto *table = part<QTableView>(QLatin1String(row.table));
            const auto copied = [this] {
                press(Qt::Key_C, Qt::ControlModifier);
                return QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
            };
            table->setFocus();
            table->clearSelection();
            QCOMPARE(copied().size(), 1 + table->model()->rowCount());
            table->selectRow(1);
            QCOMPARE(copied().size(), 2);
            QCOMPARE(copied()[0], row.heading);
            QVERIFY2(copied()[1].startsWith(row.second), qPrintable(copied()[1]));
            press(Qt::Key_Down, Qt::ShiftModifier);
            QCOMPARE(copied().size(), 3);
            QVERIFY(messages()->text().endsWith("headings: 2."));
        }
        part("mechanismView")->setFocus(); // without a table or text, Ctrl+C copies the figure
        press(Qt::Key_C, Qt::ControlModifier);
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void copiesSelectedText()
    {
        session().setParameter(Parameter::B, -1.0);
        settle();
        auto *sentence = part<QLabel>("messageText");
        QTest::mouseDClick(sentence, Qt::LeftButton, Qt::NoModifier, QPoint(10, sentence->height() / 2));
        QVERIFY(sentence->hasSelectedText());
        press(Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), sentence->selectedText());
        sentence->setSelection(0, 0);
        press(Qt::Key_C, Qt::ControlModifier); // without selected text, Ctrl+C copies the figure
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void aDragOfASliderIsOneStepToUndo()
    {
        auto *slider = part<QSlider>("slider_b");
        const QPoint handle(slider->width() * 65 / 200, slider->height() / 2);
        const QPoint groove(slider->width() * 3 / 4, slider->height() / 2);
        for (const QPoint &from : {groove, handle}) {
            session().setParameter(Parameter::B, 65.0);
            session().undoStack().clear();
            QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, from);
            for (const int pixels : {5, 9}) {
                QTest::mouseMove(slider, from + QPoint(pixels, 0));
            }
            QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, from + QPoint(9, 0));
            const double b = session().parameters().b;
            const double underMouse = 200.0 * (from.x() + 9) / slider->width();
            QVERIFY2(b != 65.0 && std::abs(b - underMouse) < 12.0,
                     qPrintable(QStringLiteral("%1, not %2").arg(b).arg(underMouse)));
            QCOMPARE(session().undoStack().count(), 1);
            press(Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(session().parameters().b, 65.0);
            press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QCOMPARE(session().parameters().b, b);
        }
    }
};

const Suite suite("tst_keys", runWithWidgets<TestKeys>);
#include "tst_keys.moc"
