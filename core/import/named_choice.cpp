// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/named_choice.h"

#include <charconv>
#include <cstddef>
#include <string_view>

namespace slidercrank
{

namespace
{

/// The columns that the name may mean: those with that heading, else with that heading but for the unit, else the one
/// of that number.
std::vector<std::size_t> columnsNamed(std::string_view name, std::span<const Heading> headings)
{
    std::vector<std::size_t> columns;
    for (const auto part : {&Heading::printed, &Heading::name}) {
        for (std::size_t i = 0; i < headings.size(); ++i) {
            if (headings[i].*part == name) {
                columns.push_back(i);
            }
        }
        if (!columns.empty()) {
            return columns;
        }
    }
    std::size_t number = 0;
    const char *const end = name.data() + name.size();
    const bool isNumber = name.starts_with('#') && std::from_chars(name.data() + 1, end, number).ptr == end;
    if (isNumber && number >= 1 && number <= headings.size()) {
        columns.push_back(number - 1);
    }
    return columns;
}

} // namespace

std::variant<std::vector<ColumnChoice>, ReadFault> choicesByNumber(const ReadOptions &options,
                                                                   std::span<const Heading> headings)
{
    std::vector<ColumnChoice> choices = options.columns;
    for (const NamedChoice &named : options.named) {
        const std::vector<std::size_t> columns = columnsNamed(named.heading, headings);
        if (columns.size() != 1) {
            ReadFault fault{columns.empty() ? ReadFault::Kind::NoSuchColumn : ReadFault::Kind::SeveralColumns};
            fault.heading = named.heading;
            return fault;
        }
        std::erase_if(choices, [&](const ColumnChoice &choice) { return choice.column == columns.front(); });
        choices.push_back({columns.front(), named.role, named.channel, named.unit});
    }
    return choices;
}

} // namespace slidercrank
