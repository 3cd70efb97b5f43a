// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/spellings.h"

#include "core/mechanism/find_element.h"

namespace slidercrank
{

Spellings::Spellings(std::initializer_list<Spelling> table)
{
    for (const Spelling &spelling : table) {
        m_spellings[static_cast<unsigned char>(spelling.from[0])].push_back(spelling);
    }
}

std::string Spellings::replacedIn(std::string_view text) const
{
    std::string result;
    while (!text.empty()) {
        const Spelling *const found =
            findElement(m_spellings[static_cast<unsigned char>(text[0])],
                        [text](const Spelling &spelling) { return text.starts_with(spelling.from); });
        result += found ? found->to : text.substr(0, 1);
        text.remove_prefix(found ? found->from.size() : 1);
    }
    return result;
}

} // namespace slidercrank
