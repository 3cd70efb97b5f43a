// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/identification_text.h"

#include "ui/text/channel_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/enum_table.h"
#include "ui/text/parameter_text.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;
using Lack = Identification::Lack;
using Rejection = Identification::Rejection;
using Symmetry = AlternativeMechanism::Symmetry;
using Reason = LeftOutColumn::Reason;
using Scale = Identification::LengthScale;

// Significant digits.
constexpr int kDigitsWithoutError = 4; // of a parameter without a standard error
constexpr int kSpeedDigits = 4;
constexpr int kGivenDigits = 6;

struct IdentificationText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::IdentificationText)

public:
    struct OutcomeRow {
        Outcome key;
        const char *name; ///< in JSON
        const char *text; ///< %1: the parameters, or the reason why there are none
    };
    static constexpr OutcomeRow kOutcomes[] = {
        {Outcome::Identified, "identified", QT_TR_NOOP("Mechanism identified in this file: %1.")},
        {Outcome::Approximate, "approximate", QT_TR_NOOP("Mechanism that approximately explains this file: %1.")},
        {Outcome::Insufficient, "insufficient", QT_TR_NOOP("This file does not determine the mechanism. %1")},
        {Outcome::None, "none", QT_TR_NOOP("No mechanism explains this file. %1")}};

    struct LackRow {
        Lack key;
        const char *text; ///< what is open, and what would help; %1: the open parameters
    };
    static constexpr LackRow kLacks[] = {
        {Lack::FewValues, QT_TR_NOOP("It contains too few values: export more time steps or more columns.")},
        {Lack::NothingMoves,
         QT_TR_NOOP("In no column that was read does the slider or the coupler move: name the column of the slider's "
                    "position or of the coupler's angle, or export one while the crank turns.")},
        {Lack::FewRowsPerTurn,
         QT_TR_NOOP("It has fewer than four rows per revolution, so that several crank speeds give the same "
                    "values: more rows per revolution, derivatives or θ₂ would help.")},
        {Lack::UnevenSpeed, QT_TR_NOOP("The crank speed varies, so that derivatives alone do not show the mechanism: "
                                       "positions of the slider or angles of the coupler would help.")},
        {Lack::OpenParameters,
         QT_TR_NOOP("Open: %1. A longer part of a revolution, derivatives, θ₂ or more digits would help.")},
        {Lack::Nothing, ""}};

    struct RejectionRow {
        Rejection key;
        const char *text; ///< %1: the largest residual in percent of the range, %2: its column
    };
    static constexpr RejectionRow kRejections[] = {
        {Rejection::LargeResiduals, QT_TR_NOOP("The best attempt deviates by up to %1 % of the range of %2: "
                                               "check the meaning and the units of the columns. Unless the crank "
                                               "speed is constant, the file must contain θ₂.")},
        {Rejection::SliderLine, QT_TR_NOOP("R4_y is not constant: the slider does not move parallel to the x axis.")},
        {Rejection::CannotBeAssembled,
         QT_TR_NOOP("The mechanisms that come near cannot be assembled in all of its rows: check the meaning "
                    "and the units of the columns.")}};

    struct SymmetryRow {
        Symmetry key;
        const char *name; ///< in JSON
        const char *text;
    };
    static constexpr SymmetryRow kSymmetries[] = {
        {Symmetry::MirrorImage, "mirror-image",
         QT_TR_NOOP("Its mirror image, with c, ω₂ and θ₂₀ negated, gives the same values.")},
        {Symmetry::ReversedCrank, "reversed",
         QT_TR_NOOP("A crank that rotates in the opposite direction, from 180° − θ₂₀, gives the same "
                    "values.")},
        {Symmetry::OtherAssembly, "other-assembly",
         QT_TR_NOOP("The other assembly, with c negated and θ₂₀ increased by 180°, gives the same "
                    "values.")}};

    struct ReasonRow {
        Reason key;
        const char *name; ///< in JSON
        const char *text;
    };
    static constexpr ReasonRow kReasons[] = {
        {Reason::FiniteDifferences, "finite-differences",
         QT_TR_NOOP("agrees with finite differences, not with the derivative")},
        {Reason::UnevenSpeed, "uneven-speed", QT_TR_NOOP("the crank speed is not constant")},
        {Reason::OpenSpeed, "open-speed", QT_TR_NOOP("the crank speed is unknown")},
        {Reason::OtherMotion, "other-motion", QT_TR_NOOP("the motion of a different mechanism")},
        {Reason::Unknown, "unknown", QT_TR_NOOP("does not fit the other columns")}};
};

static_assert(isCompleteTable(IdentificationText::kOutcomes, Outcome::None));
static_assert(isCompleteTable(IdentificationText::kLacks, Lack::Nothing));
static_assert(isCompleteTable(IdentificationText::kRejections, Rejection::CannotBeAssembled));
static_assert(isCompleteTable(IdentificationText::kSymmetries, Symmetry::OtherAssembly));
static_assert(isCompleteTable(IdentificationText::kReasons, Reason::Unknown));

/// Returns whether the value of the parameter follows from the data, if necessary together with the given a or ω₂.
bool isMeasured(Parameter parameter, const Identification &found)
{
    const bool isCrank = parameter == Parameter::A;
    const bool isRatio = parameter == Parameter::B || parameter == Parameter::C;
    const bool isScaled = (found.lengthScale == Scale::GivenCrank && isRatio) ||
                          (found.lengthScale == Scale::GivenSpeed && (isRatio || isCrank));
    const bool isDetermined =
        found.outcome == Outcome::Insufficient && std::isfinite(found.standardErrors[indexOf(parameter)]);
    return found.identifiable[indexOf(parameter)] || isScaled || isDetermined;
}

/// Returns the equation of a measured parameter: "a = 20.001 ± 0.002 mm".
QString measuredEquation(Parameter parameter, const Identification &found)
{
    const QString equation = QString(found.hasSystematicResiduals ? "%1 ≈ %2" : "%1 = %2")
                                 .arg(symbolText(parameter), measuredText(parameter, found, notationOf(found)));
    if (parameter != Parameter::Omega2 || !found.drive) {
        return equation;
    }
    return found.drive->alpha2 ? IdentificationText::tr("%1 at t = 0").arg(equation)
                               : IdentificationText::tr("%1 on average").arg(equation);
}

QStringList measuredEquations(const Identification &found)
{
    QStringList texts;
    for (const Parameter parameter : kAllParameters) {
        if (isMeasured(parameter, found)) {
            texts << measuredEquation(parameter, found);
        }
    }
    return texts;
}

/// Returns the column with the largest residual relative to its range, or null.
const ColumnResidual *worstResidual(const Identification &found)
{
    const auto worst = std::ranges::max_element(found.residuals, {}, &ColumnResidual::percentOfRange);
    return worst == found.residuals.end() ? nullptr : &*worst;
}

/// Says how large the residuals of an approximate mechanism are, and what that means for its parameters.
QString residualText(const Identification &found)
{
    const ColumnResidual *worst = worstResidual(found);
    if (found.outcome != Outcome::Approximate || !worst) {
        return {};
    }
    if (found.followsApproximateFormula) {
        return IdentificationText::tr("The columns agree with the approximate formula Rₓ⁴ ≈ a cos θ₂ + b − (a sin θ₂ − "
                                      "c)²/2b. From the exact motion they deviate by up to %1 % of the range of %2.")
            .arg(errorText(worst->percentOfRange), symbolText(worst->channel));
    }
    const QString text =
        found.hasSystematicResiduals
            ? IdentificationText::tr("The columns deviate from its motion by up to %1 % of the range "
                                     "of %2. The residuals are systematic, so that no standard errors can be given: "
                                     "the data may be filtered, interpolated or integrated, or the crank speed may "
                                     "vary.")
            : IdentificationText::tr("The columns deviate from its motion by up to %1 % of the range "
                                     "of %2, more than by rounding; ± holds if these errors are "
                                     "independent.");
    return text.arg(errorText(worst->percentOfRange), symbolText(worst->channel));
}

/// Says which parameters are those of the given mechanism, because the data do not determine them.
QString keptText(const Identification &found)
{
    QStringList symbols, equations;
    for (const Parameter parameter : kAllParameters) {
        if (!isMeasured(parameter, found)) {
            symbols << symbolText(parameter);
            equations << equationText(parameter, valueOf(found.parameters, parameter), kGivenDigits, notationOf(found));
        }
    }
    return symbols.isEmpty() ? QString()
                             : IdentificationText::tr("The data do not determine %1. Kept as given: %2.")
                                   .arg(listed(symbols), equations.join(", "));
}

/// Names the speeds that the derivatives allow if their units leave several.
QString possibleSpeedText(const Identification &found)
{
    QStringList speeds;
    for (const double speed : found.possibleSpeeds) {
        speeds << numberText(speed);
    }
    return speeds.isEmpty() ? QString()
                            : IdentificationText::tr("The derivatives allow ω₂ = %1 rad/s, because their unit is "
                                                     "uncertain (radians or degrees, mm or cm?): state it in the "
                                                     "headings.")
                                  .arg(anyOf(speeds));
}

/// Returns a list of line numbers, of which at most kMaxListed are shown.
QString linesText(const std::vector<std::size_t> &lines)
{
    constexpr std::size_t kMaxListed = 10;
    QStringList texts;
    for (const std::size_t line : std::span(lines).first(std::min(lines.size(), kMaxListed))) {
        texts << QString::number(line);
    }
    if (lines.size() > kMaxListed) {
        texts << "…";
    }
    return texts.join(", ");
}

/// Names the outliers by their lines in the file.
QString excludedText(const std::vector<std::size_t> &lines)
{
    return lines.empty() ? QString()
                         : IdentificationText::tr("Outliers that were excluded: %1 (lines %2).")
                               .arg(QString::number(lines.size()), linesText(lines));
}

/// Returns the sentences that follow the parameters of a mechanism, from its residuals to the rows that were excluded.
/// Some of the sentences are empty.
QStringList reservations(const Identification &found)
{
    QStringList sentences{residualText(found)};
    if (found.lengthScale == Scale::GivenCrank) {
        sentences << IdentificationText::tr("The coupler angle θ³ alone determines only b/a and c/a.");
    } else if (found.lengthScale == Scale::GivenSpeed) {
        sentences << IdentificationText::tr("Derivatives over the crank angle determine only b/a, c/a and the product "
                                            "a·ω₂: the lengths hold for the given ω₂.");
    }
    for (const AlternativeMechanism &alternative : found.alternatives) {
        sentences << IdentificationText::tr(rowOf(IdentificationText::kSymmetries, alternative.symmetry).text);
    }
    sentences << keptText(found) << possibleSpeedText(found) << driveText(found);
    if (const QString columns = leftOutText(found); !columns.isEmpty()) {
        sentences << columns;
    }
    return sentences << excludedText(found.excludedRows);
}

QString insufficientText(const Identification &found)
{
    QStringList open;
    for (const Parameter parameter : kAllParameters) {
        if (found.openParameters[indexOf(parameter)]) {
            open << symbolText(parameter);
        }
    }
    const QString text =
        IdentificationText::tr(rowOf(IdentificationText::kLacks, found.lack).text).replace("%1", listed(open));
    const QStringList determined = measuredEquations(found);
    return determined.isEmpty() ? text
                                : IdentificationText::tr("It determines %1.").arg(listed(determined)) + u' ' + text;
}

QString rejectionText(const Identification &found)
{
    const ColumnResidual *worst = worstResidual(found);
    if (found.rejection == Rejection::LargeResiduals && !worst) {
        return IdentificationText::tr("Check the meaning and the units of the columns.");
    }
    const QString text = IdentificationText::tr(rowOf(IdentificationText::kRejections, found.rejection).text);
    return found.rejection == Rejection::LargeResiduals
               ? text.arg(errorText(worst->percentOfRange), symbolText(worst->channel))
               : text;
}

} // namespace

const char *outcomeName(Outcome outcome)
{
    return rowOf(IdentificationText::kOutcomes, outcome).name;
}

const char *symmetryName(Symmetry symmetry)
{
    return rowOf(IdentificationText::kSymmetries, symmetry).name;
}

const char *reasonName(Reason reason)
{
    return rowOf(IdentificationText::kReasons, reason).name;
}

Notation notationOf(const Identification &found)
{
    Notation notationOfFile = notation();
    if (notationOfFile.units.length == LengthUnit::Millimetre) { // the default: no unit was chosen
        notationOfFile.units.length = lengthUnitWithSize(found.lengthUnit);
    }
    return notationOfFile;
}

QString measuredText(Parameter parameter, const Identification &found, const Notation &shown)
{
    if (!isMeasured(parameter, found)) {
        return dash();
    }
    const double factor = shownFactor(parameter, shown);
    const QString unit = unitSuffix(parameter, shown);
    const double value = factor * valueOf(found.parameters, parameter);
    const double standardError = found.standardErrors[indexOf(parameter)];
    if (found.hasSystematicResiduals || (found.drive && std::isnan(standardError))) {
        return numberText(value, kDigitsWithoutError) + unit;
    }
    double scale = characteristicLength(found.parameters);
    if (parameter == Parameter::Omega2) {
        scale = std::abs(found.parameters.omega2);
    } else if (parameter == Parameter::Theta20) {
        scale = 1.0;
    }
    return measuredText(value, factor * standardError, factor * scale) + unit;
}

QString summaryText(const Identification &found)
{
    if (found.stopped) {
        return IdentificationText::tr("The search was stopped.");
    }
    const QString text = IdentificationText::tr(rowOf(IdentificationText::kOutcomes, found.outcome).text);
    if (!found.hasMechanism()) {
        return text.arg(found.outcome == Outcome::Insufficient ? insufficientText(found) : rejectionText(found));
    }
    const QStringList mechanism = measuredEquations(found) << assemblyPhrase(found.parameters.branch);
    QStringList sentences = reservations(found);
    sentences.prepend(text.arg(mechanism.join(", ")));
    sentences.removeAll(QString());
    return sentences.join(u' ');
}

/// Returns whether the number has at most `digits` significant digits.
static bool hasFewDigits(double number, int digits)
{
    constexpr double kArithmetic = 1e-14; // relative error of a conversion of units
    const double rounded = QString::number(number, 'g', digits).toDouble();
    return std::abs(rounded - number) <= kArithmetic * std::abs(number);
}

/// Returns the notation in which the lengths are round numbers: that of the other texts, or the unit in which they were
/// rounded if 20 mm would be 0.787401575 in.
static Notation notationOfRoundLengths(const Identification &found, int digits)
{
    Notation shown = notationOf(found);
    const auto isRound = [&](double length) {
        return hasFewDigits(shownValue(Measure::Length, length, shown.units), digits);
    };
    const Parameters &rounded = found.rounded;
    if (!isRound(rounded.a) || !isRound(rounded.b) || !isRound(rounded.c)) {
        shown.units.length = lengthUnitWithSize(found.lengthUnit);
    }
    return shown;
}

QString roundNumbersText(const Identification &found)
{
    constexpr int kDigits = 9;
    if (!found.hasMechanism() || found.rounded == found.parameters) {
        return {};
    }
    const Notation shown = notationOfRoundLengths(found, kDigits);
    QStringList equations;
    for (const Parameter parameter : kAllParameters) {
        if (isMeasured(parameter, found) && !(parameter == Parameter::Omega2 && found.drive)) {
            equations << equationText(parameter, valueOf(found.rounded, parameter), kDigits, shown);
        }
    }
    return IdentificationText::tr("Rounded values that fit equally well: %1.").arg(equations.join(", "));
}

QString singleLengthExplanation(const Identification &found, const Parameters &given)
{
    if (!found.change) {
        return {};
    }
    const auto [parameter, value] = *found.change;
    const double before = valueOf(given, parameter);
    const int digits = digitsToTellApart(value, before);
    const QString text =
        found.outcome == Outcome::Identified
            ? IdentificationText::tr("With %1 instead of %2, this mechanism agrees with the file.")
            : IdentificationText::tr("With %1 instead of %2, this mechanism fits the file as well as any other.");
    const Notation shown = notationOf(found);
    const QString sentence =
        text.arg(equationText(parameter, value, digits, shown), parameterText(parameter, before, digits, shown));
    return found.drive ? sentence + u' ' + IdentificationText::tr("The crank speed of the file is not constant.")
                       : sentence;
}

QString outlierText(const Identification &found)
{
    const std::vector<std::size_t> &lines = found.excludedRows;
    if (lines.empty()) {
        return {};
    }
    const QString text = lines.size() == 1 ? IdentificationText::tr("Line %1 is far from the motion: a typing error?")
                                           : IdentificationText::tr("Lines %1 are far from the motion: typing errors?");
    return text.arg(linesText(lines));
}

QString leftOutText(const Identification &found)
{
    QStringList columns;
    for (const LeftOutColumn &column : found.leftOut) {
        const bool isUnusedAngle =
            column.channel == Channel{Theta2, Order::Position} && column.reason == Reason::OpenSpeed;
        const QString reason = isUnusedAngle
                                   ? IdentificationText::tr("it has gaps, or its rows are too far apart")
                                   : IdentificationText::tr(rowOf(IdentificationText::kReasons, column.reason).text);
        columns << (std::isnan(column.percentOfPeak)
                        ? QStringLiteral("%1 (%2)").arg(symbolText(column.channel), reason)
                        : IdentificationText::tr("%1 (%2; off by up to %3 % of its peak)")
                              .arg(symbolText(column.channel), reason, errorText(column.percentOfPeak)));
    }
    return columns.isEmpty() ? QString()
                             : IdentificationText::tr("Columns left out of the fit: %1.").arg(columns.join(", "));
}

std::vector<QStringList> residualTable(const std::vector<ColumnResidual> &residuals)
{
    std::vector<QStringList> rows{{IdentificationText::tr("channel"), IdentificationText::tr("rms residual"),
                                   IdentificationText::tr("largest residual"), IdentificationText::tr("% of range")}};
    for (const ColumnResidual &residual : residuals) {
        rows.push_back({QStringLiteral("%1 [%2]").arg(columnName(residual.channel), unitText(residual.channel)),
                        errorText(residual.rms), errorText(residual.max), errorText(residual.percentOfRange)});
    }
    return rows;
}

QString driveText(const Identification &found)
{
    if (!found.drive) {
        return {};
    }
    const auto &[omega2, standardError, least, greatest, alpha2] = *found.drive;
    const int digits = std::min(digitsToTellApart(least, greatest), kSpeedDigits);
    const QString range = IdentificationText::tr("The crank speed varies from %1 to %2 rad/s")
                              .arg(numberText(least, digits), numberText(greatest, digits));
    return alpha2 ? IdentificationText::tr("%1; it changes evenly, α₂ = %2 rad/s².")
                        .arg(range, numberText(*alpha2, kSpeedDigits))
                  : range + u'.';
}

QString shownDriveText(const Identification &found, double omega2)
{
    return found.drive ? IdentificationText::tr("%1 The window shows the motion at the mean speed, %2 rad/s, because a "
                                                "changing speed is not modelled: compare the positions over the crank "
                                                "angle.")
                             .arg(driveText(found), numberText(omega2, kSpeedDigits))
                       : QString();
}

} // namespace slidercrank
