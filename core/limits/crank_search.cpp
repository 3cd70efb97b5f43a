// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/crank_search.h"

#include "core/closed_form/motion_constants.h"
#include "core/limits/critical_points.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

/// A quantity of the form factor · f(θ2) + constant, where f is one of the functions of the crank angle. Its
/// derivatives have no constant part.
struct ScaledFunction {
    CrankFunction function = CrankFunction::CouplerAngle;
    double factor = 1.0;
    double constant = 0.0;
};

/// Returns nullopt for the crank angle and for coordinates that are constant.
std::optional<ScaledFunction> scaledFunction(const Mechanism &mechanism, Coordinate coordinate)
{
    switch (coordinate) {
    case R2x: return ScaledFunction{.function = CrankFunction::PinX, .factor = 0.5};
    case R2y: return ScaledFunction{.function = CrankFunction::PinY, .factor = 0.5};
    case R3x: return ScaledFunction{CrankFunction::CouplerCentreX};
    case R3y: return ScaledFunction{.function = CrankFunction::PinY, .factor = 0.5, .constant = 0.5 * mechanism.c()};
    case Theta3: return ScaledFunction{CrankFunction::CouplerAngle};
    case R4x: return ScaledFunction{CrankFunction::SliderPosition};
    case R1x:
    case R1y:
    case Theta1:
    case Theta2:
    case R4y:
    case Theta4: break;
    }
    return std::nullopt;
}

/// Returns nullopt for the transmission angle, which is no multiple of one function: see transmissionSolutions().
std::optional<ScaledFunction> scaledFunction(const Mechanism &mechanism, DerivedQuantity quantity)
{
    switch (quantity) {
    case DerivedQuantity::PinX: return ScaledFunction{CrankFunction::PinX};
    case DerivedQuantity::PinY: return ScaledFunction{CrankFunction::PinY};
    case DerivedQuantity::Displacement: {
        const MotionConstants k(mechanism);
        return ScaledFunction{
            .function = CrankFunction::SliderPosition, .factor = -k.branch, .constant = std::sqrt(k.reach * k.gamma)};
    }
    case DerivedQuantity::TransmissionAngle: break;
    }
    return std::nullopt;
}

std::optional<ScaledFunction> scaledFunction(const Mechanism &mechanism, const OutputChannel &channel)
{
    if (const DerivedChannel *derived = std::get_if<DerivedChannel>(&channel)) {
        return scaledFunction(mechanism, derived->quantity);
    }
    return scaledFunction(mechanism, std::get<Channel>(channel).coordinate);
}

/// Returns the critical points of the channel for ω2 = 1 rad/s, each of them once. `accelerationRatio`: α2/ω2².
CriticalPoints findCriticalPointsOfChannel(const Mechanism &mechanism, const ScaledFunction &scaled, Order order,
                                           double accelerationRatio)
{
    constexpr double kAngleTolerance = 1e-10; // rad
    constexpr double kValueTolerance = 1e-12; // relative
    const CrankCurve curve{.function = scaled.function,
                           .order = order,
                           .accelerationRatio = order == Order::Acceleration ? accelerationRatio : 0.0};
    CriticalPoints points;
    const std::vector<CriticalPoints> pointsOfCurves = findCriticalPoints(mechanism, std::span(&curve, 1));
    for (CriticalPoint point : pointsOfCurves.front()) { // there is one curve
        point.value = scaled.factor * point.value + (order == Order::Position ? scaled.constant : 0.0);
        const bool isRepeated = !points.empty() && point.kind == points.back().kind &&
                                point.theta2 - points.back().theta2 < kAngleTolerance &&
                                std::abs(point.value - points.back().value) <= kValueTolerance * std::abs(point.value);
        if (!isRepeated) {
            points.push_back(point);
        }
    }
    return points;
}

/// Sorts the crank angles and removes repeated ones. A solution at a toggle is found twice, with angles that differ by
/// rounding: in the motion before the toggle and in the motion after it.
void sortWithoutRepetition(std::vector<double> &angles)
{
    constexpr double kAngleTolerance = 1e-14; // rad
    std::ranges::sort(angles);
    const auto areEqual = [](double x, double y) { return y - x < kAngleTolerance; };
    angles.erase(std::unique(angles.begin(), angles.end(), areEqual), angles.end());
}

bool canBeAssembled(const Mechanism &mechanism, double theta2)
{
    return !std::isnan(outputStateAt(withCrankAt(mechanism, theta2), 0.0).state.q[R4x]);
}

/// Solves channel(θ2) = value for ω2 = 1 rad/s. `accelerationRatio`: α2/ω2².
class Solver
{
public:
    Solver(const Mechanism &mechanism, const OutputChannel &channel, double value, double accelerationRatio)
        : m_mechanism(mechanism)
        , m_channel(channel)
        , m_value(value)
        , m_accelerationRatio(accelerationRatio)
        , m_naturalSize(isAngular(measureOf(channel)) ? 1.0 : characteristicLength(mechanism.parameters()))
    {
        if (orderOf(channel) == Order::Acceleration) {
            m_naturalSize *= std::max(1.0, std::abs(accelerationRatio));
        }
    }

    /// Returns the solutions in [-π, π), ascending. `points`: the critical points of the channel. A solution is a
    /// critical point itself, or lies between two successive ones.
    std::vector<double> solve(const CriticalPoints &points) const
    {
        std::vector<double> solutions;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const CriticalPoint &point = points[i];
            const CriticalPoint previous = i > 0 ? points[i - 1] : turned(points.back(), -kTurn);
            const CriticalPoint next = i + 1 < points.size() ? points[i + 1] : turned(points.front(), kTurn);
            const double difference = differenceAt(point.value);
            if (difference == 0.0) {
                const bool isInsideConstantArc = isKeptBetween(previous, point) && isKeptBetween(point, next);
                if (!isInsideConstantArc) {
                    solutions.push_back(angleInsideMotion(point));
                }
            } else if (point.kind != CriticalPoint::Kind::End && difference * differenceAt(next.value) < 0.0) {
                solutions.push_back(wrapToPi(bisect(point, next)));
            }
        }
        sortWithoutRepetition(solutions);
        return solutions;
    }

private:
    /// Returns the same point one revolution later or earlier.
    static CriticalPoint turned(CriticalPoint point, double angle)
    {
        point.theta2 += angle;
        return point;
    }

    double valueAt(double theta2) const
    {
        return outputStateAt(withDrive(m_mechanism, 1.0, theta2), 0.0, m_accelerationRatio).valueOf(m_channel);
    }

    /// Returns whether the channel keeps the wanted value from one critical point to the next.
    bool isKeptBetween(const CriticalPoint &from, const CriticalPoint &to) const
    {
        return differenceAt(from.value) == 0.0 && differenceAt(to.value) == 0.0 &&
               differenceAt(valueAt(std::midpoint(from.theta2, to.theta2))) == 0.0;
    }

    /// Returns a value minus the wanted one, or 0 if the difference is only a rounding error.
    double differenceAt(double value) const
    {
        constexpr double kRounding = 8.0 * kEpsilon;
        const double difference = value - m_value;
        const double size = std::max(std::abs(m_value), m_naturalSize);
        return std::abs(difference) <= kRounding * size ? 0.0 : difference;
    }

    /// Returns the crank angle between two successive critical points at which the channel passes the value.
    double bisect(const CriticalPoint &from, const CriticalPoint &to) const
    {
        double low = from.theta2;
        double high = to.theta2;
        const bool startsBelow = from.value < m_value;
        for (double middle = std::midpoint(low, high); low < middle && middle < high;
             middle = std::midpoint(low, high)) {
            const double value = valueAt(middle);
            // Because of rounding, the mechanism may be impossible to assemble beside an end of the motion. Then the
            // nearer one of the two points decides.
            const bool isBeforeSolution =
                std::isnan(value) ? middle - from.theta2 < to.theta2 - middle : (value < m_value) == startsBelow;
            (isBeforeSolution ? low : high) = middle;
        }
        return std::isnan(valueAt(low)) ? high : low;
    }

    /// Returns the crank angle of the point. At a limit of the motion, where the rounded angle may be impossible to
    /// assemble, returns the nearest one within the motion.
    double angleInsideMotion(const CriticalPoint &point) const
    {
        constexpr double kStep = 2.0 * kEpsilon; // rad: the last place of an angle near π
        constexpr int kMaxSteps = 16;            // the rounding error of the angle is smaller
        const double inwards = point.kind == CriticalPoint::Kind::End ? -kStep : kStep;
        double theta2 = point.theta2;
        for (int i = 0; i < kMaxSteps && !canBeAssembled(m_mechanism, theta2); ++i) {
            theta2 += inwards;
        }
        return theta2;
    }

    const Mechanism &m_mechanism;
    const OutputChannel &m_channel;
    double m_value;
    double m_accelerationRatio; ///< α2/ω2², the acceleration of the crank for ω2 = 1 rad/s
    double m_naturalSize;       ///< of the channel; rounding errors of smaller values are measured against it
};

std::vector<double> solutionsOf(const Mechanism &mechanism, const OutputChannel &channel, const ScaledFunction &scaled,
                                double value, double accelerationRatio)
{
    return Solver(mechanism, channel, value, accelerationRatio)
        .solve(findCriticalPointsOfChannel(mechanism, scaled, orderOf(channel), accelerationRatio));
}

/// Returns the solutions for the transmission angle μ, or a derivative of it. With the angle φ = asin(h/b) of the
/// coupler to the slider's line, which is θ3 on the open branch and π - θ3 on the crossed one, μ is π/2 - φ where φ > 0
/// and π/2 + φ where φ < 0. So there are two searches for θ3, each of which keeps the solutions on its side.
std::vector<double> transmissionSolutions(const Mechanism &mechanism, Order order, double value,
                                          double accelerationRatio)
{
    const bool isPosition = order == Order::Position;
    const bool isOpen = mechanism.branch() == Branch::Open;
    const Channel theta3{Theta3, order};
    std::vector<double> solutions;
    for (const double side : {1.0, -1.0}) { // the sign of φ
        // The φ, or derivative of φ, that gives the value, and the θ3 that gives this φ.
        const double elevation = isPosition ? side * (kQuarterTurn - value) : -side * value;
        const double straightAngle = isPosition ? std::numbers::pi : 0.0;
        const double angle = isOpen ? elevation : straightAngle - elevation;
        for (const double theta2 :
             solutionsOf(mechanism, theta3, {CrankFunction::CouplerAngle}, angle, accelerationRatio)) {
            const double height = mechanism.c() - mechanism.a() * std::sin(theta2);
            const bool isOnThisSide = side * height > 0.0;
            const bool isBetweenSides = isPosition && elevation == 0.0;
            if (isOnThisSide || (isBetweenSides && side > 0.0)) {
                solutions.push_back(theta2);
            }
        }
    }
    sortWithoutRepetition(solutions);
    return solutions;
}

/// Returns the angle of the same direction that is nearest to 0 on the open branch, and to 180° on the crossed one: θ3
/// is within 90° of it.
double asCouplerAngle(const Mechanism &mechanism, double angle)
{
    const double centre = mechanism.branch() == Branch::Open ? 0.0 : std::numbers::pi;
    return angle - kTurn * std::round((angle - centre) / kTurn);
}

/// As crankAnglesAt(), but for ω2 = 1 rad/s: `value` is the value divided by ω2ᵏ for the k-th derivative, and
/// `accelerationRatio` is α2/ω2².
std::optional<std::vector<double>> solutionsAtUnitSpeed(const Mechanism &mechanism, const OutputChannel &channel,
                                                        double value, double accelerationRatio)
{
    const Order order = orderOf(channel);
    if (const DerivedChannel *derived = std::get_if<DerivedChannel>(&channel)) {
        const std::optional<ScaledFunction> scaled = scaledFunction(mechanism, derived->quantity);
        return scaled ? solutionsOf(mechanism, channel, *scaled, value, accelerationRatio)
                      : transmissionSolutions(mechanism, order, value, accelerationRatio);
    }
    const Coordinate coordinate = std::get<Channel>(channel).coordinate;
    if (coordinate == Theta2 && order == Order::Position) {
        const double theta2 = wrapToPi(value);
        return canBeAssembled(mechanism, theta2) ? std::vector{theta2} : std::vector<double>();
    }
    if (coordinate == Theta3 && order == Order::Position) {
        value = asCouplerAngle(mechanism, value);
    }
    const std::optional<ScaledFunction> scaled = scaledFunction(mechanism, coordinate);
    return scaled ? std::optional(solutionsOf(mechanism, channel, *scaled, value, accelerationRatio)) : std::nullopt;
}

} // namespace

std::optional<std::vector<double>> crankAnglesAt(const Mechanism &mechanism, const OutputChannel &channel, double value,
                                                 double alpha2)
{
    const Order order = orderOf(channel);
    const double omega2 = mechanism.omega2();
    const bool startsFromRest = omega2 == 0.0 && order == Order::Acceleration && alpha2 != 0.0;
    if (startsFromRest) { // the acceleration f'' ω2² + f' α2 is α2 times f', the velocity for ω2 = 1 rad/s
        return solutionsAtUnitSpeed(mechanism, withOrder(channel, Order::Velocity), value / alpha2, 0.0);
    }
    const double driveFactor = std::pow(omega2, static_cast<int>(order));
    if (driveFactor == 0.0) {
        return std::nullopt;
    }
    return solutionsAtUnitSpeed(mechanism, channel, value / driveFactor,
                                order == Order::Acceleration ? alpha2 / (omega2 * omega2) : 0.0);
}

std::optional<ChannelRange> rangeOf(const Mechanism &mechanism, const OutputChannel &channel, double alpha2)
{
    const std::optional<ScaledFunction> scaled = scaledFunction(mechanism, channel);
    const Order order = orderOf(channel);
    const double omega2 = mechanism.omega2();
    // If ω2 = 0, the acceleration f'' ω2² + f' α2 is α2 times f', so that the critical points are those of a velocity.
    const bool isAtRest = omega2 == 0.0 && order == Order::Acceleration;
    const double driveFactor = isAtRest ? alpha2 : std::pow(omega2, static_cast<int>(order));
    if (!scaled || driveFactor == 0.0) {
        return std::nullopt;
    }
    const CriticalPoints points =
        isAtRest ? findCriticalPointsOfChannel(mechanism, *scaled, Order::Velocity, 0.0)
                 : findCriticalPointsOfChannel(mechanism, *scaled, order, alpha2 / (omega2 * omega2));
    if (points.empty()) {
        return std::nullopt;
    }
    const auto [least, greatest] = std::ranges::minmax(points, {}, &CriticalPoint::value);
    const auto [low, high] = std::minmax({driveFactor * least.value, driveFactor * greatest.value});
    return ChannelRange{low, high};
}

std::optional<double> crankSpeedFor(const Mechanism &mechanism, double theta2, const OutputChannel &channel,
                                    double value)
{
    constexpr double kRounding = 1e-15; // a coefficient that is zero except for rounding
    const double coefficient = outputStateAt(withDrive(mechanism, 1.0, theta2), 0.0).valueOf(channel);
    const double size = isAngular(measureOf(channel)) ? 1.0 : characteristicLength(mechanism.parameters());
    return std::abs(coefficient) > kRounding * size ? std::optional(value / coefficient) : std::nullopt;
}

} // namespace slidercrank
