// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/tolerance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace slidercrank
{

namespace
{

using KindValues = std::array<double, kLimitKindCount>; ///< indexed by LimitKind; NaN if the limit does not exist

enum Length : std::size_t { A, B, C };
using Point = std::array<double, 3>; ///< lengths of a mechanism, indexed by Length, mm

/// Returns the limits of a mechanism with these lengths (of peaks, the magnitudes); NaN for those that do not exist,
/// and for all if the lengths are impossible.
KindValues valuesAt(const Parameters &parameters, const Point &lengths)
{
    Parameters varied = parameters;
    varied.a = lengths[A];
    varied.b = lengths[B];
    varied.c = lengths[C];
    KindValues values;
    values.fill(kNone);
    if (findFault(varied)) {
        return values;
    }
    const Mechanism mechanism(varied);
    for (const Limit &limit : findLimits(mechanism, motionLimits(mechanism))) {
        const bool isPeak = peakChannel(limit.kind).has_value();
        values[static_cast<std::size_t>(limit.kind)] = isPeak ? std::abs(limit.value) : limit.value;
    }
    return values;
}

/// Returns the values that are tried for one length, ascending: the ends of its range, the nominal value and, for the
/// offset c, 0 if it is within the range.
std::vector<double> trialValuesOf(double nominal, double tolerance, Length length)
{
    if (tolerance == 0.0) {
        return {nominal};
    }
    std::vector<double> values{nominal - tolerance, nominal, nominal + tolerance};
    if (length == C && std::abs(nominal) < tolerance && nominal != 0.0) {
        values.push_back(0.0);
        std::ranges::sort(values);
    }
    return values;
}

/// Returns the argument between `low` and `high` for which a function is largest, by golden section search.
template <class Function>
double findMaximum(const Function &valueAt, double low, double high, double resolution)
{
    constexpr double kGolden = 0.6180339887498949;
    while (high - low > resolution) {
        const double left = high - kGolden * (high - low);
        const double right = low + kGolden * (high - low);
        if (valueAt(left) < valueAt(right)) {
            low = left;
        } else {
            high = right;
        }
    }
    return 0.5 * (low + high);
}

/// Finds the smallest and the largest value of each limit while the lengths vary within their tolerances.
class ToleranceSearch
{
public:
    ToleranceSearch(const Parameters &parameters, const LengthTolerances &tolerances)
        : m_parameters(parameters)
        , m_trialValues{trialValuesOf(parameters.a, tolerances.a, A), trialValuesOf(parameters.b, tolerances.b, B),
                        trialValuesOf(parameters.c, tolerances.c, C)}
    {
        for (const double a : m_trialValues[A]) {
            for (const double b : m_trialValues[B]) {
                for (const double c : m_trialValues[C]) {
                    m_trialPoints.push_back({a, b, c});
                }
            }
        }
    }

    std::optional<LimitRange> range(std::size_t kind)
    {
        const bool isBounded = std::ranges::all_of(
            m_trialPoints, [this, kind](const Point &point) { return std::isfinite(limitsAt(point)[kind]); });
        return isBounded ? std::optional(LimitRange{-greatest(kind, -1.0), greatest(kind, 1.0)}) : std::nullopt;
    }

private:
    const KindValues &limitsAt(const Point &point)
    {
        const auto known = m_computed.find(point);
        return known != m_computed.end() ? known->second
                                         : m_computed.emplace(point, valuesAt(m_parameters, point)).first->second;
    }

    /// Returns the largest value of sign · limit: that of the best trial point, refined along each length.
    double greatest(std::size_t kind, double sign)
    {
        Point best = *std::ranges::max_element(
            m_trialPoints, {}, [this, kind, sign](const Point &point) { return sign * limitsAt(point)[kind]; });
        for (const Length length : {A, B, C}) {
            best = refined(kind, sign, length, best);
        }
        return sign * limitsAt(best)[kind];
    }

    /// Returns the point with the largest value of sign · limit if one length varies between the trial values that
    /// neighbour `point`. Returns `point` if the value rises on neither side of it.
    Point refined(std::size_t kind, double sign, Length length, const Point &point)
    {
        const auto moved = [&point, length](double x) {
            Point next = point;
            next[length] = x;
            return next;
        };
        const auto valueAt = [&](double x) { return sign * limitsAt(moved(x))[kind]; };
        const std::vector<double> &trials = m_trialValues[length];
        const double here = point[length];
        const auto index = static_cast<std::size_t>(std::ranges::find(trials, here) - trials.begin());
        const double low = trials[index > 0 ? index - 1 : 0];
        const double high = trials[std::min(index + 1, trials.size() - 1)];

        constexpr double kProbe = 0.01;     // distance at which a rise is looked for, as a fraction of the interval
        constexpr double kRounding = 1e-13; // relative: a smaller rise is a rounding error
        const double largest = valueAt(here) + kRounding * std::abs(valueAt(here));
        const bool risesTowardsLow = valueAt(here - kProbe * (here - low)) > largest;
        const bool risesTowardsHigh = valueAt(here + kProbe * (high - here)) > largest;
        if (!risesTowardsLow && !risesTowardsHigh) {
            return point; // almost always a corner of the box
        }
        constexpr double kResolution = 1e-6; // fraction of the range; the error of the value grows with its square
        return moved(findMaximum(valueAt, low, high, kResolution * (trials.back() - trials.front())));
    }

    const Parameters &m_parameters;
    std::array<std::vector<double>, 3> m_trialValues; ///< indexed by Length
    std::vector<Point> m_trialPoints;                 ///< all combinations of m_trialValues
    std::map<Point, KindValues> m_computed;           ///< the limits at computed points
};

} // namespace

LimitRanges limitRanges(const Mechanism &mechanism, const LengthTolerances &tolerances)
{
    ToleranceSearch search(mechanism.parameters(), tolerances);
    LimitRanges ranges;
    for (const LimitDescription &description : kLimitDescriptions) {
        if (description.kind != LimitKind::CrankLimit) {
            const auto kind = static_cast<std::size_t>(description.kind);
            ranges[kind] = search.range(kind);
        }
    }
    return ranges;
}

} // namespace slidercrank
