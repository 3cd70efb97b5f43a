// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/study_text.h"

#include "ui/text/axis_scale.h"
#include "ui/text/column_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
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

QString traitText(const CaseTrait &trait)
{
    const QString value = QString::fromUtf8(trait.value);
    switch (trait.kind) {
    case CaseTrait::Kind::Formula: return value;
    case CaseTrait::Kind::ReportTable: return StudyText::tr("Table 1 of the report");
    case CaseTrait::Kind::ThisMechanism: return StudyText::tr("this mechanism");
    case CaseTrait::Kind::AuthorsFile: return StudyText::tr("the author's file");
    case CaseTrait::Kind::Crossed: return StudyText::tr("crossed");
    case CaseTrait::Kind::ToggleGap: return StudyText::tr("toggle gap %1").arg(value);
    case CaseTrait::Kind::ExactToggle: return StudyText::tr("exact toggle");
    case CaseTrait::Kind::ChangePoint: return StudyText::tr("change point");
    case CaseTrait::Kind::EqualAndInLine: return StudyText::tr("a = b and c = 0");
    case CaseTrait::Kind::Rocker: return StudyText::tr("rocker");
    case CaseTrait::Kind::OneArc: return StudyText::tr("one arc");
    case CaseTrait::Kind::TwoArcs: return StudyText::tr("two arcs");
    case CaseTrait::Kind::RockerByAHair: return StudyText::tr("rocker by a hair");
    case CaseTrait::Kind::Gap: return StudyText::tr("gap %1").arg(value);
    case CaseTrait::Kind::Locked: return StudyText::tr("locked");
    case CaseTrait::Kind::NeverAssemblable: return StudyText::tr("never assemblable");
    case CaseTrait::Kind::LengthsTimes: return StudyText::tr("lengths x %1").arg(value);
    case CaseTrait::Kind::TimeNear: return StudyText::tr("t near %1").arg(value);
    case CaseTrait::Kind::StepsATurn: return StudyText::tr("%1 steps a turn").arg(value);
    }
    return {};
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

QString speedText(double closedForm, double report)
{
    if (report >= kAlike * closedForm) {
        return StudyText::tr("%1 times as fast as the report's way").arg(ratioText(report / closedForm));
    }
    return closedForm < kAlike * report
               ? StudyText::tr("as fast as the report's way")
               : StudyText::tr("takes %1 times as long as the report's way").arg(ratioText(closedForm / report));
}

QString exactnessText(std::optional<double> closedForm, std::optional<double> report)
{
    if (!closedForm) {
        return StudyText::tr(", but it solves no instant here");
    }
    if (!report) {
        return StudyText::tr(", which solves no instant here");
    }
    if (*report >= kAlike * *closedForm && *report > 0.0) {
        return *closedForm > 0.0 ? StudyText::tr(" and %1 times as exact here").arg(ratioText(*report / *closedForm))
                                 : StudyText::tr(" and right to the last digit here");
    }
    return *closedForm <= kAlike * *report ? StudyText::tr(" and as exact here")
           : *report > 0.0
               ? StudyText::tr(", but its error is %1 times as large here").arg(ratioText(*closedForm / *report))
               : StudyText::tr(", which is right to the last digit here");
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
                       .arg(speedText(closedForm->nsPerState, report->nsPerState),
                            exactnessText(closedForm->maxError, report->maxError));
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

QString caseText(const std::vector<CaseTrait> &traits)
{
    QStringList texts;
    for (const CaseTrait &trait : traits) {
        texts += traitText(trait);
    }
    return texts.join(QStringLiteral(", "));
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
