// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pixels.h"
#include "tests/support/suite.h"
#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "tests/ui/mechanism/drawn.h"
#include "ui/document/session.h"
#include "ui/mechanism/mechanism_text.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_mechanism_view
{

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kImpossibleTime = 0.75; // s; θ2 = 270°, where kOscillating would need b = 45 mm

const Parameters kOscillating{.b = 40.0};

/// A view connected with a session.
struct TestedView {
    Session session;
    MechanismView view;

    explicit TestedView(const Parameters &parameters = {})
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

    QImage picture() { return view.grab().toImage(); }
    QPointF A() const
    {
        return session.parameters().a * QPointF(session.pose().motion.crank.cos, session.pose().motion.crank.sin);
    }
    QPointF B() const { return {session.pose().motion.R4x, session.parameters().c}; }

    void press(QPointF model, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(&view, Qt::LeftButton, keys, view.toPixels(model).toPoint());
    }
    void move(QPointF model) { QTest::mouseMove(&view, view.toPixels(model).toPoint()); }
    void release(QPointF model) { QTest::mouseRelease(&view, Qt::LeftButton, {}, view.toPixels(model).toPoint()); }
    void drag(QPointF from, QPointF to, Qt::KeyboardModifiers keys = {})
    {
        press(from, keys);
        move(to);
        release(to);
    }

    /// Returns all texts of the drawing.
    QString text() const
    {
        TextRecorder recorder(view.size());
        QPainter painter(&recorder);
        view.paintMechanism(painter, view.size(), view.palette());
        painter.end();
        QStringList lines;
        for (const auto &[line, place] : recorder.texts) {
            lines << line.trimmed();
        }
        return lines.join(u' ').replace(QChar::Nbsp, u' ');
    }
};

class TestMechanismView : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QApplication::setStyle("Fusion");
        QApplication::setPalette(paletteFor(Theme::Light));
    }

    /// An export sets the result and the settings before the first pose.
    void drawsNoLinkageWithoutAPose()
    {
        TestedView tested;
        tested.view.setSettings({.names = true});
        QVERIFY(tested.text().contains("O₂"));
        tested.view.setPose({});
        QVERIFY(!tested.text().contains("O₂"));
    }

    void keepsTheWholeMotionInViewAndToScale()
    {
        for (const Parameters &parameters :
             {Parameters(), Parameters{.branch = Branch::Crossed}, Parameters{.c = -25.0}, Parameters{.c = 0.0},
              kOscillating, Parameters{.a = 40.0, .b = 20.0, .c = 5.0}, Parameters{.a = 0.02, .b = 0.065, .c = 0.025},
              Parameters{.a = 2e6, .b = 6.5e6, .c = 2.5e6}}) {
            TestedView tested(parameters);
            const QRectF inside = QRectF(tested.view.rect()).adjusted(8.0, 8.0, -8.0, -8.0);
            const QPointF origin = tested.view.toPixels({});
            int poses = 0;
            for (int i = 0; i <= 100; ++i) {
                tested.session.setTime(i / 100.0);
                const double theta2 = kTurn * i / 100.0;
                QVERIFY(
                    inside.contains(tested.view.toPixels(parameters.a * QPointF(std::cos(theta2), std::sin(theta2)))));
                const bool exists = tested.session.pose().exists();
                QVERIFY(!exists || inside.contains(tested.view.toPixels(tested.B())));
                poses += exists ? 1 : 0;
                QCOMPARE(tested.view.toPixels({}), origin); // the frame does not move
            }
            QVERIFY(poses > 20);
            const QPointF right = tested.view.toPixels({parameters.a, 0.0}) - origin;
            const QPointF up = tested.view.toPixels({0.0, parameters.a}) - origin;
            QVERIFY2(right.x() > 20.0 && qFuzzyCompare(right.x(), -up.y()), qPrintable(QString::number(right.x())));
        }
    }

    void followsALengthInCoarseStepsAndFitsItAtTheEnd()
    {
        TestedView tested;
        auto *delay = tested.view.findChild<QTimer *>("refitDelay");
        const QRectF fitted = tested.view.frame().fitted();
        int changes = 0;
        for (int i = 0; i <= 200; ++i) {
            const QRectF before = tested.view.frame().fitted();
            tested.session.setParameter(Parameter::B, 65.0 + 0.5 * i);
            changes += tested.view.frame().fitted() != before ? 1 : 0;
        }
        QVERIFY2(changes >= 1 && changes <= 5, qPrintable(QString::number(changes)));
        tested.session.setParameter(Parameter::B, 80.0);
        tested.session.setParameter(Parameter::B, 65.0);
        const QRectF coarse = tested.view.frame().fitted();
        QVERIFY(coarse != fitted);

        tested.press({-15.0, -15.0}); // nothing moves while a button is held
        delay->start(0);
        QTest::qWait(20);
        QCOMPARE(tested.view.frame().fitted(), coarse);
        tested.release({-15.0, -15.0});
        AWAIT(tested.view.frame().fitted() == fitted);
        QVERIFY(!delay->isActive());

        tested.view.setZoom(QRectF(-10.0, -10.0, 20.0, 20.0)); // a zoom chosen by the user does not change
        const QPointF there = tested.view.toPixels({5.0, 5.0});
        tested.session.setParameter(Parameter::B, 150.0);
        QCOMPARE(tested.view.toPixels({5.0, 5.0}), there);
        tested.view.fit();
        QVERIFY(!tested.view.zoom() && tested.view.toPixels({5.0, 5.0}) != there);
    }

    void drawsTheCrankAndTheGapWhereItCannotBeAssembled()
    {
        const Drawn drawn(kOscillating, kImpossibleTime);
        QCOMPARE(drawn.partAt({0.0, -20.0}), DrawnPart::A); // the crank is drawn at θ2 = 270°
        QCOMPARE(drawn.partAt({0.0, -10.0}), DrawnPart::Crank);
        QVERIFY(!drawn.sketch->has(DrawnPart::Coupler) && !drawn.sketch->has(DrawnPart::Slider)); // no older pose
        QVERIFY(!drawn.label("gap = 5 mm").isNull());
        const auto isCircleOfCoupler = [&drawn](const DrawnShape &shape) {
            const QRectF circle = shape.path.boundingRect();
            const QPointF away = circle.center() - drawn.sketch->toPixels({0.0, -20.0});
            return std::abs(circle.width() - 80.0 * drawn.sketch->projection().scale) < 1e-6 &&
                   away.manhattanLength() < 1e-6;
        };
        QVERIFY(std::ranges::any_of(drawn.sketch->shapes(), isCircleOfCoupler));
    }

    void saysWhyItCannotBeAssembledAndWhatWouldHelp()
    {
        for (const auto &[c, limit] : {std::pair(25.00001, "full turns if b ≥ 45.0001 mm"),
                                       std::pair(100.00001, "assembled if b ≥ 80.0001 mm")}) {
            TestedView tested({.b = 40.0, .c = c});
            tested.session.setTime(kImpossibleTime);
            QVERIFY2(tested.text().contains(limit), qPrintable(tested.text()));
        }
    }

    /// A former defect: the button for the assembly covered the reason.
    void theReasonIsBesideTheButton()
    {
        for (const Parameters &parameters :
             {Parameters{.b = 10.0}, Parameters{.b = 10.0, .c = -25.0}, Parameters{.a = 76.2, .b = 12.7, .c = 78.0},
              Parameters{.b = 10.0, .c = -25.0, .branch = Branch::Crossed}}) {
            for (const QSize &size : {QSize(550, 620), QSize(450, 340), QSize(400, 260)}) {
                TestedView tested(parameters);
                tested.view.resize(size);
                tested.view.show();
                tested.view.fit();
                QCoreApplication::processEvents();
                TextRecorder recorder(tested.view.size());
                tested.view.render(&recorder, {}, {}, QWidget::DrawWindowBackground); // without the button
                const QRectF button = tested.view.findChild<QToolButton *>()->geometry();
                int reasons = 0;
                for (const auto &[line, place] : recorder.texts) {
                    const bool isReason =
                        line.contains("assembled") || line.contains("too short") || line.contains("full turns");
                    reasons += isReason;
                    QVERIFY2(!isReason || !place.intersects(button), qPrintable(line));
                }
                QVERIFY(reasons > 0);
            }
        }
    }

    void findsThePartUnderThePointer()
    {
        using enum DrawnPart;
        const Drawn drawn({}, 0.3);
        const Drawn oscillating(kOscillating, 0.2);
        const QPointF pinA = drawn.scene.crankPin();
        const QPointF pinB = drawn.scene.wristPin();
        const MotionLimits &limits = drawn.scene.result->limits;
        const std::pair<QPointF, DrawnPart> places[] = {{pinA, A},
                                                        {pinA + QPointF(0.0, 2.0), A},
                                                        {pinB, B},
                                                        {pinB + QPointF(2.0, 0.0), Slider},
                                                        {{}, O2},
                                                        {0.5 * pinA, Crank},
                                                        {0.3 * pinA + 0.7 * pinB, Coupler},
                                                        {0.5 * (pinA + pinB), G3},
                                                        {{-15.0, 25.0}, Guide},
                                                        {{0.0, -2.0}, Ground},
                                                        {{60.0, -20.0}, Background},
                                                        {{limits.innerDeadCentre->R4x, 26.5}, InnerDeadCentre},
                                                        {{limits.outerDeadCentre->R4x, 26.5}, OuterDeadCentre}};
        for (const auto &[model, part] : places) {
            QCOMPARE(drawn.partAt(model), part);
        }
        QCOMPARE(oscillating.partAt({0.0, -20.0}), ForbiddenArc);
        QCOMPARE(oscillating.partAt({-20.0, 0.0}), Background);
    }

    void describesEachPartByTheKeyboard()
    {
        TestedView tested;
        const auto *note = tested.view.findChild<QLabel *>("mechanismNote");
        QStringList notes;
        for (int i = 0; i < 11; ++i) {
            QTest::keyClick(&tested.view, Qt::Key_PageDown);
            notes << note->text();
        }
        notes.removeDuplicates();
        QCOMPARE(notes.size(), qsizetype(9)); // O2 and the ground share a note, and so do B and the slider
        QVERIFY(notes.join(u' ').contains("ω₂ = 6.283 rad/s"));
    }

    void highlightsThePartOfAnEquation()
    {
        TestedView tested;
        const QImage plain = tested.picture();
        QImage before = plain;
        for (int part = 1; part <= static_cast<int>(MechanismPart::Drive); ++part) {
            tested.view.highlight(static_cast<MechanismPart>(part));
            QVERIFY(tested.picture() != before && tested.picture() != plain);
            before = tested.picture();
        }
        tested.view.highlight(MechanismPart::None);
        QCOMPARE(tested.picture(), plain);
    }

    void draggingTheCrankPinScrubs()
    {
        struct Row {
            double omega2, duration, from, degrees, time;
        };
        const Row rows[] = {{kTurn, 1.0, 0.1, 72.0, 0.2},    {kTurn, 1.0, 0.3, 72.0, 0.2},
                            {kTurn, 1.0, 0.05, -36.0, 0.9},  // before the start, so a turn later
                            {kTurn, 2.0, 1.1, 72.0, 1.2},    // in the second turn
                            {-kTurn, 1.0, 0.1, -72.0, 0.2},  // clockwise
                            {kTurn, 0.25, 0.2, 120.0, 0.25}, // past the end
                            {kTurn, 0.25, 0.05, -30.0, 0.0}, {0.0, 1.0, 0.1, 72.0, 0.1}}; // at rest
        for (const Row &row : rows) {
            TestedView tested({.omega2 = row.omega2});
            tested.session.setSampling({0.0, row.duration, 200});
            tested.session.setTime(row.from);
            const double angle = row.degrees / kDegreesPerRadian;
            tested.drag(tested.A(), 30.0 * QPointF(std::cos(angle), std::sin(angle)));
            QVERIFY2(std::abs(tested.session.time() - row.time) < 0.005, // the error of one pixel
                     qPrintable(QString::number(tested.session.time())));
        }
    }

    void slidesThroughADeadCentreWithoutTurningBack()
    {
        TestedView tested;
        tested.session.setTime(0.9); // the outer dead centre is at θ2 = 17.1°, t = 1.0475
        tested.session.setSampling({0.0, 4.0, 400});
        tested.press(tested.B());
        double before = tested.session.time();
        const auto moveTo = [&](double x) {
            tested.move({x, 25.0});
            QVERIFY2(tested.session.time() >= before - 1e-6 && tested.session.time() - before < 0.2,
                     qPrintable(QStringLiteral("%1 after %2").arg(tested.session.time()).arg(before)));
            before = tested.session.time();
        };
        for (double x = tested.B().x(); x < 86.0; x += 2.0) {
            moveTo(x);
        }
        QVERIFY(std::abs(tested.session.time() - 1.0475) < 1e-3);
        for (double x = 86.0; x > 33.0; x -= 2.0) { // back again: the crank turns on
            moveTo(x);
        }
        QVERIFY(tested.session.time() > 1.5);
        tested.release({60.0, 25.0});
    }

    void pullsLengthsAndTakesThemBack()
    {
        struct Row {
            QPointF from, by; // mm
            Qt::KeyboardModifiers keys;
            Parameter parameter;
            double length;
        };
        const Row rows[] = {{{20.0, 0.0}, {5.0, 0.0}, Qt::ShiftModifier, Parameter::A, 25.0},
                            {{10.0, 0.0}, {-5.0, 3.0}, {}, Parameter::A, 15.0},
                            {{50.0, 12.5}, {12.0, 5.0}, {}, Parameter::B, 78.0},
                            {{-15.0, 25.0}, {0.0, -10.0}, {}, Parameter::C, 15.0},
                            {{10.0, 0.0}, {-40.0, 0.0}, {}, Parameter::A, 0.5}}; // beyond O₂
        for (const Row &row : rows) {
            TestedView tested;
            const QPointF fixed = tested.view.toPixels({10.0, 10.0});
            tested.press(row.from, row.keys);
            for (int i = 1; i <= 8; ++i) {
                tested.move(row.from + i / 8.0 * row.by);
                QCOMPARE(tested.view.toPixels({10.0, 10.0}), fixed); // nothing jumps under the pointer
            }
            tested.release(row.from + row.by);
            const double length = valueOf(tested.session.parameters(), row.parameter);
            QVERIFY2(std::abs(length - row.length) <= 0.6, qPrintable(QString::number(length)));
            QCOMPARE(2.0 * length, std::round(2.0 * length)); // on a grid of half millimetres
            QCOMPARE(tested.session.undoStack().count(), 1);
            tested.session.undoStack().undo();
            QCOMPARE(tested.session.parameters(), Parameters());

            tested.press(row.from, row.keys);
            tested.move(row.from + row.by);
            QVERIFY(tested.session.parameters() != Parameters());
            QTest::keyClick(&tested.view, Qt::Key_Escape);
            QCOMPARE(tested.session.parameters(), Parameters());
            tested.release(row.from);
        }
    }

    void flipsTheAssembly()
    {
        for (const auto &[shown, flipped] :
             {std::pair(Branch::Open, Branch::Crossed), {Branch::Crossed, Branch::Open}}) {
            TestedView tested({.branch = shown});
            QSignalSpy requested(&tested.view, &MechanismView::branchRequested);
            tested.view.findChild<QToolButton *>("flipButton")->click();
            QCOMPARE(requested.takeFirst()[0].value<Branch>(), flipped);
        }
    }

    void zoomsAndMovesTheDrawing()
    {
        TestedView tested;
        const QPointF whole = tested.view.toPixels({30.0, 5.0});
        tested.drag({60.0, -20.0}, {50.0, -10.0});
        const QPointF moved = tested.view.toPixels({30.0, 5.0});
        QVERIFY(tested.view.zoom() && moved != whole);
        const auto scale = [&tested] { return tested.view.toPixels({1.0, 0.0}).x() - tested.view.toPixels({}).x(); };
        const double before = scale();
        const auto triggerActionOf = [&tested](Qt::Key key) {
            for (QAction *action : tested.view.choices()) {
                if (action->shortcuts().contains(QKeySequence(key))) {
                    action->trigger();
                }
            }
        };
        triggerActionOf(Qt::Key_Plus); // zooms in
        QTest::keyClick(&tested.view, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(scale() > 1.2 * before);
        triggerActionOf(Qt::Key_0); // fits the drawing
        QVERIFY(!tested.view.zoom());
        QCOMPARE(tested.view.toPixels({30.0, 5.0}), whole);
    }

    void arrowsAreTheDerivativesOfWhatIsDrawn_data()
    {
        QTest::addColumn<double>("alpha2"); // rad/s²
        QTest::newRow("constant speed") << 0.0;
        QTest::newRow("accelerated") << 60.0; // a former defect: the arrows were those of a constant speed
        QTest::newRow("decelerated") << -25.0;
    }

    void arrowsAreTheDerivativesOfWhatIsDrawn()
    {
        QFETCH(const double, alpha2);
        constexpr double kTime = 0.37; // s
        const Drawn drawn({}, kTime, {.velocity = true, .acceleration = true}, {800.0, 600.0}, alpha2);
        const SeriesColours colours = drawn.sketch->colours();
        const ArrowScale velocity = drawn.scene.arrows(&PointMotion::velocity);
        const Parameters p;
        constexpr double kStep = 1e-4; // s
        for (const LinkagePoint point : kLinkagePoints) {
            const auto at = [&](double time) -> QPointF {
                // With α₂, the crank is where it would be at a different time without α₂.
                const double later = time - 0.37; // s
                const Pose pose = poseAt(p, time + 0.5 * alpha2 * later * later / p.omega2);
                const QPointF A = p.a * QPointF(pose.motion.crank.cos, pose.motion.crank.sin);
                const QPointF B(pose.motion.R4x, p.c);
                switch (point) {
                case LinkagePoint::A: return A;
                case LinkagePoint::B: return B;
                case LinkagePoint::G3: break;
                }
                return 0.5 * (A + B);
            };
            const auto hasArrow = [&](QPointF derivative, const ArrowScale &scale, const QColor &colour) {
                const QPointF tip = drawn.sketch->toPixels(at(kTime) + derivative * (scale.length / scale.amount));
                return std::ranges::any_of(drawn.sketch->shapes(), [&](const DrawnShape &shape) {
                    // The first point of an arrow head is its tip.
                    return shape.brush.color() == colour && shape.path.length() > 10.0 &&
                           (QPointF(shape.path.elementAt(0)) - tip).manhattanLength() < 0.05;
                });
            };
            QVERIFY(hasArrow((at(kTime + kStep) - at(kTime - kStep)) / (2.0 * kStep), velocity, colours.velocity));
            QVERIFY(hasArrow((at(kTime + kStep) - 2.0 * at(kTime) + at(kTime - kStep)) / (kStep * kStep),
                             drawn.scene.arrows(&PointMotion::acceleration), colours.acceleration));
        }
        QVERIFY(!drawn.label(arrowScaleText(velocity)).isNull());
        const QString scale = arrowScaleText(drawn.scene.arrows(&PointMotion::acceleration));
        const auto states = [&](const QString &text) {
            return std::ranges::count(drawn.sketch->labels(), text, &Label::text) == 1;
        };
        QVERIFY(states(alpha2 == 0.0 ? scale : QStringLiteral("%1, α₂ = %2 rad/s²").arg(scale, numberText(alpha2))));
    }

    /// A former defect: the scale remained that of the acceleration without α₂.
    void showsAChangedCrankAccelerationAtOnce()
    {
        TestedView tested;
        tested.view.setSettings({.acceleration = true});
        const QImage atConstantSpeed = tested.picture();
        tested.session.setAlpha2(300.0);
        const QImage accelerated = tested.picture();
        QVERIFY(accelerated != atConstantSpeed);
        tested.view.refreshNotation(); // draws everything again
        QCOMPARE(accelerated, tested.picture());
    }

    /// With ω₂ = 0, the acceleration of A is a α₂ = 20 mm · 5 rad/s². θ₂ = 0: α₃ = −a α₂ / √(b² − c²) = −5/3 rad/s².
    void statesTheAccelerationsOfACrankThatStarts()
    {
        const Drawn drawn({.omega2 = 0.0}, 0.0, {.acceleration = true}, {800.0, 600.0}, 5.0);
        const PointMotion pin = drawn.scene.motion(LinkagePoint::A);
        QVERIFY(std::abs(pin.acceleration.x) < 1e-12 && std::abs(pin.acceleration.y - 100.0) < 1e-12);
        const ArrowScale scale = drawn.scene.arrows(&PointMotion::acceleration);
        QVERIFY(scale.amount > 0.0);
        const QPointF tip = drawn.sketch->toPixels(QPointF(20.0, 100.0 * scale.length / scale.amount));
        QVERIFY(std::ranges::any_of(drawn.sketch->shapes(), [&tip](const DrawnShape &shape) {
            return !shape.path.isEmpty() && (QPointF(shape.path.elementAt(0)) - tip).manhattanLength() < 0.05;
        }));
        QVERIFY2(partText(drawn.scene, DrawnPart::Coupler).contains("α³ = −95.49 °/s²"),
                 qPrintable(partText(drawn.scene, DrawnPart::Coupler)));
    }

    void showsTheInstantCentre()
    {
        const MechanismSettings settings{.instantCentre = true};
        // At θ2 = 0, P is at (R4x, 0): PA = √(b² − c²) = 60 mm, PB = c = 25 mm, ω3 = −a ω2 / PA = −2π/3 rad/s.
        const Drawn drawn({}, 0.0, settings);
        QVERIFY(!drawn.label("Instant centre P: ω³ = −2.094 rad/s = −120.0 °/s").isNull());
        QVERIFY(!drawn.label("PA = 60.00 mm, PB = 25.00 mm").isNull());
        QVERIFY(!Drawn({}, 0.25, settings).label("Instant centre P at infinity").isNull());
        QVERIFY(Drawn(kOscillating, kImpossibleTime, settings).label("Instant").isNull());
    }

    /// A former defect: in pictures the lengths were written twice.
    void picturesHaveALegendWithoutTheLengths()
    {
        TestedView tested;
        tested.view.setSettings({.velocity = true, .acceleration = true, .dimensions = true, .instantCentre = true});
        tested.session.setTime(0.3);
        const QString text = tested.text();
        QCOMPARE(text.count("Scale"), 2);
        QVERIFY(text.contains("Instant centre P") && !text.contains("a = 20 mm"));
    }

    void showsTheGhostWithinTheView()
    {
        TestedView tested;
        const SeriesColours colours = seriesColours(tested.view.palette());
        const QImage without = tested.picture();
        tested.view.setGhost({.exists = true, .pinX = 10.0, .pinY = -12.0, .sliderX = 70.0, .sliderY = 20.0});
        QVERIFY(countPixels(tested.picture(), colours.reference) > 20);
        QVERIFY(tested.text().contains("file"));
        tested.view.setGhost({});
        QCOMPARE(tested.picture(), without);

        const QPointF before = tested.view.toPixels({20.0, 0.0});
        for (const double tooLarge : {2e4, qInf()}) { // as in a different unit; the model must not become tiny
            tested.view.setGhostBounds(QRectF(0.0, 0.0, tooLarge, 1.0));
            QCOMPARE(tested.view.toPixels({20.0, 0.0}), before);
        }
        tested.view.setGhostBounds(QRectF(QPointF(-20.0, -20.0), QPointF(130.0, 25.0)));
        QVERIFY(QRectF(tested.view.rect()).contains(tested.view.toPixels({130.0, 25.0})));
    }

    void linksGrowWithTheFont()
    {
        TestedView tested;
        const SeriesColours colours = seriesColours(tested.view.palette());
        const int usual = countPixels(tested.picture(), colours.model);
        const QPointF there = tested.view.toPixels({7.0, 0.0});
        QFont font = tested.view.font();
        font.setPixelSize(2 * QFontInfo(font).pixelSize());
        tested.view.setFont(font);
        QCOMPARE(tested.view.toPixels({7.0, 0.0}), there); // nothing moves
        QVERIFY(countPixels(tested.picture(), colours.model) > 3 * usual / 2);
    }

    void paintsVectorsInLandscapeForDocuments()
    {
        TestedView tested({.c = 150.0});
        QVERIFY(tested.view.pictureHeight(900) < 900);
        QImage image(900, 600, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        tested.view.paintMechanism(painter, image.size(), paletteFor(Theme::Dark));
        painter.end();
        QCOMPARE(countPixels(image, Qt::magenta), 0);
        QVERIFY(countPixels(image, paletteFor(Theme::Dark).color(QPalette::Base)) > 900 * 300);
    }
};

const Suite<TestMechanismView> suite("tst_mechanism_view");

} // namespace tst_mechanism_view

#include "tst_mechanism_view.moc"
