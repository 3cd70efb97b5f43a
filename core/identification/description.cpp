// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/description.h"

#include "core/identification/geometry.h"
#include "core/identification/length_change.h"
#include "core/identification/mirror_images.h"
#include "core/identification/residual_test.h"
#include "core/identification/round_values.h"

#include <algorithm>
#include <utility>

namespace slidercrank
{

namespace
{

/// Until here, the lengths are in the unit of the column from which the geometry was found. Converts them to the unit
/// of most columns, so that only the others are said to be in a wrong unit. Of two units with equally many columns, the
/// one is chosen in which the crank has the given length.
void convertToUnitOfMostColumns(LastFit &last, const Parameters &given)
{
    Indices lengths;
    Indices sliderLine; // R4_y, which has been fitted in the same unit, but shows none
    for (const Index k : last.fit.columns) {
        const ObservedColumn &column = last.observations.columns[k];
        if (column.channel == kSliderLine) {
            sliderLine.push_back(k);
        } else if (!column.containsAngles() && !column.isConstant()) {
            lengths.push_back(k);
        }
    }
    const auto columnsWith = [&](double unit) {
        return std::ranges::count_if(lengths,
                                     [&](Index k) { return std::abs(last.fit.model.readings[k].factor) == unit; });
    };
    const auto rank = [&](double unit) {
        const bool isGivenLength = std::abs(last.fit.model.mechanism.a * unit - given.a) < kTypedDifference * given.a;
        return std::pair(columnsWith(unit), isGivenLength);
    };
    double mostFrequentUnit = 1.0;
    for (const Index k : lengths) {
        const double unit = std::abs(last.fit.model.readings[k].factor);
        mostFrequentUnit = rank(unit) > rank(mostFrequentUnit) ? unit : mostFrequentUnit;
    }
    for (const Indices &columns : {lengths, sliderLine}) {
        for (const Index k : columns) {
            last.fit.model.readings[k].factor /= mostFrequentUnit;
        }
    }
    Parameters &mechanism = last.fit.model.mechanism;
    for (const Parameter length : kLengths) {
        valueOf(mechanism, length) *= mostFrequentUnit;
        scaleErrors(last, length, mostFrequentUnit);
    }
}

/// Replaces the model of the last fit by a mirror image. Its parameters are as certain as before, but their covariances
/// change their signs with c and with the sense of the crank (θ20 is negated with ω2).
void replaceByImage(LastFit &lastFit, const Model &image)
{
    const Parameters &before = lastFit.fit.model.mechanism;
    const double signOfC = before.c * image.mechanism.c < 0.0 ? -1.0 : 1.0;
    const double senseOfCrank = before.omega2 * image.mechanism.omega2 < 0.0 ? -1.0 : 1.0;
    scaleErrors(lastFit, Parameter::C, signOfC);
    scaleErrors(lastFit, Parameter::Omega2, senseOfCrank);
    scaleErrors(lastFit, Parameter::Theta20, senseOfCrank);
    lastFit.fit.model = image;
}

/// Replaces the model of the last fit by its mirror image with the simplest reading. Sets findings.otherImages to those
/// that need the same reading.
void chooseImage(Findings &findings, const Parameters &given)
{
    LastFit &last = findings.lastFit;
    const std::vector<Model> images = findSimplestMirrorImages(last.observations, last.fit, given);
    replaceByImage(last, images.front());
    findings.otherImages.assign(images.begin() + 1, images.end());
    if (findings.drive.kind == Drive::Kind::RunUp) { // its angle, speed and acceleration are those of the image
        findings.drive = findDrive(last.observations, last.fit.model);
    }
}

/// Replaces the lengths of the last fit by the given ones, with its drive and its origins fitted again, if these
/// explain all rows as well: many rows show a difference that some of them do not show. Then chooses its image anew,
/// because findings.otherImages still have the lengths from before.
void moveToGivenLengths(Findings &findings, const Parameters &given)
{
    const Observations &allRows = findings.lastFit.observations;
    Fit &last = findings.lastFit.fit;
    const Fit moved = fitWithGivenLengths(allRows, last, given);
    if (explainsAsWell(allRows, moved, last)) {
        last.replaceModel(moved);
        chooseImage(findings, given);
    }
}

/// Compares the lengths of the last fit with the given ones. If the given ones explain the searched rows as well, a fit
/// with free origins is moved to them: other lengths with other origins may be nearly the same curve. If they do not, a
/// single wrong one is looked for, findings.change.
void compareWithGivenLengths(Findings &findings, const Observations &searched, const Parameters &given)
{
    const Fit &last = findings.lastFit.fit;
    const Fit best = fitModel(searched, last.model, last.columns, last.unknowns);
    if (!best.isFinite() || !determineLengths(searched, best.columns)) {
        return;
    }
    if (!explainsAsWell(searched, fitWithGivenLengths(searched, best, given), best)) {
        findings.change = findLengthChange(searched, best, given);
        return;
    }
    const bool hasFreeOrigins = std::ranges::any_of(last.unknowns, &Unknown::isOrigin);
    if (hasFreeOrigins) {
        moveToGivenLengths(findings, given);
    }
}

} // namespace

void chooseExpectedDescription(Findings &findings, const Observations &searched, const Parameters &given)
{
    LastFit &last = findings.lastFit;
    convertToUnitOfMostColumns(last, given);
    const Parameters unrounded = parametersAtTimeZero(last.fit.model, last.observations, findings.drive);
    moveToChosenNumbers(last, unrounded);
    chooseImage(findings, given);
    compareWithGivenLengths(findings, searched, given);
}

} // namespace slidercrank
