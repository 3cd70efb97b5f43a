// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/column_mapping.h"

#include "ui/document/column_choices.h"
#include "ui/document/reference_file.h"
#include "ui/text/channel_text.h"
#include "ui/text/column_text.h"
#include "ui/text/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVariant>

#include <algorithm>
#include <utility>

namespace slidercrank
{

namespace
{

/// What an entry in the list of meanings stores.
struct ColumnMeaning {
    ColumnRole role = ColumnRole::Ignored;
    Channel channel = {}; ///< if the role is Channel

    friend bool operator==(const ColumnMeaning &, const ColumnMeaning &) = default;
};

QVariant meaningOf(ColumnRole role, Channel channel = {})
{
    return QVariant::fromValue(ColumnMeaning{role, role == ColumnRole::Channel ? channel : Channel()});
}

void fillMeanings(QComboBox &combo)
{
    combo.addItem(ColumnMapping::tr("ignored"), meaningOf(ColumnRole::Ignored));
    combo.addItem(ColumnMapping::tr("time"), meaningOf(ColumnRole::Time));
    combo.addItem(ColumnMapping::tr("crank angle, instead of a time"), meaningOf(ColumnRole::CrankAngle));
    const std::vector<Coordinate> groups[] = {
        {R4x}, {Theta3}, {Theta2}, {R4y, Theta4, R3x, R3y, R2x, R2y, R1x, R1y, Theta1}};
    for (const std::vector<Coordinate> &coordinates : groups) {
        combo.insertSeparator(combo.count());
        for (const Coordinate coordinate : coordinates) {
            for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
                const Channel channel{coordinate, order};
                const QString symbol = absoluteSymbolText(channel);
                const QString name = symbol.contains(u'_') // a list cannot show this subscript
                                         ? quantityName(channel)
                                         : quantityName(channel) + "  " + symbol;
                combo.addItem(QStringLiteral("%1  (%2)").arg(name, columnName(channel)),
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
        const Channel channel =
            choice.role == ColumnRole::CrankAngle ? Channel{Theta2, Order::Position} : choice.channel;
        units = isAngle(channel.coordinate) ? QStringList{"°", "rad"} : QStringList{"mm", "cm", "m", "in"};
        usual = unitText(channel);
        units.replaceInStrings(QRegularExpression("$"), usual.mid(units.first().size())); // appends "/s²"
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
    constexpr std::size_t kValues = 2;
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
    , m_problem(named("mappingProblem", plainText()))
{
    setObjectName("columnMapping");
    setWindowTitle(tr("Columns of %1").arg(fileNames(paths).join(", ")));
    m_layout = layoutOf(readBytes(paths, beginnings, {}));
    m_rows.resize(m_layout.columns.size());
    setInk(*m_problem, seriesColours(palette()).warning);
    auto *rows = new QVBoxLayout(this);
    rows->addWidget(
        plainText(tr("Choose what each column contains. The choice is remembered for files with the same headings.")));
    rows->addWidget(createRows(), 1);
    rows->addWidget(m_problem);
    addButtons(rows);
    constexpr int kWidth = 1200; // px: the text "why" of each row fits into one or two lines
    constexpr int kMargins = 40; // px of the screen, left and right of the dialog together
    resize(std::min(kWidth, screen()->availableGeometry().width() - kMargins), 560);

    for (const ColumnChoice &choice : savedChoices(m_layout, m_paths)) {
        showChoice(choice.column, choice);
        m_rows[choice.column].isChosen = true;
    }
    readAgain();
}

void ColumnMapping::addButtons(QBoxLayout *rows)
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_useButton = named("useButton", buttons->addButton(tr("Use these columns"), QDialogButtonBox::AcceptRole));
    QPushButton *detect = named("guessButton", buttons->addButton(tr("Detect again"), QDialogButtonBox::ResetRole));
    detect->setToolTip(tr("Forgets what was chosen for files with these headings"));
    detect->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(detect, &QPushButton::clicked, this, &ColumnMapping::detectAgain);
    rows->addWidget(buttons);
}

QWidget *ColumnMapping::createRows()
{
    constexpr int kHeadingColumn = 0;
    constexpr int kReasonColumn = 4; // "why"
    auto *page = new QWidget;
    auto *grid = new QGridLayout(page);
    grid->setHorizontalSpacing(14);
    int column = 0;
    for (const QString &heading : {tr("heading"), tr("first values"), tr("read as"), tr("unit"), tr("why")}) {
        grid->addWidget(new QLabel(QStringLiteral("<b>%1</b>").arg(heading)), 0, column++);
    }
    int line = 1;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const std::size_t file = m_layout.columns[i].file;
        if (!m_layout.files.empty() && (i == 0 || file != m_layout.columns[i - 1].file)) {
            grid->addWidget(plainText(QString::fromUtf8(m_layout.files[file])), line++, 0, 1, column);
        }
        addRow(grid, line++, i);
    }
    grid->setColumnMinimumWidth(kHeadingColumn, 12 * fontMetrics().averageCharWidth()); // for usual headings
    grid->setColumnStretch(kHeadingColumn, 1);
    grid->setColumnStretch(kReasonColumn, 2);
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
    for (const QComboBox *combo : {row.meaning, row.unit}) {
        connect(combo, &QComboBox::currentIndexChanged, this, [this, column] { acceptChoice(column); });
    }
    auto *values = new QLabel(firstValues(m_layout, column));
    values->setTextFormat(Qt::PlainText);
    int gridColumn = 0;
    for (QWidget *widget : std::initializer_list<QWidget *>{plainText(headingWithoutFile(m_layout, column)), values,
                                                            row.meaning, row.unit, row.why}) {
        grid->addWidget(widget, line, gridColumn++);
    }
}

ColumnChoice ColumnMapping::choiceIn(std::size_t row) const
{
    const auto meaning = m_rows[row].meaning->currentData().value<ColumnMeaning>();
    return {.column = row,
            .role = meaning.role,
            .channel = meaning.channel,
            .unit = m_rows[row].unit->currentData().toString().toStdString()};
}

std::vector<ColumnChoice> ColumnMapping::choices() const
{
    std::vector<ColumnChoice> choices;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].isChosen) {
            choices.push_back(choiceIn(i));
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

void ColumnMapping::acceptChoice(std::size_t row)
{
    m_rows[row].isChosen = true;
    showChoice(row, choiceIn(row)); // the list of units depends on the meaning
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
    const auto outcome = readBytes(m_paths, m_beginnings, {choices(), {}});
    if (const ReferenceData *read = std::get_if<ReferenceData>(&outcome)) {
        m_layout = read->layout; // otherwise keep the old layout: the reader may not have reached all columns
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        showRow(i);
    }
    const ReadError *error = std::get_if<ReadError>(&outcome);
    m_problem->setVisible(error);
    m_problem->setText(error ? readErrorText(*error, fileNames(m_paths)) : QString());
    m_useButton->setEnabled(!error);
}

void ColumnMapping::showRow(std::size_t row)
{
    const FileColumn &column = m_layout.columns[row];
    if (!m_rows[row].isChosen) {
        showChoice(row, {row, column.role, column.channel, {}});
    }
    m_rows[row].why->setText(m_rows[row].isChosen ? tr("chosen by hand") : reasonText(m_layout, row));
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

#include "moc_column_mapping.cpp"
