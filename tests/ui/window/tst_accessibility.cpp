// SPDX-License-Identifier: GPL-3.0-or-later

// The window for those who cannot see it, or have no mouse: what a screen reader is told, where the Tab key leads.

#include "tests/support/suite.h"
#include "tests/ui/window/window_fixture.h"

#include "ui/widgets/number_slider.h"
#include "ui/window/presentation.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSlider>

using namespace slidercrank;

namespace
{

QString described(const QWidget *widget)
{
    return QStringLiteral("%1 \"%2\"").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
}

/// What a person operates, or stops at with the Tab key; the parts that a control is made of are the control's.
bool isControl(const QWidget *widget)
{
    const bool operated = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QSlider *>(widget) ||
                          qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget) ||
                          qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QTabBar *>(widget) ||
                          qobject_cast<const QAbstractItemView *>(widget);
    const bool stops = widget->focusPolicy() & Qt::TabFocus;
    const QWidget *owner = widget->parentWidget();
    const bool isPart = qobject_cast<const QAbstractSpinBox *>(owner) || qobject_cast<const QComboBox *>(owner) ||
                        widget->objectName().startsWith(QLatin1String("qt_")) ||
                        qobject_cast<const QScrollBar *>(widget) || qobject_cast<const QHeaderView *>(widget);
    return (operated || stops) && !isPart;
}

/// The arrow keys lead there from the one that is chosen.
bool isOneOfAChoice(const QWidget *widget)
{
    const auto *button = qobject_cast<const QAbstractButton *>(widget);
    return button && button->group() && button->group()->exclusive() && !button->isChecked();
}

/// The room of the window, or the dialog, in which a control is.
const QWidget *panelOf(const QWidget *widget)
{
    const QWidget *panel = widget->parentWidget();
    while (panel->parentWidget() && !panel->isWindow() &&
           !QByteArray(panel->metaObject()->className()).startsWith("slidercrank::")) {
        panel = panel->parentWidget();
    }
    return panel;
}

/// With its surroundings, where a style may draw the focus.
QImage pictureOf(QWidget *widget)
{
    constexpr int kAround = 4; // px
    QWidget *window = widget->window();
    const QRect area(widget->mapTo(window, QPoint()), widget->size());
    QCoreApplication::processEvents();
    return window->grab(area.adjusted(-kAround, -kAround, kAround, kAround)).toImage();
}

QString accessible(QWidget *widget, QAccessible::Text text)
{
    QAccessibleInterface *told = QAccessible::queryAccessibleInterface(widget);
    return told ? told->text(text).trimmed() : QString();
}

} // namespace

class TestAccessibility : public WindowFixture
{
    Q_OBJECT

private:
    QStringList m_faults;

    /// A number is told as one, with the range in which it may be.
    void judgeNumber(QWidget *box)
    {
        const QAccessibleValueInterface *number = QAccessible::queryAccessibleInterface(box)->valueInterface();
        const double smallest = number ? number->minimumValue().toDouble() : 0.0;
        const double largest = number ? number->maximumValue().toDouble() : 0.0;
        const double current = number ? number->currentValue().toDouble() : 0.0;
        if (!(smallest < largest && smallest <= current && current <= largest)) {
            m_faults << QStringLiteral("%1 is %2, from %3 to %4")
                            .arg(described(box))
                            .arg(current)
                            .arg(smallest)
                            .arg(largest);
        }
    }

    void judge(QWidget *window)
    {
        QHash<std::pair<const QWidget *, QString>, const QWidget *> names;
        for (QWidget *widget : window->findChildren<QWidget *>()) {
            if (!widget->isVisible() || widget->window() != window || !isControl(widget)) {
                continue;
            }
            const QString name = accessible(widget, QAccessible::Name);
            if (name.isEmpty()) {
                m_faults << QStringLiteral("%1 has no name").arg(described(widget));
                continue;
            }
            const std::pair<const QWidget *, QString> key{panelOf(widget), name};
            if (const QWidget *other = names.value(key)) {
                m_faults << QStringLiteral("%1 and %2 are both called \"%3\"")
                                .arg(described(other), described(widget), name);
            }
            names[key] = widget;
            if (qobject_cast<QSlider *>(widget) || qobject_cast<QAbstractSpinBox *>(widget) ||
                qobject_cast<QComboBox *>(widget)) {
                const QString value = accessible(widget, QAccessible::Value);
                if (value.isEmpty()) {
                    m_faults << QStringLiteral("%1 \"%2\" has no value").arg(described(widget), name);
                }
                if (qobject_cast<QAbstractSpinBox *>(widget)) {
                    judgeNumber(widget);
                }
                if (qobject_cast<QSlider *>(widget) && widget->objectName() != "designRatio" &&
                    value[value.size() - 1].isDigit()) {
                    m_faults << QStringLiteral("%1 \"%2\" has no unit: %3").arg(described(widget), name, value);
                }
            }
        }
    }

    /// By the Tab key all the way round, from wherever the focus is.
    void walk(QWidget *window)
    {
        QSet<QWidget *> reached;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab); // styles show the focus once keys are used
        QWidget *stop = QApplication::focusWidget();
        while (stop && !reached.contains(stop)) {
            reached << stop;
            const QImage focused = pictureOf(stop);
            QTest::keyClick(stop, Qt::Key_Tab);
            if (stop->hasFocus() && qobject_cast<QLabel *>(stop)) {
                QTest::keyClick(stop, Qt::Key_Tab); // from the label to its link, and on
            }
            if (stop->hasFocus()) {
                m_faults << QStringLiteral("%1 does not let the Tab key out").arg(described(stop));
                return;
            }
            if (pictureOf(stop) == focused) {
                m_faults << QStringLiteral("%1 does not show that it has the focus").arg(described(stop));
            }
            stop = QApplication::focusWidget();
        }
        for (QWidget *widget : window->findChildren<QWidget *>()) {
            const bool wanted = widget->isVisible() && widget->isEnabled() && isControl(widget) &&
                                !isOneOfAChoice(widget) && widget->window() == window;
            if (wanted && !reached.contains(widget)) {
                m_faults << QStringLiteral("%1 is not reached by the Tab key").arg(described(widget));
            }
        }
    }

    /// What opens from the timeline's button.
    QWidget *openRun()
    {
        part<QAbstractButton>("runButton")->click();
        QCoreApplication::processEvents();
        return part("runForm");
    }

    /// On every page, in the form of the time range and in presentation mode, without and with a reference.
    void everywhere(const std::function<void(QWidget *)> &look)
    {
        for (const bool withReference : {false, true}) {
            QSettings().clear(); // so that the window greets, too
            openWindow();
            if (withReference) {
                openSample();
            }
            onEveryPage(*m_window, [&](const QString &) { look(m_window.get()); });
            QWidget *form = openRun();
            look(form);
            form->close();
            m_window->presentation().setOn(true);
            m_window->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
            look(m_window.get());
        }
        m_faults.removeDuplicates();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

private slots:
    void init() { m_faults.clear(); }

    void cleanup() { m_window.reset(); }

    void everyControlHasANameOfItsOwnAndAValue()
    {
        everywhere([this](QWidget *window) { judge(window); });
    }

    void theTabKeyReachesEveryControlAndTheFocusIsSeen()
    {
        everywhere([this](QWidget *window) { walk(window); });
    }

    void everyDialogIsJudgedAsTheWindowIs()
    {
        openWindow();
        openSample();
        session().setParameter(Parameter::B, 70.0);
        showTab(2);
        child<QAbstractButton>(*part("referencePanel"), "remedyButton")->click(); // chooses columns
        for (const char *name : {"Theory and help", "Keyboard and mouse", "Animation…"}) {
            action(QString::fromUtf8(name))->trigger();
        }
        m_window->close(); // asks about the change
        QCoreApplication::processEvents();
        int dialogs = 0;
        for (auto *dialog : m_window->findChildren<QDialog *>()) {
            if (dialog->isVisible()) {
                ++dialogs;
                judge(dialog);
                QVERIFY2(!dialog->windowTitle().isEmpty(), qPrintable(described(dialog)));
            }
        }
        QCOMPARE(dialogs, 5);
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void aNumberSetFromOutsideIsAnEdit()
    {
        openWindow();
        auto *box = part<QAbstractSpinBox>("box_b");
        QAccessibleValueInterface *number = QAccessible::queryAccessibleInterface(box)->valueInterface();
        QCOMPARE(number->currentValue().toDouble(), 65.0);
        number->setCurrentValue(70.0);
        number->setCurrentValue(-1.0);
        QCOMPARE(session().parameters().b, 70.0);
        QVERIFY(accessible(box, QAccessible::Description).contains("greater than 0"));
    }
};

const Suite suite("tst_accessibility", runWithWidgets<TestAccessibility>);
#include "tst_accessibility.moc"
