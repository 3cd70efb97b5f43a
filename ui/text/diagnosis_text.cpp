// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/diagnosis_text.h"

#include "ui/text/convention_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Why = Identification::Alternative::Why;

constexpr int kApproximateDigits = 3;

struct DiagnosisText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::DiagnosisText)

public:
    // In the order of Identification::Lack. %1 are the open parameters.
    static constexpr const char *kLacks[] = {
        QT_TR_NOOP("Too few values of the coupler angle θ³, the slider position Rₓ⁴, the coupler's centre R³ and their "
                   "derivatives to find the mechanism: export more time steps, or more columns."),
        QT_TR_NOOP("Nothing moves in these data: export the motion of a turning crank."),
        QT_TR_NOOP("These data do not determine %1: export a longer motion, more digits, or more columns."),
        QT_TR_NOOP("Many mechanisms move nearly as these data do: export a longer motion, more digits, or more "
                   "columns.")};

    // How an alternative is related to the mechanism that was found, for the first Identification::Alternative::Why.
    static constexpr const char *kImages[] = {
        QT_TR_NOOP("its mirror image, with c, ω₂ and θ₂₀ negated"),
        QT_TR_NOOP("one that rotates in the opposite direction, from 180° − θ₂₀"),
        QT_TR_NOOP("the other assembly, with c negated and θ₂₀ increased by 180°")};
};

/// Whether the value of the parameter follows from the data; if they contain only ratios of lengths, from the given a.
bool isMeasured(Parameter parameter, const Identification &found)
{
    return found.identifiable[indexOf(parameter)] ||
           (found.onlyRatios && (parameter == Parameter::B || parameter == Parameter::C));
}

/// Returns an equation for each identified parameter, and the assembly.
QStringList foundTexts(const Identification &found)
{
    const QString equation = found.outcome == Outcome::Approximate ? "%1 ≈ %2" : "%1 = %2";
    QStringList texts;
    for (const Parameter parameter : kAllParameters) {
        if (isMeasured(parameter, found)) {
            texts << equation.arg(symbolText(parameter), measuredText(parameter, found));
        }
    }
    return texts << withNoun(found.parameters.branch);
}

/// Returns an equation with the given value for each parameter that the data do not determine.
QStringList givenTexts(const Identification &found)
{
    QStringList texts;
    for (const Parameter parameter : kAllParameters) {
        if (!isMeasured(parameter, found)) {
            texts << equationText(parameter, valueOf(found.parameters, parameter));
        }
    }
    return texts;
}

/// Returns the channel that differs most from the mechanism that was found.
ChannelComparison worstChannel(const Diagnosis &diagnosis)
{
    const bool isApproximate = diagnosis.identification.outcome == Outcome::Approximate; // R4y is then compared with a
    const auto worst = std::ranges::max_element(diagnosis.identified, {}, [&](const ChannelComparison &channel) {
        return isApproximate && channel.channel.coordinate == R4y ? -1.0 : channel.percentOfPeak.value_or(-1.0);
    });
    return worst == diagnosis.identified.end() ? ChannelComparison() : *worst;
}

/// Lists the columns that the mechanism does not fit: "θ³ (1.2 % of its peak), Rₓ⁴ (3 % of its peak)".
QString leftOutText(const Identification &found)
{
    QStringList columns;
    for (const Identification::LeftOut &column : found.leftOut) {
        columns << DiagnosisText::tr("%1 (%2 % of its peak)")
                       .arg(symbolText(column.channel), errorText(column.percentOfPeak));
    }
    return columns.join(", ");
}

QString alternativeText(const Identification::Alternative &alternative)
{
    return alternative.why < Why::Alias
               ? DiagnosisText::tr(DiagnosisText::kImages[static_cast<std::size_t>(alternative.why)])
               : mechanismText(Mechanism(alternative.parameters));
}

QString ambiguousText(const Identification &found)
{
    QStringList mechanisms{foundTexts(found).join(", ")};
    bool hasAlias = false;
    for (const Identification::Alternative &alternative : found.alternatives) {
        mechanisms << alternativeText(alternative);
        hasAlias = hasAlias || alternative.why == Why::Alias;
    }
    const QString text = DiagnosisText::tr("%1 mechanisms fit this file equally well: %2.")
                             .arg(mechanisms.size())
                             .arg(mechanisms.join("; "));
    return hasAlias ? text + u' ' +
                          DiagnosisText::tr("More time steps per revolution, derivatives or θ₂ would tell them apart.")
                    : text;
}

QString identifiedText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    const QString mechanism = foundTexts(found).join(", ");
    if (found.outcome != Outcome::Approximate) {
        return found.outcome == Outcome::Identified ? mechanism + u'.' : ambiguousText(found);
    }
    return DiagnosisText::tr("%1 fit the file up to %2 % of peak; the rest is systematic (filtered, interpolated or "
                             "integrated data?), so no standard errors can be given.")
        .arg(mechanism, errorText(worstChannel(diagnosis).percentOfPeak));
}

QString notIdentifiedText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    if (found.outcome == Outcome::Insufficient) {
        QStringList open;
        for (const Parameter parameter : kAllParameters) {
            if (found.openParameters[indexOf(parameter)]) {
                open << symbolText(parameter);
            }
        }
        return DiagnosisText::tr(DiagnosisText::kLacks[static_cast<std::size_t>(found.lack)])
            .replace("%1", listed(open));
    }
    if (found.outcome != Outcome::Nearest) {
        return diagnosis.unevenCrank
                   ? DiagnosisText::tr("No mechanism fits this file.")
                   : DiagnosisText::tr("No mechanism fits this file: check the meaning and the units of its columns.");
    }
    const ChannelComparison worst = worstChannel(diagnosis);
    const QString text =
        DiagnosisText::tr("No mechanism fits this file. The nearest: %1, off by up to %2 % of peak, in %3.")
            .arg(mechanismText(Mechanism(found.parameters), 4), errorText(worst.percentOfPeak),
                 symbolText(worst.channel));
    return found.leftOut.empty() ? text
                                 : text + u' ' +
                                       DiagnosisText::tr("It fits the other columns, but these disagree with them: %1.")
                                           .arg(leftOutText(found));
}

QString crankSpeedText(const CrankSpeedChange &speed)
{
    const int digits = digitsToTellApart(speed.atStart, speed.atEnd);
    return DiagnosisText::tr("The crank speed is not constant: %1 rad/s at the start and %2 rad/s at the end.")
        .arg(numberText(speed.atStart, digits), numberText(speed.atEnd, digits));
}

QString noiseText(const Identification::Noise &noise)
{
    const QString unit = unitText(noise.channel);
    const QString space = unit.startsWith(u'°') ? QString() : " ";
    return symbolText(noise.channel) + u' ' + errorText(noise.rms) + space + unit;
}

} // namespace

QString measuredText(Parameter parameter, const Identification &found)
{
    if (!isMeasured(parameter, found)) {
        return dash();
    }
    const double factor = shownFactor(parameter);
    const double value = factor * valueOf(found.parameters, parameter);
    if (found.outcome == Outcome::Approximate) {
        return numberText(value, kApproximateDigits) + unitBehind(parameter);
    }
    const double scale = parameter == Parameter::Omega2    ? std::abs(found.parameters.omega2)
                         : parameter == Parameter::Theta20 ? factor
                                                           : characteristicLength(found.parameters);
    return measuredText(value, factor * found.standardError[indexOf(parameter)], scale) + unitBehind(parameter);
}

/// Returns the first ten of the numbers of lines.
QString linesText(const std::vector<std::size_t> &lines)
{
    constexpr std::size_t kMostListed = 10;
    QStringList texts;
    for (const std::size_t line : std::span(lines).first(std::min(lines.size(), kMostListed))) {
        texts << QString::number(line);
    }
    return texts.join(", ") + (lines.size() > kMostListed ? ", …" : "");
}

QString caveatText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    QStringList sentences;
    if (found.onlyRatios) {
        sentences << DiagnosisText::tr("The coupler angle θ³ alone determines only b/a and c/a.");
    }
    if (found.hasOneMechanism()) {
        for (const Identification::Alternative &alternative : found.alternatives) {
            sentences << DiagnosisText::tr("These columns cannot tell it from %1.").arg(alternativeText(alternative));
        }
    }
    if (const QStringList given = givenTexts(found); !given.isEmpty()) {
        sentences << DiagnosisText::tr("The data do not determine %1: kept as given.").arg(listed(given));
    }
    if (found.hasOneMechanism() && !found.leftOut.empty()) {
        sentences << DiagnosisText::tr("Columns left out, because they deviate from the motion of the others: %1.")
                         .arg(leftOutText(found));
    }
    if (!found.excludedRows.empty()) {
        sentences << DiagnosisText::tr("Rows left out, because they are far off the motion: %1. Lines of the file: %2.")
                         .arg(QString::number(found.excludedRows.size()), linesText(found.excludedRows));
    }
    if (!found.noise.empty()) {
        QStringList columns;
        std::ranges::transform(found.noise, std::back_inserter(columns), noiseText);
        sentences << DiagnosisText::tr("What remains looks like noise: %1 (rms).").arg(listed(columns));
    }
    if (diagnosis.unevenCrank) {
        sentences << crankSpeedText(*diagnosis.unevenCrank);
    }
    return sentences.join(u' ');
}

QString summaryText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    if (found.stopped) {
        return DiagnosisText::tr("The search was stopped.");
    }
    if (found.hasMechanism()) {
        const QString caveats = caveatText(diagnosis);
        return identifiedText(diagnosis) + (caveats.isEmpty() ? caveats : u' ' + caveats);
    }
    const QString text = notIdentifiedText(diagnosis);
    return diagnosis.unevenCrank ? crankSpeedText(*diagnosis.unevenCrank) + u' ' + text : text;
}

QString foundText(const Diagnosis &diagnosis)
{
    const QString summary = summaryText(diagnosis);
    return diagnosis.identification.hasOneMechanism()
               ? DiagnosisText::tr("Mechanism found in this file: %1").arg(summary)
               : summary;
}

QStringList explanationLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism)
{
    QStringList lines;
    for (const ConventionFinding &finding : diagnosis.conventions) {
        lines << findingText(finding);
    }
    if (!lines.isEmpty() && diagnosis.agreesWithGiven) {
        lines << DiagnosisText::tr("Read this way, it does not differ from this mechanism.");
    }
    lines << differenceSentence(data.layout);
    if (!diagnosis.agreesWithGiven) {
        if (diagnosis.change) {
            lines << changeText(diagnosis, mechanism);
        }
        lines << foundText(diagnosis);
    }
    lines.removeAll(QString());
    return lines;
}

QString roundNumbersText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    return found.hasOneMechanism() && diagnosis.rounded != found.parameters
               ? DiagnosisText::tr("Nominal values fit equally well: %1.")
                     .arg(mechanismText(Mechanism(diagnosis.rounded), 9))
               : QString();
}

QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism)
{
    if (!diagnosis.change) {
        return {};
    }
    const auto [parameter, value, explained] = *diagnosis.change;
    const double given = valueOf(mechanism.parameters(), parameter);
    const int digits = digitsToTellApart(value, given);
    constexpr double kNearlyAll = 1.0 - 1e-6; // never 100 %
    constexpr double kSlack = 1e-3;           // 99.5 % equals 995 tenths except for rounding
    return DiagnosisText::tr("With %1 instead of %2, %3 % of the difference disappears.")
        .arg(equationText(parameter, value, digits), parameterText(parameter, given, digits),
             numberText(std::floor(1e6 * std::min(explained, kNearlyAll) + kSlack) / 1e4));
}

} // namespace slidercrank
