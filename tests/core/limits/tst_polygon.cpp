// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/polygon.h"
#include "tests/support/accelerating_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_polygon
{

class TestPolygon : public QObject
{
    Q_OBJECT

private slots:
    /// The chain of vectors ends where the vector of B ends, and the vector of B is the derivative of the slider's
    /// position.
    void polygonsClose()
    {
        RandomMechanisms random(466);
        for (int i = 0; i < 1000; ++i) {
            const Parameters p = random.next();
            const double alpha2 = random.uniform(-2.0, 2.0) * p.omega2 * p.omega2;
            const Polygons polygons = polygonsAt(Mechanism(p), 0.0, alpha2);
            QCOMPARE(polygons.velocity.size(), std::size_t(3));
            QCOMPARE(polygons.acceleration.size(), std::size_t(5));
            for (const auto &[polygon, scale] : {std::pair(polygons.velocity, std::abs(p.omega2)),
                                                 {polygons.acceleration, p.omega2 * p.omega2 + std::abs(alpha2)}}) {
                const PlaneVector end = polygon[polygon.size() - 2].to;
                const PlaneVector sum = polygon.back().to;
                const double tolerance = 1e-13 * characteristicLength(p) * scale;
                QVERIFY2(std::abs(end.x - sum.x) <= tolerance && std::abs(end.y - sum.y) <= tolerance,
                         describe(p).c_str());
                QCOMPARE(sum.y, 0.0);
            }
            if (i % 20 == 0) {
                const ExactOutputs exact = exactMotion(p, alpha2);
                const double velocity = static_cast<double>(exact.at("R4_x_diff"));
                QVERIFY(std::abs(polygons.velocity.back().to.x - velocity) <=
                        1e-12 * characteristicLength(p) * std::abs(p.omega2));
            }
        }
    }

    void normalAndTangentialPartsArePerpendicular()
    {
        const Polygons polygons = polygonsAt(Mechanism({.theta20 = 1.0}), 0.0, 30.0);
        const auto vector = [&](std::size_t index) {
            const PlacedVector &placed = polygons.acceleration[index];
            return PlaneVector{placed.to.x - placed.from.x, placed.to.y - placed.from.y};
        };
        for (const std::size_t normal : {0U, 2U}) {
            const PlaneVector n = vector(normal);
            const PlaneVector t = vector(normal + 1);
            QVERIFY(std::abs(n.x * t.x + n.y * t.y) <= 1e-12 * n.length() * t.length());
        }
        QVERIFY(std::abs(vector(1).length() - 20.0 * 30.0) < 1e-9);
    }

    void areEmptyIfThereAreNoVelocities()
    {
        QVERIFY(polygonsAt(Mechanism({.b = 25.0}), 0.0, 0.0).velocity.empty());                      // a toggle
        QVERIFY(polygonsAt(Mechanism({.b = 40.0, .theta20 = -1.5}), 0.0, 0.0).acceleration.empty()); // impossible
    }
};

const Suite<TestPolygon> suite("tst_polygon");

} // namespace tst_polygon

#include "tst_polygon.moc"
