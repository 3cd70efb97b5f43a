// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sliders and boxes for a, b, c, ω₂, θ₂₀, and the choice of the assembly. Keeps every number exact: what is shown may
// be shortened, what was given is what comes back.

#include "core/mechanism/mechanism.h"

#include <QWidget>

#include <array>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class ParameterSlider;

class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterPanel(QWidget *parent = nullptr);

    /// One parameter at a time, the one that is chosen; else all of them.
    void setBrief(bool brief);

public slots:
    /// Shows them; emits nothing.
    void setParameters(const slidercrank::Parameters &parameters);

signals:
    /// Somebody moved, typed, reset or chose. Only what can be used is emitted.
    void edited(const slidercrank::Parameters &parameters);

    /// A slider is pressed, is let go: what is edited between belongs together.
    void dragBegan();
    void dragEnded();

private:
    struct Row {
        Parameter parameter;
        QLabel *label = nullptr;
        ParameterSlider *slider = nullptr;
        NumberBox *box = nullptr;
        QComboBox *unit = nullptr; ///< null: mm
        QToolButton *reset = nullptr;
    };

    void addRow(Row &row);
    void showBriefly();
    void showParameters();
    void showRow(const Row &row);
    void shadeForbidden();
    double sliderRangeFor(const Row &row, double value) const;

    /// Takes the number (in the core's unit) over if a mechanism can be made with it; else shows the old one again.
    void edit(const Row &row, double value);

    static double halfTurnOf(const Row &row); ///< π rad in the unit shown; 0: a length
    static double toUnitOf(const Row &row, double value);
    static double fromUnitOf(const Row &row, double value);

    Parameters m_parameters;
    std::array<Row, 5> m_rows;
    QLabel *m_branchLabel = nullptr;
    QComboBox *m_branch = nullptr;
    QGridLayout *m_grid = nullptr;
    QComboBox *m_chosen = nullptr; ///< while brief: the row on show
    bool m_isBrief = false;
};

} // namespace slidercrank
