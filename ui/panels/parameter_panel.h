// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slider, a box and a reset button for each of a, b, c, ω₂, θ₂₀. Numbers may be displayed shortened, but are stored
// exactly.

#include "core/import/quantity.h"
#include "core/mechanism/mechanism.h"
#include "ui/text/notation.h"

#include <QWidget>

#include <array>
#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace slidercrank
{

class NumberBox;
class ParameterSlider;
class Session;

class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterPanel(Session *session, QWidget *parent = nullptr);

    /// Shows the lengths and angles in the chosen units.
    void refreshNotation();

signals:
    void crankSpeedUnitChosen(slidercrank::CrankSpeedUnit unit);
    /// Emitted when the user clicks the name of a parameter that affects the limits of the motion.
    void responseRequested(slidercrank::Parameter parameter);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// A display unit and its conversion from and to the core's unit.
    struct ShownUnit {
        QString name;
        Unit unit;
        double range;                                 ///< initial range of the slider, to both sides of 0
        std::optional<CrankSpeedUnit> speedUnit = {}; ///< the same unit, if it is for the crank speed
        std::optional<AngleUnit> angleUnit = {};      ///< the same unit, if it is for angles

        bool isCoreUnit() const;
        double toCore(double value) const;
        double fromCore(double value) const;
    };

    struct Row {
        QString explanation;
        std::vector<ShownUnit> units;
        QLabel *label = nullptr;
        ParameterSlider *slider = nullptr;
        NumberBox *box = nullptr;
        QComboBox *unit = nullptr; ///< null if there is only one unit
        QToolButton *reset = nullptr;

        const ShownUnit &shownUnit() const;
        void showUnit(const std::function<bool(const ShownUnit &)> &isWanted); ///< selects the first wanted unit
    };

    static ShownUnit lengthUnit(Parameter length);
    void addRow(Parameter parameter, const QString &explanation, const std::vector<ShownUnit> &units);
    QLabel *makeLabel(Parameter parameter);
    ParameterSlider *makeSlider(Parameter parameter);
    NumberBox *makeBox(Parameter parameter);
    QComboBox *makeUnitBox(Parameter parameter);
    QToolButton *makeResetButton(Parameter parameter);
    QString spokenName(Parameter parameter) const;
    void useUnit(Parameter parameter);
    void edit(Parameter parameter, double value); ///< `value` is in the displayed unit
    void showParameters();
    void showRow(Parameter parameter);

    Session *m_session;
    std::array<Row, kParameterCount> m_rows;
    QGridLayout *m_grid;
    AngleUnit m_angleUnit = AngleUnit::Degree; ///< of the notation that is shown
};

} // namespace slidercrank
