// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/error_panel.h"

#include "ui/widgets/named.h"
#include "ui/widgets/number_table.h"
#include "ui/widgets/paragraph.h"
#include "ui/document/result.h"
#include "ui/panels/empty_page.h"
#include "ui/text/axis_scale.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kErrorDigits = 3;
constexpr int kInstantDigits = 4; // of one that is computed

/// Between two fillings while the parameters move: nobody reads faster, and a filling takes longer than nine plots.
constexpr std::chrono::milliseconds kPause{100};

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
        return std::ranges::count(comparison, verdict, &ChannelComparison::verdict) > 0;
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
                           .arg(QString::fromUtf8(row.text).toHtmlEscaped(), reasonOf(row));
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

TableRow errorRowOf(const ChannelComparison &channel, const SeriesColours &colours)
{
    const QString unit = unitOf(channel.channel);
    const auto withUnit = [&unit](const QString &text) {
        return text == dash() ? text : text + QLatin1Char(' ') + unit;
    };
    const auto cell = [](const QString &text, const QString &explanation) {
        return TableCell{.text = text, .explanation = explanation};
    };
    const bool exists = channel.maxAbs.has_value();
    const QString goThere = ErrorPanel::tr("Click to go to the instant of the largest error");
    QString nameTip =
        ErrorPanel::tr("%1 in the file, %2 instants").arg(columnNameOf(channel.channel)).arg(channel.count);
    if (channel.missingModel > 0) {
        nameTip += ErrorPanel::tr("; at %1 more there is no motion to compare with").arg(channel.missingModel);
    }
    TableCell outcome = cell(markOf(channel.verdict) + verdictText(channel),
                             ErrorPanel::tr("%1\n%2").arg(verdictText(channel), verdictFormula(channel)));
    outcome.shortText = markOf(channel.verdict) + shortVerdict(channel.verdict);
    outcome.ink = verdictColour(channel.verdict, colours);
    TableCell percent = cell(shortNumber(channel.maxPercent, kErrorDigits),
                             ErrorPanel::tr("max |model − reference| / |reference| · 100"));
    if (channel.zeroReference > 0) {
        percent.explanation += ErrorPanel::tr("\nWhere the reference is zero it is infinite, and left out: %1×")
                                   .arg(channel.zeroReference);
        percent.text += ErrorPanel::tr(" (%1×∞)").arg(channel.zeroReference);
    }
    TableCell percentAt = cell(channel.maxPercent ? numberText(channel.timeOfMaxPercent) : dash(),
                               ErrorPanel::tr("Click to go to the instant of the largest percentage"));
    if (channel.maxPercent) {
        percent.instant = percentAt.instant = channel.timeOfMaxPercent;
    }
    TableRow row{
        MechanismPart::None,
        {cell(ErrorPanel::tr("%1 [%2]").arg(symbolOf(channel.channel), unit), nameTip), outcome,
         cell(shortNumber(channel.maxAbs, kErrorDigits),
              exists ? ErrorPanel::tr("max |model − reference| = %1\n%2")
                           .arg(withUnit(shortNumber(channel.maxAbs, kErrorDigits)), goThere)
                     : QString()),
         cell(exists ? numberText(channel.timeOfMaxAbs) : dash(), goThere),
         cell(shortNumber(channel.rms, kErrorDigits), ErrorPanel::tr("√( mean of (model − reference)² ) = %1")
                                                          .arg(withUnit(shortNumber(channel.rms, kErrorDigits)))),
         percent, percentAt,
         cell(shortNumber(channel.percentOfPeak, kErrorDigits),
              ErrorPanel::tr("max |model − reference| / max |reference| · 100")),
         cell(numberText(channel.roundingStep, kErrorDigits),
              channel.roundingStep ? ErrorPanel::tr("The file writes this channel in steps of %1 at most")
                                         .arg(withUnit(numberText(channel.roundingStep, kErrorDigits)))
                                   : ErrorPanel::tr("How the file was rounded is unknown"))},
        exists ? std::optional(channel.timeOfMaxAbs) : std::nullopt};
    row.cells[0].csv = QStringLiteral("%1 [%2]").arg(columnNameOf(channel.channel), unit);
    row.cells[1].csv = verdictText(channel);
    const std::optional<double> numbers[] = {channel.maxAbs,      row.instant,       channel.rms,
                                             channel.maxPercent,  percentAt.instant, channel.percentOfPeak,
                                             channel.roundingStep};
    for (std::size_t i = 0; i < std::size(numbers); ++i) {
        TableCell &number = row.cells[2 + i];
        number.number = numbers[i];
        number.csv = dash(); // where there is none
    }
    return row;
}

TableRow differenceRowOf(const ChannelDifference &channel)
{
    const QString unit = unitOf(channel.channel);
    const auto cell = [](std::optional<double> number) {
        const bool isInfinite = number && std::isinf(*number);
        return TableCell{.text = isInfinite ? QStringLiteral("∞") : shortNumber(number, kErrorDigits),
                         .number = isInfinite ? std::nullopt : number};
    };
    const std::optional<double> instant = channel.maxAbs ? std::optional(channel.timeOfMaxAbs) : std::nullopt;
    TableCell largest = cell(channel.maxAbs);
    largest.explanation = channel.maxAbs && std::isinf(*channel.maxAbs)
                              ? ErrorPanel::tr("Without bounds where one of the two ends its stroke")
                              : ErrorPanel::tr("Click to go to the instant of the largest difference");
    TableCell at = cell(instant);
    at.text = instant ? numberText(*instant, kInstantDigits) : dash();
    TableRow row{MechanismPart::None,
                 {TableCell{.text = ErrorPanel::tr("%1 [%2]").arg(symbolOf(channel.channel), unit)}, largest, at,
                  cell(channel.rms), cell(channel.percentOfPeak)},
                 instant};
    row.cells[0].csv = QStringLiteral("%1 [%2]").arg(columnNameOf(channel.channel), unit);
    return row;
}

} // namespace

ErrorPanel::ErrorPanel(QWidget *parent)
    : QWidget(parent)
{
    named("errorPanel", this, tr("Errors against the reference"));
    m_pages = new QStackedWidget;
    m_pages->addWidget(
        emptyPage(this, tr("Load a simulation's exported motion (CSV) to see how far it is from this mechanism: the "
                           "largest error of each channel, where it is, and whether it is more than the file's own "
                           "rounding.")));
    m_pages->addWidget(createTablePage());
    m_pages->addWidget(createKeptPage());
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

QWidget *ErrorPanel::createTablePage()
{
    m_verdict = named("verdictLabel", plainText());

    m_table = new NumberTable(
        QStringLiteral("errorTable"), tr("Errors, a row a channel"),
        {{tr("channel"), tr("What is compared, and its unit"), QStringLiteral("channel"), false},
         {tr("verdict"),
          tr("agrees: at least 95 % of the values within the file's rounding, none beyond ten times that\n"
             "close: none beyond a hundred times\n"
             "differs: anything else, and what lies beyond the rounding by 1 % of half the motion's range"),
          QStringLiteral("verdict"), false},
         {tr("max error"), tr("max |model − reference|, in the channel's unit"), QStringLiteral("max_error")},
         {tr("at [s]"), tr("Instant of the largest error"), QStringLiteral("max_error_at [s]")},
         {tr("rms"), tr("√( mean of (model − reference)² ), in the channel's unit"), QStringLiteral("rms")},
         {tr("max %"),
          tr("max |model − reference| / |reference| · 100, as in the report, over the instants where the "
             "reference is not zero"),
          QStringLiteral("max_percent")},
         {tr("at [s]"), tr("Instant of the largest percentage"), QStringLiteral("max_percent_at [s]")},
         {tr("% of peak"), tr("max |model − reference| / max |reference| · 100"), QStringLiteral("percent_of_peak")},
         {tr("step"),
          tr("One unit of the last digit that the file writes, where it is largest, in the channel's unit. Rounding "
             "alone makes an error of up to half of it."),
          QStringLiteral("step")}},
        TableLook::Striped);
    connect(m_table, &NumberTable::instantRequested, this, &ErrorPanel::timeRequested);
    connect(m_table, &NumberTable::copied, this, &ErrorPanel::rowsCopied);

    m_findings = new FindingList;
    connect(m_findings, &FindingList::remedyRequested, this, &ErrorPanel::remedyRequested);

    m_leftOut = named("leftOutLabel", new QLabel);
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

QWidget *ErrorPanel::createKeptPage()
{
    m_kept = named("keptLabel", plainText());
    m_keptTable = new NumberTable(
        QStringLiteral("differenceTable"), tr("Differences from the kept motion, a row a channel"),
        {{tr("channel"), tr("What is compared, and its unit"), QStringLiteral("channel"), false},
         {tr("largest difference"), tr("max |this − kept|, in the channel's unit"), QStringLiteral("max_difference")},
         {tr("at [s]"), tr("Instant of the largest difference"), QStringLiteral("max_difference_at [s]")},
         {tr("rms"), tr("√( mean of (this − kept)² ), in the channel's unit"), QStringLiteral("rms")},
         {tr("% of peak"), tr("max |this − kept| / max |kept| · 100"), QStringLiteral("percent_of_peak")}},
        TableLook::Striped);
    connect(m_keptTable, &NumberTable::instantRequested, this, &ErrorPanel::timeRequested);
    connect(m_keptTable, &NumberTable::copied, this, &ErrorPanel::rowsCopied);

    auto *page = new QWidget;
    auto *rows = new QVBoxLayout(page);
    rows->setContentsMargins(6, 6, 6, 4);
    rows->setSpacing(4);
    rows->addWidget(m_kept);
    rows->addWidget(m_keptTable, 1);
    return page;
}

void ErrorPanel::setResult(const std::shared_ptr<const Result> &result)
{
    m_result = result;
    refresh();
}

void ErrorPanel::setDiagnosis(const std::shared_ptr<const ReferenceDiagnosis> &diagnosis)
{
    m_diagnosis = diagnosis;
    refresh();
}

void ErrorPanel::refresh()
{
    m_stale = true;
    const bool tooSoon = m_pause.isActive() && (isOnTheMove() || (m_result && m_result->difference));
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

void ErrorPanel::fill()
{
    m_stale = false;
    m_pause.start();
    enum Page { Empty, OfFile, OfKept };
    const Page page = m_result && m_result->reference ? OfFile : m_result && m_result->difference ? OfKept : Empty;
    m_pages->setCurrentIndex(page);
    if (page == OfKept) {
        fillKept();
    }
    if (page != OfFile) {
        return;
    }
    const Verdict worst = worstOf(m_result->comparison);
    m_verdict->setText(tr("%1%2: %3").arg(markOf(worst), m_result->reference->name, summaryOf(m_result->comparison)));
    setInk(*m_verdict, verdictColour(worst, seriesColours(palette())));
    fillFindings();

    const LeftOut leftOut = leftOutOf(m_result->reference->data);
    m_leftOut->setText(leftOut.line);
    m_leftOut->setToolTip(leftOut.details);
    m_leftOut->setVisible(!leftOut.line.isEmpty());
    fillTable();
}

bool ErrorPanel::isOnTheMove() const
{
    const bool ofThisFile = m_diagnosis && m_diagnosis->reference == m_result->chosenReference();
    return ofThisFile && m_diagnosis->parameters != m_result->mechanism.parameters();
}

void ErrorPanel::fillFindings()
{
    // What was found for others stays, dimmed, lest the panel jump under the hand.
    const bool outOfDate = isOnTheMove() && worstOf(m_result->comparison) != Verdict::Agrees;
    if (!outOfDate) {
        const bool ofThese = m_diagnosis && m_diagnosis->reference == m_result->chosenReference() && !isOnTheMove();
        m_findings->setFindings(findingsOf(*m_result, ofThese ? m_diagnosis.get() : nullptr));
    }
    m_findings->setUpToDate(!outOfDate);
}

void ErrorPanel::fillKept()
{
    const Parameters &present = m_result->mechanism.parameters();
    const Parameters &kept = m_result->kept.back();
    QString title = present == kept ? tr("This mechanism is the one that was kept: change it to see what differs.")
                                    : tr("This mechanism − kept %1").arg(keptText(kept, present));
    if (m_result->difference->hasGaps) {
        title += tr(". Where one of the two cannot be assembled there is nothing to compare.");
    }
    m_kept->setText(title);
    std::vector<TableRow> rows;
    for (const ChannelDifference &channel : m_result->difference->channels) {
        rows.push_back(differenceRowOf(channel));
    }
    constexpr int kMostAir = 28; // px
    m_keptTable->setRows(std::move(rows));
    m_keptTable->fitToContents(0, kMostAir);
}

void ErrorPanel::fillTable()
{
    constexpr int kMostAir = 28; // px
    const SeriesColours colours = seriesColours(palette());
    std::vector<TableRow> rows;
    for (const ChannelComparison &channel : m_result->comparison) {
        rows.push_back(errorRowOf(channel, colours));
    }
    m_table->setRows(std::move(rows));
    if (!isOnTheMove()) { // else the columns stay as wide as they are
        m_table->fitToContents(0, kMostAir);
    }
}

} // namespace slidercrank
