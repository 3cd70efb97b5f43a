// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The views of a window.

class QSplitter;

namespace slidercrank
{

class FoldingTabs;
class Ghost;
class MechanismView;
class MotionTablePanel;
class ParameterPanel;
class PlotGrid;
class TablePanel;
class Timeline;

struct Views {
    QSplitter *columns = nullptr; ///< contains all other views
    MechanismView *mechanism = nullptr;
    Ghost *ghost = nullptr; ///< drawn in the mechanism view
    Timeline *timeline = nullptr;
    ParameterPanel *parameters = nullptr;
    PlotGrid *plots = nullptr;
    FoldingTabs *tabs = nullptr;
    TablePanel *errors = nullptr;
    MotionTablePanel *table = nullptr;
};

} // namespace slidercrank
