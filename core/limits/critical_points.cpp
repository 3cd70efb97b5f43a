// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/critical_points.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr double kBesideToggle = 1e-15; // rad: distance from a toggle at which the motion just beside it is examined

/// A function and its first three derivatives by the crank angle.
using Derivatives = std::array<double, 4>;

/// All functions at one crank angle, with their derivatives.
struct FunctionValues {
    std::array<Derivatives, kCrankFunctionCount> functions; ///< indexed by CrankFunction

    double value(const CrankCurve &curve) const { return valueAt(curve, static_cast<std::size_t>(curve.order)); }
    double slope(const CrankCurve &curve) const { return valueAt(curve, static_cast<std::size_t>(curve.order) + 1); }

private:
    /// Returns the derivative of that order of f, with the term of the crank acceleration.
    double valueAt(const CrankCurve &curve, std::size_t order) const
    {
        const Derivatives &f = functions[static_cast<std::size_t>(curve.function)];
        return curve.accelerationRatio == 0.0 ? f[order] : f[order] + curve.accelerationRatio * f[order - 1];
    }
};

/// The motion near the centre, a crank angle of ±90°, at which the coupler is steepest. The gap is the excess of the
/// coupler length over the length required to pass the centre, divided by a; so b cos θ3 ∝ √(gap + φ²/2) at the
/// distance φ (rad) from the centre. The variable u stretches the motion there. If the mechanism passes the centre,
/// φ = w sinh u with w = √(2·gap), at most 1: then every feature of the motion has a width of about one unit of u,
/// however small the gap is. If the mechanism does not pass the centre, it comes as near as φ₀, with cos φ₀ = 1 + gap,
/// and φ = ±φ₀ cosh u has the same effect. At an exact toggle, where the gap is 0, w = 1.
class SteepRegion
{
public:
    SteepRegion(const Mechanism &mechanism, double centre, double gap)
        : m_a(mechanism.a())
        , m_c(mechanism.c())
        , m_centre(centre)
        , m_gap(gap)
        , m_width(widthFor(gap))
        , m_motion(withDrive(mechanism, 1.0, centre))
    {
    }

    /// Returns the smallest |φ| that the motion reaches.
    double smallestDistance() const { return m_gap < 0.0 ? m_width : 0.0; }

    bool isPassed() const { return m_gap > 0.0; }
    bool isToggle() const { return m_gap == 0.0; }

    double phi(double u) const
    {
        return m_gap < 0.0 ? std::copysign(m_width * std::cosh(u), u) : m_width * std::sinh(u);
    }
    double uAt(double phi) const { return m_gap < 0.0 ? std::acosh(phi / m_width) : std::asinh(phi / m_width); }
    double theta2(double u) const { return wrapToPi(m_centre + phi(u)); }

    // With s = b cos θ3, h = c - a sin θ2 and ' for d/dθ2:
    //     s θ3' = -a cos θ2             s' θ3' + s θ3'' = a sin θ2        s'' θ3' + 2 s' θ3'' + s θ3''' = a cos θ2
    //     s s'  = a h cos θ2            s s''' + 3 s' s'' = a cos θ2 (3 a sin θ2 - h)
    FunctionValues functionsAt(double u) const
    {
        const Motion motion = m_motion.motionAt(phi(u)); // ω2 = 1: the angle is the time
        const double aSin = m_a * motion.crank.sin;
        const double aCos = m_a * motion.crank.cos;
        const double sJerk = (aCos * (4.0 * aSin - m_c) - 3.0 * motion.sDot * motion.sDDot) / motion.s;
        const double theta3Jerk =
            (aCos - motion.sDDot * motion.theta3Dot - 2.0 * motion.sDot * motion.theta3DDot) / motion.s;
        const Derivatives theta3{motion.theta3, motion.theta3Dot, motion.theta3DDot, theta3Jerk};
        const Derivatives slider{motion.R4x, motion.R4xDot, motion.R4xDDot, aSin + sJerk};
        const Derivatives coupler{aCos + 0.5 * motion.s, -aSin + 0.5 * motion.sDot, -aCos + 0.5 * motion.sDDot,
                                  aSin + 0.5 * sJerk};
        return {
            {theta3, slider, coupler, Derivatives{aCos, -aSin, -aCos, aSin}, Derivatives{aSin, aCos, -aSin, -aCos}}};
    }

    /// Returns the value of the curve at φ = φ₀ for u > 0, or at φ = -φ₀ for u < 0. Requires a negative gap. There the
    /// coupler is perpendicular to the slider's line: A, B and the middle of the coupler have the same x, and the
    /// derivatives of the coupler and of the slider are infinite, with the sign that they have at u.
    double valueAtLimit(const CrankCurve &curve, double u) const
    {
        const double sinPhi = std::copysign(std::sqrt(-m_gap * (2.0 + m_gap)), u);
        const double cosPhi = 1.0 + m_gap;
        const double sinCentre = std::copysign(1.0, m_centre);
        const double pinX = -m_a * sinCentre * sinPhi;
        const double pinY = m_a * sinCentre * cosPhi;
        const double theta3 = kQuarterTurn * std::round(m_motion.motionAt(phi(u)).theta3 / kQuarterTurn);
        const FunctionValues atLimit{{Derivatives{theta3}, Derivatives{pinX}, Derivatives{pinX},
                                      Derivatives{pinX, -pinY, -pinX, pinY}, Derivatives{pinY, pinX, -pinY, -pinX}}};
        const bool isOfCrank = curve.function == CrankFunction::PinX || curve.function == CrankFunction::PinY;
        const bool isFinite = isOfCrank || curve.order == Order::Position;
        return isFinite ? atLimit.value(curve) : std::copysign(kInfinity, functionsAt(u).value(curve));
    }

private:
    /// Returns w, or φ₀ if the mechanism does not pass the centre.
    static double widthFor(double gap)
    {
        if (gap > 0.0) {
            return std::min(1.0, std::sqrt(2.0 * gap));
        }
        return gap < 0.0 ? 2.0 * std::asin(std::sqrt(-0.5 * gap)) : 1.0;
    }

    double m_a;
    double m_c;
    double m_centre;
    double m_gap;
    double m_width;
    ClosedForm m_motion;
};

/// The curves whose critical points are searched, and the points that have been found of each.
class PointSearch
{
public:
    explicit PointSearch(std::span<const CrankCurve> curves)
        : m_curves(curves)
        , m_points(curves.size())
    {
    }

    /// Adds all critical points with |φ| <= reach.
    void addPoints(const SteepRegion &region, double reach)
    {
        const double end = region.uAt(reach);
        if (region.isPassed()) {
            addExtrema(region, -end, end);
            return;
        }
        // The search begins at this |u|: nearer to the limit the crank angle has too few digits.
        constexpr double kBesideLimit = 1e-6;
        const double start = region.isToggle()
                                 ? kBesideToggle
                                 : std::max(kBesideLimit, std::sqrt(4.0 * kBesideToggle / region.smallestDistance()));
        for (const double side : {-1.0, 1.0}) {
            addOneSidedLimits(region, side * start);
            addExtrema(region, std::min(side * start, side * end), std::max(side * start, side * end));
        }
    }

    /// Returns the points of each curve, ascending.
    std::vector<CriticalPoints> sorted()
    {
        for (CriticalPoints &points : m_points) {
            std::ranges::stable_sort(points, {}, &CriticalPoint::theta2);
        }
        return std::move(m_points);
    }

private:
    /// Adds the extrema between two values of u, by bisecting each cell in which a slope changes its sign. A cell is so
    /// short that it contains at most one extremum of a curve: every feature of the motion is about one unit of u wide.
    void addExtrema(const SteepRegion &region, double from, double to)
    {
        constexpr double kCellLength = 0.1; // units of u
        constexpr int kMinCells = 16;
        const int cells = std::max(kMinCells, static_cast<int>(std::ceil((to - from) / kCellLength)));
        double left = from;
        FunctionValues atLeft = region.functionsAt(left);
        for (int i = 1; i <= cells; ++i) {
            const double right = from + (to - from) * i / cells;
            const FunctionValues atRight = region.functionsAt(right);
            for (std::size_t k = 0; k < m_curves.size(); ++k) {
                if ((atLeft.slope(m_curves[k]) < 0.0) != (atRight.slope(m_curves[k]) < 0.0)) {
                    addExtremum(region, left, right, k);
                }
            }
            left = right;
            atLeft = atRight;
        }
    }

    /// Adds the extremum between two values of u at which the slope of the curve has opposite signs.
    void addExtremum(const SteepRegion &region, double low, double high, std::size_t curve)
    {
        const auto fallsAt = [&](double u) { return region.functionsAt(u).slope(m_curves[curve]) < 0.0; };
        const bool fallsAtLow = fallsAt(low);
        for (double u = std::midpoint(low, high); low < u && u < high; u = std::midpoint(low, high)) {
            (fallsAt(u) == fallsAtLow ? low : high) = u;
        }
        const double value = region.functionsAt(high).value(m_curves[curve]);
        if (std::isfinite(value)) {
            m_points[curve].push_back(
                {.theta2 = region.theta2(high), .value = value, .kind = CriticalPoint::Kind::Extremum});
        }
    }

    /// Adds the points at which the curves begin (u > 0) or end (u < 0), at an exact toggle or a limit of a rocker.
    void addOneSidedLimits(const SteepRegion &region, double u)
    {
        const double theta2 = region.theta2(region.isToggle() ? u : std::copysign(0.0, u));
        for (std::size_t k = 0; k < m_curves.size(); ++k) {
            m_points[k].push_back({.theta2 = theta2,
                                   .value = region.isToggle() ? region.functionsAt(u).value(m_curves[k])
                                                              : region.valueAtLimit(m_curves[k], u),
                                   .kind = u > 0.0 ? CriticalPoint::Kind::Begin : CriticalPoint::Kind::End});
        }
    }

    std::span<const CrankCurve> m_curves;
    std::vector<CriticalPoints> m_points;
};

} // namespace

std::vector<CriticalPoints> findCriticalPoints(const Mechanism &mechanism, std::span<const CrankCurve> curves)
{
    PointSearch search(curves);
    const MotionConstants k(mechanism);
    // The crank angle at which A is farthest from the slider's line: p = ε, and m = β opposite (motion_constants.h).
    const double farthest = -k.side * kQuarterTurn;
    const SteepRegion farRegion(mechanism, farthest, k.epsilon / k.a);
    const SteepRegion nearRegion(mechanism, -farthest, k.beta / k.a);
    // The searches in the two regions meet half way and overlap a little, so that no extremum is missed, although some
    // are found twice.
    const double half = 0.5 * (0.5 * kTurn - farRegion.smallestDistance() - nearRegion.smallestDistance());
    if (half > 0.0) { // otherwise the mechanism cannot be assembled, or is locked
        const double overlap = std::min(0.1, 0.1 * half);
        search.addPoints(farRegion, farRegion.smallestDistance() + half + overlap);
        search.addPoints(nearRegion, nearRegion.smallestDistance() + half + overlap);
    }
    return search.sorted();
}

std::array<CriticalPoints, kPlottedChannels.size()> findCriticalPoints(const Mechanism &mechanism)
{
    std::array<CrankCurve, kPlottedChannels.size()> curves;
    std::ranges::transform(kPlottedChannels, curves.begin(), [](Channel channel) {
        const bool isCoupler = channel.coordinate == Theta3;
        return CrankCurve{.function = isCoupler ? CrankFunction::CouplerAngle : CrankFunction::SliderPosition,
                          .order = channel.order};
    });
    std::array<CriticalPoints, kPlottedChannels.size()> points;
    std::ranges::move(findCriticalPoints(mechanism, curves), points.begin());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double factor = std::pow(mechanism.omega2(), static_cast<int>(kPlottedChannels[i].order));
        for (CriticalPoint &point : points[i]) {
            point.value *= factor;
        }
    }
    return points;
}

} // namespace slidercrank
