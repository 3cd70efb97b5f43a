// SPDX-License-Identifier: GPL-3.0-or-later
// Every claim about files with the faults of sensors, filters, loggers and spreadsheets is true; and one file for each
// fault that was once misread.

#include "tests/support/claim_deviation.h"
#include "tests/support/claim_judge.h"
#include "tests/support/claim_suite.h"
#include "tests/support/long_tests.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <variant>

using namespace slidercrank;

namespace
{

const Parameters kMechanism{43.0, 154.0, -27.0, 7.0, 0.4, Branch::Open};

/// 240 rows of 1.6 turns.
ClaimFile emptyFile(const Parameters &mechanism = kMechanism)
{
    ClaimFile file(1, 0);
    file.truth = mechanism;
    for (int i = 0; i < 240; ++i) {
        file.instants.push_back(0.006 * i);
    }
    file.tolerance = 1e-5;
    return file;
}

/// A turn of two degrees a row, counted from another origin (°).
ClaimFile fileByAngle(double origin)
{
    ClaimFile file = emptyFile({43.0, 154.0, -27.0, 2.0 * std::numbers::pi, 0.0, Branch::Open});
    file.instants.clear();
    for (int degrees = 0; degrees <= 360; degrees += 2) {
        file.instants.push_back(degrees / 360.0);
    }
    file.byAngle = ClaimFile::ByAngle{1.0, origin};
    file.add({kX, kTheta});
    return file;
}

struct Claimed {
    ProgramClaim claim;
    ClaimJudgement judgement;
};

Claimed claimAbout(ClaimFile file)
{
    file.print();
    const auto outcome = readReferenceData(file.text);
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    if (data == nullptr) {
        return {{}, {.falseClaim = "cannot be read"}};
    }
    const ProgramClaim claim = claimAbout(*data, Mechanism(file.given));
    return {claim, judgeClaim(file, *data, claim)};
}

void averageNineRows(ClaimFile &file)
{
    for (ClaimColumn &column : file.columns) {
        for (const double t : file.instants) {
            double sum = 0.0;
            for (int i = -4; i <= 4; ++i) {
                sum += file.exactValue(column.shown, t + 0.006 * i);
            }
            column.values.push_back(sum / 9.0);
        }
        column.content = ClaimColumn::Content::Systematic;
    }
    file.mayBeApproximate = true;
}

/// Empty if there is no false claim and the outcome is that one.
QString wrongClaim(const Claimed &claimed, ClaimedOutcome outcome)
{
    const auto name = [](ClaimedOutcome which) { return std::string(kOutcomeNames[static_cast<std::size_t>(which)]); };
    return QString::fromStdString(claimed.claim.outcome == outcome
                                      ? claimed.judgement.falseClaim
                                      : name(claimed.claim.outcome) + " instead of " + name(outcome) + ' ' +
                                            claimed.judgement.falseClaim);
}

bool hasStandardErrors(const ProgramClaim &claim)
{
    return std::ranges::any_of(claim.standardError, [](double error) { return std::isfinite(error); });
}

} // namespace

class TestFaultClaims : public QObject
{
    Q_OBJECT

private slots:
    /// The slider of a crossed assembly, driven with a ripple: an open mechanism is off by 200 %.
    void nearestIsTheMechanismThatWasFitted()
    {
        ClaimFile file = emptyFile({43.0, 154.0, -27.0, 7.0, 0.4, Branch::Crossed});
        file.motion = [truth = *file.truth](double t) {
            const double theta2 = truth.theta20 + truth.omega2 * t;
            return poseAt(truth, theta2 + 0.04 * std::sin(2.3 * theta2), truth.omega2);
        };
        file.add(kX, digits(7));
        file.columns[0].content = ClaimColumn::Content::Foreign;
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Nearest), QString());
        QVERIFY(!hasStandardErrors(claimed.claim));
        QVERIFY(!claimed.claim.identified.empty());
        for (const ChannelComparison &channel : claimed.claim.identified) {
            QVERIFY(channel.percentOfPeak.value_or(100.0) < 5.0);
        }
    }

    void originOfTheCrankAngleIsAFinding()
    {
        ClaimFile file = fileByAngle(20.0);
        file.interpretations = {{*file.truth, {{"zero-point", {kCrank}, -20.0}}}};
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QCOMPARE(claimed.claim.findings.size(), std::size_t(1));
    }

    /// By angle, changed signs of all derivatives are those of a crank that turns the other way.
    void findingsReduceTheDeviation()
    {
        ClaimFile file = fileByAngle(0.0);
        file.add({kV, kOmega});
        file.at(kV).factor = file.at(kOmega).factor = -1.0;
        Parameters reversed = *file.truth;
        reversed.omega2 *= -1.0;
        file.interpretations = {{*file.truth, {{"sign", {kV, kOmega}, -1.0}}},
                                {*file.truth, {{"sign", {kV}, -1.0}, {"sign", {kOmega}, -1.0}}},
                                {reversed, {}}};
        const Claimed claimed = claimAbout(file);
        QCOMPARE(QString::fromStdString(claimed.judgement.falseClaim), QString());
        for (const ProgramClaim::ClaimedFinding &finding : claimed.claim.findings) {
            QVERIFY(finding.after < finding.before);
        }
    }

    void averagedPositionsAreApproximate_data()
    {
        QTest::addColumn<Channels>("channels");
        QTest::newRow("R4_x") << Channels{kX};
        QTest::newRow("R4_x and theta3") << Channels{kX, kTheta};
        QTest::newRow("six columns") << kSix;
    }
    void averagedPositionsAreApproximate()
    {
        QFETCH(Channels, channels);
        ClaimFile file = emptyFile();
        file.add(channels, digits(8));
        averageNineRows(file);
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Approximate), QString());
        QVERIFY(!hasStandardErrors(claimed.claim));
        QVERIFY(std::abs(claimed.claim.parameters.a - 43.0) < 0.5);
    }

    void integrationErrorsLeadToRoundNumbers()
    {
        ClaimFile file = emptyFile();
        file.add(kSix, digits(9));
        file.compute();
        for (ClaimColumn &column : file.columns) {
            const double size = 1e-5 * file.swing(column.shown);
            for (std::size_t row = 0; row < file.instants.size(); ++row) {
                column.values[row] += size * std::sin(4.7 * file.instants[row]);
            }
            column.content = ClaimColumn::Content::Systematic;
        }
        file.mayBeApproximate = true;
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Approximate), QString());
        QCOMPARE(claimed.claim.rounded.a, 43.0);
        QCOMPARE(claimed.claim.rounded.b, 154.0);
        QCOMPARE(claimed.claim.rounded.c, -27.0);
    }

    void columnThatTakesNoPartIsNamed()
    {
        ClaimFile file = emptyFile();
        file.add(kSix);
        Parameters other = *file.truth;
        other.b *= 1.06;
        double deviation = 0.0;
        for (const double t : file.instants) {
            file.at(kV).values.push_back(static_cast<double>(motionAt(other, t)[indexOf(kV)]));
            deviation = std::max(deviation, std::abs(file.at(kV).values.back() - file.exactValue(kV, t)));
        }
        file.at(kV).content = ClaimColumn::Content::Foreign;
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QCOMPARE(claimed.claim.leftOut.size(), std::size_t(1));
        QCOMPARE(claimed.claim.leftOut[0].channel, kV);
        const double percent =
            100.0 * deviation / std::ranges::max(file.at(kV).values, {}, [](double v) { return std::abs(v); });
        QVERIFY(std::abs(claimed.claim.leftOut[0].value) < 1.1 * std::abs(percent));
    }

    void wrongReadingsAreNamedByLine_data()
    {
        QTest::addColumn<double>("reading");
        QTest::addColumn<double>("noise"); ///< mm
        QTest::newRow("zero") << 0.0 << 0.0;
        QTest::newRow("-9999") << -9999.0 << 0.0;
        QTest::newRow("spike in noise") << 170.0 << 0.1;
    }
    void wrongReadingsAreNamedByLine()
    {
        QFETCH(double, reading);
        QFETCH(double, noise);
        ClaimFile file = emptyFile();
        file.add({kX, kTheta}, digits(7));
        file.at(kX).noise = noise;
        file.compute();
        file.at(kX).values[100] = reading;
        file.badRows = {100};
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QCOMPARE(claimed.claim.excludedLines, std::vector<std::size_t>{102});
    }

    void quantizedAnglesAreRounding()
    {
        ClaimFile file = emptyFile();
        file.add({kCrank, kX}, digits(9));
        file.at(kCrank).form.quantum = 360.0 / 1024.0;
        file.tolerance = 2e-3;
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QVERIFY(!claimed.claim.crankSpeeds);
    }

    void noisyDerivativesAreLeftOut()
    {
        const ClaimKind kind =
            *std::ranges::find(faultKinds(), "Savitzky-Golay derivatives of noisy positions", &ClaimKind::name);
        const Claimed claimed = claimAbout(claimFile(kind, 3, 1));
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QVERIFY(isLeftOut(claimed.claim, kA) && isLeftOut(claimed.claim, kAlpha));
    }

    void columnsOfTwoMechanismsDisagree()
    {
        ClaimFile file = emptyFile();
        file.add(kSix);
        Parameters other = *file.truth;
        other.b *= 1.1;
        for (ClaimColumn &column : file.columns) {
            for (const double t : file.instants) {
                const bool isOther = column.shown.coordinate == Theta3;
                column.values.push_back(
                    static_cast<double>(motionAt(isOther ? other : *file.truth, t)[indexOf(column.shown)]));
            }
        }
        file.truth = std::nullopt;
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Nearest), QString());
        QVERIFY(!claimed.claim.leftOut.empty() ||
                std::ranges::count(claimed.claim.identified, Verdict::Differs, &ChannelComparison::verdict) > 0);
    }

    void repeatedTimesOfEventsAreRead()
    {
        ClaimFile file = emptyFile();
        file.add(kSix);
        file.repeatedRows = {50, 51, 120};
        const Claimed claimed = claimAbout(file);
        QCOMPARE(wrongClaim(claimed, ClaimedOutcome::Identified), QString());
        QVERIFY(claimed.judgement.isRight);
    }

    void claimsAboutEveryKindAreTrue()
    {
        const ClaimTotals totals = runClaimSuite(faultKinds(), runs(10, 200));
        QCOMPARE(totals.falseClaims, 0);
        QVERIFY2(kIsMemoryCheck || 20 * totals.missed <= totals.determined, "more than 5 % are missed");
    }
};

QTEST_APPLESS_MAIN(TestFaultClaims)
#include "tst_fault_claims.moc"
