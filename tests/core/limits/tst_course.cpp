// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/course.h"

#include "core/closed_form/batch.h"
#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr int kSteps = 20'000;

/// The motion at crank angles all round, with ω2 = 1 or -1.
struct Turn {
    std::vector<double> theta2;
    std::array<std::vector<double>, kChannels> values;
};

Turn turnOf(Parameters p)
{
    Turn turn;
    p.omega2 = 1.0;
    p.theta20 = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        turn.theta2.push_back(-std::numbers::pi + kTurn * i / kSteps);
    }
    for (std::vector<double> &values : turn.values) {
        values.resize(turn.theta2.size());
    }
    std::vector<Status> statuses(turn.theta2.size());
    ClosedFormBatch(Mechanism(p))
        .evaluate(turn.theta2,
                  {turn.values[0].data(), turn.values[1].data(), turn.values[2].data(), turn.values[3].data(),
                   turn.values[4].data(), turn.values[5].data()},
                  statuses);
    return turn;
}

/// Where the motion reaches beyond what the course says it can between two neighbouring crank angles; empty: nowhere.
QString whereItLeaves(const Course &course, std::size_t channel, const Turn &turn)
{
    const std::vector<double> &values = turn.values[channel];
    double size = 0.0;
    for (const double value : values) {
        size = std::isfinite(value) ? std::max(size, std::abs(value)) : size;
    }
    constexpr int kLook = 50; // angles at once
    for (std::size_t from = 0; from + kLook < values.size(); from += kLook) {
        const std::size_t to = from + kLook;
        double lower = std::min(values[from], values[to]);
        double upper = std::max(values[from], values[to]);
        bool isWhole = std::isfinite(values[from]) && std::isfinite(values[to]);
        for (const CoursePoint &point : course) {
            if (turn.theta2[from] <= point.theta2 && point.theta2 <= turn.theta2[to]) {
                lower = std::min(lower, point.value);
                upper = std::max(upper, point.value);
                isWhole = isWhole && point.kind == CoursePoint::Kind::Turn;
            }
        }
        if (!isWhole) {
            continue; // it ends or begins there
        }
        for (std::size_t i = from; i <= to; ++i) {
            const double beyond = std::max(lower - values[i], values[i] - upper);
            if (!(beyond <= 1e-9 * size)) {
                return QStringLiteral("channel %1 at θ2 = %2: %3 beyond %4 … %5")
                    .arg(channel)
                    .arg(turn.theta2[i], 0, 'g', 12)
                    .arg(values[i], 0, 'g', 12)
                    .arg(lower, 0, 'g', 12)
                    .arg(upper, 0, 'g', 12);
            }
        }
    }
    return {};
}

void check(const Parameters &p, const QString &name)
{
    Parameters unit = p;
    unit.omega2 = 1.0;
    std::array<Course, kChannels> courses = coursesOf(Mechanism(unit));
    const Turn turn = turnOf(p);
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
        for (CoursePoint &point : courses[channel]) {
            point.value = inAuthorUnit(kPlottedChannels[channel], point.value);
        }
        const QString where = whereItLeaves(courses[channel], channel, turn);
        QVERIFY2(where.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(name, where)));
    }
}

} // namespace

/// Between two places of a course the motion only rises or only falls.
class TestCourse : public QObject
{
    Q_OBJECT

private slots:
    void holdsWhateverHappensInBetween()
    {
        for (const Case &which : allCases()) {
            check(which.parameters, QString::fromUtf8(which.name.data(), static_cast<qsizetype>(which.name.size())));
        }
        RandomMechanisms random(11);
        for (int i = 0; i < runs(200, 5000); ++i) {
            Parameters p = random.next();
            if (i % 3 == 1) { // rockers, some of two arcs
                p.b *= random.uniform(0.2, 0.95);
            } else if (i % 3 == 2) { // near toggles on either side
                p.b = (p.a + std::abs(p.c)) * (1.0 + random.uniform(-1.0, 1.0) * std::pow(10.0, -random.uniform(1, 9)));
            }
            check(p, QStringLiteral("random %1: a %2 b %3 c %4").arg(i).arg(p.a).arg(p.b).arg(p.c));
        }
    }

    void endsAndBeginsWhereARockerStops()
    {
        Parameters p;
        p.b = 40.0;
        for (const Course &course : coursesOf(Mechanism(p))) {
            const auto count = [&course](CoursePoint::Kind kind) {
                return std::ranges::count(course, kind, &CoursePoint::kind);
            };
            QCOMPARE(count(CoursePoint::Kind::Begin), 1);
            QCOMPARE(count(CoursePoint::Kind::End), 1);
        }
    }

    void isEmptyWhereNothingMoves()
    {
        Parameters p;
        p.b = 4.0;
        for (const Course &course : coursesOf(Mechanism(p))) {
            QVERIFY(course.empty());
        }
    }
};

QTEST_GUILESS_MAIN(TestCourse)
#include "tst_course.moc"
