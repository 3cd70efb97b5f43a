// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_cursor.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kInsideAxes = 1.0; // px between the left edge of the axes and a label

/// Where a label stands beside its line or its dot.
enum class Side { Right, Left, Centre };

/// Returns the left end of a label on the side `side` of the line at x = `line`, within the axes, or nullopt if it does
/// not fit there.
std::optional<double> labelLeft(double line, double width, const QRectF &axes, Side side, const QFont &font)
{
    constexpr double kMinGap = 6.0;    // px
    constexpr double kBesideDot = 2.5; // px, so that the text does not touch the dot
    const double gap = std::max(kMinGap, dotRadius(font) + kBesideDot);
    const double leftmost = axes.left() + kInsideAxes;
    const double rightmost = axes.right() - width;
    if (side == Side::Centre) {
        return std::max(leftmost, std::min(line - 0.5 * width, rightmost));
    }
    const double left = side == Side::Right ? line + gap : line - gap - width;
    return left >= leftmost && left <= rightmost ? std::optional(left) : std::nullopt;
}

/// Returns the left end of a column of labels: to the right of the line, or to the left where it does not fit. A column
/// that fits on neither side begins at the left edge of the axes, beside their numbers.
double columnLeft(const PlotCursor &cursor, double width, const QRectF &axes, const QFont &font)
{
    const std::optional<double> right = labelLeft(cursor.x, width, axes, Side::Right, font);
    const std::optional<double> left = labelLeft(cursor.x, width, axes, Side::Left, font);
    return right ? *right : left.value_or(axes.left() + kInsideAxes);
}

/// Returns how many points of the curves, and how many dots, are below a label. Dots count as many points.
std::ptrdiff_t coveredPoints(const PlotCursor &cursor, const QRectF &place, double radiusOfDot)
{
    constexpr std::ptrdiff_t kPointsOfDot = 10;
    std::ptrdiff_t covered =
        std::ranges::count_if(cursor.curves, [&place](QPointF point) { return place.contains(point); });
    const QRectF around = place.adjusted(-radiusOfDot, -radiusOfDot, radiusOfDot, radiusOfDot);
    for (const PlotCursor::Label &label : cursor.labels) {
        covered += label.dot && around.contains(*label.dot) ? kPointsOfDot : 0;
    }
    return covered;
}

/// Returns the place of a value that keeps its distance from its anchor (Label::lastPlace). Returns nullopt if it has
/// had no place, or a place that is far from the anchor or is not within the axes now.
std::optional<QRectF> keptPlace(const PlotCursor &cursor, const PlotCursor::Label &label, const QRectF &axes,
                                double height)
{
    constexpr double kFarInHeights = 1.6; // heights of a label
    if (!label.lastPlace || std::abs(label.lastPlace->center().y()) > kFarInHeights * height) {
        return std::nullopt;
    }
    const QPointF anchor = anchorOf(cursor, label);
    QRectF place(QPointF(), QSizeF(label.text.size().width(), height));
    place.moveCenter(anchor + label.lastPlace->center());
    if (label.lastPlace->left() > 0.0) {
        place.moveLeft(anchor.x() + label.lastPlace->left());
    } else if (label.lastPlace->right() < 0.0) {
        place.moveRight(anchor.x() + label.lastPlace->right());
    }
    return axes.contains(place) ? std::optional(place) : std::nullopt;
}

/// Returns the possible places of a value, the best first: its last place, to the right or the left of the line
/// near its dot, above and below the dot, and then farther away.
std::vector<QRectF> possiblePlaces(const PlotCursor &cursor, const PlotCursor::Label &label, const QRectF &axes,
                                   const QFont &font)
{
    // Distances upwards and downwards from the dot, in half heights of a label.
    constexpr int kNearInHalfHeights = 3;
    constexpr int kFarInHalfHeights = 6;
    constexpr int kClearOfDotInHalfHeights = 2; // so that a label above or below its dot does not cover the dot
    const double height = QFontMetricsF(font).height();
    const double width = label.text.size().width();
    const double middle = anchorOf(cursor, label).y() - 0.5 * height;
    std::vector<QRectF> places;
    if (const std::optional<QRectF> kept = keptPlace(cursor, label, axes, height)) {
        places.push_back(*kept);
    }
    const auto add = [&](Side side, int first, int last) {
        const std::optional<double> left = labelLeft(cursor.x, width, axes, side, font);
        for (int shift = first; left && shift <= last; ++shift) {
            for (const double top : {middle - 0.5 * shift * height, middle + 0.5 * shift * height}) {
                const double within = std::max(axes.top(), std::min(top, axes.bottom() - height));
                places.emplace_back(*left, within, width, height);
            }
        }
    };
    add(Side::Right, 0, kNearInHalfHeights);
    add(Side::Left, 0, kNearInHalfHeights);
    add(Side::Centre, kClearOfDotInHalfHeights, kFarInHalfHeights);
    add(Side::Right, kNearInHalfHeights + 1, kFarInHalfHeights);
    add(Side::Left, kNearInHalfHeights + 1, kFarInHalfHeights);
    return places;
}

/// Returns whether a place is above the value of a higher dot, or below the value of a lower dot.
bool isInWrongOrder(const PlotCursor &cursor, const PlotCursor::Label &label, const QRectF &place)
{
    return std::ranges::any_of(cursor.labels, [&](const PlotCursor::Label &other) {
        return other.dot && !other.place.isEmpty() &&
               (anchorOf(cursor, other).y() - anchorOf(cursor, label).y()) * (other.place.top() - place.top()) < 0.0;
    });
}

/// Places a value where it covers no other label and the fewest points of the curves. A place in the wrong order counts
/// as one more point, except while the motion is played, because values would jump where curves cross: then a place
/// other than the one where the value stood before counts as some more points. Returns the number of points, or nullopt
/// if every place covers a label.
std::optional<std::ptrdiff_t> placeValue(const PlotCursor &cursor, PlotCursor::Label &label, const QRectF &axes,
                                         const QFont &font)
{
    constexpr std::ptrdiff_t kPointsOfWrongOrder = 1;
    constexpr std::ptrdiff_t kPointsOfJump = 2;
    const std::optional<QRectF> kept = keptPlace(cursor, label, axes, QFontMetricsF(font).height());
    std::optional<std::ptrdiff_t> fewest;
    QRectF best;
    for (const QRectF &place : possiblePlaces(cursor, label, axes, font)) {
        const auto overlaps = [&place](const PlotCursor::Label &other) { return other.place.intersects(place); };
        if (std::ranges::any_of(cursor.labels, overlaps)) {
            continue;
        }
        std::ptrdiff_t covered = coveredPoints(cursor, place, dotRadius(font));
        covered += !label.lastPlace && isInWrongOrder(cursor, label, place) ? kPointsOfWrongOrder : 0;
        covered += kept && place != *kept ? kPointsOfJump : 0;
        if (!fewest || covered < *fewest) {
            fewest = covered;
            best = place;
        }
        if (covered == 0) {
            break;
        }
    }
    label.place = best;
    return fewest;
}

/// Removes the text of a value, so that only its dot remains.
void leaveOut(PlotCursor::Label &label)
{
    label.text.setText({});
    label.place = QRectF();
}

/// Places all labels in a column beside the line. A column that is higher than the axes begins above them.
void stackLabels(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    const double height = QFontMetricsF(font).height();
    double widest = 0.0;
    for (const PlotCursor::Label &label : cursor.labels) {
        widest = std::max(widest, label.text.size().width());
    }
    const double left = columnLeft(cursor, widest, axes, font);
    double top =
        std::max(0.0, std::min(axes.top(), axes.bottom() - height * static_cast<double>(cursor.labels.size())));
    for (PlotCursor::Label &label : cursor.labels) {
        label.place = QRectF(QPointF(left, top), QSizeF(label.text.size().width(), height));
        top += height;
    }
}

/// The penalty, in covered points, for a value without a place. It is larger than the number of points that values
/// cover.
constexpr std::ptrdiff_t kPointsWithoutPlace = 10000;

/// The order in which the values are placed: from the highest dot to the lowest, or from the lowest to the highest.
enum class Direction { Downwards, Upwards };

/// Returns the indices of the labels in that direction; where values may be left out, the most important ranks first.
std::vector<std::size_t> orderOfPlacing(const PlotCursor &cursor, Direction direction, CrowdedLabelPolicy policy)
{
    std::vector<std::size_t> order(cursor.labels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (direction == Direction::Upwards) {
        std::ranges::reverse(order);
    }
    if (policy == CrowdedLabelPolicy::LeaveOut) {
        std::ranges::stable_sort(order, {}, [&cursor](std::size_t i) { return cursor.labels[i].rank; });
    }
    return order;
}

/// Places the values one after the other. Of the values of a rank, all are placed or none, and none if one of a more
/// important rank is left out: a single value would be taken for that of the model. Returns how many points of the
/// curves they cover, with a penalty for each value that has no place or is left out.
std::ptrdiff_t placeValues(PlotCursor &cursor, Direction direction, const QRectF &axes, const QFont &font,
                           CrowdedLabelPolicy policy)
{
    constexpr std::ptrdiff_t kMaxCovered = 1; // points: the corner of a label may touch a curve
    std::ptrdiff_t total = 0;
    std::optional<PlotCursor::Rank> missing; // the most important rank of which a value has no place
    for (const std::size_t i : orderOfPlacing(cursor, direction, policy)) {
        PlotCursor::Label &label = cursor.labels[i];
        if (!label.dot || missing) {
            continue;
        }
        const std::ptrdiff_t covered = placeValue(cursor, label, axes, font).value_or(kPointsWithoutPlace);
        if (covered > kMaxCovered && policy == CrowdedLabelPolicy::LeaveOut) {
            missing = label.rank;
        }
        total += covered;
    }
    for (PlotCursor::Label &label : cursor.labels) {
        if (label.dot && missing && label.rank >= *missing) {
            leaveOut(label);
            total += kPointsWithoutPlace;
        }
    }
    return total;
}

/// Places the values in the direction in which they cover fewer points, because the values that are placed first take
/// the best places. While the motion is played, downwards is sufficient: most values keep their places. Returns the
/// same as placeValues().
std::ptrdiff_t placeValuesInBestDirection(PlotCursor &cursor, const QRectF &axes, const QFont &font,
                                          CrowdedLabelPolicy policy)
{
    const bool isPlayed =
        std::ranges::any_of(cursor.labels, [](const PlotCursor::Label &label) { return label.lastPlace.has_value(); });
    PlotCursor upwards = cursor;
    const std::ptrdiff_t covered = placeValues(cursor, Direction::Downwards, axes, font, policy);
    if (covered == 0 || isPlayed) {
        return covered;
    }
    const std::ptrdiff_t coveredUpwards = placeValues(upwards, Direction::Upwards, axes, font, policy);
    if (coveredUpwards < covered) {
        cursor = std::move(upwards);
    }
    return std::min(covered, coveredUpwards);
}

/// Places the labels without a dot at the top of the axes, one below the other.
void placeHeadings(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    double top = axes.top();
    for (PlotCursor::Label &label : cursor.labels) {
        if (!label.dot) {
            const QSizeF size(label.text.size().width(), QFontMetricsF(font).height());
            label.place = QRectF(QPointF(columnLeft(cursor, size.width(), axes, font), top), size);
            top = label.place.bottom();
        }
    }
}

/// Places the labels of one cursor. If a value has no place near its dot, all labels are in a column.
void placeLabelsOf(PlotCursor &cursor, const QRectF &wholeAxes, const QFont &font, CrowdedLabelPolicy policy)
{
    // Beside the left edge, where the axis has its numbers, a value looks like one of them. A figure has little space.
    constexpr double kBesideNumbers = 3.0; // px
    const bool isFigure = policy == CrowdedLabelPolicy::LeaveOut;
    const QRectF axes = isFigure ? wholeAxes : wholeAxes.adjusted(kBesideNumbers, 0.0, 0.0, 0.0);
    std::ranges::stable_sort(cursor.labels, {}, [&cursor](const PlotCursor::Label &label) {
        return label.dot ? anchorOf(cursor, label).y() : 0.0;
    });
    for (PlotCursor::Label &label : cursor.labels) {
        label.text.prepare({}, font);
    }
    placeHeadings(cursor, axes, font);
    const std::ptrdiff_t covered = placeValuesInBestDirection(cursor, axes, font, policy);
    if (covered >= kPointsWithoutPlace && policy == CrowdedLabelPolicy::CoverLeast) {
        stackLabels(cursor, axes, font);
    }
}

} // namespace

QPointF anchorOf(const PlotCursor &cursor, const PlotCursor::Label &label)
{
    return {cursor.x, label.crossing.value_or(label.dot ? label.dot->y() : 0.0)};
}

PlotCursor translated(PlotCursor cursor, QPointF offset)
{
    cursor.x += offset.x();
    for (PlotCursor::Label &label : cursor.labels) {
        label.dot = label.dot ? std::optional(*label.dot + offset) : std::nullopt;
        label.crossing = label.crossing ? std::optional(*label.crossing + offset.y()) : std::nullopt;
        label.place.translate(offset);
    }
    for (QPointF &point : cursor.curves) {
        point += offset;
    }
    return cursor;
}

double curveReach(const QFont &font)
{
    constexpr double kWidestValue = 5.0; // heights of its text, with the gap beside the line
    return kWidestValue * QFontMetricsF(font).height();
}

double curveSpacing(const QFont &font)
{
    constexpr double kPointsPerLine = 7.0; // so that a curve cannot cross a label unnoticed
    return QFontMetricsF(font).height() / kPointsPerLine;
}

double dotRadius(const QFont &font)
{
    constexpr double kMinRadius = 3.5;     // px
    constexpr double kFontFraction = 0.27; // of the size of the letters
    return std::max(kMinRadius, kFontFraction * font.pixelSize());
}

void placeLabels(std::vector<PlotCursor> &cursors, const QRectF &axes, const QFont &font, CrowdedLabelPolicy policy)
{
    for (PlotCursor &cursor : cursors) {
        placeLabelsOf(cursor, axes, font, policy);
    }
    if (cursors.empty()) {
        return;
    }
    PlotCursor &timeCursor = cursors.front();
    for (const PlotCursor &later : std::span(cursors).subspan(1)) {
        for (PlotCursor::Label &label : timeCursor.labels) {
            const auto covers = [&label](const PlotCursor::Label &other) {
                return other.place.intersects(label.place);
            };
            if (std::ranges::any_of(later.labels, covers)) {
                leaveOut(label);
            }
        }
    }
}

void keepPlaces(std::vector<PlotCursor> &cursors, std::span<const PlotCursor> before)
{
    constexpr double kMaxDistance = 20.0; // px from frame to frame; a click may move the cursor farther
    for (PlotCursor &cursor : cursors) {
        const auto old = std::ranges::find(before, cursor.isLight, &PlotCursor::isLight);
        const double distance = old == before.end() ? 0.0 : std::abs(cursor.x - old->x);
        if (distance == 0.0 || distance > kMaxDistance) { // other curves at the same time have other places
            continue;
        }
        for (PlotCursor::Label &label : cursor.labels) {
            const auto same = std::ranges::find_if(old->labels, [&label](const PlotCursor::Label &other) {
                return label.dot && other.dot && other.colour == label.colour && !other.place.isEmpty();
            });
            if (same != old->labels.end()) {
                label.lastPlace = same->place.translated(-anchorOf(*old, *same));
            }
        }
    }
}

void paintCursors(QPainter &painter, std::span<const PlotCursor> cursors, const QRectF &axes, const QFont &font,
                  const SeriesColours &colours)
{
    constexpr double kLightOpacity = 0.45;
    constexpr float kOpacityBehindText = 0.8F;
    constexpr double kLineWidth = 1.0;   // px
    constexpr double kPixelCentre = 0.5; // px
    const double radius = dotRadius(font);
    painter.setFont(font);
    for (const PlotCursor &cursor : cursors) {
        painter.setOpacity(cursor.isLight ? kLightOpacity : 1.0);
        const double x = cursor.x + kPixelCentre;
        painter.setPen(QPen(colours.cursor, kLineWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QLineF(x, axes.top(), x, axes.bottom())); // a rectangle may vanish in a preview
        painter.setOpacity(1.0);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(colours.background); // separates a dot from its curve
        for (const PlotCursor::Label &label : cursor.labels) {
            if (label.dot) {
                painter.setBrush(label.colour);
                painter.drawEllipse(*label.dot, radius, radius);
            }
        }
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
    QColor behind = colours.background;
    behind.setAlphaF(kOpacityBehindText);
    for (const PlotCursor &cursor : cursors) {
        for (const PlotCursor::Label &label : cursor.labels) {
            painter.fillRect(label.place, behind);
            painter.setPen(label.colour);
            painter.drawStaticText(label.place.topLeft(), label.text);
        }
    }
}

} // namespace slidercrank
