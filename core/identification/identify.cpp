// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/abscissa.h"
#include "core/identification/best_geometry.h"
#include "core/identification/description.h"
#include "core/identification/difference_quotients.h"
#include "core/identification/file_comparison.h"
#include "core/identification/further_columns.h"
#include "core/identification/mirror_images.h"
#include "core/identification/outcome.h"
#include "core/identification/residual_test.h"
#include "core/identification/table_conventions.h"
#include "core/identification/typing_errors.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

/// A mirror image of a geometry, with the drive of its crank and all columns that it explains.
struct ExtendedImage {
    ObservedFit observed; ///< before the columns are added
    Drive drive;
    FurtherColumns further;
};

/// Fits `image`, a mirror image of the model of a geometry, again, finds its drive, and adds the columns that it
/// explains.
ExtendedImage extendImage(ObservedFit geometry, const Model &image, const Parameters &given)
{
    Fit &fit = geometry.fit;
    fit = fitModel(geometry.searched, image, fit.columns, fit.unknowns);
    const Drive driveOfAngle = findDrive(geometry.wholeFile, fit.model);
    auto [observed, drive] = withDriveOfFile(std::move(geometry), driveOfAngle);
    FurtherColumns further = withFurtherColumns(observed.searched, observed.fit, drive, given);
    return {.observed = std::move(observed), .drive = drive, .further = std::move(further)};
}

/// Extends the mirror image of a geometry that has the simplest reading. If the geometry was found from angles alone
/// and this image leaves columns out, extends the other images as well, and returns the one that leaves out the fewest:
/// both assemblies have the same angles, but different motions of the slider.
ExtendedImage extendBestImage(const ObservedFit &geometry, const Parameters &given)
{
    const std::vector<Model> images = rankMirrorImages(geometry.searched, geometry.fit, given);
    ExtendedImage best = extendImage(geometry, images.front(), given);
    if (geometry.searched.containOnlyAngles(geometry.fit.columns)) {
        for (std::size_t i = 1; i < images.size() && !best.further.leftOut.empty(); ++i) {
            ExtendedImage next = extendImage(geometry, images[i], given);
            if (next.further.leftOut.size() < best.further.leftOut.size()) {
                best = std::move(next);
            }
        }
    }
    return best;
}

/// Adds θ2 to the columns that are left out if the file contains it but the observations do not, because it has gaps or
/// the crank may make any number of turns between two rows: the reason OpenSpeed also stands for these.
void leaveOutUnusedAngle(std::vector<LeftOutColumn> &leftOut, const ReferenceData &data,
                         const Observations &observations)
{
    if (data.find(kCrankAngle) && !observations.hasAngle()) {
        leftOut.push_back({kCrankAngle, LeftOutColumn::Reason::OpenSpeed});
    }
}

/// The step that finds the geometry, one of the functions of best_geometry.h.
using FindGeometry = ConstrainedFit (&)(const Observations &wholeFile, const Observations &searched,
                                        const Parameters &given);

/// Adds the errors of the lengths because of angles that were moved within their rounding (ObservedFit::errorsOfAngles)
/// to the possible errors of the parameters, as independent errors.
ParameterErrors withErrorsOfAngles(ParameterErrors possibleErrors, const ParameterErrors &errorsOfAngles)
{
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        possibleErrors[i] = std::hypot(possibleErrors[i], errorsOfAngles[i]);
    }
    return possibleErrors;
}

/// Runs the steps from the geometry to the last fit, and then chooses the description of it that a person expects. The
/// last fit is not finite if no mechanism can be assembled. `wholeFile`: the observations of `data`.
Findings findMechanism(const ReferenceData &data, Observations wholeFile, FindGeometry findGeometry,
                       const Parameters &given)
{
    Findings findings;
    const Observations smoothRows = withoutSpikes(wholeFile);
    Observations searched = selectRows(smoothRows, kSearchedRows);
    const ConstrainedFit geometry = findGeometry(smoothRows, searched, given);
    if (!geometry.fit.isFinite()) {
        findings.lastFit.observations = std::move(wholeFile);
        return findings;
    }
    auto [observed, drive, further] =
        extendBestImage(withBestAbscissa({std::move(wholeFile), std::move(searched), geometry.fit}), given);
    findings.drive = drive;
    findings.leftOut = std::move(further.leftOut);
    leaveOutUnusedAngle(findings.leftOut, data, observed.wholeFile);
    findings.speeds = std::move(further.speeds);
    const ConstrainedFit fitOfAllColumns = withoutFreedoms(observed.searched, std::move(further.fit), geometry);
    const ParameterErrors possibleErrors = withErrorsOfAngles(fitOfAllColumns.possibleErrors, observed.errorsOfAngles);
    findings.lastFit = fitAllRows(std::move(observed.wholeFile), fitOfAllColumns.fit, possibleErrors, findings.drive);
    if (findings.lastFit.fit.isFinite()) {
        chooseExpectedDescription(findings, observed.searched, given);
    }
    return findings;
}

/// The result for a table, and the findings that lead to it.
struct IdentifiedTable {
    Identification result;
    Findings findings{};
};

/// The arguments of identify(), with the table as it is in the file or without some of its rows.
struct IdentificationInput {
    const ReferenceData &table;
    const Parameters &given;
    const std::stop_token &stop;
};

/// Identifies the mechanism of a table by running all steps once. `tableConvention`: the convention that is applied to
/// the table before it is observed; nullopt if it is observed as it is. `findGeometry`: the step that finds the
/// geometry.
IdentifiedTable identifyTable(const IdentificationInput &input, const std::optional<Convention> &tableConvention,
                              FindGeometry findGeometry)
{
    const Parameters &given = input.given;
    const ReferenceData data = tableConvention ? applied(*tableConvention, input.table) : input.table;
    Observations wholeFile = withComputedColumnsMarked(observe(data, input.stop));
    if (const Identification::Lack lack = findLack(wholeFile); lack != Identification::Lack::Nothing) {
        return {
            {.outcome = Identification::Outcome::Insufficient, .parameters = given, .rounded = given, .lack = lack}};
    }
    IdentifiedTable table;
    table.findings = findMechanism(data, std::move(wholeFile), findGeometry, given);
    table.result = judge(data, table.findings, given);
    if (table.result.hasMechanism()) {
        addConventionsAndComparisons(table.result, input.table, tableConvention, table.findings, given);
        if (!allAgree(table.result.channels)) { // the comparison, which the user can repeat, decides
            table.result.outcome = Identification::Outcome::Approximate;
        }
    }
    return table;
}

/// Whether a result is preferred to another one: by the outcome, then by the number of columns that are left out, then
/// by the number of conventions, then by a constant speed.
bool isBetter(const Identification &result, const Identification &other)
{
    const auto rank = [](const Identification &found) {
        return std::tuple(found.outcome, found.leftOut.size(), found.conventions.size(), found.drive.has_value());
    };
    return rank(result) < rank(other);
}

/// Identifies the mechanism of a table whose slider moves along y, after the axes are rotated: once those of lengths
/// only, and once those of angles, too. Returns the better result; nullopt if the slider moves along x.
std::optional<Identification> identifyRotated(const IdentificationInput &input)
{
    std::optional<Identification> best;
    for (const bool rotatesAngles : {false, true}) {
        if (const std::optional<Convention> rotation = findAxisRotation(input.table, rotatesAngles)) {
            Identification result = identifyTable(input, rotation, findBestGeometry).result;
            if (!best || isBetter(result, *best)) {
                best = std::move(result);
            }
        }
    }
    return best;
}

/// Whether a mechanism explains all columns of the file exactly.
bool explainsAll(const Identification &result)
{
    return result.outcome == Identification::Outcome::Identified && result.leftOut.empty();
}

/// The result for a table in which `rows` were replaced by gaps, with these among the excluded rows. Returns nullopt if
/// one of them does not contradict the mechanism found. `data`: the table with all rows.
std::optional<Identification> withExcludedRows(IdentifiedTable table, const ReferenceData &data,
                                               const std::vector<std::size_t> &rows)
{
    std::vector<std::size_t> &excluded = table.result.excludedRows;
    for (const std::size_t row : rows) {
        if (!isRowContradicted(table.result, data, row, table.findings)) {
            return std::nullopt;
        }
        const std::size_t line = data.lineOfRow(row);
        excluded.insert(std::ranges::lower_bound(excluded, line), line);
    }
    return std::move(table.result);
}

/// Identifies the mechanism of a table without the rows that may contain typing errors. Leaves rows out, one after the
/// other, until a mechanism explains the remaining rows exactly: the row of the most suspicious value or, if no value
/// is suspicious, the row with the largest residual. Returns nullopt after maxTypingErrors() rows, if no row is left to
/// suspect, or if the mechanism also explains a row that was left out. `table`: the result for all rows.
std::optional<Identification> identifyWithoutTypingErrors(IdentifiedTable table, const IdentificationInput &input)
{
    ReferenceData remaining = input.table;
    std::vector<std::size_t> rows;
    while (rows.size() < maxTypingErrors(input.table)) {
        std::optional<std::size_t> row = findSuspiciousRow(remaining);
        if (!row) {
            row = findRowWithLargestResidual(table.findings.lastFit);
        }
        if (!row) {
            return std::nullopt;
        }
        rows.push_back(*row);
        remaining = withoutRow(std::move(remaining), *row);
        table = identifyTable({remaining, input.given, input.stop}, std::nullopt, findBestGeometry);
        if (explainsAll(table.result)) {
            return withExcludedRows(std::move(table), input.table, rows);
        }
    }
    return std::nullopt;
}

/// Whether the approximate formula explains the columns of the last fit better than the exact motion does. False if the
/// file does not contain θ2, which the formula needs.
bool isApproximateFormulaBetter(const LastFit &exactMotion)
{
    const Fit &fit = exactMotion.fit;
    if (!fit.isFinite() || !exactMotion.observations.hasAngle()) {
        return false;
    }
    const Observations searched = selectRows(exactMotion.observations, kSearchedRows);
    Model formula = fit.model;
    formula.isApproximateFormula = true;
    const Fit byFormula = fitModel(searched, std::move(formula), fit.columns, fit.unknowns);
    const Fit byExactMotion = fitModel(searched, fit.model, fit.columns, fit.unknowns);
    return byFormula.misfit + kMaxMisfitIncrease < byExactMotion.misfit;
}

/// Whether the conventions of a result measure R4_x from a different origin.
bool needsOrigin(const Identification &result)
{
    const Convention::Kind kind = Convention::Kind::ZeroPoint;
    return std::ranges::any_of(result.conventions, [=](const ConventionFinding &finding) {
        return finding.convention.kind == kind && concerns(finding.convention, {R4x, Order::Position});
    });
}

/// Identifies the mechanism with which the approximate formula of textbooks explains a table exactly; nullopt if there
/// is none, if it has the crossed assembly, or if the exact motion explains the table as well and as simply.
/// `asInFile`: the result with the exact motion, which may need an origin of R4_x where the formula needs none.
std::optional<Identification> identifyByApproximateFormula(const IdentifiedTable &asInFile,
                                                           const IdentificationInput &input)
{
    const LastFit &exactMotion = asInFile.findings.lastFit;
    const bool isFormulaBetter = isApproximateFormulaBetter(exactMotion);
    const bool mayAvoidOrigin = exactMotion.observations.hasAngle() && needsOrigin(asInFile.result);
    if (!isFormulaBetter && !mayAvoidOrigin) {
        return std::nullopt;
    }
    IdentifiedTable table = identifyTable(input, std::nullopt, findGeometryOfApproximateFormula);
    Identification &result = table.result;
    const bool explainsTable = result.outcome == Identification::Outcome::Approximate &&
                               table.findings.lastFit.isExact && result.leftOut.empty() && result.excludedRows.empty();
    const bool isSimpler = isFormulaBetter || !needsOrigin(result);
    const bool isEngine = result.parameters.branch == Branch::Open; // for the other assembly, nobody uses the formula
    if (!explainsTable || !isSimpler || !isEngine) {
        return std::nullopt;
    }
    result.followsApproximateFormula = true;
    return std::move(result);
}

/// Tries unlikely readings of a table (README.md): the approximate formula, the geometry of higher derivatives,
/// conventions of the table, and typing errors. Returns the best result that explains everything exactly, or that of
/// `asInFile`, the table as it is in the file, if none is better. The approximate formula, if it is accepted, comes
/// first.
Identification tryUnlikelyReadings(IdentifiedTable asInFile, const IdentificationInput &input)
{
    if (std::optional<Identification> result = identifyByApproximateFormula(asInFile, input)) {
        return *std::move(result);
    }
    Identification best = asInFile.result;
    const auto keepIfBetter = [&](Identification result) {
        if (explainsAll(result) && isBetter(result, best)) {
            best = std::move(result);
        }
    };
    if (!explainsAll(best)) {
        // Coarsely rounded positions may have been explained by a mechanism that contradicts their derivatives.
        keepIfBetter(identifyTable(input, std::nullopt, findGeometryOfHigherDerivatives).result);
    }
    for (const Convention &convention : possibleTableConventions(input.table, asInFile.result)) {
        keepIfBetter(identifyTable(input, convention, findBestGeometry).result);
    }
    // A typing error may look like a convention or, in θ2, like an uneven speed.
    const bool mayContainTypingErrors = !explainsAll(best) || !best.conventions.empty() || best.drive;
    if (mayContainTypingErrors) {
        if (auto result = identifyWithoutTypingErrors(std::move(asInFile), input)) {
            keepIfBetter(*std::move(result));
        }
    }
    return best;
}

} // namespace

Identification identify(const ReferenceData &data, const Mechanism &given, std::stop_token stop)
{
    const Parameters &parameters = given.parameters();
    const IdentificationInput input{.table = data, .given = parameters, .stop = stop};
    std::optional<Identification> result = identifyRotated(input);
    if (!result) {
        result = tryUnlikelyReadings(identifyTable(input, std::nullopt, findBestGeometry), input);
    }
    if (stop.stop_requested()) {
        Identification stopped{.parameters = parameters, .rounded = parameters};
        stopped.stopped = true;
        return stopped;
    }
    return *std::move(result);
}

} // namespace slidercrank
