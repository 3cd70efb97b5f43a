// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/study_text.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StudyText)

public:
    /// Patterns of the properties of a case. Formulas are not translated.
    static constexpr const char *kPatterns[] = {QT_TR_NOOP("Table 1 of the reference report"),
                                                QT_TR_NOOP("this mechanism"),
                                                QT_TR_NOOP("the reference report's file"),
                                                QT_TR_NOOP("crossed"),
                                                QT_TR_NOOP("toggle gap %1"),
                                                QT_TR_NOOP("exact toggle"),
                                                QT_TR_NOOP("change point"),
                                                QT_TR_NOOP("a = b and c = 0"),
                                                QT_TR_NOOP("rocker"),
                                                QT_TR_NOOP("one arc"),
                                                QT_TR_NOOP("two arcs"),
                                                QT_TR_NOOP("barely a rocker"),
                                                QT_TR_NOOP("gap %1"),
                                                QT_TR_NOOP("locked"),
                                                QT_TR_NOOP("never assemblable"),
                                                QT_TR_NOOP("lengths x %1"),
                                                QT_TR_NOOP("t near %1"),
                                                QT_TR_NOOP("%1 steps a turn")};
};

/// Translates a property such as "toggle gap 1e-4" with the pattern "toggle gap %1".
QString propertyText(const QString &property)
{
    for (const char *pattern : StudyText::kPatterns) {
        const QStringList around = QString::fromUtf8(pattern).split(QStringLiteral("%1"));
        if (property == around.first() && around.size() == 1) {
            return StudyText::tr(pattern);
        }
        if (around.size() == 2 && property.startsWith(around[0]) && property.endsWith(around[1])) {
            return StudyText::tr(pattern).arg(property.sliced(around[0].size()).chopped(around[1].size()));
        }
    }
    return property;
}

const MethodResult *findRow(const CaseResult &result, MethodName::Kind kind, std::optional<double> tolerance)
{
    const auto row = std::ranges::find_if(result.methods, [&](const MethodResult &method) {
        return method.method.kind == kind && method.tolerance == tolerance;
    });
    return row == result.methods.end() ? nullptr : &*row;
}

/// Returns a ratio with two significant digits: "4", "4.6", "130".
QString ratioText(double ratio)
{
    const double step = std::pow(10.0, std::floor(std::log10(ratio)) - 1.0);
    return numberText(step * std::round(ratio / step));
}

/// Returns the ratio of two times with the range that follows from their spreads: "65 (60 to 70)".
QString timeRatioText(const MethodResult &slower, const MethodResult &faster)
{
    const auto edge = [](const MethodResult &row, double side) {
        return std::max(row.nsPerState + side * 0.5 * row.spread, 0.5 * row.nsPerState);
    };
    const QString ratio = ratioText(slower.nsPerState / faster.nsPerState);
    const QString from = ratioText(std::max(edge(slower, -1.0) / edge(faster, 1.0), 1.0));
    const QString to = ratioText(edge(slower, 1.0) / edge(faster, -1.0));
    return from == to ? ratio : StudyText::tr("%1 (%2 to %3)").arg(ratio, from, to);
}

struct Field {
    QString key;
    QJsonValue value;
};

const QString kCounts = QStringLiteral("counts"); // an object in JSON, one column per status in CSV

QJsonValue toJson(std::optional<double> value)
{
    return value && std::isfinite(*value) ? QJsonValue(*value) : QJsonValue();
}

QString statusName(std::size_t status)
{
    return QString::fromUtf8(wordOf(static_cast<Status>(status)));
}

std::vector<Field> fieldsOf(const MethodResult &row)
{
    QJsonObject counts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        counts[statusName(i)] = static_cast<qint64>(row.counts[i]);
    }
    return {{QStringLiteral("method"), QString::fromStdString(nameOf(row.method))},
            {QStringLiteral("tolerance"), toJson(row.tolerance)},
            {QStringLiteral("channels"), row.channels},
            {QStringLiteral("nsPerState"), toJson(row.nsPerState)},
            {QStringLiteral("spread"), toJson(row.spread)},
            {QStringLiteral("iterationsPerState"), toJson(row.iterationsPerState)},
            {QStringLiteral("maxError"), toJson(row.maxError)},
            {QStringLiteral("errorBound"), toJson(row.errorBound)},
            {QStringLiteral("status"), statusName(static_cast<std::size_t>(row.status))},
            {kCounts, counts},
            {QStringLiteral("silentFailures"),
             row.silentFailures ? QJsonValue(static_cast<qint64>(*row.silentFailures)) : QJsonValue()},
            {QStringLiteral("linearSolvesPerState"), toJson(row.linearSolvesPerState)}};
}

std::vector<Field> fieldsOf(const WorkPrecision &row)
{
    return {{QStringLiteral("method"), QString::fromStdString(nameOf(row.method))},
            {QStringLiteral("tolerance"), toJson(row.tolerance)},
            {QStringLiteral("steps"), row.steps},
            {QStringLiteral("microseconds"), toJson(row.microseconds)},
            {QStringLiteral("spread"), toJson(row.spread)},
            {QStringLiteral("linearSolves"), toJson(row.linearSolves)},
            {QStringLiteral("maxError"), toJson(row.maxError)}};
}

template <class Row>
QJsonArray toArray(const std::vector<Row> &rows)
{
    QJsonArray array;
    for (const Row &row : rows) {
        QJsonObject object;
        for (const auto &[key, value] : fieldsOf(row)) {
            object[key] = value;
        }
        array += object;
    }
    return array;
}

/// Returns a line of CSV with the values of the row, or the header line with their keys.
QString csvLine(const MethodResult &row, bool isHeader)
{
    QStringList cells;
    for (const auto &[key, value] : fieldsOf(row)) {
        for (std::size_t i = 0; key == kCounts && i < kStatusCount; ++i) {
            cells += isHeader ? statusName(i) : QString::number(row.counts[i]);
        }
        if (key != kCounts) {
            cells += isHeader ? key : value.toVariant().toString();
        }
    }
    return cells.join(u',') + u'\n';
}

QString describeMachine(const Machine &machine, const QString &other, const QString &threads,
                        const QString &notOptimized)
{
    QStringList parts{machine.processor.empty() ? other : QString::fromStdString(machine.processor),
                      threads.arg(machine.threads), QString::fromStdString(machine.compiler),
                      machine.isOptimized ? QString() : notOptimized};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(", "));
}

} // namespace

QString closedFormSentence(const CaseResult &result)
{
    const MethodResult *closedForm = findRow(result, MethodName::Kind::ClosedForm, std::nullopt);
    const MethodResult *newton = findRow(result, MethodName::Kind::NewtonDense, kReportsTolerance);
    if (!closedForm || !newton || closedForm->nsPerState <= 0.0 || newton->nsPerState <= 0.0) {
        return {};
    }
    if (!closedForm->maxError && !newton->maxError) {
        return StudyText::tr("Neither the closed form nor dense Newton-Raphson solves a time step here.");
    }
    constexpr double kFaster = 1.05; // smaller ratios are within the measurement error
    const QString speed = newton->nsPerState >= kFaster * closedForm->nsPerState
                              ? StudyText::tr("Closed form: %1 times faster than dense Newton-Raphson")
                                    .arg(timeRatioText(*newton, *closedForm))
                              : StudyText::tr("Closed form: not faster than dense Newton-Raphson");
    const auto errorOf = [](const MethodResult &row) { return row.maxError ? errorText(*row.maxError) : dash(); };
    const auto solvedBy = [](const MethodResult &row) {
        return QString::number(row.counts[static_cast<std::size_t>(Status::Solved)]);
    };
    QString text = StudyText::tr("%1; largest error %2 of the peak instead of %3.")
                       .arg(speed, errorOf(*closedForm), errorOf(*newton));
    if (solvedBy(*closedForm) != solvedBy(*newton)) {
        text += u' ' + StudyText::tr("Time steps that are solved: %1 instead of %2.")
                           .arg(solvedBy(*closedForm), solvedBy(*newton));
    }
    if (newton->silentFailures.value_or(0) > 0) {
        text += u' ' + StudyText::tr("Undetected failures of dense Newton-Raphson: %1.").arg(*newton->silentFailures);
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
    for (const CaseResult &each : result.cases) {
        QJsonObject object{{QStringLiteral("name"), QString::fromStdString(each.name)},
                           {QStringLiteral("methods"), toArray(each.methods)}};
        if (!each.workPrecision.empty()) {
            object[QStringLiteral("workPrecision")] = toArray(each.workPrecision);
        }
        cases += object;
    }
    const QString machine = describeMachine(result.machine, QStringLiteral("other"), QStringLiteral("%1 threads"),
                                            QStringLiteral("not optimized"));
    return QJsonDocument(QJsonObject{{QStringLiteral("machine"), machine}, {QStringLiteral("cases"), cases}})
        .toJson()
        .toStdString();
}

std::string studyCsv(const StudyResult &result)
{
    QString text = QStringLiteral("case,") + csvLine({}, true);
    for (const CaseResult &each : result.cases) {
        for (const MethodResult &row : each.methods) {
            text += u'"' + QString::fromStdString(each.name) + QStringLiteral("\",") + csvLine(row, false);
        }
    }
    return text.toStdString();
}

QString machineText(const Machine &machine)
{
    return describeMachine(machine, StudyText::tr("other"), StudyText::tr("%1 threads"),
                           StudyText::tr("not optimized"));
}

} // namespace slidercrank
