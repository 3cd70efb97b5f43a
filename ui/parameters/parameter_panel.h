// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Sliders and boxes for a, b, c, ω₂, θ₂₀, and the choice of the assembly. Keeps every number exact: what is shown may
// be shortened, what was given is what comes back.

#include "core/mechanism/mechanism.h"

#include <QWidget>

#include <array>

class QComboBox;
class QGridLayout;
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
        ParameterSlider *slider = nullptr;
        NumberBox *box = nullptr;
        QComboBox *unit = nullptr; ///< null: mm
        QToolButton *reset = nullptr;
    };

    void addRow(QGridLayout *grid, Row &row);
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
    QComboBox *m_branch = nullptr;
};

} // namespace slidercrank
