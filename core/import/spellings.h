// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables of other spellings: of letters, units and numbers.

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// Other spellings of parts of a text, and what replaces them.
class Spellings
{
public:
    /// `table`: "á=a|ñ=n|°=", from "=" to, separated by "|". It has to outlive the object.
    explicit Spellings(std::string_view table);

    /// Returns the text with all spellings replaced. Where several match, the first one in the table applies.
    std::string replacedIn(std::string_view text) const;

private:
    struct Entry {
        std::string_view from;
        std::string_view to;
    };
    std::array<std::vector<Entry>, 256> m_entries; ///< by the first byte of `from`
};

} // namespace slidercrank
