// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/reference_page.h"

#include "ui/panels/error_page.h"
#include "ui/text/column_text.h"
#include "ui/text/identification_text.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct ReferencePage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReferencePage)

public:
    static TableRow textRow(const QStringList &texts)
    {
        TableRow row;
        for (const QString &text : texts) {
            row.cells.push_back({.text = text});
        }
        return row;
    }

    static QString valueCountText(const ReferenceSeries &series)
    {
        const auto isGap = [](double value) { return std::isnan(value); };
        const auto gaps = static_cast<std::size_t>(std::ranges::count_if(series.values, isGap));
        const QString values = QString::number(series.values.size() - gaps);
        return gaps == 0 ? values : tr("%1, gaps: %2").arg(values, QString::number(gaps));
    }

    static TableRow columnRow(const ReferenceData &data, std::size_t column)
    {
        const FileColumn &fileColumn = data.layout.columns[column];
        const bool isAbscissa = fileColumn.role == ColumnRole::Time || fileColumn.role == ColumnRole::CrankAngle;
        const ReferenceSeries *series =
            fileColumn.role == ColumnRole::Channel ? data.find(fileColumn.channel) : nullptr;
        QString valueCount = dash();
        if (series) {
            valueCount = valueCountText(*series);
        } else if (isAbscissa) {
            valueCount = QString::number(data.time.size());
        }
        TableRow row =
            textRow({headingWithoutFile(data.layout, column), unitText(fileColumn), meaningText(fileColumn),
                     series ? roundingText(series->rounding) : dash(), valueCount, reasonText(data.layout, column)});
        row.explanation = reasonText(data.layout, column);
        for (TableCell &cell : row.cells) {
            cell.tone = fileColumn.role == ColumnRole::Ignored ? Tone::Muted : Tone::Normal;
        }
        if (isGuess(fileColumn.reason)) {
            row.cells.back().tone = Tone::Fair;
        }
        return row;
    }

    /// Returns a table of text without rows. `csvNames`: the names of the columns in CSV.
    static PageTable textTable(const QString &name, const QString &title, const QStringList &headings,
                               const QStringList &csvNames)
    {
        PageTable table{.name = name, .title = title, .columns = {}};
        for (qsizetype i = 0; i < headings.size(); ++i) {
            table.columns.push_back({.title = headings[i], .csvName = csvNames[i], .isNumber = false});
        }
        return table;
    }

    static PageTable columnTable(const ReferenceData &data)
    {
        PageTable table =
            textTable("columnTable", tr("Columns of the file, a row for each"),
                      {tr("heading"), tr("unit"), tr("read as"), tr("rounded to"), tr("values"), tr("why")},
                      {"heading", "unit", "read_as", "rounded_to", "values", "why"});
        constexpr std::size_t kReadAsColumn = 2;
        constexpr std::size_t kRoundedToColumn = 3;
        table.columns[kReadAsColumn].isFormula = true; // "R_y⁴"
        table.columns[kRoundedToColumn].explanation = tr("Inferred from all values of the column");
        const FileLayout &layout = data.layout;
        for (std::size_t i = 0; i < layout.columns.size(); ++i) {
            if (!layout.files.empty() && (i == 0 || layout.columns[i].file != layout.columns[i - 1].file)) {
                table.rows.push_back(
                    textRow({QString::fromUtf8(layout.files[layout.columns[i].file]), {}, {}, {}, {}, {}}));
            }
            if (!repeatsTimeStamps(layout, i)) {
                table.rows.push_back(columnRow(data, i));
            }
        }
        return table;
    }

    static PageTable skippedTable(const ReferenceData &data)
    {
        PageTable table =
            textTable("skippedTable", tr("Rows of the file that were skipped"),
                      {tr("skipped line"), tr("column"), tr("text"), tr("why")}, {"line", "column", "text", "why"});
        for (const SkippedRow &row : data.skipped) {
            table.rows.push_back(
                textRow({lineText(data.layout, row), row.column == 0 ? QString() : QString::number(row.column),
                         QString::fromUtf8(row.text), rowFaultText(row)}));
        }
        return table;
    }

    static Finding mechanismFinding(const Result &result, const ReferenceIdentification *identification)
    {
        if (!belongsToCurrentFile(identification, result)) {
            return {tr("Searching for the mechanism of this file…")};
        }
        const Identification &found = identification->found;
        Finding finding{summaryText(found)};
        if (const QString rounded = roundNumbersText(found); !rounded.isEmpty()) {
            finding.sentence += u'\n' + rounded;
        }
        offerMechanism(finding, found, result.mechanism.parameters());
        return finding;
    }
};

} // namespace

Page referencePage(const Result &result, const ReferenceIdentification *identification)
{
    if (!result.reference) {
        Page page;
        page.findings = {noOpenFileFinding(ReferencePage::tr("No file is open."))};
        return page;
    }
    const ReferenceData &data = result.reference->data;
    QString rows = QString::number(data.time.size());
    if (!data.time.empty()) {
        rows += ", " + abscissaText(data);
    }
    Page page;
    page.sentence = displayName(result.reference->source.paths);
    page.findings = {{.sentence = ReferencePage::tr("%1. Rows: %2.").arg(layoutText(data.layout), rows),
                      .remedy = Remedy::ChooseColumns,
                      .remedyText = ReferencePage::tr("Choose columns…")}};
    if (data.crank) {
        page.findings.push_back(
            {.sentence = ReferencePage::tr("The rows are indexed by the crank angle; ω₂ and θ₂₀ give the time.")});
    }
    page.findings.push_back(ReferencePage::mechanismFinding(result, identification));
    for (const Finding &finding : findingsOf(result, identification)) {
        if (finding.remedy == Remedy::ApplyConvention || finding.remedy == Remedy::ReadAsPrinted) {
            page.findings.push_back(finding);
        }
    }
    page.tables = {ReferencePage::columnTable(data), ReferencePage::skippedTable(data)};
    return page;
}

} // namespace slidercrank
