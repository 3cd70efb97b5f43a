// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/limits_panel.h"

#include "core/limits/extremes.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/save_dialog.h"
#include "ui/document/whole_file.h"
#include "ui/text/motion_facts.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace slidercrank
{

namespace
{

enum Column { Name, Value, Angle, Instant };
constexpr int kBetweenTables = 12; // px

std::vector<TableRow> rowsOf(const std::vector<MotionFact> &facts, double runLength, const QColor &link)
{
    std::vector<TableRow> rows;
    QString above;
    for (const MotionFact &fact : facts) {
        QString explanation = fact.explanation;
        if (fact.theta2) {
            explanation += u'\n' + (fact.instant ? LimitsPanel::tr("Click or press Enter to go there")
                                                 : LimitsPanel::tr("The run does not come there"));
        }
        std::vector<TableCell> cells;
        for (const QString &text : {fact.name == above ? QString() : fact.name, fact.value,
                                    fact.theta2 ? crankAngleText(*fact.theta2) : fact.remark,
                                    fact.instant ? secondsText(*fact.instant, runLength) : QStringLiteral("–")}) {
            cells.push_back({.text = text, .explanation = explanation});
        }
        cells[Name].spoken = fact.name;
        cells[Name].csv = fact.unit.isEmpty() ? fact.name : QStringLiteral("%1 [%2]").arg(fact.name, fact.unit);
        cells[Value].number = fact.number;
        cells[Instant].number = fact.instant;
        if (fact.theta2) {
            const double degrees = kDegreesPerRadian * *fact.theta2;
            cells[Angle].number = degrees < 0.0 ? degrees + 360.0 : degrees;
        }
        cells[Instant].ink = fact.instant ? link : QColor();
        rows.push_back({MechanismPart::None, std::move(cells), fact.instant});
        above = fact.name;
    }
    return rows;
}

/// A remark takes the room of angle and instant.
void spanRemarks(NumberTable &table, const std::vector<MotionFact> &facts)
{
    for (int row = 0; row < table.model()->rowCount(); ++row) {
        const int columns = facts[static_cast<std::size_t>(row)].theta2 ? 1 : 2;
        if (table.columnSpan(row, Angle) != columns) {
            table.setSpan(row, Angle, 1, columns);
        }
    }
}

QString longestOf(const NumberTable &table, Column column, const QString &usual = {})
{
    QString longest = usual;
    for (int row = 0; row < table.model()->rowCount(); ++row) {
        const QString text = table.model()->index(row, column).data().toString();
        const bool isRemark = column == Angle && table.columnSpan(row, Angle) > 1;
        longest = text.size() > longest.size() && !isRemark ? text : longest;
    }
    return longest;
}

/// Wide enough for the usual numbers and for the longest there is, so that nothing moves while a slider does.
void fitColumns(NumberTable &table)
{
    table.setColumnText(Value, longestOf(table, Value, QStringLiteral("-0000.00 mm/s²")));
    table.setColumnText(Angle, longestOf(table, Angle, QStringLiteral("000.00")));
    table.setColumnText(Instant, longestOf(table, Instant, QStringLiteral("0.0000")));
}

/// Of the columns, each as wide as it has to be.
int neededWidth(const NumberTable &table)
{
    return table.widthFor(longestOf(table, Name)) + table.columnWidth(Value) + table.columnWidth(Angle) +
           table.columnWidth(Instant);
}

} // namespace

LimitsPanel::LimitsPanel(QWidget *parent)
    : QWidget(parent)
{
    named("limitsPanel", this, tr("Motion limits"));
    const QString valueName = QStringLiteral("value");
    const TableColumn value{tr("value"), tr("Positions are those of the slider, Rₓ⁴, measured from O₂"), valueName};
    const TableColumn signedValue{tr("value"), tr("With its sign: x to the right, angles counter-clockwise"),
                                  valueName};
    const TableColumn angle{tr("θ₂ [°]"), tr("Crank angle, 0 to 360°"), QStringLiteral("theta2 [°]")};
    const TableColumn instant{tr("t [s]"), tr("The first instant of the run with the crank there"),
                              QStringLiteral("time [s]")};
    const TableColumn limit{tr("limit"), tr("Where slider and crank turn back, and how long the strokes take"),
                            QStringLiteral("limit"), false};
    const TableColumn peak{tr("peak of a turn"),
                           tr("The largest speeds and accelerations over a whole turn of the "
                              "crank, whatever part of it is sampled"),
                           QStringLiteral("peak"), false};
    m_positions =
        createTable(QStringLiteral("positionTable"), tr("Limits of the motion"), {limit, value, angle, instant});
    m_peaks = createTable(QStringLiteral("peakTable"), tr("Peaks of speed and acceleration"),
                          {peak, signedValue, angle, instant});

    auto *page = new QWidget;
    m_tables = new QBoxLayout(QBoxLayout::LeftToRight, page);
    m_tables->setContentsMargins(0, 0, 0, 0);
    m_tables->setSpacing(kBetweenTables);
    m_tables->addWidget(m_positions, 1);
    m_tables->addWidget(m_peaks, 1);
    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(page);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 2, 6, 0);
    rows->setSpacing(2);
    rows->addLayout(createHead());
    rows->addWidget(m_scroll, 1);
}

QLayout *LimitsPanel::createHead()
{
    m_sentence = named("mobilityLabel", new Paragraph);
    m_sentence->setTextFormat(Qt::PlainText);
    auto *copyButton = named("copyLimitsButton", new QToolButton);
    copyButton->setText(tr("Copy as CSV"));
    copyButton->setToolTip(tr("Both tables with every digit (Ctrl+C in one of them: the rows that are chosen)"));
    connect(copyButton, &QToolButton::clicked, this, &LimitsPanel::copy);
    auto *exportButton = named("exportLimitsButton", new QToolButton);
    exportButton->setText(tr("Export…"));
    exportButton->setToolTip(tr("Both tables as a CSV file"));
    connect(exportButton, &QToolButton::clicked, this, &LimitsPanel::chooseFile);
    auto *head = new QHBoxLayout;
    head->addWidget(m_sentence, 1);
    head->addWidget(copyButton);
    head->addWidget(exportButton);
    return head;
}

QString LimitsPanel::csv()
{
    if (m_stale) {
        fill();
    }
    const QString peaks = m_peaks->csv();
    return m_positions->csv() + peaks.sliced(peaks.indexOf(u'\n') + 1); // one line of names for both
}

void LimitsPanel::copy()
{
    QApplication::clipboard()->setText(csv());
    emit rowsCopied(m_positions->model()->rowCount() + m_peaks->model()->rowCount());
}

std::optional<QString> LimitsPanel::exportCsv(const QString &path)
{
    const std::optional<QString> reason = writeWhole(path, csv().toUtf8());
    return reason ? std::optional(tr("%1 cannot be written: %2.").arg(QDir::toNativeSeparators(path), *reason))
                  : std::nullopt;
}

void LimitsPanel::chooseFile()
{
    chooseFileToSave(this, {tr("Export"),
                            {tr("Tables (*.csv)")},
                            lastFolder(QStandardPaths::DocumentsLocation),
                            tr("limits.csv"),
                            [this](const QString &path, const QString &) {
                                if (const std::optional<QString> problem = exportCsv(path)) {
                                    emit problemFound(*problem);
                                }
                            }});
}

NumberTable *LimitsPanel::createTable(const QString &name, const QString &title, std::vector<TableColumn> columns)
{
    auto *table = new NumberTable(name, title, std::move(columns), TableLook::Striped);
    table->setRowAir(3);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // they scroll together
    table->setMinimumWidth(1);
    connect(table, &NumberTable::instantRequested, this, &LimitsPanel::timeRequested);
    connect(table, &NumberTable::copied, this, &LimitsPanel::rowsCopied);
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
    const QEvent::Type type = event->type();
    if (type == QEvent::FontChange || type == QEvent::LocaleChange || type == QEvent::PaletteChange) {
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
    const QColor link = palette().color(QPalette::Link);
    for (const auto &[table, facts] : {std::pair{m_positions, positionFacts(mechanism, limits, run)},
                                       std::pair{m_peaks, peakFacts(mechanism, limits, peaks, run)}}) {
        table->setRows(rowsOf(facts, run.duration, link));
        table->setVisible(!facts.empty());
        spanRemarks(*table, facts);
        fitColumns(*table);
    }
    arrange();
}

void LimitsPanel::arrange()
{
    int needed = 0;
    for (NumberTable *table : {m_positions, m_peaks}) {
        needed = std::max(needed, neededWidth(*table));
        const int rows = table->model()->rowCount() * table->verticalHeader()->defaultSectionSize();
        table->setMinimumHeight(table->horizontalHeader()->sizeHint().height() + rows);
    }
    const bool sideBySide = m_scroll->width() >= 2 * needed + kBetweenTables;
    m_tables->setDirection(sideBySide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

} // namespace slidercrank
