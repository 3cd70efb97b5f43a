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
constexpr std::array<std::string_view, 11> kNamesInSi{"_tx",           "qpos",         "qvel",       "qacc",
                                                      "_joint_pos",    "_joint_vel",   "_joint_acc", "joint_states",
                                                      "pose.position", "twist.linear", "field."};

/// Returns whether a part of a path only says which quantity follows: "position", "linear".
bool isOfQuantity(std::string_view part)
{
    return std::ranges::all_of(wordsOf(part), [](const std::string &word) {
        const WordMeaning *const entry = findWord(word, WordUse::Word);
        return entry && !entry->body && (entry->order || isAmong(word, "linear angular"));
    });
}

/// Returns whether a part of a path names a quantity, by a word or by nothing but its symbol: the "s" of
/// "Displacement: s".
bool mayBeQuantity(std::string_view part)
{
    const Words words = wordsOf(part);
    return namesQuantity(words) || (words.size() == 1 && findWord(words[0], WordUse::Symbol));
}

/// Returns whether the full stop at `at` is before an index, as Mathcad writes it: "x.B", "θ.2". An index is a capital
/// letter or a digit, unlike the part of a path in "slider.s".
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
    case '@': // "Pos_TX@Slider"
    case '|': return true;
    case '-': return isBehindBlank && !isBeforeName; // "Position - Cart"
    case '.': return (!hasBlank || isBeforeName) && !isBeforeIndex(name, at);
    case '\\': return !isLatex;
    case ',': return at > 1 && at + 3 < name.size() && name[at + 1] == ' '; // "Slider, X Displacement"
    default: return false;
    }
}

/// Moves the part that names the time, or else the last one that names a quantity, behind its owner: "Pos_TX@Slider",
/// "Time - Position".
void moveQuantityToEnd(std::vector<std::string_view> &parts)
{
    const auto isTimeItself = [](std::string_view part) { return isTime(wordsOf(part)); };
    const auto time = std::find_if(parts.rbegin(), parts.rend(), isTimeItself);
    const auto quantity = time != parts.rend() ? time : std::find_if(parts.rbegin(), parts.rend(), mayBeQuantity);
    if (quantity != parts.rend()) {
        std::rotate(quantity.base() - 1, quantity.base(), parts.end());
    }
}

} // namespace

NamePath splitPath(std::string_view name)
{
    NamePath path;
    name.remove_prefix(name.starts_with("Y:") ? 2 : 0);        // RecurDyn's mark of values
    name = name.substr(0, name.find('@', name.find('@') + 1)); // "Pos_TX@Slider@Model1" without the model
    std::size_t begin = 0;
    char lastSeparator = ' ';
    for (std::size_t i = 0; i <= name.size(); ++i) {
        const bool isEnd = i == name.size();
        if (!isEnd && !isSeparator(name, i)) {
            continue;
        }
        if (i > begin) {
            path.parts.push_back(trimmed(name.substr(begin, i - begin)));
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
    if (!path.isOfModelica) {
        moveQuantityToEnd(path.parts);
    }
    for (std::size_t i = 0; i + 1 < path.parts.size(); ++i) {
        path.owner += isOfQuantity(path.parts[i]) ? "" : '/' + std::string(path.parts[i]);
    }
    return path;
}

} // namespace slidercrank
