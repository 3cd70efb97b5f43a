// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/spellings.h"

#include "core/import/cells.h"
#include "core/mechanism/find_element.h"

namespace slidercrank
{

namespace
{

/// Removes the first character of a text in UTF-8, and returns it.
std::string_view takeCharacter(std::string_view &text)
{
    std::size_t size = 1;
    while (size < text.size() && (byteOf(text[size]) & 0xC0U) == 0x80U) {
        ++size;
    }
    const std::string_view character = text.substr(0, size);
    text.remove_prefix(size);
    return character;
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
    while (!from.empty()) {
        add({takeCharacter(from), to});
    }
}

void Spellings::addPairs(std::string_view from, std::string_view to)
{
    while (!from.empty()) {
        add({takeCharacter(from), takeCharacter(to)});
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

std::string withCarets(std::string_view text)
{
    static const Spellings kSuperscripts{{"⁻", "^-"}, {"⁺", "^+"}, {"⁰", "^0"}, {"¹", "^1"}, {"²", "^2"}, {"³", "^3"},
                                         {"⁴", "^4"}, {"⁵", "^5"}, {"⁶", "^6"}, {"⁷", "^7"}, {"⁸", "^8"}, {"⁹", "^9"}};
    return kSuperscripts.replacedIn(text);
}

} // namespace slidercrank
