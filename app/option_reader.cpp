// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_reader.h"

#include "app/similar_words.h"
#include "ui/document/result.h"
#include "ui/document/scene_link.h"
#include "ui/text/expression.h"
#include "ui/text/quantity_text.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

void requireOneOf(const QStringList &words, const QString &word, const char *option)
{
    if (!words.contains(word)) {
        throw UsageError{CommandLine::tr("--%1 must be %2, not \"%3\".").arg(option, anyOf(words), word) +
                         didYouMean(similarWords(word, words))};
    }
}

double parseNumber(const char *option, const QString &text, const std::optional<Unit> &unit, double smallest,
                   double largest)
{
    const auto &[value, fault] = readExpression(text, unit, QLocale::c());
    if (fault) {
        throw UsageError{QString("--%1: %2").arg(option, quantityFaultText(text, *fault, unit))};
    }
    if (value < smallest || value > largest) {
        throw UsageError{CommandLine::tr("--%1 must be between %2 and %3, not \"%4\".")
                             .arg(option, typedNumberText(smallest),
                                  typedNumberText(largest) + (unit ? unitAfterNumber(*unit) : QString()), text)};
    }
    return value;
}

/// Returns the options whose description contains the words, such as --branch for "assembly" and --omega2 for
/// "crank-speed". Returns none if the words are in the descriptions of more than kMaxOptions options: then they do not
/// tell which one was meant.
static QStringList optionsDescribedBy(const std::vector<OptionDescription> &options, const QString &words)
{
    constexpr qsizetype kMaxOptions = 3;
    const QString text = QString(words).replace('-', ' ');
    const QRegularExpression wholeWord("\\b" + QRegularExpression::escape(text) + "\\b",
                                       QRegularExpression::CaseInsensitiveOption |
                                           QRegularExpression::UseUnicodePropertiesOption);
    QStringList described;
    for (const OptionDescription &option : options) {
        if (QString(option.text).contains(wholeWord) || CommandLine::tr(option.text).contains(wholeWord)) {
            described += QStringLiteral("--") + option.name;
        }
    }
    return described.size() <= kMaxOptions ? described : QStringList();
}

/// Returns the options that an unknown one may stand for: those with a similar name, such as --at-angle for "angle" or
/// "at-angel", and those that take the name as a value, such as "--branch crossed" for "crossed". If there are none,
/// returns the options whose description contains it.
static QStringList similarOptions(const std::vector<OptionDescription> &options, const QString &name)
{
    constexpr qsizetype kMinLetters = 3; // of a name that is compared with parts: too many of them begin like "to"
    QStringList similar;
    QStringList names;
    for (const OptionDescription &option : options) {
        const QString known = option.name;
        names += known;
        const QStringList parts = known.split('-');
        const bool isLikePart =
            std::ranges::any_of(parts, [&name](const QString &part) { return sharesBeginning(name, part); });
        if (sharesBeginning(name, known) || (isLikePart && name.size() >= kMinLetters)) {
            similar += "--" + known;
        } else if (QString(option.value).split('|').contains(name)) {
            similar += QStringLiteral("--%1 %2").arg(known, name);
        }
    }
    if (similar.isEmpty()) {
        for (const QString &nearest : similarWords(name, names)) {
            similar += "--" + nearest;
        }
    }
    return similar.isEmpty() ? optionsDescribedBy(options, name) : similar;
}

OptionReader::OptionReader(const CommandDescription &command, const QStringList &arguments)
    : m_command(command)
    , m_options(optionsOf(command))
{
    m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    for (const OptionDescription &option : m_options) {
        QStringList names(option.name);
        if (option.shortName) {
            names += option.shortName;
        }
        m_parser.addOption(QCommandLineOption(names, {}, option.value));
    }
    m_parser.parse(QStringList("slidercrank") + arguments);
    if (!m_parser.errorText().isEmpty() && !has("help")) {
        const QStringList unknown = m_parser.unknownOptionNames();
        const QStringList similar = unknown.isEmpty() ? QStringList() : similarOptions(m_options, unknown.first());
        throw UsageError{m_parser.errorText() + didYouMean(similar) + ' ' +
                         CommandLine::tr("--help describes the options.")};
    }
    checkRepetitions();
    checkDetachedUnits(arguments);
    m_scene.solver = initialSolver();
}

void OptionReader::checkRepetitions() const
{
    const QStringList repeatable{"column", "reference"};
    for (const OptionDescription &option : m_options) {
        if (!option.value) { // a switch, which may be repeated
            continue;
        }
        const QStringList given = texts(option.name);
        if (given.size() > 1 && !repeatable.contains(option.name)) {
            throw UsageError{CommandLine::tr("--%1 is given more than once: keep one of them.").arg(option.name)};
        }
        if (option.value == QLatin1String("FILE") && given.contains("")) {
            throw UsageError{CommandLine::tr("--%1 needs the name of a file.").arg(option.name)};
        }
    }
    if (files().contains("")) {
        throw UsageError{CommandLine::tr("One of the arguments is empty: remove it, or name a file.")};
    }
    if (inputFiles().count("-") > 1) {
        throw UsageError{CommandLine::tr("Standard input can be read only once: give one \"-\".")};
    }
}

void OptionReader::checkDetachedUnits(const QStringList &arguments) const
{
    for (qsizetype i = 1; i < arguments.size(); ++i) {
        const QString &before = arguments[i - 1];
        const QString &unit = arguments[i];
        const bool isUnit = files().contains(unit) && parseUnit(unit.toStdString()) && !QFileInfo::exists(unit);
        const bool isBehindNumber = !readExpression(before.section('=', -1), {}, QLocale::c()).fault;
        if (isUnit && isBehindNumber) {
            const QString beforeNumber = i > 1 ? arguments[i - 2] : QString();
            const QString option = beforeNumber.startsWith("--") ? beforeNumber + ' ' : QString();
            throw UsageError{CommandLine::tr("%1%2 %3: write the number and its unit without a space, %2%3.")
                                 .arg(option, before, unit)};
        }
    }
}

void OptionReader::checkWord(const char *name) const
{
    requireOneOf(QString(find(name)->value).split('|'), text(name), name);
}

void OptionReader::readScene()
{
    if (!has("scene")) {
        return;
    }
    std::variant<Scene, QString> scene = slidercrank::readScene(text("scene"));
    if (const QString *message = std::get_if<QString>(&scene)) {
        throw UsageError{*message, ExitStatus::FileError};
    }
    m_scene = std::get<Scene>(std::move(scene));
}

QStringList OptionReader::inputFiles() const
{
    return files() + texts("reference") + texts("scene");
}

void OptionReader::refuseOptionWithoutDashes(const QString &argument) const
{
    const QString name = argument.section('=', 0, 0).trimmed();
    const OptionDescription *option = find(name.toUtf8());
    if (option && option->value) {
        const QString value = argument.contains('=') ? argument.section('=', 1).trimmed() : option->value;
        throw UsageError{CommandLine::tr("\"%1\" is not an option: write --%2 %3.").arg(argument, name, value)};
    }
}

void OptionReader::refuseFiles() const
{
    if (files().isEmpty()) {
        return;
    }
    const QString file = files().first();
    refuseOptionWithoutDashes(file);
    const bool isScene = file.endsWith(QLatin1String(".slidercrank")) || isSceneLink(file);
    const char *const option = isScene ? "scene" : "reference";
    if (find(option)) {
        throw UsageError{CommandLine::tr("\"slidercrank %1\" takes options only: write --%2 before \"%3\".")
                             .arg(m_command.name, QLatin1String(option), file)};
    }
    throw UsageError{
        CommandLine::tr("\"slidercrank %1\" takes options only: remove \"%2\".").arg(m_command.name, file)};
}

const OptionDescription *OptionReader::find(const char *name) const
{
    const auto found = std::ranges::find_if(m_options, [name](const OptionDescription &option) {
        return QLatin1String(option.name) == QLatin1String(name);
    });
    return found == m_options.end() ? nullptr : &*found;
}

bool OptionReader::has(const char *name) const
{
    return find(name) && m_parser.isSet(QLatin1String(name));
}

QStringList OptionReader::texts(const char *name) const
{
    return find(name) ? m_parser.values(QLatin1String(name)) : QStringList();
}

double OptionReader::number(const char *name, double defaultValue, const std::optional<Unit> &unit, double smallest,
                            double largest) const
{
    return has(name) ? parseNumber(name, text(name), unit, smallest, largest) : defaultValue;
}

int OptionReader::integer(const char *name, int defaultValue, int smallest, int largest) const
{
    const double value = number(name, defaultValue, {}, smallest, largest);
    if (value != std::round(value)) {
        throw UsageError{CommandLine::tr("--%1 must be a whole number, not \"%2\".").arg(name, text(name))};
    }
    return static_cast<int>(value);
}

void OptionReader::refuseIfGiven(const std::vector<const char *> &names, const QString &message) const
{
    for (const char *name : names) {
        if (has(name)) {
            throw UsageError{message.arg(QString("--") + name)};
        }
    }
}

} // namespace slidercrank
