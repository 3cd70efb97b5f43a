// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/study_text.h"

#include "ui/words/column_text.h"

#include <QCoreApplication>
#include <QStringList>

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

} // namespace

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
