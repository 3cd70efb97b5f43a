// SPDX-License-Identifier: GPL-3.0-or-later

// Which freedoms and which mirror image the identification chooses for constructed tables.

#include "core/identification/freedoms.h"
#include "core/identification/mirror_images.h"
#include "core/mechanism/turn.h"
#include "tests/support/channels.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace slidercrank;

namespace tst_readings
{

const Parameters kMechanism{20.0, 60.0, 25.0, 6.25, 0.25, Branch::Open};
const Unknown kAngleOrigin = originOf(0);
const Unknown kSliderOrigin = originOf(1);

/// Returns a fit of θ3 (column 0) and R4_x (column 1) in which all parameters and both origins are free.
Fit freeFit(const Observations &observations)
{
    Model model{.mechanism = kMechanism};
    model.mechanism.theta20 += kMechanism.omega2 * observations.timeOrigin;
    model.readings.resize(observations.columns.size());
    return fitModel(
        observations, model, {0, 1},
        {Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20, kAngleOrigin, kSliderOrigin});
}

using Change = std::function<double(double value, std::size_t row)>;

/// Returns the observations of a printed motion after these changes of its values (°, mm).
Observations changedObservations(const Change &angle, const Change &slider)
{
    Printing printing;
    printing.channels = kAngleAndPosition;
    ReferenceData data = printedData(kMechanism, printing);
    for (std::size_t i = 0; i < data.time.size(); ++i) {
        data.series[0].values[i] = angle(data.series[0].values[i], i);
        data.series[1].values[i] = slider(data.series[1].values[i], i);
    }
    return observe(data, {});
}

double unchanged(double value, std::size_t)
{
    return value;
}

class TestReadings : public QObject
{
    Q_OBJECT

private slots:
    void takesOriginsBackThatTheFileDoesNotNeed()
    {
        const Observations observations = changedObservations(unchanged, unchanged);
        const ConstrainedFit result = withoutFreedoms(observations, freeFit(observations));
        QVERIFY(!result.fit.isFree(kAngleOrigin) && !result.fit.isFree(kSliderOrigin));
        QVERIFY(result.fit.model.readings[0].origin == 0.0 && result.fit.model.readings[1].origin == 0.0);
        for (const double error : result.possibleErrors) { // only what origins below the rounding steps can change
            QVERIFY(error < 1e-3);
        }
    }

    void keepsOriginsThatTheFileNeeds()
    {
        const Observations observations = changedObservations([](double value, std::size_t) { return value - 180.0; },
                                                              [](double value, std::size_t) { return value - 40.0; });
        const ConstrainedFit result = withoutFreedoms(observations, freeFit(observations));
        QVERIFY(!result.fit.isFree(kAngleOrigin) && result.fit.isFree(kSliderOrigin));
        QCOMPARE(result.fit.model.readings[0].origin, -0.5 * kTurn);
        QVERIFY(std::abs(result.fit.model.readings[1].origin + 40.0) < 1e-3);
    }

    void keepsAnOriginInNoise()
    {
        RandomMechanisms random(11);
        const auto noise = [&](double value, std::size_t) { return value + random.uniform(-0.2, 0.2); };
        const Observations observations =
            changedObservations([](double value, std::size_t) { return value + 20.0; }, noise);
        const ConstrainedFit result = withoutFreedoms(observations, freeFit(observations));
        QVERIFY(result.fit.isFree(kAngleOrigin) && !result.fit.isFree(kSliderOrigin));
        QVERIFY(std::abs(result.fit.model.readings[0].origin * kDegreesPerRadian - 20.0) < 1.0);
    }

    /// An average of neighbouring rows bends the curve as an origin does.
    void inventsNoOriginForAFilter()
    {
        Printing printing;
        printing.channels = kAngleAndPosition;
        ReferenceData data = printedData(kMechanism, printing);
        const std::vector<double> exact = data.series[1].values;
        for (std::size_t i = 5; i + 5 < exact.size(); ++i) {
            double sum = 0.0;
            for (std::size_t k = i - 5; k <= i + 5; ++k) {
                sum += exact[k];
            }
            data.series[1].values[i] = sum / 11.0;
        }
        const Observations observations = observe(data, {});
        const ConstrainedFit result = withoutFreedoms(observations, freeFit(observations));
        QVERIFY(!result.fit.isFree(kSliderOrigin));
    }

    /// Every image explains the columns as well as the fit.
    void returnsImagesWithTheSameCurves()
    {
        const Observations observations = changedObservations(unchanged, unchanged);
        const Fit fit = freeFit(observations);
        for (const Parameters &given : mirrorImages(kMechanism)) {
            const std::vector<Model> images = findSimplestMirrorImages(observations, fit, given);
            QCOMPARE(images.size(), std::size_t{1}); // x and θ3 together have one image in each reading
            const Fit image = evaluateModel(observations, images[0], fit.columns);
            QVERIFY(std::abs(image.misfit - fit.misfit) < 1e-3);
        }
    }

    void prefersTheImageWithFewReadings()
    {
        struct Row {
            const char *name;
            Change angle;
            Change slider;
            double c;
            double omega2;
            Branch branch;
        };
        const auto negated = [](double value, std::size_t) { return -value; };
        for (const Row &row : {Row{"as it is", unchanged, unchanged, 25.0, 6.25, Branch::Open},
                               Row{"angles clockwise", negated, unchanged, -25.0, -6.25, Branch::Open},
                               Row{"turned by half a turn", [](double value, std::size_t) { return value + 180.0; },
                                   negated, -25.0, 6.25, Branch::Crossed}}) {
            const Observations observations = changedObservations(row.angle, row.slider);
            Model model = freeFit(changedObservations(unchanged, unchanged)).model;
            // Describes the changed file by the model of the unchanged file with other factors and origins.
            const double angle = observations.columns[0].values[1] - observations.columns[0].values[0];
            const double slider = observations.columns[1].values[1] - observations.columns[1].values[0];
            const Observations plain = changedObservations(unchanged, unchanged);
            model.readings[0].factor =
                std::copysign(1.0, angle * (plain.columns[0].values[1] - plain.columns[0].values[0]));
            model.readings[1].factor =
                std::copysign(1.0, slider * (plain.columns[1].values[1] - plain.columns[1].values[0]));
            model.readings[0].origin =
                observations.columns[0].values[0] - model.readings[0].factor * plain.columns[0].values[0];
            const Fit fit = evaluateModel(observations, model, {0, 1});
            const Parameters found = findSimplestMirrorImages(observations, fit, kMechanism).front().mechanism;
            QVERIFY2(std::abs(found.c - row.c) < 1e-3 && std::abs(found.omega2 - row.omega2) < 1e-3, row.name);
            QCOMPARE(found.branch, row.branch);
        }
    }
};

const Suite<TestReadings> suite("tst_readings");

} // namespace tst_readings

#include "tst_readings.moc"
