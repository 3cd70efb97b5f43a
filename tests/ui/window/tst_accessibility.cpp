// SPDX-License-Identifier: GPL-3.0-or-later

// The window for those who cannot see it, or have no mouse: what a screen reader is told, where the Tab key leads.

#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/number_slider.h"
#include "ui/window/main_window.h"
#include "ui/window/presentation.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSettings>
#include <QSlider>
#include <QStandardPaths>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

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

class TestAccessibility : public QObject
{
    Q_OBJECT

private:
    const QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;
    QStringList m_faults;

    /// A number is told as one: how large it is, and how small and large it may become.
    void judgeNumber(QWidget *box)
    {
        QAccessibleInterface *told = QAccessible::queryAccessibleInterface(box);
        QAccessibleValueInterface *number = told->valueInterface();
        if (!number) {
            m_faults << QStringLiteral("%1 is no number").arg(described(box));
            return;
        }
        bool areNumbers[3] = {};
        const double current = number->currentValue().toDouble(&areNumbers[0]);
        const double smallest = number->minimumValue().toDouble(&areNumbers[1]);
        const double largest = number->maximumValue().toDouble(&areNumbers[2]);
        if (!areNumbers[0] || !areNumbers[1] || !areNumbers[2] ||
            !(smallest < largest && smallest <= current && current <= largest)) {
            m_faults << QStringLiteral("%1 is %2, from %3 to %4")
                            .arg(described(box), number->currentValue().toString(), number->minimumValue().toString(),
                                 number->maximumValue().toString());
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
                if (qobject_cast<QSlider *>(widget) && value[value.size() - 1].isDigit()) {
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

    /// Each tab of the panels below in turn, and in a tab each page that its own buttons choose.
    void onEveryPage(const std::function<void()> &look)
    {
        auto *bar = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
        for (int tab = 0; tab < bar->count(); ++tab) {
            bar->setCurrentIndex(tab);
            QCoreApplication::processEvents();
            look();
        }
        bar->setCurrentIndex(3);
        for (int page = 1; page < 5; ++page) {
            m_window->findChild<QAbstractButton *>(QStringLiteral("segment%1").arg(page))->click();
            settle(*m_window); // the panel lets numbers rest for a moment before the next are shown
            look();
        }
    }

    /// What opens from the timeline's button.
    QWidget *openRun()
    {
        m_window->findChild<QAbstractButton *>(QStringLiteral("runButton"))->click();
        auto *form = m_window->findChild<QWidget *>(QStringLiteral("runForm"));
        QCoreApplication::processEvents();
        return form;
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
        QSettings().clear(); // so that the window greets, too
        m_faults.clear();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void everyControlHasANameOfItsOwnAndAValue_data()
    {
        QTest::addColumn<QString>("reference");
        QTest::newRow("as it starts") << QString();
        QTest::newRow("with a reference") << kSample;
    }

    void everyControlHasANameOfItsOwnAndAValue()
    {
        QFETCH(const QString, reference);
        if (!reference.isEmpty()) {
            m_window->openReference(reference);
            AWAIT(m_window->session().diagnosis());
        }
        onEveryPage([this] { judge(m_window.get()); });
        judge(openRun());
        m_window->presentation().setOn(true);
        judge(m_window.get());
        m_faults.removeDuplicates();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void everyDialogIsJudgedAsTheWindowIs()
    {
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        m_window->findChild<QTabBar *>(QStringLiteral("tabBar"))->setCurrentIndex(2);
        Parameters parameters;
        parameters.b = 70.0;
        m_window->session().setParameters(parameters);
        const auto *reference = m_window->findChild<QWidget *>(QStringLiteral("referencePanel"));
        reference->findChild<QAbstractButton *>(QStringLiteral("remedyButton"))->click(); // chooses columns
        for (QAction *action : m_window->findChildren<QAction *>()) {
            const QString name = action->text().remove(u'&');
            if (name == QLatin1String("Theory and help") || name == QLatin1String("Keyboard and mouse") ||
                name == QLatin1String("About") || name == QStringLiteral("Animation…")) {
                action->trigger();
            }
        }
        m_window->close(); // asks about the change
        QCoreApplication::processEvents();
        int dialogs = 0;
        for (auto *dialog : m_window->findChildren<QDialog *>()) {
            if (dialog->isVisible()) {
                ++dialogs;
                judge(dialog);
                if (dialog->windowTitle().isEmpty()) {
                    m_faults << QStringLiteral("%1 has no title").arg(described(dialog));
                }
            }
        }
        QCOMPARE(dialogs, 6);
        m_faults.removeDuplicates();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void aNumberSetFromOutsideIsAnEdit()
    {
        auto *box = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("box_b"));
        QAccessibleValueInterface *number = QAccessible::queryAccessibleInterface(box)->valueInterface();
        QVERIFY(number);
        QCOMPARE(number->currentValue().toDouble(), 65.0);
        number->setCurrentValue(70.0);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        number->setCurrentValue(-1.0);
        QCOMPARE(m_window->session().parameters().b, 70.0);
        QVERIFY(accessible(box, QAccessible::Description).contains(QStringLiteral("greater than 0")));
    }

    void theTabKeyReachesEveryControlAndTheFocusIsSeen_data() { everyControlHasANameOfItsOwnAndAValue_data(); }

    void theTabKeyReachesEveryControlAndTheFocusIsSeen()
    {
        QFETCH(const QString, reference);
        if (!reference.isEmpty()) {
            m_window->openReference(reference);
            AWAIT(m_window->session().diagnosis());
        }
        onEveryPage([this] { walk(m_window.get()); });
        walk(openRun());
        m_window->presentation().setOn(true);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        walk(m_window.get());
        m_faults.removeDuplicates();
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }
};

QTEST_MAIN(TestAccessibility)
#include "tst_accessibility.moc"
