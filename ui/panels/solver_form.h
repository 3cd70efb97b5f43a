// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of the solver and its outcome: iterations, residual, and the time steps that could not be solved.

#include "ui/document/result.h"

#include <QWidget>

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

    // These functions show the values and emit nothing.
    void setSolver(const SolverSettings &solver);
    void setResult(const Result &result);

signals:
    void edited(const slidercrank::SolverSettings &solver);

private:
    void edit();

    SolverSettings m_solver;
    QComboBox *m_method;
    NumberBox *m_tolerance;
    QComboBox *m_toleranceKind;
    NumberBox *m_iterations;
    QLabel *m_outcome;
    QLabel *m_warnings;
};

} // namespace slidercrank
