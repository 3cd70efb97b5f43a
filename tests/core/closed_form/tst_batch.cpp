// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/batch.h"
#include "core/study/cases.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"

#include <QTest>
#include <hwy/highway.h>

using namespace slidercrank;

namespace
{

/// What the batch promises, of a channel's peak.
constexpr double kPromise = 2e-15;

constexpr double kNotWritten = -12345.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The same number, or both none.
bool same(double x, double y)
{
    return x == y || (std::isnan(x) && std::isnan(y));
}

/// Each instruction set that there is code for and that this processor has.
std::vector<std::int64_t> targets()
{
    return hwy::SupportedAndGeneratedTargets();
}

/// Chooses an instruction set while it lives.
class OnTarget
{
public:
    explicit OnTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
    ~OnTarget() { hwy::SetSupportedTargetsForTest(0); }
    OnTarget(const OnTarget &) = delete;
    OnTarget &operator=(const OnTarget &) = delete;
};

/// In the order of kPlottedChannels.
constexpr std::array<double * PlottedColumns::*, 6> kColumns{&PlottedColumns::theta3,     &PlottedColumns::R4x,
                                                             &PlottedColumns::theta3Dot,  &PlottedColumns::R4xDot,
                                                             &PlottedColumns::theta3DDot, &PlottedColumns::R4xDDot};
constexpr unsigned kAllSix = 63;

struct Answer {
    std::array<std::vector<double>, 6> values; ///< author's units; kNotWritten where nothing was written
    std::vector<Status> statuses;
};

/// The channels whose bits are set in `asked`, with some room behind each array that is not to be written.
Answer evaluate(const Parameters &parameters, std::span<const double> instants, unsigned asked = kAllSix)
{
    constexpr std::size_t kRoomBehind = 16;
    Answer answer;
    answer.statuses.assign(instants.size(), Status::IterationLimit);
    PlottedColumns columns;
    for (std::size_t k = 0; k < kColumns.size(); ++k) {
        answer.values[k].assign(instants.size() + kRoomBehind, kNotWritten);
        columns.*kColumns[k] = (asked >> k & 1U) != 0 ? answer.values[k].data() : nullptr;
    }
    ClosedFormBatch{Mechanism(parameters)}.evaluate(instants, columns, answer.statuses);
    return answer;
}

/// What differs from one evaluation after another of ClosedForm; empty when nothing does.
QString differenceFromOneByOne(const Parameters &parameters, std::span<const double> instants, unsigned asked = kAllSix)
{
    const Answer answer = evaluate(parameters, instants, asked);
    const ClosedForm closedForm{Mechanism(parameters)};
    for (std::size_t k = 0; k < kColumns.size(); ++k) {
        for (std::size_t i = 0; i < answer.values[k].size(); ++i) {
            double expected = kNotWritten;
            if (i < instants.size() && (asked >> k & 1U) != 0) {
                const Motion motion = closedForm.motionAt(instants[i]);
                const double motions[] = {motion.theta3, motion.R4x,        motion.theta3Dot,
                                          motion.R4xDot, motion.theta3DDot, motion.R4xDDot};
                expected = toFileUnit(kPlottedChannels[k], motions[k]);
            }
            if (!same(answer.values[k][i], expected)) {
                return QString("%1\n    %2 of %3 instants, number %4: %5, expected %6")
                    .arg(QString::fromStdString(describe(parameters)))
                    .arg(QString::fromStdString(std::string(nameOf(kPlottedChannels[k]))))
                    .arg(instants.size())
                    .arg(i)
                    .arg(answer.values[k][i], 0, 'g', 17)
                    .arg(expected, 0, 'g', 17);
            }
        }
    }
    for (std::size_t i = 0; i < instants.size(); ++i) {
        const Status expected = closedForm.motionAt(instants[i]).status;
        if (answer.statuses[i] != expected) {
            return QString("%1\n    status at t=%2: %3, expected %4")
                .arg(QString::fromStdString(describe(parameters)))
                .arg(instants[i], 0, 'g', 17)
                .arg(int(answer.statuses[i]))
                .arg(int(expected));
        }
    }
    return {};
}

/// The worst error of the six, in units of the channel's peak in `sizes` (mm, rad).
template <class Real>
double worstError(const Answer &answer, std::span<const ExactState<Real>> run,
                  const std::array<double, kChannelCount> &sizes)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < run.size(); ++i) {
        for (std::size_t k = 0; k < kColumns.size(); ++k) {
            const std::size_t index = indexOf(kPlottedChannels[k]);
            const bool angle = isAngle(kPlottedChannels[k].coordinate);
            const Real unit = angle ? Real(180 / boost::math::constants::pi<Real>()) : Real(1);
            const double error = static_cast<double>(abs(Real(answer.values[k][i]) / unit - run[i].values[index]));
            worst = std::max(worst, std::isnan(error) ? kInfinity : error / sizes[index]);
        }
    }
    return worst;
}

bool isRocker(const Parameters &p)
{
    return Digits50(p.b) < Digits50(p.a) + Digits50(std::abs(p.c));
}

Parameters withLengths(double b, double c)
{
    Parameters parameters;
    parameters.b = b;
    parameters.c = c;
    return parameters;
}

} // namespace

class tst_batch : public QObject
{
    Q_OBJECT

private slots:
    void hasWideVectorsHere();
    void isExactOnNamedCases();
    void isExactOnRandomMechanisms();
    void isTheClosedFormOnNamedCases();
    void isTheClosedFormOnRandomMechanisms();
    void takesRunsOfAnyLength();
    void isTheSameInEveryLane();
    void keepsMixedStatusesApart();
    void takesAnglesOfAnySize();
    void writesOnlyWhatIsAskedFor();
};

/// What the other tests run on; on a processor with vectors, more than one instruction set.
void tst_batch::hasWideVectorsHere()
{
    QStringList names;
    for (const std::int64_t target : targets()) {
        names << hwy::TargetName(target);
    }
    qInfo("%s", qPrintable(names.join(", ")));
    QVERIFY(!names.isEmpty());
}

void tst_batch::isExactOnNamedCases()
{
    double worst = 0.0;
    for (const Case &which : allCases()) {
        if (isRocker(which.parameters)) {
            continue;
        }
        const std::vector<double> instants = instantsOf(which);
        const std::vector<ExactState<Digits100>> run = exactRun<Digits100>(which.parameters, instants);
        const std::array<double, kChannelCount> sizes = channelSizes<Digits100>(which.parameters, run);
        for (const std::int64_t target : targets()) {
            const OnTarget on(target);
            const Answer answer = evaluate(which.parameters, instants);
            const double error = worstError<Digits100>(answer, run, sizes);
            QVERIFY2(error <= kPromise,
                     qPrintable(QString("%1: %2").arg(QString::fromStdString(std::string(which.name))).arg(error)));
            worst = std::max(worst, error);
            for (std::size_t i = 0; i < instants.size(); ++i) {
                QCOMPARE(answer.statuses[i], run[i].status);
            }
        }
    }
    qInfo("worst: %.3g of peak", worst);
}

void tst_batch::isExactOnRandomMechanisms()
{
    constexpr int kMechanisms = 300;
    constexpr int kInstants = 11;
    constexpr int kPeakInstants = 100;
    RandomMechanisms random(20240502);
    double worst = 0.0;
    for (int i = 0; i < kMechanisms; ++i) {
        Parameters p = random.next();
        const double turnTime = 2.0 * std::numbers::pi / std::abs(p.omega2);
        std::vector<double> turn;
        for (int k = 0; k < kPeakInstants; ++k) {
            turn.push_back(turnTime * k / kPeakInstants);
        }
        std::vector<double> instants;
        for (int k = 0; k < kInstants; ++k) {
            instants.push_back(random.uniform(0.0, turnTime));
        }
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            const std::vector<ExactState<long double>> around = exactRun<long double>(p, turn);
            const std::vector<ExactState<Digits50>> run = exactRun<Digits50>(p, instants);
            const std::array<double, kChannelCount> sizes = channelSizes<long double>(p, around);
            for (const std::int64_t target : targets()) {
                const OnTarget on(target);
                const double error = worstError<Digits50>(evaluate(p, instants), run, sizes);
                QVERIFY2(error <= kPromise,
                         qPrintable(QString::fromStdString(describe(p)) + QString(": %1").arg(error)));
                worst = std::max(worst, error);
            }
        }
    }
    qInfo("worst: %.3g of peak", worst);
}

/// Rockers too, both branches, to the last bit.
void tst_batch::isTheClosedFormOnNamedCases()
{
    for (const Case &which : allCases()) {
        Parameters p = which.parameters;
        const std::vector<double> instants = instantsOf(which);
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            for (const std::int64_t target : targets()) {
                const OnTarget on(target);
                const QString difference = differenceFromOneByOne(p, instants);
                QVERIFY2(difference.isEmpty(), qPrintable(QString(hwy::TargetName(target)) + ", " + difference));
            }
        }
    }
}

void tst_batch::isTheClosedFormOnRandomMechanisms()
{
    RandomMechanisms random(20240503);
    for (int i = 0; i < 300; ++i) {
        Parameters p = random.next();
        p.b *= random.uniform(0.6, 1.1); // rockers among them
        std::vector<double> instants;
        for (int k = 0; k < 61; ++k) {
            instants.push_back(random.uniform(-100.0, 100.0));
        }
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            p.branch = branch;
            for (const std::int64_t target : targets()) {
                const OnTarget on(target);
                const QString difference = differenceFromOneByOne(p, instants);
                QVERIFY2(difference.isEmpty(), qPrintable(QString(hwy::TargetName(target)) + ", " + difference));
            }
        }
    }
}

/// From none to several vectors, and around the lengths that are worked on at once; starting anywhere.
void tst_batch::takesRunsOfAnyLength()
{
    const Sampling sampling{0.0, 1.0, 300};
    const std::vector<double> instants = sampling.instants();
    std::vector<std::size_t> lengths;
    for (std::size_t length = 0; length <= 40; ++length) {
        lengths.push_back(length);
    }
    for (const std::size_t length : {63, 64, 65, 127, 128, 129, 200, 255, 256, 257}) {
        lengths.push_back(length);
    }
    for (const std::int64_t target : targets()) {
        const OnTarget on(target);
        for (const std::size_t length : lengths) {
            for (const std::size_t from : {0, 1, 3}) {
                const QString difference =
                    differenceFromOneByOne(Parameters{}, std::span(instants).subspan(from, length));
                QVERIFY2(difference.isEmpty(), qPrintable(QString(hwy::TargetName(target)) + ", " + difference));
            }
        }
    }
}

void tst_batch::isTheSameInEveryLane()
{
    const std::vector<double> instants(19, 0.73);
    for (const std::int64_t target : targets()) {
        const OnTarget on(target);
        const Answer answer = evaluate(Parameters{}, instants);
        for (const std::vector<double> &values : answer.values) {
            for (std::size_t i = 1; i < instants.size(); ++i) {
                QVERIFY(values[i] == values[0]);
            }
        }
    }
}

/// Every kind of instant at every place among ordinary ones.
void tst_batch::keepsMixedStatusesApart()
{
    struct Kind {
        const char *name;
        Parameters parameters;
        double odd;
        Status status;
    };
    Parameters locked = withLengths(5.0, 25.0); // in its one pose, θ2 = 90°, at t = 0
    locked.theta20 = 0.5 * std::numbers::pi;
    const Kind kinds[] = {
        {"not a number", Parameters{}, kNone, Status::NotFinite},
        {"infinite", Parameters{}, kInfinity, Status::NotFinite},
        {"overflows", Parameters{}, 1e308, Status::NotFinite},
        {"outside a rocker's arc", withLengths(40.0, 25.0), 0.75, Status::NotAssemblable},
        {"square", locked, 0.0, Status::Singular},
        {"angle too large for vectors", Parameters{}, 1e9 + 0.3, Status::Solved},
    };
    for (const Kind &kind : kinds) {
        QCOMPARE(ClosedForm{Mechanism(kind.parameters)}.motionAt(kind.odd).status, kind.status);
        for (const std::int64_t target : targets()) {
            const OnTarget on(target);
            for (std::size_t length = 1; length <= 20; ++length) {
                for (std::size_t place = 0; place < length; ++place) {
                    std::vector<double> instants(length);
                    for (std::size_t i = 0; i < length; ++i) {
                        instants[i] = 0.01 * static_cast<double>(i) + 0.005;
                    }
                    instants[place] = kind.odd;
                    instants[(place * 7 + 3) % length] = kind.odd;
                    for (const unsigned asked : {kAllSix, 3U, 1U, 0U}) {
                        const QString difference = differenceFromOneByOne(kind.parameters, instants, asked);
                        QVERIFY2(
                            difference.isEmpty(),
                            qPrintable(
                                QString("%1, %2, %3").arg(kind.name).arg(hwy::TargetName(target)).arg(difference)));
                    }
                }
            }
        }
    }
}

/// The reduction's own limit, 1.6e6 rad, is not to be seen in the numbers.
void tst_batch::takesAnglesOfAnySize()
{
    Parameters p = withLengths(60.0, 25.0);
    const std::vector<double> turn = Sampling{}.instants();
    const std::array<double, kChannelCount> sizes = channelSizes<long double>(p, exactRun<long double>(p, turn));
    std::vector<double> instants;
    for (double t = 0.1; t < 1e15; t *= 1.37) {
        instants.push_back(t);
        instants.push_back(-t);
    }
    const double limit = 1.6e6 / p.omega2;
    for (const double nearLimit : {limit, std::nextafter(limit, 0.0), std::nextafter(limit, 1e9), 0.999 * limit}) {
        instants.push_back(nearLimit);
        instants.push_back(-nearLimit);
    }
    for (double quarter = 0.25; quarter < limit; quarter *= 2.0) {
        instants.push_back(quarter); // square, to the last digit
        instants.push_back(std::nextafter(quarter, 0.0));
    }
    const std::vector<ExactState<Digits100>> run = exactRun<Digits100>(p, instants);
    for (const std::int64_t target : targets()) {
        const OnTarget on(target);
        const double error = worstError<Digits100>(evaluate(p, instants), run, sizes);
        QVERIFY2(error <= kPromise, qPrintable(QString::number(error)));
        const QString difference = differenceFromOneByOne(p, instants);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }

    // A speed and an angle that are both too large, and cancel.
    p.omega2 = 1e12;
    p.theta20 = -1e12;
    const double cancelling[] = {1.0, std::nextafter(1.0, 2.0), std::nextafter(1.0, 0.0), 1.0000001};
    for (const std::int64_t target : targets()) {
        const OnTarget on(target);
        const QString difference = differenceFromOneByOne(p, cancelling);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
    p.omega2 = 2.0 * std::numbers::pi;
    for (const double theta20 : {1e6, 1.5e6, 1.7e6, 1e12}) {
        p.theta20 = theta20;
        const QString difference = differenceFromOneByOne(p, turn);
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
}

void tst_batch::writesOnlyWhatIsAskedFor()
{
    const std::vector<double> instants = Sampling{0.0, 1.0, 20}.instants();
    for (const std::int64_t target : targets()) {
        const OnTarget on(target);
        for (unsigned asked = 0; asked <= kAllSix; ++asked) {
            const QString difference = differenceFromOneByOne(withLengths(45.0, -25.0), instants, asked);
            QVERIFY2(difference.isEmpty(), qPrintable(difference));
        }
    }
}

QTEST_APPLESS_MAIN(tst_batch)
#include "tst_batch.moc"
