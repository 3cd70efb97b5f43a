// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads image files with independent programs: netpbm for PNG, librsvg for SVG, poppler for PDF.

#include <QByteArray>
#include <QFileInfo>
#include <QImage>
#include <QProcess>
#include <QRect>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <utility>
#include <vector>

/// Returns the standard output of a program, or nothing if the program is missing or fails.
inline QByteArray outputOf(const QString &program, const QStringList &arguments, const QByteArray &input = {})
{
    QProcess process;
    process.start(program, arguments);
    process.write(input);
    process.closeWriteChannel();
    const bool done = process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
    return done && process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
}

inline bool isGrey(QRgb colour)
{
    constexpr int kTolerance = 12;
    const auto differs = [](int x, int y) { return std::abs(x - y) >= kTolerance; };
    return !differs(qRed(colour), qGreen(colour)) && !differs(qGreen(colour), qBlue(colour)) &&
           !differs(qBlue(colour), qRed(colour));
}

/// Reads an image that netpbm, librsvg or poppler has written. Returns a null image on failure.
inline QImage imageIn(const QByteArray &bytes)
{
    return QImage::fromData(bytes).convertToFormat(QImage::Format_RGB32);
}

/// Reads an image file. A PDF is rendered at 192 dots per inch, because poppler draws thin lines too faint at 96.
inline QImage printedPicture(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix();
    return imageIn(suffix == QLatin1String("pdf")
                       ? outputOf(QStringLiteral("pdftoppm"), {"-r", "192", "-singlefile", path})
                   : suffix == QLatin1String("svg") ? outputOf(QStringLiteral("rsvg-convert"), {path})
                                                    : outputOf(QStringLiteral("pngtopnm"), {path}));
}

/// Returns the first of the programs that is not installed, or an empty string.
inline QString missingProgram(const QStringList &programs)
{
    const auto missing = std::find_if(programs.begin(), programs.end(), [](const QString &program) {
        return QStandardPaths::findExecutable(program).isEmpty();
    });
    return missing == programs.end() ? QString() : *missing;
}

inline constexpr QRgb kWhite = 0xffffffff; // the colour of most pixels

/// Returns an image with a byte for each pixel: 0 if the pixel is white or a very light grey, otherwise 1.
inline QImage drawnPixels(const QImage &picture)
{
    QImage drawn(picture.size(), QImage::Format_Grayscale8);
    const int width = picture.width();
    for (int y = 0; y < picture.height(); ++y) {
        const auto *colours = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        uchar *bytes = drawn.scanLine(y);
        for (int x = 0; x < width; ++x) {
            const QRgb colour = colours[x];
            bytes[x] = colour != kWhite && (qRed(colour) < 0xf4 || !isGrey(colour)) ? 1 : 0;
        }
    }
    return drawn;
}

/// Returns the ranges of columns that are covered by horizontal lines of at least `shortest` px, as (first, last).
inline std::vector<std::pair<int, int>> rangesOfLines(const QImage &drawn, int shortest)
{
    std::vector<bool> isCovered(static_cast<std::size_t>(drawn.width()));
    for (int y = 0; y < drawn.height(); ++y) {
        const QByteArrayView row(drawn.constScanLine(y), drawn.width());
        for (qsizetype first = row.indexOf('\1'); first >= 0;) {
            const qsizetype next = row.indexOf('\0', first);
            const qsizetype end = next < 0 ? row.size() : next;
            if (end - first >= shortest) {
                std::fill(isCovered.begin() + first, isCovered.begin() + end, true);
            }
            first = row.indexOf('\1', end);
        }
    }
    std::vector<std::pair<int, int>> ranges;
    for (auto end = isCovered.begin(); end != isCovered.end();) {
        const auto begin = std::find(end, isCovered.end(), true);
        end = std::find(begin, isCovered.end(), false);
        if (begin != end) {
            ranges.emplace_back(begin - isCovered.begin(), end - isCovered.begin() - 1);
        }
    }
    return ranges;
}

/// Returns the rectangles of the plot axes, left to right and top to bottom. They are found by their grid lines, which
/// are longer than half of a plot's share of the picture. The picture has `across` rows and columns of plots.
inline std::vector<QRect> axesIn(const QImage &picture, int across)
{
    const QImage drawn = drawnPixels(picture);
    const QImage turned = drawn.transformed(QTransform().rotate(-90)); // its columns are the rows of the picture
    const auto columns = rangesOfLines(drawn, picture.width() / across / 2);
    std::vector<QRect> axes;
    for (const auto &[top, bottom] : rangesOfLines(turned, picture.height() / across / 2)) {
        for (const auto &[left, right] : columns) {
            axes.emplace_back(QPoint(left, top), QPoint(right, bottom));
        }
    }
    return axes;
}
