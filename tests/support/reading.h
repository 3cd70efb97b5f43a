// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads one file from its bytes.

#include "core/import/reference_data.h"

namespace slidercrank
{

inline std::variant<ReferenceData, ReadError> readReferenceData(std::string_view bytes, const ReadOptions &options = {})
{
    const FileBytes file{bytes};
    return readFiles({&file, 1}, options);
}

} // namespace slidercrank
