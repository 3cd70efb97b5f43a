// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that everything the program claims about files of known origin is true, for each kind of file.

#include "core/mechanism/in_parallel.h"
#include "tests/support/claim_judge.h"
#include "tests/support/claim_suite.h"
#include "tests/support/long_tests.h"
#include "tests/support/suite.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstdio>
#include <variant>
#include <vector>

using namespace slidercrank;

class TestClaims : public QObject
{
    Q_OBJECT

private slots:
    void areTrueForEveryKind()
    {
        std::vector<ClaimKind> kinds;
        for (const std::span<const ClaimKind> group :
             {plainKinds(), limitKinds(), conventionKinds(), otherMotionKinds()}) {
            kinds.insert(kinds.end(), group.begin(), group.end());
        }
        const ClaimTotals totals = runClaimSuite(kinds, runs(10, 500));
        QCOMPARE(totals.falseClaims, 0);
        QVERIFY2(kIsMemoryCheck || 100 * totals.missed <= totals.determined, "more than 1 % are missed");
    }

    void standardErrorsHold_data()
    {
        QTest::addColumn<bool>("isNoisy");
        QTest::newRow("white noise") << true;
        QTest::newRow("only rounded") << false;
    }
    void standardErrorsHold()
    {
        QFETCH(bool, isNoisy);
        const int files = kIsMemoryCheck ? 20 : runs(200, 1000);
        std::vector<std::vector<double>> errors(static_cast<std::size_t>(files));
        inParallel(errors.size(), [&](std::size_t i) {
            ClaimFile file(claimSeed() * 1000003U + i * 2U + (isNoisy ? 1U : 0U), static_cast<int>(i));
            file.sample(file.random.uniform(0.8, 3.0), file.random.whole(60, 300));
            file.add(file.random.chance(0.5) ? kSix : Channels{kTheta, kX}, digits(isNoisy ? 8 : 6));
            file.setNoise(isNoisy ? 0.005 : 0.0);
            file.print();
            const auto outcome = readReferenceData(file.text);
            errors[i] = errorsInStandardErrors(file, claimAbout(std::get<ReferenceData>(outcome), Mechanism()));
        });
        int parameters = 0;
        int identified = 0;
        std::array<int, 3> within{};
        for (const std::vector<double> &file : errors) {
            identified += !file.empty();
            for (const double error : file) {
                ++parameters;
                for (std::size_t k = 0; k < within.size(); ++k) {
                    within[k] += error <= static_cast<double>(k + 1);
                }
            }
        }
        QVERIFY(identified >= 95 * files / 100);
        const auto percent = [&](std::size_t k) { return 100.0 * within[k] / parameters; };
        std::printf("%d identified; %.2f %.2f %.2f %% within one, two, three standard errors\n", identified, percent(0),
                    percent(1), percent(2));
        const double chance = std::sqrt(1000.0 / files); // the tolerance grows if there are fewer files
        if (isNoisy && !kIsMemoryCheck) {
            QVERIFY(std::abs(percent(0) - 68.0) <= 4.0 * chance);
            QVERIFY(std::abs(percent(1) - 95.0) <= 2.0 * chance);
            QVERIFY(std::abs(percent(2) - 99.7) <= 0.6 * chance);
        } else if (!kIsMemoryCheck) {
            QVERIFY(percent(2) >= 99.0);
        }
    }
};

const Suite suite("tst_claims", runWithoutApplication<TestClaims>);
#include "tst_claims.moc"
