// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_path.h"

#include "core/import/cells.h"
#include "core/import/vocabulary.h"

#include <algorithm>
#include <array>
#include <optional>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

/// Parts of names that programs with m, rad and s give: OpenSim, MuJoCo, Gazebo and ROS.
constexpr std::array<std::string_view, 10> kNamesInSi{"_tx",           "qpos",        "qvel",       "qacc",
                                                      "_joint_pos",    "_joint_vel",  "_joint_acc", "joint_states",
                                                      "pose.position", "twist.linear"};

/// Returns whether a part of a path only says which quantity follows: "position", "linear".
bool isOfQuantity(std::string_view part)
{
    return std::ranges::all_of(wordsOf(part), [](const std::string &word) {
        const WordMeaning *const entry = findWord(word, WordUse::Word);
        return entry && !entry->body && (entry->order || isAmong(word, "linear angular"));
    });
}

/// Returns whether a text is only the symbol of a quantity: the "s" of "Displacement: s".
bool isSymbol(std::string_view text)
{
    const Words words = wordsOf(text);
    return words.size() == 1 && findWord(words[0], WordUse::Symbol);
}

/// Returns the mark between a quantity and its owner: "@", a hyphen, or a colon behind the quantity, as in
/// "slider_pos:MECHANISM" of Creo.
std::string_view markOfOwner(std::string_view name)
{
    if (name.find('@') != name.npos) {
        return "@";
    }
    const std::size_t colon = name.find(':');
    const bool isBehindQuantity = colon != name.npos && namesQuantity(wordsOf(name.substr(0, colon))) &&
                                  !namesQuantity(wordsOf(name.substr(colon + 1))) && !isSymbol(name.substr(colon + 1));
    return isBehindQuantity ? ":" : " - ";
}

/// Splits a name whose owner follows after "@", a hyphen or a colon, "Pos_TX@Slider" or "Position - Cart", or is before
/// the hyphen, "Slider - X". Returns nullopt for other names.
std::optional<NamePath> splitAtOwner(std::string_view name)
{
    const bool isOfRecurDyn = name.starts_with("Y:"); // "Y:Pos_TX-Slider"
    name.remove_prefix(isOfRecurDyn ? 2 : 0);
    const std::string_view mark = isOfRecurDyn ? "-" : markOfOwner(name);
    const std::size_t at = name.find(mark);
    if (at == name.npos || at == 0) {
        return std::nullopt;
    }
    const std::string_view before = name.substr(0, at);
    const std::string_view after = name.substr(at + mark.size()); // "Slider@Model1"
    if (mark == " - " && !namesQuantity(wordsOf(before)) && namesQuantity(wordsOf(after))) {
        return NamePath{{before, after}, std::string(before)};
    }
    return NamePath{{after.substr(0, after.find('@')), before}, std::string(after)};
}

/// Returns whether the full stop at `at` is before an index, as Mathcad writes it: "x.B", "θ.2". A part of a path, as
/// in "slider.s", is no capital letter or digit.
bool isBeforeIndex(std::string_view name, std::size_t at)
{
    const Words before = wordsOf(name.substr(0, at));
    const char last = name.back();
    return at + 2 == name.size() && (isDigit(last) || lowerCase(last) != last) && before.size() == 1 &&
           findWord(before[0], WordUse::Symbol);
}

/// Returns whether the character at `at` separates two parts of a path.
bool isSeparator(std::string_view name, std::size_t at)
{
    const bool hasBlank = name.find_first_of(" (") != name.npos; // then a full stop may end an abbreviation
    const bool isLatex = name.starts_with('\\') || name.find_first_of("{^$") != name.npos;
    const bool isBeforeName = at + 1 < name.size() && !isBlank(name[at + 1]); // "Slider Joint.Px.v"
    const bool isBehindBlank = at > 0 && isBlank(name[at - 1]);
    switch (name[at]) {
    case '/': return isBeforeName || !isBehindBlank; // "Motor current / A" has a unit
    case ':':
    case '|': return true;
    case '.': return (!hasBlank || isBeforeName) && !isBeforeIndex(name, at);
    case '\\': return !isLatex;
    case ',': return at > 1 && at + 3 < name.size() && name[at + 1] == ' '; // "Slider, X Displacement"
    default: return false;
    }
}

} // namespace

NamePath splitPath(std::string_view name)
{
    if (const std::optional<NamePath> path = splitAtOwner(name)) {
        return *path;
    }
    NamePath path;
    std::string_view owner; // of the part that begins
    std::size_t begin = 0;
    char lastSeparator = ' ';
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const bool isEnd = i == name.size();
        if (!isEnd && !isSeparator(name, i)) {
            continue;
        }
        if (i > begin) {
            path.owner = owner;
            path.parts.push_back(name.substr(begin, i - begin));
            owner = isOfQuantity(path.parts.back()) ? owner : name.substr(0, i);
        }
        begin = i + 1;
        lastSeparator = isEnd ? lastSeparator : name[i];
    }
    if (path.parts.size() > 2 && path.parts.back() == "Q") { // the value of a measure in Adams: ".model.slider_vx.Q"
        path.parts.pop_back();
    }
    path.isOfModelica = path.parts.size() > 1 && lastSeparator == '.' && name.find_first_of(" ,;:/") == name.npos &&
                        findWord('.' + std::string(path.parts.back()), WordUse::Symbol);
    path.isInSi = path.isOfModelica || (path.parts.size() > 1 && name.starts_with('/')) ||
                  std::ranges::any_of(kNamesInSi, [&](std::string_view part) { return name.find(part) != name.npos; });
    return path;
}

} // namespace slidercrank
