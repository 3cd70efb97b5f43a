// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/column_mapping.h"

#include "ui/document/column_choices.h"
#include "ui/document/reference_file.h"
#include "ui/plots/chart.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// Entries in the list of meanings store a role and, for ColumnRole::Channel, the channel in one number.
constexpr int kChannels = 100; // larger than the number of channels

int meaningOf(ColumnRole role, Channel channel = {})
{
    return kChannels * static_cast<int>(role) + (role == ColumnRole::Channel ? static_cast<int>(indexOf(channel)) : 0);
}

/// Returns the choice for an entry, without its column and unit.
ColumnChoice choiceOf(int meaning)
{
    ColumnChoice choice;
    choice.role = static_cast<ColumnRole>(meaning / kChannels);
    choice.channel = channelAt(static_cast<std::size_t>(meaning % kChannels));
    return choice;
}

void fillMeanings(QComboBox &combo)
{
    combo.addItem(ColumnMapping::tr("ignored"), meaningOf(ColumnRole::Ignored));
    combo.addItem(ColumnMapping::tr("time"), meaningOf(ColumnRole::Time));
    combo.addItem(ColumnMapping::tr("crank angle, instead of a time"), meaningOf(ColumnRole::CrankAngle));
    const std::pair<QString, std::vector<Coordinate>> groups[] = {
        {ColumnMapping::tr("Slider"), {R4x}},
        {ColumnMapping::tr("Coupler"), {Theta3}},
        {ColumnMapping::tr("Crank"), {Theta2}},
        {ColumnMapping::tr("Seldom exported"), {R4y, Theta4, R3x, R3y, R2x, R2y, R1x, R1y, Theta1}}};
    for (const auto &[title, coordinates] : groups) {
        combo.addItem(title); // a heading, which cannot be chosen
        qobject_cast<QStandardItemModel *>(combo.model())->item(combo.count() - 1)->setFlags(Qt::NoItemFlags);
        for (const Coordinate coordinate : coordinates) {
            for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
                const Channel channel{coordinate, order};
                combo.addItem(
                    QStringLiteral("%1  %2  (%3)").arg(quantityOf(channel), symbolOf(channel), columnNameOf(channel)),
                    meaningOf(ColumnRole::Channel, channel));
            }
        }
    }
    combo.setMaxVisibleItems(16);
}

/// Lists the units that a column of this meaning may have; the first entry is the unit in the file.
void fillUnits(QComboBox &combo, const ColumnChoice &choice, const FileColumn &column)
{
    const QString previous = combo.currentData().toString();
    combo.clear();
    combo.setEnabled(choice.role != ColumnRole::Ignored);
    if (choice.role == ColumnRole::Ignored) {
        return;
    }
    QStringList units{"s", "ms"};
    QString usual = units.first();
    if (choice.role != ColumnRole::Time) {
        const Channel channel = choice.role == ColumnRole::CrankAngle ? Channel{Theta2, Order::Position} : choice.channel;
        units = isAngle(channel.coordinate) ? QStringList{"°", "rad"} : QStringList{"mm", "cm", "m", "in"};
        usual = unitOf(channel);
        units.replaceInStrings(QRegularExpression("$"), usual.mid(units.first().size())); // "/s²"
    }
    combo.addItem(column.unit.empty() ? ColumnMapping::tr("none given: %1").arg(usual)
                                      : ColumnMapping::tr("as printed: %1").arg(QString::fromUtf8(column.unit)),
                  QString());
    for (const QString &unit : units) {
        combo.addItem(unit, unit);
    }
    combo.setCurrentIndex(std::max(0, combo.findData(previous)));
}

QStringList fileNames(const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths) {
        names += QFileInfo(path).fileName();
    }
    return names;
}

/// Returns the first cells of a column as written in the file.
QString firstValues(const FileLayout &layout, std::size_t column)
{
    constexpr std::size_t kValues = 3;
    QStringList values;
    for (std::size_t row = 0; row < std::min(kValues, layout.rows.size()); ++row) {
        if (column < layout.rows[row].size()) {
            values << QString::fromUtf8(layout.rows[row][column]);
        }
    }
    return values.join("  ");
}

} // namespace

ColumnMapping::ColumnMapping(const QStringList &paths, const QByteArrayList &beginnings, QWidget *parent)
    : QDialog(parent)
    , m_paths(paths)
    , m_beginnings(beginnings)
    , m_preview(named("preview", new Chart, tr("Preview of the chosen column")))
    , m_caption(named("previewCaption", plainText()))
    , m_problem(named("mappingProblem", plainText()))
{
    setObjectName("columnMapping");
    setWindowTitle(tr("Columns of %1").arg(fileNames(paths).join(", ")));
    m_outcome = readWith({});
    const ReferenceData *read = std::get_if<ReferenceData>(&m_outcome);
    m_layout = read ? read->layout : std::get<ReadError>(m_outcome).layout;
    m_rows.resize(m_layout.columns.size());
    m_preview->setMinimumSize(200, 100);
    setInk(*m_problem, seriesColours(palette()).warning);

    auto *buttons = new QDialogButtonBox;
    m_use = named("useButton", buttons->addButton(tr("Use these columns"), QDialogButtonBox::AcceptRole));
    m_use->setDefault(true);
    QPushButton *detect = named("guessButton", buttons->addButton(tr("Detect again"), QDialogButtonBox::ResetRole));
    detect->setToolTip(tr("Forgets what was chosen for files with these headings"));
    detect->setAutoDefault(false);
    buttons->addButton(QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(detect, &QPushButton::clicked, this, &ColumnMapping::detectAgain);

    auto *rows = new QVBoxLayout(this);
    rows->addWidget(new Paragraph(tr("Say what the columns are; the choice is remembered for files with the same "
                                     "headings. Below is what would be read from the chosen column.")));
    rows->addWidget(createRows(), 3);
    rows->addWidget(m_caption);
    rows->addWidget(m_preview, 1);
    rows->addWidget(m_problem);
    rows->addWidget(buttons);
    constexpr int kWidth = 1200; // px, for reasons in one or two lines
    constexpr int kAround = 40;  // px of the screen
    resize(std::min(kWidth, screen()->availableGeometry().width() - kAround), 640);

    for (const ColumnChoice &choice : savedChoices(m_layout, m_paths)) {
        showChoice(choice.column, choice);
        m_rows[choice.column].isChosen = true;
    }
    // Start at the first column whose meaning is unknown or was guessed.
    const auto open = std::ranges::find_if(m_layout.columns, [this](const FileColumn &column) {
        return m_layout.isOpen() ? leavesOpen(column.reason)
                                 : column.role == ColumnRole::Channel && isGuess(column.reason);
    });
    m_current = open == m_layout.columns.end() ? 0 : static_cast<std::size_t>(open - m_layout.columns.begin());
    readAgain();
    if (m_current < m_rows.size()) {
        m_rows[m_current].meaning->setFocus();
    }
}

QWidget *ColumnMapping::createRows()
{
    auto *page = new QWidget;
    auto *grid = new QGridLayout(page);
    grid->setHorizontalSpacing(14);
    int column = 0;
    for (const QString &heading : {tr("heading"), tr("first values"), tr("read as"), tr("unit"), tr("why")}) {
        grid->addWidget(boldLabel(heading), 0, column++);
    }
    int line = 1;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const std::size_t file = m_layout.columns[i].file;
        if (!m_layout.files.empty() && (i == 0 || file != m_layout.columns[i - 1].file)) {
            grid->addWidget(boldLabel(QString::fromUtf8(m_layout.files[file])), line++, 0, 1, column);
        }
        addRow(grid, line++, i);
    }
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(4, 2);
    grid->setRowStretch(line, 1);
    auto *scroll = new QScrollArea;
    scroll->setAccessibleName(tr("Columns of the file"));
    scroll->setWidgetResizable(true);
    scroll->setWidget(page);
    return scroll;
}

void ColumnMapping::addRow(QGridLayout *grid, int line, std::size_t column)
{
    const QString heading = headingText(m_layout, column);
    Row &row = m_rows[column];
    row.meaning = named(QStringLiteral("meaning%1").arg(column), new QComboBox, tr("%1 is read as").arg(heading));
    fillMeanings(*row.meaning);
    row.unit = named(QStringLiteral("unit%1").arg(column), new QComboBox, tr("Unit of %1").arg(heading));
    row.unit->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row.why = named(QStringLiteral("why%1").arg(column), plainText());
    for (QComboBox *combo : {row.meaning, row.unit}) {
        combo->setFocusPolicy(Qt::StrongFocus);
        combo->installEventFilter(this);
        connect(combo, &QComboBox::currentIndexChanged, this, [this, column] { choose(column); });
    }
    auto *values = new QLabel(firstValues(m_layout, column));
    values->setTextFormat(Qt::PlainText);
    int place = 0;
    for (QWidget *widget : std::initializer_list<QWidget *>{plainText(headingAlone(m_layout, column)), values,
                                                            row.meaning, row.unit, row.why}) {
        grid->addWidget(widget, line, place++);
    }
}

std::variant<ReferenceData, ReadError> ColumnMapping::readWith(const std::vector<ColumnChoice> &choices) const
{
    return readBytes(m_paths, m_beginnings, {choices, {}});
}

std::vector<ColumnChoice> ColumnMapping::choices() const
{
    std::vector<ColumnChoice> choices;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].isChosen) {
            ColumnChoice &choice = choices.emplace_back(choiceOf(m_rows[i].meaning->currentData().toInt()));
            choice.column = i;
            choice.unit = m_rows[i].unit->currentData().toString().toStdString();
        }
    }
    return choices;
}

void ColumnMapping::showChoice(std::size_t row, const ColumnChoice &choice)
{
    const QSignalBlocker quietMeaning(m_rows[row].meaning);
    const QSignalBlocker quietUnit(m_rows[row].unit);
    QComboBox &unit = *m_rows[row].unit;
    m_rows[row].meaning->setCurrentIndex(m_rows[row].meaning->findData(meaningOf(choice.role, choice.channel)));
    fillUnits(unit, choice, m_layout.columns[row]);
    unit.setCurrentIndex(std::max(0, unit.findData(QString::fromStdString(choice.unit))));
}

void ColumnMapping::choose(std::size_t row)
{
    m_rows[row].isChosen = true;
    m_current = row;
    ColumnChoice choice = choiceOf(m_rows[row].meaning->currentData().toInt());
    choice.unit = m_rows[row].unit->currentData().toString().toStdString();
    showChoice(row, choice);
    readAgain();
}

void ColumnMapping::detectAgain()
{
    for (Row &row : m_rows) {
        row.isChosen = false;
    }
    readAgain();
}

void ColumnMapping::readAgain()
{
    m_outcome = readWith(choices());
    if (const ReferenceData *read = std::get_if<ReferenceData>(&m_outcome)) {
        m_layout = read->layout; // otherwise keep the old layout: the reader may not have reached all columns
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        showRow(i);
    }
    const ReadError *error = std::get_if<ReadError>(&m_outcome);
    m_problem->setVisible(error);
    m_problem->setText(error ? readErrorText(*error, fileNames(m_paths)) : QString());
    m_use->setEnabled(!error);
    showPreview();
}

void ColumnMapping::showRow(std::size_t row)
{
    const FileColumn &column = m_layout.columns[row];
    if (!m_rows[row].isChosen) {
        showChoice(row, {row, column.role, column.channel, {}});
    }
    m_rows[row].why->setText(m_rows[row].isChosen ? tr("chosen by hand") : reasonText(m_layout, row));
}

/// Shows the curve and the range of the current column. An ignored column is read as lengths, because its curve helps to
/// recognize it.
void ColumnMapping::showPreview()
{
    if (m_current >= m_rows.size()) {
        return;
    }
    const FileColumn &column = m_layout.columns[m_current];
    const bool isIgnored = column.role == ColumnRole::Ignored;
    Channel channel = column.channel;
    std::variant<ReferenceData, ReadError> outcome = m_outcome;
    if (isIgnored) {
        channel = {R1x, Order::Position};
        std::vector<ColumnChoice> all = choices();
        std::erase_if(all, [this](const ColumnChoice &choice) { return choice.column == m_current; });
        all.push_back({m_current, ColumnRole::Channel, channel, "mm"});
        outcome = readWith(all);
    }
    const ReferenceData *read = std::get_if<ReferenceData>(&outcome);
    const ReferenceSeries *series = read && (isIgnored || column.role == ColumnRole::Channel) ? read->find(channel) : nullptr;
    const QString heading = headingText(m_layout, m_current);
    QString caption = isIgnored ? tr("%1 is ignored").arg(heading) : read ? tr("%1: %2").arg(heading, abscissaText(*read)) : QString();
    ChartContent content;
    if (series) {
        constexpr std::size_t kPoints = 600; // enough to recognize a quantity by its shape
        ChartSeries curve{.name = {}, .colour = &SeriesColours::reference, .line = ChartSeries::Line::Solid};
        Interval range{INFINITY, -INFINITY};
        for (std::size_t i = 0; i < read->time.size(); ++i) {
            if (const double value = series->values[i]; std::isfinite(value)) {
                range = {std::min(range.lower, value), std::max(range.upper, value)};
            }
            if (i % (1 + read->time.size() / kPoints) == 0) {
                curve.points.push_back({read->time[i], series->values[i]});
            }
        }
        const auto longer = [](const Interval &axis) { // an axis needs a length, also if all values are equal
            return axis.upper > axis.lower ? axis : Interval{axis.lower - 1.0, axis.lower + 1.0};
        };
        content = {{{}, longer({read->time.front(), read->time.back()})}, {{}, longer(range)}, {curve}};
        caption = isIgnored ? tr("%1 is ignored: from %2 to %3").arg(heading, numberText(range.lower), numberText(range.upper))
                            : tr("%1: %2 from %3 to %4 %5, %6")
                                  .arg(heading, symbolOf(channel), numberText(range.lower), numberText(range.upper), unitOf(channel),
                                       abscissaText(*read));
    }
    m_preview->setContent(content);
    m_preview->setAccessibleDescription(caption);
    m_caption->setText(caption);
}

bool ColumnMapping::eventFilter(QObject *watched, QEvent *event)
{
    auto *combo = qobject_cast<QComboBox *>(watched);
    if (event->type() == QEvent::FocusIn) {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if ((combo == m_rows[i].meaning || combo == m_rows[i].unit) && i != m_current) {
                m_current = i;
                showPreview();
            }
        }
    }
    return QDialog::eventFilter(watched, event);
}

void ColumnMapping::accept()
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) { // accepting the dialog confirms the guesses
        m_rows[i].isChosen = m_rows[i].isChosen || isGuess(m_layout.columns[i].reason);
    }
    saveChoices(m_layout, m_paths, choices());
    QDialog::accept();
    emit chosen(m_paths);
}

} // namespace slidercrank
