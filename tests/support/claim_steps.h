// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The vocabulary of claim_kinds.txt: steps, which build a file, and changes of columns.

#include "tests/support/claim_file.h"

#include <deque>
#include <map>

namespace slidercrank
{

/// A file and the arguments of the current step, which are read one after the other.
struct ClaimBuilder : ClaimFile {
    using ClaimFile::ClaimFile;

    std::deque<std::string> arguments{};

    std::string word();   ///< empty if there is none
    std::string choice(); ///< one of the words that are separated by '|'; "0" if there is none
    double number();
    int whole();
    Channels channels();
};

using Step = void (*)(ClaimBuilder &f);
using Change = void (*)(ClaimBuilder &f, ClaimColumn &column);

extern const std::map<std::string, Step> kSteps;
extern const std::map<std::string, Step> kMotionSteps;
extern const std::map<std::string, Change> kChanges;

} // namespace slidercrank
