// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The picture of a case of the study: error against time per state, both logarithmic, a point a method and tolerance,
// the best front as a stepped line, the bound κ·u as a horizontal one. Draws with any painter at any size.

#include "core/study/study.h"
#include "ui/words/theme.h"

#include <QPointF>
#include <QSize>

#include <optional>
#include <vector>

class QPainter;

namespace slidercrank
{

/// What kind of method a row is of: one colour and one shape of point each.
enum class MethodKind { NewtonDense, NewtonStructured, ClosedForm, Approximation };
MethodKind kindOf(const MethodResult &row);

/// "dense LU, Taylor start", translated.
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
