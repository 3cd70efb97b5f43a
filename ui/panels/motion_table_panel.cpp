// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/motion_table_panel.h"

#include "ui/document/session.h"
#include "ui/document/whole_file.h"
#include "ui/panels/find_line.h"
#include "ui/panels/table_panel.h"
#include "ui/text/notation.h"
#include "ui/text/record.h"
#include "ui/text/subscripts.h"
#include "ui/widgets/enum_box.h"
#include "ui/widgets/named.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/spacing.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>

namespace slidercrank
{

MotionTablePanel::MotionTablePanel(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_step(new NumberBox)
    , m_stepKind(new QComboBox)
    , m_columnsButton(makeMenuButton("tableColumns", tr("Columns"), tr("Chooses the columns of the table")))
    , m_alpha2(new NumberBox)
    , m_constantSpeedNote(named("constantSpeed", plainText(tr("The curves are for a constant speed."))))
    , m_findLine(new FindLine(session))
    , m_answer(named("findAnswer", plainText()))
    , m_conclusion(named("judgement", plainText()))
    , m_layout(new QVBoxLayout(this))
    , m_currentRowLayout(new QHBoxLayout)
{
    named("motionTablePanel", this, tr("Table of the motion"));
    m_settings.columns = usualTableChannels();
    setMinimumWidth(1); // in a narrow window the widest boxes become narrower, instead of the window wider
    m_layout->setContentsMargins(kTabMargins);
    m_layout->setSpacing(kRowSpacing);
    m_layout->addLayout(makeControls());
    m_layout->addWidget(m_constantSpeedNote); // beside the controls of a narrow window it would be a column of letters
    m_layout->addLayout(makeFindAndExportLine());
    m_layout->addWidget(m_answer);
    m_answer->setTextFormat(Qt::RichText);
    m_answer->hide();
    m_layout->addLayout(m_currentRowLayout);
    m_layout->addWidget(m_conclusion);
    m_conclusion->setTextFormat(Qt::RichText);
    makeTables();
    m_pause.setSingleShot(true);
    m_pause.setInterval(kReadingTime);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_isStale) {
            refresh();
        }
    });
    connect(session, &Session::alpha2Changed, this, &MotionTablePanel::showAlpha2);
    connect(session, &Session::resultChanged, this, &MotionTablePanel::refresh);
    connect(session, &Session::timeChanged, this, &MotionTablePanel::showCurrentPosition);
}

QLayout *MotionTablePanel::makeControls()
{
    auto *row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Every")));
    named("tableStep", m_step, tr("Step of the table"));
    m_step->setRange(kShortestTableStep, kLongestTableStep);
    m_step->setValue(m_settings.angleStep);
    row->addWidget(m_step);
    named("tableStepKind", m_stepKind, tr("Unit of the step"));
    addChoice(m_stepKind, TableStep::CrankAngle, tr("°"));
    addChoice(m_stepKind, TableStep::Time, tr("s"));
    row->addWidget(m_stepKind);
    row->addWidget(m_columnsButton);
    auto *label = new QLabel(tr("α₂"));
    row->addWidget(label);
    named("tableAlpha2", m_alpha2, tr("Acceleration of the crank in each row (α₂)"));
    m_alpha2->setToolTip(
        tr("Acceleration of the crank in each row of the table. The curves are for a constant speed."));
    m_alpha2->setSuffix(tr(" rad/s²"));
    m_alpha2->setUnit(kRadianPerSquareSecond);
    label->setBuddy(m_alpha2);
    row->addWidget(m_alpha2);
    m_constantSpeedNote->hide();
    row->addStretch();
    connect(m_step, &NumberBox::edited, this, [this](double step) {
        MotionTableSettings settings = m_settings;
        (settings.step == TableStep::Time ? settings.timeStep : settings.angleStep) = step;
        setSettings(settings);
    });
    connect(m_stepKind, &QComboBox::activated, this, [this] {
        MotionTableSettings settings = m_settings;
        settings.step = chosen<TableStep>(m_stepKind);
        setSettings(settings);
    });
    connect(m_alpha2, &NumberBox::edited, m_session, &Session::setAlpha2);
    return row;
}

QLayout *MotionTablePanel::makeFindAndExportLine()
{
    auto *row = new QHBoxLayout;
    row->addWidget(m_findLine, 1);
    connect(addButton(row, "motionTableCopy", tr("Copy"), tr("Copies the rows as CSV")), &QToolButton::clicked, this,
            &MotionTablePanel::copy);
    QToolButton *button = makeMenuButton("motionTableExport", tr("Export"), tr("Writes the rows to a CSV file"));
    fillExportMenu(button);
    row->addWidget(button);
    connect(m_findLine, &FindLine::timeRequested, this, &MotionTablePanel::timeRequested);
    connect(m_findLine, &FindLine::answered, this, [this](const QString &text) {
        m_answer->setText(text);
        m_answer->setVisible(!text.isEmpty());
    });
    return row;
}

void MotionTablePanel::fillColumnsMenu()
{
    QMenu *menu = m_columnsButton->menu();
    menu->clear();
    for (const OutputChannel &channel : tableChannels()) {
        QAction *action = menu->addAction(nameText(channel));
        action->setObjectName("column_" + columnName(channel));
        action->setCheckable(true);
        action->setChecked(std::ranges::count(m_settings.columns, channel) > 0);
        connect(action, &QAction::triggered, this, [this, channel](bool isWanted) {
            MotionTableSettings settings = m_settings;
            std::erase(settings.columns, channel);
            if (isWanted) {
                settings.columns.push_back(channel);
            }
            setSettings(settings);
        });
    }
}

void MotionTablePanel::fillExportMenu(QToolButton *button)
{
    QMenu *menu = button->menu();
    menu->addAction(tr("Write to a file…"), this, [this] {
        chooseExport(m_session, this, QStringList(tr("Tables (*.csv)")), tr("table"),
                     [this](const QString &path) { return exportTo(path); });
    });
    menu->addSeparator();
    const auto addSwitch = [this, menu](const char *name, const QString &text, bool CsvStyle::*member) {
        QAction *action = menu->addAction(text);
        action->setObjectName(name);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [this, member](bool isOn) {
            CsvStyle style = m_style;
            style.*member = isOn;
            setCsvStyle(style);
        });
        connect(menu, &QMenu::aboutToShow, action, [this, action, member] { action->setChecked(m_style.*member); });
    };
    addSwitch("everyDigit", tr("All digits instead of six"), &CsvStyle::hasEveryDigit);
    addSwitch("localSeparators", tr("Decimal sign and delimiter of the language"), &CsvStyle::isLocal);
}

void MotionTablePanel::setSettings(const MotionTableSettings &settings)
{
    std::vector<OutputChannel> columns = tableChannels();
    std::erase_if(columns, [&settings](const OutputChannel &channel) {
        return std::ranges::count(settings.columns, channel) == 0;
    });
    const bool hasOtherColumns = columns != m_settings.columns;
    m_settings = settings;
    m_settings.columns = columns;
    const bool isTime = settings.step == TableStep::Time;
    choose(m_stepKind, settings.step);
    m_step->setValue(isTime ? settings.timeStep : settings.angleStep);
    m_step->setUnit(isTime ? kSecond : kDegree);
    if (hasOtherColumns) {
        makeTables();
    }
    showRows();
}

void MotionTablePanel::setCsvStyle(const CsvStyle &style)
{
    m_style = style;
    setCsvSeparators(style.isLocal ? CsvSeparators::OfLanguage : CsvSeparators::Standard);
}

void MotionTablePanel::offerTextbookNotation()
{
    auto *offer = named("notationOffer", new QWidget);
    auto *row = new QHBoxLayout(offer);
    row->setContentsMargins(0, 0, 0, 0);
    auto *question =
        new QLabel(tr("θ₃ measured at B, and x<sub>B</sub>, v<sub>B</sub>, a<sub>B</sub>, as in textbooks?"));
    question->setWordWrap(true);
    question->setMinimumHeight(1); // by default it is as high as the text in its narrowest form
    row->addWidget(question, 1);
    const auto addAnswer = [&](const QString &name, const QString &text, Symbols symbols) {
        auto *button = named(name, new QPushButton(text));
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, offer, symbols] {
            offer->deleteLater();
            emit symbolsChosen(symbols);
        });
    };
    addAnswer("textbookNotation", tr("Use this notation"), Symbols::Textbook);
    addAnswer("absoluteCoordinates", tr("Keep θ³, Rₓ⁴"), Symbols::AbsoluteCoordinates);
    m_layout->insertWidget(0, offer);
}

void MotionTablePanel::refreshNotation()
{
    if (auto *offer = findChild<QWidget *>("notationOffer"); offer && notation().symbols == Symbols::Textbook) {
        offer->deleteLater(); // it was chosen elsewhere
    }
    m_findLine->refreshNotation();
    makeTables();
    showRows();
}

/// Makes the tables for the chosen columns and notation. The current position has a table of its own, so that it stays
/// while the rows scroll.
void MotionTablePanel::makeTables()
{
    delete m_currentRowTable;
    delete m_table;
    const std::vector<TableColumn> columns = motionTableColumns(m_settings);
    m_table = new NumberTable("motionTable", tr("Table of the motion"), columns);
    m_currentRowTable = new NumberTable("presentPosition", tr("Present position"), columns);
    arrangeTable();
    arrangeCurrentRow();
    connectTables();
    fillColumnsMenu();
}

void MotionTablePanel::arrangeTable()
{
    constexpr int kMinRows = 2; // stay visible where the panel itself scrolls
    m_table->horizontalHeader()->hide();
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // so that m_currentRowLayout can reserve its width
    m_table->setSizePolicy(QSizePolicy::Preferred,
                           QSizePolicy::Ignored); // the panel may become as low as its other widgets need
    m_table->setMinimumHeight(kMinRows * m_table->verticalHeader()->defaultSectionSize());
    m_layout->addWidget(m_table, 1);
}

void MotionTablePanel::arrangeCurrentRow()
{
    constexpr int kMyValuesRow = 1; // below the current position
    constexpr int kNoHeight = 1;    // until alignColumns() knows the rows; a higher table would make the tabs higher
    m_currentRowTable->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_currentRowTable->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_currentRowTable->setFixedHeight(kNoHeight);
    m_currentRowTable->setEditable(kMyValuesRow, kFirstChannelColumn);
    m_currentRowTable->horizontalHeader()->setSectionResizeMode(
        QHeaderView::Fixed);                                             // alignColumns() chooses the widths
    m_currentRowTable->setSelectionMode(QAbstractItemView::NoSelection); // it would hide the colours of the verdicts
    m_currentRowLayout->setContentsMargins(0, 0, m_table->verticalScrollBar()->sizeHint().width(), 0);
    m_currentRowLayout->addWidget(m_currentRowTable);
}

void MotionTablePanel::connectTables()
{
    connect(m_currentRowTable, &NumberTable::typed, this, [this](int column, const QString &text) {
        const OutputChannel channel = m_settings.columns[static_cast<std::size_t>(column - kFirstChannelColumn)];
        m_myValues.setText(currentPosition().theta2, channel, text.trimmed());
        QMetaObject::invokeMethod(this, &MotionTablePanel::showCurrentPosition,
                                  Qt::QueuedConnection); // after the cell is closed
    });
    connect(m_table->horizontalScrollBar(), &QScrollBar::valueChanged, m_currentRowTable->horizontalScrollBar(),
            &QScrollBar::setValue);
    connect(m_table, &NumberTable::timeRequested, this, &MotionTablePanel::timeRequested);
    connect(m_table, &NumberTable::rowHovered, this, [this](int row) {
        const bool isRow = row >= 0 && row < static_cast<int>(m_positions.size());
        emit positionHovered(isRow ? std::optional(m_positions[static_cast<std::size_t>(row)].theta2) : std::nullopt);
    });
    for (NumberTable *table : {m_currentRowTable, m_table}) {
        connect(table, &NumberTable::copied, this,
                [this] { m_session->confirm(tr("The rows are in the clipboard, as CSV with headings.")); });
    }
}

void MotionTablePanel::refresh()
{
    m_isStale = true;
    if (isVisible() && !m_pause.isActive()) {
        m_pause.start();
        showRows();
    }
}

void MotionTablePanel::showRows()
{
    m_isStale = false;
    const Mechanism &mechanism = m_session->result()->mechanism;
    m_positions = tablePositions(m_settings, mechanism, m_session->result()->sampling);
    m_rows.clear();
    for (const TablePosition &position : m_positions) {
        m_rows.push_back(motionTableRow(m_settings, mechanism, m_session->alpha2(), position));
    }
    m_table->setRows(m_rows);
    showCurrentPosition();
    alignColumns();
}

void MotionTablePanel::showAlpha2()
{
    m_alpha2->setValue(m_session->alpha2());
    m_constantSpeedNote->setVisible(m_session->alpha2() != 0.0);
}

void MotionTablePanel::showCurrentPosition()
{
    if (isVisible()) {
        const Mechanism mechanism(m_session->parameters());
        TableRow row = motionTableRow(m_settings, mechanism, m_session->alpha2(), currentPosition());
        constexpr std::size_t kTimeColumn = 0;
        row.cells[kTimeColumn].tone = Tone::Normal; // the time is no link here
        row.time.reset();                           // the row would link to its own time
        const CrankPosition position{withCrankAt(mechanism, currentPosition().theta2), m_session->alpha2()};
        const MyValues::CheckedRow checked = m_myValues.check(position, m_settings.columns);
        m_currentRowTable->setRows({row, checked.row});
        m_conclusion->setVisible(!checked.conclusion.isEmpty());
        m_conclusion->setText(subscriptHtml(checked.conclusion));
        alignColumns();
        deselectOtherPosition();
    }
}

/// Deselects the row that was clicked once the crank is at a different position. Several rows, which a person selects
/// to copy them, stay selected.
void MotionTablePanel::deselectOtherPosition()
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    if (rows.size() == 1 &&
        !isSamePosition(m_positions[static_cast<std::size_t>(rows.front().row())].theta2, currentPosition().theta2)) {
        m_table->clearSelection();
    }
}

/// Gives the columns of both tables the same widths.
void MotionTablePanel::alignColumns()
{
    for (int column = 0; column < m_table->horizontalHeader()->count(); ++column) {
        const int width = std::max(m_currentRowTable->columnWidth(column), m_table->columnWidth(column));
        m_currentRowTable->setColumnWidth(column, width);
        m_table->setColumnWidth(column, width);
    }
    constexpr int kFrame = 2; // px, above and below the rows
    m_currentRowTable->setFixedHeight(m_currentRowTable->contentSize().height() + kFrame);
}

TablePosition MotionTablePanel::currentPosition() const
{
    return {.theta2 = m_session->pose().motion.theta2, .time = m_session->time()};
}

QByteArray MotionTablePanel::csv() const
{
    return csvText(motionTableColumns(m_settings), m_rows, m_style);
}

std::optional<QString> MotionTablePanel::exportTo(const QString &path) const
{
    return writeWhole(path, csv());
}

void MotionTablePanel::copy()
{
    QApplication::clipboard()->setText(QString::fromUtf8(csv()));
    m_session->confirm(tr("The rows are in the clipboard, as CSV with headings."));
}

int MotionTablePanel::heightForWidth(int width) const
{
    return m_layout->minimumHeightForWidth(width);
}

void MotionTablePanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) { // each table has fitted its columns to its own texts
        alignColumns();
    }
}

void MotionTablePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    showRows();
}

void MotionTablePanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    emit positionHovered(std::nullopt);
}

} // namespace slidercrank

#include "moc_motion_table_panel.cpp"
