// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/check_text.h"

#include "ui/text/enum_table.h"
#include "ui/text/notation.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <cmath>

namespace slidercrank
{

namespace
{

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::CheckText)

public:
    /// The subjects of "… gives exactly your v and a."
    static constexpr EnumText<Slip> kSlips[] = {
        {Slip::OtherAssembly, QT_TR_NOOP("The other assembly")},
        {Slip::OffsetSign, QT_TR_NOOP("The offset c with the opposite sign")},
        {Slip::OffsetOmitted, QT_TR_NOOP("Omitting the offset c")},
        {Slip::CrankSpeedSign, QT_TR_NOOP("ω₂ with the opposite sign")},
        {Slip::CrankAccelerationSign, QT_TR_NOOP("α₂ with the opposite sign")},
        {Slip::CrankAccelerationOmitted, QT_TR_NOOP("Omitting α₂")},
        {Slip::CrankAngleSign, QT_TR_NOOP("θ₂ with the opposite sign")},
        {Slip::CrankAngleUnit,
         QT_TR_NOOP("Taking the degrees of θ₂ as radians (or the reverse: check the mode of the calculator)")},
        {Slip::CrankSpeedInRpm, QT_TR_NOOP("Taking ω₂ in rpm as rad/s (or the reverse)")},
        {Slip::CrankSpeedInDegrees, QT_TR_NOOP("Taking ω₂ in °/s as rad/s (or the reverse)")},
        {Slip::LinksExchanged, QT_TR_NOOP("Exchanging a and b")},
        {Slip::DiameterForRadius,
         QT_TR_NOOP("Taking twice or half the crank length a (diameter or stroke instead of radius)")},
        {Slip::CouplerAngleSign, QT_TR_NOOP("Measuring θ₃ clockwise")},
        {Slip::CrankSineForCosine, QT_TR_NOOP("Exchanging sine and cosine of θ₂")},
        {Slip::CouplerSineForCosine, QT_TR_NOOP("Exchanging sine and cosine of θ₃")},
        {Slip::CouplerAngleEnd, QT_TR_NOOP("θ₃ measured at A in a formula for θ₃ at B (or the reverse)")},
        {Slip::CrankSpeedNotSquared, QT_TR_NOOP("ω₂ instead of ω₂²")},
        {Slip::CrankNormalOmitted, QT_TR_NOOP("Omitting the centripetal term a ω₂² of the crank")},
        {Slip::CouplerNormalOmitted, QT_TR_NOOP("Omitting the centripetal term b ω₃² of the coupler")},
        {Slip::NormalsOmitted, QT_TR_NOOP("Omitting both centripetal terms (a ω₂² and b ω₃²)")},
        {Slip::HarmonicMotion,
         QT_TR_NOOP("Simple harmonic motion (that of the crank pin A instead of the wrist pin B)")},
        {Slip::TwoHarmonics,
         QT_TR_NOOP("The approximation x ≈ a cos θ₂ + b − a²/4b (1 − cos 2θ₂) with its derivatives")},
        {Slip::SecondHarmonicDouble, QT_TR_NOOP("sin 2θ₂/n instead of sin 2θ₂/2n in the velocity (n = b/a)")},
        {Slip::CouplerCentre, QT_TR_NOOP("The centre of the coupler instead of the wrist pin B")},
        {Slip::FromOuterDeadCentre, QT_TR_NOOP("Measuring from the outer dead centre towards the crank")},
        {Slip::FromInnerDeadCentre, QT_TR_NOOP("Measuring from the inner dead centre outwards")},
        {Slip::InchesAsMetricUnits, QT_TR_NOOP("Taking inches as millimetres or centimetres (or the reverse)")},
        {Slip::MetresAsMillimetres, QT_TR_NOOP("Taking metres as millimetres (or the reverse)")},
        {Slip::CentimetresAsMillimetres, QT_TR_NOOP("Taking centimetres as millimetres (or the reverse)")},
        {Slip::ValueInRadians, QT_TR_NOOP("Taking radians as degrees (or the reverse)")},
        {Slip::PressureAngle, QT_TR_NOOP("The pressure angle 90° − μ instead of μ")},
        {Slip::ObtuseAngle, QT_TR_NOOP("The obtuse angle 180° − μ instead of the acute μ")},
        {Slip::CouplerAngleRounded, QT_TR_NOOP("Rounding θ₃ to three digits")}};
    static_assert(isCompleteTable(kSlips, Slip::CouplerAngleRounded));
};

} // namespace

/// Returns the verdict on a right value. `digits`: number of its significant digits; 0 for zero.
static QString rightText(int digits)
{
    if (digits == 0) {
        return CheckText::tr("right");
    }
    return digits == 1 ? CheckText::tr("right to its only digit") : CheckText::tr("right to its %1 digits").arg(digits);
}

QString checkedValueText(const CheckedValue &checked, int digits, double deviation, const QString &unit)
{
    if (std::isnan(deviation)) {
        return CheckText::tr("does not exist here");
    }
    if (!checked.isRight) {
        constexpr int kDigits = 3;
        return CheckText::tr("off by %1").arg(shortNumber(deviation, kDigits) + unit);
    }
    const QString right = rightText(digits);
    const bool isOfTextbook = notation().symbols == Symbols::Textbook; // whose θ₃ is the one at B
    return checked.isMeasuredAtB && !isOfTextbook ? CheckText::tr("%1, measured at B (θ₃ = θ³ + 180°)").arg(right)
                                                  : right;
}

QString slipText(Slip slip, const QStringList &wrongNames)
{
    return CheckText::tr("%1 gives exactly your %2.")
        .arg(CheckText::tr(rowOf(CheckText::kSlips, slip).text), listed(wrongNames));
}

QString explanationText(const CheckResult &result, const QStringList &wrongNames)
{
    if (result.status != Status::Solved) {
        return {}; // checkedValueText() says which values do not exist
    }
    switch (result.explanation) {
    case CheckOutcome::NotNeeded: return CheckText::tr("All values are right to their last digit.");
    case CheckOutcome::SingleSlip: return slipText(result.slips.front(), wrongNames);
    case CheckOutcome::Ambiguous: {
        QStringList sentences(CheckText::tr("More than one slip is possible; more quantities or digits may decide:"));
        for (const Slip slip : result.slips) {
            sentences += slipText(slip, wrongNames);
        }
        return sentences.join(' ');
    }
    case CheckOutcome::TooFewDigits:
        return CheckText::tr("The values have too few digits to name a slip: add digits or other quantities.");
    case CheckOutcome::RoundedEarlier:
        return CheckText::tr("The deviation is within the error of an intermediate result (θ₃, ω₃, α₃) that was "
                             "rounded to three digits.");
    case CheckOutcome::None: return CheckText::tr("No known slip gives exactly these values.");
    }
    return {};
}

} // namespace slidercrank
