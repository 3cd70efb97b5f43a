// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/study_text.h"

#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QStringList>
#include <QSysInfo>
#include <QThread>

#include <boost/config.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::StudyText)

public:
    /// The properties of the cases in core/study/cases.cpp, with %1 instead of a number. Formulas are not among them.
    static constexpr const char *kProperties[] = {QT_TR_NOOP("initial mechanism"),
                                                  QT_TR_NOOP("this mechanism"),
                                                  QT_TR_NOOP("sample file"),
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

/// Translates a property such as "toggle gap 1e-4". Formulas are not translated.
QString propertyText(const QString &property)
{
    for (const char *pattern : StudyText::kProperties) {
        const QStringList fixedParts = QString(pattern).split("%1");
        if (fixedParts.size() == 1 && property == fixedParts.front()) {
            return StudyText::tr(pattern);
        }
        const QString before = fixedParts.front();
        const QString after = fixedParts.back();
        if (fixedParts.size() == 2 && property.startsWith(before) && property.endsWith(after)) {
            const QString number = property.sliced(before.size()).chopped(after.size());
            return StudyText::tr(pattern).arg(number);
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

QJsonValue jsonCount(std::size_t count)
{
    return static_cast<qint64>(count);
}

QString statusName(Status status)
{
    return QString::fromUtf8(nameOf(status));
}

/// Returns the number of time stamps with each status.
Record countsOf(const MethodResult &row)
{
    Record counts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        counts.emplace_back(statusName(static_cast<Status>(i)), jsonCount(row.counts[i]));
    }
    return counts;
}

/// Returns the results of a method. `counts`: countsOf(row) as columns of CSV, or as a single object of JSON.
Record recordOf(const MethodResult &row, const Record &counts)
{
    Record record{{"method", QString::fromStdString(nameOf(row.method))},
                  {"tolerance", jsonNumber(row.tolerance)},
                  {"channels", row.channels},
                  {"nsPerState", jsonNumber(row.nanosecondsPerState)},
                  {"spread", jsonNumber(row.spread)},
                  {"iterationsPerState", jsonNumber(row.iterationsPerState)},
                  {"maxError", jsonNumber(row.maxError)},
                  {"errorBound", jsonNumber(row.errorBound)},
                  {"status", statusName(row.status)}};
    record.insert(record.end(), counts.begin(), counts.end());
    record.emplace_back("silentFailures", row.silentFailures ? jsonCount(*row.silentFailures) : QJsonValue());
    record.emplace_back("linearSolvesPerState", jsonNumber(row.linearSolvesPerState));
    return record;
}

/// Returns a row of CaseResult::workPrecision. Times are those of all states, in µs.
QJsonObject jsonWorkPrecisionRow(const MethodResult &row)
{
    assert(row.stateCount > 0);
    const auto states = static_cast<double>(row.stateCount);
    return {{"method", QString::fromStdString(nameOf(row.method))},
            {"tolerance", jsonNumber(row.tolerance)},
            {"steps", jsonCount(row.stateCount - 1)},
            {"microseconds", jsonNumber(1e-3 * states * row.nanosecondsPerState)},
            {"spread", jsonNumber(1e-3 * states * row.spread)},
            {"linearSolves", jsonNumber(states * row.linearSolvesPerState.value_or(kNone))},
            {"maxError", jsonNumber(row.maxError)}};
}

} // namespace

QString closedFormSentence(const CaseResult &result)
{
    const MethodResult *closedForm = findRow(result, MethodName::Kind::ClosedForm, std::nullopt);
    const MethodResult *newton = findRow(result, MethodName::Kind::NewtonDense, kReferenceReportTolerance);
    if (!closedForm || !newton) {
        return {};
    }
    constexpr int kDigits = 2;
    const double spread =
        newton->spread / newton->nanosecondsPerState + closedForm->spread / closedForm->nanosecondsPerState;
    const double percent = std::ceil(100.0 * 0.5 * spread); // ± half the distance between the quartiles
    return StudyText::tr(
               "The closed form is %1 times as fast as dense Newton-Raphson with its default tolerance (± %2 %).")
        .arg(shortNumber(newton->nanosecondsPerState / closedForm->nanosecondsPerState, kDigits), numberText(percent));
}

QString caseText(const std::string &name)
{
    QStringList texts;
    for (const QString &property : QString::fromStdString(name).split(", ")) {
        texts += propertyText(property);
    }
    return texts.join(", ");
}

QJsonObject studyJson(const StudyResult &result)
{
    const auto jsonMethod = [](const MethodResult &row) {
        return jsonObject(recordOf(row, {{"counts", jsonObject(countsOf(row))}}));
    };
    const auto jsonCase = [&jsonMethod](const CaseResult &each) {
        QJsonObject object{{"name", QString::fromStdString(each.name)},
                           {"methods", jsonList(each.methods, jsonMethod)}};
        if (!each.workPrecision.empty()) {
            object.insert("workPrecision", jsonList(each.workPrecision, jsonWorkPrecisionRow));
        }
        return object;
    };
    return {{"machine", machineText()}, {"cases", jsonList(result.cases, jsonCase)}};
}

std::vector<Record> studyRecords(const StudyResult &result)
{
    std::vector<Record> records;
    for (const CaseResult &each : result.cases) {
        for (const MethodResult &row : each.methods) {
            records.push_back(recordOf(row, countsOf(row)));
            records.back().insert(records.back().begin(), {"case", QString::fromStdString(each.name)});
        }
    }
    return records;
}

QString machineText()
{
    QStringList parts{QSysInfo::buildCpuArchitecture()};
    if (const int threads = QThread::idealThreadCount(); threads > 1) {
        parts += StudyText::tr("%1 threads").arg(threads);
    }
    parts += QString(BOOST_COMPILER).remove(" version"); // the word would have to be translated
#ifndef NDEBUG
    parts += StudyText::tr("not optimized");
#endif
    return parts.join(", ");
}

} // namespace slidercrank
