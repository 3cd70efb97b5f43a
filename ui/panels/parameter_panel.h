// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slider, a box and a reset button for each of a, b, c, ω₂, θ₂₀. Keeps every number exact: what is shown may be shortened, what was given is what comes back.

#include "core/mechanism/mechanism.h"

#include <QWidget>

#include <array>
#include <memory>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class ParameterSlider;
struct ParameterText;
struct ShownUnit;

class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterPanel(QWidget *parent = nullptr);

    /// Only the parameter that is chosen in a list, instead of all of them.
    void setBrief(bool brief);

public slots:
    /// Shows them; emits nothing.
    void setParameters(const slidercrank::Parameters &parameters);

signals:
    /// Somebody moved, typed or reset. Only what can be used is emitted.
    void edited(const slidercrank::Parameters &parameters);

    /// A slider is pressed, is released: what is edited between belongs together.
    void dragBegan();
    void dragEnded();

    /// Somebody clicked the name of a parameter that the limits of the motion depend on.
    void responseRequested(slidercrank::Parameter parameter);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Row {
        Parameter parameter;
        std::shared_ptr<const ParameterText> text{};
        QLabel *label = nullptr;
        ParameterSlider *slider = nullptr;
        NumberBox *box = nullptr;
        QComboBox *unit = nullptr; ///< null: there is only one
        QToolButton *reset = nullptr;

        const ShownUnit &shownUnit() const;
    };

    void addRow(Row &row);
    void showParameters();
    void showRow(const Row &row);
    void showRows();
    void shade();

    /// Takes the number (in the core's unit) over if a mechanism can be made with it; else shows the old one again.
    void edit(const Row &row, double value);

    Parameters m_parameters;
    std::array<Row, 5> m_rows;
    QGridLayout *m_grid;
    QComboBox *m_chosen; ///< while brief: the row on show
    bool m_isBrief = false;
};

} // namespace slidercrank
