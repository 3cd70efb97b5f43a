// SPDX-License-Identifier: GPL-3.0-or-later

// The contrast of the colours, also with colour vision deficiencies. Sources: G. M. Machado, M. M. Oliveira and L. A.
// F. Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", IEEE TVCG 15 (2009), the
// matrices of severity 1; CIE 1976 L*a*b* differences; the contrast of the W3C's WCAG 2.1.

#include "tests/support/suite.h"
#include "ui/text/theme.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace slidercrank;

namespace tst_theme
{

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Matrix kNormalVision{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
constexpr Matrix kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

Triple matrixProduct(const Matrix &matrix, const Triple &vector)
{
    Triple product{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            product[i] += matrix[i][j] * vector[j];
        }
    }
    return product;
}

/// Returns the linear components of an sRGB colour.
Triple linearComponents(const QColor &colour)
{
    const auto channel = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return {channel(colour.redF()), channel(colour.greenF()), channel(colour.blueF())};
}

constexpr Matrix kToXyz{
    {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};

/// Returns L*, a*, b* (white D65) of the colour as it is seen with that colour vision.
Triple labComponents(const QColor &colour, const Matrix &vision)
{
    Triple seen = matrixProduct(vision, linearComponents(colour));
    for (double &channel : seen) {
        channel = std::clamp(channel, 0.0, 1.0);
    }
    const Triple xyz = matrixProduct(kToXyz, seen);
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const double x = f(xyz[0] / 0.95047);
    const double y = f(xyz[1]);
    const double z = f(xyz[2] / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double colourDifference(const QColor &first, const QColor &second, const Matrix &vision)
{
    const Triple a = labComponents(first, vision);
    const Triple b = labComponents(second, vision);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double contrast(const QColor &first, const QColor &second)
{
    const double a = matrixProduct(kToXyz, linearComponents(first))[1] + 0.05;
    const double b = matrixProduct(kToXyz, linearComponents(second))[1] + 0.05;
    return std::max(a, b) / std::min(a, b);
}

class TestTheme : public QObject
{
    Q_OBJECT

private slots:
    void curvesDifferWithEveryColourVision()
    {
        constexpr double kInTheSameAxes = 25.0; // ten times the smallest difference that is noticed
        constexpr double kInOneFigure = 20.0;
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            const SeriesColours colours = seriesColours(paletteFor(theme));
            enum class Axes { Motion, Errors };
            struct Curve {
                QColor colour;
                Axes axes;
            };
            const std::array<Curve, 4> curves{{{colours.model, Axes::Motion},
                                               {colours.reference, Axes::Motion},
                                               {colours.couplerError, Axes::Errors},
                                               {colours.sliderError, Axes::Errors}}};
            for (const Matrix &vision : {kNormalVision, kProtanopia, kDeuteranopia}) {
                for (std::size_t i = 0; i < curves.size(); ++i) {
                    for (std::size_t j = 0; j < i; ++j) {
                        const double difference = colourDifference(curves[i].colour, curves[j].colour, vision);
                        const double least = curves[i].axes == curves[j].axes ? kInTheSameAxes : kInOneFigure;
                        QVERIFY2(difference > least, qPrintable(QString("%1 %2: %3").arg(i).arg(j).arg(difference)));
                    }
                }
            }
        }
    }

    void curvesAndTextsHaveEnoughContrast()
    {
        constexpr double kGraphics = 3.0; // WCAG 1.4.11
        constexpr double kText = 4.5;     // WCAG 1.4.3
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            const QPalette palette = paletteFor(theme);
            const SeriesColours colours = seriesColours(palette);
            for (const QColor &curve : {colours.model, colours.reference, colours.couplerError, colours.sliderError,
                                        colours.cursor, colours.warning}) {
                QVERIFY2(contrast(curve, colours.background) > kGraphics, qPrintable(curve.name()));
            }
            // Sentences have the colour of warnings; values have the colours of errors.
            QVERIFY(contrast(colours.warning, palette.color(QPalette::Window)) > kText);
            QVERIFY(contrast(colours.couplerError, colours.background) > kText);
            QVERIFY(contrast(colours.sliderError, colours.background) > kText);
            using Roles = std::pair<QPalette::ColorRole, QPalette::ColorRole>;
            for (const auto &[text, under] :
                 {Roles{QPalette::WindowText, QPalette::Window}, Roles{QPalette::Text, QPalette::Base},
                  Roles{QPalette::Text, QPalette::AlternateBase}, Roles{QPalette::ButtonText, QPalette::Button},
                  Roles{QPalette::HighlightedText, QPalette::Highlight}, Roles{QPalette::Link, QPalette::Window},
                  Roles{QPalette::Link, QPalette::Base}, Roles{QPalette::PlaceholderText, QPalette::Base},
                  Roles{QPalette::ToolTipText, QPalette::ToolTipBase}}) {
                QVERIFY2(contrast(palette.color(text), palette.color(under)) > kText,
                         qPrintable(QString("role %1 on %2").arg(text).arg(under)));
            }
        }
    }
};

const Suite<TestTheme> suite("tst_theme");

} // namespace tst_theme

#include "tst_theme.moc"
