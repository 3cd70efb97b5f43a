// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/limits_page.h"

#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>

namespace slidercrank
{

namespace
{

struct LimitsPage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::LimitsPage)
};

/// Returns the name of a limit in files, as the command line writes it in every language.
QString csvName(const MotionFact &fact)
{
    const std::string_view key = describe(fact.kind).key;
    QString name = key.empty() ? "crank-limit" : QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
    const bool isCouplerAngle =
        fact.kind == LimitKind::MinimumCouplerAngle || fact.kind == LimitKind::MaximumCouplerAngle;
    if (isCouplerAngle && notation().symbols == Symbols::Textbook) {
        name += " at B";
    }
    return nameWithAsciiUnit(name, describe(fact.kind).measure, notation().units);
}

std::vector<TableRow> rowsOf(const std::vector<MotionFact> &facts)
{
    std::vector<TableRow> rows;
    for (const MotionFact &fact : facts) {
        QString explanation = fact.explanation;
        TableCell angle{.text = fact.remark};
        if (fact.theta2) {
            explanation += u'\n' + (fact.time ? LimitsPage::tr("Click or press Enter to go there")
                                              : LimitsPage::tr("Outside the simulated time range"));
            angle = {.text = crankAngleText(*fact.theta2), .number = shownCrankAngle(*fact.theta2)};
        }
        rows.push_back({{{.text = fact.name, .csv = csvName(fact)},
                         {.text = valueText(fact, kReadoutDigits), .number = fact.number},
                         angle,
                         {.text = fact.theta2 ? numberText(fact.time, kReadoutDigits) : QString(),
                          .number = fact.time,
                          .tone = fact.time ? Tone::Link : Tone::Normal}},
                        fact.time,
                        MechanismPart::None,
                        explanation});
    }
    return rows;
}

} // namespace

Page limitsPage(const Result &result)
{
    const Mechanism &mechanism = result.mechanism;
    const QString angleUnit = shownUnit(Measure::Angle);
    Page page;
    page.sentence = mobilitySentence(mechanism, result.limits);
    page.tables = {
        {.name = "limitTable",
         .title = LimitsPage::tr("Limits of the motion"),
         .columns =
             {{.title = LimitsPage::tr("limit"),
               .explanation = LimitsPage::tr(
                   "Where slider and crank reverse, the stroke times, and the largest velocities and accelerations "
                   "over a whole revolution of the crank, whatever part of it is simulated"),
               .csvName = "limit",
               .isNumber = false},
              {.title = LimitsPage::tr("value"),
               .explanation = LimitsPage::tr(
                   "Positions are those of the slider, measured from O₂; x points to the right, angles are "
                   "counter-clockwise"),
               .csvName = "value"},
              {.title = QStringLiteral("θ₂ [%1]").arg(angleUnit),
               .explanation = LimitsPage::tr("Crank angle, 0 to 360°"),
               .csvName = nameWithAsciiUnit("theta2", Measure::Angle, notation().units)},
              {.title = LimitsPage::tr("t [s]"),
               .explanation = LimitsPage::tr("First time at which the crank is there"),
               .csvName = "time [s]"}},
         .rows = rowsOf(motionFacts(mechanism, result.limits, result.sampling, notation()))}};
    return page;
}

} // namespace slidercrank
