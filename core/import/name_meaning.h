// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the quantity that the name of a column denotes, by the words of vocabulary.h. A name is a path whose last part
// names the quantity; its words are read one after the other, and their meanings are merged.

#include "core/import/file_layout.h"

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>

namespace slidercrank
{

/// The quantity that a name denotes.
struct NameMeaning {
    /// The later kinds are better evidence of a channel.
    enum class Kind {
        Nothing,
        Time,
        Quantity,    ///< of an unnamed body: `channel` is the one that is usually exported
        Words,       ///< for a quantity of a body, which is a channel
        ChannelName, ///< the exact name of a channel: nameOf()
        Chosen       ///< by a person
    };

    /// A question about the name that only the other columns can decide.
    enum class Doubt {
        None,
        IsDerivative,    ///< "x_d", "xp" or "dx" may be a derivative of x
        IsPistonsIndex,  ///< "x_p" may be a derivative, or the x of the piston
        IsAngle,         ///< "α" is an angle or an angular acceleration
        IsOfPoint,       ///< "x_A", "X(3)" or "P1X" is the slider's only if the y of that point does not change
        IsOfPart,        ///< likewise "PART_4.X", but also if it is the only part, and no other column is the slider's
        IsAngleOfUnknown ///< of an unknown body: it is a channel only if it is that of the crank
    };

    Kind kind = Kind::Nothing;
    Channel channel{};
    ColumnReason reason = ColumnReason::UnknownName; ///< why a column with this name is used, or not
    std::string owner{};  ///< its point or body: "3.1" of "P[3.1]", "slider" of "slider.s", "massa" of "mass_A x"
    std::string symbol{}; ///< symbol of the quantity or its position: "psi" in "ψ̇"; empty: a word denotes it
    Doubt doubt = Doubt::None;
    bool hasUnknownWords = false;
    bool namesAxis = false;      ///< x or y, as in "vx"
    bool isNumberedLink = false; ///< the number of a link names the body, and no word: "θ3"
    bool isFirstLink = false;    ///< the name has the number 1 of a link: "θ1", "crank angle φ1"
    bool isAtB = false; ///< the angle of the coupler is measured at B; it differs from that at A by half a turn
};

/// Returns whether the name denotes a channel, and not only a quantity of an unnamed body.
constexpr bool namesChannel(const NameMeaning &meaning)
{
    return meaning.kind == NameMeaning::Kind::Words || meaning.kind == NameMeaning::Kind::ChannelName;
}

/// Orders meanings by how certain it is that the name denotes the channel: the greater is the more certain one.
std::weak_ordering compareEvidence(const NameMeaning &first, const NameMeaning &second);

/// Names with more bytes are remarks and have no meaning.
inline constexpr std::size_t kMaxNameSize = 200;

/// Returns what a name with that unit means by itself. The unit decides what the name leaves open: the order, and
/// whether it is an angle or a length.
NameMeaning meaningOf(std::string_view name, const std::string &unit);

} // namespace slidercrank
