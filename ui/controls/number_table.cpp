// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/number_table.h"

#include "ui/words/theme.h"

#include <QAbstractTableModel>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kMargin = 4; // px, beside a text in its cell
constexpr int kTintRole = Qt::UserRole;
constexpr int kShortTextRole = Qt::UserRole + 1;

QColor mixed(const QColor &one, const QColor &other, double part)
{
    const auto mix = [part](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
    return {mix(one.red(), other.red()), mix(one.green(), other.green()), mix(one.blue(), other.blue())};
}

/// Black or white, whichever stands out.
QColor inkOn(const QColor &background)
{
    return qGray(background.rgb()) < 140 ? QColor(Qt::white) : QColor(Qt::black);
}

QString csvField(const QString &text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n')) {
        return text;
    }
    return u'"' + QString(text).replace(QStringLiteral("\""), QStringLiteral("\"\"")) + u'"';
}

} // namespace

QColor tintColour(double tint, const QPalette &palette)
{
    const SeriesColours colours = seriesColours(palette);
    constexpr double kStrongest = 0.85;
    return mixed(colours.background, tint > 0.0 ? colours.model : colours.reference,
                 kStrongest * std::min(1.0, std::abs(tint)));
}

class NumberTableModel : public QAbstractTableModel
{
public:
    NumberTableModel(std::vector<TableColumn> columns, QObject *parent)
        : QAbstractTableModel(parent)
        , m_columns(std::move(columns))
    {
    }

    void setRows(std::vector<TableRow> rows)
    {
        if (rows.size() != m_rows.size()) {
            beginResetModel();
            m_rows = std::move(rows);
            endResetModel();
            return;
        }
        std::swap(m_rows, rows);
        for (int row = 0; row < rowCount(); ++row) {
            const std::vector<TableCell> &before = rows[static_cast<std::size_t>(row)].cells;
            for (int column = 0; column < columnCount(); ++column) {
                const TableCell &was = before[static_cast<std::size_t>(column)];
                const TableCell &is = cell(row, column);
                if (was.text != is.text || was.tint != is.tint) {
                    emit dataChanged(index(row, column), index(row, column));
                }
            }
        }
    }

    const std::vector<TableColumn> &columns() const { return m_columns; }
    const std::vector<TableRow> &rows() const { return m_rows; }

    const TableCell &cell(int row, int column) const
    {
        return m_rows[static_cast<std::size_t>(row)].cells[static_cast<std::size_t>(column)];
    }

    Qt::Alignment alignmentOf(int column) const
    {
        const bool number = m_columns[static_cast<std::size_t>(column)].isNumber;
        return (number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
    }

    int rowCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }

    int columnCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
    }

    QVariant data(const QModelIndex &index, int role) const override
    {
        const TableCell &shown = cell(index.row(), index.column());
        switch (role) {
        case Qt::DisplayRole: return shown.text;
        case Qt::ToolTipRole: return shown.explanation;
        case kTintRole: return shown.tint;
        case kShortTextRole: return shown.shortText;
        default: return {};
        }
    }

    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (orientation == Qt::Vertical) {
            return {};
        }
        const TableColumn &column = m_columns[static_cast<std::size_t>(section)];
        switch (role) {
        case Qt::DisplayRole: return column.title;
        case Qt::ToolTipRole: return column.explanation;
        case Qt::TextAlignmentRole: return static_cast<int>(alignmentOf(section));
        default: return {};
        }
    }

private:
    std::vector<TableColumn> m_columns;
    std::vector<TableRow> m_rows;
};

namespace
{

/// A line of text on its tint, and no more: the cells are painted while the mechanism plays, and the general delegate
/// takes ten times as long.
class CellDelegate : public QStyledItemDelegate
{
public:
    CellDelegate(const NumberTableModel &model, QObject *parent)
        : QStyledItemDelegate(parent)
        , m_model(model)
    {
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const TableCell &cell = m_model.cell(index.row(), index.column());
        if (m_ruled) {
            painter->setPen(seriesColours(option.palette).grid);
            painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
        }
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        QColor ink = option.palette.color(QPalette::Text);
        if (cell.tint != 0.0) {
            const QColor background = tintColour(cell.tint, option.palette);
            painter->fillRect(option.rect.adjusted(0, 0, -1, -1), background);
            ink = inkOn(background);
        }
        if (selected && cell.tint == 0.0) {
            painter->fillRect(option.rect, option.palette.brush(QPalette::Highlight));
            ink = option.palette.color(QPalette::HighlightedText);
        } else if (index.row() == m_pointed && cell.tint == 0.0) {
            QColor light = option.palette.color(QPalette::Highlight);
            light.setAlpha(40);
            painter->fillRect(option.rect, light);
        }
        painter->setPen(ink);
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
        }
        if (cell.text.isEmpty()) {
            return;
        }
        const QRect room = option.rect.adjusted(kMargin, 0, -kMargin, 0);
        const bool fits = cell.shortText.isEmpty() || option.fontMetrics.horizontalAdvance(cell.text) <= room.width();
        painter->drawText(room, static_cast<int>(m_model.alignmentOf(index.column())) | Qt::TextSingleLine,
                          fits ? cell.text : cell.shortText);
    }

    void setPointed(int row) { m_pointed = row; }
    void setRuled(bool ruled) { m_ruled = ruled; }

private:
    const NumberTableModel &m_model;
    int m_pointed = -1;
    bool m_ruled = false;
};

} // namespace

NumberTable::NumberTable(std::vector<TableColumn> columns, QWidget *parent)
    : QTableView(parent)
    , m_model(new NumberTableModel(std::move(columns), this))
    , m_longest(m_model->columns().size())
{
    setModel(m_model);
    setItemDelegate(new CellDelegate(*m_model, this));
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrap(false);
    setMouseTracking(true);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setHeights();
}

void NumberTable::setRows(std::vector<TableRow> rows)
{
    m_model->setRows(std::move(rows));
    if (m_pointed >= m_model->rowCount()) {
        point(-1);
    }
    tell();
}

QString NumberTable::csv() const
{
    QStringList lines;
    QStringList fields;
    for (const TableColumn &column : m_model->columns()) {
        fields << csvField(column.csvName);
    }
    lines << fields.join(u',');
    const QLocale plain = QLocale::c();
    for (const TableRow &row : m_model->rows()) {
        fields.clear();
        for (const TableCell &cell : row.cells) {
            fields << csvField(cell.number ? plain.toString(*cell.number, 'g', QLocale::FloatingPointShortest)
                                           : cell.text);
        }
        lines << fields.join(u',');
    }
    return lines.join(u'\n') + u'\n';
}

void NumberTable::copy() const
{
    QApplication::clipboard()->setText(csv());
}

void NumberTable::setColumnText(int column, const QString &longest)
{
    m_longest[static_cast<std::size_t>(column)] = longest;
    fitColumns();
}

void NumberTable::setRuled(bool ruled)
{
    static_cast<CellDelegate *>(itemDelegate())->setRuled(ruled);
}

void NumberTable::setHeights()
{
    verticalHeader()->setDefaultSectionSize(fontMetrics().height());
    horizontalHeader()->setFixedHeight(fontMetrics().height() + 4);
}

void NumberTable::fitColumns()
{
    std::vector<int> widths;
    int needed = 0;
    int stretching = 0;
    for (std::size_t column = 0; column < m_longest.size(); ++column) {
        const QString &text = m_longest[column];
        const QString &title = m_model->columns()[column].title;
        const int width =
            text.isNull() ? 0
                          : std::max(fontMetrics().horizontalAdvance(text), fontMetrics().horizontalAdvance(title)) +
                                2 * kMargin + 4;
        widths.push_back(width);
        needed += width;
        stretching += text.isNull() ? 1 : 0;
    }
    const int room = viewport()->width();
    for (std::size_t column = 0; column < widths.size(); ++column) {
        int width = widths[column];
        if (stretching > 0 && m_longest[column].isNull()) {
            const int title = fontMetrics().horizontalAdvance(m_model->columns()[column].title) + 2 * kMargin;
            width = std::max(title, (room - needed) / stretching); // else it is scrolled
        }
        setColumnWidth(static_cast<int>(column), width);
    }
}

void NumberTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

void NumberTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        setHeights();
        fitColumns();
    }
}

void NumberTable::hideEvent(QHideEvent *event)
{
    QTableView::hideEvent(event);
    point(-1);
}

/// The window copies its figure by the same key; with the focus here it is the table that is meant.
bool NumberTable::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent *>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void NumberTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        copy();
        return;
    }
    QTableView::keyPressEvent(event);
}

bool NumberTable::viewportEvent(QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseMove: point(indexAt(static_cast<QMouseEvent *>(event)->pos()).row()); break;
    case QEvent::Leave: point(-1); break;
    default: break;
    }
    return QTableView::viewportEvent(event);
}

void NumberTable::point(int row)
{
    if (row == m_pointed) {
        return;
    }
    m_pointed = row;
    static_cast<CellDelegate *>(itemDelegate())->setPointed(row);
    viewport()->update();
    tell();
}

void NumberTable::focusInEvent(QFocusEvent *event)
{
    QTableView::focusInEvent(event);
    tell();
}

void NumberTable::focusOutEvent(QFocusEvent *event)
{
    QTableView::focusOutEvent(event);
    tell();
}

void NumberTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    tell();
}

void NumberTable::tell()
{
    const int row = m_pointed >= 0 ? m_pointed : hasFocus() ? currentIndex().row() : -1;
    const bool exists = row >= 0 && row < m_model->rowCount();
    const MechanismPart part = exists ? m_model->rows()[static_cast<std::size_t>(row)].part : MechanismPart::None;
    if (part != m_told) {
        m_told = part;
        emit partHovered(part);
    }
}

} // namespace slidercrank
