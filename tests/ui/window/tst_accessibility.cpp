// SPDX-License-Identifier: GPL-3.0-or-later

// Accessibility of the window: the names and values that a screen reader receives, and the order of the Tab key.

#include "tests/ui/window/window_fixture.h"

#include "tests/support/suite.h"
#include "ui/panels/timeline.h"
#include "ui/widgets/number_slider.h"
#include "ui/window/messages.h"
#include "ui/window/presentation.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSlider>

using namespace slidercrank;

namespace tst_accessibility
{

QString descriptionOf(const QWidget *widget)
{
    return QStringLiteral("%1 \"%2\"").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
}

/// Whether the widget is a control, or accepts the focus by the Tab key. Internal parts of a control do not count.
bool isControl(const QWidget *widget)
{
    const bool isOperated = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QSlider *>(widget) ||
                            qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget) ||
                            qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QTabBar *>(widget) ||
                            qobject_cast<const QAbstractItemView *>(widget);
    const bool takesTabFocus = widget->focusPolicy() & Qt::TabFocus;
    const QWidget *owner = widget->parentWidget();
    const bool isPart = qobject_cast<const QAbstractSpinBox *>(owner) || qobject_cast<const QComboBox *>(owner) ||
                        widget->objectName().startsWith("qt_") || qobject_cast<const QScrollBar *>(widget) ||
                        qobject_cast<const QHeaderView *>(widget);
    return (isOperated || takesTabFocus) && !isPart;
}

/// Returns the panel or dialog that contains the control.
const QWidget *panelOf(const QWidget *widget)
{
    const QWidget *panel = widget->parentWidget();
    while (panel->parentWidget() && !panel->isWindow() &&
           !QByteArray(panel->metaObject()->className()).startsWith("slidercrank::")) {
        panel = panel->parentWidget();
    }
    return panel;
}

/// Returns a picture of the widget and a margin around it, in which a style may draw the focus.
QImage pictureOf(QWidget *widget)
{
    constexpr int kMargin = 4; // px
    QWidget *window = widget->window();
    const QRect area(widget->mapTo(window, QPoint()), widget->size());
    QCoreApplication::processEvents();
    return window->grab(area.adjusted(-kMargin, -kMargin, kMargin, kMargin)).toImage();
}

/// Returns everything that the Space key could change.
QVariantList stateOf(const QWidget *widget)
{
    const auto *button = qobject_cast<const QAbstractButton *>(widget);
    const auto *table = qobject_cast<const QAbstractItemView *>(widget);
    return {button && button->isChecked(),
            button && button->isDown(),
            widget->property("currentIndex"),
            widget->property("text"),
            table ? table->currentIndex().row() : -1,
            QApplication::activePopupWidget() != nullptr,
            QApplication::activeModalWidget() != nullptr};
}

/// Returns a text that a screen reader receives.
QString accessibleText(QWidget *widget, QAccessible::Text text)
{
    QAccessibleInterface *accessibleInterface = QAccessible::queryAccessibleInterface(widget);
    return accessibleInterface ? accessibleInterface->text(text).trimmed() : QString();
}

class TestAccessibility : public WindowFixture
{
    Q_OBJECT

private:
    QStringList m_faults;

    /// Records a fault for each visible control without a name of its own or without a valid value.
    void checkControls(QWidget *window)
    {
        QSet<std::pair<const QWidget *, QString>> names;
        for (QWidget *widget : window->findChildren<QWidget *>()) {
            if (!widget->isVisible() || widget->window() != window || !isControl(widget)) {
                continue;
            }
            const QString name = accessibleText(widget, QAccessible::Name);
            const std::pair<const QWidget *, QString> key{panelOf(widget), name};
            if (name.isEmpty() || names.contains(key)) {
                m_faults << QStringLiteral("%1 has no name of its own: \"%2\"").arg(descriptionOf(widget), name);
            }
            names << key;
            const auto *box = qobject_cast<QAbstractSpinBox *>(widget);
            const auto *slider = qobject_cast<QSlider *>(widget);
            const QString value = accessibleText(widget, QAccessible::Value);
            if ((slider || box || qobject_cast<QComboBox *>(widget)) && value.isEmpty()) {
                m_faults << QStringLiteral("%1 has no value").arg(descriptionOf(widget));
            }
            if (slider && widget->objectName() != "designRatio" && value.back().isDigit()) {
                m_faults << QStringLiteral("%1 has no unit: %2").arg(descriptionOf(widget), value);
            }
            if (box) {
                const auto *number = QAccessible::queryAccessibleInterface(widget)->valueInterface();
                const double current = number->currentValue().toDouble();
                if (!(number->minimumValue().toDouble() <= current && current <= number->maximumValue().toDouble())) {
                    m_faults << QStringLiteral("%1 is %2, out of its range").arg(descriptionOf(widget)).arg(current);
                }
            }
        }
    }

    /// Presses Space twice. It must only start and stop the playback.
    void checkSpace(QWidget *stop)
    {
        const QVariantList state = stateOf(stop);
        for (const bool plays : {true, false}) {
            QTest::keyClick(stop, Qt::Key_Space);
            if (view<Timeline>()->isPlaying() != plays || (!plays && stateOf(stop) != state)) {
                m_faults << descriptionOf(stop) + " uses Space itself";
            }
        }
        stop->setFocus();
    }

    /// Presses the Tab key until the focus returns, and checks that every control was reached and showed the focus, and
    /// that Space plays there.
    void checkTabOrder(QWidget *window)
    {
        QSet<QWidget *> reached;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab); // styles show the focus once keys are used
        QWidget *stop = QApplication::focusWidget();
        while (stop && !reached.contains(stop)) {
            reached << stop;
            checkSpace(stop);
            const QImage focused = pictureOf(stop);
            QTest::keyClick(stop, Qt::Key_Tab);
            if (stop->hasFocus() && qobject_cast<QLabel *>(stop)) {
                QTest::keyClick(stop, Qt::Key_Tab); // the first key moved the focus to the link of the label
            }
            if (stop->hasFocus()) {
                m_faults << QStringLiteral("%1 does not let the Tab key out").arg(descriptionOf(stop));
                return;
            }
            if (pictureOf(stop) == focused) {
                m_faults << QStringLiteral("%1 does not show that it has the focus").arg(descriptionOf(stop));
            }
            stop = QApplication::focusWidget();
        }
        for (QWidget *widget : window->findChildren<QWidget *>()) {
            const bool isExpected =
                widget->isVisible() && widget->isEnabled() && isControl(widget) && widget->window() == window;
            if (isExpected && !reached.contains(widget)) {
                m_faults << QStringLiteral("%1 is not reached by the Tab key").arg(descriptionOf(widget));
            }
        }
    }

    /// Opens the form of the time range by its button.
    QWidget *openTimeRange()
    {
        part<QAbstractButton>("runButton")->click();
        QCoreApplication::processEvents();
        return part("runForm");
    }

    /// Calls the function on every page, for the form of the time range and in presentation mode, each without and with
    /// a reference.
    void checkEveryView(const std::function<void(QWidget *)> &check)
    {
        for (const bool withReference : {false, true}) {
            openWindow();
            view<Timeline>()->setClock([] { return 0.0; });
            emit session().referenceRefused({kSample}, "The file cannot be read.");
            if (withReference) {
                openSample();
            }
            onEveryPage(*m_window, [&](const QString &) { check(m_window.get()); });
            QWidget *form = openTimeRange();
            check(form);
            form->close();
            m_window->presentation().setOn(true);
            m_window->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
            check(m_window.get());
        }
        m_faults.removeDuplicates();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

private slots:
    void init() { m_faults.clear(); }

    void cleanup() { m_window.reset(); }

    void everyControlHasAUniqueNameAndAValue()
    {
        checkEveryView([this](QWidget *window) { checkControls(window); });
    }

    void theTabKeyReachesEveryControlAndSpacePlaysThere()
    {
        checkEveryView([this](QWidget *window) { checkTabOrder(window); });
    }

    void controlsOfDialogsHaveNamesAndValues()
    {
        openWindow();
        openSample();
        session().setParameter(Parameter::B, 70.0);
        showTab(ReferenceTab);
        child<QAbstractButton>(*part("referencePanel"), "remedyButton")
            ->click(); // opens the dialog for choosing columns
        for (const char *name : {"Theory and help", "Keyboard and mouse", "Animation…"}) {
            action(QString::fromUtf8(name))->trigger();
        }
        m_window->close(); // asks whether to save the change
        QCoreApplication::processEvents();
        int dialogs = 0;
        for (auto *dialog : m_window->findChildren<QDialog *>()) {
            if (dialog->isVisible()) {
                ++dialogs;
                checkControls(dialog);
                QVERIFY2(!dialog->windowTitle().isEmpty(), qPrintable(descriptionOf(dialog)));
            }
        }
        QCOMPARE(dialogs, 5);
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void aNumberSetByAScreenReaderIsAnEdit()
    {
        openWindow();
        auto *box = part<QAbstractSpinBox>("box_b");
        QAccessibleValueInterface *number = QAccessible::queryAccessibleInterface(box)->valueInterface();
        QCOMPARE(number->currentValue().toDouble(), 65.0);
        number->setCurrentValue(70.0);
        QCOMPARE(session().parameters().b, 70.0);
    }
};

const Suite<TestAccessibility> suite("tst_accessibility");

} // namespace tst_accessibility

#include "tst_accessibility.moc"
