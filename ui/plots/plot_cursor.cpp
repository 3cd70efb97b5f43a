// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_cursor.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// Returns how many points of the curves a label would cover. A dot counts as kPointsPerDot points.
std::ptrdiff_t coveredPoints(const PlotCursor &cursor, const QRectF &place, double radiusOfDot)
{
    constexpr std::ptrdiff_t kPointsPerDot = 10;
    std::ptrdiff_t covered =
        std::ranges::count_if(cursor.curvePoints, [&place](QPointF point) { return place.contains(point); });
    const QRectF around = place.adjusted(-radiusOfDot, -radiusOfDot, radiusOfDot, radiusOfDot);
    for (const PlotCursor::Label &label : cursor.labels) {
        covered += label.dot && around.contains(*label.dot) ? kPointsPerDot : 0;
    }
    return covered;
}

/// Returns the place at which a value has the same distance from its anchor as in the previous frame. Returns nullopt
/// if the value had no place, if that place was far above or below the anchor, or if the new place leaves the axes.
std::optional<QRectF> keptPlace(const PlotCursor &cursor, const PlotCursor::Label &label, const QRectF &axes,
                                double height)
{
    constexpr double kFarInHeights = 1.6; // heights of a label
    if (!label.previousPlace || std::abs(label.previousPlace->center().y()) > kFarInHeights * height) {
        return std::nullopt;
    }
    const QPointF anchor = anchorOf(cursor, label);
    QRectF place(QPointF(), QSizeF(label.text.size().width(), height));
    place.moveCenter(anchor + label.previousPlace->center());
    if (label.previousPlace->left() > 0.0) {
        place.moveLeft(anchor.x() + label.previousPlace->left());
    } else if (label.previousPlace->right() < 0.0) {
        place.moveRight(anchor.x() + label.previousPlace->right());
    }
    return axes.contains(place) ? std::optional(place) : std::nullopt;
}

/// Returns the possible places of a value, the best first: keptPlace(), to the right or the left of the line near its
/// dot, above and below the dot, and then farther away.
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
/// as one more point. While the motion is played it does not, because values would jump where curves cross; instead,
/// every place other than keptPlace() counts as two more points. Returns the number of points, or nullopt if every
/// place covers a label.
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
        covered += !label.previousPlace && isInWrongOrder(cursor, label, place) ? kPointsOfWrongOrder : 0;
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

/// Places the values one after the other, from the highest dot to the lowest. Returns whether each of them has a place
/// in the right order that covers nothing.
bool placeOneAfterTheOther(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    bool isGood = true;
    for (PlotCursor::Label &label : cursor.labels) {
        if (label.dot) {
            isGood = placeValue(cursor, label, axes, font) == 0 && isGood;
        }
    }
    return isGood;
}

/// A place of a value, and how good it is.
struct RatedPlace {
    QRectF place;
    std::ptrdiff_t covered = 0; ///< number of points of the curves
    std::size_t index = 0;      ///< in possiblePlaces(), where the best places are first
};

/// The places of the first values of a cursor.
struct Arrangement {
    std::vector<QRectF> places = {};
    std::ptrdiff_t covered = 0; ///< sum over the places
    std::size_t indexSum = 0;   ///< sum of RatedPlace::index
};

/// Returns the possible places of a value that cover no heading and at most `maxCovered` points of the curves.
std::vector<RatedPlace> ratedPlaces(const PlotCursor &cursor, const PlotCursor::Label &label, const QRectF &axes,
                                    const QFont &font, std::ptrdiff_t maxCovered)
{
    std::vector<RatedPlace> rated;
    std::size_t index = 0;
    for (const QRectF &place : possiblePlaces(cursor, label, axes, font)) {
        const auto isCoveredHeading = [&place](const PlotCursor::Label &other) {
            return !other.dot && other.place.intersects(place);
        };
        const std::ptrdiff_t covered = coveredPoints(cursor, place, dotRadius(font));
        if (covered <= maxCovered && std::ranges::none_of(cursor.labels, isCoveredHeading)) {
            rated.push_back({place, covered, index});
        }
        ++index;
    }
    return rated;
}

/// Adds the next value to the arrangements, at each of its places that is not above the previous value and covers no
/// value. Returns the best of the results.
std::vector<Arrangement> extendedArrangements(const std::vector<RatedPlace> &places,
                                              const std::vector<Arrangement> &arrangements)
{
    constexpr std::size_t kMaxArrangements = 24; // with more of them, hardly any value has a better place
    struct Continuation {
        const Arrangement *first;
        const RatedPlace *next;

        std::pair<std::ptrdiff_t, std::size_t> cost() const
        {
            return {first->covered + next->covered, first->indexSum + next->index};
        }
    };
    std::vector<Continuation> continuations;
    for (const RatedPlace &next : places) {
        const auto overlaps = [&next](const QRectF &other) { return other.intersects(next.place); };
        for (const Arrangement &first : arrangements) {
            const bool isInOrder = first.places.empty() || first.places.back().top() <= next.place.top();
            if (isInOrder && std::ranges::none_of(first.places, overlaps)) {
                continuations.push_back({&first, &next});
            }
        }
    }
    const std::size_t kept = std::min(continuations.size(), kMaxArrangements);
    const auto end = continuations.begin() + static_cast<std::ptrdiff_t>(kept);
    std::ranges::partial_sort(continuations, end, {}, &Continuation::cost);
    std::vector<Arrangement> longer;
    for (const auto &[first, next] : std::span(continuations).first(kept)) {
        Arrangement &added = longer.emplace_back(*first);
        added.places.push_back(next->place);
        added.covered += next->covered;
        added.indexSum += next->index;
    }
    return longer;
}

/// Places values in the order of their dots, all of them together where they cover the fewest points. `values` are
/// sorted from the highest dot to the lowest. Returns false, and changes nothing, if there is no such arrangement.
bool placeTogether(PlotCursor &cursor, const std::vector<std::size_t> &values, const QRectF &axes, const QFont &font,
                   std::ptrdiff_t maxCovered)
{
    std::vector<Arrangement> best(1);
    for (const std::size_t index : values) {
        best = extendedArrangements(ratedPlaces(cursor, cursor.labels[index], axes, font, maxCovered), best);
    }
    if (best.empty()) {
        return false;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        cursor.labels[values[i]].place = best.front().places[i];
    }
    return true;
}

/// Returns the indices of the values that are at least as important as a rank, from the highest dot to the lowest.
std::vector<std::size_t> valuesUpTo(const PlotCursor &cursor, PlotCursor::Rank rank)
{
    std::vector<std::size_t> values;
    for (std::size_t i = 0; i < cursor.labels.size(); ++i) {
        if (cursor.labels[i].dot && cursor.labels[i].rank <= rank) {
            values.push_back(i);
        }
    }
    return values;
}

/// Places the values of all ranks. If they do not fit, leaves out all values of the least important rank and tries
/// again. It leaves out whole ranks, because a single remaining value would be taken for that of the model. A label may
/// cover kMaxCovered points of a curve.
void placeMostImportant(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    constexpr std::ptrdiff_t kMaxCovered = 1; // the corner of a label may touch a curve
    using Rank = PlotCursor::Rank;
    for (const Rank rank : {Rank::Pinned, Rank::File, Rank::Model}) {
        if (placeTogether(cursor, valuesUpTo(cursor, rank), axes, font, kMaxCovered)) {
            return;
        }
        for (PlotCursor::Label &label : cursor.labels) {
            if (label.dot && label.rank == rank) {
                leaveOut(label);
            }
        }
    }
}

/// Places all values. If one has no place near its dot, all labels are in a column. While the motion is played, most
/// values keep their places.
void placeAll(PlotCursor &cursor, const QRectF &axes, const QFont &font)
{
    constexpr std::ptrdiff_t kAnyNumber = std::numeric_limits<std::ptrdiff_t>::max();
    const bool isPlayed = std::ranges::any_of(
        cursor.labels, [](const PlotCursor::Label &label) { return label.previousPlace.has_value(); });
    if (placeOneAfterTheOther(cursor, axes, font)) {
        return;
    }
    const bool isPlaced =
        !isPlayed && placeTogether(cursor, valuesUpTo(cursor, PlotCursor::Rank::Pinned), axes, font, kAnyNumber);
    const auto hasNoPlace = [](const PlotCursor::Label &label) { return label.dot && label.place.isEmpty(); };
    if (!isPlaced && std::ranges::any_of(cursor.labels, hasNoPlace)) {
        stackLabels(cursor, axes, font);
    }
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

void placeLabelsOf(PlotCursor &cursor, const QRectF &wholeAxes, const QFont &font, CrowdedLabelPolicy policy)
{
    // Close to the left edge, a value could be taken for one of the numbers of the axis. In an exported figure, which
    // has little space, it may be there nevertheless.
    constexpr double kGapToNumbers = 3.0; // px
    const bool isExported = policy == CrowdedLabelPolicy::LeaveOut;
    const QRectF axes = isExported ? wholeAxes : wholeAxes.adjusted(kGapToNumbers, 0.0, 0.0, 0.0);
    std::ranges::stable_sort(cursor.labels, {}, [&cursor](const PlotCursor::Label &label) {
        return label.dot ? anchorOf(cursor, label).y() : 0.0;
    });
    for (PlotCursor::Label &label : cursor.labels) {
        label.text.prepare({}, font);
    }
    placeHeadings(cursor, axes, font);
    if (isExported) {
        placeMostImportant(cursor, axes, font);
    } else {
        placeAll(cursor, axes, font);
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
    for (QPointF &point : cursor.curvePoints) {
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

void setPreviousPlaces(std::vector<PlotCursor> &cursors, std::span<const PlotCursor> before)
{
    constexpr double kMaxMoveOfFrame = 20.0; // px; a click may move the cursor farther
    for (PlotCursor &cursor : cursors) {
        const auto old = std::ranges::find(before, cursor.followsPointer, &PlotCursor::followsPointer);
        const double distance = old == before.end() ? 0.0 : std::abs(cursor.x - old->x);
        if (distance == 0.0 || distance > kMaxMoveOfFrame) { // if it is 0, only the curves have changed
            continue;
        }
        for (PlotCursor::Label &label : cursor.labels) {
            const auto same = std::ranges::find_if(old->labels, [&label](const PlotCursor::Label &other) {
                return label.dot && other.dot && other.colour == label.colour && !other.place.isEmpty();
            });
            if (same != old->labels.end()) {
                label.previousPlace = same->place.translated(-anchorOf(*old, *same));
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
        painter.setOpacity(cursor.followsPointer ? kLightOpacity : 1.0);
        const double x = cursor.x + kPixelCentre;
        painter.setPen(QPen(colours.cursor, kLineWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QLineF(x, axes.top(), x, axes.bottom())); // a thin rectangle may vanish in a preview
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
