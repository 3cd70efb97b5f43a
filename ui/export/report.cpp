// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report.h"
#include "ui/document/byte_stream.h"

#include "ui/text/axis_scale.h"
#include "ui/text/column_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct Report {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::Report)
};

using Kind = ReportBlock::Kind;

constexpr int kErrorDigits = 3; // as in the Errors tab

ReportBlock heading(const QString &text)
{
    return {Kind::Heading, text, {}};
}

ReportBlock paragraph(const QString &text, Kind kind = Kind::Text)
{
    return {kind, text, {}};
}

bool isFound(const ReportContent &content)
{
    return content.result->reference && content.diagnosis.identification.stands();
}

bool differs(const std::vector<ChannelComparison> &channels)
{
    return channels.empty() || std::ranges::count(channels, Verdict::Differs, &ChannelComparison::verdict) > 0;
}

QString nounOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return Report::tr("crank");
    case Parameter::B: return Report::tr("coupler");
    case Parameter::C: return Report::tr("offset");
    case Parameter::Omega2: return Report::tr("speed");
    case Parameter::Theta20: return Report::tr("start");
    }
    return {};
}

/// The drawing beside the numbers: the model's and, where one was found, those of the file's own mechanism.
ReportBlock mechanismBlock(const ReportContent &content)
{
    const Parameters &model = content.result->mechanism.parameters();
    const Identification &found = content.diagnosis.identification;
    ReportBlock block{Kind::Mechanism, {}, {{QString(), Report::tr("model")}, {}, QStringLiteral("tn")}};
    if (content.hasGhost) {
        block.text = content.result->reference ? Report::tr("Thin: the mechanism as the file has it.")
                                               : Report::tr("Thin: the mechanism that was kept.");
    }
    if (isFound(content)) {
        block.table.header << (found.hasOneMechanism() ? Report::tr("the file's own")
                                                       : Report::tr("one of the file's"));
        block.table.numeric += u'n';
    }
    for (const Parameter parameter : kParameters) {
        QStringList row{QStringLiteral("%1, %2").arg(symbolOf(parameter), nounOf(parameter)),
                        parameterText(parameter, valueOf(model, parameter))};
        if (isFound(content)) {
            row << measuredText(parameter, found);
        }
        block.table.rows.push_back(row);
    }
    QStringList assembly{Report::tr("assembly"), assemblyText(model.branch)};
    if (isFound(content)) {
        assembly << assemblyText(found.parameters.branch);
    }
    block.table.rows.push_back(assembly);
    return block;
}

/// What the thin curves are; empty where there are none.
QString keptText(const Result &result)
{
    QStringList motions;
    for (const Parameters &kept : result.kept) {
        motions << keptText(kept, result.mechanism.parameters());
    }
    return motions.isEmpty()
               ? QString()
               : Report::tr("Thin curves: motions that were kept, %1.").arg(motions.join(Report::tr("; ")));
}

ReportTable differenceTable(const MotionDifference &difference)
{
    ReportTable table{{Report::tr("channel"), Report::tr("largest difference"), Report::tr("at [s]"), Report::tr("rms"),
                       Report::tr("% of peak")},
                      {},
                      QStringLiteral("tnnnn")};
    for (const ChannelDifference &channel : difference.channels) {
        const bool isInfinite = channel.maxAbs && std::isinf(*channel.maxAbs);
        table.rows.push_back({QStringLiteral("%1 [%2]").arg(symbolOf(channel.channel), unitOf(channel.channel)),
                              isInfinite ? QStringLiteral("∞") : shortNumber(channel.maxAbs, kErrorDigits),
                              channel.maxAbs ? numberText(channel.timeOfMaxAbs) : dash(),
                              shortNumber(channel.rms, kErrorDigits),
                              shortNumber(channel.percentOfPeak, kErrorDigits)});
    }
    return table;
}

QString fileText(const Reference &reference)
{
    const std::vector<double> &time = reference.data.time;
    if (reference.data.crank) {
        return Report::tr("Reference: %1, %2, %3 angles.")
            .arg(reference.name, abscissaText(reference.data), countText(time.size()));
    }
    return Report::tr("Reference: %1, t = %2 s to %3 s, %4 instants.")
        .arg(reference.name, numberText(time.front()), numberText(time.back()), countText(time.size()));
}

/// When, and by what.
QString originText(const ReportContent &content)
{
    return Report::tr("%1, by %2 %3")
        .arg(QLocale().toString(content.written, QLocale::LongFormat), QCoreApplication::applicationName(),
             QCoreApplication::applicationVersion());
}

/// Which bytes were read; the sample that comes with the program has no place of its own.
QString identityText(const ReportContent &content)
{
    QStringList lines;
    const QStringList &paths = content.result->reference->paths;
    for (qsizetype i = 0; i < paths.size(); ++i) {
        const QString &path = paths[i];
        const QByteArray checksum = content.checksums.value(i);
        lines << Report::tr("File: %1\nSHA-256: %2")
                     .arg(path.startsWith(u':')   ? Report::tr("the sample that comes with the program")
                          : isStandardInput(path) ? shownNameOf(path)
                                                  : QDir::toNativeSeparators(QFileInfo(path).absoluteFilePath()),
                          checksum.isEmpty()
                              ? Report::tr("unknown: the file cannot be read again, or was changed since")
                              : QString::fromLatin1(checksum));
    }
    return lines.join(u'\n');
}

QString guessedText(const FileLayout &layout)
{
    QStringList parts;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (isGuess(column.reason)) {
            const QString meaning = column.role == ColumnRole::Channel
                                        ? Report::tr("%1 %2").arg(quantityOf(column.channel), symbolOf(column.channel))
                                        : meaningText(column);
            parts << Report::tr("“%1” as %2 (%3)").arg(headingText(layout, i), meaning, shortReasonText(layout, i));
        }
    }
    return parts.isEmpty() ? Report::tr("No column was guessed.")
                           : Report::tr("Columns guessed: %1.").arg(parts.join(Report::tr("; ")));
}

/// What was not used of the file; empty where all was.
QString leftOutText(const ReferenceData &data)
{
    QStringList parts;
    if (!data.skipped.empty()) {
        parts << Report::tr("%1 rows, the first in line %2 (\"%3\": %4)")
                     .arg(countText(data.skippedRowCount()), lineText(data.layout, data.skipped.front()),
                          QString::fromStdString(data.skipped.front().text), reasonOf(data.skipped.front()));
    }
    if (const QStringList ignored = ignoredHeadings(data.layout); !ignored.isEmpty()) {
        parts << Report::tr("the columns %1").arg(ignored.join(Report::tr(", ")));
    }
    return parts.isEmpty() ? QString() : Report::tr("Left out of the file: %1.").arg(parts.join(Report::tr("; ")));
}

ReportTable errorTable(const std::vector<ChannelComparison> &channels)
{
    ReportTable table{{Report::tr("channel"), Report::tr("largest error"), Report::tr("at [s]"), Report::tr("rms"),
                       Report::tr("largest %"), Report::tr("at [s]"), Report::tr("% of peak"),
                       Report::tr("file's step"), Report::tr("verdict")},
                      {},
                      QStringLiteral("tnnnnnnnt")};
    for (const ChannelComparison &channel : channels) {
        table.rows.push_back({QStringLiteral("%1 [%2]").arg(symbolOf(channel.channel), unitOf(channel.channel)),
                              shortNumber(channel.maxAbs, kErrorDigits),
                              channel.maxAbs ? numberText(channel.timeOfMaxAbs) : dash(),
                              shortNumber(channel.rms, kErrorDigits), shortNumber(channel.maxPercent, kErrorDigits),
                              channel.maxPercent ? numberText(channel.timeOfMaxPercent) : dash(),
                              shortNumber(channel.percentOfPeak, kErrorDigits),
                              numberText(channel.roundingStep, kErrorDigits), verdictText(channel)});
    }
    return table;
}

QString methodText(const Result &result)
{
    const NewtonOptions &newton = result.solver.newton;
    const Sampling &run = result.sampling;
    const QString instants =
        Report::tr("%1 instants from t = %2 s to %3 s.")
            .arg(countText(result.summary.instants), numberText(run.start), numberText(run.start + run.duration));
    if (result.solver.method == Method::ClosedForm) {
        return Report::tr("Closed form, exact to rounding. ") + instants;
    }
    const QString until =
        newton.tolerance == 0.0 ? Report::tr("until the residual ‖C‖ no longer falls")
        : newton.toleranceKind == ToleranceKind::Absolute
            ? Report::tr("until ‖C‖ ≤ %1 (absolute, mm and rad as they are)").arg(numberText(newton.tolerance))
            : Report::tr("until ‖C‖ ≤ %1 (relative, lengths divided by a + b + |c|)").arg(numberText(newton.tolerance));
    QString text = Report::tr("Newton-Raphson in the 12 absolute coordinates, %1, at most %2 iterations an instant. ")
                       .arg(until, QString::number(newton.maxIterations)) +
                   instants + u' ';
    const SamplingSummary &summary = result.summary;
    const QString residual = numberText(summary.largestResidual, 2);
    if (summary.found() > 0 && summary.mostIterations <= newton.maxIterations) {
        text += Report::tr("It took %1 iterations in all, %2 an instant at most; the largest residual is %3.")
                    .arg(countText(static_cast<std::size_t>(summary.iterations)),
                         QString::number(summary.mostIterations), residual);
    } else if (summary.found() > 0) {
        text +=
            Report::tr("Iterations: %1; the largest residual is %2.").arg(iterationsText(summary, newton), residual);
    }
    const std::size_t solved = summary.count(Status::Solved);
    if (solved < summary.instants) {
        text += Report::tr(" %1 of %2 instants are solved.").arg(countText(solved), countText(summary.instants));
    }
    if (const QString few = fewSamplesSentence(result.mechanism, run); !few.isEmpty()) {
        text += u' ' + few;
    }
    return text;
}

void addComparison(std::vector<ReportBlock> &blocks, const ReportContent &content)
{
    const Result &result = *content.result;
    const Diagnosis &found = content.diagnosis;
    blocks.push_back(
        paragraph(summaryOf(result.comparison), differs(result.comparison) ? Kind::Difference : Kind::Agreement));
    for (const QString &line : differenceLines(found, result.reference->data, result.mechanism)) {
        blocks.push_back(paragraph(line));
    }
}

void addIdentification(std::vector<ReportBlock> &blocks, const ReportContent &content)
{
    const Diagnosis &found = content.diagnosis;
    if (!isFound(content)) {
        if (!found.isOfMechanismAtHand) {
            blocks.push_back(paragraph(summaryOf(found)));
        }
        return;
    }
    const auto agreeing = std::ranges::count(found.identified, Verdict::Agrees, &ChannelComparison::verdict);
    const bool isOne = found.identification.hasOneMechanism();
    const bool hasErrors = found.identification.outcome != Identification::Outcome::Approximate;
    QString text = (isOne ? Report::tr("Against its own mechanism the file agrees in %1 of %2 channels.")
                          : Report::tr("Against the first of several mechanisms the file agrees in %1 of %2 channels."))
                       .arg(agreeing)
                       .arg(found.identified.size());
    if (const QString more = isOne && hasErrors ? caveatsOf(found) : summaryOf(found); !more.isEmpty()) {
        text += u' ' + more;
    }
    if (const QString rounded = roundNumbersText(found); !rounded.isEmpty()) {
        text += u' ' + rounded;
    }
    blocks.push_back(paragraph(text));
    QString note = (hasErrors ? Report::tr("Found by weighted least squares (Levenberg-Marquardt, %1 iterations, "
                                           "condition number %2); ± is one standard deviation.")
                              : Report::tr("Found by weighted least squares (Levenberg-Marquardt, %1 iterations, "
                                           "condition number %2)."))
                       .arg(found.identification.iterations)
                       .arg(shortNumber(found.identification.conditionNumber, 3));
    if (!found.conventions.empty()) {
        note += u' ' + Report::tr("The file was read with the conventions named above.");
    }
    blocks.push_back(paragraph(note, Kind::Note));
}

void addErrors(std::vector<ReportBlock> &blocks, const Result &result)
{
    blocks.push_back(heading(Report::tr("Errors: model against reference")));
    blocks.push_back({Kind::Table, {}, errorTable(result.comparison)});
    blocks.push_back(paragraph(
        Report::tr(
            "Largest error: max |model − reference|. Largest %: max |model − reference| / |reference| · 100 where "
            "the reference is not zero. File's step: distance of the numbers that the file can print, where it "
            "is largest. Within the file's rounding: at least %1 % of the values within half a step of their own and "
            "what the motion does in half a step of their instant (evenly spaced instants count as exact), none "
            "beyond %2 times that bound, nor by more than %4 % of half the motion's range. Close: none beyond %3 "
            "times, nor by more than %5 %.")
            .arg(kPercentWithinBound)
            .arg(kBoundsOfAgreement)
            .arg(kBoundsOfCloseness)
            .arg(numberText(100.0 * kExcessOfAgreement))
            .arg(numberText(100.0 * kExcessOfCloseness)),
        Kind::Note));
    if (const QString leftOut = leftOutText(result.reference->data); !leftOut.isEmpty()) {
        blocks.push_back(paragraph(leftOut, Kind::Note));
    }
}

} // namespace

std::vector<ReportBlock> reportOf(const ReportContent &content)
{
    const Result &result = *content.result;
    std::vector<ReportBlock> blocks{paragraph(Report::tr("Motion of an offset slider-crank"), Kind::Title),
                                    paragraph(originText(content), Kind::Note)};
    if (result.reference) {
        blocks.push_back(paragraph(fileText(*result.reference)));
        blocks.push_back(paragraph(identityText(content), Kind::Note));
        blocks.push_back(paragraph(guessedText(result.reference->data.layout), Kind::Note));
        addComparison(blocks, content);
    }
    blocks.push_back(heading(Report::tr("Mechanism")));
    blocks.push_back(mechanismBlock(content));
    if (result.reference) {
        addIdentification(blocks, content);
        addErrors(blocks, result);
    }
    if (result.difference) {
        blocks.push_back(heading(
            Report::tr("This mechanism − kept %1").arg(keptText(result.kept.back(), result.mechanism.parameters()))));
        blocks.push_back({Kind::Table, {}, differenceTable(*result.difference)});
    }
    blocks.push_back(heading(Report::tr("Method")));
    blocks.push_back(paragraph(methodText(result)));
    blocks.push_back(heading(result.reference ? Report::tr("Motion and errors") : Report::tr("Motion")));
    if (const QString kept = keptText(result); !kept.isEmpty()) {
        blocks.push_back(paragraph(kept));
    }
    blocks.push_back({Kind::Figure, {}, {}});
    return blocks;
}

} // namespace slidercrank
