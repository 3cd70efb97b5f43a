// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/design_text.h"

#include "core/mechanism/channel.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct DesignText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::DesignText)
};

} // namespace

QString designFaultText(const DesignFault &fault, const DesignRequest &request)
{
    constexpr int kDigits = 4;
    constexpr double kNearOne = 1.001; // a smaller time ratio needs more digits to differ from 1
    constexpr int kDigitsNearOne = 9;
    const QString ratio = numberText(request.timeRatio < 1.0 ? 1.0 / request.timeRatio : request.timeRatio);
    switch (fault.reason) {
    case DesignFault::Reason::StrokeNotPositive: return DesignText::tr("The stroke must be greater than 0.");
    case DesignFault::Reason::TimeRatioOutOfRange:
        return DesignText::tr(
                   "There is no such mechanism: a crank that makes full turns has a time ratio below 3, not %1.")
            .arg(ratio);
    case DesignFault::Reason::TransmissionAngleTooLarge:
        if (fault.timeRatioBound <= 1.0) {
            return DesignText::tr("There is no such mechanism: every minimum transmission angle is below 90°.");
        }
        return DesignText::tr(
                   "There is no such mechanism: with a time ratio of %1 the minimum transmission angle is at most %2°; "
                   "an angle of %3° needs a time ratio below %4.")
            .arg(ratio, numberText(fault.bound * kDegreesPerRadian, kDigits),
                 numberText(*request.transmissionAngle * kDegreesPerRadian, kDigits),
                 numberText(fault.timeRatioBound, fault.timeRatioBound < kNearOne ? kDigitsNearOne : kDigits));
    case DesignFault::Reason::CouplerTooShort:
        return DesignText::tr("There is no such mechanism: the coupler b must be longer than the crank a.");
    case DesignFault::Reason::TimeRatioTooLarge:
        return DesignText::tr(
                   "There is no such mechanism: with these lengths a and b the time ratio is below %1, not %2.")
            .arg(numberText(fault.bound, kDigits), ratio);
    }
    return {};
}

} // namespace slidercrank
