// SPDX-License-Identifier: GPL-3.0-or-later

// Makes data/inventor_sample.csv: one turn of the report's mechanism with b = 60 mm, computed with 50 digits and
// rounded as the author's Inventor file is: to six significant digits, then printed with six decimals.
//
//     make_inventor_sample                 prints the file
//     make_inventor_sample --check FILE    fails unless FILE holds exactly these bytes
//
// The formulas are the textbook's: Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15. Lengths in mm, angles in rad.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

namespace
{

using Real = boost::multiprecision::cpp_dec_float_50;

constexpr int kSteps = 200;
constexpr std::streamsize kSignificantDigits = 6;
constexpr std::streamsize kDecimals = 6;

std::string printed(const Real &value)
{
    // Where the exact value is zero, the 50 digits leave some 1e-48.
    if (abs(value) < Real("1e-40")) {
        return "0.000000";
    }
    const Real rounded(value.str(kSignificantDigits - 1, std::ios_base::scientific));
    std::string text = rounded.str(kDecimals, std::ios_base::fixed);
    if (text == "-0.000000") {
        text.erase(0, 1);
    }
    return text;
}

std::string row(int step)
{
    const Real a = 20;
    const Real b = 60;
    const Real c = 25;
    const Real pi = boost::math::constants::pi<Real>();
    const Real omega = 2 * pi;
    const Real degrees = 180 / pi;

    const Real time = Real(step) / kSteps;
    const Real crank = omega * time;
    const Real h = c - a * sin(crank);      // height of B above A
    const Real s = sqrt((b - h) * (b + h)); // b cos θ3
    const Real theta3 = asin(h / b);
    const Real theta3Dot = -a * omega * cos(crank) / s;
    const Real theta3DDot = (a * omega * omega * sin(crank) + h * theta3Dot * theta3Dot) / s;
    const Real position = a * cos(crank) + s;
    const Real velocity = -a * omega * sin(crank) - h * theta3Dot;
    const Real acceleration = -a * omega * omega * cos(crank) - s * theta3Dot * theta3Dot - h * theta3DDot;

    std::string line = printed(time);
    const Real columns[] = {
        position, velocity, acceleration, theta3 * degrees, theta3Dot * degrees, theta3DDot * degrees};
    for (const Real &value : columns) {
        line += ',' + printed(value);
    }
    return line + '\n';
}

std::string sample()
{
    std::string bytes = "\xEF\xBB\xBF" // byte order mark, as the author's file has one
                        "time,R4_x,R4_x_diff,R4_x_diff2,theta3,theta3_diff,theta3_diff2\n";
    for (int step = 0; step <= kSteps; ++step) {
        bytes += row(step);
    }
    return bytes;
}

int check(const char *path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::cerr << path << " cannot be opened\n";
        return 1;
    }
    const std::string found{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string expected = sample();
    if (found == expected) {
        return 0;
    }
    std::size_t offset = 0;
    while (offset < found.size() && offset < expected.size() && found[offset] == expected[offset]) {
        ++offset;
    }
    std::size_t line = 1;
    for (std::size_t i = 0; i < offset; ++i) {
        line += expected[i] == '\n' ? 1 : 0;
    }
    std::cerr << path << " differs from what is computed, first in line " << line << '\n';
    return 1;
}

} // namespace

int main(int argc, char **argv)
{
    if (argc == 3 && std::string_view(argv[1]) == "--check") {
        return check(argv[2]);
    }
    if (argc != 1) {
        std::cerr << "usage: make_inventor_sample [--check FILE]\n";
        return 2;
    }
    std::cout << sample();
    return 0;
}
