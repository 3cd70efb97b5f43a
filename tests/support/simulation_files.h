// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of one motion (Table 1 with b = 60, 101 time stamps of one turn) in the formats of simulation programs, with
// the source of their headings, and files that contain no motion. The numbers are computed with the textbook's
// formulas, not with the core.

#include <string>
#include <vector>

namespace slidercrank
{

/// The content of a column.
enum class Written {
    Time,
    RowNumber,
    X,
    V,
    A,
    Theta3,
    Omega3,
    Alpha3,
    Theta2,
    Omega2,
    Zero,
    Offset, ///< c
    Speed,  ///< magnitude of v
    Word
};

struct WrittenColumn {
    std::string heading;
    Written content = Written::Time;
    double unit = 1.0;       ///< unit of the column, in mm, degrees and s
    std::string suffix{};    ///< text after each number
    double readFactor = 1.0; ///< factor of the values that are read, if the file does not state the unit
};

struct SimulationFile {
    std::string program;
    std::string source; ///< of the headings
    std::string bytes;
    std::vector<WrittenColumn> columns;
    std::string becomes; ///< expected role and unit of each column, "time[s] R4_x?[mm] -"; a guess has a question mark
    std::string refusal{}; ///< part of the error message, if the file is rejected
};

/// The files of a program that exports one plot at a time.
struct SimulationPlots {
    std::string program;
    std::string source;                ///< where the headings or the export are documented
    std::vector<SimulationFile> files; ///< `program` is the name of the file
    std::string becomes;               ///< like SimulationFile::becomes, for the columns of all files
    std::string refusal{};
};

struct OtherFile {
    std::string name;
    std::string bytes;
    std::string refusal; ///< part of the sentence
};

std::vector<SimulationFile> simulationFiles();
std::vector<SimulationPlots> simulationPlots();
std::vector<OtherFile> otherFiles();

/// Returns the value of a column in a row, in mm, degrees and s.
double writtenValue(Written content, int row);

inline constexpr int kWrittenRows = 101;

} // namespace slidercrank
