// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/newton_tables.h"

#include "core/mechanism/channel.h"
#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

struct NewtonTables {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::NewtonTables)
};

QString symbolOf(Coordinate coordinate)
{
    return symbolOf(Channel{coordinate, Order::Position});
}

bool isAngle(Constraint row)
{
    return row == GroundAngle || row == SliderAngle || row == CrankDrive;
}

QString jointText(MechanismPart part)
{
    switch (part) {
    case MechanismPart::Ground: return NewtonTables::tr("ground");
    case MechanismPart::Crank: return NewtonTables::tr("crank");
    case MechanismPart::Coupler: return NewtonTables::tr("coupler");
    case MechanismPart::Slider: return NewtonTables::tr("slider");
    case MechanismPart::Pivot: return NewtonTables::tr("pivot O₂");
    case MechanismPart::PinA: return NewtonTables::tr("pin A");
    case MechanismPart::PinB: return NewtonTables::tr("pin B");
    case MechanismPart::Guide: return NewtonTables::tr("guide");
    case MechanismPart::Drive: return NewtonTables::tr("drive");
    case MechanismPart::None: break;
    }
    return {};
}

/// As in the report, bodies as superscripts.
QString equationOf(Constraint row)
{
    static const std::array<QString, kCoordinateCount> kEquations{
        QStringLiteral("Rₓ¹ = 0"),
        QStringLiteral("R_y¹ = 0"),
        QStringLiteral("θ¹ = 0"),
        QStringLiteral("Rₓ² − a/2 cos θ₂ = 0"),
        QStringLiteral("R_y² − a/2 sin θ₂ = 0"),
        QStringLiteral("−Rₓ³ + Rₓ² + a/2 cos θ₂ + b/2 cos θ³ = 0"),
        QStringLiteral("−R_y³ + R_y² + a/2 sin θ₂ + b/2 sin θ³ = 0"),
        QStringLiteral("Rₓ⁴ − Rₓ³ − b/2 cos θ³ = 0"),
        QStringLiteral("R_y⁴ − R_y³ − b/2 sin θ³ = 0"),
        QStringLiteral("θ⁴ − θ¹ = 0"),
        QStringLiteral("R_y⁴ − c = 0"),
        QStringLiteral("θ₂ − ω₂ t − θ₂₀ = 0")};
    return kEquations[static_cast<std::size_t>(row)];
}

TableCell textCell(const QString &text, const QString &explanation = {})
{
    return {.text = text, .explanation = explanation};
}

/// `perSecond`: the power of 1/s in the number's unit.
QString unitText(bool angle, int perSecond)
{
    static const std::array<QString, 3> kPer{QString(), QStringLiteral("/s"), QStringLiteral("/s²")};
    return (angle ? QStringLiteral("rad") : QStringLiteral("mm")) + kPer[static_cast<std::size_t>(perSecond)];
}

/// Every digit there is, for the tool tip.
QString everyDigit(double value)
{
    return numberText(value, QLocale::FloatingPointShortest);
}

TableCell numberCell(double value, const QString &text, const QString &meaning, const QString &unit)
{
    TableCell cell;
    if (!std::isfinite(value)) {
        cell.text = dash();
        cell.explanation = NewtonTables::tr("%1 does not exist here").arg(meaning);
        return cell;
    }
    cell.text = text;
    cell.number = value;
    cell.explanation = unit.isEmpty() ? NewtonTables::tr("%1 = %2").arg(meaning, everyDigit(value))
                                      : NewtonTables::tr("%1 = %2 %3").arg(meaning, everyDigit(value), unit);
    return cell;
}

/// So many decimals that a number of that size shows seven digits: the same ones while it moves.
QString steadyText(double value, double size)
{
    constexpr int kDigits = 7;
    const QLocale locale = localeWithoutGroups();
    if (value == 0.0 || !std::isfinite(value)) {
        return locale.toString(0);
    }
    if (!(size >= 1e-3 && size < 1e6)) {
        return shortNumber(value, kDigits);
    }
    const int decimals = std::max(0, kDigits - 1 - static_cast<int>(std::floor(std::log10(size))));
    const double least = 0.5 * std::pow(10.0, -decimals);
    return locale.toString(std::abs(value) < least ? 0.0 : value, 'f', decimals); // never -0.000
}

} // namespace

QString nameOf(Constraint row)
{
    const QString joint = jointText(partOf(row));
    switch (row) {
    case GroundX:
    case CrankPivotX:
    case CrankPinX:
    case SliderPinX: return NewtonTables::tr("%1, x").arg(joint);
    case GroundY:
    case CrankPivotY:
    case CrankPinY:
    case SliderPinY:
    case SliderLine: return NewtonTables::tr("%1, y").arg(joint);
    case GroundAngle:
    case SliderAngle: return NewtonTables::tr("%1, θ").arg(joint);
    case CrankDrive: return joint;
    }
    return {};
}

QString longestConstraintName()
{
    QString longest;
    for (Eigen::Index row = 0; row < kCoordinateCount; ++row) {
        const QString name = nameOf(static_cast<Constraint>(row));
        longest = name.size() > longest.size() ? name : longest;
    }
    return longest;
}

QString longestBodyName()
{
    QString longest;
    for (const MechanismPart body :
         {MechanismPart::Ground, MechanismPart::Crank, MechanismPart::Coupler, MechanismPart::Slider}) {
        const QString name = jointText(body);
        longest = name.size() > longest.size() ? name : longest;
    }
    return longest;
}

std::vector<TableColumn> equationColumns()
{
    return {
        {NewtonTables::tr("joint"), NewtonTables::tr("The joint that the equation is of"), QStringLiteral("joint"),
         false},
        {NewtonTables::tr("equation"),
         NewtonTables::tr("C(q, t) = 0, the bodies as superscripts: 1 ground, 2 crank, "
                          "3 coupler, 4 slider"),
         QStringLiteral("equation"), false},
        {NewtonTables::tr("C"), NewtonTables::tr("What is left of the equation now, in mm or rad"),
         QStringLiteral("C")},
        {NewtonTables::tr("Cₜ, per s"), NewtonTables::tr("∂C/∂t, in mm/s or rad/s: velocities follow from C_q q̇ = −Cₜ"),
         QStringLiteral("C_t")},
        {NewtonTables::tr("Q_d, per s²"),
         NewtonTables::tr("−(C_q q̇)_q q̇ − 2 C_qt q̇ − C_tt, in mm/s² or rad/s²: accelerations follow from C_q q̈ = Q_d"),
         QStringLiteral("Q_d")},
        {NewtonTables::tr("unit"), NewtonTables::tr("Of C; of Cₜ per s, of Q_d per s²"), QStringLiteral("unit"),
         false}};
}

std::vector<TableRow> equationRows(const InstantEquations &equations)
{
    constexpr int kDigits = 4;
    const auto text = [](double value) { return std::isfinite(value) ? shortNumber(value, kDigits) : dash(); };
    std::vector<TableRow> rows;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto row = static_cast<Constraint>(i);
        const bool angle = isAngle(row);
        const double C = equations.C[i];
        const double Ct = equations.Ct[i];
        const double Qd = equations.Qd[i];
        const QString number = QString::number(i + 1);
        rows.push_back({partOf(row),
                        {textCell(nameOf(row), NewtonTables::tr("Equation %1").arg(number)), textCell(equationOf(row)),
                         numberCell(C, text(C), NewtonTables::tr("C, row %1").arg(number), unitText(angle, 0)),
                         numberCell(Ct, text(Ct), NewtonTables::tr("Cₜ, row %1").arg(number), unitText(angle, 1)),
                         numberCell(Qd, text(Qd), NewtonTables::tr("Q_d, row %1").arg(number), unitText(angle, 2)),
                         textCell(unitText(angle, 0))}});
    }
    return rows;
}

std::vector<TableColumn> jacobianColumns()
{
    std::vector<TableColumn> columns{{NewtonTables::tr("C_q"),
                                      NewtonTables::tr("∂C/∂q: a row a constraint, a column a coordinate"),
                                      QStringLiteral("constraint"), false}};
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto coordinate = static_cast<Coordinate>(i);
        const QString part = jointText(partOf(coordinate));
        columns.push_back({symbolOf(coordinate),
                           isAngle(coordinate) ? NewtonTables::tr("Angle of the %1").arg(part)
                                               : NewtonTables::tr("Centre of mass of the %1").arg(part),
                           columnNameOf(Channel{coordinate, Order::Position})});
    }
    return columns;
}

std::vector<TableRow> jacobianRows(const Mechanism &mechanism, const InstantEquations &equations)
{
    constexpr double kUnity = 0.4; // the tint of ±1, beside that of lengths, which are coloured by their size
    constexpr double kFaintest = 0.1;
    const double largest = 0.5 * std::max(mechanism.a(), mechanism.b());
    std::vector<TableRow> rows;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto row = static_cast<Constraint>(i);
        TableRow shown{partOf(row), {textCell(nameOf(row), equationOf(row))}};
        for (Eigen::Index j = 0; j < kCoordinateCount; ++j) {
            const auto coordinate = static_cast<Coordinate>(j);
            const double value = equations.Cq(i, j);
            const bool isLength = isAngle(coordinate) && !isAngle(row); // mm/rad
            const QString text = isLength ? steadyText(value, 1e3 * largest) : numberText(value);
            TableCell cell =
                numberCell(value, text, NewtonTables::tr("∂(%1)/∂%2").arg(nameOf(row), symbolOf(coordinate)),
                           isLength ? QStringLiteral("mm") : QString());
            if (value == 0.0) {
                cell.text.clear();
                cell.explanation.clear();
            } else if (std::isfinite(value)) {
                const double strength =
                    isLength ? kFaintest + (1.0 - kFaintest) * std::min(1.0, std::abs(value) / largest) : kUnity;
                cell.tint = std::copysign(strength, value);
                cell.shortText = isLength ? shortNumber(value, 2) : text;
            }
            shown.cells.push_back(std::move(cell));
        }
        rows.push_back(std::move(shown));
    }
    return rows;
}

std::vector<TableColumn> coordinateColumns()
{
    return {
        {NewtonTables::tr("coordinate"), NewtonTables::tr("Centre of mass and angle of each body"),
         QStringLiteral("coordinate"), false},
        {NewtonTables::tr("body"), QString(), QStringLiteral("body"), false},
        {NewtonTables::tr("position"), NewtonTables::tr("q, in mm or °"), QStringLiteral("position")},
        {NewtonTables::tr("velocity, per s"), NewtonTables::tr("dq/dt, in mm/s or °/s"), QStringLiteral("velocity")},
        {NewtonTables::tr("acceleration, per s²"), NewtonTables::tr("d²q/dt², in mm/s² or °/s²"),
         QStringLiteral("acceleration")},
        {NewtonTables::tr("unit"),
         NewtonTables::tr("Of the position; of the velocity per s, of the acceleration "
                          "per s²"),
         QStringLiteral("unit"), false}};
}

std::vector<TableRow> coordinateRows(const Mechanism &mechanism, const State &state)
{
    std::vector<TableRow> rows;
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto coordinate = static_cast<Coordinate>(i);
        TableCell name = textCell(symbolOf(coordinate), columnNameOf(Channel{coordinate, Order::Position}));
        TableRow row{partOf(coordinate), {name, textCell(jointText(partOf(coordinate)))}};
        for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
            const Channel channel{coordinate, order};
            const Vector12 &values = order == Order::Position   ? state.q
                                     : order == Order::Velocity ? state.qDot
                                                                : state.qDDot;
            const double value = toFileUnit(channel, values[i]);
            row.cells.push_back(
                numberCell(value, steadyText(value, toFileUnit(channel, naturalSize(mechanism.parameters(), channel))),
                           symbolOf(channel), unitOf(channel)));
        }
        row.cells.push_back(textCell(unitOf(Channel{coordinate, Order::Position})));
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<TableColumn> iterationColumns()
{
    return {{NewtonTables::tr("step"), NewtonTables::tr("0: the start"), QStringLiteral("step"), true},
            {NewtonTables::tr("● ‖C‖"), NewtonTables::tr("From a rough start: θ₂ exact, θ³ = 0 (crossed: 180°)"),
             QStringLiteral("residual_from_afar")},
            {NewtonTables::tr("● θ³ [°]"), NewtonTables::tr("From a rough start: θ₂ exact, θ³ = 0 (crossed: 180°)"),
             QStringLiteral("theta3_from_afar")},
            {NewtonTables::tr("□ ‖C‖"), NewtonTables::tr("From the position one step of the run before"),
             QStringLiteral("residual_from_before")},
            {NewtonTables::tr("□ θ³ [°]"), NewtonTables::tr("From the position one step of the run before"),
             QStringLiteral("theta3_from_before")}};
}

std::vector<TableRow> iterationRows(const IterationHistory &fromAfar, const IterationHistory &fromBefore)
{
    constexpr int kDecimals = 10;
    const QLocale locale = localeWithoutGroups();
    std::vector<TableRow> rows;
    for (std::size_t k = 0; k < std::max(fromAfar.size(), fromBefore.size()); ++k) {
        TableCell step = textCell(QString::number(k));
        step.number = static_cast<double>(k);
        TableRow row{MechanismPart::None, {step}};
        for (const IterationHistory *history : {&fromAfar, &fromBefore}) {
            if (k >= history->size()) {
                row.cells.insert(row.cells.end(), 2, TableCell());
                continue;
            }
            const Iteration &iteration = (*history)[k];
            const double degrees = kDegreesPerRadian * iteration.q[Theta3];
            row.cells.push_back(numberCell(
                iteration.residual, std::isfinite(iteration.residual) ? shortNumber(iteration.residual, 3) : dash(),
                NewtonTables::tr("‖C‖"), QString()));
            row.cells.push_back(numberCell(degrees, locale.toString(degrees, 'f', kDecimals), QStringLiteral("θ³"),
                                           QStringLiteral("°")));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace slidercrank
