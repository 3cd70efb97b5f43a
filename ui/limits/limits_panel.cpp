// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/limits_panel.h"

#include "core/limits/extremes.h"
#include "ui/controls/paragraph.h"
#include "ui/words/motion_facts.h"

#include <QAbstractTableModel>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace slidercrank
{

namespace
{

enum Column { Name, Value, Angle, Instant };
constexpr int kColumnCount = 4;
constexpr int kBetweenTables = 12; // px
constexpr int kAir = 12;           // px, about a text in its cell
constexpr Qt::Alignment kNameAlignment = Qt::AlignLeft | Qt::AlignVCenter;
constexpr Qt::Alignment kNumberAlignment = Qt::AlignRight | Qt::AlignVCenter;

Qt::Alignment alignmentOf(int column)
{
    return column == Name ? kNameAlignment : kNumberAlignment;
}

/// A line of text and no more: a row is painted at every move of a slider, and the general delegate takes ten times as
/// long.
class LineDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        constexpr int kMargin = 4;
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        const bool leadsSomewhere = index.column() == Instant && index.data(Qt::UserRole).isValid();
        if (selected) {
            painter->fillRect(option.rect, option.palette.brush(QPalette::Highlight));
        } else if (index.row() % 2 == 1) {
            painter->fillRect(option.rect, option.palette.brush(QPalette::AlternateBase));
        }
        const QPalette::ColorRole role = selected         ? QPalette::HighlightedText
                                         : leadsSomewhere ? QPalette::Link
                                                          : QPalette::Text;
        painter->setPen(option.palette.color(role));
        painter->drawText(option.rect.adjusted(kMargin, 0, -kMargin, 0),
                          static_cast<int>(alignmentOf(index.column())) | Qt::TextSingleLine,
                          index.data(Qt::DisplayRole).toString());
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
        }
    }
};

} // namespace

/// The facts as a table; the instant of a row is the UserRole of each of its cells.
class FactModel : public QAbstractTableModel
{
public:
    struct Header {
        QString text;
        QString explanation;
    };

    FactModel(std::array<Header, kColumnCount> headers, QObject *parent)
        : QAbstractTableModel(parent)
        , m_headers(std::move(headers))
    {
    }

    /// Only the cells whose text changes are painted anew.
    void setFacts(std::vector<MotionFact> facts, double runLength)
    {
        const bool sameRows =
            std::equal(facts.begin(), facts.end(), m_facts.begin(), m_facts.end(),
                       [](const MotionFact &one, const MotionFact &other) { return one.name == other.name; });
        if (!sameRows) {
            beginResetModel();
        }
        std::swap(m_facts, facts);
        std::swap(m_runLength, runLength);
        if (!sameRows) {
            endResetModel();
            return;
        }
        for (int row = 0; row < rowCount(); ++row) {
            const MotionFact &before = facts[static_cast<std::size_t>(row)];
            for (const Column column : {Value, Angle, Instant}) {
                if (textOf(before, column, runLength) != textOf(fact(row), column, m_runLength)) {
                    emit dataChanged(index(row, column), index(row, column));
                }
            }
        }
    }

    const MotionFact &fact(int row) const { return m_facts[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_facts.size());
    }

    int columnCount(const QModelIndex &parent = {}) const override { return parent.isValid() ? 0 : kColumnCount; }

    QVariant data(const QModelIndex &index, int role) const override
    {
        const MotionFact &shown = fact(index.row());
        switch (role) {
        case Qt::DisplayRole: {
            const bool repeated = index.row() > 0 && fact(index.row() - 1).name == shown.name;
            const auto column = static_cast<Column>(index.column());
            return column == Name && repeated ? QString() : textOf(shown, column, m_runLength);
        }
        case Qt::AccessibleTextRole: return index.column() == Name ? QVariant(shown.name) : QVariant();
        case Qt::ToolTipRole:
            if (!shown.theta2) {
                return shown.explanation;
            }
            return QStringLiteral("%1\n%2").arg(shown.explanation,
                                                shown.instant ? LimitsPanel::tr("Click or press Enter to go there")
                                                              : LimitsPanel::tr("The run does not come there"));
        case Qt::UserRole: return shown.instant ? QVariant(*shown.instant) : QVariant();
        default: return {};
        }
    }

    QVariant headerData(int section, Qt::Orientation orientation, int role) const override
    {
        if (orientation == Qt::Vertical) {
            return {};
        }
        const Header &header = m_headers[static_cast<std::size_t>(section)];
        switch (role) {
        case Qt::DisplayRole: return header.text;
        case Qt::ToolTipRole: return header.explanation;
        case Qt::TextAlignmentRole: return static_cast<int>(alignmentOf(section));
        default: return {};
        }
    }

private:
    static QString textOf(const MotionFact &shown, Column column, double runLength)
    {
        switch (column) {
        case Name: return shown.name;
        case Value: return shown.value;
        case Angle: return shown.theta2 ? crankAngleText(*shown.theta2) : shown.remark;
        case Instant: return shown.instant ? secondsText(*shown.instant, runLength) : QStringLiteral("–");
        }
        return {};
    }

    std::array<Header, kColumnCount> m_headers;
    std::vector<MotionFact> m_facts;
    double m_runLength = 1.0;
};

namespace
{

/// A remark takes the room of angle and instant.
void spanRemarks(QTableView &table, const FactModel &model)
{
    for (int row = 0; row < model.rowCount(); ++row) {
        const int columns = model.fact(row).theta2 ? 1 : 2;
        if (table.columnSpan(row, Angle) != columns) {
            table.setSpan(row, Angle, 1, columns);
        }
    }
}

/// Wide enough for the usual numbers and for the longest there is, so that nothing moves while a slider does.
void fitColumns(QTableView &table, const FactModel &model)
{
    const std::array<QString, kColumnCount> usual{QString(), QStringLiteral("-0000.00 mm/s²"), QStringLiteral("000.00"),
                                                  QStringLiteral("0.0000")};
    for (const int column : {Value, Angle, Instant}) {
        QString longest = usual[static_cast<std::size_t>(column)];
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString text = model.index(row, column).data().toString();
            if ((column == Value || model.fact(row).theta2) && text.size() > longest.size()) {
                longest = text;
            }
        }
        const int width = table.fontMetrics().horizontalAdvance(longest) + kAir;
        if (table.columnWidth(column) != width) {
            table.setColumnWidth(column, width);
        }
    }
}

/// Of the columns, each as wide as it has to be.
int neededWidth(const QTableView &table, const FactModel &model)
{
    QString longest;
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.fact(row).name.size() > longest.size()) {
            longest = model.fact(row).name;
        }
    }
    const int name = table.fontMetrics().horizontalAdvance(longest) + kAir;
    return name + table.columnWidth(Value) + table.columnWidth(Angle) + table.columnWidth(Instant);
}

void setHeights(QTableView &table)
{
    table.horizontalHeader()->setFixedHeight(table.horizontalHeader()->sizeHint().height());
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 3);
}

} // namespace

LimitsPanel::LimitsPanel(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("limitsPanel"));
    setAccessibleName(tr("Motion limits"));
    m_sentence = new Paragraph;
    m_sentence->setObjectName(QStringLiteral("mobilityLabel"));
    m_sentence->setTextFormat(Qt::PlainText);

    const FactModel::Header value{tr("value"), tr("Positions are Rₓ⁴, those of the slider")};
    const FactModel::Header angle{tr("θ₂ [°]"), tr("Crank angle, 0 to 360°")};
    const FactModel::Header instant{tr("t [s]"), tr("The first instant of the run with the crank there")};
    m_positions = new FactModel(
        {FactModel::Header{tr("limit"), tr("Where slider and crank turn back, and how long the strokes take")}, value,
         angle, instant},
        this);
    m_peaks = new FactModel(
        {FactModel::Header{tr("peak of a turn"), tr("The largest speeds and accelerations over a whole turn of the "
                                                    "crank, whatever part of it is sampled")},
         {tr("value"), tr("With its sign: x to the right, angles counter-clockwise")},
         angle,
         instant},
        this);
    m_positionTable = createTable(m_positions, QStringLiteral("positionTable"), tr("Limits of the motion"));
    m_peakTable = createTable(m_peaks, QStringLiteral("peakTable"), tr("Peaks of speed and acceleration"));

    auto *page = new QWidget;
    m_tables = new QBoxLayout(QBoxLayout::LeftToRight, page);
    m_tables->setContentsMargins(0, 0, 0, 0);
    m_tables->setSpacing(kBetweenTables);
    m_tables->addWidget(m_positionTable, 1);
    m_tables->addWidget(m_peakTable, 1);
    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(page);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 6, 6, 4);
    rows->setSpacing(4);
    rows->addWidget(m_sentence);
    rows->addWidget(m_scroll, 1);
}

QTableView *LimitsPanel::createTable(FactModel *model, const QString &name, const QString &title)
{
    auto *table = new QTableView;
    table->setObjectName(name);
    table->setAccessibleName(title);
    table->setModel(model);
    table->setItemDelegate(new LineDelegate(table));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setWordWrap(false);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // they scroll together
    table->setMinimumWidth(1);
    table->verticalHeader()->hide();
    table->verticalHeader()->setMinimumSectionSize(1);
    setHeights(*table);
    QHeaderView *header = table->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(1);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(Name, QHeaderView::Stretch);

    const auto go = [this, model](const QModelIndex &index) {
        if (const std::optional<double> instant = model->fact(index.row()).instant) {
            emit timeRequested(*instant);
        }
    };
    connect(table, &QTableView::clicked, this, go);
    connect(table, &QTableView::activated, this, go);
    connect(table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this, table](const QModelIndex &index) {
                const QRect row = table->visualRect(index);
                const QPoint centre = table->viewport()->mapTo(m_scroll->widget(), row.center());
                m_scroll->ensureVisible(centre.x(), centre.y(), 0, row.height());
            });
    return table;
}

void LimitsPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_result = result;
    showLater();
}

void LimitsPanel::showLater()
{
    m_stale = m_result != nullptr;
    if (m_stale && isVisible()) {
        fill();
    }
}

void LimitsPanel::showEvent(QShowEvent *event)
{
    if (m_stale) {
        fill();
    }
    QWidget::showEvent(event);
}

void LimitsPanel::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::FontChange) {
        setHeights(*m_positionTable);
        setHeights(*m_peakTable);
        showLater();
    } else if (event->type() == QEvent::LocaleChange) {
        showLater();
    }
    QWidget::changeEvent(event);
}

void LimitsPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void LimitsPanel::fill()
{
    m_stale = false;
    const Mechanism &mechanism = m_result->mechanism;
    const MotionLimits &limits = m_result->limits;
    const Sampling &run = m_result->sampling;
    const std::vector<Peak> peaks = motionPeaks(mechanism);
    m_sentence->setText(mobilitySentence(mechanism, limits));
    m_positions->setFacts(positionFacts(mechanism, limits, run), run.duration);
    m_peaks->setFacts(peakFacts(mechanism, limits, peaks, run), run.duration);
    for (const auto &[table, model] : {std::pair{m_positionTable, m_positions}, std::pair{m_peakTable, m_peaks}}) {
        table->setVisible(model->rowCount() > 0);
        spanRemarks(*table, *model);
        fitColumns(*table, *model);
    }
    arrange();
}

void LimitsPanel::arrange()
{
    int needed = 0;
    for (const auto &[table, model] : {std::pair{m_positionTable, m_positions}, std::pair{m_peakTable, m_peaks}}) {
        needed = std::max(needed, neededWidth(*table, *model));
        const int rows = model->rowCount() * table->verticalHeader()->defaultSectionSize();
        table->setMinimumHeight(table->horizontalHeader()->height() + rows);
    }
    const bool sideBySide = m_scroll->width() >= 2 * needed + kBetweenTables;
    m_tables->setDirection(sideBySide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

} // namespace slidercrank
