// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/newton_pages.h"

#include "core/mechanism/channel.h"
#include "core/newton/newton.h"
#include "core/sampling/time_step_equations.h"
#include "ui/text/axis_scale.h"
#include "ui/text/channel_text.h"
#include "ui/text/enum_table.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

struct Equation {
    Constraint key;
    const char *direction; ///< of the joint's equation; empty if it is the joint's only one
    const char *text;
};

constexpr Equation kEquations[] = {{GroundX, "x", "Rₓ¹ = 0"},
                                   {GroundY, "y", "R_y¹ = 0"},
                                   {GroundAngle, "θ", "θ¹ = 0"},
                                   {CrankPivotX, "x", "Rₓ² − a/2 cos θ₂ = 0"},
                                   {CrankPivotY, "y", "R_y² − a/2 sin θ₂ = 0"},
                                   {CrankPinX, "x", "−Rₓ³ + Rₓ² + a/2 cos θ₂ + b/2 cos θ³ = 0"},
                                   {CrankPinY, "y", "−R_y³ + R_y² + a/2 sin θ₂ + b/2 sin θ³ = 0"},
                                   {SliderPinX, "x", "Rₓ⁴ − Rₓ³ − b/2 cos θ³ = 0"},
                                   {SliderPinY, "y", "R_y⁴ − R_y³ − b/2 sin θ³ = 0"},
                                   {SliderAngle, "θ", "θ⁴ − θ¹ = 0"},
                                   {SliderLine, "y", "R_y⁴ − c = 0"},
                                   {CrankDrive, "", "θ₂ − ω₂ t − θ₂₀ = 0"}};
static_assert(isCompleteTable(kEquations, CrankDrive));

QString symbolText(Coordinate coordinate)
{
    return absoluteSymbolText({coordinate, Order::Position});
}

bool isAngle(Constraint row)
{
    return row == GroundAngle || row == SliderAngle || row == CrankDrive;
}

QString partName(MechanismPart part)
{
    switch (part) {
    case MechanismPart::None: break;
    case MechanismPart::Ground: return NewtonPages::tr("ground");
    case MechanismPart::Crank: return NewtonPages::tr("crank");
    case MechanismPart::Coupler: return NewtonPages::tr("coupler");
    case MechanismPart::Slider: return NewtonPages::tr("slider");
    case MechanismPart::Pivot: return NewtonPages::tr("pivot O₂");
    case MechanismPart::PinA: return NewtonPages::tr("pin A");
    case MechanismPart::PinB: return NewtonPages::tr("pin B");
    case MechanismPart::Guide: return NewtonPages::tr("guide");
    case MechanismPart::Drive: return NewtonPages::tr("drive");
    }
    return {};
}

QString constraintName(Constraint row)
{
    const QString joint = partName(partOf(row));
    const QString direction = kEquations[row].direction;
    return direction.isEmpty() ? joint : QStringLiteral("%1, %2").arg(joint, direction);
}

/// Returns a value (mm, rad; per s, per s²) of an equation in the unit that is shown. Angles stay in rad.
double shownEquationValue(Constraint row, double value)
{
    return isAngle(row) ? value : shownValue(Measure::Length, value, notation().units);
}

QString unitOfEquation(Constraint row)
{
    return isAngle(row) ? QStringLiteral("rad") : shownUnit(Measure::Length);
}

/// Returns the units of a coordinate and of its derivatives: "°, rad/s, rad/s²".
QString unitsOfCoordinate(Coordinate coordinate)
{
    QStringList units;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        units << shownUnit(measureOf(Channel{coordinate, order}));
    }
    return units.join(", ");
}

/// Returns a coordinate or its derivative (mm, rad, s) in the unit that is shown. The crank angle is within a
/// revolution, as in the drawing and in the tables.
double shownCoordinate(Channel channel, double value)
{
    const bool isCrankAngle = channel == Channel{Theta2, Order::Position};
    const double reduced = isCrankAngle ? degreesFromZero(value) / kDegreesPerRadian : value;
    return shownValue(measureOf(channel), reduced, notation().units);
}

TableCell shortNumberCell(double value)
{
    return numberCell(value, shortNumber(value));
}

/// Returns a cell of the Jacobian. Negative entries have a second colour, and zeros are blank, so that the structure of
/// the matrix can be seen.
TableCell jacobianCell(double value)
{
    TableCell cell = shortNumberCell(value);
    cell.tone = value < 0.0 ? Tone::Fair : Tone::Model;
    if (value == 0.0) {
        cell.text.clear();
    }
    return cell;
}

/// Returns a page without tables, with a warning that explains why numbers are missing. There is no warning if the
/// status is Solved.
Page emptyPage(Status status, const Result &result)
{
    const QString sentence = statusSentence(status, result.solver.newton);
    return {.sentence = sentence.isEmpty() ? sentence : "⚠ " + sentence, .tone = Tone::Bad};
}

TimeStepEquations solvedEquations(const Result &result, double time)
{
    return equationsAt(result.mechanism, time, result.sampling.duration / result.sampling.steps, result.solver);
}

/// Returns the series of the iterations from a rough start, still without points: a solid line with discs.
ChartSeries roughStartSeries()
{
    ChartSeries series{.colour = &SeriesColours::model, .line = ChartSeries::Line::Solid};
    series.mark.addEllipse(QPointF(), 3.5, 3.5);
    return series;
}

/// Returns the series of the iterations from a warm start, still without points: a dashed line with hollow squares.
ChartSeries warmStartSeries()
{
    ChartSeries series{.colour = &SeriesColours::reference, .line = ChartSeries::Line::Dashed, .isHollow = true};
    series.mark.addRect(-3.5, -3.5, 7.0, 7.0);
    return series;
}

/// Returns the series with the residual after each iteration.
ChartSeries withResiduals(ChartSeries series, const IterationHistory &history)
{
    constexpr double kSmallestDrawn = 1e-18; // a residual of 0 is drawn here
    constexpr double kNotFiniteDrawn = 1.0;  // one that is not finite, here
    for (const Iteration &iteration : history) {
        const double residual =
            std::isfinite(iteration.residual) ? std::max(kSmallestDrawn, iteration.residual) : kNotFiniteDrawn;
        series.points.push_back({static_cast<double>(series.points.size()), residual});
        series.tips << numberText(iteration.residual, QLocale::FloatingPointShortest);
    }
    return series;
}

/// Returns the chart of the residual ‖C‖ over the iterations, and of the tolerance. The axes change only if a
/// point is outside their usual ranges.
ChartContent residualChart(std::vector<ChartSeries> series, const NewtonOptions &options)
{
    Interval steps{-0.3, 6.3}; // 0 to 6, with a margin of 0.3
    Interval decades{-19.0, 2.0};
    for (const ChartSeries &history : series) {
        steps.upper = std::max(steps.upper, static_cast<double>(history.points.size()) - 0.7);
        for (const QPointF &point : history.points) {
            decades.upper = std::max(decades.upper, std::ceil(std::log10(point.y())));
        }
    }
    if (options.tolerance > 0.0) {
        series.push_back({.colour = &SeriesColours::warning,
                          .points = {{steps.lower, options.tolerance}, {steps.upper, options.tolerance}},
                          .line = ChartSeries::Line::Dashed});
        decades.lower = std::min(decades.lower, std::floor(std::log10(options.tolerance)) - 1.0);
    }
    const bool isRelative = options.toleranceKind == ToleranceKind::Relative;
    return {.x = {.title = NewtonPages::tr("iteration"), .range = steps},
            .y = {.title = isRelative ? NewtonPages::tr("‖C‖, relative") : NewtonPages::tr("‖C‖"),
                  .range = {std::pow(10.0, decades.lower), std::pow(10.0, decades.upper)},
                  .isLogarithmic = true},
            .series = std::move(series)};
}

} // namespace

Page NewtonPages::equations(const Result &result, double time)
{
    const TimeStepEquations equations = solvedEquations(result, time);
    Page page = emptyPage(equations.state.status, result);
    PageTable table{
        "equationTable",
        tr("Equations, a row for each constraint"),
        {{.title = tr("joint"),
          .explanation = tr("Joint that the equation describes"),
          .csvName = "joint",
          .isNumber = false},
         {.title = tr("equation"),
          .explanation = tr("C(q, t) = 0; bodies as superscripts: 1 ground, 2 crank, 3 coupler, 4 slider"),
          .csvName = "equation",
          .isNumber = false,
          .isFormula = true},
         {tr("C"), tr("Residual of the equation"), "C"},
         {tr("Cₜ, per s"), tr("∂C/∂t: the velocities follow from C<sub>q</sub> dq/dt = −Cₜ"), "C_t"},
         {tr("Q_d, per s²"), tr("The accelerations follow from C<sub>q</sub> d²q/dt² = Q<sub>d</sub>"), "Q_d"},
         {.title = tr("unit"),
          .explanation = tr("Unit of C; Cₜ has this unit per s, Q<sub>d</sub> per s²"),
          .csvName = "unit",
          .isNumber = false}}};
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto row = static_cast<Constraint>(i);
        table.rows.push_back({.cells = {{.text = constraintName(row)},
                                        {.text = rowOf(kEquations, row).text},
                                        shortNumberCell(shownEquationValue(row, equations.C[row])),
                                        shortNumberCell(shownEquationValue(row, equations.Ct[row])),
                                        shortNumberCell(shownEquationValue(row, equations.Qd[row])),
                                        {.text = unitOfEquation(row)}},
                              .part = partOf(row)});
    }
    page.tables = {table};
    return page;
}

/// Returns C_q in the unit of length that is shown. An entry is a length where the constraint is a length and the
/// coordinate an angle, and otherwise a pure number.
static Matrix12 shownJacobian(const Matrix12 &Cq)
{
    Matrix12 shown = Cq;
    for (Eigen::Index row = 0; row < kCoordinateCount; ++row) {
        for (Eigen::Index column = 0; column < kCoordinateCount; ++column) {
            if (!isAngle(static_cast<Constraint>(row)) && isAngle(static_cast<Coordinate>(column))) {
                shown(row, column) = shownValue(Measure::Length, Cq(row, column), notation().units);
            }
        }
    }
    return shown;
}

Page NewtonPages::jacobian(const Result &result, double time)
{
    const TimeStepEquations equations = solvedEquations(result, time);
    Page page = emptyPage(equations.state.status, result);
    const QString length = shownUnit(Measure::Length);
    PageTable table{
        "jacobianTable",
        tr("Jacobian C_q, a row for each constraint, a column for each coordinate"),
        {{.title = tr("C_q"),
          .explanation =
              tr("∂C/∂q: a row for each constraint, a column for each coordinate.\n"
                 "κ is the largest singular value divided by the smallest. It depends on the unit of length, because\n"
                 "lengths and angles are mixed. The larger it is, the more digits are lost; it is infinite where the\n"
                 "coupler is perpendicular to the slider's line."),
          .csvName = QStringLiteral("constraint (lengths in %1)").arg(unitText(Measure::Length, notation().units)),
          .isNumber = false}}};
    for (Eigen::Index j = 0; j < kCoordinateCount; ++j) {
        const auto coordinate = static_cast<Coordinate>(j);
        const QString body = partName(partOf(coordinate));
        table.columns.push_back({.title = symbolText(coordinate),
                                 .explanation = isAngle(coordinate)
                                                    ? tr("Angle of the %1; lengths in %2").arg(body, length)
                                                    : tr("Centre of mass of the %1").arg(body),
                                 .csvName = columnName(Channel{coordinate, Order::Position})});
    }
    const Matrix12 entries = shownJacobian(equations.Cq);
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto row = static_cast<Constraint>(i);
        TableRow tableRow{
            .cells = {{.text = constraintName(row)}}, .part = partOf(row), .explanation = rowOf(kEquations, row).text};
        for (Eigen::Index j = 0; j < kCoordinateCount; ++j) {
            tableRow.cells.push_back(jacobianCell(entries(i, j)));
        }
        table.rows.push_back(tableRow);
    }
    page.tables = {table};
    if (equations.hasPosition()) {
        const double determinant = shownValue(Measure::Length, equations.determinant, notation().units);
        page.note = tr("Lengths in %1. Condition number of the Jacobian κ = %2; its determinant −b cos θ³ = %3")
                        .arg(length, shortNumber(conditionNumber(entries)), withUnit(shortNumber(determinant), length));
    }
    return page;
}

Page NewtonPages::iterations(const Result &result, double time)
{
    const NewtonOptions &options = result.solver.newton;
    const double step = result.sampling.duration / result.sampling.steps;
    IterationHistory rough;
    IterationHistory warm;
    solve(result.mechanism, time, options, {}, &rough);
    const NewtonTimeStep before = solve(result.mechanism, time - step, options);
    if (before.positionStatus == Status::Solved) {
        solve(result.mechanism, time, options, before, &warm);
    }
    const QString roughStart = tr("From a rough start: θ₂ exact, θ³ = 0 (crossed: 180°)");
    const QString warmStart = tr("From the position %1 s before").arg(numberText(step));

    Page page = emptyPage(solvedEquations(result, time).state.status, result);
    page.chart = PageChart{
        "iterationPlot", tr("Residual ‖C‖ over the iterations"),
        residualChart({withResiduals(roughStartSeries(), rough), withResiduals(warmStartSeries(), warm)}, options)};
    PageTable table{"iterationTable",
                    tr("Iterations, a row for each"),
                    {{tr("iteration"), tr("0: the start"), "step"},
                     {tr("● ‖C‖"), roughStart, "residual_from_afar"},
                     {tr("● θ³ [°]"), roughStart, "theta3_from_afar"},
                     {tr("□ ‖C‖"), warmStart, "residual_from_before"},
                     {tr("□ θ³ [°]"), warmStart, "theta3_from_before"}}};
    constexpr int kDecimals = 10;
    for (std::size_t k = 0; k < std::max(rough.size(), warm.size()); ++k) {
        TableRow row{{{.text = QString::number(k), .number = static_cast<double>(k)}}};
        for (const IterationHistory *history : {&rough, &warm}) {
            if (k >= history->size()) {
                row.cells.insert(row.cells.end(), 2, TableCell());
                continue;
            }
            const Iteration &iteration = (*history)[k];
            const double degrees = kDegreesPerRadian * iteration.q[Theta3];
            row.cells.push_back(shortNumberCell(iteration.residual));
            row.cells.push_back(numberCell(degrees, fixedText(degrees, kDecimals)));
        }
        table.rows.push_back(row);
    }
    page.tables = {table};
    page.note = tr("● %1. □ %2. The dashed line is the tolerance, %3.")
                    .arg(roughStart, warmStart, numberText(options.tolerance));
    if (page.sentence.isEmpty()) {
        page.tone = Tone::Normal;
        page.sentence =
            tr("Near the solution each iteration doubles the number of correct digits: the line bends down.");
    }
    return page;
}

Page NewtonPages::coordinates(const Result &result, double time)
{
    const State state = solvedEquations(result, time).state;
    Page page = emptyPage(state.status, result);
    PageTable table{"coordinateTable",
                    tr("Coordinates, a row for each"),
                    {{.title = tr("coordinate"),
                      .explanation = tr("Centre of mass and angle of each body"),
                      .csvName = "coordinate",
                      .isNumber = false,
                      .isFormula = true},
                     {.title = tr("body"), .csvName = "body", .isNumber = false},
                     {tr("position"), tr("q; θ₂ is within a revolution"), "position"},
                     {tr("velocity"), tr("dq/dt"), "velocity"},
                     {tr("acceleration"), tr("d²q/dt²"), "acceleration"},
                     {.title = tr("units"),
                      .explanation = tr("Units of position, velocity and acceleration"),
                      .csvName = "unit",
                      .isNumber = false}}};
    for (Eigen::Index i = 0; i < kCoordinateCount; ++i) {
        const auto coordinate = static_cast<Coordinate>(i);
        const Channel position{coordinate, Order::Position};
        const auto cell = [&](Order order, const Vector12 &values) {
            return shortNumberCell(shownCoordinate({coordinate, order}, values[i]));
        };
        table.rows.push_back({.cells = {{.text = symbolText(coordinate), .csv = columnName(position)},
                                        {.text = partName(partOf(coordinate))},
                                        cell(Order::Position, state.q),
                                        cell(Order::Velocity, state.qDot),
                                        cell(Order::Acceleration, state.qDDot),
                                        {.text = unitsOfCoordinate(coordinate)}},
                              .part = partOf(coordinate)});
    }
    page.tables = {table};
    return page;
}

} // namespace slidercrank
