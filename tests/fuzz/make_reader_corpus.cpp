// SPDX-License-Identifier: GPL-3.0-or-later

// Writes each of the file variants into a folder, for fuzz_reference_data to begin with: make_reader_corpus FOLDER

#include "tests/support/file_variants.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

using namespace slidercrank;

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::fputs("make_reader_corpus FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder(argv[1]);
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    int number = 0;
    const auto write = [&](const std::string &bytes) {
        std::ofstream file(folder / ("variant" + std::to_string(number++)), std::ios::binary);
        file << bytes.substr(0, 1500); // what a fuzzer changes should be small: names and a few rows
        return file.good();
    };
    bool written = !fault;
    for (const GoodFile &file : goodFiles()) {
        written = write(file.bytes) && written;
    }
    for (const BadFile &file : badFiles()) {
        written = write(file.bytes) && written;
    }
    return written ? 0 : 1;
}
