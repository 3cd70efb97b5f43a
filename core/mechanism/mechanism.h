// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Defines the offset slider-crank: lengths, drive and assembly, and the names and order of its 12 coordinates and 12
// constraints.
//
// There are four bodies in the plane: 1 ground, 2 crank, 3 coupler, 4 slider. The crank turns about the crank pivot O2,
// which is the origin of the frame, at constant speed. A is the crank pin. B is the wrist pin of the slider, which
// moves along the line y = c, parallel to the x axis. Lengths are in mm, time is in s, and angles are in rad, positive
// counter-clockwise from the x axis.
//
// Source: A. A. Shabana, "Computational Dynamics", 3rd ed., Wiley 2009, ch. 3 (absolute coordinates);
//         R. L. Norton, "Design of Machinery", section 4.6 (the two assemblies of the fourbar slider-crank).

#include "core/mechanism/enum_table.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

namespace slidercrank
{

/// Represents a value that does not exist.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The two assemblies: on the open branch the slider lies to the right of A (cos θ3 > 0), on the crossed one to the
/// left.
enum class Branch { Open, Crossed };

constexpr Branch oppositeBranch(Branch branch)
{
    return branch == Branch::Open ? Branch::Crossed : Branch::Open;
}

/// The input that defines a mechanism. The defaults are those of Table 1 of the reference report.
struct Parameters {
    double a = 20.0;                        ///< crank length O2-A, mm, > 0
    double b = 65.0;                        ///< coupler length A-B, mm, > 0
    double c = 25.0;                        ///< offset of the slider's line from O2 along y, mm, any sign
    double omega2 = 2.0 * std::numbers::pi; ///< crank speed, rad/s, constant, any sign
    double theta20 = 0.0;                   ///< crank angle at t = 0, rad
    Branch branch = Branch::Open;           ///< assembly

    friend bool operator==(const Parameters &, const Parameters &) = default;
};

/// Returns the eight mechanisms whose motions a single channel may be unable to distinguish: the given one, mirrored in
/// the y axis, in the x axis and in both, each on either branch. The first is `parameters` itself.
std::array<Parameters, 8> mirrorImages(const Parameters &parameters);

/// Returns a + b + |c| (mm).
inline double characteristicLength(const Parameters &parameters)
{
    return parameters.a + parameters.b + std::abs(parameters.c);
}

enum class Parameter { A, B, C, Omega2, Theta20 };
inline constexpr std::size_t kParameterCount = enumeratorCount<Parameter::Theta20>();
inline constexpr std::array<Parameter, kParameterCount> kAllParameters{Parameter::A, Parameter::B, Parameter::C,
                                                                       Parameter::Omega2, Parameter::Theta20};

constexpr std::size_t indexOf(Parameter parameter)
{
    return static_cast<std::size_t>(parameter);
}

/// Returns the member of `parameters` that `parameter` denotes, in its unit.
double &valueOf(Parameters &parameters, Parameter parameter);
double valueOf(const Parameters &parameters, Parameter parameter);

/// The largest magnitude of a length, speed or angle (in its unit), and the shortest link (mm). Products of a few such
/// values neither overflow nor underflow, so that no other code has to take care of that.
inline constexpr double kLargestParameter = 1e12;
inline constexpr double kShortestLink = 1e-9;

/// A parameter that cannot be used, and the reason.
struct ParameterFault {
    enum class Reason {
        NotFinite,
        TooLarge,    ///< beyond kLargestParameter in magnitude
        NotPositive, ///< a or b
        TooShort     ///< a or b, below kShortestLink
    };
    Parameter parameter;
    Reason reason;
};

/// Returns the first parameter that cannot be used, or nullopt if all are valid.
std::optional<ParameterFault> findFault(const Parameters &parameters);

/// Valid parameters, the input of every solver.
class Mechanism
{
public:
    Mechanism() = default;                            ///< Table 1 of the reference report
    explicit Mechanism(const Parameters &parameters); ///< precondition: !findFault(parameters)

    double a() const { return m_parameters.a; }
    double b() const { return m_parameters.b; }
    double c() const { return m_parameters.c; }
    double omega2() const { return m_parameters.omega2; }
    double theta20() const { return m_parameters.theta20; }
    Branch branch() const { return m_parameters.branch; }
    const Parameters &parameters() const { return m_parameters; }

    friend bool operator==(const Mechanism &, const Mechanism &) = default;

private:
    Parameters m_parameters;
};

/// Returns the same mechanism with a different crank speed (rad/s) and a different crank angle at t = 0 (rad).
Mechanism withDrive(const Mechanism &mechanism, double omega2, double theta20);

/// Returns the same mechanism with the crank angle theta2 (rad) at t = 0.
inline Mechanism withCrankAt(const Mechanism &mechanism, double theta2)
{
    return withDrive(mechanism, mechanism.omega2(), theta2);
}

/// The 12 absolute coordinates in the order of q: centre of mass (mm) and angle (rad) of each body.
/// Theta3 is the direction from A to B, θ³ of the reference report; Norton's θ_3 is Theta3 + 180°.
enum Coordinate : std::ptrdiff_t { R1x, R1y, Theta1, R2x, R2y, Theta2, R3x, R3y, Theta3, R4x, R4y, Theta4 };
inline constexpr std::ptrdiff_t kCoordinateCount = Theta4 + 1;

/// The 12 constraints in the order of the rows of C. Length rows are in mm, angle rows in rad.
enum Constraint : std::ptrdiff_t {
    GroundX,     ///< R1x = 0
    GroundY,     ///< R1y = 0
    GroundAngle, ///< θ1 = 0
    CrankPivotX, ///< revolute joint at O2
    CrankPivotY,
    CrankPinX, ///< revolute joint at A
    CrankPinY,
    SliderPinX, ///< revolute joint at B
    SliderPinY,
    SliderAngle, ///< prismatic joint: the slider does not turn,
    SliderLine,  ///< and stays on the line y = c
    CrankDrive   ///< θ2 = ω2 t + θ20
};

/// The outcome of solving one time step.
enum class Status {
    Solved,         ///< position, velocity and acceleration are computed
    Singular,       ///< the coupler is perpendicular to the slider's line (cos θ3 = 0): only the position exists
    IterationLimit, ///< Newton-Raphson reached its iteration limit with the residual above the tolerance
    NotAssemblable, ///< |c - a sin θ2| > b: the mechanism cannot be assembled
    NotFinite ///< the time or the crank angle is not a finite number or, for Newton-Raphson, the crank angle is too
              ///< large to be resolved (kLargestDrive)
};

inline constexpr std::size_t kStatusCount = enumeratorCount<Status::NotFinite>();

/// Returns the name of a status in files and on the command line: "solved", "singular", "iteration-limit",
/// "not-assemblable", "not-finite".
std::string_view nameOf(Status status);

} // namespace slidercrank
