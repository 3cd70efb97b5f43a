// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The main window: makes the views, lays them out and connects them with the session. It computes nothing.

#include "ui/document/session.h"
#include "ui/panels/page.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"
#include "ui/window/views.h"

#include <QMainWindow>

#include <functional>
#include <memory>

namespace slidercrank
{

class Exports;
class Presentation;
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

    /// Shows the window; maximized if the screen is too small for it.
    void showWithinScreen();

    /// Returns a window, not yet visible, in the language that was chosen last. It takes over what this window shows.
    /// This window is then to be deleted.
    std::unique_ptr<MainWindow> makeReplacement();

signals:
    /// Emitted when a different language is chosen. Widgets keep the language in which they were made:
    /// makeReplacement() makes a new window.
    void languageChosen();

public slots:
    /// Opens a scene, or a reference. Several files are joined to one reference.
    void openFiles(const QStringList &paths);
    void openReference(const QStringList &paths);
    void openReference(const QString &path) { openReference(QStringList(path)); }
    void openSample();
    void chooseFiles();                           ///< asks for a scene or a reference to open
    void chooseColumns(const QStringList &paths); ///< asks for the meaning of the columns of the files at `paths`

    void setTheme(slidercrank::Theme theme);
    void setNotation(const slidercrank::Notation &notation);

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    bool event(QEvent *event) override;

private:
    void connectDocument();
    void makeViews();
    void makeTabs();
    void connectMechanism();
    void connectPlots();

    TablePanel *makePanel(const QString &name, const QString &title, const std::function<Page()> &makePage);
    QWidget *makeMotionTable();
    QWidget *makeLimitsPanel();
    QWidget *makeNewtonPanel();

    void followReference(const std::shared_ptr<const Reference> &reference);
    void applyRemedy(const Finding &finding);
    void showTitle();
    void showResult(const std::shared_ptr<const Result> &result);

    Session *m_session;
    Views m_views;
    SceneFile *m_scene;
    Exports *m_exports;
    Presentation *m_presentation;
    StatusBar *m_status;
};

} // namespace slidercrank
