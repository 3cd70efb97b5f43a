// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/motion_table_panel.h"

#include "core/check/check.h"
#include "core/limits/crank_search.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"
#include "ui/document/session.h"
#include "ui/document/whole_file.h"
#include "ui/panels/table_panel.h"
#include "ui/text/check_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/quantity_text.h"
#include "ui/text/record.h"
#include "ui/text/subscripts.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"
#include "ui/widgets/formula.h"
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
#include <cmath>

namespace slidercrank
{

/// Returns the angle (rad) that a crank at theta2 reaches first if it is turned counter-clockwise.
static double nextAngle(const std::vector<double> &angles, double theta2)
{
    constexpr double kRounding = 1e-9; // rad: a crank that is nearer is there already
    return std::ranges::min(angles, {}, [theta2](double angle) { return wrapToTwoPi(angle - theta2 - kRounding); });
}

MotionTablePanel::MotionTablePanel(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_step(new NumberBox)
    , m_stepKind(new QComboBox)
    , m_columns(makeMenuButton("tableColumns", tr("Columns"), tr("Chooses the columns of the table")))
    , m_alpha2(new NumberBox)
    , m_constantSpeed(named("constantSpeed", plainText(tr("The curves are for a constant speed."))))
    , m_quantity(new FormulaBox)
    , m_value(new NumberBox)
    , m_next(new QToolButton)
    , m_useAsSpeed(new QToolButton)
    , m_answer(named("findAnswer", plainText()))
    , m_judgement(named("judgement", plainText()))
    , m_layout(new QVBoxLayout(this))
    , m_currentRowLayout(new QHBoxLayout)
{
    named("motionTablePanel", this, tr("Table of the motion"));
    m_settings.columns = usualTableChannels();
    setMinimumWidth(1); // in a narrow window the widest boxes become narrower, instead of the window wider
    m_layout->setContentsMargins(kTabMargins);
    m_layout->setSpacing(kRowSpacing);
    m_layout->addLayout(makeControls());
    m_layout->addWidget(m_constantSpeed); // beside the controls of a narrow window it would be a column of letters
    m_layout->addLayout(makeFindLine());
    m_layout->addWidget(m_answer);
    m_answer->setTextFormat(Qt::RichText);
    m_answer->hide();
    m_layout->addLayout(m_currentRowLayout);
    m_layout->addWidget(m_judgement);
    m_judgement->setTextFormat(Qt::RichText);
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
    m_stepKind->addItem(tr("°"), static_cast<int>(TableStep::CrankAngle));
    m_stepKind->addItem(tr("s"), static_cast<int>(TableStep::Time));
    row->addWidget(m_stepKind);
    row->addWidget(m_columns);
    auto *label = new QLabel(tr("α₂"));
    row->addWidget(label);
    named("tableAlpha2", m_alpha2, tr("Acceleration of the crank in each row (α₂)"));
    m_alpha2->setToolTip(
        tr("Acceleration of the crank in each row of the table. The curves are for a constant speed."));
    m_alpha2->setSuffix(tr(" rad/s²"));
    m_alpha2->setUnit(kRadianPerSquareSecond);
    label->setBuddy(m_alpha2);
    row->addWidget(m_alpha2);
    m_constantSpeed->hide();
    row->addStretch();
    connect(m_step, &NumberBox::edited, this, [this](double step) {
        MotionTableSettings settings = m_settings;
        (settings.step == TableStep::Time ? settings.timeStep : settings.angleStep) = step;
        setSettings(settings);
    });
    connect(m_stepKind, &QComboBox::activated, this, [this] {
        MotionTableSettings settings = m_settings;
        settings.step = static_cast<TableStep>(m_stepKind->currentData().toInt());
        setSettings(settings);
    });
    connect(m_alpha2, &NumberBox::edited, m_session, &Session::setAlpha2);
    return row;
}

QLayout *MotionTablePanel::makeFindLine()
{
    auto *row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Find")));
    named("findQuantity", m_quantity, tr("Quantity that has a value"));
    row->addWidget(m_quantity);
    row->addWidget(new QLabel("="));
    named("findValue", m_value, tr("Value of the quantity"));
    row->addWidget(m_value);
    named("findNext", m_next, tr("Next"));
    m_next->setText(tr("Next"));
    m_next->setToolTip(tr("Turns the crank to the next position in which the quantity has this value"));
    m_next->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_next);
    named("findUseAsSpeed", m_useAsSpeed, tr("Use as ω₂"));
    m_useAsSpeed->setText(tr("Use as ω₂"));
    m_useAsSpeed->setToolTip(tr("Sets the crank speed with which the velocity has this value at the present position"));
    m_useAsSpeed->setFocusPolicy(Qt::TabFocus);
    row->addWidget(m_useAsSpeed);
    row->addStretch(1);
    connect(addButton(row, "motionTableCopy", tr("Copy"), tr("Copies the rows as CSV")), &QToolButton::clicked, this,
            &MotionTablePanel::copy);
    QToolButton *button = makeMenuButton("motionTableExport", tr("Export"), tr("Writes the rows to a CSV file"));
    fillExportMenu(button);
    row->addWidget(button);
    connect(m_quantity, &QComboBox::activated, this, &MotionTablePanel::showWantedUnit);
    connect(m_value, &NumberBox::edited, this, [this] { m_answer->hide(); });
    connect(m_value, &NumberBox::enterPressed, this, &MotionTablePanel::goToNext);
    connect(m_next, &QToolButton::clicked, this, &MotionTablePanel::goToNext);
    connect(m_useAsSpeed, &QToolButton::clicked, this, &MotionTablePanel::useAsCrankSpeed);
    return row;
}

void MotionTablePanel::fillColumnsMenu()
{
    QMenu *menu = m_columns->menu();
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
    m_stepKind->setCurrentIndex(m_stepKind->findData(static_cast<int>(settings.step)));
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
    const auto addButton = [&](const QString &name, const QString &text, Symbols symbols) {
        auto *button = named(name, new QPushButton(text));
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, offer, symbols] {
            offer->deleteLater();
            emit symbolsChosen(symbols);
        });
    };
    addButton("textbookNotation", tr("Use this notation"), Symbols::Textbook);
    addButton("absoluteCoordinates", tr("Keep θ³, Rₓ⁴"), Symbols::AbsoluteCoordinates);
    m_layout->insertWidget(0, offer);
}

void MotionTablePanel::refreshNotation()
{
    if (auto *offer = findChild<QWidget *>("notationOffer"); offer && notation().symbols == Symbols::Textbook) {
        offer->deleteLater(); // it was chosen elsewhere
    }
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
    fillQuantities();
}

void MotionTablePanel::arrangeTable()
{
    constexpr int kMinRows = 2; // where the panel itself scrolls
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
        typeValue(m_settings.columns[static_cast<std::size_t>(column - kFirstChannelColumn)], text.trimmed());
        QMetaObject::invokeMethod(this, &MotionTablePanel::showCurrentPosition,
                                  Qt::QueuedConnection); // after the cell is closed
    });
    connect(m_table->horizontalScrollBar(), &QScrollBar::valueChanged, m_currentRowTable->horizontalScrollBar(),
            &QScrollBar::setValue);
    connect(m_table, &NumberTable::timeRequested, this, &MotionTablePanel::timeRequested);
    connect(m_table, &NumberTable::rowHovered, this, [this](int row) {
        const bool isRow = row >= 0 && row < static_cast<int>(m_places.size());
        emit placeHovered(isRow ? std::optional(m_places[static_cast<std::size_t>(row)].theta2) : std::nullopt);
    });
    for (NumberTable *table : {m_currentRowTable, m_table}) {
        connect(table, &NumberTable::copied, this,
                [this] { emit m_session->confirmed(tr("The rows are in the clipboard, as CSV with headings.")); });
    }
}

/// Fills the list of the quantities that can be found. The chosen one stays.
void MotionTablePanel::fillQuantities()
{
    const int chosen = std::max(0, m_quantity->currentIndex());
    m_quantity->clear();
    for (const OutputChannel &channel : tableChannels()) {
        m_quantity->addItem(symbolOf(channel), columnName(channel));
        m_quantity->setItemData(m_quantity->count() - 1, nameText(channel), Qt::ToolTipRole);
    }
    m_quantity->setCurrentIndex(chosen);
    showWantedUnit();
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
    m_places = tablePlaces(m_settings, mechanism, m_session->result()->sampling);
    m_rows.clear();
    for (const TablePlace &place : m_places) {
        m_rows.push_back(motionTableRow(m_settings, mechanism, m_session->alpha2(), place));
    }
    m_table->setRows(m_rows);
    showCurrentPosition();
    alignColumns();
}

void MotionTablePanel::showAlpha2()
{
    m_alpha2->setValue(m_session->alpha2());
    m_constantSpeed->setVisible(m_session->alpha2() != 0.0);
}

void MotionTablePanel::showCurrentPosition()
{
    if (isVisible()) {
        TableRow row =
            motionTableRow(m_settings, Mechanism(m_session->parameters()), m_session->alpha2(), currentPlace());
        row.cells.front().tone = Tone::Normal; // the time is no link here
        row.time.reset();                      // the row would link to its own time
        m_currentRowTable->setRows({row, judgeMyValues()});
        alignColumns();
        deselectOtherPosition();
    }
}

/// Returns whether two crank angles (rad) are the same position, except for rounding.
static bool isSamePosition(double x, double y)
{
    constexpr double kRounding = 1e-9; // rad
    return std::abs(wrapToPi(x - y)) < kRounding;
}

/// Deselects the row that was clicked once the crank is at a different position. Several rows, which a person selects
/// to copy them, stay selected.
void MotionTablePanel::deselectOtherPosition()
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    if (rows.size() == 1 &&
        !isSamePosition(m_places[static_cast<std::size_t>(rows.front().row())].theta2, currentPlace().theta2)) {
        m_table->clearSelection();
    }
}

void MotionTablePanel::typeValue(const OutputChannel &channel, const QString &text)
{
    const double theta2 = wrapToPi(currentPlace().theta2);
    auto here = std::ranges::find_if(
        m_myValues, [theta2](const TypedTexts &typed) { return isSamePosition(typed.theta2, theta2); });
    if (here == m_myValues.end()) {
        here = m_myValues.insert(here, {.theta2 = theta2, .byColumn = {}});
    }
    if (text.isEmpty()) {
        here->byColumn.erase(columnName(channel));
    } else {
        here->byColumn[columnName(channel)] = text;
    }
    if (here->byColumn.empty()) {
        m_myValues.erase(here);
    }
}

const MotionTablePanel::TypedTexts *MotionTablePanel::textsAtCurrentPosition() const
{
    const auto here = std::ranges::find_if(
        m_myValues, [this](const TypedTexts &typed) { return isSamePosition(typed.theta2, currentPlace().theta2); });
    return here == m_myValues.end() ? nullptr : &*here;
}

QString MotionTablePanel::otherPositions() const
{
    QStringList angles;
    for (const TypedTexts &typed : m_myValues) {
        angles << QStringLiteral("θ₂ = ") + crankAngleWithUnit(typed.theta2);
    }
    return angles.isEmpty() ? QString() : tr("Your values are shown again at %1.").arg(listed(angles));
}

/// Returns the row of the values that were typed at the current position, with their verdicts as colours. Also shows
/// the conclusions from these values.
TableRow MotionTablePanel::judgeMyValues()
{
    TableRow row{.cells = {{.text = tr("my values"), .tone = Tone::Muted}, {}},
                 .explanation = tr(
                     "Type values of your calculation: they are compared with the exact ones, each to its last digit")};
    QStringList sentences;
    std::vector<TypedValue> values = readMyValues(row, sentences);
    const bool hasUnreadable = !sentences.isEmpty();
    const CrankPosition position{withCrankAt(Mechanism(m_session->parameters()), currentPlace().theta2),
                                 m_session->alpha2()};
    values = inLikelyUnits(std::move(values), position, notation().units);
    std::vector<GivenValue> given(values.size());
    std::ranges::transform(values, given.begin(), &TypedValue::given);
    const CheckResult result = check(position, given);
    QStringList wrong;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool isRight = result.values[i].isRight;
        const auto column = std::ranges::find(m_settings.columns, values[i].channel) - m_settings.columns.begin();
        row.cells[static_cast<std::size_t>(column + kFirstChannelColumn)].tone = isRight ? Tone::Good : Tone::Bad;
        sentences << QStringLiteral("%1: %2.").arg(symbolOf(values[i].channel),
                                                   verdictText(values[i], result.values[i]));
        if (!isRight) {
            wrong << symbolOf(values[i].channel);
        }
    }
    if (!textsAtCurrentPosition() && !m_myValues.empty()) {
        sentences << otherPositions();
    }
    const bool isIncomplete = wrong.isEmpty() && hasUnreadable; // then not "all values are right"
    if (!values.empty() && !isIncomplete) {
        sentences << explanationText(result, wrong);
    }
    if (!values.empty() && result.status == Status::Singular &&
        velocitiesJumpAt(position.mechanism, currentPlace().theta2)) {
        sentences << jumpSentence();
    }
    m_judgement->setVisible(!sentences.isEmpty());
    m_judgement->setText(subscriptHtml(sentences.join(u' ')));
    return row;
}

/// Appends a cell for each column to a row, with the text that was typed at the current position, and returns the
/// values. Appends a sentence for each text that is no value.
std::vector<TypedValue> MotionTablePanel::readMyValues(TableRow &row, QStringList &sentences) const
{
    std::vector<TypedValue> values;
    const TypedTexts *typedHere = textsAtCurrentPosition();
    for (const OutputChannel &channel : m_settings.columns) {
        TableCell &cell = row.cells.emplace_back();
        if (!typedHere || !typedHere->byColumn.contains(columnName(channel))) {
            continue;
        }
        cell.text = typedHere->byColumn.at(columnName(channel));
        if (cell.text.startsWith(u'-')) {
            cell.text.replace(0, 1, "−"); // as in the row above
        }
        const QString number = QString(cell.text).replace(QLocale().decimalPoint(), ".");
        const TypedValue typed = readTypedValue(number, channel, notation().units);
        if (typed.parsed.fault) {
            cell.tone = Tone::Bad;
            sentences << QStringLiteral("%1: %2").arg(symbolOf(channel), faultText(typed));
            continue;
        }
        values.push_back(typed);
    }
    return values;
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

TablePlace MotionTablePanel::currentPlace() const
{
    return {.theta2 = m_session->pose().motion.theta2, .time = m_session->time()};
}

std::optional<OutputChannel> MotionTablePanel::wantedChannel() const
{
    return outputChannelNamed(m_quantity->currentData().toString().toStdString());
}

double MotionTablePanel::wantedValue() const
{
    const OutputChannel channel = *wantedChannel();
    const ShownScale scale = shownScale(channel, m_session->parameters().branch);
    return scale.inFileUnit(m_value->value()) / toFileUnit(measureOf(channel), 1.0);
}

void MotionTablePanel::showWantedUnit()
{
    const OutputChannel channel = *wantedChannel();
    const Measure measure = measureOf(channel);
    const QString unit = shownUnit(channel);
    m_value->setSuffix(unit == u"°" ? unit : u' ' + unit);
    m_value->setUnit({isAngular(measure) ? Dimension::Angle : Dimension::Length, static_cast<int>(orderOf(channel)),
                      1.0 / fromFileUnit(measure, 1.0, notation().units)});
    m_useAsSpeed->setVisible(orderOf(channel) == Order::Velocity);
    m_answer->hide();
}

QString MotionTablePanel::noPosition() const
{
    const OutputChannel channel = *wantedChannel();
    const bool isCouplerAngle = channel == OutputChannel(Channel{Theta3, Order::Position});
    const Mechanism mechanism(m_session->parameters());
    if (isCouplerAngle && !crankAnglesAt(mechanism, channel, wantedValue() + 0.5 * kTurn)->empty()) {
        return notation().symbols == Symbols::Textbook
                   ? tr("There is no such position: this θ₃ is measured at B. View > Notation and units has the angle "
                        "at A.")
                   : tr("There is no such position: this θ³ is measured at A. View > Notation and units has the angle "
                        "at B.");
    }
    const std::optional<ChannelRange> range = rangeOf(mechanism, channel, m_session->alpha2());
    if (!range || !range->excludes(wantedValue())) {
        return tr("There is no such position.");
    }
    constexpr int kDigits = 5; // as in the table
    const Branch branch = mechanism.branch();
    const QString unit = shownUnit(channel);
    return tr("There is no such position: %1 lies between %2 and %3.")
        .arg(symbolOf(channel), withUnit(lowerBoundText(shownChannel(channel, branch, range->least), kDigits), unit),
             withUnit(upperBoundText(shownChannel(channel, branch, range->greatest), kDigits), unit));
}

void MotionTablePanel::goToNext()
{
    const OutputChannel channel = *wantedChannel();
    const Mechanism mechanism(m_session->parameters());
    std::optional<std::vector<double>> angles = crankAnglesAt(mechanism, channel, wantedValue(), m_session->alpha2());
    QString answer;
    if (!angles || angles->empty()) {
        answer = noPosition();
    } else if (mechanism.omega2() == 0.0) {
        m_session->setParameter(Parameter::Theta20, nextAngle(*angles, m_session->parameters().theta20));
    } else if (const auto time = nextTime(*angles, mechanism, m_session->sampling(), m_session->time())) {
        emit timeRequested(*time);
    } else {
        answer = tr("The crank does not reach these positions within the time range.");
    }
    if (answer.isEmpty()) {
        std::ranges::sort(*angles, {}, shownCrankAngle);
        QStringList texts;
        for (const double theta2 : *angles) {
            texts << crankAngleWithUnit(theta2);
        }
        answer = tr("Positions of a revolution: θ₂ = %1").arg(texts.join("; "));
    }
    m_answer->setText(subscriptHtml(answer));
    m_answer->show();
}

void MotionTablePanel::useAsCrankSpeed()
{
    const std::optional<double> speed = crankSpeedFor(Mechanism(m_session->parameters()),
                                                      m_session->pose().motion.theta2, *wantedChannel(), wantedValue());
    if (speed && std::abs(*speed) <= kLargestParameter) {
        m_answer->hide();
        m_session->setCrankSpeedHere(*speed);
        emit timeRequested(m_session->time()); // also shows it in plots that are zoomed
        return;
    }
    m_answer->setText(tr("No crank speed gives this velocity here: it is 0 at every speed, as at a dead centre."));
    m_answer->show();
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
    emit m_session->confirmed(tr("The rows are in the clipboard, as CSV with headings."));
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
    emit placeHovered(std::nullopt);
}

} // namespace slidercrank

#include "moc_motion_table_panel.cpp"
