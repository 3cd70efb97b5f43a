// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Newton-Raphson: the solver's settings at first, and behind them, for the instant on show, what it works with: the
// equations, their Jacobian, the iterations and the coordinates that come of them. Only what is on show is computed.

#include "core/mechanism/mechanism_part.h"
#include "ui/document/result.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QBoxLayout;
class QButtonGroup;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace slidercrank
{

class IterationPlot;
class NumberTable;
class SolverForm;

class NewtonPanel : public QWidget
{
    Q_OBJECT

public:
    explicit NewtonPanel(QWidget *parent = nullptr);

public slots:
    /// Shows them; emits nothing.
    void setSolver(const slidercrank::SolverSettings &solver);
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

signals:
    void rowsCopied(int count);
    void edited(const slidercrank::SolverSettings &solver);

    /// What the row under the mouse, or the current one, is about; None: nothing is pointed at.
    void partHovered(slidercrank::MechanismPart part);

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    enum Page { Settings, Equations, Jacobian, Iterations, Coordinates };

    void addPage(Page page, const QString &title, QWidget *widget, NumberTable *table);
    QWidget *createJacobianPage();
    QWidget *createIterationPage();
    void showPage(int page);
    void showLater(); ///< the instant, in a moment where the last one has only just been shown
    void fill();
    void fillIterations();
    void explain(Status status);
    void arrange();

    std::shared_ptr<const Result> m_result;
    double m_time = 0.0;
    bool m_stale = false; ///< what is on show is of another instant
    QTimer m_pause{this}; ///< runs while the last instant has only just been shown

    SolverForm *m_form = nullptr;
    QBoxLayout *m_beside = nullptr;
    QBoxLayout *m_segments = nullptr;
    QButtonGroup *m_buttons = nullptr;
    QToolButton *m_copy = nullptr;
    QLabel *m_remark = nullptr;
    QStackedWidget *m_pages = nullptr;
    std::vector<NumberTable *> m_tables; ///< a page; null: none
    NumberTable *m_jacobian = nullptr;
    QLabel *m_jacobianNote = nullptr;
    IterationPlot *m_plot = nullptr;
    NumberTable *m_iterations = nullptr;
};

} // namespace slidercrank
