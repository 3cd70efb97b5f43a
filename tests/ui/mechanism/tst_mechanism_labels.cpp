// SPDX-License-Identifier: GPL-3.0-or-later

// The texts of the mechanism's drawing, and what they keep clear of.

#include "core/limits/mobility.h"
#include "core/sampling/trajectory.h"
#include "tests/support/suite.h"
#include "tests/ui/mechanism/drawn.h"
#include "ui/document/session.h"
#include "ui/mechanism/mechanism_text.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"

#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QScopeGuard>
#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

using namespace slidercrank;

namespace tst_mechanism_labels
{

class TestMechanismLabels : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void labelsKeepClearOfTheLinks()
    {
        const MechanismSettings settings{.names = true, .dimensions = true, .angles = true};
        int overlaps = 0;
        for (const Parameters &parameters : {Parameters(), Parameters{.b = 60.0, .branch = Branch::Crossed},
                                             Parameters{.c = 0.0}, Parameters{.c = -25.0}}) {
            for (int i = 0; i < 40; ++i) {
                const Drawn drawn(parameters, i / 40.0, settings);
                for (const QString name : {"O₂", "A", "B", "G₃", "a", "b", "θ₂", "θ³"}) {
                    const QRectF box = drawn.label(name);
                    QVERIFY2(!box.isNull(), qPrintable(name));
                    for (const DrawnShape &shape : drawn.sketch->shapes()) {
                        const bool isLink = shape.part == DrawnPart::Crank || shape.part == DrawnPart::Coupler;
                        overlaps += isLink && shape.path.intersects(box.adjusted(2.0, 4.0, -2.0, -4.0));
                    }
                }
            }
        }
        QCOMPARE(overlaps, 0);
    }

    /// Former defects: in the notation of textbooks, θ₃ at B covered a part of the rail, or the mark of a dead centre.
    void theAngleAtTheSliderKeepsClearOfTheRailAndItsArc()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.symbols = Symbols::Textbook});
        for (const Parameters &parameters : {Parameters(), Parameters{.a = 50.8, .b = 152.4, .c = -76.2},
                                             Parameters{.c = 0.0}, Parameters{.b = 60.0, .branch = Branch::Crossed}}) {
            for (int i = 0; i < 40; ++i) {
                const Drawn drawn(parameters, i / 40.0, {.names = true, .angles = true});
                const QRectF box = drawn.label("θ₃").adjusted(2.0, 3.0, -2.0, -3.0);
                const QPointF pin =
                    drawn.sketch->toPixels({drawn.scene.motion(LinkagePoint::B).position.x, parameters.c});
                QVERIFY(!box.isEmpty());
                for (const DrawnShape &shape : drawn.sketch->shapes()) {
                    const bool isArc = shape.path.elementCount() > 4 && shape.part == DrawnPart::Background &&
                                       QLineF(shape.path.elementAt(0), pin).length() < 0.5;
                    const bool isRail = shape.part == DrawnPart::Guide && shape.path.boundingRect().height() > 2.0;
                    const bool isMark =
                        shape.part == DrawnPart::OuterDeadCentre || shape.part == DrawnPart::InnerDeadCentre;
                    QVERIFY2(!(isArc || isRail || isMark) || !shape.path.intersects(box),
                             qPrintable(QString::number(i)));
                }
            }
        }
    }

    /// A former defect: the names stood beside the mark of the other dead centre, and moved while playing.
    void namesOfTheDeadCentresAreBelowTheirOwnMarks()
    {
        const MechanismSettings settings{.names = true, .angles = true};
        int captions = 0;
        for (const Parameters &parameters :
             {Parameters(), Parameters{.b = 60.0, .branch = Branch::Crossed}, Parameters{.a = 30.0, .b = 200.0},
              Parameters{.a = 3.0, .b = 90.0}, Parameters{.a = 10.0, .b = 120.0, .c = -25.0}, Parameters{.c = 0.0}}) {
            const MotionLimits limits = Drawn(parameters, 0.0, settings).scene.result->limits;
            for (const auto &[name, own, other] :
                 {std::tuple("outer", *limits.outerDeadCentre, *limits.innerDeadCentre),
                  {"inner", *limits.innerDeadCentre, *limits.outerDeadCentre}}) {
                const QRectF box = Drawn(parameters, 0.0, settings).label(name);
                if (box.isNull()) {
                    continue; // left out
                }
                ++captions;
                for (int i = 0; i < 12; ++i) {
                    const Drawn drawn(parameters, i / 12.0, settings);
                    QCOMPARE(drawn.label(name), box); // it does not move
                    const QPointF mark = drawn.sketch->toPixels({own.R4x, parameters.c});
                    QVERIFY(std::abs(box.center().x() - mark.x()) < 0.5 && box.top() > mark.y());
                    QVERIFY(!box.contains(drawn.sketch->toPixels({other.R4x, parameters.c}).x(), box.center().y()));
                    QVERIFY(QRectF(0.0, 0.0, 800.0, 600.0).contains(box));
                }
            }
        }
        QVERIFY2(captions >= 8, qPrintable(QString::number(captions)));
        QCOMPARE(Drawn({.a = 3.0, .b = 90.0}, 0.0, settings).label("outer dead"), QRectF()); // too close together
    }

    /// Former defects: where the coupler passed the name of a dead centre, the coupler covered half of the name; later,
    /// the name hid G₃.
    void namesOfTheDeadCentresAreDrawnOverTheCoupler()
    {
        const Drawn drawn({.a = 40.0, .b = 120.0, .c = 20.0, .theta20 = -std::numbers::pi / 6.0}, 0.0, {.names = true},
                          {321.0, 160.0});
        const QRectF box = drawn.label("inner");
        const auto passes = [&box](const DrawnShape &shape) {
            return shape.part == DrawnPart::Coupler && shape.path.intersects(box);
        };
        QVERIFY(std::ranges::any_of(drawn.sketch->shapes(), passes));
        MechanismSketch scenery(drawn.scene, drawn.sketch->projection(), paletteFor(Theme::Light), QFont());
        scenery.addScenery(); // is painted below the linkage
        const auto isName = [](const Label &label) { return label.text == u"inner"; };
        QCOMPARE(std::ranges::find_if(drawn.sketch->labels(), isName)->paper.alpha(), 0);
        QVERIFY(std::ranges::none_of(scenery.labels(), isName));
    }

    /// A former defect: in a small picture, the number of an angle hid half of the joint A.
    void textsKeepClearOfTheJoints()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.symbols = Symbols::Textbook});
        constexpr double kRadius = 6.5; // px, with a part of the outline
        constexpr int kPoses = 48;
        constexpr std::array kWidths{300.0, 340.0, 380.0, 420.0, 460.0, 500.0, 540.0, 580.0};
        const MechanismSettings settings{.names = true, .dimensions = true, .angles = true};
        const Parameters parameters{.a = 76.2, .b = 203.2, .c = 50.8, .omega2 = 2.0 * std::numbers::pi};
        for (std::size_t i = 0; i < kPoses * kWidths.size(); ++i) {
            const double width = kWidths[i / kPoses];
            const Drawn drawn(parameters, static_cast<double>(i % kPoses) / kPoses, settings, {width, 0.5 * width});
            QRectF joint(0.0, 0.0, 2.0 * kRadius, 2.0 * kRadius);
            joint.moveCenter(drawn.sketch->toPixels(drawn.scene.crankPin()));
            for (const Label &label : drawn.sketch->labels()) {
                const QRectF letters = label.box.adjusted(0.0, 2.0, 0.0, -2.0);
                const bool isBelow = label.text == u"c" || label.paper.alpha() == 0; // painted below the linkage
                QVERIFY2(isBelow || !letters.intersects(joint),
                         qPrintable(QStringLiteral("%1 at %2 px").arg(label.text).arg(width)));
            }
        }
    }

    /// A former defect: the arc of an angle above 180° ran through the name O₂.
    void theArcOfTheCrankKeepsClearOfItsPivotsName()
    {
        for (const double theta20 : {3.5, 4.5, 5.5}) {
            const Drawn drawn({.theta20 = theta20}, 0.0, {.names = true, .angles = true});
            const QRectF name = drawn.label("O₂").adjusted(2.0, 3.0, -2.0, -3.0);
            for (const QPointF corner : {name.topLeft(), name.topRight(), name.bottomLeft(), name.bottomRight()}) {
                QVERIFY(QLineF(drawn.sketch->toPixels({0.0, 0.0}), corner).length() >
                        MechanismSketch::kLargestCrankArc);
            }
        }
    }

    /// A former defect: in a picture of 85 mm, the letter c covered an arrow head of its dimension.
    void theLetterOfTheOffsetKeepsClearOfItsDimension()
    {
        for (const double width : {300.0, 400.0, 900.0}) {
            const Drawn drawn({.a = 40.0, .b = 120.0, .c = 20.0}, 0.0, {.dimensions = true}, {width, 0.6 * width});
            const QRectF letter = drawn.label("c").adjusted(2.0, 3.0, -2.0, -3.0);
            QVERIFY(!letter.isNull());
            const auto covers = [&letter](const DrawnShape &shape) {
                const QRectF box = shape.path.boundingRect();
                const bool isVertical = box.width() < 10.0 && box.height() > 5.0; // the line and its heads
                return isVertical && shape.part == DrawnPart::Background &&
                       box.adjusted(-0.5, 0.0, 0.5, 0.0).intersects(letter);
            };
            QVERIFY(std::ranges::none_of(drawn.sketch->shapes(), covers));
        }
    }

    /// A former defect: in small pictures the upper edge cut the arc of a wide angle of the coupler.
    void picturesContainTheArcOfAWideAngle()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const Parameters high{.c = 25.0};
        const Parameters crossed{.theta20 = 0.5 * std::numbers::pi, .branch = Branch::Crossed};
        for (const auto &[symbols, parameters] :
             {std::pair(Symbols::Textbook, high), {Symbols::AbsoluteCoordinates, crossed}}) {
            setNotation({.symbols = symbols});
            Session session;
            session.setParameters(parameters);
            MechanismView view;
            view.setResult(session.result());
            view.setPose(poseAt(parameters, 0.0));
            view.setSettings({.angles = true});
            QImage image(300, view.pictureHeight(300), QImage::Format_RGB32);
            QPainter painter(&image);
            view.paintMechanism(painter, image.size(), paletteFor(Theme::Light));
            painter.end();
            for (int x = 0; x < image.width(); ++x) {
                QVERIFY2(qGray(image.pixel(x, 0)) > 180, qPrintable(QString::number(x))); // nothing but the grid
            }
        }
    }

    /// A former defect: in the report, the reason why there is no assembly covered the pivot and the crank pin, and in
    /// small pictures, the names of both stood across the letters of the reason.
    void theReasonCoversNothingInPictures()
    {
        MechanismScene scene;
        Session session;
        session.setParameters({.b = 4.0}); // cannot be assembled at any angle
        scene.result = session.result();
        scene.pose = session.pose();
        scene.settings = {.names = true, .dimensions = true, .angles = true};
        for (const double width : {220.0, 380.0, 800.0}) {
            MechanismFrame frame;
            frame.fit(motionBounds(scene.mechanism(), scene.result->limits));
            const MechanismProjection projection = frame.projection({width, 0.6 * width});
            const auto beginsWithReason = [](const Label &label) { return label.text.startsWith("The mechanism"); };
            MechanismSketch picture(scene, projection, paletteFor(Theme::Light), QFont(),
                                    MechanismSketch::Legend::Separate);
            picture.addLinkage();
            QVERIFY(std::ranges::none_of(picture.labels(), beginsWithReason));
            MechanismSketch legend(scene, projection, paletteFor(Theme::Light), QFont(),
                                   MechanismSketch::Legend::Separate);
            legend.addLegend();
            const auto reason = std::ranges::find_if(legend.labels(), beginsWithReason);
            QVERIFY(reason != legend.labels().end() && reason->box.bottom() <= legend.legendHeight());
            QVERIFY(reason->box.left() >= 0.0 && reason->box.right() <= width);
            QVERIFY2(reason->text.contains("b\u00a0≥\u00a045\u00a0mm"), qPrintable(reason->text));

            MechanismSketch onScreen(scene, projection, paletteFor(Theme::Light), QFont());
            onScreen.addLinkage();
            const auto box = std::ranges::find_if(onScreen.labels(), beginsWithReason);
            QVERIFY(box != onScreen.labels().end());
            for (const Label &label : onScreen.labels()) {
                QVERIFY2(&label == &*box || !label.box.intersects(box->box), qPrintable(label.text));
            }
        }
    }

    /// A former defect: in small pictures, the right and the upper edge cut the slider at its outer dead centre.
    void picturesContainTheSlider()
    {
        for (const Parameters &parameters : {Parameters{}, Parameters{.c = 0.0}, Parameters{.b = 300.0, .c = -10.0},
                                             Parameters{.branch = Branch::Crossed}}) {
            Session session;
            session.setParameters(parameters);
            const SliderPosition outer = *session.result()->limits.outerDeadCentre;
            MechanismView view;
            view.setResult(session.result());
            view.setPose(poseAt(parameters, outer.theta2 / parameters.omega2));
            for (const int width : {160, 230, 320, 600}) { // px
                QImage image(width, view.pictureHeight(width), QImage::Format_RGB32);
                QPainter painter(&image);
                view.paintMechanism(painter, image.size(), paletteFor(Theme::Light));
                painter.end();
                constexpr int kDarkest = 90; // the slider's line and its rail are lighter than the slider's outline
                for (int x = 0; x < image.width(); ++x) {
                    QVERIFY2(qGray(image.pixel(x, 0)) > kDarkest, qPrintable(QString::number(width)));
                }
                for (int y = 0; y < image.height(); ++y) {
                    for (const int x : {0, image.width() - 1}) {
                        QVERIFY2(qGray(image.pixel(x, y)) > kDarkest, qPrintable(QString::number(width)));
                    }
                }
            }
        }
    }

    /// A former defect: the drawing showed −173° for a coupler angle of 187° in the plots, and an angle of the crank
    /// other than the timeline's.
    void anglesAreTheNumbersOfThePlotsAndTheTimeline()
    {
        const MechanismSettings settings{.angles = true};
        const Drawn crossed({.c = -25.0, .branch = Branch::Crossed}, 0.05, settings);
        const double theta3 = sample(crossed.scene.mechanism(), std::vector{0.05}, plottedChannels(),
                                     {})[Channel{Coordinate::Theta3, Order::Position}][0];
        QVERIFY(theta3 > 180.0);
        QVERIFY(!crossed.label("θ³ = " + QString::number(theta3, 'f', 1)).isNull());

        const Drawn fast({.omega2 = -200.0 * std::numbers::pi}, 1.0 / 6.0, settings); // −6000 rpm
        QVERIFY(!fast.label("θ₂ = 120.0°").isNull()); // as in the timeline, the table and the limits: 0° … 360°
        QVERIFY(partText(fast.scene, DrawnPart::Crank).contains("θ₂ = 120.00°"));
    }

    /// A former defect: in inches and at 1024×700 the lengths ran below the button of the assembly.
    void theLengthsLeaveSpaceForTheButton()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Degree}});
        const MechanismSettings settings{.dimensions = true};
        const Drawn wide({}, 0.0, settings);
        QVERIFY(wide.label("a = 0.787402 in").contains({60.0, wide.label("a = ").center().y()}));
        QVERIFY(wide.label("b = ").isNull()); // in the same line
        const Drawn narrow({}, 0.0, settings, {320.0, 400.0});
        for (const char *length : {"a = 0.787402 in", "b = 2.55906 in", "c = 0.984252 in"}) {
            const QRectF box = narrow.label(length);
            QVERIFY2(!box.isNull() && box.right() < 0.55 * 320.0, length);
        }
        QVERIFY(narrow.label("b = ").top() >= narrow.label("a = ").bottom() - 1.0);
    }

    /// A former defect: at 764×450 the lengths lay over the slider's line and the dimension of the offset, and the
    /// angle over the letter b.
    void lowDrawingsHaveNoTextsOverEachOther()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({Symbols::Textbook, {LengthUnit::Inch, AngleUnit::Degree}});
        constexpr MechanismSettings kWithTexts{.names = true, .dimensions = true, .angles = true};
        QVERIFY(!Drawn({}, 0.0, kWithTexts, {400.0, 300.0}).label("a = ").isNull());
        for (int i = 0; i < 24; ++i) {
            const Drawn drawn({}, i / 24.0, kWithTexts, {331.0, 178.0});
            QVERIFY(drawn.label("a = ").isNull());
            MechanismSettings withArrows = kWithTexts;
            withArrows.velocity = withArrows.acceleration = true;
            QVERIFY(Drawn({}, i / 24.0, withArrows, {331.0, 178.0}).label("Scale").isNull()); // over the coupler
            QVERIFY(!Drawn({}, i / 24.0, withArrows, {400.0, 400.0}).label("Scale").isNull());
            for (const char *letter : {"a", "b", "c"}) {
                const QRectF box = drawn.label(letter);
                for (const char *angle : {"θ₂", "θ₃"}) {
                    QVERIFY2(!box.adjusted(0.0, 2.0, 0.0, -2.0).intersects(drawn.label(angle).adjusted(0, 2, 0, -2)),
                             qPrintable(QString("%1 at %2°").arg(letter).arg(15 * i)));
                }
            }
        }
    }

    /// A former defect: in a window of 800×600 the numbers of the grid lay below other texts.
    void gridNumbersKeepClearOfOtherTexts()
    {
        constexpr MechanismSettings kEverything{.velocity = true,
                                                .acceleration = true,
                                                .path = true,
                                                .names = true,
                                                .dimensions = true,
                                                .angles = true,
                                                .instantCentre = true};
        for (int i = 0; i < 10; ++i) {
            const Drawn drawn({}, i / 10.0, kEverything, {331.0, 330.0});
            for (const QString number : {"−20", "0", "20", "40"}) {
                const QRectF box = drawn.label(number);
                for (const Label &label : drawn.sketch->labels()) {
                    QVERIFY2(label.box == box || !label.box.intersects(box), qPrintable(label.text));
                }
            }
        }
    }
};

const Suite<TestMechanismLabels> suite("tst_mechanism_labels");

} // namespace tst_mechanism_labels

#include "tst_mechanism_labels.moc"
