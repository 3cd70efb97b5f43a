// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The picture of a case of the study: error against time per state, both logarithmic, a mark a method and tolerance,
// the best front as a stepped line, the bound κ·u as a horizontal one, a legend where there is room for it. Draws with
// any painter at any size.

#include "core/study/study.h"
#include "ui/text/theme.h"

#include <QPointF>
#include <QSize>

#include <optional>
#include <vector>

class QPainter;

namespace slidercrank
{

/// The method's mark, in its shape and colour: hollow where it does not solve every instant.
void drawMark(QPainter &painter, const QPointF &at, const MethodResult &row, const SeriesColours &colours);

/// "closed form, batch", translated.
QString titleOf(const MethodResult &row);

/// What the point says to who hovers over it, a line each.
QString descriptionOf(const MethodResult &row);

/// The rows with a point, and where it is at that size of picture.
struct StudyPoint {
    std::size_t row = 0;
    QPointF at;
};
std::vector<StudyPoint> studyPoints(const CaseResult &which, const QSize &size);

/// From the origin, background included. `marked`: a row whose point stands out.
void drawStudy(QPainter &painter, const QSize &size, const CaseResult &which, const SeriesColours &colours,
               std::optional<std::size_t> marked = {});

} // namespace slidercrank
