// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/state_at.h"
#include "core/comparison/reference_pose.h"
#include "tests/support/channels.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace slidercrank;

namespace tst_reference_pose
{

constexpr int kIntervals = 50; // intervals per turn: few, so that the interpolation matters

const Mechanism kFileMechanism({.b = 60.0});
const Mechanism kModel({.b = 65.0});

/// Returns one turn of the mechanism with b = 60 as reference data with the given columns.
ReferenceData fileWith(const std::vector<Channel> &channels)
{
    ReferenceData data;
    const ClosedForm motion(kFileMechanism);
    for (int i = 0; i <= kIntervals; ++i) {
        data.time.push_back(static_cast<double>(i) / kIntervals);
    }
    for (const Channel channel : channels) {
        ReferenceSeries series{channel, {}, {}};
        for (const double t : data.time) {
            const State state = motion.stateAt(t);
            const Vector12 &coordinates = channel.order == Order::Position ? state.q : state.qDot;
            series.values.push_back(toFileUnit(channel, coordinates[channel.coordinate]));
        }
        data.series.push_back(series);
    }
    return data;
}

/// Returns the largest distance (mm) of the pins from those of the mechanism, at times on and between the rows.
double largestPinDistance(const ReferenceData &data)
{
    double farthest = 0.0;
    for (int i = 0; i <= 7 * kIntervals; ++i) {
        const double t = i / (7.0 * kIntervals);
        const ReferencePose pose = referencePoseAt(data, kFileMechanism, t);
        const Motion motion = ClosedForm(kFileMechanism).motionAt(t);
        if (!pose.exists) {
            return kInfinity;
        }
        farthest = std::max({farthest, std::abs(pose.sliderX - motion.R4x), std::abs(pose.sliderY - kFileMechanism.c()),
                             std::hypot(pose.pinX - kFileMechanism.a() * motion.crank.cos,
                                        pose.pinY - kFileMechanism.a() * motion.crank.sin)});
    }
    return farthest;
}

class TestReferencePose : public QObject
{
    Q_OBJECT

private slots:
    void followsTheFileBetweenItsRows()
    {
        // The largest error of linear interpolation would be at least 20 mm · (2π/50)²/8 = 0.04 mm. At the ends,
        // parabolas are used. The mechanism replaces a missing column.
        for (const auto &channels : {std::vector{kTheta3, kSlider}, {kSlider}, {kTheta3}}) {
            QVERIFY(largestPinDistance(fileWith(channels)) < 0.02);
        }
    }

    void showsTheFilesMotionNotTheMechanisms()
    {
        const ReferencePose pose = referencePoseAt(fileWith({kTheta3, kSlider}), kModel, 0.0);
        QVERIFY(pose.exists);
        QVERIFY(std::abs(pose.sliderX - (20.0 + 60.0 * std::cos(std::asin(25.0 / 60.0)))) < 1e-12);
        QVERIFY(std::abs(pose.pinY - (25.0 - 65.0 * 25.0 / 60.0)) < 1e-12);
    }

    /// A former defect: a file with only one of the columns moved the crank pin off its circle.
    void keepsTheCrankPinOnItsCircleIfAColumnIsMissing()
    {
        for (const Channel channel : {kTheta3, kSlider}) {
            const ReferencePose pose = referencePoseAt(fileWith({channel}), kModel, 0.3);
            const double theta2 = 0.6 * std::numbers::pi;
            QVERIFY(std::hypot(pose.pinX - 20.0 * std::cos(theta2), pose.pinY - 20.0 * std::sin(theta2)) < 1e-12);
        }
    }

    void unwrapsAnglesThatAreLimitedToOneTurn()
    {
        ReferenceData data = fileWith({kTheta3, kSlider});
        for (double &value : data.series[0].values) {
            value = value < 20.0 ? value + 360.0 : value;
        }
        QVERIFY(largestPinDistance(data) < 0.02);
    }

    void isEmptyOutsideTheRowsOrNextToAnEmptyCell()
    {
        ReferenceData data = fileWith({kTheta3, kSlider});
        data.series[1].values[10] = kNone;
        for (const auto &[time, exists] :
             {std::pair(-0.001, false), std::pair(0.0, true), std::pair(1.0, true), std::pair(1.001, false),
              std::pair(kNone, false), std::pair(8.5 / kIntervals, true), std::pair(9.5 / kIntervals, false),
              std::pair(10.5 / kIntervals, false), std::pair(11.5 / kIntervals, true)}) {
            QCOMPARE(referencePoseAt(data, kFileMechanism, time).exists, exists);
        }
    }

    void isEmptyWithoutTheRequiredPositions()
    {
        QVERIFY(!referencePoseAt(fileWith({kTheta3Speed, kSliderSpeed}), kFileMechanism, 0.5).exists);
        QVERIFY(!referencePoseAt(ReferenceData(), kFileMechanism, 0.0).exists);
    }
};

const Suite<TestReferencePose> suite("tst_reference_pose");

} // namespace tst_reference_pose

#include "tst_reference_pose.moc"
