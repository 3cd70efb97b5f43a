// SPDX-License-Identifier: GPL-3.0-or-later

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/closed_form/batch.cpp"

#include <hwy/foreach_target.h>

#include "core/closed_form/batch.h"
#include "core/closed_form/motion_kernel-inl.h"
#include "core/mechanism/channel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace slidercrank
{
namespace HWY_NAMESPACE
{

/// Writes the wanted columns from an instant on.
struct ColumnStore {
    PlottedColumns columns;
    std::size_t at;

    bool wantsR4x() const { return columns.R4x != nullptr; }
    bool wantsVelocity() const { return columns.theta3Dot != nullptr || columns.R4xDot != nullptr; }
    bool wantsAcceleration() const { return columns.theta3DDot != nullptr || columns.R4xDDot != nullptr; }

    template <class D, class V>
    HWY_INLINE void storeS(D, V) const
    {
    }
    template <class D, class V>
    HWY_INLINE void storeR4x(D d, V R4x) const
    {
        putLength(d, R4x, columns.R4x);
    }
    template <class D, class V>
    HWY_INLINE void storeVelocity(D d, V theta3Dot, V, V R4xDot) const
    {
        putAngle(d, theta3Dot, columns.theta3Dot);
        putLength(d, R4xDot, columns.R4xDot);
    }
    template <class D, class V>
    HWY_INLINE void storeAcceleration(D d, V theta3DDot, V, V R4xDDot) const
    {
        putAngle(d, theta3DDot, columns.theta3DDot);
        putLength(d, R4xDDot, columns.R4xDDot);
    }

    template <class D, class V>
    HWY_INLINE void putAngle(D d, V radians, double *column) const
    {
        putLength(d, hn::Mul(radians, hn::Set(d, kDegreesPerRadian)), column);
    }
    template <class D, class V>
    HWY_INLINE void putLength(D d, V value, double *column) const
    {
        if (column != nullptr) {
            hn::StoreU(value, d, column + at);
        }
    }
};

/// Instants that go through one stage before the next begins: stages are short enough for a processor to overlap
/// several vectors, which it cannot where one vector is carried from its instant to its last channel.
constexpr std::size_t kBlock = 64;

/// At most kBlock instants, whole vectors: how many of them, from the first on, are in vectors that moveLinks() is for.
/// Only those are written.
template <class D>
HWY_INLINE std::size_t moveBlock(D d, const MotionConstants &k, const double *instants, std::size_t count,
                                 const PlottedColumns &columns)
{
    using V = hn::Vec<D>;
    HWY_ALIGN double sines[kBlock];
    HWY_ALIGN double cosines[kBlock];
    HWY_ALIGN double heights[kBlock];
    HWY_ALIGN double roots[kBlock];
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t i = 0; i < count; i += lanes) {
        V hi, lo, x, cos2;
        turnCrank(d, k, hn::LoadU(d, instants + i), hi, lo, x, cos2);
        hn::Store(x, d, sines + i);
        hn::Store(cos2, d, cosines + i);
    }
    std::size_t moved = 0;
    for (; moved < count; moved += lanes) {
        V h, root;
        if (!moveLinks(d, k, hn::Load(d, sines + moved), hn::Load(d, cosines + moved), ColumnStore{columns, moved}, h,
                       root)) {
            break;
        }
        hn::Store(h, d, heights + moved);
        hn::Store(root, d, roots + moved);
    }
    if (columns.theta3 != nullptr) {
        for (std::size_t i = 0; i < moved; i += lanes) {
            const V theta3 = couplerAngle(d, k, hn::Load(d, heights + i), hn::Load(d, roots + i));
            ColumnStore{columns, i}.putAngle(d, theta3, columns.theta3);
        }
    }
    return moved;
}

/// Computes instants from the first on, as far as whole vectors of them are Solved and of reducible angle; how many.
std::size_t moveWhileOrdinary(const MotionConstants &constants, const double *instants, std::size_t count,
                              const PlottedColumns &columns)
{
    const hn::ScalableTag<double> d;
    const std::size_t lanes = hn::Lanes(d);
    const MotionConstants k = constants; // a copy of its own: what is stored cannot change it
    const std::size_t whole = count - count % lanes;
    std::size_t i = 0;
    while (i < whole) {
        const std::size_t size = std::min(kBlock, whole - i);
        const std::size_t moved = moveBlock(d, k, instants + i, size, columns.behind(i));
        i += moved;
        if (moved < size) {
            return i;
        }
    }
    if (i == count) {
        return count;
    }

    // Fewer than a vector are left: beside room of their own, the last of them again in the lanes too many.
    double last[kBlock];
    double room[6][kBlock];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        last[lane] = instants[std::min(i + lane, count - 1)];
    }
    PlottedColumns beside;
    double *PlottedColumns::*const members[] = {&PlottedColumns::theta3,     &PlottedColumns::R4x,
                                                &PlottedColumns::theta3Dot,  &PlottedColumns::R4xDot,
                                                &PlottedColumns::theta3DDot, &PlottedColumns::R4xDDot};
    for (std::size_t c = 0; c < std::size(members); ++c) {
        beside.*members[c] = columns.*members[c] != nullptr ? room[c] : nullptr;
    }
    if (moveBlock(d, k, last, lanes, beside) == 0) {
        return i;
    }
    for (std::size_t c = 0; c < std::size(members); ++c) {
        if (columns.*members[c] != nullptr) {
            std::copy(room[c], room[c] + (count - i), columns.*members[c] + i);
        }
    }
    return count;
}

} // namespace HWY_NAMESPACE
} // namespace slidercrank
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace slidercrank
{

HWY_EXPORT(moveWhileOrdinary);

PlottedColumns PlottedColumns::behind(std::size_t count) const
{
    const auto moved = [count](double *column) { return column == nullptr ? nullptr : column + count; };
    return {moved(theta3), moved(R4x), moved(theta3Dot), moved(R4xDot), moved(theta3DDot), moved(R4xDDot)};
}

namespace
{

void put(double *column, std::size_t i, double value)
{
    if (column != nullptr) {
        column[i] = value;
    }
}

} // namespace

ClosedFormBatch::ClosedFormBatch(const Mechanism &mechanism)
    : m_constants(motionConstants(mechanism))
    , m_closedForm(mechanism)
{
}

void ClosedFormBatch::evaluate(std::span<const double> instants, const PlottedColumns &columns,
                               std::span<Status> statuses) const
{
    // Instants that come one by one are still as many as the widest vector has lanes.
    constexpr std::size_t kOneByOne = 8;
    const std::size_t count = instants.size();
    std::fill(statuses.begin(), statuses.end(), Status::Solved);
    std::size_t i = 0;
    while (i < count) {
        i += HWY_DYNAMIC_DISPATCH(moveWhileOrdinary)(m_constants, instants.data() + i, count - i, columns.behind(i));
        for (const std::size_t end = std::min(i + kOneByOne, count); i < end; ++i) {
            const Motion motion = m_closedForm.motionAt(instants[i]);
            statuses[i] = motion.status;
            put(columns.theta3, i, motion.theta3 * kDegreesPerRadian);
            put(columns.R4x, i, motion.R4x);
            put(columns.theta3Dot, i, motion.theta3Dot * kDegreesPerRadian);
            put(columns.R4xDot, i, motion.R4xDot);
            put(columns.theta3DDot, i, motion.theta3DDot * kDegreesPerRadian);
            put(columns.R4xDDot, i, motion.R4xDDot);
        }
    }
}

} // namespace slidercrank

#endif
