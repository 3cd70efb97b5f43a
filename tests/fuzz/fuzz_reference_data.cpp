// SPDX-License-Identifier: GPL-3.0-or-later

// Reads arbitrary bytes, with arbitrary choices of columns. The result is consistent data or an error.

#include "tests/fuzz/promise.h"
#include "tests/support/reading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <variant>

using namespace slidercrank;

namespace
{

void check(const ReadError &error)
{
    require(error.fault.kind < ReadFault::Kind::Stopped, "the reason is in the bytes");
}

void check(const ReferenceData &data)
{
    require(!data.time.empty() && !data.series.empty(), "data are not empty");
    require(std::is_sorted(data.time.begin(), data.time.end(), std::less_equal<>()), "the time increases");
    ChannelSet seen;
    for (const ReferenceSeries &series : data.series) {
        require(series.values.size() == data.time.size(), "a value for each time stamp");
        require(!seen.test(indexOf(series.channel)), "each channel once");
        seen.set(indexOf(series.channel));
        require(
            std::none_of(series.values.begin(), series.values.end(), [](double value) { return std::isinf(value); }),
            "no value is infinite");
        require(!(series.rounding.stepAt(series.values.front()) < 0.0), "no step is negative");
    }
    ChannelSet named;
    int abscissas = 0;
    for (const FileColumn &column : data.layout.columns) {
        abscissas += column.role == ColumnRole::Time || column.role == ColumnRole::CrankAngle ? 1 : 0;
        if (column.role == ColumnRole::Channel) {
            named.set(indexOf(column.channel));
        }
    }
    require(abscissas == 1 && named == seen, "the columns are those of the data");
    require(!data.crank || data.crank->degrees.size() == data.time.size(), "an angle for each time stamp");
}

/// Reads the bytes, checks the data or the error, and returns the layout.
FileLayout checkedLayout(std::string_view bytes, const ReadOptions &options)
{
    const std::variant<ReferenceData, ReadError> outcome = readReferenceData(bytes, options);
    std::visit([](const auto &each) { check(each); }, outcome);
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(bytes), size);
    const FileLayout layout = checkedLayout(text, {});
    if (layout.columns.size() >= 2) {
        ReadOptions options;
        options.columns = {{layout.columns.size() - 1, ColumnRole::Time, {}, {}},
                           {0, ColumnRole::Channel, {Theta3, Order::Velocity}, "rad/s"}};
        checkedLayout(text, options);
        options.columns.front().role = ColumnRole::CrankAngle;
        checkedLayout(text, options);
    }
    return 0;
}
