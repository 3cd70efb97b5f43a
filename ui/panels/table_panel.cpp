// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/table_panel.h"

#include "ui/document/session.h"
#include "ui/document/whole_file.h"
#include "ui/export/figure_export.h"
#include "ui/text/subscripts.h"
#include "ui/text/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/save_dialog.h"
#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>
#include <chrono>

namespace slidercrank
{

namespace
{

constexpr int kChartWidth = 360;      // px, beside tables
constexpr QSize kChartSize(900, 600); // px, of an exported chart

/// Shows a sentence, in which symbols of textbooks have subscripts.
void showSentence(QLabel &label, const QString &sentence)
{
    const QString text = symbolHtml(withUnbrokenUnits(sentence));
    label.setTextFormat(text.contains("<sub>") ? Qt::RichText : Qt::PlainText);
    label.setText(text);
}

} // namespace

TablePanel::TablePanel(Session *session, const QString &name, const QString &title,
                       const std::function<Page()> &makePage)
    : m_session(session)
    , m_makePage(makePage)
    , m_sentence(named(name + "Sentence", plainText()))
    , m_findings(named("findings", new QWidget))
    , m_scrollArea(new QScrollArea)
    , m_chart(new Chart)
    , m_note(named(name + "Note", plainText()))
{
    named(name, this, title);
    prepareFindings();
    prepareChartAndScrollArea();
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kTabMargins);
    rows->setSpacing(kRowSpacing);
    rows->addLayout(makeHead(name));
    auto *columns = new QHBoxLayout;
    columns->setSpacing(kColumnSpacing);
    columns->addWidget(m_chart, 1);
    columns->addWidget(m_scrollArea, 1);
    rows->addLayout(columns, 1);
    rows->addWidget(m_note);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kReadingTime);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_isStale) {
            refresh();
        }
    });
}

/// Makes the first line: the sentence and the buttons. `name`: that of the panel.
QLayout *TablePanel::makeHead(const QString &name)
{
    auto *head = new QHBoxLayout;
    head->addWidget(m_sentence, 1);
    m_copyButton = addButton(head, name + "Copy", tr("Copy"), tr("Copies the tables as CSV, at full precision"));
    m_exportButton =
        addButton(head, name + "Export", tr("Export…"), tr("Writes the tables to a CSV file, at full precision"));
    connect(m_copyButton, &QToolButton::clicked, this, &TablePanel::copy);
    connect(m_exportButton, &QToolButton::clicked, this, [this] {
        const Page page = m_makePage();
        chooseExport(m_session, this,
                     QStringList(tr("Tables (*.csv)")) + (page.chart ? figureFilters() : QStringList()),
                     accessibleName(), [this](const QString &path) { return exportTo(path); });
    });
    return head;
}

void TablePanel::prepareFindings()
{
    auto *grid = new QGridLayout(m_findings);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(kDenseSpacing);
    grid->setColumnStretch(0, 1);
    m_findings->hide();
}

/// Prepares the chart, and the area with the findings and the tables, which scrolls.
void TablePanel::prepareChartAndScrollArea()
{
    auto *parts = new QWidget;
    auto *content = new QVBoxLayout(parts);
    content->setContentsMargins(0, 0, 0, 0);
    content->setSpacing(kRowSpacing);
    content->addWidget(m_findings);
    m_tablesLayout = new QBoxLayout(QBoxLayout::LeftToRight);
    m_tablesLayout->setSpacing(kColumnSpacing);
    content->addLayout(m_tablesLayout, 1);
    constexpr int kMinChartWidth = 200; // px, for the numbers of its axes
    m_chart->setMinimumWidth(kMinChartWidth);
    m_chart->hide();
    m_scrollArea->setFrameShape(QFrame::NoFrame);
    m_scrollArea->setFocusPolicy(Qt::NoFocus);
    m_scrollArea->setWidgetResizable(true);
    m_scrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scrollArea->setWidget(parts);
}

void TablePanel::refresh()
{
    m_isStale = true;
    if (isVisible() && !m_pause.isActive()) {
        fill();
    }
}

void TablePanel::fill()
{
    m_isStale = false;
    m_pause.start();
    const Page page = m_makePage();
    showSentence(*m_sentence, page.sentence);
    setInk(*m_sentence, toneColour(page.tone, palette()));
    showSentence(*m_note, page.note);
    m_note->setVisible(!page.note.isEmpty());
    m_chart->setVisible(page.chart.has_value());
    if (page.chart) {
        named(page.chart->name, m_chart, page.chart->title);
        m_chart->setContent(page.chart->content);
    }
    fillFindings(page);
    fillTables(page);
    arrange();
}

void TablePanel::fillFindings(const Page &page)
{
    m_findings->setEnabled(!page.isSearching);
    if (page.findings == m_shownFindings) {
        return;
    }
    m_shownFindings = page.findings;
    auto *grid = static_cast<QGridLayout *>(m_findings->layout());
    while (QLayoutItem *item = grid->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // one of the widgets may be the button that was just clicked
        delete item;
    }
    m_findings->setVisible(!m_shownFindings.empty());
    int row = 0;
    for (const Finding &finding : m_shownFindings) {
        QLabel *label = named("findingLabel", plainText());
        showSentence(*label, finding.sentence);
        grid->addWidget(label, row, 0);
        if (finding.remedy != Remedy::None) {
            auto *button = named("remedyButton", new QPushButton(finding.remedyText),
                                 tr("%1: %2").arg(finding.remedyText, finding.sentence));
            button->setToolTip(finding.details);
            button->setFocusPolicy(Qt::TabFocus); // the button disappears when clicked and must not have the focus then
            grid->addWidget(button, row, 1, Qt::AlignTop);
            connect(button, &QPushButton::clicked, this, [this, finding] { emit remedyRequested(finding); });
        }
        ++row;
    }
}

NumberTable *TablePanel::tableFor(const PageTable &content)
{
    auto *table = findChild<NumberTable *>(content.name);
    if (!table) {
        table = new NumberTable(content.name, content.title, content.columns);
        table->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored); // arrange() sets its minimum height
        m_tablesLayout->addWidget(table, 1);
        connect(table, &NumberTable::timeRequested, this, &TablePanel::timeRequested);
        connect(table, &NumberTable::partHovered, this, &TablePanel::partHovered);
        connect(table, &NumberTable::copied, this, &TablePanel::confirmCopied);
        connect(table->selectionModel(), &QItemSelectionModel::currentChanged, this,
                [this, table](const QModelIndex &index) {
                    const QRect row = table->visualRect(index);
                    const QPoint centre = table->viewport()->mapTo(m_scrollArea->widget(), row.center());
                    m_scrollArea->ensureVisible(centre.x(), centre.y(), 0, row.height());
                });
    }
    return table;
}

void TablePanel::fillTables(const Page &page)
{
    m_shownTables.clear();
    for (const PageTable &content : page.tables) {
        NumberTable *table = tableFor(content);
        table->setColumns(content.columns);
        table->setRows(content.rows);
        if (!content.rows.empty()) {
            m_shownTables.push_back(table);
        }
    }
    for (NumberTable *table : findChildren<NumberTable *>()) { // also the tables of earlier pages
        table->setVisible(std::ranges::count(m_shownTables, table) > 0);
    }
    m_copyButton->setVisible(!m_shownTables.empty());
    m_exportButton->setVisible(!m_shownTables.empty());
}

/// Arranges the tables and the chart. Several tables scroll together; a single table scrolls below its headings. The
/// rest of the width is for the chart.
void TablePanel::arrange()
{
    constexpr int kScrollBar = 20; // px
    constexpr int kMinRows = 5;    // of a single table, with its headings: fewer rows could not be read
    const bool hasSeveralTables = m_shownTables.size() > 1;
    const int availableWidth = std::max(1, contentsRect().width() - (m_chart->isHidden() ? 0 : kChartWidth));
    int widthSum = 0;
    int widest = 0;
    for (NumberTable *table : m_shownTables) {
        const QSize content = table->contentSize();
        widthSum += content.width() + m_tablesLayout->spacing();
        widest = std::max(widest, content.width());
        table->setVerticalScrollBarPolicy(hasSeveralTables ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
        const int minHeight = kMinRows * table->verticalHeader()->defaultSectionSize();
        table->setMinimumSize(1, hasSeveralTables ? content.height() : std::min(content.height(), minHeight));
    }
    const bool areSideBySide = widthSum <= availableWidth || !hasSeveralTables;
    m_tablesLayout->setDirection(areSideBySide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_scrollArea->setMinimumWidth(
        m_chart->isHidden() ? 1 : std::min((areSideBySide ? widthSum : widest) + kScrollBar, availableWidth));
}

void TablePanel::copy()
{
    QApplication::clipboard()->setText(QString::fromUtf8(csvOf(m_makePage())));
    confirmCopied();
}

void TablePanel::confirmCopied()
{
    m_session->confirm(tr("The rows are in the clipboard, as CSV with headings."));
}

std::optional<QString> TablePanel::exportTo(const QString &path) const
{
    const Page page = m_makePage();
    if (!path.endsWith(".csv", Qt::CaseInsensitive) && page.chart) {
        Chart chart; // the one on screen may have no content yet
        chart.setContent(page.chart->content);
        return exportFigure(path, {kChartSize, 2.0}, page.chart->title, [&chart](QPainter &painter, const QSize &size) {
            chart.paint(painter, size, paletteFor(Theme::Light));
        });
    }
    return writeWhole(path, csvOf(page));
}

void TablePanel::showEvent(QShowEvent *event)
{
    if (m_isStale) {
        fill();
    }
    QWidget::showEvent(event);
}

void TablePanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    emit partHovered(MechanismPart::None);
}

void TablePanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void TablePanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        refresh();
    }
}

QToolButton *addButton(QBoxLayout *row, const QString &name, const QString &text, const QString &explanation)
{
    auto *button = named(name, new QToolButton);
    button->setText(text);
    button->setToolTip(explanation);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button, 0, Qt::AlignTop);
    return button;
}

QToolButton *makeMenuButton(const QString &name, const QString &text, const QString &explanation)
{
    auto *button = named(name, new QToolButton, text);
    button->setText(text);
    button->setToolTip(explanation);
    button->setFocusPolicy(Qt::TabFocus);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(new QMenu(button));
    return button;
}

void chooseExport(Session *session, QWidget *parent, const QStringList &filters, const QString &name,
                  const std::function<std::optional<QString>(const QString &path)> &write)
{
    chooseFileToSave(parent, {TablePanel::tr("Export"), filters, name, [=](const QString &path, const QString &) {
                                  session->reportWritten(path, write(path));
                              }});
}

QByteArray csvOf(const Page &page)
{
    QByteArray text;
    QByteArray headingsBefore;
    for (const PageTable &table : page.tables) {
        const QByteArray csv = csvText(table.columns, table.rows);
        const QByteArray headings = csv.left(csv.indexOf('\n') + 1);
        text += headings == headingsBefore ? csv.sliced(headings.size()) : csv;
        headingsBefore = headings;
    }
    return text;
}

} // namespace slidercrank

#include "moc_table_panel.cpp"
