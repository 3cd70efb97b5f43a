// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading_row.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace slidercrank
{

namespace
{

void findPairs(std::vector<Heading> &row)
{
    for (std::size_t x = 0; x < row.size(); ++x) {
        const std::string_view name = row[x].name;
        if (!name.starts_with("X:")) {
            continue;
        }
        const auto found = std::ranges::find_if(row, [name](const Heading &each) {
            return each.name.starts_with("Y:") && name.substr(2) == std::string_view(each.name).substr(2);
        });
        if (found == row.end()) {
            continue;
        }
        found->part = Heading::Part::Ordinate;
        found->other = x;
        row[x].part = Heading::Part::Abscissa;
        row[x].other = static_cast<std::size_t>(found - row.begin());
        row[x].unit.clear(); // it is that of the values
    }
}

void findComponents(std::vector<Heading> &row)
{
    std::optional<std::size_t> magnitude;
    for (std::size_t i = 0; i < row.size(); ++i) {
        Heading &heading = row[i];
        if (heading.name != "X-comp" && heading.name != "Y-comp") {
            magnitude = meaningOf(heading).kind == NameMeaning::Kind::Quantity ? std::optional(i) : std::nullopt;
            continue;
        }
        if (!magnitude) {
            continue;
        }
        Heading &whole = row[*magnitude];
        if (whole.part == Heading::Part::Own) {
            whole.part = Heading::Part::Magnitude;
            whole.other = i;
        }
        heading.name = whole.name + (heading.name[0] == 'X' ? " x" : " y");
        heading.unit = heading.unit.empty() ? whole.unit : heading.unit;
    }
}

std::string perSecond(std::string_view unit, Order order)
{
    return std::string(unit) + (order == Order::Position ? "" : order == Order::Velocity ? "/s" : "/s2");
}

void takeUnitsOfModelica(std::vector<Heading> &row)
{
    // "a" alone leaves open of what: the others of the same joint tell.
    const auto dimensionOf = [&](const NameMeaning &meaning) {
        std::optional<Dimension> dimension = meaning.dimension;
        for (std::size_t i = 0; i < row.size() && !dimension; ++i) {
            const NameMeaning other = meaningOf(row[i]);
            if (other.isModelica && other.outputIndex == meaning.outputIndex) {
                dimension = other.dimension;
            }
        }
        return dimension;
    };
    for (Heading &heading : row) {
        const NameMeaning meaning = meaningOf(heading);
        if (!meaning.isModelica || !heading.unit.empty() || !meaning.order) {
            continue;
        }
        const std::optional<Dimension> dimension = dimensionOf(meaning);
        if (!dimension) {
            continue;
        }
        heading.unit = perSecond(dimension == Dimension::Angle ? "rad" : "m", *meaning.order);
        heading.unitOfModelica = true;
    }
}

} // namespace

void readTogether(std::vector<Heading> &row)
{
    findPairs(row);
    findComponents(row);
    takeUnitsOfModelica(row);
}

bool takeUnits(std::vector<Heading> &row, std::string_view ofLengths, std::string_view ofAngles)
{
    bool any = false;
    for (Heading &heading : row) {
        NameMeaning meaning = meaningOf(heading);
        if (meaning.kind == NameMeaning::Kind::Channel) {
            meaning.dimension = isAngle(meaning.channel.coordinate) ? Dimension::Angle : Dimension::Length;
            meaning.order = meaning.channel.order;
        }
        const std::string_view unit = meaning.dimension == Dimension::Length  ? ofLengths
                                      : meaning.dimension == Dimension::Angle ? ofAngles
                                                                              : std::string_view();
        if (heading.unit.empty() && !unit.empty() && meaning.order) {
            heading.unit = perSecond(unit, *meaning.order);
            any = true;
        }
    }
    return any;
}

} // namespace slidercrank
