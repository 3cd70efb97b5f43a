// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/study_text.h"

#include "ui/text/axis_scale.h"
#include "ui/text/column_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slidercrank
{

namespace
{

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StudyText)
};

/// Translates "toggle gap 1e-4" by the pattern "toggle gap %1"; formulas stay.
QString propertyText(const QString &property)
{
    constexpr const char *kPatterns[] = {QT_TRANSLATE_NOOP("slidercrank::StudyText", "Table 1 of the report"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "this mechanism"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "the author's file"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "crossed"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "toggle gap %1"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "exact toggle"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "change point"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "a = b and c = 0"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "rocker"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "one arc"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "two arcs"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "rocker by a hair"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "gap %1"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "locked"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "never assemblable"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "lengths x %1"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "t near %1"),
                                         QT_TRANSLATE_NOOP("slidercrank::StudyText", "%1 steps a turn")};
    for (const char *pattern : kPatterns) {
        const QStringList around = QString::fromUtf8(pattern).split(QStringLiteral("%1"));
        if (around.size() == 1 && property == around[0]) {
            return StudyText::tr(pattern);
        }
        if (around.size() == 2 && property.startsWith(around[0]) && property.endsWith(around[1])) {
            return StudyText::tr(pattern).arg(
                property.sliced(around[0].size(), property.size() - around[0].size() - around[1].size()));
        }
    }
    return property;
}

constexpr double kAlike = 1.05; // ratios up to this say nothing

/// "4", "4.6", "130".
QString ratioText(double ratio)
{
    constexpr int kDigits = 2;
    constexpr double kWrittenOut = 1e6;
    const double step = std::pow(10.0, std::floor(std::log10(ratio)) - (kDigits - 1));
    return ratio < kWrittenOut ? numberText(step * std::round(ratio / step)) : shortNumber(ratio, kDigits);
}

const MethodResult *rowOf(const CaseResult &which, MethodName::Kind kind, std::optional<double> tolerance)
{
    const auto row = std::ranges::find_if(which.methods, [&](const MethodResult &method) {
        return method.method.kind == kind && method.tolerance == tolerance;
    });
    return row == which.methods.end() ? nullptr : &*row;
}

/// "65 (60 to 70)": the ratio of two times, with the range that their spreads leave.
QString timeRatioText(const MethodResult &slower, const MethodResult &faster)
{
    const auto edge = [](const MethodResult &row, double side) { return row.nsPerState + side * 0.5 * row.spread; };
    const double least = edge(slower, -1.0) / edge(faster, 1.0);
    const double most = edge(slower, 1.0) / std::max(edge(faster, -1.0), 0.5 * faster.nsPerState);
    const QString ratio = ratioText(slower.nsPerState / faster.nsPerState);
    const QString from = ratioText(std::max(least, 1.0));
    const QString to = ratioText(most);
    return from == to ? ratio : StudyText::tr("%1 (%2 to %3)").arg(ratio, from, to);
}

QString speedText(const MethodResult &closedForm, const MethodResult &report)
{
    if (report.nsPerState >= kAlike * closedForm.nsPerState) {
        return StudyText::tr("%1 times as fast as the report's way").arg(timeRatioText(report, closedForm));
    }
    return closedForm.nsPerState < kAlike * report.nsPerState
               ? StudyText::tr("as fast as the report's way")
               : StudyText::tr("takes %1 times as long as the report's way").arg(timeRatioText(closedForm, report));
}

/// Errors below `rounding`, which the rounded data cause by themselves, are not distinguished.
QString accuracyText(std::optional<double> closedForm, std::optional<double> report, double rounding)
{
    if (!closedForm) {
        return StudyText::tr(", but it solves no instant here");
    }
    if (!report) {
        return StudyText::tr(", which solves no instant here");
    }
    const double own = std::max(*closedForm, rounding);
    const double other = std::max(*report, rounding);
    constexpr double kAtLimit = 2.0; // the error of Newton-Raphson iterated to the end is at most so many κ u
    if (rounding > 0.0 && own <= kAtLimit * rounding && other <= kAtLimit * rounding) {
        return StudyText::tr("; both are as exact as the rounding of the data allows");
    }
    if (own == 0.0 || other == 0.0) {
        return own == other ? StudyText::tr(" and as exact here")
               : own == 0.0 ? StudyText::tr(" and right to the last digit here")
                            : StudyText::tr(", which is right to the last digit here");
    }
    if (other >= kAlike * own) {
        return StudyText::tr(" and %1 times as exact here").arg(ratioText(other / own));
    }
    return own <= kAlike * other
               ? StudyText::tr(" and as exact here")
               : StudyText::tr(", but its error is %1 times as large here").arg(ratioText(own / other));
}

struct Field {
    QString key;
    QJsonValue value;
};

QJsonValue numberValue(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QJsonValue(*value) : QJsonValue();
}

QString nameText(const MethodName &method)
{
    return QString::fromStdString(nameOf(method));
}

QString statusKey(std::size_t status)
{
    return QString::fromUtf8(wordOf(static_cast<Status>(status)));
}

QJsonObject objectOf(const std::vector<Field> &fields)
{
    QJsonObject object;
    for (const auto &[key, value] : fields) {
        object[key] = value;
    }
    return object;
}

/// Up to the status; behind it JSON has an object of counts, CSV a column for each.
std::vector<Field> fieldsBeforeCounts(const MethodResult &row)
{
    return {{QStringLiteral("method"), nameText(row.method)},
            {QStringLiteral("tolerance"), numberValue(row.tolerance)},
            {QStringLiteral("channels"), row.channels},
            {QStringLiteral("nsPerState"), numberValue(row.nsPerState)},
            {QStringLiteral("spread"), numberValue(row.spread)},
            {QStringLiteral("iterationsPerState"), numberValue(row.iterationsPerState)},
            {QStringLiteral("maxError"), numberValue(row.maxError)},
            {QStringLiteral("errorBound"), numberValue(row.errorBound)},
            {QStringLiteral("status"), statusKey(static_cast<std::size_t>(row.status))}};
}

std::vector<Field> fieldsBehindCounts(const MethodResult &row)
{
    const auto silent = row.silentFailures ? QJsonValue(static_cast<qint64>(*row.silentFailures)) : QJsonValue();
    return {{QStringLiteral("silentFailures"), silent},
            {QStringLiteral("linearSolvesPerState"), numberValue(row.linearSolvesPerState)}};
}

QJsonObject objectOf(const MethodResult &row)
{
    QJsonObject object = objectOf(fieldsBeforeCounts(row));
    QJsonObject counts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        counts[statusKey(i)] = static_cast<qint64>(row.counts[i]);
    }
    object[QStringLiteral("counts")] = counts;
    for (const auto &[key, value] : fieldsBehindCounts(row)) {
        object[key] = value;
    }
    return object;
}

QJsonObject objectOf(const WorkPrecision &row)
{
    return objectOf({{QStringLiteral("method"), nameText(row.method)},
                     {QStringLiteral("tolerance"), numberValue(row.tolerance)},
                     {QStringLiteral("steps"), row.steps},
                     {QStringLiteral("microseconds"), numberValue(row.microseconds)},
                     {QStringLiteral("spread"), numberValue(row.spread)},
                     {QStringLiteral("linearSolves"), numberValue(row.linearSolves)},
                     {QStringLiteral("maxError"), numberValue(row.maxError)}});
}

template <class Rows>
QJsonArray arrayOf(const Rows &rows)
{
    QJsonArray array;
    for (const auto &row : rows) {
        array += objectOf(row);
    }
    return array;
}

/// In English, for files.
QString machineName(const Machine &machine)
{
    return QString::fromStdString(machine.processor.empty() ? "other" : machine.processor) + QStringLiteral(", ") +
           QString::number(machine.threads) + QStringLiteral(" threads") +
           (machine.compiler.empty() ? QString() : QStringLiteral(", ") + QString::fromStdString(machine.compiler)) +
           (machine.isOptimized ? QString() : QStringLiteral(", not optimized"));
}

} // namespace

QString closedFormSentence(const CaseResult &which)
{
    const MethodResult *closedForm = rowOf(which, MethodName::Kind::ClosedForm, std::nullopt);
    const MethodResult *report = rowOf(which, MethodName::Kind::NewtonDense, kReportsTolerance);
    if (!closedForm || !report || closedForm->nsPerState <= 0.0 || report->nsPerState <= 0.0) {
        return {};
    }
    if (!closedForm->maxError && !report->maxError) {
        return StudyText::tr("Neither the closed form nor the report's way solves an instant here.");
    }
    QString text = StudyText::tr("Closed form: %1%2.")
                       .arg(speedText(*closedForm, *report),
                            accuracyText(closedForm->maxError, report->maxError, report->errorBound.value_or(0.0)));
    const auto solved = [](const MethodResult &row) { return row.counts[static_cast<std::size_t>(Status::Solved)]; };
    if (closedForm->maxError && report->maxError && solved(*closedForm) != solved(*report)) {
        text += u' ' + StudyText::tr("It solves %1 of %2 instants, the report's way %3.")
                           .arg(solved(*closedForm))
                           .arg(std::accumulate(closedForm->counts.begin(), closedForm->counts.end(), std::size_t{0}))
                           .arg(solved(*report));
    }
    if (report->silentFailures.value_or(0) > 0) {
        text +=
            u' ' +
            StudyText::tr("At %1 instants the report's way is wrong without saying so.").arg(*report->silentFailures);
    }
    return text;
}

QString caseText(const std::string &name)
{
    QStringList texts;
    for (const QString &property : QString::fromStdString(name).split(QStringLiteral(", "))) {
        texts += propertyText(property);
    }
    return texts.join(QStringLiteral(", "));
}

std::string studyJson(const StudyResult &result)
{
    QJsonArray cases;
    for (const CaseResult &which : result.cases) {
        QJsonObject object{{QStringLiteral("name"), QString::fromStdString(which.name)},
                           {QStringLiteral("methods"), arrayOf(which.methods)}};
        if (!which.workPrecision.empty()) {
            object[QStringLiteral("workPrecision")] = arrayOf(which.workPrecision);
        }
        cases += object;
    }
    const QJsonObject whole{{QStringLiteral("machine"), machineName(result.machine)}, {QStringLiteral("cases"), cases}};
    return QJsonDocument(whole).toJson().toStdString();
}

std::string studyCsv(const StudyResult &result)
{
    const auto line = [](const MethodResult &row, const auto &text) {
        QStringList cells;
        for (const Field &field : fieldsBeforeCounts(row)) {
            cells += text(field);
        }
        for (std::size_t i = 0; i < kStatusCount; ++i) {
            cells += text(Field{statusKey(i), static_cast<qint64>(row.counts[i])});
        }
        for (const Field &field : fieldsBehindCounts(row)) {
            cells += text(field);
        }
        return cells.join(u',') + u'\n';
    };
    QString text = QStringLiteral("case,") + line({}, [](const Field &field) { return field.key; });
    for (const CaseResult &which : result.cases) {
        for (const MethodResult &row : which.methods) {
            text += u'"' + QString::fromStdString(which.name) + QStringLiteral("\",") +
                    line(row, [](const Field &field) { return field.value.toVariant().toString(); });
        }
    }
    return text.toStdString();
}

QString machineText(const Machine &machine)
{
    QStringList parts{machine.processor.empty() ? StudyText::tr("other") : QString::fromUtf8(machine.processor),
                      StudyText::tr("%1 threads").arg(machine.threads)};
    if (!machine.compiler.empty()) {
        parts += QString::fromUtf8(machine.compiler);
    }
    if (!machine.isOptimized) {
        parts += StudyText::tr("not optimized");
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace slidercrank
