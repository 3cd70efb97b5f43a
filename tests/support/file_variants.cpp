// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/file_variants.h"

#include "core/sampling/trajectory.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kRows = 101;

constexpr Channel kX{R4x, Order::Position};
constexpr Channel kV{R4x, Order::Velocity};
constexpr Channel kA{R4x, Order::Acceleration};
constexpr Channel kTheta{Theta3, Order::Position};
constexpr Channel kOmega{Theta3, Order::Velocity};
constexpr Channel kAlpha{Theta3, Order::Acceleration};
constexpr Channel kCrank{Theta2, Order::Position};
constexpr Channel kCrankSpeed{Theta2, Order::Velocity};
constexpr Channel kCrankAlpha{Theta2, Order::Acceleration};

/// One column of a file to be written: without a channel, the time.
struct Written {
    std::string heading{};
    std::optional<Channel> channel{};
    double unit = 1.0;  ///< of the file, in the author's unit (of the time: in s)
    std::string text{}; ///< in every row, instead of numbers
};

struct Form {
    std::vector<Written> columns{};
    std::string before{}; ///< lines above the header
    std::string below{};  ///< lines between header and numbers
    std::string cell = ",";
    std::string rowEnd{}; ///< behind the last cell of each row
    std::string lineEnd = "\n";
    bool decimalComma = false;
    bool quoteNumbers = false;
    bool header = true;
};

const Trajectory &motion()
{
    static const Trajectory result = [] {
        Parameters parameters;
        parameters.b = 60.0;
        std::vector<double> time(kRows);
        for (std::size_t i = 0; i < kRows; ++i) {
            time[i] = static_cast<double>(i) / 100.0;
        }
        SolverSettings exact;
        exact.method = Method::ClosedForm;
        return sample(Mechanism(parameters), time, allChannels(), exact);
    }();
    return result;
}

std::string number(double value, const Form &form)
{
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.6g", value);
    std::string printed(text.data());
    for (char &c : printed) {
        c = form.decimalComma && c == '.' ? ',' : c;
    }
    return form.quoteNumbers ? '"' + printed + '"' : printed;
}

std::string written(const Form &form)
{
    std::string bytes = form.before;
    for (std::size_t i = 0; form.header && i < form.columns.size(); ++i) {
        bytes += (i == 0 ? "" : form.cell) + form.columns[i].heading;
    }
    bytes += (form.header ? form.rowEnd + form.lineEnd : "") + form.below;
    for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t i = 0; i < form.columns.size(); ++i) {
            const Written &column = form.columns[i];
            bytes += i == 0 ? "" : form.cell;
            if (!column.text.empty()) {
                bytes += column.text;
            } else if (!column.channel) {
                bytes += number(motion().time[row] / column.unit, form);
            } else {
                bytes += number(motion()[*column.channel][row] / column.unit, form);
            }
        }
        bytes += form.rowEnd + form.lineEnd;
    }
    return bytes;
}

/// In UTF-16; `text` has only characters below U+0800.
std::string utf16(const std::string &text, bool littleEndian, bool mark)
{
    std::string bytes;
    const auto put = [&](unsigned unit) {
        const char low = static_cast<char>(unit & 0xFFU);
        const char high = static_cast<char>(unit >> 8U);
        bytes += littleEndian ? low : high;
        bytes += littleEndian ? high : low;
    };
    if (mark) {
        put(0xFEFF);
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x80) {
            put(byte);
        } else {
            put((byte & 0x1FU) << 6U | (static_cast<unsigned char>(text[++i]) & 0x3FU));
        }
    }
    return bytes;
}

/// In Latin-1; `text` has only characters below U+0100.
std::string latin1(const std::string &text)
{
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned byte = static_cast<unsigned char>(text[i]);
        bytes += byte < 0x80 ? text[i]
                             : static_cast<char>((byte & 3U) << 6U | (static_cast<unsigned char>(text[++i]) & 0x3FU));
    }
    return bytes;
}

const std::vector<Written> kTwo{{"time", {}}, {"R4_x", kX}};
const std::vector<Written> kSix{{"time", {}},
                                {"R4_x", kX},
                                {"R4_x_diff", kV},
                                {"R4_x_diff2", kA},
                                {"theta3", kTheta},
                                {"theta3_diff", kOmega},
                                {"theta3_diff2", kAlpha}};
const std::vector<Written> kSpanish{{"Tiempo (s)", {}},
                                    {"Posición de la corredera (mm)", kX},
                                    {"Velocidad de la corredera (mm/s)", kV},
                                    {"Ángulo de la biela (°)", kTheta},
                                    {"Aceleración angular de la biela (°/s²)", kAlpha}};
const std::string kSpanishColumns = "time R4_x R4_x_diff theta3 theta3_diff2";
const std::string kSixColumns = "time R4_x R4_x_diff R4_x_diff2 theta3 theta3_diff theta3_diff2";

} // namespace

std::vector<GoodFile> goodFiles()
{
    const std::string plain = "UTF-8 , point line 1";
    std::vector<GoodFile> files;
    const auto add = [&](const char *name, const std::string &bytes, const std::string &columns,
                         const std::string &form) {
        files.push_back({name, bytes, columns, form});
    };

    add("the author's own form", "\xEF\xBB\xBF" + written({.columns = kSix}), kSixColumns,
        "UTF-8 with mark , point line 1");
    add("European: semicolons and decimal commas", written({.columns = kSix, .cell = ";", .decimalComma = true}),
        kSixColumns, "UTF-8 ; comma line 1");
    add("European with commas between the cells: numbers quoted",
        written({.columns = kSix, .decimalComma = true, .quoteNumbers = true}), kSixColumns, "UTF-8 , comma line 1");
    add("tabs, lines ending as in Windows", written({.columns = kSix, .cell = "\t", .lineEnd = "\r\n"}), kSixColumns,
        "UTF-8 tab point line 1");
    add("lines ending as on an old Macintosh", written({.columns = kSix, .lineEnd = "\r"}), kSixColumns, plain);
    add("a separator at the end of each line", written({.columns = kSix, .rowEnd = ","}), kSixColumns, plain);
    add("several separators at the end of each line", written({.columns = kSix, .cell = ";", .rowEnd = ";;;"}),
        kSixColumns, "UTF-8 ; point line 1");
    add("a delimiter announced by a spreadsheet",
        written({.columns = kSix, .before = "sep=;\r\n", .cell = ";", .lineEnd = "\r\n"}), kSixColumns,
        "UTF-8 ; point line 2");
    add("UTF-16, little end first, with mark", utf16(written({.columns = kSpanish}), true, true), kSpanishColumns,
        "UTF-16LE with mark , point line 1");
    add("UTF-16, big end first, with mark", utf16(written({.columns = kSpanish}), false, true), kSpanishColumns,
        "UTF-16BE with mark , point line 1");
    add("UTF-16, little end first, without mark", utf16(written({.columns = kSpanish, .cell = "\t"}), true, false),
        kSpanishColumns, "UTF-16LE tab point line 1");
    add("UTF-16, big end first, without mark", utf16(written({.columns = kSpanish, .cell = ";"}), false, false),
        kSpanishColumns, "UTF-16BE ; point line 1");
    add("Latin-1", latin1(written({.columns = kSpanish, .cell = ";", .decimalComma = true})), kSpanishColumns,
        "Windows-1252 ; comma line 1");
    add("preamble lines before the header",
        written(
            {.columns = kSix, .before = "Dynamic Simulation\nDate: 2024-05-17, 12:30\n\n# solved in 200 steps, 1 s\n"}),
        kSixColumns, "UTF-8 , point line 5");
    add("a preamble with a number alone in a line", written({.columns = kSix, .before = "200\nrun 7\n"}), kSixColumns,
        "UTF-8 , point line 3");
    add("SolidWorks Motion: a title and counted quantities",
        written({.columns = {{"Time (sec)", {}},
                             {"Linear Displacement1 (mm)", kX},
                             {"Linear Velocity2 (mm/sec)", kV},
                             {"Linear Acceleration1 (mm/sec**2)", kA},
                             {"Angular Displacement1 (deg)", kTheta},
                             {"Angular Velocity3 (deg/sec)", kOmega},
                             {"Angular Acceleration1 (deg/sec**2)", kAlpha}},
                 .before = "Plot1\n"}),
        "time R4_x? R4_x_diff? R4_x_diff2? theta3? theta3_diff? theta3_diff2?", "UTF-8 , point line 2");
    add("Simulink: a line of types and units",
        written({.columns = {{"time", {}}, {"theta3", kTheta, kDegreesPerRadian}, {"R4_x", kX, 1000.0}},
                 .below = "Type: double Unit: s,Type: double Unit: rad,Type: double Unit: m\n"}),
        "time theta3 R4_x", plain + " units 2");
    add("Simulink: lines of types, units and interpolation",
        written({.columns = {{"time", {}}, {"slider position", kX, 1000.0}, {"coupler angle", kTheta}},
                 .below = ",Type: double,Type: double\n,Unit: m,Unit: deg\n,Interp: linear,Interp: linear\n"}),
        "time R4_x theta3", plain + " units 3");
    add("a line of units in brackets",
        written({.columns = {{"time", {}, 1e-3}, {"R4_x", kX, 10.0}, {"theta3", kTheta, kDegreesPerRadian}},
                 .below = "[ms],[cm],[rad]\n"}),
        "time R4_x theta3", plain + " units 2");
    add("a line of units, one without",
        written(
            {.columns = {{"time", {}}, {"R4_x", kX}, {"step count", {}, 1.0, "1"}}, .below = "s;mm;-\n", .cell = ";"}),
        "time R4_x -", "UTF-8 ; point line 1 units 2");
    add("Spanish names", written({.columns = kSpanish}), kSpanishColumns, plain);
    add("Spanish names without a body",
        written({.columns = {{"tiempo", {}},
                             {"posición", kX},
                             {"velocidad", kV},
                             {"aceleración", kA},
                             {"ángulo", kTheta},
                             {"velocidad angular", kOmega},
                             {"aceleración angular", kAlpha}}}),
        "time R4_x? R4_x_diff? R4_x_diff2? theta3? theta3_diff? theta3_diff2?", plain);
    add("English names with their bodies",
        written({.columns = {{"Elapsed time [s]", {}},
                             {"Slider position [mm]", kX},
                             {"Piston velocity [mm/s]", kV},
                             {"Connecting rod angle [deg]", kTheta},
                             {"Coupler angular velocity [rad/s]", kOmega, kDegreesPerRadian},
                             {"Crank angle [deg]", kCrank}}}),
        "time R4_x R4_x_diff theta3 theta3_diff theta2", plain);
    add("names in camel case, units behind underscores",
        written({.columns = {{"Time_ms", {}, 1e-3},
                             {"SliderPosition_m", kX, 1000.0},
                             {"couplerAngle_rad", kTheta, kDegreesPerRadian}}}),
        "time R4_x theta3", plain);
    add("Greek letters",
        written(
            {.columns = {{"t", {}}, {"θ3 [°]", kTheta}, {"ω3 (rad/s)", kOmega, kDegreesPerRadian}, {"θ₂", kCrank}}}),
        "time theta3 theta3_diff theta2", plain);
    add("a student's letters", written({.columns = {{"t", {}}, {"x", kX}, {"v", kV}, {"a", kA}}}),
        "time R4_x? R4_x_diff? R4_x_diff2?", plain);
    add("dots for derivatives", written({.columns = {{"t", {}}, {"theta3_dot", kOmega}, {"R4x ddot", kA}}}),
        "time theta3_diff R4_x_diff2", plain);
    add("timestamp", written({.columns = {{"timestamp", {}}, {"R4_x", kX}}}), "time R4_x", plain);
    add("Zeit", written({.columns = {{"Zeit [s]", {}}, {"R4_x", kX}}, .cell = ";", .decimalComma = true}), "time R4_x",
        "UTF-8 ; comma line 1");
    add("a time under another name", written({.columns = {{"no.", {}, 1.0, "1"}, {"clock", {}}, {"R4_x", kX}}}),
        "- time? R4_x", plain);
    add("commas in quoted names",
        written({.columns = {{"\"Time ( s )\"", {}},
                             {"\"R4_x ( mm )\"", kX},
                             {"\"note, of the author\"", {}, 1.0, "\"a, b\""}}}),
        "time R4_x -", plain);
    add("Inventor's Output Grapher, with units",
        written({.columns = {{"Time ( s )", {}},
                             {"\"P[3,1] ( mm )\"", kX},
                             {"\"V[3,1] ( mm/s )\"", kV},
                             {"\"A[3,1] ( mm/s^2 )\"", kA},
                             {"\"P[2,1] ( deg )\"", kTheta},
                             {"\"V[2,1] ( deg/s )\"", kOmega}}}),
        "time R4_x? R4_x_diff? R4_x_diff2? theta3? theta3_diff?", plain);
    add("Inventor's Output Grapher, without units",
        written({.columns = {{"Time", {}},
                             {"P[3.1]", kX},
                             {"V[3.1]", kV},
                             {"A[3.1]", kA},
                             {"P[2.1]", kTheta},
                             {"V[2.1]", kOmega},
                             {"A[2.1]", kAlpha},
                             {"P[1.1]", kCrank},
                             {"V[1.1]", kCrankSpeed},
                             {"A[1.1]", kCrankAlpha}}}),
        "time R4_x? R4_x_diff? R4_x_diff2? theta3? theta3_diff? theta3_diff2? theta2? theta2_diff? theta2_diff2?",
        plain);
    add("Inventor's Output Grapher, in radians, units for the positions only",
        written(
            {.columns =
                 {{"Time", {}}, {"P[2.1] (deg)", kTheta}, {"V[2.1]", kOmega}, {"P[3.1] (mm)", kX}, {"V[3.1]", kV}}}),
        "time theta3? theta3_diff? R4_x? R4_x_diff?", plain);
    add("two lengths, one known: the other is left out",
        written({.columns = {{"time", {}}, {"R4_x", kX}, {"Linear Displacement2 (mm)", kX}}}), "time R4_x -", plain);
    add("two crank pin lengths besides an angle: only the angle",
        written({.columns = {{"time", {}},
                             {"Linear Displacement1 (mm)", kX},
                             {"Linear Displacement2 (mm)", {{R2x, Order::Position}}},
                             {"Angular Displacement1 (deg)", kTheta}}}),
        "time - - theta3?", plain);
    add("a velocity that is not that of the position",
        written({.columns = {{"time", {}}, {"R4_x", kX}, {"velocity", {{R3x, Order::Velocity}}}}}), "time R4_x -",
        plain);
    add("of two velocities, the position's",
        written({.columns =
                     {{"time", {}}, {"posición", kX}, {"velocidad 1", {{R3y, Order::Velocity}}}, {"velocidad 2", kV}}}),
        "time R4_x? - R4_x_diff?", plain);
    add("an angle that grows evenly is the crank's",
        written({.columns = {{"time", {}}, {"ángulo 1 (deg)", kCrank}, {"ángulo 2 (deg)", kTheta}}}),
        "time theta2? theta3?", plain);
    add("rpm", written({.columns = {{"time", {}}, {"theta3_diff [rpm]", kOmega, 6.0}}}), "time theta3_diff", plain);
    add("inches and feet no, microseconds yes",
        written({.columns = {{"time [us]", {}, 1e-6}, {"R4_x [in]", kX, 25.4}}}), "time R4_x", plain);
    std::string unfinished = written({.columns = kSix});
    unfinished.pop_back();
    add("no line end at the end", unfinished, kSixColumns, plain);
    return files;
}

std::vector<BadFile> badFiles()
{
    using namespace std::string_literals;
    using Kind = ReadFault::Kind;
    std::vector<BadFile> files;
    const auto add = [&](const char *name, std::string bytes, const ReadFault &fault) {
        files.push_back({name, std::move(bytes), fault});
    };
    const std::string rows = "0,1,2\n1,2,3\n2,3,4\n";
    add("nothing", "", {Kind::Empty});
    add("only a mark of UTF-16", "\xFF\xFE", {Kind::Empty});
    add("a spreadsheet", "PK\x03\x04\x14\x00\x06"s, {Kind::Spreadsheet});
    add("an old spreadsheet", "\xD0\xCF\x11\xE0\xA1\xB1"s, {Kind::Spreadsheet});
    add("a packed file", "\x1F\x8B\x08\x00"s, {Kind::Spreadsheet});
    add("a PDF", "%PDF-1.7\n1 0 obj\n", {Kind::Pdf});
    add("a web page", "<!DOCTYPE html>\n<html><body>time,R4_x</body></html>\n", {Kind::Markup});
    add("bytes that are no text", "time,R4_x\n0,1\n\0\0\1\2,3\n"s, {Kind::NotText});
    add("prose", "It was a dark and stormy night.\nThe rain fell in torrents.\n", {Kind::NoTime});
    add("numbers without names", written({.columns = kTwo, .header = false}), {Kind::NamesMissing});
    add("names that mean nothing", "time,a1b,zz\n" + rows, {Kind::NoChannel});
    add("no time", "R4_x,theta3\n3,1\n1,2\n2,3\n", {Kind::NoTime});
    add("the row's number is no time", "n,R4_x\n1,5\n2,6\n3,7\n", {Kind::NoTime});
    add("two times", "Time (s),Tiempo,R4_x\n" + rows, {Kind::TimeTwice});
    add("two columns of one name", "time,R4_x,r4x\n" + rows, {Kind::ChannelTwice, {R4x, Order::Position}});
    add("a length in degrees", "time,R4_x [deg],theta3\n" + rows, {Kind::UnknownUnit, {R4x, Order::Position}});
    add("an angle in a line of units in metres", "time,theta3,R4_x\ns,m,m\n" + rows,
        {Kind::UnknownUnit, {Theta3, Order::Position}});
    add("units that contradict each other", "time,theta3 [rad],R4_x\ns,deg,mm\n" + rows,
        {Kind::UnitsContradict, {}, "theta3 [rad]"});
    add("time in hours", "time [h],R4_x\n0,1\n1,2\n", {Kind::UnknownTimeUnit});
    add("time that goes back", "time,R4_x\n0,1\n2,2\n1,3\n", {Kind::TimeNotRising});
    add("dates for the time", "timestamp,R4_x\n2024-05-17 12:30:00,1\n2024-05-17 12:30:01,2\n", {Kind::NoRow});
    add("only names", "time;R4_x\n", {Kind::NoNumbers});
    add("decimal commas between commas", "time,R4_x\n0,000,74,5436\n0,005,74,8173\n",
        {.kind = Kind::NoRow, .row = RowFault::TooManyCells});
    add("nothing but gaps", "time,R4_x\n0,\n1,nan\n", {Kind::NoValues});
    add("two lengths that could each be the slider's",
        written({.columns = {{"time", {}},
                             {"Linear Displacement1 (mm)", kX},
                             {"Linear Displacement2 (mm)", {{R2x, Order::Position}}}}}),
        {Kind::NoCertainChannel, {}, "Linear Displacement1 (mm)", ColumnReason::LikeOther});
    add("one of Inventor's letters, and nothing beside it", written({.columns = {{"Time", {}}, {"P[3.1]", kX}}}),
        {Kind::NoCertainChannel, {}, "P[3.1]", ColumnReason::AngleOrLength});
    add("an angle in millimetres", written({.columns = {{"time", {}}, {"coupler angle (mm)", kTheta}}}),
        {Kind::NoCertainChannel, {}, "coupler angle (mm)", ColumnReason::UnknownUnit});
    return files;
}

} // namespace slidercrank
