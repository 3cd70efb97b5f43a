// SPDX-License-Identifier: GPL-3.0-or-later

// Keys and mouse wheel: the events are sent to the window, with the focus on different controls.

#include "tests/ui/window/window_fixture.h"

#include "tests/support/suite.h"
#include "ui/panels/timeline.h"
#include "ui/window/messages.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QTableView>
#include <QTextBrowser>
#include <QWheelEvent>

using namespace slidercrank;

namespace tst_keys
{

void turnWheelOver(QWidget *widget)
{
    const QPointF centre = widget->rect().center();
    QWheelEvent wheel(centre, widget->mapToGlobal(centre), QPoint(), QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
}

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

    /// Presses Ctrl+C, and returns the text in the clipboard.
    QString copyWithKeys() const
    {
        press(Qt::Key_C, Qt::ControlModifier);
        return QApplication::clipboard()->text();
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

    void spaceIsPartOfWhatIsTyped()
    {
        typeInto("box_b", "25 mm");
        QVERIFY(!m_timeline->isPlaying());
        QCOMPARE(textIn("box_b"), "25 mm");
        press(Qt::Key_Return);
        QCOMPARE(session().parameters().b, 25.0);
        press(Qt::Key_Space); // the number is entered, so the box no longer uses Space
        QVERIFY(m_timeline->isPlaying());
        typeInto("box_b", "20/");
        press(Qt::Key_Return);
        QVERIFY(part<QLabel>("refusalLabel")->isVisible());
        QCOMPARE(textIn("box_b"), "25 mm");
        press(Qt::Key_Space);
        QVERIFY(!m_timeline->isPlaying());
    }

    /// A former defect: "65 in" over 65 mm started the animation at the space.
    void spaceIsTypedAlsoAfterThePresentNumber()
    {
        typeInto("box_b", "65 in");
        QVERIFY(!m_timeline->isPlaying());
        press(Qt::Key_Return);
        QCOMPARE(session().parameters().b, 65.0 * 25.4);
        typeInto("box_b", "1651");
        press(Qt::Key_Escape);
        press(Qt::Key_Space); // the typed text is gone
        QVERIFY(m_timeline->isPlaying());
    }

    /// A former defect: Home set b to 1 mm after its slider had been dragged.
    void homeAndEndMoveTheTimeUnlessATextIsEdited()
    {
        showTab(LimitsTab);
        for (const char *name : {"slider_b", "timeSlider", "limitTable", "unit_theta20", "playButton", "tabBar"}) {
            part(name)->setFocus();
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
        QCOMPARE(textIn("box_b"), "67 mm");
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
        QCOMPARE(shownTab(), LimitsTab);
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
        QCOMPARE(textIn("startBox"), "3 s");
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
        emit session().referenceRefused({kSample}, "The file cannot be read."); // shows a button
        showTab(NewtonTab);
        part<QListWidget>("newtonPages")->setCurrentRow(2);
        settle(*m_window);
        for (const char *name : {"playButton", "loopButton", "jacobianPanelCopy"}) {
            auto *button = part<QAbstractButton>(name);
            QSignalSpy clicked(button, &QAbstractButton::clicked);
            for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
                button->setFocus();
                press(key);
            }
            QVERIFY2(clicked.count() == 2, name);
        }
        while (messages()->isVisible()) {
            part("messageDismiss")->setFocus();
            const qsizetype length = shownMessages().size();
            press(Qt::Key_Return);
            QVERIFY(shownMessages().size() < length);
        }
    }

    void keysChangeLoopAndSpeed()
    {
        press(Qt::Key_L, Qt::ControlModifier);
        QVERIFY(!part<QAbstractButton>("loopButton")->isChecked());
        click("loopButton");
        QVERIFY(action("Loop")->isChecked());
        press(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(m_timeline->speed(), 2.0);
        press(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(m_timeline->speed(), 1.0);
    }

    void theKeysOfTheWindowWorkInEveryBox()
    {
        showTab(NewtonTab);
        session().setSolver({Method::Newton, {}});
        for (const char *name : {"box_a", "box_omega2", "timeBox", "angleBox", "unit_theta20", "runButton",
                                 "toleranceBox", "iterationsBox", "methodBox", "toleranceKindBox", "slider_b"}) {
            setB(70.0);
            part(name)->setFocus(Qt::TabFocusReason);
            press(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY2(session().parameters().b == 65.0, name);
            press(Qt::Key_Y, Qt::ControlModifier);
            QVERIFY2(session().parameters().b == 70.0, name);
            session().undoStack().undo();
        }
    }

    void undoesTypingInTheBox()
    {
        setB(70.0);
        typeInto("box_a", "33");
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session().parameters().b, 70.0);
        QCOMPARE(textIn("box_a"), "20 mm");
        press(Qt::Key_Y, Qt::ControlModifier); // nothing is restored
        QCOMPARE(textIn("box_a"), "20 mm");
        press(Qt::Key_Z, Qt::ControlModifier); // the box has nothing to undo, so the session undoes b
        QCOMPARE(session().parameters().b, 65.0);
        typeInto("box_a", "33");
        press(Qt::Key_Return);
        press(Qt::Key_Z, Qt::ControlModifier); // while the box still has the focus
        QCOMPARE(session().parameters().a, 20.0);
    }

    void theWheelChangesOnlyTheControlWithTheFocus()
    {
        showTab(NewtonTab);
        session().setSolver({Method::Newton, {}});
        for (const char *name : {"slider_b", "box_b", "timeSlider", "timeBox", "angleBox", "unit_theta20",
                                 "unit_omega2", "iterationsBox", "methodBox"}) {
            session().setTime(0.5);
            auto *control = part(name);
            const auto state = [&] {
                return QVariantList{control->property("currentIndex"), session().parameters().b, session().time(),
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
            Tab tab;
            const char *table;
            const char *heading;
            const char *second;
        };
        openSample();
        for (const Row &row :
             {Row{ErrorsTab, "errorTable", "channel,verdict,max_error,percent_of_peak,max_error_at [s]",
                  "\"R4_x_diff [mm/s]\",differs,9.46935096"},
              Row{LimitsTab, "limitTable", "limit,value,theta2 [deg],time [s]",
                  "\"inner-dead-centre [mm]\",37.4165738"}}) {
            showTab(row.tab);
            auto *table = part<QTableView>(row.table);
            table->setFocus();
            table->clearSelection();
            QCOMPARE(copyWithKeys().count('\n'), 1 + table->model()->rowCount());
            table->selectRow(1);
            QVERIFY2(copyWithKeys().startsWith(QString(row.heading) + '\n' + row.second), qPrintable(copyWithKeys()));
            QCOMPARE(copyWithKeys().count('\n'), 2);
            press(Qt::Key_Down, Qt::ShiftModifier);
            QCOMPARE(copyWithKeys().count('\n'), 3);
            QVERIFY(shownMessages().contains("clipboard"));
        }
        part("mechanismView")->setFocus(); // without a table or text, Ctrl+C copies the figure
        copyWithKeys();
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void copiesSelectedText()
    {
        setB(-1.0);
        settle();
        auto *sentence = part<QLabel>("messageText");
        QTest::mouseDClick(sentence, Qt::LeftButton, Qt::NoModifier, QPoint(10, sentence->height() / 2));
        QVERIFY(sentence->hasSelectedText());
        QCOMPARE(copyWithKeys(), sentence->selectedText());
        sentence->setSelection(0, 0);
        copyWithKeys(); // without selected text, Ctrl+C copies the figure
        QVERIFY(QApplication::clipboard()->mimeData()->hasImage());
    }

    void aDragOfASliderIsOneStepToUndo()
    {
        auto *slider = part<QSlider>("slider_b");
        const QPoint handle(slider->width() * 65 / 200, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, handle);
        for (const int pixels : {5, 9}) {
            QTest::mouseMove(slider, handle + QPoint(pixels, 0));
            letTimePass(session()); // otherwise the edits would form one step without a drag
        }
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, handle + QPoint(9, 0));
        const double b = session().parameters().b;
        QVERIFY2(b > 65.0 && b < 85.0, qPrintable(QString::number(b)));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(session().parameters().b, 65.0);
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(session().parameters().b, b);
    }

    void theHelpDescribesEveryKeyAndFormatsFormulas()
    {
        const auto inSpanish = [](QString key) { // as Qt writes it in the menus
            for (const auto &[name, translation] : {std::pair{"Ctrl", "Control"},
                                                    {"Shift", "Mayúsculas"},
                                                    {"Space", "Espacio"},
                                                    {"Home", "Inicio"},
                                                    {"End", "Fin"},
                                                    {"Left", "Izquierda"},
                                                    {"Right", "Derecha"}}) {
                key.replace(QLatin1String(name), QString::fromUtf8(translation));
            }
            return key;
        };
        for (const char *name : {":/help/english.html", ":/help/spanish.html"}) {
            const QString page = QString::fromUtf8(contentOf(name));
            const bool isSpanish = QString(name).contains("spanish");
            QVERIFY(page.contains("C<sub>q</sub>") && !page.contains(QChar(0x307)) && !page.contains(u'_'));
            for (const char *figure : {"mechanism", "dead-centres", "transmission-angle", "polygons"}) {
                QVERIFY2(page.contains(QString("<img src=\"qrc:/help/%1.svg\">").arg(figure)), figure);
                QVERIFY2(contentOf(QString(":/help/%1.svg").arg(figure)).startsWith("<svg"), figure);
            }
            int keys = 0;
            for (const QAction *action : m_window->findChildren<QAction *>()) {
                for (const QKeySequence &key : action->shortcuts()) {
                    const QString text = key.toString(QKeySequence::PortableText);
                    QVERIFY2(page.contains(isSpanish ? inSpanish(text) : text), qPrintable(text));
                    ++keys;
                }
            }
            QVERIFY(keys > 20);
        }
        for (const char *title : {"Theory and help", "Keyboard and mouse"}) {
            action(title)->trigger();
            auto *page = m_window->findChild<QDialog *>("help");
            QVERIFY(page && page->isVisible() && !page->isModal());
            QCOMPARE(page->windowTitle(), QString(title));
            QVERIFY(page->findChild<QTextBrowser *>()->toPlainText().contains(title));
            QTest::keyClick(page, Qt::Key_Escape);
            AWAIT(!m_window->findChild<QDialog *>("help"));
        }
    }
};

const Suite<TestKeys> suite("tst_keys");

} // namespace tst_keys

#include "tst_keys.moc"
