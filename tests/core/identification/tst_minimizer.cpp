// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/minimizer.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace tst_minimizer
{

using Status = Minimum::Status;

/// The sum of squared residuals with its derivatives. `jacobian`: the partial derivatives of the residuals.
LocalShape sumOfSquares(const Eigen::VectorXd &residuals, const Eigen::MatrixXd &jacobian)
{
    return {residuals.squaredNorm(), 2.0 * jacobian.transpose() * residuals, 2.0 * jacobian.transpose() * jacobian};
}

/// H. Rosenbrock's valley, whose minimum is 0 at (1, 1).
std::optional<LocalShape> rosenbrock(const Eigen::VectorXd &point)
{
    const double x = point[0];
    const double y = point[1];
    return sumOfSquares(Eigen::Vector2d(10.0 * (y - x * x), 1.0 - x),
                        (Eigen::Matrix2d() << -20.0 * x, 10.0, -1.0, 0.0).finished());
}

class TestMinimizer : public QObject
{
    Q_OBJECT

private slots:
    void findsTheMinimumOfACurvedValley()
    {
        const auto minimum =
            minimize(rosenbrock, Eigen::Vector2d(-1.2, 1.0), {.iterationLimit = 200, .smallestGain = 1e-20});
        QVERIFY(minimum && minimum->status == Status::Converged);
        QVERIFY((minimum->point - Eigen::Vector2d(1.0, 1.0)).norm() < 1e-6);
        QVERIFY(minimum->iterations < 100);
    }

    void solvesALinearProblemInFewSteps()
    {
        const Eigen::Matrix<double, 3, 2> jacobian{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}};
        const Eigen::Vector3d values(1.0, 3.0, 5.0); // 1 + 2 t
        const auto line = [&](const Eigen::VectorXd &point) -> std::optional<LocalShape> {
            return sumOfSquares(jacobian * point - values, jacobian);
        };
        const auto minimum = minimize(line, Eigen::Vector2d::Zero(), {.smallestGain = 1e-12});
        QVERIFY(minimum && (minimum->point - Eigen::Vector2d(1.0, 2.0)).norm() < 1e-6 && minimum->iterations < 8);
    }

    void leavesAnUnknownWithoutInfluenceWhereItIs()
    {
        const auto parabola = [](const Eigen::VectorXd &point) -> std::optional<LocalShape> {
            return sumOfSquares(Eigen::VectorXd::Constant(1, point[0] - 3.0), Eigen::RowVector2d(1.0, 0.0));
        };
        const auto minimum = minimize(parabola, Eigen::Vector2d(0.0, 7.0), {});
        QVERIFY(minimum && std::abs(minimum->point[0] - 3.0) < 0.1 && minimum->point[1] == 7.0);
    }

    void staysWhereTheFunctionExists()
    {
        // Newton's step from 1 leads to a negative number, where the logarithm does not exist.
        const auto logarithm = [](const Eigen::VectorXd &point) -> std::optional<LocalShape> {
            const double x = point[0];
            return x > 0.0 ? std::optional(sumOfSquares(Eigen::VectorXd::Constant(1, std::log(x) + 5.0),
                                                        Eigen::MatrixXd::Constant(1, 1, 1.0 / x)))
                           : std::nullopt;
        };
        const auto minimum = minimize(logarithm, Eigen::VectorXd::Constant(1, 1.0), {.smallestGain = 1e-12});
        QVERIFY(minimum && std::abs(minimum->point[0] - std::exp(-5.0)) < 1e-6);
        QVERIFY(!minimize(logarithm, Eigen::VectorXd::Constant(1, -1.0), {}));
    }

    void saysWhyItEnds()
    {
        const auto uphill = [](const Eigen::VectorXd &point) -> std::optional<LocalShape> { // a wrong gradient
            return LocalShape{point[0], Eigen::VectorXd::Constant(1, -1e3), Eigen::MatrixXd::Constant(1, 1, 1.0)};
        };
        QVERIFY(minimize(uphill, Eigen::VectorXd::Zero(1), {.smallestGain = 1e-9})->status == Status::NoProgress);
        QVERIFY(minimize(rosenbrock, Eigen::Vector2d(-1.2, 1.0), {.iterationLimit = 3})->status ==
                Status::IterationLimit);
    }
};

const Suite<TestMinimizer> suite("tst_minimizer");

} // namespace tst_minimizer

#include "tst_minimizer.moc"
