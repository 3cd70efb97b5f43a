// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/reference_panel.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"
#include "ui/panels/empty_page.h"
#include "ui/text/column_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

enum Column { Heading, Unit, Meaning, RoundedTo, Values, Why };
constexpr int kAir = 6; // px, beside what a column holds

/// What the left of the panel shows; the findings are beside it where there is room.
enum View { ColumnsView, SkippedView, FindingsView };
constexpr int kBesideEachOther = 800; // px of width: less is too narrow for two

/// A table to read; what does not fit into its last column is wrapped.
NumberTable *tableToRead(const QString &name, const QString &title, std::vector<TableColumn> columns)
{
    for (TableColumn &column : columns) {
        column.isNumber = false;
    }
    auto *table = new NumberTable(name, title, std::move(columns), TableLook::Striped);
    table->setWordWrap(true);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

/// With the texts as tool tips, where a column is too narrow for them.
TableRow rowOfTexts(const QStringList &texts)
{
    TableRow row;
    for (const QString &text : texts) {
        row.cells.push_back({.text = text, .explanation = text});
    }
    return row;
}

/// A text with a button beside it.
QLayout *rowOf(QLabel *text, QPushButton *button)
{
    auto *row = new QHBoxLayout;
    row->addWidget(text, 1);
    row->addWidget(button, 0, Qt::AlignTop);
    return row;
}

} // namespace

ReferencePanel::ReferencePanel(QWidget *parent)
    : QWidget(parent)
{
    named("referencePanel", this, tr("Reference: what was read, and how"));
    m_pages = new QStackedWidget;
    m_pages->addWidget(
        emptyPage(this, tr("Load a simulation's exported motion (CSV): here it says what was read from the file "
                           "and how, which mechanism the motion belongs to, and by which other reading it would "
                           "come nearer. A file can also be dropped anywhere in the window.")));
    m_pages->addWidget(createFilePage());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
}

QSize ReferencePanel::minimumSizeHint() const
{
    return {300, 120}; // the rest scrolls
}

QWidget *ReferencePanel::createFilePage()
{
    m_name = named("fileLabel", boldLabel({}));
    m_name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_name->installEventFilter(this);
    auto *columns = named("columnsButton", new QPushButton(tr("Choose columns…")));
    columns->setToolTip(tr("Say what the columns of the file are"));
    connect(columns, &QPushButton::clicked, this, &ReferencePanel::columnsRequested);
    m_form = named("formLabel", plainText());
    m_abscissa = named("abscissaBox", new QComboBox, tr("What the first column is"));
    m_abscissa->addItem(tr("First column: time"), QVariant::fromValue(ColumnRole::Time));
    m_abscissa->addItem(tr("First column: crank angle"), QVariant::fromValue(ColumnRole::CrankAngle));
    m_abscissa->setToolTip(
        tr("Whether the rows are by time or by crank angle; from the angle, ω₂ and θ₂₀ give the time"));
    connect(m_abscissa, &QComboBox::activated, this, [this](int index) {
        showAbscissa(); // it may be refused
        emit abscissaRequested(m_abscissa->itemData(index).value<ColumnRole>());
    });

    QWidget *tables = createTables();
    auto *head = new QHBoxLayout;
    head->addWidget(m_name, 1);
    for (QAbstractButton *button : m_choice->buttons()) {
        head->addWidget(button);
    }
    head->addWidget(columns);
    auto *file = new QVBoxLayout;
    file->setSpacing(4);
    file->addLayout(head);
    auto *form = new QHBoxLayout;
    form->addWidget(m_form, 1);
    form->addWidget(m_abscissa, 0, Qt::AlignTop);
    file->addLayout(form);
    file->addWidget(tables, 1);

    auto *room = new QWidget;
    m_findingsRoom = new QVBoxLayout(room);
    m_findingsRoom->setContentsMargins(8, 0, 4, 0);
    m_findingsArea =
        named("findings", new QScrollArea, tr("Which mechanism the file belongs to, and how else it may be read"));
    m_findingsArea->setWidgetResizable(true);
    m_findingsArea->setFrameShape(QFrame::NoFrame);
    m_findingsArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_findingsArea->setWidget(room);

    auto *page = new QWidget;
    m_halves = new QHBoxLayout(page);
    m_halves->setContentsMargins(6, 6, 6, 4);
    m_halves->addLayout(file, 5);
    m_halves->addWidget(m_findingsArea, 3);
    return page;
}

QWidget *ReferencePanel::createTables()
{
    m_columns = tableToRead(QStringLiteral("columnTable"), tr("Columns of the file, a row a column"),
                            {{tr("heading"), {}, QStringLiteral("heading")},
                             {tr("unit"), {}, QStringLiteral("unit")},
                             {tr("read as"), {}, QStringLiteral("read_as")},
                             {tr("rounded to"), tr("How the file rounded this column, inferred from all its values"),
                              QStringLiteral("rounded_to")},
                             {tr("values"), {}, QStringLiteral("values")},
                             {tr("why"), {}, QStringLiteral("why")}});
    m_skipped = tableToRead(QStringLiteral("skippedTable"), tr("Rows of the file that were left out"),
                            {{tr("line"), {}, QStringLiteral("line")},
                             {tr("column"), {}, QStringLiteral("column")},
                             {tr("text"), {}, QStringLiteral("text")},
                             {tr("why it was left out"), {}, QStringLiteral("why")}});
    for (const NumberTable *table : {m_columns, m_skipped}) {
        connect(table, &NumberTable::copied, this, &ReferencePanel::rowsCopied);
    }
    m_tables = new QStackedWidget;
    m_tables->addWidget(m_columns);
    m_tables->addWidget(m_skipped);

    m_choice = new QButtonGroup(this);
    for (const auto &[name, text] : {std::pair{"showColumns", tr("Columns")}, std::pair{"showSkipped", QString()},
                                     std::pair{"showFindings", tr("Its mechanism")}}) {
        auto *button = named(name, new QToolButton);
        button->setText(text);
        button->setCheckable(true);
        button->setAutoRaise(true);
        m_choice->addButton(button, static_cast<int>(m_choice->buttons().size()));
    }
    connect(m_choice, &QButtonGroup::idClicked, this, &ReferencePanel::showView);
    return m_tables;
}

/// Puts the findings beside the tables, or among them; what there is nothing to see of is not offered.
void ReferencePanel::arrange()
{
    const bool beside = width() >= kBesideEachOther;
    const bool isBeside = m_halves->indexOf(m_findingsArea) >= 0;
    if (beside && !isBeside) {
        m_halves->addWidget(m_findingsArea, 3);
        m_findingsArea->show();
    } else if (!beside && isBeside) {
        m_tables->addWidget(m_findingsArea);
    }
    const bool skipped = m_reference && !m_reference->data.skipped.empty();
    m_choice->button(ColumnsView)->setVisible(skipped || !beside);
    m_choice->button(SkippedView)->setVisible(skipped);
    m_choice->button(FindingsView)->setVisible(!beside);
    const int view = m_choice->checkedId();
    const bool gone = (view == SkippedView && !skipped) || (view == FindingsView && beside);
    showView(view < 0 || gone ? ColumnsView : view);
}

void ReferencePanel::showView(int view)
{
    m_choice->button(view)->setChecked(true);
    m_tables->setCurrentWidget(view == ColumnsView   ? static_cast<QWidget *>(m_columns)
                               : view == SkippedView ? static_cast<QWidget *>(m_skipped)
                                                     : m_findingsArea);
}

void ReferencePanel::setReference(const std::shared_ptr<const Reference> &reference)
{
    m_reference = reference;
    refill();
}

void ReferencePanel::setDiagnosis(const std::shared_ptr<const ReferenceDiagnosis> &diagnosis)
{
    m_diagnosis = diagnosis;
    if (isVisible() && !m_stale) {
        fillFindings();
    } else {
        m_stale = true;
    }
}

void ReferencePanel::refill()
{
    m_stale = true;
    if (isVisible()) {
        fill();
    }
}

void ReferencePanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void ReferencePanel::showEvent(QShowEvent *event)
{
    if (m_stale) {
        fill();
    }
    QWidget::showEvent(event);
}

void ReferencePanel::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LocaleChange) {
        refill();
    }
    QWidget::changeEvent(event);
}

bool ReferencePanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_name && event->type() == QEvent::Resize) {
        showName();
    }
    return QWidget::eventFilter(watched, event);
}

void ReferencePanel::fill()
{
    m_stale = false;
    m_pages->setCurrentIndex(m_reference ? 1 : 0);
    if (m_reference) {
        fillForm();
        fillColumns();
        fillSkipped();
        arrange();
    }
    fillFindings();
}

void ReferencePanel::showName()
{
    if (!m_reference) {
        return;
    }
    const QStringList &paths = m_reference->paths;
    const bool onDisk = !paths.first().startsWith(QLatin1String(":/")); // the sample is in the program
    const QString name = onDisk && paths.size() == 1 ? shownNameOf(paths) : m_reference->name;
    m_name->setText(m_name->fontMetrics().elidedText(name, Qt::ElideLeft, m_name->width()));
    m_name->setToolTip(onDisk ? QDir::toNativeSeparators(paths.join(u'\n')) : name);
}

void ReferencePanel::showAbscissa()
{
    const bool byAngle = m_reference && m_reference->data.crank;
    m_abscissa->setCurrentIndex(byAngle ? 1 : 0);
}

void ReferencePanel::fillForm()
{
    showName();
    showAbscissa();
    const ReferenceData &read = m_reference->data;
    QString rows = read.time.size() == 1 ? tr("1 row read") : tr("%1 rows read").arg(countText(read.time.size()));
    if (!read.time.empty()) {
        rows += QStringLiteral(", ") + abscissaText(read);
    }
    m_form->setText(tr("%1. %2.").arg(formText(read.layout), rows));
}

void ReferencePanel::fillColumns()
{
    const ReferenceData &read = m_reference->data;
    const FileLayout &layout = read.layout;
    std::vector<TableRow> rows;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (!layout.files.empty() && (i == 0 || column.file != layout.columns[i - 1].file)) { // from there on its own
            rows.push_back(rowOfTexts({QString::fromUtf8(layout.files[column.file]), {}, {}, {}, {}, {}}));
        }
        if (repeatsInstants(layout, i)) {
            continue;
        }
        QString rounding = dash();
        const bool isAbscissa = column.role == ColumnRole::Time || column.role == ColumnRole::CrankAngle;
        QString values = isAbscissa ? countText(read.time.size()) : dash();
        const ReferenceSeries *series = column.role == ColumnRole::Channel ? read.find(column.channel) : nullptr;
        if (series) {
            rounding = roundingText(series->rounding);
            const auto empty = static_cast<std::size_t>(std::count_if(series->values.begin(), series->values.end(),
                                                                      [](double value) { return std::isnan(value); }));
            values = countText(series->values.size() - empty);
            if (empty > 0) {
                values += empty == 1 ? tr(", 1 gap") : tr(", %1 gaps").arg(countText(empty));
            }
        }
        TableRow row = rowOfTexts({headingAlone(layout, i), unitText(column), meaningText(column), rounding, values,
                                   shortReasonText(layout, i)});
        if (series) {
            row.cells[Meaning].explanation = columnNameOf(column.channel);
        }
        for (TableCell &cell : row.cells) {
            cell.ink = column.role == ColumnRole::Ignored ? palette().color(QPalette::PlaceholderText) : QColor();
        }
        row.cells[Why].explanation = reasonText(layout, i);
        if (isGuess(column.reason)) {
            row.cells[Why].ink = seriesColours(palette()).reference;
        }
        rows.push_back(std::move(row));
    }
    m_columns->setRows(std::move(rows));
    m_columns->fitToContents(kAir, kAir);
}

void ReferencePanel::fillSkipped()
{
    const auto numberOf = [](std::size_t number) { return number == 0 ? QString() : QString::number(number); };
    m_choice->button(SkippedView)
        ->setText(tr("Rows left out (%1)").arg(countText(m_reference->data.skippedRowCount())));
    std::vector<TableRow> rows;
    for (const SkippedRow &row : m_reference->data.skipped) {
        rows.push_back(rowOfTexts({lineText(m_reference->data.layout, row), numberOf(row.column),
                                   QString::fromUtf8(row.text), reasonOf(row)}));
    }
    m_skipped->setRows(std::move(rows));
    m_skipped->fitToContents(kAir, kAir);
}

void ReferencePanel::fillFindings()
{
    const bool hadFocus = m_findings && m_findings->isAncestorOf(focusWidget());
    delete m_findings;
    m_findings = new QWidget;
    auto *rows = new QVBoxLayout(m_findings);
    rows->setContentsMargins(0, 0, 0, 0);
    m_findingsRoom->addWidget(m_findings);
    if (!m_reference) {
        return;
    }
    const auto later = Qt::QueuedConnection; // what follows a click makes all of this anew, the button too

    if (!m_reference->conventions.empty()) {
        rows->addWidget(boldLabel(tr("Read differently from how it is written")));
        const ReferenceData &printed = (m_reference->asPrinted ? m_reference->asPrinted : m_reference)->data;
        QStringList sentences;
        for (const Convention &convention : m_reference->conventions) {
            sentences << explanationOf(convention, printed);
        }
        auto *asPrinted = named("asPrintedButton", new QPushButton(tr("Read as written again")));
        connect(asPrinted, &QPushButton::clicked, this, &ReferencePanel::readAsPrintedRequested, later);
        rows->addLayout(rowOf(plainText(sentences.join(QLatin1Char('\n'))), asPrinted));
    }
    const bool known = m_diagnosis && m_diagnosis->reference == m_reference;
    if (known && !m_diagnosis->found.conventions.empty()) {
        rows->addWidget(boldLabel(tr("How else it may be read")));
        for (const ConventionFinding &finding : m_diagnosis->found.conventions) {
            const QString explanation = explanationOf(finding.convention, m_reference->data);
            auto *apply = named("applyButton", new QPushButton(tr("Apply")));
            apply->setAccessibleName(tr("Apply: %1").arg(explanation));
            connect(
                apply, &QPushButton::clicked, this,
                [this, convention = finding.convention] { emit applyRequested(convention); }, later);
            rows->addLayout(rowOf(plainText(explanation + QLatin1Char('\n') + effectOf(finding)), apply));
        }
    }
    rows->addWidget(boldLabel(tr("Which mechanism it belongs to")));
    if (!known) {
        rows->addWidget(plainText(tr("Searching…")));
    } else {
        QString summary = summaryOf(m_diagnosis->found);
        if (const QString rounded = roundNumbersText(m_diagnosis->found); !rounded.isEmpty()) {
            summary += QLatin1Char('\n') + rounded;
        }
        for (const char *inOneLine : {" = ", " ± ", " mm", " rad/s"}) {
            const QString part = QString::fromUtf8(inOneLine);
            summary.replace(part, QString(part).replace(QLatin1Char(' '), QChar::Nbsp));
        }
        rows->addWidget(named("identificationLabel", plainText(summary)));
        if (const Identification &found = m_diagnosis->found.identification; found.stands()) {
            const bool isOne = found.hasOneMechanism();
            auto *takeOver =
                named("takeOverButton", new QPushButton(isOne ? tr("Use this mechanism") : tr("Use the first")));
            takeOver->setToolTip(tr("Sets the sliders to this mechanism; can be undone"));
            takeOver->setEnabled(m_diagnosis->parameters != m_diagnosis->found.rounded); // else it is the one on show
            connect(takeOver, &QPushButton::clicked, this, &ReferencePanel::takeOverRequested, later);
            rows->addWidget(takeOver, 0, Qt::AlignLeft);
        }
    }
    rows->addStretch(1);
    if (hadFocus) {
        if (auto *first = m_findings->findChild<QPushButton *>()) {
            first->setFocus();
        }
    }
}

} // namespace slidercrank
