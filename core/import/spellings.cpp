// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/spellings.h"

#include "core/import/unit_text.h"

#include <algorithm>

namespace slidercrank
{

Spellings::Spellings(std::string_view table)
{
    while (!table.empty()) {
        std::string_view to = takeUntil('|', table);
        const std::string_view from = takeUntil('=', to);
        m_entries[static_cast<unsigned char>(from[0])].push_back({from, to});
    }
}

std::string Spellings::replacedIn(std::string_view text) const
{
    std::string result;
    while (!text.empty()) {
        const std::vector<Entry> &entries = m_entries[static_cast<unsigned char>(text[0])];
        const auto matches = [text](const Entry &entry) { return text.starts_with(entry.from); };
        const auto entry = std::ranges::find_if(entries, matches);
        const bool isReplaced = entry != entries.end();
        result += isReplaced ? entry->to : text.substr(0, 1);
        text.remove_prefix(isReplaced ? entry->from.size() : 1);
    }
    return result;
}

} // namespace slidercrank
