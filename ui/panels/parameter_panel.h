// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slider, a box and a reset button for each of a, b, c, ω₂, θ₂₀. Numbers may be displayed shortened, but are stored
// and emitted exactly.

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

    /// Shows only the parameter that is chosen in a list instead of all of them.
    void setBrief(bool brief);

public slots:
    /// Shows the parameters and emits nothing.
    void setParameters(const slidercrank::Parameters &parameters);

signals:
    /// The user changed a parameter. Only valid parameters are emitted.
    void edited(const slidercrank::Parameters &parameters);

    /// A slider was pressed or released: the edits in between form one undo step.
    void dragBegan();
    void dragEnded();

    /// The user clicked the name of a parameter that affects the limits of the motion.
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
        QComboBox *unit = nullptr; ///< null if there is only one unit
        QToolButton *reset = nullptr;

        const ShownUnit &shownUnit() const;
    };

    void addRow(Row &row);
    void showParameters();
    void showRow(const Row &row);
    void showRows();
    void shade();

    /// Uses the number (in the core's unit) if the parameters are then valid; otherwise shows the previous one again.
    void edit(const Row &row, double value);

    Parameters m_parameters;
    std::array<Row, 5> m_rows;
    QGridLayout *m_grid;
    QComboBox *m_chosen; ///< the row that is shown while the panel is brief
    bool m_isBrief = false;
};

} // namespace slidercrank
