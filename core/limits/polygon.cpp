// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/polygon.h"

#include "core/limits/output_channel.h"

#include <cmath>

namespace slidercrank
{

namespace
{

PlaneVector scaled(double factor, const PlaneVector &vector)
{
    return {factor * vector.x, factor * vector.y};
}

/// Returns the vector product of an angular velocity or acceleration with a vector in the plane.
PlaneVector crossProduct(double rate, const PlaneVector &vector)
{
    return {-rate * vector.y, rate * vector.x};
}

struct NamedVector {
    PolygonVector name = PolygonVector::PinVelocity;
    PlaneVector vector;
};

/// Places the vectors of the chain one after the other, and their sum at the pole.
std::vector<PlacedVector> placeVectors(const std::vector<NamedVector> &chain, const NamedVector &sum)
{
    std::vector<PlacedVector> polygon;
    PlaneVector end;
    for (const auto &[name, vector] : chain) {
        const PlaneVector next{end.x + vector.x, end.y + vector.y};
        polygon.push_back({.vector = name, .from = end, .to = next});
        end = next;
    }
    polygon.push_back({.vector = sum.name, .from = {}, .to = sum.vector});
    return polygon;
}

} // namespace

Polygons polygonsAt(const Mechanism &mechanism, double t, double alpha2)
{
    using enum PolygonVector;
    const OutputState output = unambiguousStateAt(mechanism, t, alpha2);
    const State &state = output.state;
    if (state.status != Status::Solved) {
        return {};
    }
    const double omega2 = mechanism.omega2();
    const double omega3 = state.qDot[Theta3];
    const double alpha3 = state.qDDot[Theta3];
    const PlaneVector pin{output.derived.pinX.position, output.derived.pinY.position};
    const PlaneVector coupler{mechanism.b() * std::cos(state.q[Theta3]), mechanism.b() * std::sin(state.q[Theta3])};
    return {.velocity = placeVectors(
                {{PinVelocity, crossProduct(omega2, pin)}, {CouplerVelocity, crossProduct(omega3, coupler)}},
                {SliderVelocity, {state.qDot[R4x], 0.0}}),
            .acceleration = placeVectors({{PinNormal, scaled(-omega2 * omega2, pin)},
                                          {PinTangential, crossProduct(alpha2, pin)},
                                          {CouplerNormal, scaled(-omega3 * omega3, coupler)},
                                          {CouplerTangential, crossProduct(alpha3, coupler)}},
                                         {SliderAcceleration, {state.qDDot[R4x], 0.0}})};
}

} // namespace slidercrank
