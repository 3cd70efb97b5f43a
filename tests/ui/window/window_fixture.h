// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A fixture that opens a window with empty settings, and functions that operate the window.

#include "ui/widgets/message_bar.h"
#include "ui/window/main_window.h"

#include "tests/support/files.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QImage>
#include <QListWidget>
#include <QMimeData>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <QWindow>

#include <memory>

namespace slidercrank
{

class WindowFixture : public QObject
{
protected:
    enum Tab { TableTab, LimitsTab, ErrorsTab, ReferenceTab, NewtonTab, StudyTab };

    WindowFixture()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle("Fusion");
        QApplication::setCursorFlashTime(0);
        QLocale::setDefault(QLocale::c());
        resetSettings();
    }

    static void resetSettings() { QSettings().clear(); }

    /// Opens a window in place of the previous one.
    void openWindow()
    {
        m_window.reset();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void openSample()
    {
        m_window->openReference(kSample);
        AWAIT(m_window->session().identification());
        settle(*m_window);
    }

    Session &session() const { return m_window->session(); }
    void setB(double b) const { session().setParameter(Parameter::B, b); }

    /// Returns the only view of this class.
    template <typename View>
    View *view() const
    {
        return m_window->findChild<View *>();
    }

    MessageBar *messages() const { return view<MessageBar>(); }
    QString shownMessages() const { return messageText(*messages()); }
    /// Returns the widget of the window with this object name.

    template <typename Widget = QWidget>
    Widget *part(const QString &name) const
    {
        return child<Widget>(*m_window, name);
    }

    void click(const QString &button) const
    {
        QTest::mouseClick(part<QAbstractButton>(button), Qt::LeftButton);
        settle();
    }

    QAction *action(const QString &text) const
    {
        for (QAction *candidate : m_window->findChildren<QAction *>()) {
            if (candidate->text().remove(u'&') == text) {
                return candidate;
            }
        }
        qFatal("no action %s", qPrintable(text));
    }

    /// Sends a key to the window or to its open popup, as the window system does.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QWidget *popup = QApplication::activePopupWidget();
        QTest::keyClick(popup ? popup->windowHandle() : m_window->windowHandle(), key, modifiers);
    }

    void showTab(Tab tab) const
    {
        part<QTabBar>("tabBar")->setCurrentIndex(tab);
        settle(*m_window);
    }

    int shownTab() const { return part<QTabBar>("tabBar")->currentIndex(); }

    QImage picture(const QString &name) const
    {
        QCoreApplication::processEvents();
        return part(name)->parentWidget()->grab(part(name)->geometry()).toImage().convertToFormat(QImage::Format_RGB32);
    }

    void drop(const QStringList &paths) const
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &path : paths) {
            urls += QUrl::fromLocalFile(path);
        }
        data.setUrls(urls);
        const QPointF middle = m_window->rect().center();
        QDragEnterEvent enter(middle.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
        QVERIFY(event.isAccepted());
    }

    const QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;
};

/// Shows each tab, and each page of a tab with a list of pages, and calls the function with the title.
inline void onEveryPage(MainWindow &window, const std::function<void(const QString &title)> &visit)
{
    auto *tabs = window.findChild<QTabWidget *>();
    for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        settle(window);
        visit(tabs->tabText(tab));
        auto *pages = tabs->currentWidget()->findChild<QListWidget *>();
        for (int page = 1; pages && page < pages->count(); ++page) {
            pages->setCurrentRow(page);
            settle(window);
            visit(pages->item(page)->text());
        }
    }
}

} // namespace slidercrank
