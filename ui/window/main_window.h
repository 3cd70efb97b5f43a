// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Constructs the rooms of the window, lays them out and connects them; no arithmetic.

#include "ui/document/session.h"
#include "ui/panels/page.h"
#include "ui/window/rooms.h"
#include "ui/text/theme.h"

#include <QMainWindow>

#include <functional>

namespace slidercrank
{

class Exports;
class Messages;
class Presentation;
class Recovery;
class SceneFile;
class StatusBar;

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    Session &session() { return *m_session; }

    SceneFile &scene() { return *m_scene; }

    Exports &exports() { return *m_exports; }

    Presentation &presentation() { return *m_presentation; }

    /// With all of its frame; it fills a screen that has no room for that.
    void showWithinScreen();

public slots:
    /// A scene where it is named as one, else a reference; several files are joined.
    void openFiles(const QStringList &paths);
    void openReference(const QStringList &paths);
    void openReference(const QString &path);
    void openSample();
    void chooseReference();

    void setTheme(slidercrank::Theme theme);

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;

private:
    void connectDocument();
    void makeRooms(bool withGhost);
    void remakeRooms();
    void connectRooms();

    /// Shows what there is now, and with that signal of the session what there is then.
    template <typename Changed, typename Room, typename Slot, typename... Now>
    void follow(Changed changed, Room *room, Slot slot, const Now &...now);

    TablePanel *makePanel(const QString &name, const QString &title, const std::function<Page()> &makePage);
    QWidget *makeLimitsPanel();
    QWidget *makeNewtonPanel();
    QWidget *makeStudyPanel();

    void chooseColumns(const QStringList &paths); ///< of those files
    void askWhereNothingTells(const QStringList &paths, const FileLayout &layout);
    void showTitle();
    void showResult(const std::shared_ptr<const Result> &result);
    void foldWhereLow();

    Session *m_session;
    Rooms m_rooms;
    SceneFile *m_scene;
    Exports *m_exports;
    Presentation *m_presentation;
    Messages *m_messages;
    StatusBar *m_status;
    Recovery *m_recovery;
    QStringList m_asked;         ///< what a person opened, until it is read or refused
    bool m_isLeaving = false;    ///< what would be lost was asked about
    bool m_foldedByHand = false; ///< the person chose; a resize no longer does
};

} // namespace slidercrank
