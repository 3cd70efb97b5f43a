// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/polygon.h"

#include "core/limits/output_channel.h"

#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

PlaneVector scaled(double factor, const PlaneVector &vector)
{
    return {factor * vector.x, factor * vector.y};
}

/// Returns the vector product of an angular velocity or acceleration with a vector in the plane.
PlaneVector crossed(double rate, const PlaneVector &vector)
{
    return {-rate * vector.y, rate * vector.x};
}

/// Places the vectors one after the other, and the last one at the pole.
std::vector<PlacedVector> placed(const std::vector<std::pair<PolygonVector, PlaneVector>> &chain,
                                 const std::pair<PolygonVector, PlaneVector> &sum)
{
    std::vector<PlacedVector> polygon;
    PlaneVector end;
    for (const auto &[name, vector] : chain) {
        const PlaneVector next{end.x + vector.x, end.y + vector.y};
        polygon.push_back({name, end, next});
        end = next;
    }
    polygon.push_back({sum.first, {}, sum.second});
    return polygon;
}

} // namespace

Polygons polygonsAt(const Mechanism &mechanism, double t, double alpha2)
{
    using enum PolygonVector;
    const OutputState output = outputStateAt(mechanism, t, alpha2);
    const State &state = output.state;
    if (state.status != Status::Solved) {
        return {};
    }
    const double omega2 = mechanism.omega2();
    const double omega3 = state.qDot[Theta3];
    const double alpha3 = state.qDDot[Theta3];
    const PlaneVector pin{output.derived.pinX.position, output.derived.pinY.position};
    const PlaneVector coupler{mechanism.b() * std::cos(state.q[Theta3]), mechanism.b() * std::sin(state.q[Theta3])};
    return {placed({{PinVelocity, crossed(omega2, pin)}, {CouplerVelocity, crossed(omega3, coupler)}},
                   {SliderVelocity, {state.qDot[R4x], 0.0}}),
            placed({{PinNormal, scaled(-omega2 * omega2, pin)},
                    {PinTangential, crossed(alpha2, pin)},
                    {CouplerNormal, scaled(-omega3 * omega3, coupler)},
                    {CouplerTangential, crossed(alpha3, coupler)}},
                   {SliderAcceleration, {state.qDDot[R4x], 0.0}})};
}

} // namespace slidercrank
