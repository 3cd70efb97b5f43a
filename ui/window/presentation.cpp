// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/presentation.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/views.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFontInfo>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QSplitter>
#include <QStatusBar>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Returns a font that is legible from the back of a lecture room, and not smaller than the usual font.
QFont largeFont(const QWidget &window)
{
    constexpr int kLinesOnScreen = 45;
    QFont font = window.font();
    font.setPixelSize(std::max(QFontInfo(font).pixelSize(), window.screen()->size().height() / kLinesOnScreen));
    return font;
}

/// Sets the font of the parts of a widget. Qt 6.4 computes the smallest width of a combo box only once, except after a
/// change of the style: with larger letters, its text would be cut off.
void setFontOfParts(QWidget &widget, const QFont &font)
{
    widget.setFont(font);
    for (QComboBox *box : widget.findChildren<QComboBox *>()) {
        QEvent styleChange(QEvent::StyleChange);
        QCoreApplication::sendEvent(box, &styleChange);
        box->updateGeometry();
    }
}

} // namespace

Presentation::Presentation(const Views &views, MessageBar *messages, QMainWindow *window)
    : QObject(window)
    , m_views(views)
    , m_messages(messages)
    , m_window(window)
{
    window->installEventFilter(this);
}

void Presentation::setOn(bool on)
{
    if (on == m_isOn) {
        return;
    }
    m_isOn = on;
    setMechanismAlone(false);
    if (on) {
        m_wasFoldedBefore = m_views.tabs->isFolded();
        m_columnWidthsBefore = m_views.columns->sizes();
    }
    m_views.plots->setPresentation(on);
    m_messages->setMuted(on);
    m_window->statusBar()->setVisible(!on);
    m_window->menuBar()->setMaximumHeight(on ? 0 : QWIDGETSIZE_MAX); // the shortcuts of a hidden menu bar do not work
    m_views.tabs->setFolded(true); // folding and unfolding give the tabs the height for the new font
    setFontOfParts(*m_window->centralWidget(), on ? largeFont(*m_window) : QFont());
    m_views.tabs->setFolded(false);
    m_views.tabs->setFolded(on || m_wasFoldedBefore);
    const QList<int> largePlots{400, 600}; // the proportion of the widths
    m_views.columns->setSizes(on ? largePlots : m_columnWidthsBefore);
    // The maximized state remains set: a Wayland compositor may end a program that changes both states at once.
    m_window->setWindowState(m_window->windowState().setFlag(Qt::WindowFullScreen, on));
    // The hidden menu bar, which keeps the focus after its menus are left by a key, would take Escape.
    if (const QWidget *focus = m_window->focusWidget(); !focus || !focus->isVisible() || focus == m_window->menuBar()) {
        m_views.mechanism->setFocus();
    }
    emit changed(on);
}

void Presentation::setMechanismAlone(bool alone)
{
    m_views.plots->parentWidget()->setVisible(!alone);
    m_views.columns->refresh(); // so that its sizes are valid at once
}

bool Presentation::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        if (m_views.plots->parentWidget()->isHidden()) {
            setMechanismAlone(false);
            return true;
        }
        if (m_isOn) {
            setOn(false);
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace slidercrank

#include "moc_presentation.cpp"
