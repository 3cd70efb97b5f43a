// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads image files with independent programs: netpbm for PNG, librsvg for SVG, poppler for PDF.

#include <QByteArray>
#include <QFileInfo>
#include <QProcess>
#include <QRect>
#include <QSize>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

struct PrintedPicture {
    QSize size;
    QByteArray rgb; ///< three bytes per pixel, row by row

    struct Colour {
        int red, green, blue;
        bool isGrey() const { return std::max({red, green, blue}) - std::min({red, green, blue}) < 12; }
    };

    Colour at(int x, int y) const
    {
        const char *const pixel = rgb.constData() + 3 * (static_cast<qsizetype>(y) * size.width() + x);
        const auto part = [&](int i) { return static_cast<int>(static_cast<unsigned char>(pixel[i])); };
        return {part(0), part(1), part(2)};
    }

    bool isBlank() const
    {
        for (qsizetype i = 3; i < rgb.size(); ++i) {
            if (rgb[i] != rgb[i % 3]) {
                return false;
            }
        }
        return true;
    }
};

/// Parses a binary PPM with 8 bits per colour, the output format of all these programs. Returns an empty size on
/// failure.
inline PrintedPicture pictureInPpm(const QByteArray &ppm)
{
    PrintedPicture picture;
    const QByteArrayList words = ppm.left(60).simplified().split(' '); // none of the programs writes comments
    if (words.size() < 4 || words[0] != "P6" || words[3].left(3) != "255") {
        return picture;
    }
    const QSize size(words[1].toInt(), words[2].toInt());
    const qsizetype bytes = qsizetype{3} * size.width() * size.height();
    if (bytes > 0 && ppm.size() > bytes) {
        picture.size = size;
        picture.rgb = ppm.last(bytes);
    }
    return picture;
}

/// Reads an image file. A PDF is rendered at 192 dots per inch, because poppler draws thin lines too faint at 96.
inline PrintedPicture printedPicture(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix();
    if (suffix == QLatin1String("pdf")) {
        return pictureInPpm(outputOf(QStringLiteral("pdftoppm"), {"-r", "192", "-singlefile", path}));
    }
    if (suffix == QLatin1String("svg")) {
        const QByteArray png = outputOf(QStringLiteral("rsvg-convert"), {path});
        return pictureInPpm(outputOf(QStringLiteral("pngtopnm"), {}, png));
    }
    return pictureInPpm(outputOf(QStringLiteral("pngtopnm"), {path}));
}

/// Returns the first of the programs that is not installed, or an empty string.
inline QString missingProgram(const QStringList &programs)
{
    const auto missing = std::find_if(programs.begin(), programs.end(), [](const QString &program) {
        return QStandardPaths::findExecutable(program).isEmpty();
    });
    return missing == programs.end() ? QString() : *missing;
}

/// Returns the rectangles of the plot axes, left to right and top to bottom. They are found by their grid lines, which
/// are grey on white and longer than half of a plot's share of the picture. The picture has `across` rows and columns
/// of plots.
inline std::vector<QRect> axesIn(const PrintedPicture &picture, int across)
{
    struct Run {
        int first, last;
    };
    const auto isGrey = [&](int x, int y) {
        const PrintedPicture::Colour colour = picture.at(x, y);
        return colour.isGrey() && colour.red < 0xf4;
    };
    // Finds the grey lines in one direction. Curves that cross a line interrupt it; grey runs within text are short.
    const auto runs = [across](int lines, int length, const auto &isGreyAt) {
        const int shortest = length / across / 2;
        constexpr int kLettering = 10; // px
        constexpr int kCrossing = 24;  // px
        std::vector<Run> found;
        const auto add = [&](const Run &run) {
            const auto known = std::find_if(found.begin(), found.end(), [&](const Run &other) {
                return run.first <= other.last && other.first <= run.last;
            });
            if (run.last - run.first < shortest) {
                return;
            }
            if (known == found.end()) {
                found.push_back(run);
            } else {
                *known = {std::min(known->first, run.first), std::max(known->last, run.last)};
            }
        };
        for (int line = 0; line < lines; ++line) {
            Run run{0, 0};
            for (int i = 0; i < length; ++i) {
                const int first = i;
                while (i < length && isGreyAt(line, i)) {
                    ++i;
                }
                if (i - first < kLettering) {
                    continue;
                }
                if (first - run.last > kCrossing) {
                    add(run);
                    run.first = first;
                }
                run.last = i - 1;
            }
            add(run);
        }
        std::sort(found.begin(), found.end(), [](const Run &one, const Run &other) { return one.first < other.first; });
        return found;
    };
    const int width = picture.size.width();
    const int height = picture.size.height();
    const std::vector<Run> columns = runs(height, width, [&](int y, int x) { return isGrey(x, y); });
    const std::vector<Run> rows = runs(width, height, [&](int x, int y) { return isGrey(x, y); });
    std::vector<QRect> axes;
    for (const Run &row : rows) {
        for (const Run &column : columns) {
            axes.emplace_back(QPoint(column.first, row.first), QPoint(column.last, row.last));
        }
    }
    return axes;
}
