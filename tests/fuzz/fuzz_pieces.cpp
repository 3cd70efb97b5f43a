// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes into the reader, in pieces of any size: they read as in one piece.

#include "core/import/reference_data.h"
#include "tests/fuzz/promise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

using namespace slidercrank;

namespace
{

std::variant<ReferenceData, ReadError> readInPieces(std::string_view bytes, std::size_t piece)
{
    const auto copy = [bytes](std::size_t offset, std::span<char> room) {
        require(offset + room.size() <= bytes.size(), "nothing is asked for that there is not");
        std::ranges::copy(bytes.substr(offset, room.size()), room.begin());
        return true;
    };
    return readReferenceData(ByteSource{bytes.size(), copy, piece});
}

bool isSame(const std::vector<double> &x, const std::vector<double> &y)
{
    return std::ranges::equal(x, y, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

bool isSame(const FileLayout &x, const FileLayout &y)
{
    const auto sameColumn = [](const FileColumn &a, const FileColumn &b) {
        return a.heading == b.heading && a.unit == b.unit && a.role == b.role && a.channel == b.channel &&
               a.reason == b.reason && a.otherColumn == b.otherColumn;
    };
    return std::ranges::equal(x.columns, y.columns, sameColumn) && x.encoding == y.encoding && x.rows == y.rows &&
           x.decimalSign == y.decimalSign && x.delimiter == y.delimiter && x.headerLine == y.headerLine;
}

bool isSame(const ReferenceData &x, const ReferenceData &y)
{
    const auto sameSeries = [](const ReferenceSeries &a, const ReferenceSeries &b) {
        return a.channel == b.channel && isSame(a.values, b.values) && a.rounding == b.rounding;
    };
    const auto sameSkipped = [](const SkippedRow &a, const SkippedRow &b) {
        return a.line == b.line && a.column == b.column && a.text == b.text && a.fault == b.fault && a.rows == b.rows;
    };
    return isSame(x.time, y.time) && x.timeRounding == y.timeRounding &&
           std::ranges::equal(x.series, y.series, sameSeries) &&
           std::ranges::equal(x.skipped, y.skipped, sameSkipped) && isSame(x.layout, y.layout);
}

bool isSame(const ReadError &x, const ReadError &y)
{
    return x.line == y.line && x.column == y.column && x.text == y.text && x.fault == y.fault &&
           isSame(x.layout, y.layout);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    if (size == 0) {
        return 0;
    }
    const std::size_t piece = 1U + bytes[size - 1] % 97U; // whatever the last byte is: the fuzzer changes it
    const std::string_view text(reinterpret_cast<const char *>(bytes), size);
    const auto whole = readReferenceData(text);
    const auto inPieces = readInPieces(text, piece);
    require(whole.index() == inPieces.index(), "data both times, or a reason");
    if (const ReferenceData *data = std::get_if<ReferenceData>(&whole)) {
        require(isSame(*data, std::get<ReferenceData>(inPieces)), "the data are the same");
    } else {
        require(isSame(std::get<ReadError>(whole), std::get<ReadError>(inPieces)), "the reason is the same");
    }
    return 0;
}
