// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_export.h"

#include "ui/document/whole_file.h"
#include "ui/text/enum_table.h"
#include "ui/text/parameter_text.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QFontInfo>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPalette>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

constexpr EnumText<FigureFormat> kSuffixes[] = {
    {FigureFormat::Png, "png"}, {FigureFormat::Svg, "svg"}, {FigureFormat::Pdf, "pdf"}};
static_assert(isCompleteTable(kSuffixes, FigureFormat::Pdf));

using Problem = std::optional<QString>;

constexpr double kPointsPerPixel = kPointsPerInch / kLogicalPixelsPerInch;

struct FigureExportText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::FigureExportText)
};

QString impossibleText(const FigureSize &size)
{
    return FigureExportText::tr("A figure of %1 × %2 pixels at scale %3 is too small or too large: choose another size "
                                "or scale.")
        .arg(size.size.width())
        .arg(size.size.height())
        .arg(size.scale);
}

QFont figureFont(int pixels)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(pixels > 0 ? pixels : QFontInfo(font).pixelSize());
    return font;
}

/// The mechanism's parameters below a figure.
struct ParameterLines {
    QString text; ///< broken only between two equations: not within "rad/s"
    QRect box;
};

ParameterLines parameterLines(const QStringList &equations, const QSize &figure, const QFont &font)
{
    constexpr int kMargin = 3; // px, above and below
    const QFontMetrics metrics(font);
    const int widest = figure.width() - 2 * metrics.averageCharWidth(); // so that no letter touches an edge
    QStringList lines;
    for (const QString &equation : equations) {
        const QString longer = lines.isEmpty() ? equation : lines.last() + ", " + equation;
        if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= widest) {
            lines.last() = longer;
        } else {
            lines << equation;
        }
    }
    const int height = static_cast<int>(lines.size()) * metrics.lineSpacing() + 2 * kMargin;
    return {lines.join(",\n"), {0, figure.height() - height, figure.width(), height}};
}

/// Corrects the text of QSvgGenerator, which states millimetres with three decimals, so that viewers round up to one
/// pixel too many, and fonts without a fallback for computers on which they are missing.
QByteArray correctedSvg(const QByteArray &svg, const FigureSize &size)
{
    const double unit = size.paperPixel * (size.isInMillimetres ? kMmPerInch / kLogicalPixelsPerInch : 1.0);
    const auto side = [&](int pixels) {
        return QString::number(unit * pixels, 'g', 7) + (size.isInMillimetres ? "mm" : "");
    };
    static const QRegularExpression kSizeAttributes(QStringLiteral(R"re(<svg width="[^"]*" height="[^"]*")re"));
    static const QRegularExpression kFamily(QStringLiteral(R"re(font-family="([^",]*)")re"));
    QString text = QString::fromUtf8(svg);
    text.replace(
        kSizeAttributes,
        QStringLiteral(R"re(<svg width="%1" height="%2")re").arg(side(size.size.width()), side(size.size.height())));
    text.replace(kFamily, QStringLiteral(R"re(font-family="'\1', sans-serif")re"));
    return text.toUtf8();
}

// All formats are drawn in memory, since neither QSvgGenerator nor QPdfWriter reports a full disk.

QByteArray makeSvg(const FigureSize &figure, const QString &title, const FigureDrawing &draw)
{
    const QSize size = figure.size;
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kLogicalPixelsPerInch);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title);
    QPainter painter(&generator);
    painter.setFont(figureFont(figure.fontPixels));
    draw(painter, size);
    painter.end();
    return correctedSvg(buffer.data(), figure);
}

QByteArray makePdf(const FigureSize &figure, const QString &title, const FigureDrawing &draw)
{
    const QPageSize page(QSizeF(figure.size) * figure.paperPixel * kPointsPerPixel, QPageSize::Point, {},
                         QPageSize::ExactMatch);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    preparePdf(writer, page, title);
    QPainter painter(&writer);
    painter.scale(figure.paperPixel, figure.paperPixel);
    painter.setFont(figureFont(figure.fontPixels));
    draw(painter, figure.size);
    painter.end();
    return buffer.data();
}

QByteArray pngBytes(const QImage &image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace

void preparePdf(QPdfWriter &writer, const QPageSize &page, const QString &title)
{
    writer.setResolution(kLogicalPixelsPerInch);
    writer.setPageSize(page);
    writer.setPageMargins(QMarginsF());
    writer.setTitle(title);
    writer.setCreator(QCoreApplication::applicationName());
}

QString suffixOf(FigureFormat format)
{
    return rowOf(kSuffixes, format).text;
}

std::optional<FigureFormat> figureFormat(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    const auto suffixOfRow = [](const EnumText<FigureFormat> &row) { return QString(row.text); };
    const auto row = std::ranges::find(kSuffixes, suffix, suffixOfRow);
    return row == std::end(kSuffixes) ? std::nullopt : std::optional(row->key);
}

FigureSize figureSize(const FigureOptions &options, const FigureHeight &height)
{
    constexpr double kPrintResolution = 300.0; // dots per inch
    const bool isInMillimetres = options.unit == FigureOptions::Unit::Millimetre;
    const double width = isInMillimetres ? options.width / kMmPerInch * kLogicalPixelsPerInch : options.width;
    const double letters = options.fontSize / kPointsPerInch * kLogicalPixelsPerInch;
    // The size of a font and the width of a drawing are whole numbers of pixels. The drawing is made for rounded
    // letters, and `paperPixel` then gives both the size that was chosen.
    FigureSize size;
    size.isInMillimetres = isInMillimetres;
    size.fontPixels = std::max(1, static_cast<int>(std::lround(letters)));
    size.size.setWidth(std::max(1, static_cast<int>(std::lround(width * size.fontPixels / letters))));
    size.size.setHeight(std::max(1, height(size.size.width(), figureFont(size.fontPixels))));
    size.paperPixel = width / size.size.width();
    size.scale = size.paperPixel * (isInMillimetres ? kPrintResolution / kLogicalPixelsPerInch : 1.0);
    return size;
}

FigureDrawing withParameters(const FigureDrawing &draw, const Mechanism &mechanism, const QPalette &palette)
{
    return [draw, palette, equations = equationTexts(mechanism.parameters())](QPainter &painter, const QSize &size) {
        const QFont font = painter.font();
        const auto [text, box] = parameterLines(equations, size, font);
        const QColor background = palette.color(QPalette::Base);
        // The whole figure, because a line would be seen between two rectangles that a viewer scales and smooths.
        painter.fillRect(QRect(QPoint(), size), background);
        painter.save();
        draw(painter, {size.width(), std::max(1, box.top())});
        painter.restore();
        painter.fillRect(box, background);
        painter.setFont(font);
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(box, Qt::AlignCenter, text);
    };
}

FigureHeight withParameters(const FigureHeight &height, const Mechanism &mechanism)
{
    return [height, equations = equationTexts(mechanism.parameters())](int width, const QFont &font) {
        const int drawing = height(width, font);
        return drawing + parameterLines(equations, {width, drawing}, font).box.height();
    };
}

QImage figureImage(const FigureSize &size, const FigureDrawing &draw)
{
    const QSizeF pixels = QSizeF(size.size) * size.scale;
    QImage image(pixels.toSize(), QImage::Format_RGB32); // rounded
    if (image.isNull()) {
        return image;
    }
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(size.scale, size.scale); // a device pixel ratio below 1 has no effect
    painter.setFont(figureFont(size.fontPixels));
    draw(painter, size.size);
    painter.end();
    if (size.isInMillimetres) { // after drawing, since the resolution would scale a QPicture
        const int dotsPerMetre =
            static_cast<int>(std::lround(size.scale / size.paperPixel * kLogicalPixelsPerInch * 1000.0 / kMmPerInch));
        image.setDotsPerMeterX(dotsPerMetre);
        image.setDotsPerMeterY(dotsPerMetre);
    }
    return image;
}

FigureWriter drawFigure(const QString &path, const FigureSize &size, const QString &title, const FigureDrawing &draw)
{
    const auto write = [path, size](const QByteArray &bytes, const std::stop_token &stop) {
        const Problem problem = bytes.isEmpty() ? impossibleText(size) : Problem();
        return problem || stop.stop_requested() ? problem : writeWhole(path, bytes);
    };
    const std::optional<FigureFormat> format = figureFormat(path);
    if (!format) {
        const QString problem = FigureExportText::tr("%1: a figure's name must end in .png, .svg or .pdf.")
                                    .arg(QDir::toNativeSeparators(path));
        return [problem](const std::stop_token &) { return problem; };
    }
    QByteArray bytes;
    switch (*format) {
    case FigureFormat::Png: {
        QImage image = figureImage(size, draw);
        image.setText("Title", title);
        return [write, image](const std::stop_token &stop) { return write(pngBytes(image), stop); };
    }
    case FigureFormat::Svg: bytes = makeSvg(size, title, draw); break;
    case FigureFormat::Pdf: bytes = makePdf(size, title, draw); break;
    }
    return [write, bytes](const std::stop_token &stop) { return write(bytes, stop); };
}

std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw)
{
    return drawFigure(path, size, title, draw)({});
}

std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw)
{
    const QImage image = figureImage(size, draw);
    if (image.isNull()) {
        return impossibleText(size);
    }
    QGuiApplication::clipboard()->setImage(image);
    return std::nullopt;
}

} // namespace slidercrank
