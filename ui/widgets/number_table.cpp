// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_table.h"

#include "ui/widgets/named.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QAbstractTableModel>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QStyledItemDelegate>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr int kMargin = 3; // px, beside a text in its cell, as the style has it
constexpr int kMarkSize = 13;
constexpr int kAir = 12; // px, about the longest text of a column
constexpr int kInstantRole = Qt::UserRole;
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
        const auto sameName = [](const TableRow &one, const TableRow &other) {
            return one.cells[0].text == other.cells[0].text;
        };
        if (!std::ranges::equal(rows, m_rows, sameName)) {
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
                if (was.text != is.text || was.tint != is.tint || was.ink != is.ink ||
                    was.mark.cacheKey() != is.mark.cacheKey()) {
                    emit dataChanged(index(row, column), index(row, column));
                }
            }
        }
    }

    const std::vector<TableColumn> &columns() const { return m_columns; }
    const std::vector<TableRow> &rows() const { return m_rows; }
    const TableRow &row(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    const TableCell &cell(int row, int column) const { return this->row(row).cells[static_cast<std::size_t>(column)]; }

    std::optional<double> instantOf(const QModelIndex &index) const
    {
        const std::optional<double> &own = cell(index.row(), index.column()).instant;
        return own ? own : row(index.row()).instant;
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
        case Qt::AccessibleTextRole: return shown.spoken.isEmpty() ? QVariant() : shown.spoken;
        case Qt::DecorationRole: return shown.mark.isNull() ? QVariant() : shown.mark;
        case kInstantRole: return instantOf(index) ? QVariant(*instantOf(index)) : QVariant();
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

/// A text on its tint, and no more: the cells are painted while the mechanism plays, and the general delegate takes ten
/// times as long.
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
        QColor ink = cell.ink.isValid() ? cell.ink : option.palette.color(QPalette::Text);
        if (cell.tint != 0.0) {
            const QColor background = tintColour(cell.tint, option.palette);
            painter->fillRect(option.rect.adjusted(0, 0, -1, -1), background);
            ink = inkOn(background);
        } else if (option.state.testFlag(QStyle::State_Selected)) {
            painter->fillRect(option.rect, option.palette.brush(QPalette::Highlight));
            ink = option.palette.color(QPalette::HighlightedText);
        } else if (index.row() == m_pointed) {
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
        QRect place = option.rect.adjusted(kMargin, 0, -kMargin, 0);
        if (!cell.mark.isNull()) {
            cell.mark.paint(painter, QRect(place.topLeft(), QSize(kMarkSize, place.height())));
            place.setLeft(place.left() + kMarkSize + kMargin);
        }
        const bool wraps = option.features.testFlag(QStyleOptionViewItem::WrapText);
        painter->drawText(place,
                          static_cast<int>(m_model.alignmentOf(index.column())) |
                              static_cast<int>(wraps ? Qt::TextWordWrap : Qt::TextSingleLine),
                          wraps ? cell.text : shownText(cell, option.rect, option.fontMetrics));
    }

    static QString shownText(const TableCell &cell, const QRect &place, const QFontMetrics &metrics)
    {
        const int room = place.width() - 2 * kMargin - (cell.mark.isNull() ? 0 : kMarkSize + kMargin);
        const bool fits = cell.shortText.isEmpty() || metrics.horizontalAdvance(cell.text) <= room;
        return metrics.elidedText(fits ? cell.text : cell.shortText, Qt::ElideRight, room);
    }

    void setPointed(int row) { m_pointed = row; }
    void setRuled(bool ruled) { m_ruled = ruled; }
    void setShort(bool isShort) { m_short = isShort; }

protected:
    /// For the size that a cell asks for.
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (const QString &text = m_model.cell(index.row(), index.column()).shortText; m_short && !text.isEmpty()) {
            option->text = text;
        }
    }

private:
    const NumberTableModel &m_model;
    int m_pointed = -1;
    bool m_ruled = false;
    bool m_short = false;
};

NumberTable::NumberTable(const QString &name, const QString &title, std::vector<TableColumn> columns, TableLook look)
    : m_model(new NumberTableModel(std::move(columns), this))
    , m_delegate(new CellDelegate(*m_model, this))
    , m_look(look)
    , m_rowAir(look == TableLook::Dense ? 0 : 4)
{
    named(name, this, title);
    setModel(m_model);
    setItemDelegate(m_delegate);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(look == TableLook::Dense ? QAbstractItemView::SingleSelection
                                              : QAbstractItemView::ExtendedSelection);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrap(false);
    setIconSize({kMarkSize, kMarkSize});
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    if (look == TableLook::Dense) {
        setMouseTracking(true);
        setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
        setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
        setMinimumSize(1, 1);
    } else {
        setAlternatingRowColors(true);
    }
    connect(this, &QTableView::clicked, this, [this](const QModelIndex &index) { goTo(m_model->instantOf(index)); });
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
    std::vector<int> all(m_model->rows().size());
    std::iota(all.begin(), all.end(), 0);
    return csv(all);
}

QString NumberTable::csv(const std::vector<int> &rows) const
{
    QStringList lines;
    QStringList fields;
    for (const TableColumn &column : m_model->columns()) {
        fields << csvField(column.csvName);
    }
    lines << fields.join(u',');
    const QLocale plain = QLocale::c();
    for (const int row : rows) {
        fields.clear();
        for (const TableCell &cell : m_model->row(row).cells) {
            const QString &text = cell.csv.isEmpty() ? cell.text : cell.csv;
            fields << csvField(cell.number      ? plain.toString(*cell.number, 'g', QLocale::FloatingPointShortest)
                               : text == dash() ? QString()
                                                : text);
        }
        lines << fields.join(u',');
    }
    return lines.join(u'\n') + u'\n';
}

void NumberTable::copy()
{
    std::vector<int> rows;
    if (selectionMode() == ExtendedSelection) {
        for (const QModelIndex &index : selectionModel()->selectedRows()) {
            rows.push_back(index.row());
        }
        std::sort(rows.begin(), rows.end());
    }
    QApplication::clipboard()->setText(rows.empty() ? csv() : csv(rows));
    emit copied(rows.empty() ? m_model->rowCount() : static_cast<int>(rows.size()));
}

void NumberTable::setColumnText(int column, const QString &longest)
{
    m_longest.resize(m_model->columns().size());
    QString &kept = m_longest[static_cast<std::size_t>(column)];
    if (kept != longest) {
        kept = longest;
        horizontalHeader()->setMinimumSectionSize(1);
        horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        fitColumns();
    }
}

int NumberTable::widthFor(const QString &text) const
{
    return fontMetrics().horizontalAdvance(text) + kAir;
}

void NumberTable::fitToContents(int leastAir, int mostAir)
{
    m_leastAir = leastAir;
    m_mostAir = mostAir;
    const int columns = m_model->columnCount() - (horizontalHeader()->stretchLastSection() ? 1 : 0);
    const auto neededWidth = [this, columns](bool ofShortTexts) {
        m_delegate->setShort(ofShortTexts);
        int width = 0;
        for (int column = 0; column < columns; ++column) {
            resizeColumnToContents(column);
            width += columnWidth(column);
        }
        return width;
    };
    const int room = viewport()->width();
    int needed = neededWidth(false);
    if (needed > room) {
        needed = neededWidth(true);
    }
    const int air = std::clamp((room - needed) / columns, leastAir, mostAir);
    for (int column = 0; column < columns; ++column) {
        setColumnWidth(column, columnWidth(column) + air);
    }
}

QString NumberTable::shownText(const QModelIndex &index) const
{
    return CellDelegate::shownText(m_model->cell(index.row(), index.column()), visualRect(index), fontMetrics());
}

void NumberTable::setRuled(bool ruled)
{
    m_delegate->setRuled(ruled);
}

void NumberTable::setRowAir(int pixels)
{
    m_rowAir = pixels;
    setHeights();
}

void NumberTable::setHeights()
{
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + m_rowAir);
    if (m_look == TableLook::Dense) {
        horizontalHeader()->setFixedHeight(fontMetrics().height() + 4);
    }
}

void NumberTable::fitColumns()
{
    if (m_longest.empty() && m_leastAir < m_mostAir) {
        fitToContents(m_leastAir, m_mostAir);
    }
    std::vector<int> widths;
    int needed = 0;
    int stretching = 0;
    for (std::size_t column = 0; column < m_longest.size(); ++column) {
        const QString &text = m_longest[column];
        const int title = widthFor(m_model->columns()[column].title);
        widths.push_back(text.isNull() ? title : std::max(title, widthFor(text)));
        needed += text.isNull() ? 0 : widths.back();
        stretching += text.isNull() ? 1 : 0;
    }
    const int room = viewport()->width();
    for (std::size_t column = 0; column < widths.size(); ++column) {
        const bool stretches = m_longest[column].isNull(); // no further than its title: else it is scrolled
        const int width = stretches ? std::max(widths[column], (room - needed) / stretching) : widths[column];
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
    if (event->type() == QEvent::ShortcutOverride && copies(static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void NumberTable::goTo(std::optional<double> instant)
{
    if (instant) {
        emit instantRequested(*instant);
    }
}

bool NumberTable::copies(QKeyEvent *event) const
{
    return event->matches(QKeySequence::Copy) && !m_model->columns().front().csvName.isEmpty();
}

void NumberTable::keyPressEvent(QKeyEvent *event)
{
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (copies(event)) {
        copy();
    } else if (enters && currentIndex().isValid()) {
        goTo(m_model->row(currentIndex().row()).instant);
    } else {
        QTableView::keyPressEvent(event);
    }
}

bool NumberTable::viewportEvent(QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseMove:
        if (m_look == TableLook::Dense) {
            point(indexAt(static_cast<QMouseEvent *>(event)->pos()).row());
        }
        break;
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
    m_delegate->setPointed(row);
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
    const MechanismPart part = exists ? m_model->row(row).part : MechanismPart::None;
    if (part != m_told) {
        m_told = part;
        emit partHovered(part);
    }
}

} // namespace slidercrank
