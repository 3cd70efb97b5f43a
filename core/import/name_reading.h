// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the words of a column's name one after the other, and merges what they say. name_meaning.h decides what
// follows.

#include "core/import/name_meaning.h"
#include "core/import/name_path.h"
#include "core/import/vocabulary.h"

#include <optional>
#include <string>
#include <vector>

namespace slidercrank
{

/// The words of a name that the vocabulary does not contain. They may name a point or body, or say nothing.
struct UnknownWords {
    std::string text{};   ///< all of them, joined
    bool hasWord = false; ///< one of them has at least three letters, so that they are not only indices
    std::string point{};  ///< the word and number or letter of a point: "massa" in "mass_A x", "joint3"

    bool isAny() const { return !text.empty() || !point.empty(); }
    bool areIndices() const { return !text.empty() && !hasWord && point.empty(); } ///< as in "x_G"
};

/// What the words of a name say together.
struct NameReading {
    std::optional<Dimension> dimension{};
    std::optional<Order> order{}; ///< without `derivatives`
    std::optional<Body> body{};
    char axis = ' ';
    int derivatives = 0;
    bool hasSymbol = false;
    bool hasIndex = false;
    bool isOrderNamed = false;  ///< by a word such as "velocity"
    bool isBodyNamed = false;   ///< by a word or number, and not only by an index such as B
    bool expectsJoint = false;  ///< the word before is "joint" or "point", so that a letter names the joint
    bool isCentre = false;      ///< it names the centre of mass
    bool isFrame = false;       ///< it has the number 1, as the frame if the links are numbered from there
    bool isUnknownBody = false; ///< it has an index that denotes none of the three bodies
    bool isAtB = false;         ///< the angle of the coupler is measured at B: "θ3 at B"
    NameMeaning::Doubt doubt = NameMeaning::Doubt::None;
    std::string symbol{};
    std::string joints{};        ///< the ends of a link: "bc" in "ω_BC"
    std::string link{};          ///< number of the link whose angle it is: "3" in "θ3"
    bool isBodyNumbered = false; ///< this number names the body, and no word

    UnknownWords unknown{};

    /// Returns whether the name states which quantity of a body it is, at least by its axis.
    bool namesQuantity() const { return order || hasSymbol || axis != ' '; }
};

/// Returns what the parts of a path say together, from the last one; nullopt if it has words that contradict each
/// other, as in "linear velocity of the crank", or one that makes it another quantity, as in "position error". Parts
/// before the last one that name two bodies, as in "/slider_crank/slider/position", are ignored.
std::optional<NameReading> readName(const NamePath &path, int derivatives, const std::vector<std::string> &lastWords);

} // namespace slidercrank
