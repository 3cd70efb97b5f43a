// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that every claim about files with the faults of sensors, filters, loggers and spreadsheets is true, and that
// round lengths are found in spite of small systematic errors.

#include "tests/support/claim_judge.h"
#include "tests/support/claim_suite.h"
#include "tests/support/long_tests.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <variant>

using namespace slidercrank;

namespace
{

const Parameters kMechanism{43.0, 154.0, -27.0, 7.0, 0.4, Branch::Open};

/// Samples 1.6 turns with 240 rows.
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

/// Returns an error message, or an empty string if no claim is false and the outcome is the expected one.
QString wrongClaim(const Claimed &claimed, ClaimedOutcome outcome)
{
    const auto name = [](ClaimedOutcome which) { return std::string(kOutcomeNames[static_cast<std::size_t>(which)]); };
    return QString::fromStdString(claimed.claim.outcome == outcome
                                      ? claimed.judgement.falseClaim
                                      : name(claimed.claim.outcome) + " instead of " + name(outcome) + ' ' +
                                            claimed.judgement.falseClaim);
}

} // namespace

class TestFaultClaims : public QObject
{
    Q_OBJECT

private slots:
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

    void claimsAboutEveryKindAreTrue()
    {
        const ClaimTotals totals = runClaimSuite(faultKinds(), runs(10, 200));
        QCOMPARE(totals.falseClaims, 0);
        QVERIFY2(kIsMemoryCheck || 20 * totals.missed <= totals.determined, "more than 5 % are missed");
    }
};

const Suite suite("tst_fault_claims", runWithoutApplication<TestFaultClaims>);
#include "tst_fault_claims.moc"
