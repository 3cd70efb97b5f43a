// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_suite.h"

#include "core/mechanism/in_parallel.h"
#include "tests/support/claim_judge.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <variant>

namespace slidercrank
{

namespace
{

struct JudgedFile {
    ClaimJudgement judgement;
    double milliseconds = 0.0; ///< duration of the claim
    std::string text;
};

JudgedFile judgeFile(const ClaimKind &kind, int number)
{
    JudgedFile result;
    const ClaimFile file = claimFile(kind, claimSeed(), number);
    result.text = file.text;
    const auto outcome = readReferenceData(file.text);
    if (const ReferenceData *data = std::get_if<ReferenceData>(&outcome)) {
        const auto start = std::chrono::steady_clock::now();
        const ProgramClaim claim = claimAbout(*data, Mechanism(file.given));
        result.milliseconds =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        result.judgement = judgeClaim(file, *data, claim);
    } else if (file.text.find('\n') + 1 < file.text.size()) { // the file has at least one row of data
        result.judgement.falseClaim = "cannot be read";
    }
    return result;
}

void save(const ClaimKind &kind, int number, const std::string &text)
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
    QFile file(QStringLiteral("%1/%2-%3.csv").arg(directory, name).arg(number));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(text.data(), static_cast<qint64>(text.size()));
    }
}

} // namespace

std::uint64_t claimSeed()
{
    constexpr std::uint64_t kSeed = 11;
    return qEnvironmentVariableIsSet("SLIDERCRANK_CLAIM_SEED")
               ? static_cast<std::uint64_t>(qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_SEED"))
               : kSeed;
}

ClaimTotals runClaimSuite(std::span<const ClaimKind> kinds, int filesOfAKind)
{
    const QByteArray wanted = qgetenv("SLIDERCRANK_CLAIM_KIND");
    const int first = qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_FILE");
    const int asked = qEnvironmentVariableIntValue("SLIDERCRANK_CLAIM_RUNS");
    const bool isOneFile = qEnvironmentVariableIsSet("SLIDERCRANK_CLAIM_FILE");
    const int files = isOneFile || kIsMemoryCheck ? 1 : asked > 0 ? asked : filesOfAKind;
    ClaimTotals totals;
    std::vector<double> times;
    std::printf("%-46s %5s %5s %5s %5s %5s %5s | %5s %5s %5s | %6s\n", "kind", "ident", "ambig", "appro", "insuf",
                "near", "none", "false", "determ", "miss", "ms");
    for (const ClaimKind &kind : kinds) {
        if (kind.name.find(std::string_view(wanted.data(), static_cast<std::size_t>(wanted.size()))) ==
            std::string_view::npos) {
            continue;
        }
        std::vector<JudgedFile> judged(static_cast<std::size_t>(files));
        inParallel(judged.size(), [&](std::size_t i) { judged[i] = judgeFile(kind, first + static_cast<int>(i)); });
        std::array<int, kOutcomeNames.size()> outcomes{};
        ClaimTotals sums{files};
        double milliseconds = 0.0;
        std::string remarks;
        for (int number = first; const auto &[judgement, time, text] : judged) {
            const bool isFalse = !judgement.falseClaim.empty();
            const auto outcome = static_cast<std::size_t>(judgement.outcome);
            ++outcomes[outcome];
            sums.falseClaims += isFalse;
            sums.determined += judgement.isDetermined;
            sums.missed += !judgement.miss.empty();
            milliseconds += time / files;
            times.push_back(time);
            if (isFalse || !judgement.miss.empty()) {
                remarks += "    " + std::to_string(number) + ' ' + std::string(kOutcomeNames[outcome]) + ": " +
                           (isFalse ? "FALSE: " + judgement.falseClaim : judgement.miss) + '\n';
                save(kind, number, text);
            }
            ++number;
        }
        std::printf("%-46s %5d %5d %5d %5d %5d %5d | %5d %5d %5d | %6.1f\n%s", std::string(kind.name).c_str(),
                    outcomes[0], outcomes[1], outcomes[2], outcomes[3], outcomes[4], outcomes[5], sums.falseClaims,
                    sums.determined, sums.missed, milliseconds, remarks.c_str());
        std::fflush(stdout);
        totals.files += sums.files;
        totals.falseClaims += sums.falseClaims;
        totals.determined += sums.determined;
        totals.missed += sums.missed;
    }
    std::ranges::sort(times);
    const auto quantile = [&](std::size_t percent) {
        return times.empty() ? 0.0 : times[times.size() * percent / 100];
    };
    std::printf(
        "%d files, %d false claims, %d missed of %d that determine their mechanism; median %.1f ms, 95 %% within "
        "%.1f ms\n",
        totals.files, totals.falseClaims, totals.missed, totals.determined, quantile(50), quantile(95));
    return totals;
}

} // namespace slidercrank
