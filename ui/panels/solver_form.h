// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The solver's settings, and what came of them: iterations, residual, and the instants it could not solve.

#include "ui/document/result.h"

#include <QWidget>

#include <memory>

class QBoxLayout;
class QComboBox;
class QLabel;

namespace slidercrank
{

class NumberBox;

class SolverForm : public QWidget
{
    Q_OBJECT

public:
    explicit SolverForm(QWidget *parent = nullptr);

public slots:
    /// Shows them; emits nothing.
    void setSolver(const slidercrank::SolverSettings &solver);
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);

signals:
    void edited(const slidercrank::SolverSettings &solver);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showSettings();
    void colourExplanation();
    void edit(const SolverSettings &solver);

    SolverSettings m_solver;
    QBoxLayout *m_beside = nullptr;
    QComboBox *m_method = nullptr;
    NumberBox *m_tolerance = nullptr;
    QComboBox *m_toleranceKind = nullptr;
    NumberBox *m_iterations = nullptr;
    QLabel *m_iterationsDone = nullptr;
    QLabel *m_residual = nullptr;
    QLabel *m_instants = nullptr;
    QLabel *m_explanation = nullptr;
};

} // namespace slidercrank
