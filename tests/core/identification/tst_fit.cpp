// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fit.h"

#include "core/identification/residual_test.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_fit
{

const Parameters kFitted{20.0, 60.0, 25.0, 6.25, 0.25, Branch::Open};

/// The observations of a printed file, and the model that printed it.
struct PrintedFile {
    Observations observations;
    Model model;
    Indices columns;
};

PrintedFile printedFile(const Parameters &parameters, const Printing &printing)
{
    PrintedFile file{observe(printedData(parameters, printing), {}), {.mechanism = parameters}, {}};
    file.model.mechanism.theta20 += parameters.omega2 * file.observations.timeOrigin;
    file.model.readings.resize(file.observations.columns.size());
    for (Index k = 0; k < std::ssize(file.observations.columns); ++k) {
        file.columns.push_back(k);
    }
    return file;
}

/// Returns the derivative of the misfit S by one unknown, as a central difference.
double numericalSlope(const PrintedFile &file, Unknown unknown, double step)
{
    Model above = file.model;
    Model below = file.model;
    valueOf(above, unknown) += step;
    valueOf(below, unknown) -= step;
    return (evaluateModel(file.observations, above, file.columns).misfit -
            evaluateModel(file.observations, below, file.columns).misfit) /
           (2.0 * step);
}

class TestFit : public QObject
{
    Q_OBJECT

private slots:
    /// At a minimum found with the analytical derivatives, central differences of S vanish, and S grows as the
    /// curvature that the fit returns predicts.
    void hasTheDerivativesThatDifferencesShow()
    {
        RandomMechanisms random(20240611);
        for (int i = 0; i < 10; ++i) {
            Printing printing;
            printing.format = "%.3g"; // so that S is smooth
            printing.rows = 80;
            PrintedFile file = printedFile(random.ordinary(), printing);
            const Unknowns unknowns{Parameter::A,       Parameter::B, Parameter::C, Parameter::Omega2,
                                    Parameter::Theta20, originOf(0),  originOf(1)};
            const Fit fit = fitModel(file.observations, file.model, file.columns, unknowns);
            QVERIFY(fit.isFinite());
            file.model = fit.model;
            for (Index k = 0; k < std::ssize(unknowns); ++k) {
                const double width = 1.0 / std::sqrt(fit.curvature(k, k)); // S changes by 1/2 in this distance
                const double slope = numericalSlope(file, unknowns[k], 0.1 * width);
                QVERIFY2(std::abs(slope) * width < 0.05, QByteArray::number(slope * width));
                Model moved = file.model;
                valueOf(moved, unknowns[k]) += 5.0 * width;
                const double growth = evaluateModel(file.observations, moved, file.columns).misfit - fit.misfit;
                QVERIFY2(std::abs(growth / 12.5 - 1.0) < 0.2, QByteArray::number(growth)); // 5² / 2
            }
        }
    }

    void findsTheParametersOfARoundedMotion()
    {
        PrintedFile file = printedFile(kFitted, {});
        const Model truth = file.model;
        file.model.mechanism.b *= 1.1;
        file.model.mechanism.c *= 0.8;
        file.model.mechanism.omega2 *= 1.02;
        const Unknowns unknowns{Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20};
        const Fit fit = fitModel(file.observations, file.model, file.columns, unknowns);
        const Eigen::MatrixXd covariance = computeCovariance(fit);
        QVERIFY(isExact(file.observations, fit));
        for (Index k = 0; k < std::ssize(unknowns); ++k) {
            Model expected = truth;
            Model found = fit.model;
            const double error = std::sqrt(covariance(k, k));
            QVERIFY(std::abs(valueOf(found, unknowns[k]) - valueOf(expected, unknowns[k])) < 4.0 * error);
            QVERIFY(error < 1e-4);
        }
    }

    void tellsNoiseFromSystematicResiduals()
    {
        PrintedFile file = printedFile(kFitted, {});
        RandomMechanisms random(7);
        for (double &value : file.observations.columns[0].values) {
            value += random.uniform(-0.01, 0.01);
        }
        const Fit noisy = evaluateModel(file.observations, file.model, {0});
        QVERIFY2(dependence(noisy) < 1.3, QByteArray::number(dependence(noisy)));
        QVERIFY(!isExact(file.observations, noisy));
        for (Index i = 0; i < file.observations.size(); ++i) {
            file.observations.columns[1].values[i] += std::sin(0.1 * static_cast<double>(i)); // 3 periods in 201 rows
        }
        QVERIFY(dependence(evaluateModel(file.observations, file.model, {1})) > 10.0);
    }

    void isNotFiniteWhereNoMechanismCanBeAssembled()
    {
        PrintedFile file = printedFile(kFitted, {});
        file.model.mechanism.b = 30.0; // the offset 25 and the crank 20 need 45
        QVERIFY(!evaluateModel(file.observations, file.model, file.columns).isFinite());
        QVERIFY(!fitModel(file.observations, file.model, file.columns, {Parameter::B}).isFinite());
    }
};

const Suite<TestFit> suite("tst_fit");

} // namespace tst_fit

#include "tst_fit.moc"
