// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/design.h"

#include "core/mechanism/mechanism.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// In the dead centres crank and coupler lie in one line: the wrist pin B is at the distances b + a and b - a from the
// crank pivot, on two rays that enclose the angle α. While the crank turns by π + α the slider makes one stroke, by π -
// α the other. So the time ratio Q gives
//
//     α = π (Q - 1) / (Q + 1)
//
// The triangle of the pivot and the two dead centres has the sides b + a, b - a and the stroke s, and the height |c|.
// With p = α/2 the law of cosines and the area give
//
//     s²/4 = a² cos² p + b² sin² p        |c| s = (b² - a²) sin α
//
// which leaves the ratio r = b/a free. Both dead centres lie on one side of the pivot if s² <= 4ab, that is
// r² sin² p - r + cos² p <= 0, or
//
//     1 <= r <= cot² p
//
// There is an r in this range if p < 45°, that is Q < 3; and then b >= a + |c|: the crank makes full turns. The minimum
// transmission angle μ follows from
//
//     cos μ = (a + |c|) / b = (1 + sin p (r² - 1) / √(1 + k² r²)) / r        k = tan p
//
// μ is 0 at both ends of the range and largest where the derivative vanishes between them: with R = r²
//
//     k² (1 + k²) R² - k² R - 1 = 0
//
// With a and b given, the two equations above give s and then c; the crank makes full turns if tan² p < a/b.

namespace slidercrank
{

namespace
{

/// Returns p = α/2, which is the same for a time ratio and its reciprocal.
double halfDeadCentreAngle(double timeRatio)
{
    return 0.5 * std::numbers::pi * std::abs(timeRatio - 1.0) / (timeRatio + 1.0);
}

/// Returns the minimum transmission angle μ as a function of r = b/a.
double transmissionAngle(double p, double r)
{
    const double k = std::tan(p);
    return std::acos(std::min(1.0, (1.0 + std::sin(p) * (r * r - 1.0) / std::sqrt(1.0 + k * k * r * r)) / r));
}

/// Returns the ratio b/a with the largest minimum transmission angle; infinite for p = 0.
double findBestRatio(double p)
{
    const double k = std::tan(p);
    return std::sqrt((k + std::sqrt(5.0 * k * k + 4.0)) / (2.0 * k * (1.0 + k * k)));
}

/// Returns the largest minimum transmission angle of any ratio b/a; for p = 0 long couplers approach 90°.
double transmissionAngleBound(double p)
{
    return p > 0.0 ? transmissionAngle(p, findBestRatio(p)) : 0.5 * std::numbers::pi;
}

/// Returns the largest time ratio that allows this minimum transmission angle, by bisection: the larger the time ratio,
/// the smaller transmissionAngleBound().
double largestTimeRatio(double transmissionAngle)
{
    constexpr double kTolerance = 1e-9;
    double low = 1.0;
    double high = kTimeRatioBound;
    while (high - low > kTolerance) {
        const double middle = 0.5 * (low + high);
        (transmissionAngleBound(halfDeadCentreAngle(middle)) >= transmissionAngle ? low : high) = middle;
    }
    return low;
}

} // namespace

std::optional<DesignRange> findDesignRange(double timeRatio)
{
    if (!(timeRatio > 1.0 / kTimeRatioBound && timeRatio < kTimeRatioBound)) {
        return std::nullopt;
    }
    const double p = halfDeadCentreAngle(timeRatio);
    DesignRange range;
    range.largestRatio = 1.0 / (std::tan(p) * std::tan(p));
    if (!(range.largestRatio > 1.0)) { // the time ratio equals 3 except for rounding
        return std::nullopt;
    }
    range.bestRatio = std::min(findBestRatio(p), kLargestProposedRatio);
    range.bestTransmissionAngle = transmissionAngle(p, range.bestRatio);
    return range;
}

Lengths findLengths(double stroke, double timeRatio, double couplerRatio)
{
    const double p = halfDeadCentreAngle(timeRatio);
    const double a = 0.5 * stroke / std::hypot(std::cos(p), couplerRatio * std::sin(p));
    const double c = a * (couplerRatio - 1.0) * (couplerRatio + 1.0) * std::sin(2.0 * p) * (a / stroke);
    return {a, couplerRatio * a, timeRatio < 1.0 ? -c : c};
}

std::variant<Lengths, DesignFault> designOffset(double a, double b, double timeRatio)
{
    using Reason = DesignFault::Reason;
    if (!findDesignRange(timeRatio)) {
        return DesignFault{.reason = Reason::TimeRatioOutOfRange};
    }
    if (!(b > a)) {
        return DesignFault{.reason = Reason::CouplerTooShort};
    }
    const double p = halfDeadCentreAngle(timeRatio);
    const double tangent = std::tan(p);
    if (!(tangent * tangent * b < a)) {
        const double alpha = 2.0 * std::atan(std::sqrt(a / b));
        return DesignFault{.reason = Reason::TimeRatioTooLarge,
                           .bound = (std::numbers::pi + alpha) / (std::numbers::pi - alpha)};
    }
    const double stroke = 2.0 * std::hypot(a * std::cos(p), b * std::sin(p));
    const double c = (b - a) * std::sin(2.0 * p) * ((b + a) / stroke);
    return Lengths{a, b, timeRatio < 1.0 ? -c : c};
}

std::variant<Lengths, DesignFault> design(const DesignRequest &request)
{
    if (!(request.stroke > 0.0)) {
        return DesignFault{.reason = DesignFault::Reason::StrokeNotPositive};
    }
    const std::optional<DesignRange> range = findDesignRange(request.timeRatio);
    if (!range) {
        return DesignFault{.reason = DesignFault::Reason::TimeRatioOutOfRange};
    }
    double ratio = range->bestRatio;
    if (request.transmissionAngle && *request.transmissionAngle > range->bestTransmissionAngle) {
        const double wanted = *request.transmissionAngle;
        const double p = halfDeadCentreAngle(request.timeRatio);
        if (!(wanted < transmissionAngleBound(p))) {
            return DesignFault{.reason = DesignFault::Reason::TransmissionAngleTooLarge,
                               .bound = transmissionAngleBound(p),
                               .timeRatioBound = largestTimeRatio(wanted)};
        }
        // Only a ratio b/a above kLargestProposedRatio is sufficient. For p = 0, cos μ = 1/r.
        ratio = p > 0.0 ? findBestRatio(p) : std::nextafter(1.0 / std::cos(wanted), kInfinity);
    }
    return findLengths(request.stroke, request.timeRatio, ratio);
}

} // namespace slidercrank
