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

constexpr double kPointsPerPixel = 0.75; // 72 / 96

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

/// Returns a null image if the size is impossible, or if there is not enough memory.
QImage drawImage(const FigureSize &size, const FigureDrawing &draw)
{
    QImage image(size.size * size.scale, QImage::Format_RGB32);
    if (image.isNull()) {
        return image;
    }
    image.setDevicePixelRatio(size.scale);
    image.fill(Qt::white);
    QPainter painter(&image);
    draw(painter, size.size);
    return image;
}

/// Corrects what Qt's generator writes: millimetres with three decimals, which viewers round up to one pixel too many,
/// and fonts without a fallback for computers on which they are missing.
QByteArray polished(const QByteArray &svg, const QSize &size)
{
    static const QRegularExpression kMillimetres(QStringLiteral(R"re(<svg width="[^"]*" height="[^"]*")re"));
    static const QRegularExpression kFamily(QStringLiteral(R"re(font-family="([^",]*)")re"));
    QString text = QString::fromUtf8(svg);
    text.replace(kMillimetres,
                 QStringLiteral(R"re(<svg width="%1" height="%2")re").arg(size.width()).arg(size.height()));
    text.replace(kFamily, QStringLiteral(R"re(font-family="'\1', sans-serif")re"));
    return text.toUtf8();
}

// All formats are drawn in memory, since neither the generator nor the writer reports a full disk.

QByteArray makeSvg(const QSize &size, const QString &title, const FigureDrawing &draw)
{
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(kDotsPerInch);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(), size));
    generator.setTitle(title);
    QPainter painter(&generator);
    draw(painter, size);
    painter.end();
    return polished(buffer.data(), size);
}

} // namespace

QByteArray makePdf(const QPageSize &page, const QString &title, const std::function<void(QPdfWriter &)> &fill)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(page);
    writer.setTitle(title);
    writer.setCreator(QCoreApplication::applicationName());
    fill(writer);
    return buffer.data();
}

std::optional<FigureFormat> figureFormat(const QString &path)
{
    const qsizetype format = QStringList{"png", "svg", "pdf"}.indexOf(QFileInfo(path).suffix().toLower());
    return format < 0 ? std::nullopt : std::optional(static_cast<FigureFormat>(format));
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

std::optional<QString> exportFigure(const QString &path, const FigureSize &size, const QString &title,
                                    const FigureDrawing &draw)
{
    const std::optional<FigureFormat> format = figureFormat(path);
    if (!format) {
        return FigureExportText::tr("%1: a figure's name must end in .png, .svg or .pdf.")
            .arg(QDir::toNativeSeparators(path));
    }
    QByteArray bytes;
    switch (*format) {
    case FigureFormat::Png: {
        QImage image = drawImage(size, draw);
        image.setText("Title", title);
        QBuffer buffer(&bytes);
        image.save(&buffer, "PNG");
        break;
    }
    case FigureFormat::Svg: bytes = makeSvg(size.size, title, draw); break;
    case FigureFormat::Pdf: {
        const QPageSize page(QSizeF(size.size) * kPointsPerPixel, QPageSize::Point, {}, QPageSize::ExactMatch);
        bytes = makePdf(page, title, [&](QPdfWriter &writer) {
            writer.setPageMargins(QMarginsF());
            QPainter painter(&writer);
            draw(painter, size.size);
        });
        break;
    }
    }
    return bytes.isEmpty() ? impossibleText(size) : writeWhole(path, bytes);
}

std::optional<QString> copyFigureToClipboard(const FigureSize &size, const FigureDrawing &draw)
{
    const QImage image = drawImage(size, draw);
    if (image.isNull()) {
        return impossibleText(size);
    }
    QGuiApplication::clipboard()->setImage(image);
    return std::nullopt;
}

} // namespace slidercrank
