// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/presentation.h"

#include "ui/document/with.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/parameter_panel.h"
#include "ui/plots/plot_grid.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/rooms.h"

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

/// As high as can be read from the last row; never smaller than usual.
QFont largeFont(const QWidget &window)
{
    constexpr int kLinesOnScreen = 45;
    QFont font = window.font();
    font.setPixelSize(std::max(QFontInfo(font).pixelSize(), window.screen()->size().height() / kLinesOnScreen));
    return font;
}

} // namespace

Presentation::Presentation(const Rooms &rooms, QMainWindow *window)
    : QObject(window)
    , m_rooms(rooms)
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
    setAlone(false);
    const MechanismSettings drawn = m_rooms.mechanism->settings();
    if (on) {
        m_widths = m_rooms.columns->sizes();
        m_hadAngles = drawn.angles;
    }
    m_rooms.mechanism->setSettings(with(drawn, &MechanismSettings::angles, on || (drawn.angles && m_hadAngles)));
    m_rooms.tabs->setVisible(!on);
    m_window->statusBar()->setVisible(!on);
    m_window->menuBar()->setMaximumHeight(on ? 0 : QWIDGETSIZE_MAX); // hidden, its keys would not work
    m_rooms.parameters->setBrief(on);
    m_rooms.plots->setPresentation(on);
    m_window->centralWidget()->setFont(on ? largeFont(*m_window) : QFont());
    constexpr int kPartOfMechanism = 40; // of 100
    m_rooms.columns->setStretchFactor(0, on ? kPartOfMechanism : 0);
    m_rooms.columns->setStretchFactor(1, on ? 100 - kPartOfMechanism : 1);
    const int width = m_rooms.columns->width();
    m_rooms.columns->setSizes(on ? QList<int>{width * kPartOfMechanism / 100, width - width * kPartOfMechanism / 100}
                                 : m_widths);
    // Maximized stays as it is beneath: a Wayland compositor may end a program that changes both at once.
    m_window->setWindowState(m_window->windowState().setFlag(Qt::WindowFullScreen, on));
    if (const QWidget *focus = m_window->focusWidget(); !focus || !focus->isVisible()) {
        m_rooms.mechanism->setFocus();
    }
    emit changed(on);
}

void Presentation::setAlone(bool alone)
{
    m_rooms.plots->parentWidget()->setVisible(!alone);
}

bool Presentation::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        if (m_rooms.plots->parentWidget()->isHidden()) {
            setAlone(false);
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
