// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/comparison_text.h"

#include "core/import/reference_data.h"
#include "ui/text/channel_text.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <utility>

namespace slidercrank
{

namespace
{

struct ComparisonText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ComparisonText)
};

} // namespace

QString errorText(std::optional<double> value)
{
    constexpr int kDigits = 3;
    return shortNumber(value, kDigits);
}

QString verdictText(const ChannelComparison &channel)
{
    if (channel.verdict == Verdict::Agrees) {
        return ComparisonText::tr("agrees within the rounding of the file");
    }
    if (channel.verdict == Verdict::Close) {
        return channel.clockIsRounded ? ComparisonText::tr("close, if the time stamps of the file are rounded")
                                      : ComparisonText::tr("close: at most %1 times the rounding of the file")
                                            .arg(errorText(channel.largestErrorInBounds));
    }
    if (channel.count == 0) {
        return ComparisonText::tr("differs: nothing to compare with");
    }
    return channel.isWithinRoundedTime ? ComparisonText::tr("differs; the rounded time stamps may explain it")
                                       : ComparisonText::tr("differs");
}

QString abscissaOfLargestError(const ChannelComparison &channel, const ReferenceData &file)
{
    if (!channel.largestError) {
        return dash();
    }
    const double time = channel.timeOfLargestError;
    if (!file.crank) {
        return numberText(time);
    }
    const double crankAngle = file.crank->omega2 * time + file.crank->theta20;
    return numberText(shownValue(Measure::Angle, crankAngle, notation().units));
}

std::vector<QStringList> comparisonTable(std::span<const ChannelComparison> channels, const ReferenceData &file)
{
    constexpr int kStepDigits = 3; // significant digits of a rounding step
    std::vector<QStringList> rows{
        {ComparisonText::tr("channel"), ComparisonText::tr("largest error"),
         file.crank ? ComparisonText::tr("at θ₂ [%1]").arg(shownUnit(Measure::Angle)) : ComparisonText::tr("at t [s]"),
         ComparisonText::tr("rms"), ComparisonText::tr("% of peak"), ComparisonText::tr("max. relative error [%]"),
         ComparisonText::tr("rounding step"), ComparisonText::tr("verdict")}};
    for (const ChannelComparison &channel : channels) {
        const auto inShownUnit = [&channel](std::optional<double> error) {
            return shownDifference(channel.channel, error);
        };
        rows.push_back({QStringLiteral("%1 [%2]").arg(columnName(channel.channel), shownUnit(channel.channel)),
                        errorText(inShownUnit(channel.largestError)), abscissaOfLargestError(channel, file),
                        errorText(inShownUnit(channel.rms)), errorText(channel.percentOfPeak),
                        errorText(channel.maxPercent), numberText(inShownUnit(channel.roundingStep), kStepDigits),
                        verdictText(channel)});
    }
    return rows;
}

QString summaryText(std::span<const ChannelComparison> channels)
{
    if (channels.empty()) {
        return ComparisonText::tr("The file has no column that this program knows.");
    }
    const auto count = [&](Verdict verdict) {
        return std::ranges::count(channels, verdict, &ChannelComparison::verdict);
    };
    const QString all = QString::number(channels.size());
    const QString agreeing = QString::number(count(Verdict::Agrees));
    const QString differing = QString::number(count(Verdict::Differs));
    if (count(Verdict::Agrees) == std::ssize(channels)) {
        return ComparisonText::tr("Match. Quantities that agree within the rounding of the file: %1 of %2.")
            .arg(all, all);
    }
    if (count(Verdict::Differs) == 0) {
        return ComparisonText::tr("Close match. Quantities that agree within the rounding of the file: %1 of %2; the "
                                  "others are close.")
            .arg(agreeing, all);
    }
    const auto worst = std::ranges::max_element(channels, {}, [](const ChannelComparison &channel) {
        const double percent = channel.percentOfPeak.value_or(0.0);
        return std::pair(channel.verdict == Verdict::Differs, percent);
    });
    if (!worst->percentOfPeak) {
        return worst->count == 0 && worst->missingModelCount > 0
                   ? ComparisonText::tr("No match: the mechanism cannot be assembled at any time step of the file.")
                   : ComparisonText::tr("No match. Quantities that differ: %1 of %2.").arg(differing, all);
    }
    const QString sentence =
        ComparisonText::tr("No match. Quantities that differ: %1 of %2, most of all the %3, by %4 % of its peak.")
            .arg(differing, all, quantityName(worst->channel), errorText(worst->percentOfPeak));
    const bool isTimeTheReason = std::ranges::all_of(channels, [](const ChannelComparison &channel) {
        return channel.verdict != Verdict::Differs || channel.isWithinRoundedTime;
    });
    return isTimeTheReason ? sentence + ' ' +
                                 ComparisonText::tr("The rounding of the time stamps is sufficient to explain this: "
                                                    "write the file with more digits of the time.")
                           : sentence;
}

} // namespace slidercrank
