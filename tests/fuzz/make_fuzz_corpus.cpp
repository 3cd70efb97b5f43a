// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the initial inputs of the fuzz targets, in one folder for each target: make_fuzz_corpus FOLDER

#include "ui/document/scene.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

using namespace slidercrank;

namespace
{

bool writeAll(const std::filesystem::path &folder, const std::vector<std::string> &texts)
{
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    int number = 0;
    bool written = !fault;
    for (const std::string &text : texts) {
        std::ofstream file(folder / std::to_string(number++), std::ios::binary);
        file << text;
        written = file.good() && written;
    }
    return written;
}

/// Returns the beginnings of the files of simulation programs, because small inputs are fuzzed most effectively.
std::vector<std::string> tables()
{
    std::vector<std::string> texts;
    for (const auto &entry :
         std::filesystem::recursive_directory_iterator(SLIDERCRANK_SOURCE_DIR "/tests/support/simulation_files")) {
        if (entry.is_regular_file()) {
            std::ifstream file(entry.path(), std::ios::binary);
            texts.push_back(std::string(std::istreambuf_iterator<char>(file), {}).substr(0, 1500));
        }
    }
    return texts;
}

std::vector<std::string> scenes()
{
    const QString path = QStringLiteral("/folder/scene.json");
    Scene scene;
    std::vector<std::string> texts{sceneToJson(scene, path).toStdString()};
    scene.reference = ReferenceSource{{QStringLiteral("/folder/reference.csv")},
                                      {{0, ColumnRole::Time, {}, "ms"},
                                       {1, ColumnRole::Channel, {Theta3, Order::Velocity}, "rad/s"},
                                       {2, ColumnRole::Ignored, {}, {}}},
                                      {}};
    scene.mechanismFrame = QRectF(-30.0, -20.0, 200.0, 100.0);
    scene.time = 0.25;
    texts.push_back(sceneToJson(scene, path).toStdString());
    return texts;
}

/// Returns command lines with one argument in each line.
std::vector<std::string> commandLines()
{
    return {"solve\n--a\n20\n--b=65\n--c\n-2.5\n--omega2\n6.28\n--theta20\n0\n--branch\ncrossed\n--steps\n10",
            "solve\n--at-angle\n30\n--method\nclosed-form\n--channels\ntheta3,R4_x_diff\n--angle-unit\nrad",
            "solve\n--max-iterations\n5\n--tolerance\n1e-8\n--tolerance-kind\nrelative\n--format\njson",
            "compare\nx.csv\ny.csv\n--fail-on-difference\n--format\ncsv\n--output\nout.csv",
            "identify\nx.csv\n--format\njson",
            "study\n--cases\nhard",
            "render\n--what\nfigure\n--output\nx.png\n--size\n1400x1800\n--scale\n2\n--theme\ndark\n--at\n0.5",
            "render\n--what\nframes\n--output\nx.gif\n--reference\nx.csv\n--duration\n2\n--start\n1",
            "scene.json\n--reference\nx.csv",
            "--help",
            "--version",
            "--reset-settings"};
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fputs("make_fuzz_corpus FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder(argv[1]);
    const bool written = writeAll(folder / "tables", tables()) && writeAll(folder / "scenes", scenes()) &&
                         writeAll(folder / "command_lines", commandLines());
    return written ? 0 : 1;
}
