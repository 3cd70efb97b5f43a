// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/diagnosis_text.h"

#include "ui/text/convention_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Lack = Identification::Lack;
using Outcome = Identification::Outcome;
using Why = Identification::Alternative::Why;

struct DiagnosisText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::DiagnosisText)
};

/// b/a or c/a, a being given.
QString measuredRatio(Parameter parameter, const Identification &found)
{
    const Parameters &p = found.parameters;
    return measuredText(valueOf(p, parameter) / p.a, found.standardError[indexOf(parameter)] / p.a,
                        (p.a + p.b + std::abs(p.c)) / p.a);
}

bool isLength(Parameter parameter)
{
    return parameter == Parameter::A || parameter == Parameter::B || parameter == Parameter::C;
}

/// The value of a parameter and its unit, to the three digits that an approximate mechanism deserves.
QString approximateText(Parameter parameter, const Parameters &p)
{
    constexpr int kDigits = 3;
    return numberText(shownFactor(parameter) * valueOf(p, parameter), kDigits) + unitBehind(parameter);
}

/// The parameters found and those kept, each of them written out.
struct FoundAndKept {
    QStringList found;
    QStringList kept;
};

FoundAndKept foundAndKept(const Identification &identification)
{
    FoundAndKept lists;
    for (const Parameter parameter : kParameters) {
        if (identification.onlyRatios && isLength(parameter)) {
            if (parameter != Parameter::A) {
                lists.found << DiagnosisText::tr("%1/a = %2")
                                   .arg(symbolOf(parameter), measuredRatio(parameter, identification));
            }
        } else if (identification.identifiable[indexOf(parameter)]) {
            lists.found << DiagnosisText::tr("%1 = %2").arg(symbolOf(parameter),
                                                            measuredText(parameter, identification));
        } else {
            lists.kept << DiagnosisText::tr("%1 = %2").arg(
                symbolOf(parameter), parameterText(parameter, valueOf(identification.parameters, parameter)));
        }
    }
    return lists;
}

/// As many decimals as it takes to see how much is missing, four at most; never rounded up.
QString percentText(double part)
{
    constexpr int kMostDecimals = 4;
    constexpr double kSlack = 1e-9; // 99.5 is 995 tenths, whatever its last digit
    const double missing = 100.0 * (1.0 - part);
    const int decimals = missing > 0.0 ? std::clamp(-static_cast<int>(std::floor(std::log10(missing * (1.0 + kSlack)))),
                                                    0, kMostDecimals)
                                       : kMostDecimals;
    const double unit = std::pow(10.0, -decimals);
    const double shown = std::min(std::floor((100.0 - missing) / unit + kSlack) * unit, 100.0 - unit);
    return QLocale().toString(shown, 'f', decimals);
}

/// Of what no column excludes.
QString imageSentence(const Identification::Alternative &alternative)
{
    switch (alternative.why) {
    case Why::MirrorImage:
        return DiagnosisText::tr("These columns cannot tell it from its mirror image (c, ω₂ and θ₂₀ negated).");
    case Why::Reversed:
        return DiagnosisText::tr("These columns cannot tell it from one that turns the other way, from 180° − θ₂₀.");
    case Why::OtherAssembly:
        return DiagnosisText::tr("These columns cannot tell it from the other assembly with c negated and θ₂₀ half a "
                                 "turn on.");
    case Why::Alias:
    case Why::AnotherMechanism: break;
    }
    return DiagnosisText::tr("These columns cannot tell it from %1.")
        .arg(mechanismText(Mechanism(alternative.parameters)));
}

/// "a = 20.000001 ± 0.000003 mm, …, open assembly"
QString measuredMechanism(const Identification &found)
{
    return (foundAndKept(found).found << withNoun(found.parameters.branch)).join(DiagnosisText::tr(", "));
}

/// In a bracket behind the mechanism; may be empty.
QString whyText(Why why)
{
    switch (why) {
    case Why::MirrorImage: return DiagnosisText::tr(" (mirror image)");
    case Why::Reversed: return DiagnosisText::tr(" (turning the other way)");
    case Why::OtherAssembly: return DiagnosisText::tr(" (the other assembly)");
    case Why::Alias: return DiagnosisText::tr(" (another speed that meets the same instants)");
    case Why::AnotherMechanism: break;
    }
    return {};
}

/// The channel that is farthest from the mechanism found; none where nothing was compared.
const ChannelComparison *worstChannel(const Diagnosis &diagnosis)
{
    const ChannelComparison *worst = nullptr;
    for (const ChannelComparison &channel : diagnosis.identified) {
        if (channel.percentOfPeak && (!worst || *channel.percentOfPeak > *worst->percentOfPeak)) {
            worst = &channel;
        }
    }
    return worst;
}

/// "a ≈ 43 mm, … explain the file up to 0.02 % of peak"
QString approximateSentence(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    QStringList values;
    for (const Parameter parameter : kParameters) {
        if (found.identifiable[indexOf(parameter)]) {
            values << DiagnosisText::tr("%1 ≈ %2").arg(symbolOf(parameter),
                                                       approximateText(parameter, found.parameters));
        } else if (found.onlyRatios && isLength(parameter) && parameter != Parameter::A) {
            values << DiagnosisText::tr("%1/a ≈ %2")
                          .arg(symbolOf(parameter),
                               numberText(valueOf(found.parameters, parameter) / found.parameters.a, 3));
        }
    }
    const ChannelComparison *const worst = worstChannel(diagnosis);
    return DiagnosisText::tr(
               "%1, %2 explain the file up to %3 % of peak; the rest is systematic (filtered, interpolated or "
               "integrated data?), so no standard errors can be given.")
        .arg(values.join(DiagnosisText::tr(", ")), withNoun(found.parameters.branch),
             errorText(worst ? *worst->percentOfPeak : 0.0));
}

/// Which columns belong to another mechanism than the others; empty where there are none.
QString disagreementSentence(const Identification &found)
{
    QStringList columns;
    for (const Identification::LeftOut &column : found.leftOut) {
        columns << DiagnosisText::tr("%1 (%2 % of its peak)")
                       .arg(symbolOf(column.channel), errorText(column.percentOfPeak));
    }
    return columns.isEmpty() ? QString()
                             : DiagnosisText::tr("It fits the other columns, but these disagree with them: %1.")
                                   .arg(columns.join(DiagnosisText::tr(", ")));
}

/// Columns that take no part in the fit, and rows that were taken for outliers; a sentence each.
QStringList exclusionSentences(const Identification &found)
{
    QStringList sentences;
    for (const Identification::LeftOut &column : found.leftOut) {
        sentences << DiagnosisText::tr(
                         "%1 deviates by %2 % of its peak from the motion of the other columns and was left out.")
                         .arg(symbolOf(column.channel), errorText(column.percentOfPeak));
    }
    if (!found.excludedRows.empty()) {
        constexpr std::size_t kMostListed = 10;
        QStringList lines;
        for (const std::size_t line : found.excludedRows) {
            if (lines.size() == kMostListed) {
                lines << QStringLiteral("…");
                break;
            }
            lines << QString::number(line);
        }
        sentences << DiagnosisText::tr("Rows far off the motion were left out: %n, line %1.", nullptr,
                                       static_cast<int>(found.excludedRows.size()))
                         .arg(lines.join(DiagnosisText::tr(", ")));
    }
    return sentences;
}

QString ambiguityOf(const Identification &found)
{
    QStringList mechanisms{measuredMechanism(found)};
    bool hasAlias = false;
    for (const Identification::Alternative &alternative : found.alternatives) {
        mechanisms << mechanismText(Mechanism(alternative.parameters)) + whyText(alternative.why);
        hasAlias = hasAlias || alternative.why == Why::Alias;
    }
    const QString text = DiagnosisText::tr("%1 mechanisms explain this file equally: %2.")
                             .arg(mechanisms.size())
                             .arg(mechanisms.join(DiagnosisText::tr("; or ")));
    return hasAlias ? text + u' ' + DiagnosisText::tr("More instants a turn, derivatives or θ₂ would tell them apart.")
                    : text;
}

QString lackSentence(const Identification &found)
{
    switch (found.lack) {
    case Lack::Nothing:
    case Lack::FewValues: break;
    case Lack::FewInstants:
        return DiagnosisText::tr("There are too few instants to find the mechanism: export more of them.");
    case Lack::NothingMoves:
        return DiagnosisText::tr("Nothing moves in these data: export the motion of a turning crank.");
    case Lack::NoEvidence:
        return DiagnosisText::tr("So few values fit many mechanisms by chance: export more instants, or more columns.");
    case Lack::OpenParameters: {
        QStringList open;
        for (const Parameter parameter : kParameters) {
            if (found.openParameters[indexOf(parameter)]) {
                open << symbolOf(parameter);
            }
        }
        return DiagnosisText::tr(
                   "These data do not determine %1: export a longer motion, more digits, or more columns.")
            .arg(listed(open));
    }
    case Lack::Crooked:
        return DiagnosisText::tr(
            "Many mechanisms move nearly as these data do: export a longer motion, more digits, or "
            "more columns.");
    }
    return DiagnosisText::tr(
        "There are too few values of the coupler angle θ³, the slider position Rₓ⁴, the coupler's centre R³ and their "
        "derivatives to find the mechanism: export more instants, or more columns.");
}

QString crankSpeedSentence(const CrankSpeedChange &speed)
{
    constexpr int kMostDigits = 9;
    int digits = 4; // more where those do not show the change to two digits
    while (digits < kMostDigits &&
           std::abs(speed.atEnd - speed.atStart) < 20.0 * std::abs(speed.atStart) * std::pow(10.0, 1 - digits)) {
        ++digits;
    }
    return DiagnosisText::tr(
               "The crank speed is not constant: θ₂ turns at %1 rad/s at the start and %2 rad/s at the end.")
        .arg(numberText(speed.atStart, digits), numberText(speed.atEnd, digits));
}

QString nearestSentence(const Diagnosis &diagnosis)
{
    constexpr int kDigits = 4;
    const QString mechanism = mechanismText(Mechanism(diagnosis.identification.parameters), kDigits);
    const ChannelComparison *const worst = worstChannel(diagnosis);
    return !worst
               ? DiagnosisText::tr("No mechanism was found that explains this file. The nearest: %1.").arg(mechanism)
               : DiagnosisText::tr("No mechanism was found that explains this file. The nearest: %1, off by up to %2 % "
                                   "of peak, in %3.")
                     .arg(mechanism, errorText(*worst->percentOfPeak), symbolOf(worst->channel));
}

} // namespace

QString measuredText(Parameter parameter, const Identification &found)
{
    const Parameters &p = found.parameters;
    if (found.outcome == Outcome::Approximate && found.identifiable[indexOf(parameter)]) {
        return approximateText(parameter, p);
    }
    if (found.onlyRatios && (parameter == Parameter::B || parameter == Parameter::C)) {
        return DiagnosisText::tr("%1 a").arg(measuredRatio(parameter, found));
    }
    if (!found.identifiable[indexOf(parameter)]) {
        return QStringLiteral("–");
    }
    const double scale = parameter == Parameter::Omega2    ? std::abs(p.omega2)
                         : parameter == Parameter::Theta20 ? 1.0
                                                           : p.a + p.b + std::abs(p.c);
    const double factor = shownFactor(parameter);
    return measuredText(factor * valueOf(p, parameter), factor * found.standardError[indexOf(parameter)],
                        factor * scale) +
           unitBehind(parameter);
}

QString caveatsOf(const Diagnosis &diagnosis)
{
    const Identification &identification = diagnosis.identification;
    QStringList sentences;
    if (identification.onlyRatios) {
        sentences << DiagnosisText::tr(
                         "The coupler angle θ³ alone determines only b/a and c/a; a = %1 is taken as given.")
                         .arg(parameterText(Parameter::A, identification.parameters.a));
    }
    if (identification.hasOneMechanism()) {
        for (const Identification::Alternative &alternative : identification.alternatives) {
            sentences << imageSentence(alternative);
        }
    }
    if (diagnosis.isSpeedOfDerivatives) {
        sentences << DiagnosisText::tr("The file is a table by crank angle: ω₂ follows from its derivatives.");
    }
    if (const QStringList kept = foundAndKept(identification).kept; !kept.isEmpty()) {
        sentences << DiagnosisText::tr("The data do not determine %1: kept as given.").arg(listed(kept));
    }
    if (diagnosis.mayBeInMetres) {
        sentences << DiagnosisText::tr(
                         "The file does not say the unit of its lengths, and they were read as mm: if they "
                         "are metres, a = %1; then write [m] behind the names.")
                         .arg(parameterText(Parameter::A, 1e3 * diagnosis.rounded.a));
    }
    sentences << exclusionSentences(identification);
    if (!identification.noise.empty()) {
        QStringList columns;
        for (const Identification::Noise &noise : identification.noise) {
            const QString unit = unitOf(noise.channel);
            columns << QStringLiteral("%1 %2%3%4")
                           .arg(symbolOf(noise.channel), errorText(noise.rms),
                                unit.startsWith(u'°') ? QString() : QStringLiteral(" "), unit);
        }
        sentences << DiagnosisText::tr("What remains looks like noise: %1 (rms).").arg(listed(columns));
    }
    if (diagnosis.unevenCrank) {
        sentences << crankSpeedSentence(*diagnosis.unevenCrank);
    }
    return sentences.join(u' ');
}

QString summaryOf(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    if (found.stopped) {
        return DiagnosisText::tr("The search was stopped.");
    }
    if (found.stands()) {
        const QString mechanism = found.outcome == Outcome::Identified    ? measuredMechanism(found) + u'.'
                                  : found.outcome == Outcome::Approximate ? approximateSentence(diagnosis)
                                                                          : ambiguityOf(found);
        const QString caveats = caveatsOf(diagnosis);
        return caveats.isEmpty() ? mechanism : mechanism + u' ' + caveats;
    }
    const QString text =
        found.outcome == Outcome::Insufficient ? lackSentence(found)
        : found.outcome == Outcome::Nearest    ? nearestSentence(diagnosis)
        : diagnosis.unevenCrank
            ? DiagnosisText::tr("No mechanism was found that explains this file.")
            : DiagnosisText::tr(
                  "No mechanism was found that explains this file: check which column is which, and their units.");
    QStringList sentences{text};
    if (diagnosis.unevenCrank) {
        sentences.prepend(crankSpeedSentence(*diagnosis.unevenCrank));
    }
    if (found.outcome == Outcome::Nearest) {
        sentences << disagreementSentence(found);
    }
    sentences.removeAll(QString());
    return sentences.join(u' ');
}

QStringList differenceLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism)
{
    QStringList lines;
    for (const ConventionFinding &finding : diagnosis.conventions) {
        lines << explanationOf(finding.convention, data) + u' ' + effectOf(finding);
    }
    if (!lines.isEmpty() && diagnosis.isOfMechanismAtHand) {
        lines << DiagnosisText::tr("Read this way, it does not differ from this mechanism.");
    } else if (const QString change = changeText(diagnosis, mechanism); !change.isEmpty()) {
        lines << change;
    }
    return lines << differenceSentences(data, diagnosis.conventions);
}

QStringList explanationLines(const Diagnosis &diagnosis, const ReferenceData &data, const Mechanism &mechanism)
{
    QStringList lines = differenceLines(diagnosis, data, mechanism);
    if (!diagnosis.isOfMechanismAtHand) {
        const QString summary = summaryOf(diagnosis);
        lines << (diagnosis.identification.hasOneMechanism()
                      ? DiagnosisText::tr("The file's own mechanism: %1").arg(summary)
                      : summary);
    }
    return lines;
}

QString roundNumbersText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    if (!found.hasOneMechanism() || diagnosis.rounded == found.parameters) {
        return {};
    }
    constexpr int kDigits = 9;
    return DiagnosisText::tr("Round numbers fit the data as well: %1.")
        .arg(mechanismText(Mechanism(diagnosis.rounded), kDigits));
}

QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism)
{
    if (!diagnosis.change) {
        return {};
    }
    const ParameterChange &found = *diagnosis.change;
    const double factor = shownFactor(found.parameter);
    const double before = factor * valueOf(mechanism.parameters(), found.parameter);
    const double after = factor * found.value;
    constexpr int kMostDigits = 12;
    int digits = 5; // of what was measured; more where those do not tell the two apart
    while (digits < kMostDigits && numberText(after, digits) == numberText(before, digits)) {
        ++digits;
    }
    return DiagnosisText::tr("This error looks like %1 = %2 instead of %3%4, which explains %5 % of it.")
        .arg(symbolOf(found.parameter), numberText(after, digits), numberText(before, digits + 1),
             unitBehind(found.parameter), percentText(found.explained));
}

} // namespace slidercrank
