// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/mobility.h"
#include "core/study/study.h"
#include "core/study/study_methods.h"
#include "tests/support/all_cases.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

using namespace slidercrank;

namespace tst_study
{

/// Returns a request that measures errors and statuses, but no accurate times.
StudyRequest quickRequest(std::vector<Case> cases)
{
    StudyRequest request;
    request.cases = std::move(cases);
    request.rounds = 1;
    request.secondsPerRound = 0.0;
    return request;
}

/// Returns the case with at most `maxSteps` time steps.
Case withFewSteps(Case reduced, int maxSteps)
{
    reduced.sampling.steps = std::min(reduced.sampling.steps, maxSteps);
    return reduced;
}

Case caseNamed(std::string_view name)
{
    for (const Case &each : allCases()) {
        if (each.name == name) {
            return each;
        }
    }
    qFatal("no such case");
}

/// Returns the results of several cases. The study measures error against cost for the first case only.
std::vector<CaseResult> studyResults(std::vector<Case> cases)
{
    return runStudy(quickRequest(std::move(cases))).cases;
}

CaseResult studyResult(const Case &namedCase)
{
    return studyResults({namedCase}).front();
}

const MethodResult *rowOf(const CaseResult &result, std::string_view method, std::optional<double> tolerance = {})
{
    const auto found = std::find_if(result.methods.begin(), result.methods.end(), [&](const MethodResult &row) {
        return nameOf(row.method) == method && row.tolerance == tolerance;
    });
    return found == result.methods.end() ? nullptr : &*found;
}

double errorOf(const CaseResult &result, std::string_view method, std::optional<double> tolerance = {})
{
    const MethodResult *row = rowOf(result, method, tolerance);
    return row && row->maxError ? *row->maxError : std::numeric_limits<double>::quiet_NaN();
}

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    void namesTheDocumentedMethods()
    {
        std::set<std::string> names;
        for (const StudyMethod &method : studyMethods()) {
            names.insert(nameOf(method.name));
        }
        const std::set<std::string> expected{
            "newton-dense", "newton-dense-taylor", "newton-structured", "newton-structured-taylor",
            "closed-form",  "closed-form-batch",   "finite-difference", "harmonic-2",
            "harmonic-4",   "harmonic-8",          "harmonic-16",       "harmonic-32"};
        QCOMPARE(names, expected);
    }

    void smallerTolerancesAreNotLessAccurate()
    {
        const CaseResult result = studyResult(withFewSteps(nominalCases()[0], 50));
        for (const char *method :
             {"newton-dense", "newton-dense-taylor", "newton-structured", "newton-structured-taylor"}) {
            double before = 1.0;
            for (const double tolerance : {1e-4, 1e-8, 1e-12, 0.0}) {
                const double error = errorOf(result, method, tolerance);
                constexpr double kNoise = 1e-14; // errors below this are rounding errors
                QVERIFY2(error <= before + kNoise, method);
                before = error;
            }
            QVERIFY2(before < kSilentFraction, method);
            QCOMPARE_LE(before, 2.0 * *rowOf(result, method, 0.0)->errorBound + 1e-15);
        }
        QCOMPARE_LT(errorOf(result, "newton-structured-taylor", 1e-12),
                    errorOf(result, "newton-structured-taylor", 1e-4));
    }

    void combinesTheResultsOfAllCases()
    {
        // A rocker, in which some time stamps are impossible and the Fourier series does not apply, and an ordinary
        // crank.
        const StudyResult study = runStudy(
            quickRequest({withFewSteps(caseNamed("rocker, one arc"), 20), withFewSteps(nominalCases()[0], 20)}));
        const std::vector<MethodResult> combined = resultsOverAllCases(study);
        QCOMPARE(combined.size(), study.cases.back().methods.size());
        for (const MethodResult &row : combined) {
            double largestError = 0.0;
            std::size_t states = 0;
            for (const CaseResult &each : study.cases) {
                if (const MethodResult *single = rowOf(each, nameOf(row.method), row.tolerance)) {
                    largestError = std::max(largestError, single->maxError.value_or(0.0));
                    states += single->stateCount;
                }
            }
            QCOMPARE(row.maxError.value_or(0.0), largestError);
            QCOMPARE(row.stateCount, states);
            QVERIFY(!row.errorBound);
        }
        const auto closedForm = std::ranges::find(combined, MethodName::Kind::ClosedForm,
                                                  [](const MethodResult &row) { return row.method.kind; });
        QVERIFY(closedForm->counts[static_cast<std::size_t>(Status::NotAssemblable)] > 0);
        QCOMPARE(closedForm->status, Status::NotAssemblable);
    }

    void differencesAreSecondOrderInTheStep()
    {
        std::vector<Case> cases(4, nominalCases()[0]);
        for (int steps = 50; Case & namedCase : cases) {
            namedCase.sampling.steps = steps;
            steps *= 2;
        }
        double before = 0.0;
        for (const CaseResult &result : studyResults(cases)) {
            const double error = errorOf(result, "finite-difference");
            if (before > 0.0) {
                const double ratio = before / error;
                QVERIFY2(ratio > 3.6 && ratio < 4.4,
                         qPrintable(QString("%1 time stamps: %2 times less").arg(result.timeStampCount).arg(ratio)));
            }
            before = error;
        }
    }

    void harmonicsFallWithTheirNumber()
    {
        const CaseResult result = studyResult(withFewSteps(nominalCases()[0], 50));
        double before = 1.0;
        for (const char *method : {"harmonic-2", "harmonic-4", "harmonic-8", "harmonic-16", "harmonic-32"}) {
            const double error = errorOf(result, method);
            QVERIFY2(error < 0.2 * before, qPrintable(QString("%1: %2 after %3").arg(method).arg(error).arg(before)));
            before = error;
        }
        QCOMPARE_LT(before, 2e-13); // only rounding errors, which grow with n²
    }

    void twoHarmonicsEqualTheTextbookFormula()
    {
        // Norton, section 13.2, c = 0: ẍ ≈ -r ω² (cos ωt + (r/l) cos 2ωt), up to terms of (r/l)³.
        const Parameters parameters{.a = 20.0, .b = 400.0, .c = 0.0, .omega2 = 3.0};
        const double ratio = parameters.a / parameters.b;
        std::vector<double> times;
        for (int i = 0; i < 24; ++i) {
            times.push_back(0.1 * i);
        }
        StudyOutput output;
        output.values.fill(times);
        output.statuses.resize(times.size());
        const auto isHarmonic2 = [](const StudyMethod &method) { return nameOf(method.name) == "harmonic-2"; };
        std::ranges::find_if(studyMethods(), isHarmonic2)->prepare(Mechanism(parameters), times)(output);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double angle = 3.0 * times[i];
            const double expected = -20.0 * 9.0 * (std::cos(angle) + ratio * std::cos(2.0 * angle));
            QCOMPARE_LT(std::abs(output.values[5][i] - expected), 20.0 * 9.0 * ratio * ratio * ratio);
        }
    }

    void errorBoundIsInverseToTheGap()
    {
        std::vector<Case> cases;
        for (const char *name : {"toggle gap 1e-4, c > 0", "toggle gap 1e-6, c > 0", "toggle gap 1e-8, c > 0"}) {
            cases.push_back(withFewSteps(caseNamed(name), 20));
        }
        double before = 0.0;
        for (const CaseResult &result : studyResults(cases)) {
            const double bound = rowOf(result, "closed-form")->errorBound.value();
            if (before > 0.0) { // the bound grows with 1/gap
                QVERIFY2(bound / before > 90.0 && bound / before < 110.0, result.name.c_str());
            }
            before = bound;
        }
    }

    /// Tests every case. Harmonics need a crank that makes full turns.
    void onlyApproximationsAreSilentlyWrong()
    {
        std::vector<Case> cases = allCases();
        std::ranges::transform(cases, cases.begin(), [](const Case &full) { return withFewSteps(full, 24); });
        const std::vector<CaseResult> results = studyResults(cases);
        QCOMPARE(results.size(), cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const Case &namedCase = cases[i];
            const CaseResult &result = results[i];
            const Mobility mobility = motionLimits(Mechanism(namedCase.parameters)).mobility;
            QCOMPARE(result.timeStampCount, timeStampsOf(namedCase).size());
            QCOMPARE(rowOf(result, "harmonic-2") != nullptr, mobility == Mobility::FullTurn);
            for (const MethodResult &row : result.methods) {
                const bool isDifference = row.method.kind == MethodName::Kind::FiniteDifference;
                const std::size_t states =
                    isDifference ? std::size_t(namedCase.sampling.steps) + 1 : result.timeStampCount;
                QCOMPARE(std::accumulate(row.counts.begin(), row.counts.end(), std::size_t{0}), states);
                QCOMPARE(row.silentFailures.has_value(), row.maxError.has_value());
                QCOMPARE(row.maxError.has_value(), row.counts[std::size_t(Status::Solved)] > 0);
                if (mobility == Mobility::Impossible) {
                    QVERIFY(row.status == Status::NotAssemblable && !row.maxError && !row.errorBound);
                }
                const bool mayBeWrong = isDifference || row.method.kind == MethodName::Kind::Harmonics;
                const bool isWrong = row.silentFailures.value_or(0) > 0;
                QVERIFY2(isWrong == (mayBeWrong && row.maxError.value_or(0.0) > kSilentFraction),
                         qPrintable(QString("%1, %2, tolerance %3: %4 of %5 silently wrong, error %6")
                                        .arg(namedCase.name.c_str(), nameOf(row.method).c_str())
                                        .arg(row.tolerance.value_or(-1.0))
                                        .arg(row.silentFailures.value_or(0))
                                        .arg(result.timeStampCount)
                                        .arg(row.maxError.value_or(0.0))));
            }
        }
    }

    void reportsTheWorstStatus()
    {
        const CaseResult result = studyResult(withFewSteps(caseNamed("lengths x 1e9"), 20));
        const MethodResult *report =
            rowOf(result, "newton-dense", 1e-8); // mm: smaller than the rounding error of the residual
        QCOMPARE(report->status, Status::IterationLimit);
        QVERIFY(report->counts[static_cast<std::size_t>(Status::IterationLimit)] > 0);
        QCOMPARE(rowOf(result, "newton-structured", 1e-8)->status, Status::Solved);
    }

    /// For a fixed set of outputs, a smaller step makes differences more accurate and every method slower. An exact
    /// method has only one row, or the same error in all rows.
    void reportsErrorAndCost()
    {
        const StudyResult study = runStudy(quickRequest({nominalCases()[0], nominalCases()[1]}));
        QVERIFY(study.cases[1].workPrecision.empty());
        for (const MethodResult &row : study.cases[0].methods) {
            QVERIFY2(row.nanosecondsPerState > 0.0 && row.spread >= 0.0, nameOf(row.method).c_str());
            QVERIFY2(row.errorBound && *row.errorBound > 5e-16 && *row.errorBound < 5e-15, nameOf(row.method).c_str());
            QCOMPARE(row.iterationsPerState.has_value(), row.tolerance.has_value());
            QCOMPARE(row.linearSolvesPerState.value_or(2.0), row.iterationsPerState.value_or(0.0) + 2.0);
        }
        double before = 1.0;
        std::size_t steps = kWorkPrecisionSteps;
        int closedForms = 0;
        for (const MethodResult &row : study.cases[0].workPrecision) {
            QVERIFY((row.stateCount - 1) % kWorkPrecisionSteps == 0 && row.nanosecondsPerState > 0.0 && row.maxError);
            closedForms += row.method.kind == MethodName::Kind::ClosedForm ? 1 : 0;
            if (row.method.kind == MethodName::Kind::FiniteDifference) {
                QCOMPARE(row.stateCount, steps + 1);
                QVERIFY(*row.maxError < before / 3.0);
                before = *row.maxError;
                steps *= 2;
            } else if (row.method.kind == MethodName::Kind::NewtonDense && row.tolerance == 0.0) {
                QVERIFY(*row.maxError < 1e-13 && *row.linearSolvesPerState > 2.0);
            }
        }
        QCOMPARE(steps, std::size_t{64 * kWorkPrecisionSteps});
        QCOMPARE(closedForms, 1);
    }

    void progressRisesToOne()
    {
        std::vector<double> progress;
        const StudyResult result = runStudy(twoCases(), {}, [&](double fraction) { progress.push_back(fraction); });
        QVERIFY(std::ranges::is_sorted(progress) && progress.size() > 20);
        QCOMPARE(progress.back(), 1.0);
        // Measuring error against cost, in the middle of the study, is reported, too.
        QVERIFY(std::ranges::any_of(progress, [](double fraction) { return fraction > 0.4 && fraction < 0.6; }));
        QVERIFY(result.complete);
        QCOMPARE(result.cases.size(), std::size_t(2));
    }

    void aStoppedStudyHasTheCompletedCases()
    {
        constexpr double kProgressInSecondCase = 0.8;
        std::stop_source stop;
        std::vector<double> progress;
        const StudyResult result = runStudy(twoCases(), stop.get_token(), [&](double fraction) {
            progress.push_back(fraction);
            if (fraction > kProgressInSecondCase) {
                stop.request_stop();
            }
        });
        QVERIFY(std::ranges::is_sorted(progress) && progress.back() < 1.0);
        QVERIFY(!result.complete);
        QCOMPARE(result.cases.size(), std::size_t(1));
    }

private:
    static StudyRequest twoCases()
    {
        return quickRequest({withFewSteps(nominalCases()[0], 10), withFewSteps(nominalCases()[1], 10)});
    }
};

const Suite<TestStudy> suite("tst_study");

} // namespace tst_study

#include "tst_study.moc"
