// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the offset slider-crank with a given stroke and time ratio. Lengths in mm, angles in rad.
//
// Source: R. L. Norton, "Design of Machinery", section 3.8 (quick-return slider-crank); VDI 2126 (transmission angle of
// the offset slider-crank). The derivation is in design.cpp.

#include <optional>
#include <variant>

namespace slidercrank
{

/// The lengths of a slider-crank; the offset c may be negative.
struct Lengths {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
};

/// The upper bound of the time ratio of a crank that makes full turns.
inline constexpr double kTimeRatioBound = 3.0;

/// The mechanisms with one time ratio: one degree of freedom is left, the ratio b/a of coupler and crank.
struct DesignRange {
    /// The upper bound of b/a; infinite for the time ratio 1. Neither this bound nor the lower bound, 1, is in the
    /// range, because the transmission angle is 0 there.
    double largestRatio = 1.0;

    double bestRatio = 1.0; ///< b/a with the largest minimum transmission angle; at most kLargestProposedRatio
    double bestTransmissionAngle = 0.0; ///< rad, minimum transmission angle with bestRatio
};

/// The largest ratio b/a that is proposed. For a time ratio near 1 the best coupler would be arbitrarily long.
inline constexpr double kLargestProposedRatio = 10.0;

/// Returns the range for a time ratio (slower over faster stroke, or its reciprocal), or nullopt unless it is in (1/3,
/// 3).
std::optional<DesignRange> findDesignRange(double timeRatio);

/// Returns the mechanism with this stroke (> 0), time ratio, and ratio b/a within the range. c >= 0 for a time ratio of
/// at least 1, so that the slider moves outwards in less time than back if ω2 > 0; a time ratio below 1 exchanges the
/// directions by c < 0.
Lengths findLengths(double stroke, double timeRatio, double couplerRatio);

struct DesignRequest {
    double stroke = 0.0; ///< mm
    double timeRatio = 1.0;
    std::optional<double> transmissionAngle = {}; ///< rad, the smallest acceptable minimum transmission angle
};

/// Why a request cannot be met.
struct DesignFault {
    enum class Reason {
        StrokeNotPositive,
        TimeRatioOutOfRange,       ///< not in (1/3, 3)
        TransmissionAngleTooLarge, ///< `bound` is the largest angle that the time ratio allows
        CouplerTooShort,           ///< with given a and b: b must be longer than a
        TimeRatioTooLarge          ///< with given a and b: `bound` is the upper bound of the time ratio
    };
    Reason reason = Reason::StrokeNotPositive;
    double bound = 0.0; ///< the bound that the reason mentions; 0 if it mentions none

    /// The largest time ratio that allows the requested transmission angle, if that is too large.
    double timeRatioBound = kTimeRatioBound;
};

/// Returns the mechanism with the largest minimum transmission angle. Its ratio b/a exceeds kLargestProposedRatio
/// only if the requested transmission angle needs it.
std::variant<Lengths, DesignFault> design(const DesignRequest &request);

/// Returns the mechanism with these lengths of crank and coupler (mm) whose offset c gives the time ratio; c has the
/// same sign as in findLengths().
std::variant<Lengths, DesignFault> designOffset(double a, double b, double timeRatio);

} // namespace slidercrank
