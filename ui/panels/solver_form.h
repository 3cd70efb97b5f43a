// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of the solver and its outcome: iterations, residual, and the time steps that could not be solved.

#include <QWidget>

class QComboBox;
class QLabel;

namespace slidercrank
{

class NumberBox;
class Session;
struct Result;

/// Returns how the motion was computed, in one line: method, iterations, residual, time steps that are not solved. The
/// text is empty if there is nothing to say.
QString samplingText(const Result &result);

class SolverForm : public QWidget
{
    Q_OBJECT

public:
    explicit SolverForm(Session *session, QWidget *parent = nullptr);

private:
    QLayout *makeFields();
    void showSettings();
    void edit(); ///< gives the session the values of the fields

    Session *m_session;
    QComboBox *m_method;
    NumberBox *m_tolerance;
    QComboBox *m_toleranceKind;
    NumberBox *m_maxIterations;
    QLabel *m_outcome;
};

} // namespace slidercrank
