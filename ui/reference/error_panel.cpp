// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reference/error_panel.h"

#include "ui/controls/paragraph.h"
#include "ui/document/diagnosis.h"
#include "ui/words/axis_scale.h"
#include "ui/words/column_text.h"
#include "ui/words/finding_text.h"
#include "ui/words/read_fault_text.h"
#include "ui/words/theme.h"
#include "ui/words/written_number.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <chrono>

namespace slidercrank
{

namespace
{

enum ErrorColumn {
    Name,
    Outcome,
    LargestError,
    LargestErrorAt,
    Rms,
    LargestPercent,
    LargestPercentAt,
    PercentOfPeak,
    RoundingStep
};
constexpr int kErrorColumnCount = 9;
constexpr int kErrorDigits = 3;

/// Between two fillings while the parameters move: nobody reads faster, and a filling takes longer than nine plots.
constexpr std::chrono::milliseconds kPause{100};

QString dash()
{
    return QStringLiteral("–");
}

QString errorText(const std::optional<double> &value)
{
    return value ? shortNumber(*value, kErrorDigits, QLocale()) : dash();
}

QString stepText(const std::optional<double> &value)
{
    return value ? numberText(*value, kErrorDigits) : dash();
}

QString instantText(double seconds)
{
    return numberText(seconds, 6);
}

QString markOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return QStringLiteral("✓ ");
    case Verdict::Close: return QStringLiteral("≈ ");
    case Verdict::Differs: return QStringLiteral("✗ ");
    }
    return {};
}

QString shortVerdict(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return ErrorPanel::tr("agrees");
    case Verdict::Close: return ErrorPanel::tr("close");
    case Verdict::Differs: return ErrorPanel::tr("differs");
    }
    return {};
}

QColor verdictColour(Verdict verdict, const SeriesColours &colours)
{
    switch (verdict) {
    case Verdict::Agrees: return colours.errorOther;
    case Verdict::Close: return colours.reference;
    case Verdict::Differs: return colours.warning;
    }
    return {};
}

Verdict worstOf(const std::vector<ChannelComparison> &comparison)
{
    const auto holds = [&comparison](Verdict verdict) {
        return std::ranges::any_of(comparison,
                                   [verdict](const ChannelComparison &channel) { return channel.verdict == verdict; });
    };
    return comparison.empty() || holds(Verdict::Differs) ? Verdict::Differs
           : holds(Verdict::Close)                       ? Verdict::Close
                                                         : Verdict::Agrees;
}

/// One line about rows and columns of the file that were not used; details, a line each.
struct LeftOut {
    QString line;
    QString details;
};

LeftOut leftOutOf(const ReferenceData &data)
{
    constexpr std::size_t kMostDetails = 12;
    QStringList parts;
    QStringList details;
    if (!data.skipped.empty()) {
        const std::size_t skipped = data.skippedRowCount();
        parts << (skipped == 1 ? ErrorPanel::tr("1 row of the file was skipped (line %1)").arg(data.skipped[0].line)
                               : ErrorPanel::tr("%1 rows of the file were skipped").arg(skipped));
        for (std::size_t i = 0; i < std::min(kMostDetails, data.skipped.size()); ++i) {
            const SkippedRow &row = data.skipped[i];
            details << ErrorPanel::tr("Line %1, column %2: “%3” %4")
                           .arg(row.line)
                           .arg(row.column)
                           .arg(textOf(row.text).toHtmlEscaped(), reasonOf(row));
        }
        if (skipped > kMostDetails) {
            details << ErrorPanel::tr("… and %1 more").arg(skipped - kMostDetails);
        }
    }
    if (const QStringList ignored = ignoredHeadings(data.layout); !ignored.isEmpty()) {
        parts << (ignored.size() == 1 ? ErrorPanel::tr("1 column was ignored")
                                      : ErrorPanel::tr("%1 columns were ignored").arg(ignored.size()));
        details << ErrorPanel::tr("Ignored: %1").arg(ignored.join(ErrorPanel::tr(", ")).toHtmlEscaped());
    }
    if (parts.isEmpty()) {
        return {};
    }
    return {parts.join(ErrorPanel::tr("; ")) + ErrorPanel::tr("."), details.join(QStringLiteral("<br>"))};
}

} // namespace

ErrorPanel::ErrorPanel(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("errorPanel"));
    setAccessibleName(tr("Errors against the reference"));
    m_pages = new QStackedWidget;
    m_pages->addWidget(createEmptyPage());
    m_pages->addWidget(createTablePage());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);

    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_stale && isVisible()) {
            fill();
        }
    });
}

QWidget *ErrorPanel::createEmptyPage()
{
    auto *purpose =
        new Paragraph(tr("Load a simulation's exported motion (CSV) to see how far it is from this mechanism: the "
                         "largest error of each channel, where it is, and whether it is more than the file's own "
                         "rounding."));
    purpose->setAlignment(Qt::AlignCenter);
    auto *openReference = new QPushButton(tr("Open reference…"));
    openReference->setObjectName(QStringLiteral("openReferenceButton"));
    auto *openSample = new QPushButton(tr("Open the sample"));
    openSample->setObjectName(QStringLiteral("openSampleButton"));
    openSample->setToolTip(tr("The motion that the report's author exported from Inventor"));
    connect(openReference, &QPushButton::clicked, this, &ErrorPanel::openReferenceRequested);
    connect(openSample, &QPushButton::clicked, this, &ErrorPanel::openSampleRequested);

    auto *buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(openReference);
    buttons->addWidget(openSample);
    buttons->addStretch(1);
    auto *page = new QWidget;
    auto *rows = new QVBoxLayout(page);
    rows->addStretch(1);
    rows->addWidget(purpose);
    rows->addLayout(buttons);
    rows->addStretch(1);
    return page;
}

QWidget *ErrorPanel::createTablePage()
{
    m_verdict = new Paragraph;
    m_verdict->setObjectName(QStringLiteral("verdictLabel"));
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);

    struct Header {
        QString title;
        QString explanation;
    };
    const std::array<Header, kErrorColumnCount> headers{{
        {tr("channel"), tr("What is compared, and its unit")},
        {tr("verdict"),
         tr("agrees: at least 95 % of the values within half a step of the file, none beyond ten halves\n"
            "close: none beyond a hundred halves\n"
            "differs: anything else")},
        {tr("max error"), tr("max |model − reference|, in the channel's unit")},
        {tr("at [s]"), tr("Instant of the largest error")},
        {tr("rms"), tr("√( mean of (model − reference)² ), in the channel's unit")},
        {tr("max %"), tr("max |model − reference| / |reference| · 100, as in the report, over the instants where the "
                         "reference is not zero")},
        {tr("at [s]"), tr("Instant of the largest percentage")},
        {tr("% of peak"), tr("max |model − reference| / max |reference| · 100")},
        {tr("step"), tr("Distance between neighbouring numbers that the file can write, where it is largest, in the "
                        "channel's unit. Rounding alone makes an error of half of it.")},
    }};
    m_table = new QTableWidget(0, kErrorColumnCount);
    m_table->setObjectName(QStringLiteral("errorTable"));
    m_table->setAccessibleName(tr("Errors, a row a channel"));
    for (int column = 0; column < kErrorColumnCount; ++column) {
        const Header &header = headers[static_cast<std::size_t>(column)];
        auto *item = new QTableWidgetItem(header.title);
        item->setToolTip(header.explanation);
        item->setTextAlignment(column == Name || column == Outcome ? Qt::AlignLeft | Qt::AlignVCenter
                                                                   : Qt::AlignRight | Qt::AlignVCenter);
        m_table->setHorizontalHeaderItem(column, item);
    }
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed); // one line each, all as high
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->installEventFilter(this);
    m_table->viewport()->installEventFilter(this);
    connect(m_table, &QTableWidget::cellClicked, this, &ErrorPanel::goToError);

    m_findings = new FindingList;
    connect(m_findings, &FindingList::remedyRequested, this, &ErrorPanel::remedyRequested);

    m_leftOut = new QLabel;
    m_leftOut->setObjectName(QStringLiteral("leftOutLabel"));
    m_leftOut->setTextFormat(Qt::PlainText);
    m_leftOut->setWordWrap(true);

    auto *page = new QWidget;
    auto *rows = new QVBoxLayout(page);
    rows->setContentsMargins(6, 6, 6, 4);
    rows->setSpacing(4);
    rows->addWidget(m_verdict);
    rows->addWidget(m_findings);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_leftOut);
    return page;
}

void ErrorPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_result = result;
    refresh();
}

void ErrorPanel::setDiagnosis(const std::shared_ptr<const Diagnosis> &diagnosis)
{
    m_diagnosis = diagnosis;
    refresh();
}

void ErrorPanel::refresh()
{
    m_stale = true;
    const bool tooSoon = m_pause.isActive() && isOnTheMove();
    if (isVisible() && !tooSoon) {
        fill();
    }
}

void ErrorPanel::showEvent(QShowEvent *event)
{
    if (m_stale) {
        fill();
    }
    QWidget::showEvent(event);
}

void ErrorPanel::changeEvent(QEvent *event)
{
    const bool repaints = event->type() == QEvent::PaletteChange || event->type() == QEvent::LocaleChange;
    if (repaints && m_result) {
        refresh();
    }
    QWidget::changeEvent(event);
}

bool ErrorPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && m_table->currentRow() >= 0) {
            goToError(m_table->currentRow(), LargestError);
            return true;
        }
    }
    if (watched == m_table->viewport() && event->type() == QEvent::Resize) {
        fitColumns();
    }
    return QWidget::eventFilter(watched, event);
}

void ErrorPanel::fitColumns()
{
    if (!m_result || m_table->rowCount() != static_cast<int>(m_result->comparison.size())) {
        return; // laid out while it comes on show, with what is not filled in yet
    }
    constexpr int kMostAir = 28;
    const auto widthNeeded = [this] {
        int width = 0;
        for (int column = 0; column < kErrorColumnCount; ++column) {
            m_table->resizeColumnToContents(column);
            width += m_table->columnWidth(column);
        }
        return width;
    };
    const int room = m_table->viewport()->width();
    m_shortVerdicts = false;
    wordVerdicts();
    int needed = widthNeeded();
    if (needed > room) {
        m_shortVerdicts = true;
        wordVerdicts();
        needed = widthNeeded();
    }
    const int air = std::clamp((room - needed) / kErrorColumnCount, 0, kMostAir);
    for (int column = 0; column < kErrorColumnCount; ++column) {
        m_table->setColumnWidth(column, m_table->columnWidth(column) + air);
    }
}

void ErrorPanel::wordVerdicts()
{
    const QSignalBlocker oneByOne(m_table->model());
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ChannelComparison &channel = m_result->comparison[static_cast<std::size_t>(row)];
        m_table->item(row, Outcome)
            ->setText(markOf(channel.verdict) +
                      (m_shortVerdicts ? shortVerdict(channel.verdict) : verdictText(channel)));
    }
}

void ErrorPanel::fill()
{
    m_stale = false;
    m_pause.start();
    const bool compared = m_result && m_result->reference;
    m_pages->setCurrentIndex(compared ? 1 : 0);
    if (!compared) {
        return;
    }
    const Verdict worst = worstOf(m_result->comparison);
    m_verdict->setText(tr("%1%2: %3").arg(markOf(worst), m_result->reference->name, summaryOf(m_result->comparison)));
    QPalette verdictPalette = palette();
    verdictPalette.setColor(QPalette::WindowText, verdictColour(worst, seriesColours(palette())));
    m_verdict->setPalette(verdictPalette);
    fillFindings();

    const LeftOut leftOut = leftOutOf(m_result->reference->data);
    m_leftOut->setText(leftOut.line);
    m_leftOut->setToolTip(leftOut.details);
    m_leftOut->setVisible(!leftOut.line.isEmpty());
    fillTable();
}

bool ErrorPanel::isOnTheMove() const
{
    const bool ofThisFile = m_diagnosis && m_diagnosis->reference == m_result->reference;
    return ofThisFile && m_diagnosis->parameters != m_result->mechanism.parameters();
}

void ErrorPanel::fillFindings()
{
    // What was found for others stays, dimmed, lest the panel jump under the hand.
    const bool outOfDate = isOnTheMove() && worstOf(m_result->comparison) != Verdict::Agrees;
    if (!outOfDate) {
        const bool ofThese = m_diagnosis && m_diagnosis->reference == m_result->reference && !isOnTheMove();
        m_findings->setFindings(findingsOf(*m_result, ofThese ? m_diagnosis.get() : nullptr));
    }
    m_findings->setUpToDate(!outOfDate);
}

void ErrorPanel::fillTable()
{
    const SeriesColours colours = seriesColours(palette());
    const std::vector<ChannelComparison> &comparison = m_result->comparison;
    m_table->setRowCount(static_cast<int>(comparison.size()));
    m_table->verticalHeader()->setDefaultSectionSize(m_table->verticalHeader()->minimumSectionSize());
    const QSignalBlocker oneByOne(m_table->model()); // each item would be painted, measured and laid out by itself
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ChannelComparison &channel = comparison[static_cast<std::size_t>(row)];
        const QString unit = unitOf(channel.channel);
        const auto set = [this, row](int column, const QString &text, const QString &tip = QString()) {
            QTableWidgetItem *item = m_table->item(row, column);
            if (!item) {
                item = new QTableWidgetItem;
                item->setTextAlignment(column == Name || column == Outcome ? Qt::AlignLeft | Qt::AlignVCenter
                                                                           : Qt::AlignRight | Qt::AlignVCenter);
                m_table->setItem(row, column, item);
            }
            item->setText(text);
            item->setToolTip(tip);
            return item;
        };
        const bool exists = channel.maxAbs.has_value();
        const auto withUnit = [&unit](const QString &text) {
            return text == dash() ? text : text + QLatin1Char(' ') + unit;
        };
        const QString goThere = tr("Click to go to the instant of the largest error");
        QString nameTip = tr("%1 in the file, %2 instants").arg(columnNameOf(channel.channel)).arg(channel.count);
        if (channel.missingModel > 0) {
            nameTip += tr("; at %1 more there is no motion to compare with").arg(channel.missingModel);
        }
        set(Name, tr("%1 [%2]").arg(symbolOf(channel.channel), unit), nameTip);
        set(LargestError, errorText(channel.maxAbs),
            exists ? tr("max |model − reference| = %1\n%2").arg(withUnit(errorText(channel.maxAbs)), goThere)
                   : QString());
        set(LargestErrorAt, exists ? instantText(channel.timeOfMaxAbs) : dash(), goThere);
        set(Rms, errorText(channel.rms),
            tr("√( mean of (model − reference)² ) = %1").arg(withUnit(errorText(channel.rms))));
        QString percent = errorText(channel.maxPercent);
        QString percentTip = tr("max |model − reference| / |reference| · 100");
        if (channel.zeroReference > 0) {
            percentTip += tr("\nInfinite at %1 instants where the reference is zero; they are left out")
                              .arg(channel.zeroReference);
            percent += tr(" (%1×∞)").arg(channel.zeroReference);
        }
        set(LargestPercent, percent, percentTip);
        set(LargestPercentAt, channel.maxPercent ? instantText(channel.timeOfMaxPercent) : dash(),
            tr("Click to go to the instant of the largest percentage"));
        set(PercentOfPeak, errorText(channel.percentOfPeak), tr("max |model − reference| / max |reference| · 100"));
        set(RoundingStep, stepText(channel.roundingStep),
            channel.roundingStep ? tr("The file writes this channel in steps of %1 at most")
                                       .arg(withUnit(stepText(channel.roundingStep)))
                                 : tr("The file does not show how it was rounded"));
        QTableWidgetItem *outcome = set(Outcome, {}, tr("%1\n%2").arg(verdictText(channel), verdictFormula(channel)));
        outcome->setForeground(verdictColour(channel.verdict, colours));
    }
    if (isOnTheMove()) {
        wordVerdicts(); // the columns stay as wide as they are
    } else {
        fitColumns();
    }
    m_table->viewport()->update();
}

void ErrorPanel::goToError(int row, int column)
{
    const ChannelComparison &channel = m_result->comparison[static_cast<std::size_t>(row)];
    const bool percent = column == LargestPercent || column == LargestPercentAt;
    if (percent && channel.maxPercent) {
        emit timeRequested(channel.timeOfMaxPercent);
    } else if (channel.maxAbs) {
        emit timeRequested(channel.timeOfMaxAbs);
    }
}

} // namespace slidercrank
