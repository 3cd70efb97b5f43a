// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/mechanism/drawn_part.h"
#include "ui/mechanism/mechanism_drag.h"
#include "ui/mechanism/mechanism_view.h"

#include "tests/support/waiting.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace
{

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A view in its place: it shows the session, and what it asks for is done.
struct Bench {
    Session session;
    MechanismView view;

    explicit Bench(const Parameters &parameters = {})
    {
        QObject::connect(&session, &Session::resultChanged, &view, &MechanismView::setResult);
        QObject::connect(&session, &Session::timeChanged, &view, &MechanismView::setPose);
        QObject::connect(&view, &MechanismView::timeRequested, &session, &Session::setTime);
        QObject::connect(&view, &MechanismView::lengthRequested, &session, &Session::setParameter);
        QObject::connect(&view, &MechanismView::dragBegan, &session, &Session::beginDrag);
        QObject::connect(&view, &MechanismView::dragEnded, &session, &Session::endDrag);
        view.resize(450, 340);
        session.setParameters(parameters);
        session.undoStack().clear();
        view.setResult(session.result());
        session.setTime(0.0);
    }

    QPointF A() const { return {session.pose().pinX, session.pose().pinY}; }
    QPointF B() const { return {session.pose().sliderX, session.parameters().c}; }

    void press(QPointF model, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(&view, Qt::LeftButton, keys, view.toPixels(model).toPoint());
    }
    void move(QPointF model) { QTest::mouseMove(&view, view.toPixels(model).toPoint()); }
    void release(QPointF model) { QTest::mouseRelease(&view, Qt::LeftButton, {}, view.toPixels(model).toPoint()); }
};

MechanismDrawing drawingAt(const Parameters &parameters, double time)
{
    Session session;
    session.setParameters(parameters);
    MechanismDrawing drawing;
    drawing.result = session.result();
    drawing.pose = poseAt(parameters, time);
    if (drawing.pose.exists()) {
        drawing.pins =
            MechanismDrawing::Pins{{drawing.pose.pinX, drawing.pose.pinY}, {drawing.pose.sliderX, parameters.c}};
    }
    return drawing;
}

} // namespace

class TestMechanismDrag : public QObject
{
    Q_OBJECT

private slots:
    void findsWhatIsUnderThePointer()
    {
        const MechanismDrawing drawing = drawingAt({}, 0.1);
        MechanismFrame frame;
        frame.fit(characteristicLength(drawing.mechanism(), drawing.result->limits));
        const MechanismProjection on = frame.projection({800.0, 600.0});
        const auto partAtModel = [&](QPointF model) { return partAt(drawing, on, on.toPixels(model)); };
        QCOMPARE(partAtModel(drawing.pins->A), DrawnPart::A);
        QCOMPARE(partAtModel(drawing.pins->B), DrawnPart::B);
        QCOMPARE(partAtModel({0.0, 0.0}), DrawnPart::O2);
        QCOMPARE(partAtModel(0.5 * drawing.pins->A), DrawnPart::Crank);
        QCOMPARE(partAtModel(0.5 * (drawing.pins->A + drawing.pins->B)), DrawnPart::Coupler);
        QCOMPARE(partAtModel({-15.0, 25.0}), DrawnPart::Guide);
        QCOMPARE(partAtModel({60.0, -20.0}), DrawnPart::Background);
        QCOMPARE(partAtModel({drawing.result->limits.inner->R4x, 26.5}), DrawnPart::InnerDeadCentre);
    }

    void findsTheArcThatCannotBe()
    {
        Parameters rocker;
        rocker.b = 40.0;
        const MechanismDrawing drawing = drawingAt(rocker, 0.2);
        MechanismFrame frame;
        frame.fit(characteristicLength(drawing.mechanism(), drawing.result->limits));
        const MechanismProjection on = frame.projection({800.0, 600.0});
        QCOMPARE(partAt(drawing, on, on.toPixels({0.0, -20.0})), DrawnPart::ForbiddenArc);
        QCOMPARE(partAt(drawing, on, on.toPixels({-20.0, 0.0})), DrawnPart::Background);
    }

    void turnsTheCrankAnyNumberOfTimes()
    {
        Bench bench;
        bench.session.setSampling({0.0, 4.0, 400});
        bench.press(bench.A());
        for (int step = 1; step <= 3 * 24; ++step) { // 15° each, over ±180°, three turns
            const double angle = kTurn * step / 24.0;
            bench.move({20.0 * std::cos(angle), 20.0 * std::sin(angle)});
            QVERIFY2(std::abs(bench.session.time() - step / 24.0) < 0.01,
                     qPrintable(QString::number(bench.session.time())));
        }
        bench.release(bench.A());
    }

    void slidesThroughADeadCentreWithoutTurningBack()
    {
        Bench bench;
        bench.session.setTime(0.9); // on the way out; the outer dead centre is at θ2 = 17.1°, t = 1.0475
        bench.session.setSampling({0.0, 4.0, 400});
        bench.press(bench.B());
        double before = bench.session.time();
        const auto moveTo = [&](double x) {
            bench.move({x, 25.0});
            QVERIFY2(bench.session.time() >= before - 1e-6 && bench.session.time() - before < 0.2,
                     qPrintable(QStringLiteral("%1 after %2").arg(bench.session.time()).arg(before)));
            before = bench.session.time();
        };
        for (double x = bench.B().x(); x < 86.0; x += 2.0) {
            moveTo(x);
        }
        QVERIFY2(std::abs(bench.session.time() - 1.0475) < 1e-3, qPrintable(QString::number(bench.session.time())));
        for (double x = 86.0; x > 33.0; x -= 2.0) { // in again: the crank goes on
            moveTo(x);
        }
        QVERIFY(bench.session.time() > 1.5);
        for (double x = 33.0; x < 60.0; x += 2.0) { // and through the inner one
            moveTo(x);
        }
        QVERIFY(bench.session.time() > 1.6);
        bench.release({60.0, 25.0});
    }

    void slidesBackTheWayItCame()
    {
        Bench bench;
        bench.session.setTime(0.3);
        bench.press(bench.B());
        bench.move(bench.B() - QPointF(10.0, 0.0));
        QVERIFY(bench.session.time() > 0.32);
        bench.move(poseAt({}, 0.3).sliderX * QPointF(1.0, 0.0) + QPointF(0.0, 25.0));
        QVERIFY2(std::abs(bench.session.time() - 0.3) < 0.01, qPrintable(QString::number(bench.session.time())));
        bench.release(bench.B());
    }

    void pullsLengths_data()
    {
        QTest::addColumn<QPointF>("from");
        QTest::addColumn<QPointF>("by"); // mm
        QTest::addColumn<bool>("withShift");
        QTest::addColumn<double>("a");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("c");
        QTest::newRow("A with Shift") << QPointF(20.0, 0.0) << QPointF(5.0, 0.0) << true << 25.0 << 65.0 << 25.0;
        QTest::newRow("the crank") << QPointF(10.0, 0.0) << QPointF(-5.0, 3.0) << false << 15.0 << 65.0 << 25.0;
        QTest::newRow("the coupler") << QPointF(50.0, 12.5) << QPointF(12.0, 5.0) << false << 20.0 << 78.0 << 25.0;
        QTest::newRow("B with Shift") << QPointF(80.0, 25.0) << QPointF(-10.0, 0.0) << true << 20.0 << 56.0 << 25.0;
        QTest::newRow("the line") << QPointF(-15.0, 25.0) << QPointF(0.0, -10.0) << false << 20.0 << 65.0 << 15.0;
        QTest::newRow("the crank, beyond O₂")
            << QPointF(10.0, 0.0) << QPointF(-40.0, 0.0) << false << 0.5 << 65.0 << 25.0;
    }
    void pullsLengths()
    {
        QFETCH(QPointF, from);
        QFETCH(QPointF, by);
        QFETCH(bool, withShift);
        QFETCH(double, a);
        QFETCH(double, b);
        QFETCH(double, c);
        Bench bench;
        const QPointF stillThere = bench.view.toPixels({10.0, 10.0});
        bench.press(from, withShift ? Qt::ShiftModifier : Qt::NoModifier);
        for (int i = 1; i <= 8; ++i) {
            bench.move(from + i / 8.0 * by);
            QCOMPARE(bench.view.toPixels({10.0, 10.0}), stillThere); // nothing jumps under the hand
        }
        bench.release(from + by);
        const Parameters &got = bench.session.parameters();
        constexpr double kPixel = 0.6; // mm
        QVERIFY2(std::abs(got.a - a) <= kPixel, qPrintable(QString::number(got.a)));
        QVERIFY2(std::abs(got.b - b) <= kPixel, qPrintable(QString::number(got.b)));
        QVERIFY2(std::abs(got.c - c) <= kPixel, qPrintable(QString::number(got.c)));
        for (const double length : {got.a, got.b, got.c}) {
            QCOMPARE(2.0 * length, std::round(2.0 * length)); // on a grid of half millimetres
        }
        QCOMPARE(bench.session.undoStack().count(), 1); // one drag, one step
        bench.session.undoStack().undo();
        QCOMPARE(bench.session.parameters(), Parameters());
    }

    void aDragThatPausesIsOneStep()
    {
        Bench bench;
        bench.press({10.0, 0.0});
        bench.move({14.0, 0.0});
        letTimePass(bench.session); // edits this far apart are steps of their own
        bench.move({16.0, 0.0});
        bench.release({16.0, 0.0});
        QCOMPARE(bench.session.undoStack().count(), 1);
    }

    void escapePutsTheLengthBack()
    {
        Bench bench;
        bench.press({10.0, 0.0});
        bench.move({14.0, 0.0});
        QVERIFY(bench.session.parameters().a > 22.0);
        QTest::keyClick(&bench.view, Qt::Key_Escape);
        QCOMPARE(bench.session.parameters(), Parameters());
        bench.move({18.0, 0.0});
        QCOMPARE(bench.session.parameters(), Parameters());
    }

    void arrowsAreTheDerivativesOfWhatIsDrawn()
    {
        const Parameters parameters;
        MechanismDrawing drawing = drawingAt(parameters, 0.37);
        const Cycle cycle = cycleOf(drawing.mechanism(), drawing.result->limits);
        const QRectF room(-30.0, -30.0, 120.0, 70.0);
        constexpr double kStep = 1e-4; // s
        for (const MotionKind kind : {MotionKind::Velocity, MotionKind::Acceleration}) {
            const ArrowScale scale = arrowScale(cycle, kind, drawing.mechanism(), room, 40.0);
            QVERIFY(scale.amount > 0.0);
            for (const LinkagePoint point : kLinkagePoints) {
                const auto at = [&](double time) -> QPointF {
                    const Pose pose = poseAt(parameters, time);
                    const QPointF A(pose.pinX, pose.pinY);
                    const QPointF B(pose.sliderX, parameters.c);
                    return point == LinkagePoint::A ? A : point == LinkagePoint::B ? B : 0.5 * (A + B);
                };
                const QPointF difference =
                    kind == MotionKind::Velocity
                        ? (at(0.37 + kStep) - at(0.37 - kStep)) / (2.0 * kStep)
                        : (at(0.37 + kStep) - 2.0 * at(0.37) + at(0.37 - kStep)) / (kStep * kStep);
                const std::optional<MotionArrow> arrow =
                    arrowOf(drawing.motion()[static_cast<std::size_t>(point)], kind, scale);
                QVERIFY(arrow && !arrow->isCut);
                const QPointF expected = difference * (scale.length / scale.amount);
                const QPointF off = arrow->tip - arrow->tail - expected;
                QVERIFY2(std::hypot(off.x(), off.y()) < 1e-3, qPrintable(QString::number(off.x())));
            }
            for (const LinkageMotion &instant : cycle.front()) { // and all of a turn is within the room
                for (const PointMotion &motion : instant) {
                    if (const std::optional<MotionArrow> arrow = arrowOf(motion, kind, scale)) {
                        QVERIFY(room.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(arrow->tip));
                    }
                }
            }
        }
    }

    void zoomsAboutThePointerAndFits()
    {
        Bench bench;
        const QPointF whole = bench.view.toPixels({30.0, 5.0});
        bench.press({60.0, -20.0});
        bench.move({50.0, -10.0});
        bench.release({50.0, -10.0});
        QVERIFY(bench.view.toPixels({30.0, 5.0}) != whole);
        QVERIFY(bench.view.zoom().has_value());
        const QPointF moved = bench.view.toPixels({30.0, 5.0});
        bench.session.setTime(0.5);
        Parameters longer;
        longer.b = 150.0;
        bench.session.setParameters(longer);
        QCOMPARE(bench.view.toPixels({30.0, 5.0}), moved); // where somebody looks, it stays
        bench.session.setParameters({});
        bench.view.fit();
        QVERIFY(!bench.view.zoom());
        QCOMPARE(bench.view.toPixels({30.0, 5.0}), whole);
    }
};

QTEST_MAIN(TestMechanismDrag)
#include "tst_mechanism_drag.moc"
