// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files as programs and people write them, all of one motion (Table 1 with b = 60, 101 instants of one turn, six
// significant digits), and files that no reader should take. What tests, and the corpus of the fuzz targets, share.

#include "core/import/read_fault.h"

#include <string>
#include <vector>

namespace slidercrank
{

struct GoodFile {
    std::string name;
    std::string bytes;
    std::string columns; ///< what each becomes: "time", "R4_x", "R4_x?" when guessed, "-" when ignored
    std::string form;    ///< "UTF-8 , point line 1", with "units 2" where there is such a line
};

struct BadFile {
    std::string name;
    std::string bytes;
    ReadFault fault;
};

std::vector<GoodFile> goodFiles();
std::vector<BadFile> badFiles();

} // namespace slidercrank
