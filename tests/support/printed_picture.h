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
    constexpr QRgb kWhite = 0xffffffff; // the colour of most pixels
    const auto differs = [](int x, int y) { return std::abs(x - y) >= kTolerance; };
    return colour == kWhite || (!differs(qRed(colour), qGreen(colour)) && !differs(qGreen(colour), qBlue(colour)) &&
                                !differs(qBlue(colour), qRed(colour)));
}

/// Reads a picture in the portable pixmap format, the output of all these programs. Returns a null image on failure.
inline QImage imageIn(const QByteArray &pixmap)
{
    return QImage::fromData(pixmap, "PPM").convertToFormat(QImage::Format_RGB32);
}

/// Reads an image file. A PDF is rendered at 192 dots per inch, because poppler draws thin lines too faint at 96.
inline QImage printedPicture(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix();
    return imageIn(suffix == QLatin1String("pdf")
                       ? outputOf(QStringLiteral("pdftoppm"), {"-r", "192", "-singlefile", path})
                   : suffix == QLatin1String("svg")
                       ? outputOf(QStringLiteral("pngtopnm"), {}, outputOf(QStringLiteral("rsvg-convert"), {path}))
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

/// Returns the first and last numbers of the stretches of `length` that contain lines of at least `shortest` px.
/// isDrawn(line, i) tells whether a pixel is not white.
template <class IsDrawn>
std::vector<std::pair<int, int>> stretchesWithLines(int lines, int length, int shortest, const IsDrawn &isDrawn)
{
    std::vector<char> isCovered(static_cast<std::size_t>(length));
    for (int line = 0; line < lines; ++line) {
        for (int first = 0, i = 0; i <= length; ++i) {
            if (i == length || !isDrawn(line, i)) {
                if (i - first >= shortest) {
                    std::fill(isCovered.begin() + first, isCovered.begin() + i, 1);
                }
                first = i + 1;
            }
        }
    }
    std::vector<std::pair<int, int>> stretches;
    for (auto end = isCovered.begin(); end != isCovered.end();) {
        const auto begin = std::find(end, isCovered.end(), 1);
        end = std::find(begin, isCovered.end(), 0);
        if (begin != end) {
            stretches.emplace_back(begin - isCovered.begin(), end - isCovered.begin() - 1);
        }
    }
    return stretches;
}

/// Returns the rectangles of the plot axes, left to right and top to bottom. They are found by their grid lines, which
/// are longer than half of a plot's share of the picture. The picture has `across` rows and columns of plots.
inline std::vector<QRect> axesIn(const QImage &picture, int across)
{
    const int width = picture.width();
    const int height = picture.height();
    const auto isDrawn = [&](int x, int y) {
        const QRgb colour = picture.pixel(x, y);
        return qRed(colour) < 0xf4 || !isGrey(colour);
    };
    const auto columns =
        stretchesWithLines(height, width, width / across / 2, [&](int y, int x) { return isDrawn(x, y); });
    std::vector<QRect> axes;
    for (const auto &[top, bottom] : stretchesWithLines(width, height, height / across / 2, isDrawn)) {
        for (const auto &[left, right] : columns) {
            axes.emplace_back(QPoint(left, top), QPoint(right, bottom));
        }
    }
    return axes;
}
