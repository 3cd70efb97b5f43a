// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/export/figure_export.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/theme.h"

#include "tests/support/waiting.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QXmlStreamReader>

#include <cmath>
#include <limits>

using namespace slidercrank;

namespace
{

void drawSquare(QPainter &painter, const QSize &size)
{
    painter.fillRect(QRect(QPoint(), size), Qt::white);
    painter.fillRect(QRect(size.width() / 4, size.height() / 4, size.width() / 2, size.height() / 2), Qt::blue);
    painter.setPen(Qt::black);
    painter.drawText(QPoint(5, 20), QStringLiteral("θ³ [°]"));
}

QByteArray contents(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TstFigureExport : public QObject
{
    Q_OBJECT

private slots:
    void knowsFormatsBySuffix();
    void writesAPngOfTheExactSize();
    void scalesPngPixelsOnly();
    void writesSvgWithText();
    void writesAPdfOfTheFiguresSize();
    void keepsTheOldFileWhenTheFolderIsMissing();
    void refusesAnUnknownSuffix();
    void refusesSillySizes_data();
    void refusesSillySizes();
    void copiesAnImage();
    void keepsCurvesWithinTheirAxesInSvg();
    void drawsTheFigureOfAGridThatWasNeverShown();
    void drawsOnePlotInTheColoursAskedFor();

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }
};

void TstFigureExport::knowsFormatsBySuffix()
{
    QCOMPARE(figureFormatOf(QStringLiteral("a.png")), FigureFormat::Png);
    QCOMPARE(figureFormatOf(QStringLiteral("a.b.SVG")), FigureFormat::Svg);
    QCOMPARE(figureFormatOf(QStringLiteral("folder.png/a.Pdf")), FigureFormat::Pdf);
    QVERIFY(!figureFormatOf(QStringLiteral("png")).has_value());
    QVERIFY(!figureFormatOf(QStringLiteral("a.jpg")).has_value());
}

void TstFigureExport::writesAPngOfTheExactSize()
{
    QCOMPARE(exportFigure(path("a.png"), {QSize(321, 123)}, QStringLiteral("Square"), drawSquare), std::nullopt);
    const QImage image(path("a.png"));
    QCOMPARE(image.size(), QSize(321, 123));
    QCOMPARE(image.pixelColor(160, 61), QColor(Qt::blue));
    QCOMPARE(image.pixelColor(310, 5), QColor(Qt::white));
    QCOMPARE(image.text(QStringLiteral("Title")), QStringLiteral("Square"));
}

void TstFigureExport::scalesPngPixelsOnly()
{
    QSize drawn;
    const auto draw = [&drawn](QPainter &painter, const QSize &size) {
        drawn = size;
        drawSquare(painter, size);
    };
    QCOMPARE(exportFigure(path("a.png"), {QSize(200, 100), 2.5}, {}, draw), std::nullopt);
    QCOMPARE(drawn, QSize(200, 100));
    QCOMPARE(QImage(path("a.png")).size(), QSize(500, 250));
    QCOMPARE(exportFigure(path("a.svg"), {QSize(200, 100), 2.5}, {}, draw), std::nullopt);
    const QByteArray svg = contents(path("a.svg"));
    QVERIFY(svg.contains("viewBox=\"0 0 200 100\""));
    QVERIFY(svg.contains("width=\"200\" height=\"100\""));
}

void TstFigureExport::writesSvgWithText()
{
    QCOMPARE(exportFigure(path("a.svg"), {QSize(300, 200)}, QStringLiteral("A < B"), drawSquare), std::nullopt);
    QXmlStreamReader xml(contents(path("a.svg")));
    QString text;
    QString title;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == QLatin1String("text")) {
            text += xml.readElementText();
        } else if (xml.isStartElement() && xml.name() == QLatin1String("title")) {
            title = xml.readElementText();
        }
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QVERIFY(text.contains(QStringLiteral("θ³ [°]")));
    QCOMPARE(title, QStringLiteral("A < B"));
    QVERIFY(contents(path("a.svg")).contains("', sans-serif\""));
}

void TstFigureExport::writesAPdfOfTheFiguresSize()
{
    QCOMPARE(exportFigure(path("a.pdf"), {QSize(400, 200)}, {}, drawSquare), std::nullopt);
    const QByteArray pdf = contents(path("a.pdf"));
    QVERIFY(pdf.startsWith("%PDF"));
    QVERIFY(pdf.contains("/MediaBox [0 0 300.0")); // 3/4 point a pixel
}

void TstFigureExport::keepsTheOldFileWhenTheFolderIsMissing()
{
    for (const QString name : {"gone/a.png", "gone/a.svg", "gone/a.pdf"}) {
        const std::optional<QString> fault = exportFigure(path(name), {}, {}, drawSquare);
        QVERIFY(fault.has_value());
        QVERIFY(fault->contains(QStringLiteral("gone")));
        QVERIFY(!QFile::exists(path(name)));
    }
    QCOMPARE(exportFigure(path("old.png"), {QSize(20, 20)}, {}, drawSquare), std::nullopt);
    const QByteArray old = contents(path("old.png"));
    QVERIFY(exportFigure(path("old.png"), {QSize(0, 20)}, {}, drawSquare).has_value());
    QCOMPARE(contents(path("old.png")), old);
}

void TstFigureExport::refusesAnUnknownSuffix()
{
    QVERIFY(exportFigure(path("a.jpg"), {}, {}, drawSquare).has_value());
    QVERIFY(!QFile::exists(path("a.jpg")));
}

void TstFigureExport::refusesSillySizes_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<double>("scale");
    QTest::newRow("no width") << QSize(0, 100) << 1.0;
    QTest::newRow("negative height") << QSize(100, -1) << 1.0;
    QTest::newRow("scale of zero") << QSize(100, 100) << 0.0;
    QTest::newRow("scale not a number") << QSize(100, 100) << std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("scaled to nothing") << QSize(100, 100) << 1e-3;
    QTest::newRow("too many pixels") << QSize(20000, 20000) << 1.0;
    QTest::newRow("too many once scaled") << QSize(1400, 900) << 20.0;
    QTest::newRow("one endless row") << QSize(1000000, 1) << 1.0;
    QTest::newRow("more than an int holds") << QSize(1400, 900) << 1e9;
}

void TstFigureExport::refusesSillySizes()
{
    QFETCH(QSize, size);
    QFETCH(double, scale);
    bool isDrawn = false;
    const auto draw = [&isDrawn](QPainter &, const QSize &) { isDrawn = true; };
    const std::optional<QString> fault = exportFigure(path("silly.png"), {size, scale}, {}, draw);
    QVERIFY(fault.has_value());
    QVERIFY(fault->endsWith(u'.'));
    QVERIFY(!isDrawn);
    QVERIFY(!QFile::exists(path("silly.png")));
}

void TstFigureExport::copiesAnImage()
{
    QCOMPARE(copyFigureToClipboard({QSize(64, 48), 2.0}, drawSquare), std::nullopt);
    QCOMPARE(QApplication::clipboard()->image().size(), QSize(128, 96));
}

void TstFigureExport::keepsCurvesWithinTheirAxesInSvg()
{
    Session session;
    PlotGrid grid;
    grid.resize(900, 600);
    grid.setResult(session.result());
    grid.show();
    settle();
    auto *plot = grid.findChild<QWidget *>(QStringLiteral("plot_theta3_diff2"));
    const auto zoomAt = [plot](QPoint at) {
        QWheelEvent event(at, plot->mapToGlobal(at), QPoint(), QPoint(0, 720), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot, &event);
        settle();
    };
    zoomAt(plot->rect().center());                // t, of all
    zoomAt(QPoint(5, plot->rect().center().y())); // its values
    const QSize size(700, 600);
    const auto draw = [&grid](QPainter &painter, const QSize &s) {
        grid.paintFigure(painter, s, paletteFor(Theme::Light));
    };
    QCOMPARE(exportFigure(path("rocker.svg"), {size}, {}, draw), std::nullopt);
    const QColor model = seriesColours(paletteFor(Theme::Light)).model;
    QXmlStreamReader xml(contents(path("rocker.svg")));
    int polylines = 0;
    QString stroke;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) {
            continue;
        }
        if (xml.attributes().hasAttribute(QStringLiteral("stroke"))) {
            stroke = xml.attributes().value(QStringLiteral("stroke")).toString();
        }
        if (xml.name() != QLatin1String("polyline") || stroke != model.name()) {
            continue;
        }
        if (polylines++ == 0) {
            continue; // the legend's sample
        }
        const QStringList points =
            xml.attributes().value(QStringLiteral("points")).toString().split(u' ', Qt::SkipEmptyParts);
        for (const QString &point : points) {
            const double x = point.section(u',', 0, 0).toDouble(); // within the plot's own cell
            const double y = point.section(u',', 1, 1).toDouble();
            QVERIFY2(x > 40.0 && x < size.width() / 2.0, qPrintable(point));
            QVERIFY2(y > 10.0 && y < size.height() / 3.0, qPrintable(point));
        }
    }
    QVERIFY(!xml.hasError());
    QVERIFY(polylines > 6);
}

void TstFigureExport::drawsTheFigureOfAGridThatWasNeverShown()
{
    Session session;
    PlotGrid grid;
    grid.setResult(session.result());
    const QPalette light = paletteFor(Theme::Light);
    const QColor model = seriesColours(light).model;
    const QSize size(700, 600);
    const auto draw = [&](QPainter &painter, const QSize &s) { grid.paintFigure(painter, s, light); };
    QCOMPARE(exportFigure(path("figure.png"), {size}, {}, draw), std::nullopt);
    const QImage image(path("figure.png"));
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 2; ++column) {
            int coloured = 0;
            for (int y = 30 + row * 190; y < 30 + (row + 1) * 190; ++y) {
                for (int x = column * 233; x < (column + 1) * 233; ++x) {
                    const QColor pixel = image.pixelColor(x, y);
                    coloured += pixel.blue() - pixel.red() > 80 && pixel.blue() > model.blue() / 2 ? 1 : 0;
                }
            }
            QVERIFY2(coloured > 100, qPrintable(QStringLiteral("row %1, column %2").arg(row).arg(column)));
        }
    }
}

void TstFigureExport::drawsOnePlotInTheColoursAskedFor()
{
    Session session;
    PlotGrid grid;
    grid.setResult(session.result());
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        const QPalette palette = paletteFor(theme);
        const auto draw = [&](QPainter &painter, const QSize &s) {
            grid.paintPlot(painter, QStringLiteral("plot_R4_x_diff2"), s, palette);
        };
        QCOMPARE(exportFigure(path("plot.png"), {QSize(400, 300)}, {}, draw), std::nullopt);
        const QImage image(path("plot.png"));
        QCOMPARE(image.pixelColor(399, 299), palette.color(QPalette::Base));
        QCOMPARE(image.pixelColor(0, 0), palette.color(QPalette::Base));
    }
}

QTEST_MAIN(TstFigureExport)
#include "tst_figure_export.moc"
