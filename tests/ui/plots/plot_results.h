// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Motions for the tests of the plots, and textbook formulas for them.

#include "tests/support/initial_mechanism.h"
#include "ui/document/result.h"
#include "ui/plots/curve_sampling.h"
#include "ui/plots/plot_pane.h"

#include <cmath>
#include <memory>
#include <numbers>

namespace slidercrank
{

/// What the plots show.
struct PlotInput {
    Parameters model = withCoupler(60.0);
    std::shared_ptr<const Reference> reference = {};
    std::vector<Parameters> pinned = {};
    Sampling sampling = {};
    Method method = Method::ClosedForm;
};

inline std::shared_ptr<const Result> resultOf(const PlotInput &shown)
{
    SolverSettings solver;
    solver.method = shown.method;
    return compute({shown.model, shown.sampling, solver, shown.reference, shown.pinned}, {});
}

/// Returns the motion with the coupler length `b` (mm) at 41 time stamps as a reference with the first `channels` of
/// the plotted channels.
inline std::shared_ptr<Reference> referenceOf(double b, std::size_t channels = kPlottedChannels.size())
{
    const std::shared_ptr<const Result> result = resultOf({.model = withCoupler(b), .sampling = {0.0, 1.0, 40}});
    auto reference = std::make_shared<Reference>();
    reference->name = "simulation.csv";
    reference->data.time = result->trajectory.time;
    for (std::size_t i = 0; i < channels; ++i) {
        reference->data.series.push_back({kPlottedChannels[i], result->trajectory[kPlottedChannels[i]], {}});
    }
    return reference;
}

/// Returns θ³ (°) and Rₓ⁴ (mm) for a = 20, c = 25, θ₂ = 2π `turns`: asin((c − a sin θ₂)/b), a cos θ₂ + √(b² − (c − a
/// sin θ₂)²).
inline std::array<double, 2> positionsAt(double turns, double b)
{
    const double theta2 = 2.0 * std::numbers::pi * turns;
    const double height = 25.0 - 20.0 * std::sin(theta2);
    return {std::asin(height / b) * kDegreesPerRadian, 20.0 * std::cos(theta2) + std::sqrt(b * b - height * height)};
}

/// Returns the texts of the labels of a pane, one per line.
inline QString textOf(const PlotPane &pane)
{
    QStringList lines;
    for (const PlotCursor &cursor : pane.cursors()) {
        for (const PlotCursor::Label &label : cursor.labels) {
            lines << label.text.text();
        }
    }
    return lines.join(u'\n');
}

/// Returns "t,v" for each point; a gap is "t,-".
inline QString textOfPoints(const std::vector<CurvePoint> &points)
{
    QStringList texts;
    for (const CurvePoint &point : points) {
        const QString value = std::isnan(point.value) ? "-" : QString::number(point.value);
        texts << QStringLiteral("%1,%2").arg(point.t).arg(value);
    }
    return texts.join(u' ');
}

} // namespace slidercrank
