// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_table.h"

#include "ui/text/record.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/formula.h"
#include "ui/widgets/named.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kCellMargin = 20; // px, left and right of a text together
constexpr int kRowMargin = 4;   // px, above and below a text together

QJsonValue csvValue(const TableColumn &column, const TableCell &cell)
{
    return column.isNumber ? jsonNumber(cell.number) : QJsonValue(cell.csv.isEmpty() ? cell.text : cell.csv);
}

int alignmentOf(const TableColumn &column)
{
    return static_cast<int>((column.isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

/// Headings with subscripts.
class FormulaHeader : public QHeaderView
{
public:
    explicit FormulaHeader(QWidget *parent)
        : QHeaderView(Qt::Horizontal, parent)
    {
        setSectionsClickable(true);
    }

protected:
    void paintSection(QPainter *painter, const QRect &box, int section) const override
    {
        const QString title = model()->headerData(section, Qt::Horizontal).toString();
        if (!title.contains(u'_')) {
            QHeaderView::paintSection(painter, box, section);
            return;
        }
        QStyleOptionHeaderV2 option;
        initStyleOption(&option);
        initStyleOptionForIndex(&option, section);
        option.rect = box;
        option.text.clear();
        style()->drawControl(QStyle::CE_Header, &option, painter, this);
        painter->save();
        painter->setPen(option.palette.color(QPalette::ButtonText));
        const int margin = style()->pixelMetric(QStyle::PM_HeaderMargin, &option, this);
        drawFormula(*painter, box.adjusted(margin, 0, -margin, 0), option.textAlignment, title);
        painter->restore();
    }
};

} // namespace

TableCell numberCell(double value, const QString &text)
{
    return std::isfinite(value) ? TableCell{.text = text, .number = value} : TableCell{.text = dash()};
}

QByteArray csvText(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows)
{
    std::vector<Record> records;
    for (const TableRow &row : rows) {
        Record &record = records.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            record.emplace_back(columns[i].csvName, csvValue(columns[i], row.cells[i]));
        }
    }
    return csvText(records, csvSeparators());
}

QColor toneColour(Tone tone, const QPalette &palette)
{
    const SeriesColours colours = seriesColours(palette);
    switch (tone) {
    case Tone::Normal: break;
    case Tone::Muted: return palette.color(QPalette::PlaceholderText);
    case Tone::Link: return palette.color(QPalette::Link);
    case Tone::Model: return colours.model;
    case Tone::Good: return colours.good;
    case Tone::Fair: return colours.reference;
    case Tone::Bad: return colours.warning;
    }
    return palette.color(QPalette::Text);
}

NumberTable::NumberTable(const QString &name, const QString &title, std::vector<TableColumn> columns)
    : m_columns(std::move(columns))
    , m_model(new QStandardItemModel(0, static_cast<int>(m_columns.size()), this))
{
    named(name, this, title);
    setHorizontalHeader(new FormulaHeader(this));
    makeHeadings();
    setModel(m_model);
    setBehaviour();
    setAppearance();
    connectSignals();
    fitColumns();
}

void NumberTable::setBehaviour()
{
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setTabKeyNavigation(false);
    setMouseTracking(true);
}

void NumberTable::setAppearance()
{
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setFrameShape(QFrame::NoFrame);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setMinimumSectionSize(1);
}

void NumberTable::connectSignals()
{
    connect(this, &QTableView::clicked, this, &NumberTable::goToRow);
    connect(this, &QTableView::activated, this, &NumberTable::goToRow); // Enter
    connect(this, &QTableView::clicked, this, [this](const QModelIndex &index) {
        if (isEditableCell(index) && state() != EditingState) { // Qt does not begin to edit the current cell
            QTableView::edit(index);
        }
    });
    connect(this, &QTableView::entered, this, [this](const QModelIndex &index) {
        emit partHovered(m_rows[static_cast<std::size_t>(index.row())].part);
        emit rowHovered(index.row());
    });
    connect(m_model, &QStandardItemModel::itemChanged, this, [this](const QStandardItem *item) {
        if (!m_isFilling && item->row() == m_editableRow) {
            emit typed(item->column(), item->text());
        }
    });
}

void NumberTable::makeHeadings()
{
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const TableColumn &described = m_columns[static_cast<std::size_t>(column)];
        auto *heading = new QStandardItem(described.title);
        heading->setToolTip(described.explanation);
        heading->setData(alignmentOf(described), Qt::TextAlignmentRole);
        m_model->setHorizontalHeaderItem(column, heading);
        if (described.isFormula) {
            setItemDelegateForColumn(column, new FormulaDelegate(this));
        }
    }
}

void NumberTable::setColumns(const std::vector<TableColumn> &columns)
{
    m_columns = columns;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        m_model->horizontalHeaderItem(column)->setText(m_columns[static_cast<std::size_t>(column)].title);
    }
}

void NumberTable::setEditable(int row, int firstColumn)
{
    m_editableRow = row;
    m_firstEditableColumn = firstColumn;
    setEditTriggers(QAbstractItemView::AllEditTriggers);
}

void NumberTable::setRows(std::vector<TableRow> rows)
{
    const bool hasOtherSize = rows.size() != m_rows.size();
    m_rows = std::move(rows);
    m_model->setRowCount(static_cast<int>(m_rows.size()));
    fillCells();
    if (hasOtherSize) { // otherwise columns only become wider: fillCells() sees to that
        fitColumns();
    }
}

/// Writes the rows into the model, which reports only the cells that change.
void NumberTable::fillCells()
{
    const QScopedValueRollback filling(m_isFilling, true);
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const TableRow &content = m_rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < m_model->columnCount(); ++column) {
            const TableCell &cell = content.cells[static_cast<std::size_t>(column)];
            const QModelIndex index = m_model->index(row, column);
            const QString before = index.data().toString();
            // A number needs no more space than one with as many characters; other texts may.
            const bool isOtherText = !cell.number && cell.text != before;
            if (isOtherText || cell.text.size() > before.size()) {
                widen(column, cell.text);
            }
            m_model->setData(index, cell.text, Qt::DisplayRole);
            m_model->setData(index, alignmentOf(m_columns[static_cast<std::size_t>(column)]), Qt::TextAlignmentRole);
            m_model->setData(index, toneColour(cell.tone, palette()), Qt::ForegroundRole);
            if (m_editableRow >= 0) {
                m_model->itemFromIndex(index)->setEditable(row == m_editableRow && column >= m_firstEditableColumn);
            }
            const QSignalBlocker quiet(m_model); // a new tool tip needs no repaint
            m_model->setData(index,
                             content.explanation.isEmpty() && cell.number ? typedNumberText(*cell.number)
                                                                          : content.explanation,
                             Qt::ToolTipRole);
        }
    }
}

void NumberTable::copy()
{
    std::vector<TableRow> rows = m_rows;
    QModelIndexList selected = selectionModel()->selectedRows();
    if (!selected.isEmpty()) {
        std::sort(selected.begin(), selected.end());
        rows.clear();
        for (const QModelIndex &index : selected) {
            rows.push_back(m_rows[static_cast<std::size_t>(index.row())]);
        }
    }
    QApplication::clipboard()->setText(QString::fromUtf8(csvText(m_columns, rows)));
    emit copied();
}

QSize NumberTable::contentSize() const
{
    return {horizontalHeader()->length() + (hasNames() ? m_namesWidth - columnWidth(0) : 0),
            horizontalHeader()->sizeHint().height() + m_model->rowCount() * verticalHeader()->defaultSectionSize()};
}

/// Gives every column the width of its texts.
void NumberTable::fitColumns()
{
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
    for (int column = 0; column < m_model->columnCount(); ++column) {
        const auto index = static_cast<std::size_t>(column);
        setColumnWidth(column, 0);
        m_namesWidth = column == 0 ? 0 : m_namesWidth;
        widen(column, m_columns[index].title);
        for (const TableRow &row : m_rows) {
            widen(column, row.cells[index].text);
        }
    }
}

/// Makes the column wide enough for the text.
void NumberTable::widen(int column, const QString &text)
{
    const int needed = fontMetrics().horizontalAdvance(text) + kCellMargin;
    setColumnWidth(column, std::max(columnWidth(column), needed));
    if (hasNames()) {
        m_namesWidth = column == 0 ? std::max(m_namesWidth, needed) : m_namesWidth;
        setColumnWidth(0, widthOfNames());
    }
}

bool NumberTable::hasNames() const
{
    return m_columns.size() > 1 && !m_columns.front().isNumber && m_columns[1].isNumber;
}

/// Returns the width of the first column. Names are shortened a little where this makes all columns visible, and as
/// much as necessary where the numbers behind them would be cut off.
int NumberTable::widthOfNames() const
{
    constexpr int kShortestNames = 12;   // letters
    constexpr double kMinFraction = 0.8; // of their width that remains if names are shortened a little
    const int forAllColumns = viewport()->width() - (horizontalHeader()->length() - columnWidth(0));
    if (forAllColumns >= kMinFraction * m_namesWidth) {
        return std::min(forAllColumns, m_namesWidth);
    }
    const int shortest = std::min(m_namesWidth, kShortestNames * fontMetrics().averageCharWidth() + kCellMargin);
    return std::clamp(viewport()->width() - columnWidth(1), shortest, m_namesWidth);
}

/// While the table has the focus, the copy key copies its rows instead of triggering the window's shortcut.
bool NumberTable::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent *>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    const bool isHandled = QTableView::event(event);
    if (event->type() == QEvent::FontChange) {
        horizontalHeader()->setFont(font()); // a hidden header would keep the old font
        fitColumns();
    } else if (event->type() == QEvent::PaletteChange) {
        fillCells();
    } else if (event->type() == QEvent::Leave) {
        emit partHovered(MechanismPart::None);
        emit rowHovered(-1);
    }
    return isHandled;
}

bool NumberTable::edit(const QModelIndex &index, EditTrigger trigger, QEvent *event)
{
    const bool isEdited = QTableView::edit(index, trigger, event);
    for (QLineEdit *editor : viewport()->findChildren<QLineEdit *>()) {
        editor->installEventFilter(this);
    }
    return isEdited;
}

/// Selects the whole number on a double click; the editor, which the first click opens, would stop at the decimal
/// point.
bool NumberTable::eventFilter(QObject *watched, QEvent *event)
{
    auto *editor = qobject_cast<QLineEdit *>(watched);
    if (editor && event->type() == QEvent::MouseButtonDblClick) {
        QMetaObject::invokeMethod(editor, &QLineEdit::selectAll, Qt::QueuedConnection);
    }
    return QTableView::eventFilter(watched, event);
}

void NumberTable::keyPressEvent(QKeyEvent *event)
{
    const bool isErasing = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
    if (event->matches(QKeySequence::Copy)) {
        copy();
    } else if (isErasing && isEditableCell(currentIndex())) {
        m_model->setData(currentIndex(), QString(), Qt::DisplayRole);
    } else {
        QTableView::keyPressEvent(event);
    }
}

void NumberTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    if (hasNames()) {
        setColumnWidth(0, widthOfNames());
    }
}

bool NumberTable::isEditableCell(const QModelIndex &index) const
{
    return m_editableRow >= 0 && index.row() == m_editableRow && index.column() >= m_firstEditableColumn;
}

void NumberTable::goToRow(const QModelIndex &index)
{
    if (const std::optional<double> &time = m_rows[static_cast<std::size_t>(index.row())].time) {
        emit timeRequested(*time);
    }
}

} // namespace slidercrank

#include "moc_number_table.cpp"
