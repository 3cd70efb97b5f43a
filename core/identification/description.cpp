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

/// The conversion that the readings of most of `lengths`, columns of the last fit, need: their |factor|. Of two with
/// equally many columns, the one after which the crank has the given length.
double findConversionOfMostColumns(const LastFit &last, const Indices &lengths, const Parameters &given)
{
    const auto conversionOf = [&](Index k) { return std::abs(last.fit.model.readings[k].factor); };
    const auto rank = [&](double conversion) {
        const double crankLength = last.fit.model.mechanism.a * conversion;
        const bool isGivenLength = std::abs(crankLength - given.a) < kTypedDifference * given.a;
        return std::pair(std::ranges::count(lengths, conversion, conversionOf), isGivenLength);
    };
    double best = 1.0;
    for (const Index k : lengths) {
        best = rank(conversionOf(k)) > rank(best) ? conversionOf(k) : best;
    }
    return best;
}

/// Converts the lengths of the last fit, which are in the unit of the column from which the geometry was found, to the
/// unit of most columns, so that only the other columns are said to be in a wrong unit.
void convertToUnitOfMostColumns(LastFit &last, const Parameters &given)
{
    Indices lengths;
    Indices sliderLine; // R4_y, which is converted with the others, but whose factor shows no unit
    for (const Index k : last.fit.columns) {
        const ObservedColumn &column = last.observations.columns[k];
        if (column.channel == kSliderLine) {
            sliderLine.push_back(k);
        } else if (!column.containsAngles() && !column.isConstant()) {
            lengths.push_back(k);
        }
    }
    const double conversion = findConversionOfMostColumns(last, lengths, given);
    for (const Indices &columns : {lengths, sliderLine}) {
        for (const Index k : columns) {
            last.fit.model.readings[k].factor /= conversion;
        }
    }
    Parameters &mechanism = last.fit.model.mechanism;
    for (const Parameter length : kLengths) {
        valueOf(mechanism, length) *= conversion;
        scaleErrors(last, length, conversion);
    }
}

/// Replaces the model of the last fit by a mirror image of it. Its parameters are as certain as before, but the
/// covariances of c, ω2 and θ20 with the others change their signs with these parameters (θ20 is negated with ω2).
void replaceByMirrorImage(LastFit &lastFit, const Model &image)
{
    const Parameters &before = lastFit.fit.model.mechanism;
    const double signOfC = before.c * image.mechanism.c < 0.0 ? -1.0 : 1.0;
    const double senseOfCrank = before.omega2 * image.mechanism.omega2 < 0.0 ? -1.0 : 1.0;
    scaleErrors(lastFit, Parameter::C, signOfC);
    scaleErrors(lastFit, Parameter::Omega2, senseOfCrank);
    scaleErrors(lastFit, Parameter::Theta20, senseOfCrank);
    lastFit.fit.model = image;
}

/// Replaces the model of the last fit by its mirror image with the simplest reading. Sets findings.otherMirrorImages to
/// the other images that need the same reading.
void chooseMirrorImage(Findings &findings, const Parameters &given)
{
    LastFit &last = findings.lastFit;
    const std::vector<Model> images = findSimplestMirrorImages(last.observations, last.fit, given);
    replaceByMirrorImage(last, images.front());
    findings.otherMirrorImages.assign(images.begin() + 1, images.end());
    if (findings.drive.kind == Drive::Kind::RunUp) { // the image may have negated its angle, speed and acceleration
        findings.drive = findDrive(last.observations, last.fit.model);
    }
}

/// Fits the drive and the origins with the given lengths to all rows, and takes this fit if it explains them as well as
/// the last one. (compareWithGivenLengths() has tested only the searched rows; all rows can show a difference that
/// those do not.) Then chooses the mirror image again, because findings.otherMirrorImages have the old lengths.
void moveToGivenLengths(Findings &findings, const Parameters &given)
{
    const Observations &allRows = findings.lastFit.observations;
    Fit &last = findings.lastFit.fit;
    const Fit moved = fitWithGivenLengths(allRows, last, given);
    if (explainsAsWell(allRows, moved, last)) {
        last.replaceModel(moved);
        chooseMirrorImage(findings, given);
    }
}

/// Compares the lengths of the last fit with the given ones, if the columns determine lengths. If the given ones do not
/// explain the searched rows as well, sets findings.change to the only wrong one of them, if there is such. If they do,
/// a last fit with free origins is moved to them, because different lengths with different origins may have nearly the
/// same curve.
void compareWithGivenLengths(Findings &findings, const Observations &searched, const Parameters &given)
{
    const Fit &last = findings.lastFit.fit;
    const Fit best = fitModel(searched, last.model, last.columns, last.unknowns);
    if (!best.isFinite() || !areLengthsDetermined(searched, best.columns)) {
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
    chooseMirrorImage(findings, given);
    compareWithGivenLengths(findings, searched, given);
}

} // namespace slidercrank
