// SPDX-License-Identifier: GPL-3.0-or-later
// A claim that is printed is true, or marked as what it is: files of known origin, kind by kind, and what the program
// says of them.
//
//     SLIDERCRANK_CLAIM_KIND   only the kinds whose name contains this
//     SLIDERCRANK_CLAIM_SEED   another suite of files
//     SLIDERCRANK_CLAIM_RUNS   so many of each kind
//     SLIDERCRANK_CLAIM_FILE   only the file of that number
//     SLIDERCRANK_CLAIM_DIR    where the files of which something is wrong are written

#include "core/mechanism/in_parallel.h"
#include "tests/support/claim_judge.h"
#include "tests/support/long_tests.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <variant>

using namespace slidercrank;

namespace
{

/// The sanitizers, thirty times slower, look at memory and not at numbers: a few files are enough for them.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kForMemoryOnly = true;
#else
constexpr bool kForMemoryOnly = false;
#endif

constexpr std::uint64_t kSeed = 11;

std::uint64_t suiteSeed()
{
    return qEnvironmentVariableIsSet("SLIDERCRANK_CLAIM_SEED")
               ? static_cast<std::uint64_t>(qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_SEED"))
               : kSeed;
}

struct Judged {
    ClaimJudgement judgement;
    std::string unread; ///< why the program does not read the file
    std::string text;
};

Judged judgedFile(const ClaimKind &kind, int n)
{
    Judged result;
    const ClaimFile file = claimFile(kind, suiteSeed(), n);
    result.text = file.text;
    const auto outcome = readReferenceData(file.text);
    if (const ReferenceData *data = std::get_if<ReferenceData>(&outcome)) {
        result.judgement = judged(file, *data);
    } else if (file.text.find('\n') + 1 < file.text.size()) { // some mechanism has no pose at all
        result.unread = "is not read";
    }
    return result;
}

void writeAside(const ClaimKind &kind, int n, const std::string &text)
{
    const QString directory = qEnvironmentVariable("SLIDERCRANK_CLAIM_DIR");
    if (directory.isEmpty()) {
        return;
    }
    QString name = QString::fromUtf8(kind.name.data(), static_cast<qsizetype>(kind.name.size()));
    for (QChar &c : name) {
        c = c.isLetterOrNumber() ? c : QLatin1Char('_');
    }
    QDir().mkpath(directory);
    QFile file(QStringLiteral("%1/%2-%3.csv").arg(directory, name).arg(n));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(text.data(), static_cast<qint64>(text.size()));
    }
}

} // namespace

class TestClaims : public QObject
{
    Q_OBJECT

private slots:
    void areTrueOfEveryKind()
    {
        const QByteArray wanted = qgetenv("SLIDERCRANK_CLAIM_KIND");
        const bool one = qEnvironmentVariableIsSet("SLIDERCRANK_CLAIM_FILE");
        const int asked = qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_RUNS");
        const int first = qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_FILE");

        std::printf("%-46s %5s %5s %5s %5s %5s | %5s %5s %5s\n", "kind", "ident", "ambig", "insuf", "near", "none",
                    "false", "fixed", "miss");
        int falseClaims = 0;
        int misses = 0;
        int fixing = 0;
        int allFiles = 0;
        for (const ClaimKind &kind : claimKinds()) {
            if (kind.name.find(std::string_view(wanted.data(), static_cast<std::size_t>(wanted.size()))) ==
                std::string_view::npos) {
                continue;
            }
            const int files = one ? 1 : asked > 0 ? asked : kForMemoryOnly ? 1 : std::max(kind.fewest, runs(50, 500));
            std::vector<Judged> all(static_cast<std::size_t>(files));
            inParallel(all.size(), [&](std::size_t i) { all[i] = judgedFile(kind, first + static_cast<int>(i)); });
            std::array<int, 6> outcomes{};
            int wrong = 0;
            int fixed = 0;
            int missed = 0;
            std::string remarks;
            for (std::size_t i = 0; i < all.size(); ++i) {
                const ClaimJudgement &judgement = all[i].judgement;
                const std::string &reason = !all[i].unread.empty()          ? all[i].unread
                                            : !judgement.falseClaim.empty() ? judgement.falseClaim
                                                                            : judgement.miss;
                ++outcomes[static_cast<std::size_t>(judgement.outcome)];
                wrong += !judgement.falseClaim.empty() || !all[i].unread.empty();
                fixed += judgement.fixes;
                missed += !judgement.miss.empty();
                if (!reason.empty()) {
                    remarks += "    " + std::to_string(first + static_cast<int>(i)) + ": " + reason + '\n';
                    writeAside(kind, first + static_cast<int>(i), all[i].text);
                }
            }
            std::printf("%-46s %5d %5d %5d %5d %5d | %5d %5d %5d\n%s", std::string(kind.name).c_str(), outcomes[0],
                        outcomes[1], outcomes[2], outcomes[3], outcomes[4], wrong, fixed, missed, remarks.c_str());
            std::fflush(stdout);
            falseClaims += wrong;
            misses += missed;
            fixing += fixed;
            allFiles += files;
        }
        std::printf("%d files, %d false claims, %d misses among %d that fix the mechanism\n", allFiles, falseClaims,
                    misses, fixing);
        QVERIFY(allFiles > 0);
        QCOMPARE(falseClaims, 0);
        QVERIFY2(kForMemoryOnly || 100 * misses <= fixing, "more than 1 % are missed");
    }

    /// ± is honest: how often the truth lies within one, two, three standard errors.
    void haveStandardErrorsThatHold_data()
    {
        QTest::addColumn<bool>("noisy");
        QTest::newRow("white noise") << true;
        QTest::newRow("only rounded") << false;
    }
    void haveStandardErrorsThatHold()
    {
        QFETCH(bool, noisy);
        constexpr int kFiles = kForMemoryOnly ? 20 : 1000;
        const auto fileOf = [noisy](int n) {
            Dice dice(suiteSeed() * 1000003U + static_cast<std::uint64_t>(n) * 2U + (noisy ? 1U : 0U));
            ClaimFile file;
            file.truth = anyMechanism(dice);
            setInstants(file, dice, dice.uniform(0.8, 3.0), dice.whole(60, 300));
            file.columns = plottedColumns({NumberForm::Rule::Digits, noisy ? 8 : 6}, dice.chance(0.5) ? 0x3F : 0x03);
            for (ClaimColumn &each : file.columns) {
                each.noise = noisy ? 0.005 * swingOf(file, each.shown) : 0.0;
            }
            finish(file, dice);
            return file;
        };
        std::vector<std::vector<double>> off(kFiles);
        inParallel(off.size(), [&](std::size_t i) {
            const ClaimFile file = fileOf(static_cast<int>(i));
            const auto outcome = readReferenceData(file.text);
            off[i] = standardErrorsOff(file, claimOf(std::get<ReferenceData>(outcome), Mechanism()));
        });
        int count = 0;
        int files = 0;
        std::array<int, 3> within{};
        for (const std::vector<double> &file : off) {
            files += !file.empty();
            for (const double ratio : file) {
                ++count;
                for (std::size_t k = 0; k < within.size(); ++k) {
                    within[k] += ratio <= static_cast<double>(k + 1);
                }
            }
        }
        const auto percent = [&](int some) { return 100.0 * some / count; };
        std::printf("%d files identified, %.2f %.2f %.2f %% within one, two, three standard errors\n", files,
                    percent(within[0]), percent(within[1]), percent(within[2]));
        QVERIFY(files >= 95 * kFiles / 100);
        if (kForMemoryOnly) {
            return;
        }
        if (noisy) {
            QVERIFY(std::abs(percent(within[0]) - 68.0) <= 4.0);
            QVERIFY(std::abs(percent(within[1]) - 95.0) <= 2.0);
            QVERIFY(std::abs(percent(within[2]) - 99.7) <= 0.6);
        } else {
            QVERIFY(percent(within[2]) >= 99.0);
        }
    }
};

QTEST_APPLESS_MAIN(TestClaims)
#include "tst_claims.moc"
