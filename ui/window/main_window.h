// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Constructs the rooms of the window, lays them out and connects them; no arithmetic.

#include "core/comparison/reference_pose.h"
#include "ui/document/session.h"
#include "ui/export/export_job.h"
#include "ui/export/figure_export.h"
#include "ui/reference/findings.h"
#include "ui/words/theme.h"

#include <QMainWindow>

class QAction;
class QMenu;
class QProgressBar;
class QSplitter;
class QTimer;
class QToolButton;

namespace slidercrank
{

class AnimationExport;
class ErrorPanel;
class FoldingTabs;
class MechanismView;
class MessageBar;
class ParameterPanel;
class PlotGrid;
class SceneFile;
class Timeline;

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget *parent = nullptr);
    ~MainWindow() override;

    Session &session() { return *m_session; }

    SceneFile &scene() { return *m_scene; }

public slots:
    /// A scene where it is named .json, else a reference.
    void openFile(const QString &path);
    void openReference(const QString &path);
    void openSample();

    /// Draws to a file (PNG, SVG or PDF by its suffix); a failure is told in the message bar.
    void exportFigureTo(const QString &path);
    void exportPlotTo(const QString &plotName, const QString &path);
    void exportMechanismTo(const QString &path);

    /// The run on show as CSV, off the GUI thread.
    void exportDataTo(const QString &path, const slidercrank::ChannelSet &channels);

    /// On A4, as PDF; whose motion the reference is, is worked out off the GUI thread first where it is not known yet.
    void exportReportTo(const QString &path);

    /// The mechanism moving through the run: numbered PNG frames, or a video where ffmpeg is installed.
    void exportAnimationTo(const QString &path);

    void setTheme(slidercrank::Theme theme);

protected:
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeRooms();
    void remakeRooms();
    void buildLayout();
    void buildMenus();
    void buildStatusBar();
    void connectRooms();
    QWidget *makeReferencePanel();
    QWidget *makeNewtonPanel();
    QWidget *makeStudyPanel();
    QWidget *makeLimitsPanel();

    void chooseReference();
    void chooseColumns(const QString &path); ///< of that file
    void exportTo(const QString &path, const QSize &size, const FigureDrawing &draw);
    QString chooseExportFile(const QString &proposal);
    void chooseData();
    void chooseReport();
    void chooseAnimation();
    void copyFigure();
    void copyPlot(const QString &plotName);
    void copyMechanism();
    void copy(const QSize &size, const FigureDrawing &draw, const QString &done);

    /// Runs work() in another thread, then, unless it failed or was cancelled, finish() in this one.
    void exportAside(const QString &path, const ExportJob::Work &work,
                     const std::function<std::optional<QString>()> &finish = {});
    void tellWritten(const QString &path, const QString &problem);
    void setBusy(bool busy); ///< counts

    void showTitle();
    void showStatus(const std::shared_ptr<const Result> &result);
    void showAgreement(const std::shared_ptr<const Result> &result);
    void announce(const std::shared_ptr<const Diagnosis> &diagnosis);
    void remedy(const Finding &finding);
    void findGhost();
    void showGhost();
    void rememberReference(const QString &path);
    void rememberLayout() const;
    void restoreLayout();
    void fillRecentMenu();
    void showAbout();
    void greetOnce();
    void greet();

    Session *m_session;
    QObjectList m_foundation; ///< what was there before the rooms
    MessageBar *m_messageBar = nullptr;
    MechanismView *m_mechanismView = nullptr;
    Timeline *m_timeline = nullptr;
    ParameterPanel *m_parameterPanel = nullptr;
    PlotGrid *m_plotGrid = nullptr;
    SceneFile *m_scene = nullptr;
    FoldingTabs *m_tabs = nullptr;
    ErrorPanel *m_errorPanel = nullptr;
    QProgressBar *m_progress = nullptr;
    QToolButton *m_cancelButton = nullptr;
    QTimer *m_busyTimer = nullptr;
    AnimationExport *m_animation = nullptr; ///< while one is written
    ExportJob *m_export = nullptr;          ///< while there is one
    int m_busy = 0;                         ///< what is under way and can be cancelled
    QMenu *m_recentMenu = nullptr;
    QAction *m_closeReferenceAction = nullptr;
    QAction *m_ghostAction = nullptr;
    std::function<ReferencePose(double)> m_ghost; ///< where the reference's linkage is at any instant; empty: not shown
    QString m_greeting;                           ///< as it was said; empty: it was not
    bool m_announceReference = false;             ///< the next diagnosis is the first of a newly loaded file
    bool m_isLeaving = false;                     ///< unsaved changes were asked about
    bool m_foldedByHand = false;                  ///< the person chose; a resize no longer does
};

} // namespace slidercrank
