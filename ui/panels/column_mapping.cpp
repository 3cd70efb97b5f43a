// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/column_mapping.h"

#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"
#include "ui/document/column_choices.h"
#include "ui/document/reference_file.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace slidercrank
{

/// A curve without axes: enough to recognize a quantity by its shape and range.
class ColumnPreview : public QWidget
{
public:
    using QWidget::QWidget;

    void setCurve(std::span<const double> x, std::span<const double> y)
    {
        // A few hundred points are enough for a few hundred pixels.
        constexpr std::size_t kPoints = 600;
        const std::size_t stride = std::max<std::size_t>(1, x.size() / kPoints);
        m_points.clear();
        for (std::size_t i = 0; i < x.size(); i += stride) {
            m_points.push_back({x[i], y[i]});
        }
        update();
    }

    QSize sizeHint() const override { return {400, 120}; }
    QSize minimumSizeHint() const override { return {200, 70}; }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        const SeriesColours colours = seriesColours(palette());
        painter.fillRect(rect(), colours.background);
        painter.setPen(colours.grid);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
        double low = INFINITY;
        double high = -INFINITY;
        for (const QPointF &point : m_points) {
            if (std::isfinite(point.y())) {
                low = std::min(low, point.y());
                high = std::max(high, point.y());
            }
        }
        if (!(low <= high)) {
            return;
        }
        const double left = m_points.front().x();
        const double width = std::max(m_points.back().x() - left, 1e-300);
        const QRectF inside = QRectF(rect()).adjusted(8.0, 8.0, -8.0, -8.0);
        const auto toPixel = [&](const QPointF &point) {
            const double up = high > low ? (point.y() - low) / (high - low) : 0.5;
            return QPointF(inside.left() + (point.x() - left) / width * inside.width(),
                           inside.bottom() - up * inside.height());
        };
        QPainterPath curve;
        bool drawing = false;
        for (const QPointF &point : m_points) {
            if (!std::isfinite(point.y())) {
                drawing = false;
            } else if (drawing) {
                curve.lineTo(toPixel(point));
            } else {
                curve.moveTo(toPixel(point));
                drawing = true;
            }
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(colours.reference, 1.5));
        painter.drawPath(curve);
    }

private:
    std::vector<QPointF> m_points;
};

namespace
{

// What an entry of the combo of meanings stands for: the index of a channel, or
constexpr int kIgnored = -2;
constexpr int kTime = -1;
constexpr int kCrankAngle = -3;

int meaningOf(ColumnRole role, Channel channel)
{
    switch (role) {
    case ColumnRole::Ignored: return kIgnored;
    case ColumnRole::Time: return kTime;
    case ColumnRole::CrankAngle: return kCrankAngle;
    case ColumnRole::Channel: return static_cast<int>(indexOf(channel));
    }
    return kIgnored;
}

FileLayout layoutIn(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

QString channelText(Channel channel)
{
    return QStringLiteral("%1  %2  (%3)").arg(quantityOf(channel), symbolOf(channel), columnNameOf(channel));
}

/// A line among the entries that cannot be chosen.
void addTitle(QComboBox &combo, const QString &title)
{
    combo.addItem(title);
    QFont bold = combo.font();
    bold.setBold(true);
    combo.setItemData(combo.count() - 1, bold, Qt::FontRole);
    qobject_cast<QStandardItemModel *>(combo.model())->item(combo.count() - 1)->setFlags(Qt::NoItemFlags);
}

void fillMeanings(QComboBox &combo)
{
    combo.addItem(ColumnMapping::tr("ignored"), kIgnored);
    combo.addItem(ColumnMapping::tr("time"), kTime);
    combo.addItem(ColumnMapping::tr("crank angle, instead of a time"), kCrankAngle);
    struct Group {
        QString title;
        std::vector<Coordinate> coordinates;
    };
    const std::array groups{
        Group{ColumnMapping::tr("Slider"), {R4x}}, Group{ColumnMapping::tr("Coupler"), {Theta3}},
        Group{ColumnMapping::tr("Crank"), {Theta2}},
        Group{ColumnMapping::tr("Seldom exported"), {R4y, Theta4, R3x, R3y, R2x, R2y, R1x, R1y, Theta1}}};
    for (const Group &group : groups) {
        addTitle(combo, group.title);
        for (const Coordinate coordinate : group.coordinates) {
            for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
                const Channel channel{coordinate, order};
                combo.addItem(channelText(channel), static_cast<int>(indexOf(channel)));
            }
        }
    }
    combo.setMaxVisibleItems(16);
}

QStringList namesOf(const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths) {
        names += QFileInfo(path).fileName();
    }
    return names;
}

/// The units that a column of that meaning may have; the first entry is the file's own.
void fillUnits(QComboBox &combo, int meaning, const FileColumn &column)
{
    const QString kept = combo.currentData().toString();
    combo.clear();
    combo.setEnabled(meaning != kIgnored);
    if (meaning == kIgnored) {
        return;
    }
    QStringList units{QStringLiteral("s"), QStringLiteral("ms")};
    QString author = QStringLiteral("s");
    if (meaning != kTime) {
        const Channel channel =
            meaning == kCrankAngle ? Channel{Theta2, Order::Position} : channelAt(static_cast<std::size_t>(meaning));
        author = unitOf(channel);
        units = isAngle(channel.coordinate) ? QStringList{QStringLiteral("°"), QStringLiteral("rad")}
                                            : QStringList{QStringLiteral("mm"), QStringLiteral("cm"),
                                                          QStringLiteral("m"), QStringLiteral("in")};
        const QString per = author.mid(units.first().size()); // "/s²"
        for (QString &unit : units) {
            unit += per;
        }
    }
    combo.addItem(column.unit.empty() ? ColumnMapping::tr("none given: %1").arg(author)
                                      : ColumnMapping::tr("as printed: %1").arg(QString::fromUtf8(column.unit)),
                  QString());
    for (const QString &unit : units) {
        combo.addItem(unit, unit);
    }
    combo.setCurrentIndex(std::max(0, combo.findData(kept)));
}

/// The first cells of a column as printed.
QString firstValues(const FileLayout &layout, std::size_t column)
{
    constexpr std::size_t kValues = 3;
    QStringList values;
    for (std::size_t row = 0; row < std::min(kValues, layout.rows.size()); ++row) {
        if (column < layout.rows[row].size()) {
            values << QString::fromUtf8(layout.rows[row][column]);
        }
    }
    return values.join(QStringLiteral("  "));
}

} // namespace

ColumnMapping::ColumnMapping(const QStringList &paths, const QByteArrayList &beginnings, QWidget *parent)
    : QDialog(parent)
    , m_paths(paths)
    , m_beginnings(beginnings)
{
    setObjectName(QStringLiteral("columnMapping"));
    setWindowTitle(tr("Columns of %1").arg(namesOf(paths).join(QStringLiteral(", "))));
    m_layout = layoutIn(readWith({}));
    m_rows.resize(m_layout.columns.size());

    auto *purpose = new QLabel(tr("Say what the columns are; the choice is remembered for files with the same "
                                  "headings. Below is what would be read from the chosen column."));
    purpose->setWordWrap(true);
    m_caption = named("previewCaption", new QLabel);
    m_caption->setTextFormat(Qt::PlainText);
    m_preview = named("preview", new ColumnPreview, tr("Preview of the chosen column"));
    m_problem = named("mappingProblem", new QLabel);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);

    auto *buttons = new QDialogButtonBox;
    m_use = named("useButton", buttons->addButton(tr("Use these columns"), QDialogButtonBox::AcceptRole));
    m_use->setDefault(true);
    QPushButton *guess = named("guessButton", buttons->addButton(tr("Guess anew"), QDialogButtonBox::ResetRole));
    guess->setToolTip(tr("Forgets what was chosen for files with these headings"));
    guess->setAutoDefault(false);
    buttons->addButton(QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(guess, &QPushButton::clicked, this, &ColumnMapping::guessAnew);

    auto *rows = new QVBoxLayout(this);
    rows->addWidget(purpose);
    rows->addWidget(createRows(), 1);
    rows->addWidget(m_caption);
    rows->addWidget(m_preview);
    rows->addWidget(m_problem);
    rows->addWidget(buttons);
    constexpr int kRoom = 1200; // px, for reasons in one or two lines
    constexpr int kAround = 40; // of the screen, at least
    resize(std::min(kRoom, screen()->availableGeometry().width() - kAround), 600);

    for (const ColumnChoice &choice : rememberedChoices(m_layout, paths)) {
        Row &row = m_rows[choice.column];
        const QSignalBlocker meaningBlocker(row.meaning);
        const QSignalBlocker unitBlocker(row.unit);
        const int meaning = meaningOf(choice.role, choice.channel);
        row.meaning->setCurrentIndex(row.meaning->findData(meaning));
        fillUnits(*row.unit, meaning, m_layout.columns[choice.column]);
        row.unit->setCurrentIndex(std::max(0, row.unit->findData(QString::fromStdString(choice.unit))));
        row.chosen = true;
    }
    // The first column that is open, or was guessed, is what brings a person here.
    const auto open = std::ranges::find_if(m_layout.columns, [this](const FileColumn &column) {
        return m_layout.isOpen() ? leavesOpen(column.reason)
                                 : column.role == ColumnRole::Channel && isGuess(column.reason);
    });
    if (open != m_layout.columns.end()) {
        m_current = static_cast<std::size_t>(open - m_layout.columns.begin());
    }
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
    const QStringList headers{tr("heading"), tr("first values"), tr("read as"), tr("unit"), tr("why")};
    for (int column = 0; column < headers.size(); ++column) {
        grid->addWidget(boldLabel(headers[column]), 0, column);
    }
    int line = 1;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const std::size_t file = m_layout.columns[i].file;
        if (!m_layout.files.empty() && (i == 0 || file != m_layout.columns[i - 1].file)) { // from there on its own
            grid->addWidget(boldLabel(QString::fromUtf8(m_layout.files[file])), line++, 0, 1,
                            static_cast<int>(headers.size()));
        }
        const QString heading = headingText(m_layout, i);
        Row &row = m_rows[i];
        row.meaning = named(QStringLiteral("meaning%1").arg(i), new QComboBox, tr("%1 is read as").arg(heading));
        fillMeanings(*row.meaning);
        row.unit = named(QStringLiteral("unit%1").arg(i), new QComboBox, tr("Unit of %1").arg(heading));
        row.unit->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        for (QComboBox *combo : {row.meaning, row.unit}) {
            combo->setFocusPolicy(Qt::StrongFocus);
            combo->installEventFilter(this);
            connect(combo, &QComboBox::currentIndexChanged, this, [this, i] { choose(i); });
        }
        row.why = named(QStringLiteral("why%1").arg(i), new QLabel);
        auto *name = new QLabel(headingAlone(m_layout, i));
        auto *values = new QLabel(firstValues(m_layout, i));
        for (QLabel *label : {name, values, row.why}) {
            label->setTextFormat(Qt::PlainText);
            label->setWordWrap(label != values);
        }
        int column = 0;
        for (QWidget *widget :
             {static_cast<QWidget *>(name), static_cast<QWidget *>(values), static_cast<QWidget *>(row.meaning),
              static_cast<QWidget *>(row.unit), static_cast<QWidget *>(row.why)}) {
            grid->addWidget(widget, line, column++);
        }
        ++line;
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

std::variant<ReferenceData, ReadError> ColumnMapping::readWith(const std::vector<ColumnChoice> &choices) const
{
    return readBytes(m_paths, m_beginnings, {choices, {}});
}

std::vector<ColumnChoice> ColumnMapping::choices() const
{
    std::vector<ColumnChoice> choices;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row &row = m_rows[i];
        if (!row.chosen) {
            continue;
        }
        ColumnChoice choice;
        choice.column = i;
        choice.unit = row.unit->currentData().toString().toStdString();
        const int meaning = row.meaning->currentData().toInt();
        if (meaning == kTime) {
            choice.role = ColumnRole::Time;
        } else if (meaning == kCrankAngle) {
            choice.role = ColumnRole::CrankAngle;
        } else if (meaning != kIgnored) {
            choice.role = ColumnRole::Channel;
            choice.channel = channelAt(static_cast<std::size_t>(meaning));
        }
        choices.push_back(choice);
    }
    return choices;
}

void ColumnMapping::choose(std::size_t row)
{
    m_rows[row].chosen = true;
    m_current = row;
    {
        const QSignalBlocker blocker(m_rows[row].unit);
        fillUnits(*m_rows[row].unit, m_rows[row].meaning->currentData().toInt(), m_layout.columns[row]);
    }
    readAgain();
}

void ColumnMapping::guessAnew()
{
    for (Row &row : m_rows) {
        row.chosen = false;
    }
    readAgain();
}

void ColumnMapping::readAgain()
{
    m_outcome = readWith(choices());
    if (const ReferenceData *fit = std::get_if<ReferenceData>(&m_outcome)) {
        m_layout = fit->layout; // else the other columns stay as they were: the reader may not have come to them
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        showRow(i);
    }
    showPreview();
}

void ColumnMapping::showRow(std::size_t row)
{
    const FileColumn &column = m_layout.columns[row];
    Row &of = m_rows[row];
    if (!of.chosen) {
        const QSignalBlocker meaningBlocker(of.meaning);
        const QSignalBlocker unitBlocker(of.unit);
        const int meaning = meaningOf(column.role, column.channel);
        of.meaning->setCurrentIndex(of.meaning->findData(meaning));
        of.unit->clear(); // what was chosen for another meaning is not kept
        fillUnits(*of.unit, meaning, column);
    }
    of.why->setText(of.chosen ? tr("chosen by hand") : reasonText(m_layout, row));
}

void ColumnMapping::showPreview()
{
    const ReadError *error = std::get_if<ReadError>(&m_outcome);
    m_problem->setVisible(error);
    m_use->setEnabled(!error);
    m_caption->clear();
    m_preview->setCurve({}, {});
    if (error) {
        m_problem->setText(sentenceOf(*error, namesOf(m_paths)));
        setInk(*m_problem, seriesColours(palette()).warning);
    }
    if (m_current >= m_rows.size()) {
        return;
    }
    if (m_layout.columns[m_current].role == ColumnRole::Ignored) {
        previewIgnored();
        return;
    }
    if (error) {
        return;
    }
    const ReferenceData &read = std::get<ReferenceData>(m_outcome);
    const FileColumn &column = m_layout.columns[m_current];
    const QString heading = headingText(m_layout, m_current);
    const QString span = abscissaText(read);
    const ReferenceSeries *series = column.role == ColumnRole::Channel ? read.find(column.channel) : nullptr;
    if (column.role == ColumnRole::Time) {
        m_caption->setText(tr("%1: %2").arg(heading, span));
        m_preview->setCurve(read.time, read.time);
    } else if (column.role == ColumnRole::CrankAngle) {
        m_caption->setText(tr("%1: %2").arg(heading, span));
        m_preview->setCurve(read.time, read.crank->degrees);
    } else if (series) {
        double low = INFINITY;
        double high = -INFINITY;
        for (const double value : series->values) {
            low = std::isnan(value) ? low : std::min(low, value);
            high = std::isnan(value) ? high : std::max(high, value);
        }
        const QString unit = unitOf(column.channel);
        m_caption->setText(tr("%1: %2 from %3 to %4 %5, %6")
                               .arg(heading, symbolOf(column.channel), numberText(low), numberText(high), unit, span));
        m_preview->setCurve(read.time, series->values);
    }
    m_preview->setAccessibleDescription(m_caption->text());
}

/// The numbers of the column all the same: they may tell what it is.
void ColumnMapping::previewIgnored()
{
    const QString heading = headingText(m_layout, m_current);
    m_caption->setText(tr("%1 is ignored").arg(heading));
    const Channel any{R1x, Order::Position};
    std::vector<ColumnChoice> choices = this->choices();
    std::erase_if(choices, [this](const ColumnChoice &choice) { return choice.column == m_current; });
    choices.push_back({m_current, ColumnRole::Channel, any, "mm"});
    const std::variant<ReferenceData, ReadError> outcome = readWith(choices);
    const ReferenceData *read = std::get_if<ReferenceData>(&outcome);
    if (const ReferenceSeries *series = read ? read->find(any) : nullptr) {
        const ValueRange range = rangeOf(series->values);
        m_caption->setText(
            tr("%1 is ignored: from %2 to %3").arg(heading, numberText(range.low), numberText(range.high)));
        m_preview->setCurve(read->time, series->values);
    }
    m_preview->setAccessibleDescription(m_caption->text());
}

bool ColumnMapping::eventFilter(QObject *watched, QEvent *event)
{
    auto *combo = qobject_cast<QComboBox *>(watched);
    if (event->type() == QEvent::Wheel && combo && !combo->hasFocus()) {
        event->ignore(); // the wheel scrolls the rows; it must not change what it passes over
        return true;
    }
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
    // A guess that was looked at and let stand is chosen.
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].chosen = m_rows[i].chosen || isGuess(m_layout.columns[i].reason);
    }
    rememberChoices(m_layout, m_paths, choices());
    QDialog::accept();
    emit chosen(m_paths);
}

} // namespace slidercrank
