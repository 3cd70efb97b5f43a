// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/closed_form/batch.cpp"

#include <hwy/foreach_target.h>

#include "core/closed_form/closed_form.h"
#include "core/closed_form/motion_kernel-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace slidercrank
{
namespace HWY_NAMESPACE
{

/// Computes a block of at most kMaxBlock time stamps, a multiple of kMaxLanes. All vectors go through one stage before
/// the next begins: stages are short enough for a processor to overlap several vectors, which it cannot do when each
/// vector is carried from its time stamp to its last channel. The columns are valid where `roots` is positive. Returns
/// whether all values are valid.
bool evaluateBlock(const MotionConstants &constants, const double *times, std::size_t count,
                   const PlottedColumns &columns, double *roots)
{
    const std::size_t lanes = hn::Lanes(Lanes::Tag());
    const MotionConstants k = constants; // a local copy, which no store can change
    double sines[kMaxBlock];
    double cosines[kMaxBlock];
    double heights[kMaxBlock];
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes hi = 0.0, lo = 0.0, x = 0.0, cosine = 0.0;
        crankAngleWithSine(k, Lanes::load(times + i), hi, lo, x, cosine);
        x.store(sines + i);
        cosine.store(cosines + i);
    }
    const auto [theta3, R4x, theta3Dot, R4xDot, theta3DDot, R4xDDot] = columns;
    bool areAllOrdinary = true;
    for (std::size_t i = 0; i < count; i += lanes) {
        const Clearance<Lanes> at = clearance(k, Lanes::load(sines + i), Lanes::load(cosines + i));
        const Lanes root = sqrt(at.p * at.m);
        const Lanes::Mask ordinary = isOrdinary(k, at, root);
        areAllOrdinary = areAllOrdinary && hn::AllTrue(Lanes::Tag(), ordinary);
        select(ordinary, root, 0.0).store(roots + i);
        at.h.store(heights + i);
        const Lanes inverse = k.branch / root;
        if (R4x != nullptr) {
            sliderPosition(k, at, k.branch * root).store(R4x + i);
        }
        const auto store = [i](const Rates<Lanes> &rates, double *theta3Column, double *R4xColumn) {
            if (theta3Column != nullptr) {
                rates.theta3.store(theta3Column + i);
            }
            if (R4xColumn != nullptr) {
                rates.R4x.store(R4xColumn + i);
            }
        };
        if (theta3Dot != nullptr || R4xDot != nullptr) {
            store(velocities(k, at, inverse), theta3Dot, R4xDot);
        }
        if (theta3DDot != nullptr || R4xDDot != nullptr) {
            store(accelerations(k, at, inverse), theta3DDot, R4xDDot);
        }
    }
    for (std::size_t i = 0; theta3 != nullptr && i < count; i += lanes) {
        couplerAngle(k, Lanes::load(heights + i), Lanes::load(roots + i)).store(theta3 + i);
    }
    return areAllOrdinary;
}

} // namespace HWY_NAMESPACE
} // namespace slidercrank
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace slidercrank
{

HWY_EXPORT(evaluateBlock);

void ClosedForm::evaluate(std::span<const double> times, const PlottedColumns &columns,
                          std::span<Status> statuses) const
{
    using HWY_NAMESPACE::kMaxBlock, HWY_NAMESPACE::kMaxLanes;
    std::fill(statuses.begin(), statuses.end(), Status::Solved);
    double roots[kMaxBlock] = {};
    const std::size_t size = times.size();
    const bool isShort = size < kMaxLanes; // then all time stamps are computed one by one
    for (std::size_t from = 0, count = size; from < size; from += count) {
        if (!isShort) { // whole vectors, of which the last one overlaps the one before it
            count = std::clamp((size - from) / kMaxLanes * kMaxLanes, kMaxLanes, kMaxBlock);
            from = std::min(from, size - count);
        }
        PlottedColumns target = columns;
        for (double *&column : target) {
            column = column == nullptr ? nullptr : column + from;
        }
        const bool areAllOrdinary =
            !isShort && HWY_DYNAMIC_DISPATCH(evaluateBlock)(m_constants, times.data() + from, count, target, roots);
        // Computes the time stamps that the vector code could not compute, one by one.
        for (std::size_t i = 0; i < count && !areAllOrdinary; ++i) {
            if (roots[i] > 0.0) {
                continue;
            }
            const Motion motion = motionAt(times[from + i]);
            statuses[from + i] = motion.status;
            const auto values = motion.plotted();
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (target[k] != nullptr) {
                    target[k][i] = values[k];
                }
            }
        }
    }
}

} // namespace slidercrank

#endif
