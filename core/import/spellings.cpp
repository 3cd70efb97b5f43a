// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/spellings.h"

#include "core/import/cells.h"
#include "core/mechanism/find_element.h"

namespace slidercrank
{

namespace
{

/// Returns the first character of a text in UTF-8.
std::string_view firstCharacter(std::string_view text)
{
    std::size_t size = 1;
    while (size < text.size() && (byteOf(text[size]) & 0xC0U) == 0x80U) {
        ++size;
    }
    return text.substr(0, size);
}

} // namespace

Spellings::Spellings(std::initializer_list<Spelling> table)
{
    for (const Spelling &spelling : table) {
        add(spelling);
    }
}

void Spellings::add(const Spelling &spelling)
{
    m_spellings[byteOf(spelling.from[0])].push_back(spelling);
}

void Spellings::addCharacters(std::string_view from, std::string_view to)
{
    const bool isEach = from.size() == to.size();
    while (!from.empty()) {
        const Spelling character{firstCharacter(from), isEach ? firstCharacter(to) : to};
        add(character);
        from.remove_prefix(character.from.size());
        to.remove_prefix(isEach ? character.to.size() : 0);
    }
}

std::string Spellings::replacedIn(std::string_view text) const
{
    std::string result;
    while (!text.empty()) {
        const Spelling *const found = findElement(
            m_spellings[byteOf(text[0])], [text](const Spelling &spelling) { return text.starts_with(spelling.from); });
        result += found ? found->to : text.substr(0, 1);
        text.remove_prefix(found ? found->from.size() : 1);
    }
    return result;
}

} // namespace slidercrank
