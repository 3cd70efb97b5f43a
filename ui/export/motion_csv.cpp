// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/motion_csv.h"

#include "ui/document/whole_file.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace slidercrank
{

namespace
{

/// The text is handed on in pieces of this size, so that a long motion is never in memory as a whole.
constexpr qsizetype kFullBuffer = 1 << 20; // bytes

/// Receives the text piece by piece. Returns false to stop.
using TextSink = std::function<bool(const QByteArray &text)>;

/// Returns the channels in the order of indexOf().
std::vector<Channel> channelList(const ChannelSet &channels)
{
    std::vector<Channel> list;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        if (channels.test(index)) {
            list.push_back(channelAt(index));
        }
    }
    return list;
}

QByteArray csvHeader(const std::vector<Channel> &channels, const MotionCsvOptions &options)
{
    QByteArray header("time");
    for (const Channel channel : channels) {
        QString name = columnName(OutputChannel(channel), options.notation.units);
        const bool isCouplerAngle = channel == Channel{Theta3, Order::Position};
        if (isCouplerAngle && options.notation.symbols == Symbols::Textbook) {
            name.replace(columnName(OutputChannel(channel)), kCouplerAngleAtB);
        }
        header += ',' + name.toUtf8();
    }
    return header + '\n';
}

/// Writes one row per time step, with the values of each channel in its scale. Returns false if the sink stopped the
/// writing.
bool writeCsvRows(const Trajectory &trajectory, const std::vector<Channel> &channels,
                  const std::vector<ShownScale> &scales, const TextSink &sink)
{
    QByteArray text;
    text.reserve(kFullBuffer + kFullBuffer / 8);
    for (std::size_t row = 0; row < trajectory.time.size(); ++row) {
        appendNumber(text, trajectory.time[row]);
        for (std::size_t column = 0; column < channels.size(); ++column) {
            text += ',';
            appendNumber(text, scales[column].shown(trajectory[channels[column]][row]));
        }
        text += '\n';
        if (text.size() >= kFullBuffer) {
            if (!sink(text)) {
                return false;
            }
            text.resize(0); // unlike clear(), this does not free the memory
        }
    }
    return sink(text);
}

} // namespace

void appendNumber(QByteArray &text, double value)
{
    if (std::isnan(value)) {
        text.append("nan"); // never "-nan"
        return;
    }
    constexpr int kDigits = 17;
    char digits[32];
    const double unsignedZero = value == 0.0 ? 0.0 : value;
    const std::to_chars_result end =
        std::to_chars(digits, digits + sizeof digits, unsignedZero, std::chars_format::general, kDigits);
    text.append(digits, end.ptr - digits);
}

std::optional<QString> exportMotion(const QString &path, const Result &result, const MotionCsvOptions &options,
                                    std::stop_token stop, const std::function<void(double)> &progress)
{
    const Sampling &sampling = result.sampling;
    ChannelSet columns = options.channels;
    columns.set(indexOf({Coordinate::Theta2, Order::Position}));
    const std::vector<Channel> list = channelList(columns);
    WholeFile file(path);
    bool goesOn = file.open() && file.write(csvHeader(list, options));
    std::vector<ShownScale> scales;
    for (const Channel channel : list) {
        scales.push_back(shownScale(channel, result.mechanism.branch(), options.notation));
    }
    double writtenSteps = 0.0;
    const TextSink sink = [&](const QByteArray &text) { return file.write(text) && !stop.stop_requested(); };
    const auto writePiece = [&](const Trajectory &piece) {
        goesOn = writeCsvRows(piece, list, scales, sink);
        writtenSteps += static_cast<double>(piece.time.size());
        if (progress) {
            progress(writtenSteps / (sampling.steps + 1.0));
        }
        return goesOn;
    };
    if (goesOn) {
        sampleInPieces(result.mechanism, sampling, columns, result.solver, writePiece, stop);
    }
    const bool isWritten = goesOn && file.commit(stop);
    if (isWritten || stop.stop_requested()) {
        return std::nullopt;
    }
    return cannotWrite(path, file.reason());
}

} // namespace slidercrank
