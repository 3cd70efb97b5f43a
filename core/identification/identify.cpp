// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/identification/difference_quotients.h"
#include "core/identification/drive.h"
#include "core/identification/file_reading.h"
#include "core/identification/findings.h"
#include "core/identification/freedoms.h"
#include "core/identification/further_columns.h"
#include "core/identification/geometry.h"
#include "core/identification/given_mechanism.h"
#include "core/identification/last_fit.h"
#include "core/identification/mirror_images.h"
#include "core/identification/outcome.h"
#include "core/identification/round_values.h"
#include "core/identification/rounding_test.h"
#include "core/identification/speed_candidates.h"

#include "core/import/crank_angles.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr Index kSearchedRows = 400; // the largest number of rows that any step but the last fit uses

/// The columns of a fit of θ3 and R4_x may come from two mechanisms, each of which explains one column exactly. Then
/// returns the fit of R4_x alone; otherwise the same fit.
Fit withoutContradictingColumn(const Observations &searched, const Fit &fit)
{
    if (fit.columns.size() != 2 || isExact(searched, fit)) {
        return fit;
    }
    Fit alone;
    for (const Index column : fit.columns) {
        Unknowns unknowns = fit.unknowns;
        std::erase_if(unknowns, [&](Unknown unknown) { return !unknown.isParameter() && unknown.column != column; });
        alone = fitModel(searched, fit.model, {column}, unknowns);
        if (!isExact(searched, alone) || isShortArc(searched, alone.model)) {
            return fit;
        }
    }
    return alone; // the fit of the last column, R4_x: shapeColumns() lists it after θ3
}

/// The geometry of some columns, without the freedoms that they do not need. `searched`: selected rows of `wholeFile`.
ConstrainedFit findConstrainedGeometry(const Observations &wholeFile, const Observations &searched,
                                       const Indices &columns, const Parameters &given)
{
    const std::vector<double> speeds =
        wholeFile.hasAngle() ? std::vector<double>() : findSpeedCandidates(wholeFile, columns);
    Fit fit = withoutContradictingColumn(searched, findGeometry(searched, columns, speeds, given));
    return fit.isFinite() ? withoutFreedoms(searched, withUsualReadings(searched, std::move(fit))) : ConstrainedFit{};
}

/// Whether the geometry from higher derivatives explains these and the lower ones together better than the geometry
/// from the lower ones does. `lowest`, `higher`: fits of the two. `columns`: all these derivatives.
bool isBetterGeometry(const Observations &searched, const Fit &higher, const Fit &lowest, const Indices &columns)
{
    if (searched.hasAngle()) {
        // The higher derivatives depend on a speed that is not known yet, so that the misfits cannot be compared.
        return isExact(searched, higher) && !isExact(searched, lowest);
    }
    if (isExact(searched, lowest)) {
        // Its origins may be wrong nevertheless. Each of the two is fitted to all columns before they are compared.
        const double misfitOfLowest = misfitOfRepeatedFit(searched, lowest, columns);
        return misfitOfRepeatedFit(searched, higher, columns) + kSameMisfit < misfitOfLowest;
    }
    return misfitWithFreeOrigins(searched, higher, columns) < misfitWithFreeOrigins(searched, lowest, columns);
}

/// Finds the geometry from the lowest derivatives of R4_x and θ3 in the file (usually their positions), and again from
/// the next higher ones, because a filter or a sensor may have changed the lower ones. Returns the better geometry. If
/// rounding explains the lower derivatives with their usual origins, nothing has changed them, and the second search is
/// omitted; also if rounding explains them with any origins in a file with θ2, where positions need no speed.
ConstrainedFit findBestGeometry(const Observations &wholeFile, const Observations &searched, const Parameters &given)
{
    Indices columns = shapeColumns(searched);
    const Indices higherColumns = shapeColumns(searched, 1);
    ConstrainedFit lowest = findConstrainedGeometry(wholeFile, searched, columns, given);
    const bool hasUsualOrigins = std::ranges::all_of(lowest.fit.unknowns, &Unknown::isParameter);
    const bool isUnchanged = isExact(searched, lowest.fit) && (hasUsualOrigins || searched.hasAngle());
    if (isUnchanged || higherColumns.empty()) {
        return lowest;
    }
    ConstrainedFit higher = findConstrainedGeometry(wholeFile, searched, higherColumns, given);
    columns.insert(columns.end(), higherColumns.begin(), higherColumns.end());
    return isBetterGeometry(searched, higher.fit, lowest.fit, columns) ? higher : lowest;
}

/// A fit with the observations to which it belongs.
struct ObservedFit {
    Observations wholeFile; ///< all rows of the file
    Observations searched;  ///< the rows to which the model was fitted
    Fit fit;
};

/// Uses the time stamps, or the angles of a table, as they were printed if these explain the columns better than evenly
/// spaced ones: a program may have computed its values at rounded times.
ObservedFit withBestAbscissa(ObservedFit current)
{
    const Fit &fit = current.fit;
    const auto abscissa = fit.model.followsAngle ? &Observations::angle : &Observations::time;
    const auto printedAbscissa = fit.model.followsAngle ? &Observations::printedAngle : &Observations::printedTime;
    Observations printed = current.searched;
    printed.*abscissa = printed.*printedAbscissa;
    if ((printed.*abscissa).size() == 0) {
        return current;
    }
    Fit other = fitModel(printed, fit.model, fit.columns, fit.unknowns);
    if (other.misfit < fit.misfit) {
        current.fit = std::move(other);
        current.searched = std::move(printed);
        current.wholeFile.*abscissa = current.wholeFile.*printedAbscissa;
    }
    return current;
}

/// Fits the mirror image of a fit that has the simplest reading.
Fit fitSimplestImage(const Observations &observations, Fit fit, const Parameters &given)
{
    fit.model = findMirrorImages(observations, fit, given).front();
    return fitModel(observations, fit.model, fit.columns, fit.unknowns);
}

/// Makes the angle of the crank in the file a column like the others, because a constant speed predicts it, and fits it
/// together with them over the time.
ObservedFit withAngleAsColumn(ObservedFit current, const Drive &drive)
{
    Observations &observations = current.wholeFile;
    Fit &fit = current.fit;
    const Values halfSteps = Values::Constant(observations.size(), observations.angleHalfStep);
    observations.columns.push_back({.channel = kCrankAngle,
                                    .values = observations.angle,
                                    .halfSteps = halfSteps,
                                    .variance = halfSteps.square().mean() / 3.0,
                                    .range = observations.angle.maxCoeff() - observations.angle.minCoeff()});
    const Index column = std::ssize(observations.columns) - 1;
    Model &model = fit.model;
    model.readings.push_back({1.0 / model.angleFactor, -model.mechanism.theta20 / model.angleFactor});
    model.followsAngle = false;
    model.mechanism.omega2 = drive.omega2;
    model.mechanism.theta20 = drive.theta20;
    fit.columns.push_back(column);
    for (const Unknown unknown : {Unknown{Unknown::Kind::CrankAngle}, {Unknown::Kind::Omega2}}) {
        if (!fit.isFree(unknown)) {
            fit.unknowns.push_back(unknown);
        }
    }
    fit.unknowns.push_back({Unknown::Kind::Origin, column});
    current.searched = selectRows(withoutSpikes(observations), kSearchedRows);
    fit = fitModel(current.searched, fit.model, fit.columns, fit.unknowns);
    return current;
}

/// Uses a constant or evenly changing speed, which predicts derivatives, in the fit.
ObservedFit withDrive(ObservedFit current, const Drive &drive)
{
    if (drive.kind == Drive::Kind::Constant) {
        return withAngleAsColumn(std::move(current), drive);
    }
    if (drive.kind == Drive::Kind::RunUp) {
        current.fit.model.mechanism.omega2 = drive.omega2;
        current.fit.model.alpha2 = drive.alpha2;
    }
    return current;
}

/// Until here, the lengths are in the unit of the column from which the geometry was found. Converts them to the unit
/// of most columns, so that only the others are said to be in a wrong unit.
void convertToUnitOfMostColumns(LastFit &last)
{
    Indices lengths;
    std::ranges::copy_if(last.fit.columns, std::back_inserter(lengths), [&](Index k) {
        const ObservedColumn &column = last.observations.columns[k];
        return !column.containsAngles() && !column.isConstant();
    });
    const auto columnsWith = [&](double unit) {
        return std::ranges::count_if(lengths,
                                     [&](Index k) { return std::abs(last.fit.model.readings[k].factor) == unit; });
    };
    double mostFrequentUnit = 1.0;
    for (const Index k : lengths) {
        const double unit = std::abs(last.fit.model.readings[k].factor);
        mostFrequentUnit = columnsWith(unit) > columnsWith(mostFrequentUnit) ? unit : mostFrequentUnit;
    }
    for (const Index k : lengths) {
        last.fit.model.readings[k].factor /= mostFrequentUnit;
    }
    Parameters &mechanism = last.fit.model.mechanism;
    for (const Parameter length : kLengths) {
        valueOf(mechanism, length) *= mostFrequentUnit;
        scaleErrors(last, length, mostFrequentUnit);
    }
}

/// Replaces the model of the last fit by its mirror image with the simplest reading. Sets findings.otherImages to those
/// that need the same reading, and the drive of a run-up to that of the image.
void chooseImage(Findings &findings, const Parameters &given)
{
    Fit &last = findings.lastFit.fit;
    const Observations &observations = findings.lastFit.observations;
    const std::vector<Model> images = findMirrorImages(observations, last, given);
    const Parameters before = last.model.mechanism;
    const Parameters &after = images.front().mechanism;
    const double signOfC = after.c == before.c ? 1.0 : -1.0;
    const double senseOfCrank = after.omega2 == before.omega2 ? 1.0 : -1.0;
    scaleErrors(findings.lastFit, Parameter::C, signOfC);
    scaleErrors(findings.lastFit, Parameter::Omega2, senseOfCrank);
    scaleErrors(findings.lastFit, Parameter::Theta20, senseOfCrank); // θ20 changes its sign with ω2
    last.model = images.front();
    findings.otherImages.assign(images.begin() + 1, images.end());
    if (findings.drive.kind == Drive::Kind::RunUp) { // its angle, speed and acceleration are those of the image
        findings.drive = findDrive(observations, last.model);
    }
}

/// If the lengths of the given mechanism do not explain the file as well as the last fit does, looks for a single wrong
/// one, findings.change. If they do, and the fit has free origins, replaces its lengths by them: such a fit may explain
/// the file equally well with other lengths and other origins.
void compareWithGivenLengths(Findings &findings, const Observations &searched, const Parameters &given)
{
    Fit &last = findings.lastFit.fit;
    const Fit best = fitModel(searched, last.model, last.columns, last.unknowns);
    if (!best.isFinite() || !determineLengths(searched, best.columns)) {
        return;
    }
    const auto isOrigin = [](Unknown unknown) { return !unknown.isParameter(); };
    if (!explainsAsWell(searched, fitWithGivenLengths(searched, best, given), best)) {
        findings.change = findLengthChange(searched, best, given, findings.lengthUnit);
    } else if (std::ranges::any_of(last.unknowns, isOrigin)) {
        last.replaceModel(fitWithGivenLengths(findings.lastFit.observations, last, given));
        chooseImage(findings, given); // the other images have the same lengths
    }
}

/// Several units, numbers, mirror images and origins explain the file equally well. Changes the last fit to those that
/// a person expects: the unit of most columns, round numbers, the simplest reading and the lengths of the given
/// mechanism. `searched`: selected rows.
void chooseExpectedDescription(Findings &findings, const Observations &searched, const Parameters &given)
{
    LastFit &last = findings.lastFit;
    convertToUnitOfMostColumns(last);
    const Parameters unrounded = parametersAtTimeZero(last.fit.model, last.observations, findings.drive);
    moveToChosenNumbers(last, unrounded, findings.lengthUnit);
    chooseImage(findings, given);
    compareWithGivenLengths(findings, searched, given);
}

/// Adds θ2 to the columns that are left out if the file contains it but the observations do not: then the crank may
/// make any number of turns between two rows.
void leaveOutSparseAngle(std::vector<LeftOutColumn> &leftOut, const ReferenceData &data,
                         const Observations &observations)
{
    if (data.find(kCrankAngle) && !observations.hasAngle()) {
        leftOut.push_back({kCrankAngle, LeftOutColumn::Reason::OpenSpeed});
    }
}

/// Runs the steps from the observations to the last fit and its description. `wholeFile`: the observations of `data`.
Findings findMechanism(const ReferenceData &data, Observations wholeFile, const Parameters &given)
{
    Findings findings;
    findings.lengthUnit = findLengthUnit(data);
    const Observations clean = withoutSpikes(wholeFile);
    Observations searched = selectRows(clean, kSearchedRows);
    ConstrainedFit geometry = findBestGeometry(clean, searched, given);
    if (!geometry.fit.isFinite()) {
        return findings;
    }
    ObservedFit current = withBestAbscissa({std::move(wholeFile), std::move(searched), std::move(geometry.fit)});
    current.fit = fitSimplestImage(current.searched, std::move(current.fit), given);
    findings.drive = findDrive(current.wholeFile, current.fit.model);
    current = withDrive(std::move(current), findings.drive);
    FurtherColumns further = withFurtherColumns(current.searched, current.fit, findings.drive, given);
    findings.leftOut = std::move(further.leftOut);
    leaveOutSparseAngle(findings.leftOut, data, current.wholeFile);
    findings.speeds = std::move(further.speeds);
    const ConstrainedFit all = withoutFreedoms(current.searched, std::move(further.fit), geometry.shifts);
    findings.lastFit = fitAllRows(std::move(current.wholeFile), all.fit, all.shifts, findings.drive);
    if (findings.lastFit.fit.isFinite()) {
        chooseExpectedDescription(findings, current.searched, given);
    }
    return findings;
}

/// Identifies the mechanism of a table. `change`: a change of its axes, headings or clock that is applied first;
/// nullopt if the table is read as it is.
Identification identifyTable(const ReferenceData &original, const std::optional<Convention> &change,
                             const Parameters &given, const std::stop_token &stop)
{
    const ReferenceData data = change ? applied(*change, original) : original;
    Observations wholeFile = withComputedColumnsMarked(observe(data, stop));
    if (const Identification::Lack lack = findLack(wholeFile); lack != Identification::Lack::Nothing) {
        return {.outcome = Identification::Outcome::Insufficient, .parameters = given, .rounded = given, .lack = lack};
    }
    const Findings findings = findMechanism(data, std::move(wholeFile), given);
    Identification result = judge(data, findings, given);
    if (result.hasMechanism()) {
        addReading(result, original, change, findings, given);
    }
    return result;
}

/// The columns whose headings may be exchanged, because the result does not explain the columns under these headings.
std::vector<Channel> findDoubtfulHeadings(const Identification &result)
{
    constexpr double kMinPercent = 10.0; // of the peak: another heading changes a column by more than a filter does
    if (result.outcome == Identification::Outcome::None) {
        return {{Theta3, Order::Position}, {R4x, Order::Position}};
    }
    std::vector<Channel> doubtful;
    for (const LeftOutColumn &column : result.leftOut) {
        const bool isUnexplained =
            column.reason == LeftOutColumn::Reason::Unknown || column.reason == LeftOutColumn::Reason::OtherMotion;
        if (isUnexplained && !(column.percentOfPeak < kMinPercent)) {
            doubtful.push_back(column.channel);
        }
    }
    return doubtful;
}

/// Changes of the table, one of which may explain what a result does not: two headings exchanged, or a clock in a
/// different unit.
std::vector<Convention> possibleChanges(const ReferenceData &data, const Identification &result)
{
    std::vector<Convention> changes;
    const auto isDerivative = [](const LeftOutColumn &column) { return column.channel.order != Order::Position; };
    if (!data.crank && std::ranges::any_of(result.leftOut, isDerivative)) {
        // A clock whose heading says seconds may count milliseconds, and one whose heading says these may count
        // seconds.
        const double unit = data.timeRounding.unitFactor;
        const double factor = unit == 1.0 ? kTimeFactors.back() : 1.0 / unit;
        changes.push_back({.kind = Convention::Kind::TimeUnit, .channels = {}, .amount = factor});
    }
    const std::vector<Channel> doubtful = findDoubtfulHeadings(result);
    for (std::size_t i = 0; i < doubtful.size(); ++i) {
        for (std::size_t j = i + 1; j < doubtful.size(); ++j) {
            if (data.find(doubtful[i]) && data.find(doubtful[j])) {
                changes.push_back({.kind = Convention::Kind::SwappedColumns, .channels = {doubtful[i], doubtful[j]}});
            }
        }
    }
    return changes;
}

/// Whether a result is preferred to another one: by the outcome, then by the number of columns that are left out, then
/// by the number of conventions.
bool isBetter(const Identification &result, const Identification &other)
{
    const auto rank = [](const Identification &found) {
        return std::tuple(found.outcome, found.leftOut.size(), found.conventions.size());
    };
    return rank(result) < rank(other);
}

} // namespace

Identification identify(const ReferenceData &data, const Mechanism &given, std::stop_token stop)
{
    using Outcome = Identification::Outcome;
    std::optional<Identification> best;
    for (const bool withAngles : {false, true}) {
        if (const std::optional<Convention> axis = axisAlongY(data, withAngles)) {
            Identification result = identifyTable(data, axis, given.parameters(), stop);
            if (!best || isBetter(result, *best)) {
                best = std::move(result);
            }
        }
    }
    if (!best) {
        best = identifyTable(data, std::nullopt, given.parameters(), stop);
        for (const Convention &change : possibleChanges(data, *best)) {
            Identification result = identifyTable(data, change, given.parameters(), stop);
            // Only a change after which everything is explained exactly is more likely than no change.
            if (result.outcome == Outcome::Identified && result.leftOut.empty() && isBetter(result, *best)) {
                best = std::move(result);
            }
        }
    }
    if (stop.stop_requested()) {
        Identification stopped{.parameters = given.parameters(), .rounded = given.parameters()};
        stopped.stopped = true;
        return stopped;
    }
    return *std::move(best);
}

} // namespace slidercrank
