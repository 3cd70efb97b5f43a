// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of one motion (Table 1 with b = 60, 101 instants of one turn) as programs of the field write them, each with
// where its header was seen, and files of other kinds. The numbers come from the textbook's formulas, not from the
// core.

#include <string>
#include <vector>

namespace slidercrank
{

/// What stands in a column of a written file.
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
    Offset,   ///< c
    Speed,    ///< the magnitude of v
    ForwardV, ///< forward differences of the positions as printed, the last one repeated
    Word
};

struct WrittenColumn {
    std::string heading;
    Written content = Written::Time;
    double unit = 1.0;    ///< of the file, in mm, degrees and s
    std::string behind{}; ///< each number in a cell
    double taken = 1.0;   ///< what a reader who knows no better makes of it, as part of what it is
};

struct SimulationFile {
    std::string program;
    std::string source; ///< of the header
    std::string bytes;
    std::vector<WrittenColumn> columns;
    std::string becomes;   ///< "time[s] R4_x?[mm] -", what each column is taken for; with a question mark where guessed
    std::string refusal{}; ///< part of the sentence, where it is refused
};

/// The motion as a program writes it that exports a plot at a time.
struct SimulationPlots {
    std::string program;
    std::string source;                ///< of the headers, or of how it exports
    std::vector<SimulationFile> files; ///< `program`: the file's name
    std::string becomes;               ///< the columns of all of them, as of SimulationFile
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

/// In mm, degrees and s, at that row.
double writtenValue(Written content, int row);

inline constexpr int kWrittenRows = 101;

} // namespace slidercrank
