// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_export.h"

#include "ui/document/whole_file.h"
#include "ui/text/finding_text.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHash>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPalette>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kPointsPerPixel = 0.75;   // 72 / 96
constexpr double kLargestPixelCount = 2e8; // 800 MB as an image
constexpr int kLargestSide = 30000;        // QPainter's raster engine stops at 32767

struct FigureExportText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::FigureExportText)
};

QSize devicePixels(const FigureSize &size)
{
    return {static_cast<int>(std::lround(size.size.width() * size.scale)),
            static_cast<int>(std::lround(size.size.height() * size.scale))};
}

std::optional<QString> findFault(const FigureSize &size)
{
    if (!std::isfinite(size.scale) || size.scale <= 0.0) {
        return FigureExportText::tr("The scale of a figure must be greater than 0.");
    }
    const QSizeF pixels = QSizeF(size.size) * size.scale;
    const auto isPossible = [](double side) { return side >= 1.0 && side <= kLargestSide; };
    const bool fits = isPossible(pixels.width()) && isPossible(pixels.height()) && isPossible(size.size.width()) &&
                      isPossible(size.size.height()) && pixels.width() * pixels.height() <= kLargestPixelCount;
    return fits ? std::nullopt
                : std::optional(FigureExportText::tr("A figure of %1 × %2 pixels is too small or too large: choose "
                                                     "another size or scale.")
                                    .arg(pixels.width(), 0, 'f', 0)
                                    .arg(pixels.height(), 0, 'f', 0));
}

/// Returns a null image if there is not enough memory.
QImage imageOf(const FigureSize &size, const FigureDrawing &draw)
{
    QImage image(devicePixels(size), QImage::Format_RGB32);
    if (image.isNull()) {
        return image;
    }
    image.setDevicePixelRatio(size.scale);
    image.fill(Qt::white);
    QPainter painter(&image);
    draw(painter, size.size);
    return image;
}

/// Corrects what Qt's generator writes: millimetres with three decimals, which viewers round up to one pixel too many;
/// fonts without a fallback for computers on which they are missing; and a title that some versions of Qt escape.
QByteArray polished(const QByteArray &svg, const QSize &size, const QString &title)
{
    static const QRegularExpression kMillimetres(QStringLiteral(R"re(<svg width="[^"]*" height="[^"]*")re"));
    static const QRegularExpression kFamily(QStringLiteral(R"re(font-family="([^",]*)")re"));
    static const QString kTitle = QStringLiteral("<title>title</title>");
    QString text = QString::fromUtf8(svg);
    text.replace(kMillimetres,
                 QStringLiteral(R"re(<svg width="%1" height="%2")re").arg(size.width()).arg(size.height()));
    text.replace(kFamily, QStringLiteral(R"re(font-family="'\1', sans-serif")re"));
    text.replace(kTitle, QStringLiteral("<title>%1</title>").arg(title.toHtmlEscaped()));
    return text.toUtf8();
}

// All formats are drawn in memory, since neither the generator nor the writer reports a full disk.

QByteArray svgOf(const QSize &size, const QString &title, const FigureDrawing &draw)
{
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kDotsPerInch);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title.isEmpty() ? title : QStringLiteral("title"));
    QPainter painter(&generator);
    draw(painter, size);
    painter.end();
    return polished(buffer.data(), size, title);
}

QByteArray pdfOf(const QSize &size, const QString &title, const FigureDrawing &draw)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QSizeF(size) * kPointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(title);
    writer.setCreator(QCoreApplication::applicationName());
    QPainter painter(&writer);
    draw(painter, size);
    painter.end();
    return buffer.data();
}

} // namespace

std::optional<FigureFormat> figureFormatOf(const QString &path)
{
    static const QHash<QString, FigureFormat> kFormats{
        {"png", FigureFormat::Png}, {"svg", FigureFormat::Svg}, {"pdf", FigureFormat::Pdf}};
    const auto format = kFormats.constFind(QFileInfo(path).suffix().toLower());
    return format == kFormats.constEnd() ? std::nullopt : std::optional(*format);
}

FigureDrawing withParameters(const FigureDrawing &draw, const Mechanism &mechanism, const QPalette &palette)
{
    constexpr int kLine = 22; // px
    return [draw, palette, text = mechanismText(mechanism)](QPainter &painter, const QSize &size) {
        painter.save();
        draw(painter, {size.width(), std::max(1, size.height() - kLine)});
        painter.restore();
        const QRect line(0, size.height() - kLine, size.width(), kLine);
        painter.fillRect(line, palette.color(QPalette::Base));
        QFont font = QGuiApplication::font();
        font.setPixelSize(12);
        painter.setFont(font);
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(line, Qt::AlignCenter, text);
    };
}

QByteArray pngOf(const QImage &image)
{
    QBuffer buffer;
    return image.save(&buffer, "PNG") ? buffer.data() : QByteArray();
}

std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw)
{
    const QString shown = QDir::toNativeSeparators(path);
    const std::optional<FigureFormat> format = figureFormatOf(path);
    if (!format) {
        return FigureExportText::tr("%1: a figure's name must end in .png, .svg or .pdf.").arg(shown);
    }
    const FigureSize wanted = *format == FigureFormat::Png ? size : FigureSize{size.size, 1.0};
    if (std::optional<QString> fault = findFault(wanted)) {
        return fault;
    }
    QByteArray bytes;
    switch (*format) {
    case FigureFormat::Png: {
        QImage image = imageOf(wanted, draw);
        image.setText(QStringLiteral("Title"), title);
        bytes = pngOf(image);
        break;
    }
    case FigureFormat::Svg: bytes = svgOf(wanted.size, title, draw); break;
    case FigureFormat::Pdf: bytes = pdfOf(wanted.size, title, draw); break;
    }
    if (bytes.isEmpty()) {
        return FigureExportText::tr("There is not enough memory for a figure of that size.");
    }
    const std::optional<QString> reason = writeWhole(path, bytes);
    return reason ? std::optional(FigureExportText::tr("%1 cannot be written: %2.").arg(shown, *reason)) : std::nullopt;
}

std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw)
{
    if (std::optional<QString> fault = findFault(size)) {
        return fault;
    }
    const QImage image = imageOf(size, draw);
    if (image.isNull()) {
        return FigureExportText::tr("There is not enough memory for a figure of that size.");
    }
    QGuiApplication::clipboard()->setImage(image);
    return std::nullopt;
}

} // namespace slidercrank
