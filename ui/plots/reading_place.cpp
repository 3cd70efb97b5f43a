// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/reading_place.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr int kCell = 3; // px

/// How much there is to hide in each cell of the room, summed from the upper left corner, so that the sum over any
/// box takes four numbers.
class SightSums
{
public:
    SightSums(const QRect &room, const PlotSight &sight)
        : m_room(room)
        , m_columns(room.width() / kCell + 1)
        , m_rows(room.height() / kCell + 1)
        , m_sums(static_cast<std::size_t>((m_columns + 1) * (m_rows + 1)))
    {
        constexpr double kLine = 0.2; // of a curve's pixel: a line is seen on either side of the box
        constexpr double kDot = 1e4;
        constexpr double kDotReach = 6.0; // px
        const QRect &axes = sight.axes;
        for (int row = 0; row < m_rows; ++row) {
            for (int column = 0; column < m_columns; ++column) {
                const QPoint centre(room.left() + kCell * column + 1, room.top() + kCell * row + 1);
                at(column, row) = axes.contains(centre) ? 0.0 : kCell;
            }
        }
        for (const int line : sight.lines) {
            for (int y = axes.top(); y <= axes.bottom(); y += kCell) {
                mark(QPointF(line, y), kLine * kCell);
            }
        }
        for (const QPolygonF &curve : sight.curves) {
            for (qsizetype i = 0; i + 1 < curve.size(); ++i) {
                const QPointF step = curve[i + 1] - curve[i];
                const int pieces = 1 + static_cast<int>(std::max(std::abs(step.x()), std::abs(step.y())) / kCell);
                for (int piece = 0; piece <= pieces; ++piece) {
                    mark(curve[i] + step * piece / pieces, kCell);
                }
            }
        }
        for (const QPointF &dot : sight.dots) {
            for (double x = -kDotReach; x <= kDotReach; x += kCell) {
                for (double y = -kDotReach; y <= kDotReach; y += kCell) {
                    mark(dot + QPointF(x, y), kDot);
                }
            }
        }
        for (int row = 1; row <= m_rows; ++row) {
            for (int column = 1; column <= m_columns; ++column) {
                sum(column, row) += sum(column - 1, row) + sum(column, row - 1) - sum(column - 1, row - 1);
            }
        }
    }

    /// With a cell around it.
    double hiddenBy(int column, int row, int width, int height) const
    {
        const int left = std::max(column - 1, 0);
        const int above = std::max(row - 1, 0);
        const int right = std::min(column + width + 1, m_columns);
        const int below = std::min(row + height + 1, m_rows);
        return sum(right, below) - sum(left, below) - sum(right, above) + sum(left, above);
    }

private:
    double &sum(int column, int row) { return m_sums[static_cast<std::size_t>(row * (m_columns + 1) + column)]; }
    double sum(int column, int row) const { return m_sums[static_cast<std::size_t>(row * (m_columns + 1) + column)]; }
    double &at(int column, int row) { return sum(column + 1, row + 1); }

    void mark(QPointF point, double amount)
    {
        const int column = static_cast<int>(std::floor((point.x() - m_room.left()) / kCell));
        const int row = static_cast<int>(std::floor((point.y() - m_room.top()) / kCell));
        if (column >= 0 && column < m_columns && row >= 0 && row < m_rows) {
            at(column, row) = std::max(at(column, row), amount);
        }
    }

    QRect m_room;
    int m_columns;
    int m_rows;
    std::vector<double> m_sums;
};

double distance(const QRectF &box, const QPointF &point)
{
    const double x = std::max({box.left() - point.x(), 0.0, point.x() - box.right()});
    const double y = std::max({box.top() - point.y(), 0.0, point.y() - box.bottom()});
    return std::hypot(x, y);
}

} // namespace

ReadingPlace placeOfReading(const QSizeF &box, const QRect &room, const PlotSight &sight)
{
    constexpr double kWorst = std::numeric_limits<double>::infinity();
    ReadingPlace best{room.topLeft(), kWorst};
    if (box.width() > room.width() || box.height() > room.height()) {
        return best;
    }
    const SightSums sums(room, sight);
    const int width = static_cast<int>(std::ceil(box.width() / kCell));
    const int height = static_cast<int>(std::ceil(box.height() / kCell));
    std::vector<QPointF> near = sight.dots;
    if (near.empty()) {
        near.push_back(sight.axes.topLeft());
    }
    constexpr double kPerHidden = 100.0; // px farther away rather than one more hidden
    double leastCost = kWorst;
    for (int row = 0; kCell * row + box.height() <= room.height(); ++row) {
        for (int column = 0; kCell * column + box.width() <= room.width(); ++column) {
            const QPointF topLeft(room.left() + kCell * column, room.top() + kCell * row);
            const double hidden = sums.hiddenBy(column, row, width, height);
            double cost = kPerHidden * hidden;
            if (cost >= leastCost) {
                continue;
            }
            for (const QPointF &dot : near) {
                cost += distance(QRectF(topLeft, box), dot);
            }
            if (cost < leastCost) {
                best = {topLeft, hidden};
                leastCost = cost;
            }
        }
    }
    return best;
}

} // namespace slidercrank
