// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The space within and between the panels, in px, so that their edges are in line.

#include <QMargins>

namespace slidercrank
{

/// Around a panel of controls, below the mechanism.
inline constexpr QMargins kControlMargins{6, 4, 6, 4};

/// Around a panel in a tab. Below it is the edge of the window, which has a margin of its own.
inline constexpr QMargins kTabMargins{6, 4, 6, 2};

/// Around the list of pages of a tab and the page beside it.
inline constexpr QMargins kPagesMargins{4, 4, 4, 2};

/// Around a page beside such a list, which separates it from the list.
inline constexpr QMargins kPageMargins{4, 0, 0, 0};

inline constexpr int kRowSpacing = 3;     ///< between the lines of a panel
inline constexpr int kFormSpacing = 4;    ///< between the rows of a form, and between a box and its label
inline constexpr int kDenseSpacing = 2;   ///< between items that belong together: buttons, charts, findings
inline constexpr int kColumnSpacing = 12; ///< between a chart and a table

} // namespace slidercrank
