// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What one can choose about the plots, for menus: the measure of the errors, the abscissa, measuring cursors.

#include <QList>

class QAction;

namespace slidercrank
{

class PlotGrid;

/// They change the plots and follow what is changed elsewhere.
QList<QAction *> plotChoices(PlotGrid &grid);

} // namespace slidercrank
