// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "ui/plots/chart.h"
#include "ui/plots/plot_drawing.h"

#include <QImage>
#include <QPainter>
#include <QPicture>
#include <QTest>
#include <QToolTip>

using namespace slidercrank;

namespace tst_chart
{

ChartContent content()
{
    QPainterPath square;
    square.addRect(-4.0, -4.0, 8.0, 8.0);
    return {.x = {"iteration", {0.0, 4.0}},
            .y = {"residual", {1e-12, 1.0}, true},
            .series = {{.name = "rough start",
                        .points = {{0.0, 1e-1}, {1.0, 1e-2}, {2.0, 1e-4}, {3.0, 1e-8}},
                        .line = ChartSeries::Line::Solid,
                        .mark = square,
                        .tips = {"0.1", "0.01", "1e-4", "1e-8"}},
                       {.points = {{0.0, 1e-6}, {4.0, 1e-6}}, .line = ChartSeries::Line::Dashed}}};
}

QStringList textsOf(Chart &chart, const QSize &size)
{
    TextRecorder recorder(size);
    QPainter painter(&recorder);
    chart.paint(painter, size, paletteFor(Theme::Light));
    painter.end();
    QStringList texts;
    for (const auto &[text, place] : recorder.texts) {
        texts << text;
    }
    return texts;
}

class TestChart : public QObject
{
    Q_OBJECT

private slots:
    /// A former defect: in a picture of 300 dpi, curves were a hairline beside an axis of three pixels.
    void curvesAreThickerThanTheGridAtEveryResolution()
    {
        Chart chart;
        chart.setContent({.x = {"b", {0.0, 1.0}},
                          .y = {{}, {0.0, 1.0}},
                          .series = {{.points = {{0.0, 0.53}, {1.0, 0.53}}, .line = ChartSeries::Line::Solid}}});
        const QSize size(300, 200);
        const QColor colour = seriesColours(paletteFor(Theme::Light)).model;
        for (const int scale : {1, 3}) {
            QImage picture(scale * size, QImage::Format_RGB32);
            picture.fill(Qt::white);
            QPainter painter(&picture);
            painter.scale(scale, scale);
            chart.paint(painter, size, paletteFor(Theme::Light));
            painter.end();
            int height = 0;
            for (int y = 0; y < picture.height(); ++y) {
                height += picture.pixelColor(picture.width() / 2 + 5, y) == colour ? 1 : 0;
            }
            QVERIFY2(height >= 2 * scale - 1, qPrintable(QString("scale %1: %2 px").arg(scale).arg(height)));
        }
    }

    void placesPointsOnItsAxes()
    {
        Chart chart;
        chart.resize(400, 300);
        chart.setContent(content());
        const QPointF first = chart.positionOf({0, 0});
        const QPointF second = chart.positionOf({0, 1});
        const QPointF third = chart.positionOf({0, 2});
        QVERIFY(std::abs((third.x() - second.x()) - (second.x() - first.x())) < 1e-6); // linear
        QVERIFY(std::abs((third.y() - second.y()) - 2.0 * (second.y() - first.y())) < 1e-6 && second.y() > first.y());
    }

    void labelsRoundNumbersPartsOfATurnAndDecades()
    {
        struct Row {
            QCPRange range;
            const char *labels;
            std::optional<AngleUnit> angle = {};
            bool isLogarithmic = false;
        };
        for (const auto &[range, labels, angle, isLogarithmic] :
             {Row{{0.0, 50.0}, "0 10 20 30 40 50"}, Row{{0.001, 0.019}, "0.005 0.01 0.015"},
              Row{{0.9e-5, 5.1e-5}, "10⁻⁵ 2·10⁻⁵ 3·10⁻⁵ 4·10⁻⁵ 5·10⁻⁵"}, Row{{-2e9, 2e9}, "−2·10⁹ −10⁹ 0 10⁹ 2·10⁹"},
              Row{{0.0, 1.1e-4}, "0 0.5·10⁻⁴ 10⁻⁴"}, Row{{-1.2e6, 1.2e6}, "−10⁶ −0.5·10⁶ 0 0.5·10⁶ 10⁶"},
              Row{{0.0, 1.1e10}, "0 0.5·10¹⁰ 10¹⁰"}, Row{{-8e5, 8e5}, "−500000 0 500000"},
              Row{{0.0, 0.00044}, "0 0.0001 0.0002 0.0003 0.0004"},
              Row{{1000.00005, 1000.00035}, "1000.0001 1000.0002 1000.0003"},
              Row{{0.0, 360.0}, "0 90 180 270 360", AngleUnit::Degree},
              Row{{0.0, 3600.0}, "0 720 1440 2160 2880 3600", AngleUnit::Degree},
              Row{{0.0, 12.0}, "0 5 10", AngleUnit::Degree}, Row{{0.0, 6.2831853}, "0 π/2 π 3π/2", AngleUnit::Radian},
              Row{{-6.5, 0.5}, "10⁻⁶ 10⁻⁴ 10⁻² 10⁰", {}, true}}) {
            NumberTicker ticker;
            ticker.angle = angle;
            ticker.isLogarithmic = isLogarithmic;
            QVector<double> ticks;
            QVector<QString> texts;
            ticker.generate(range, QLocale(), u'g', 6, ticks, nullptr, &texts);
            QCOMPARE(QStringList(texts).join(u' '), QString::fromUtf8(labels));
        }
    }

    void atLeastTwoTicksShowTheScale()
    {
        for (const QCPRange &range : {QCPRange(41.0, 49.0), QCPRange(0.1, 195.0), QCPRange(-110.0, 110.0)}) {
            NumberTicker ticker;
            ticker.setTickCount(2);
            QVector<double> ticks;
            ticker.generate(range, QLocale(), u'g', 6, ticks, nullptr, nullptr);
            QVERIFY2(ticks.size() >= 2 && ticks.size() <= 4, qPrintable(QString::number(range.lower)));
        }
    }

    void aPointUnderThePointerSaysWhatItIs()
    {
        Chart chart;
        chart.resize(400, 300);
        chart.setContent(content());
        chart.show();
        settle();
        const QPointF place = chart.positionOf({0, 2});
        QCOMPARE(chart.pointAt(place + QPointF(3.0, 3.0)), std::optional(Chart::PointIndex{0, 2}));
        QVERIFY(!chart.pointAt(place + QPointF(15.0, 15.0)));
        QVERIFY(!chart.pointAt(chart.positionOf({1, 0}))); // has no mark
        QTest::mouseMove(&chart, place.toPoint());
        AWAIT(QToolTip::text() == "1e-4");
    }

    void aCurveFarBeyondItsAxesHasFewPieces()
    {
        Chart chart;
        chart.setContent({{"x", {0.0, 1.0}},
                          {"y", {0.0, 1.0}},
                          {{.points = {{0.0, 0.0}, {0.5, 1e10}, {1.0, 0.0}}, .line = ChartSeries::Line::Solid}}});
        QPicture picture;
        QPainter painter(&picture);
        chart.paint(painter, {400, 300}, QPalette());
        painter.end();
        constexpr uint kMaxBytes = 50'000;
        QVERIFY2(picture.size() < kMaxBytes, qPrintable(QString::number(picture.size())));
    }

    void namesItsPartsWhereThereIsRoom()
    {
        Chart chart;
        chart.setContent(content());
        const QStringList texts = textsOf(chart, {500, 300});
        for (const char *wanted : {"iteration", "residual", "rough start", "10⁻⁶"}) {
            QVERIFY2(texts.contains(QString::fromUtf8(wanted)), wanted);
        }
        QVERIFY(!textsOf(chart, {90, 60}).contains("rough start"));
    }
};

const Suite<TestChart> suite("tst_chart");

} // namespace tst_chart

#include "tst_chart.moc"
