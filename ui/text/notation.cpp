// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/notation.h"

#include "ui/text/channel_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <array>
#include <numbers>

namespace slidercrank
{

namespace
{

struct NotationText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::NotationText)
};

Notation &chosenNotation()
{
    static Notation chosen;
    return chosen;
}

/// The names or the symbols of a quantity and of its time derivatives.
struct NamesByOrder {
    QString position;
    QString velocity;
    QString acceleration;

    const QString &nameFor(Order order) const
    {
        switch (order) {
        case Order::Position: break;
        case Order::Velocity: return velocity;
        case Order::Acceleration: return acceleration;
        }
        return position;
    }
};

/// Returns the names of a quantity whose derivatives are not called velocity and acceleration.
NamesByOrder withDerivatives(const QString &name)
{
    return {name, NotationText::tr("%1, first derivative").arg(name),
            NotationText::tr("%1, second derivative").arg(name)};
}

NamesByOrder namesOf(DerivedQuantity quantity)
{
    switch (quantity) {
    case DerivedQuantity::TransmissionAngle: return withDerivatives(NotationText::tr("transmission angle"));
    case DerivedQuantity::Displacement:
        return withDerivatives(NotationText::tr("displacement from the outer dead centre"));
    case DerivedQuantity::PinX: break;
    case DerivedQuantity::PinY:
        return {NotationText::tr("crank pin A in y"), NotationText::tr("velocity of the crank pin A in y"),
                NotationText::tr("acceleration of the crank pin A in y")};
    }
    return {NotationText::tr("crank pin A in x"), NotationText::tr("velocity of the crank pin A in x"),
            NotationText::tr("acceleration of the crank pin A in x")};
}

NamesByOrder symbolsOf(DerivedQuantity quantity)
{
    switch (quantity) {
    case DerivedQuantity::TransmissionAngle: return {"μ", "dμ/dt", "d²μ/dt²"};
    case DerivedQuantity::Displacement: return {"s", "ds/dt", "d²s/dt²"};
    case DerivedQuantity::PinX: break;
    case DerivedQuantity::PinY: return {"A_y", "v_Ay", "a_Ay"};
    }
    return {"A_x", "v_Ax", "a_Ax"};
}

/// Returns the textbook's symbol of a coordinate of the coupler's centre of mass G₃.
QString centreSymbol(Channel channel)
{
    const NamesByOrder symbols =
        channel.coordinate == R3x ? NamesByOrder{"G_x", "v_Gx", "a_Gx"} : NamesByOrder{"G_y", "v_Gy", "a_Gy"};
    return symbols.nameFor(channel.order);
}

} // namespace

double crankSpeedFactor(CrankSpeedUnit unit)
{
    switch (unit) {
    case CrankSpeedUnit::RadianPerSecond: return 1.0;
    case CrankSpeedUnit::DegreePerSecond: return kDegreesPerRadian;
    case CrankSpeedUnit::TurnPerMinute: break;
    }
    return 30.0 / std::numbers::pi;
}

QString crankSpeedUnitText(CrankSpeedUnit unit)
{
    switch (unit) {
    case CrankSpeedUnit::RadianPerSecond: return NotationText::tr("rad/s");
    case CrankSpeedUnit::DegreePerSecond: return NotationText::tr("°/s");
    case CrankSpeedUnit::TurnPerMinute: break;
    }
    return NotationText::tr("rpm");
}

const Notation &notation()
{
    return chosenNotation();
}

void setNotation(const Notation &notation)
{
    chosenNotation() = notation;
}

ShownScale shownScale(const OutputChannel &channel, Branch branch, const Notation &chosen)
{
    const Measure measure = measureOf(channel);
    ShownScale scale{.factor = fromFileUnit(measure, 1.0, chosen.units)};
    if (chosen.symbols == Symbols::Textbook && channel == OutputChannel(Channel{Theta3, Order::Position})) {
        scale.offset = scale.factor * (branch == Branch::Open ? 180.0 : -180.0);
    }
    return scale;
}

std::optional<double> shownDifference(const OutputChannel &channel, std::optional<double> difference)
{
    return difference ? std::optional(fromFileUnit(measureOf(channel), *difference, notation().units)) : std::nullopt;
}

double shownChannel(const OutputChannel &channel, Branch branch, double value)
{
    return shownScale(channel, branch).shown(toFileUnit(measureOf(channel), value));
}

QString shownUnit(Measure measure)
{
    return unitText(measure, notation().units);
}

QString lengthText(double length, int digits)
{
    return withUnit(numberText(shownValue(Measure::Length, length, notation().units), digits),
                    shownUnit(Measure::Length));
}

QString symbolOf(const OutputChannel &channel)
{
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        const bool isCentre = coordinate->coordinate == R3x || coordinate->coordinate == R3y;
        return isCentre && notation().symbols == Symbols::Textbook ? centreSymbol(*coordinate)
                                                                   : symbolText(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    return symbolsOf(quantity).nameFor(order);
}

QString nameText(const OutputChannel &channel)
{
    if (const Channel *coordinate = std::get_if<Channel>(&channel)) {
        return quantityName(*coordinate);
    }
    const auto &[quantity, order] = std::get<DerivedChannel>(channel);
    return namesOf(quantity).nameFor(order);
}

} // namespace slidercrank
