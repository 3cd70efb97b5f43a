// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables that replace different spellings of letters, units and numbers by one spelling.

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// A spelling, and what replaces it. Both have to outlive the table.
struct Spelling {
    std::string_view from;
    std::string_view to;
};

class Spellings
{
public:
    explicit Spellings(std::initializer_list<Spelling> table);

    /// Adds the replacement of each character of `from` by `to`.
    void addCharacters(std::string_view from, std::string_view to);

    /// Adds the replacement of each character of `from` by the one at the same position in `to`.
    void addPairs(std::string_view from, std::string_view to);

    /// Returns the text with all spellings replaced. If several match at a position, the first one in the table
    /// applies.
    std::string replacedIn(std::string_view text) const;

private:
    void add(const Spelling &spelling);

    std::array<std::vector<Spelling>, 256> m_spellings; ///< by the first byte of `from`
};

/// Returns the text with "^" and a plain character for each superscript digit or sign: "10^-^3" for "10⁻³".
std::string withCarets(std::string_view text);

} // namespace slidercrank
