// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What there is in a window now. All of it but the message bar is made anew when the language changes: who
// outlives that asks here each time.

class QSplitter;

namespace slidercrank
{

class FoldingTabs;
class Ghost;
class MechanismView;
class MessageBar;
class ParameterPanel;
class PlotGrid;
class TablePanel;
class Timeline;

struct Rooms {
    MessageBar *messageBar = nullptr;
    QSplitter *columns = nullptr; ///< all that follows is in them
    MechanismView *mechanism = nullptr;
    Ghost *ghost = nullptr; ///< in the mechanism's view
    Timeline *timeline = nullptr;
    ParameterPanel *parameters = nullptr;
    PlotGrid *plots = nullptr;
    FoldingTabs *tabs = nullptr;
    TablePanel *errors = nullptr;
};

} // namespace slidercrank
