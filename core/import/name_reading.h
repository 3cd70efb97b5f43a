// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the words of a column's name one after the other, and merges their meanings. name_meaning.h decides which
// quantity they denote.

#include "core/import/name_meaning.h"
#include "core/import/name_path.h"
#include "core/import/vocabulary.h"

#include <optional>
#include <string>
#include <vector>

namespace slidercrank
{

/// The words of a name that the vocabulary does not contain. They may name a point or a body, or be a remark.
struct UnknownWords {
    std::string text{};   ///< all of them, joined
    bool hasWord = false; ///< one of them has at least three bytes, so that they are not only indices
    std::string point{};  ///< a word with the number or letter of a point: "massa" in "mass_A x", "joint3"

    bool exist() const { return !text.empty() || !point.empty(); }
    bool areIndices() const { return !text.empty() && !hasWord && point.empty(); } ///< as in "x_G"
};

/// The merged meanings of the words of a name.
struct NameReading {
    std::optional<Dimension> dimension{};
    std::optional<Order> order{}; ///< of the words and symbols, without the marks that `derivatives` counts
    std::optional<Body> body{};
    char axis = ' ';
    int derivatives = 0; ///< how often the marks of derivatives differentiate: 2 in "x_ddot"
    bool hasSymbol = false;
    bool hasIndex = false;
    bool isOrderNamed = false;  ///< by a word such as "velocity"
    bool isBodyNamed = false;   ///< by a word or number, and not only by an index such as B
    bool expectsJoint = false;  ///< the last word was "joint" or the like, so that a letter names a joint
    bool isCentre = false;      ///< it names the centre of mass
    bool isFrame = false;       ///< it has the number 1, which denotes the frame if the slider is link 4
    bool isUnknownBody = false; ///< it has an index that denotes none of the three bodies
    bool isAtB = false;         ///< the angle of the coupler is measured at B: "θ3 at B"
    NameMeaning::Doubt doubt = NameMeaning::Doubt::None;
    std::string symbol{};
    std::string pointLetters{};  ///< letters or number of a point, or the ends of a link: "b", "bc", "3"
    std::string link{};          ///< number of the link whose angle it is: "3" in "θ3"
    bool isBodyNumbered = false; ///< the number in `link` names the body, and no word does

    UnknownWords unknown{};

    /// Returns whether the name states which quantity of a body it is, at least by its axis.
    bool namesQuantity() const { return order || hasSymbol || axis != ' '; }
};

/// Returns what the parts of a path say together, beginning with the last part. Returns nullopt if its words contradict
/// each other, as in "linear velocity of the crank", or if one makes it a different quantity, as in "position error".
/// Earlier parts that contradict those behind them, as the first one in "/slider_crank/slider/position", are ignored.
/// `lastWords`: the words of the last part without the marks of derivatives, which differentiate `derivatives` times.
std::optional<NameReading> readName(const NamePath &path, int derivatives, const std::vector<std::string> &lastWords);

} // namespace slidercrank
