// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/parameter_text.h"

#include "ui/text/enum_table.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QStringList>

namespace slidercrank
{

namespace
{

struct ParameterText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ParameterText)

public:
    struct ParameterWords {
        Parameter key;
        const char *name;   ///< untranslated
        const char *symbol; ///< in equations
        const char *option; ///< on the command line and in JSON
    };
    static constexpr ParameterWords kParameters[] = {
        {Parameter::A, QT_TR_NOOP("crank"), "a", "a"},
        {Parameter::B, QT_TR_NOOP("coupler"), "b", "b"},
        {Parameter::C, QT_TR_NOOP("offset"), "c", "c"},
        {Parameter::Omega2, QT_TR_NOOP("crank speed"), "ω₂", "omega2"},
        {Parameter::Theta20, QT_TR_NOOP("initial angle"), "θ₂₀", "theta20"}};
    static_assert(isCompleteTable(kParameters, Parameter::Theta20));
};

} // namespace

QString parameterName(Parameter parameter)
{
    return ParameterText::tr(rowOf(ParameterText::kParameters, parameter).name);
}

QString symbolText(Parameter parameter)
{
    return rowOf(ParameterText::kParameters, parameter).symbol;
}

const char *optionName(Parameter parameter)
{
    return rowOf(ParameterText::kParameters, parameter).option;
}

QString assemblyText(Branch branch)
{
    return branch == Branch::Open ? ParameterText::tr("open") : ParameterText::tr("crossed");
}

QString assemblyPhrase(Branch branch)
{
    return ParameterText::tr("%1 assembly").arg(assemblyText(branch));
}

double shownFactor(Parameter parameter, const Notation &shown)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return shownValue(Measure::Length, 1.0, shown.units);
    case Parameter::Omega2: return crankSpeedFactor(shown.crankSpeed);
    case Parameter::Theta20: break;
    }
    return shownValue(Measure::Angle, 1.0, shown.units);
}

QString unitSuffix(Parameter parameter, const Notation &shown)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return u' ' + unitText(Measure::Length, shown.units);
    case Parameter::Omega2: return u' ' + crankSpeedUnitText(shown.crankSpeed);
    case Parameter::Theta20: break;
    }
    const QString unit = unitText(Measure::Angle, shown.units);
    return unit == u"°" ? unit : u' ' + unit;
}

QString parameterText(Parameter parameter, double value, int digits, const Notation &shown)
{
    return numberText(shownFactor(parameter, shown) * value, digits) + unitSuffix(parameter, shown);
}

QString equationText(Parameter parameter, double value, int digits, const Notation &shown)
{
    return QStringLiteral("%1 = %2").arg(symbolText(parameter), parameterText(parameter, value, digits, shown));
}

QStringList equationTexts(const Parameters &parameters, int digits)
{
    QStringList equations;
    for (const Parameter parameter : kAllParameters) {
        equations << equationText(parameter, valueOf(parameters, parameter), digits);
    }
    return equations << assemblyPhrase(parameters.branch);
}

QString mechanismText(const Mechanism &mechanism, int digits)
{
    return equationTexts(mechanism.parameters(), digits).join(", ");
}

QString pinnedText(const Parameters &pinned, const Parameters &current)
{
    QStringList parts = equationTexts(pinned);
    for (const QString &part : equationTexts(current)) {
        parts.removeOne(part);
    }
    return parts.isEmpty() ? ParameterText::tr("pinned") : parts.join(", ");
}

} // namespace slidercrank
