// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/difference_curves.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

DifferenceCurves::DifferenceCurves(const Mechanism &model, const Mechanism &other, const Interval &run)
    : m_model(model)
    , m_other(other)
    , m_speed(std::max(std::abs(model.omega2()), std::abs(other.omega2())))
    , m_run(run)
{
}

DifferenceCurves::Values DifferenceCurves::valuesAt(const std::vector<double> &instants) const
{
    const auto valuesOf = [&instants](const ClosedFormBatch &motion) {
        Values values;
        for (std::vector<double> &channel : values) {
            channel.resize(instants.size());
        }
        std::vector<Status> statuses(instants.size());
        motion.evaluate(instants,
                        {values[0].data(), values[1].data(), values[2].data(), values[3].data(), values[4].data(),
                         values[5].data()},
                        statuses);
        return values;
    };
    Values differences = valuesOf(m_model);
    const Values others = valuesOf(m_other);
    for (std::size_t channel = 0; channel < differences.size(); ++channel) {
        std::ranges::transform(differences[channel], others[channel], differences[channel].begin(),
                               [](double model, double other) {
                                   const double difference = std::abs(model - other);
                                   return std::isfinite(difference) ? difference : kNoValue;
                               });
    }
    return differences;
}

double DifferenceCurves::value(std::size_t channel, double t) const
{
    return valuesAt({t})[channel].front();
}

DifferenceCurves::Curves DifferenceCurves::curves(const Interval &range, std::size_t columns) const
{
    const Interval shown{std::max(range.lower, m_run.lower), std::min(range.upper, m_run.upper)};
    if (!(shown.lower <= shown.upper)) {
        return {};
    }
    constexpr double kPerTurn = 32.0;
    constexpr double kMostInAColumn = 32.0;
    const double pixels = range.length() > 0.0 ? static_cast<double>(columns) * shown.length() / range.length() : 1.0;
    const double turns = m_speed * shown.length() / kTurn;
    const double pieces = std::ceil(std::clamp(kPerTurn * turns, 2.0 * pixels, kMostInAColumn * pixels));
    const bool isThin = kPerTurn * turns > pieces; // then not evenly, lest they meet every turn at the same place
    std::vector<double> instants;
    instants.reserve(static_cast<std::size_t>(pieces) + 1);
    for (double i = 0.0; i < pieces; ++i) {
        const double shift = i * std::numbers::phi;
        instants.push_back(shown.lower + shown.length() * (i + (isThin ? shift - std::floor(shift) : 0.0)) / pieces);
    }
    instants.push_back(shown.upper);
    const Values values = valuesAt(instants);
    const PixelColumns inColumns = pixelColumns(instants, range, columns);
    Curves curves;
    for (std::size_t channel = 0; channel < curves.size(); ++channel) {
        curves[channel] = decimate(instants, values[channel], inColumns);
    }
    return curves;
}

} // namespace slidercrank
