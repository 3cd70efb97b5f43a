// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_reader.h"

#include "core/import/quantity.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

/// Returns the Levenshtein distance of two words, ignoring case.
qsizetype editDistance(const QString &from, const QString &to)
{
    std::vector<qsizetype> row(static_cast<std::size_t>(to.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < from.size(); ++i) {
        qsizetype diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 1; j < row.size(); ++j) {
            const bool same = from[i].toLower() == to[static_cast<qsizetype>(j) - 1].toLower();
            const qsizetype replaced = diagonal + (same ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
        }
    }
    return row.back();
}

} // namespace

QString joinedByOr(const QStringList &names)
{
    return names.size() < 2 ? names.join("")
                            : CommandLine::tr("%1 or %2").arg(names.first(names.size() - 1).join(", "), names.last());
}

void throwUnknownName(const QString &message, const QString &name, const QStringList &names)
{
    const auto distance = [&name](const QString &each) {
        return each.startsWith(name, Qt::CaseInsensitive) ? 1 : editDistance(name, each);
    };
    const QString nearest = *std::ranges::min_element(names, {}, distance);
    const bool isSimilar = 3 * distance(nearest) <= name.size() + 1;
    throw UsageError{isSimilar ? CommandLine::tr("%1: did you mean %2?").arg(message, nearest)
                               : CommandLine::tr("%1: choose one of %2.").arg(message, names.join(", "))};
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
    if (!has("help")) {
        checkSyntax();
    }
    m_scene.solver.newton.elimination = Elimination::Structured; // the same iterates as Dense, ten times faster
}

void OptionReader::checkSyntax() const
{
    if (const QStringList unknown = m_parser.unknownOptionNames(); !unknown.isEmpty()) {
        QStringList names;
        for (const OptionDescription &option : m_options) {
            names += QString("--") + option.name;
        }
        const QString name = "--" + unknown.first();
        throwUnknownName(CommandLine::tr("There is no option %1 here").arg(name), name, names);
    }
    if (const QString error = m_parser.errorText(); !error.isEmpty()) {
        throw UsageError{error};
    }
    for (const OptionDescription &option : m_options) {
        if (texts(option.name).size() > 1 && !option.mayRepeat) {
            throw UsageError{CommandLine::tr("--%1 is given more than once: keep one of them.").arg(option.name)};
        }
    }
    if ((files() + texts("scene") + texts("reference")).count("-") > 1) {
        throw UsageError{CommandLine::tr("Standard input can be read only once: give one \"-\".")};
    }
    for (const char *name : {"scene", "reference", "output"}) {
        if (texts(name).contains("")) {
            throw UsageError{CommandLine::tr("--%1 needs the name of a file.").arg(name)};
        }
    }
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

void OptionReader::refuseFiles() const
{
    if (!files().isEmpty()) {
        throw UsageError{CommandLine::tr("\"slidercrank %1\" takes options only: remove \"%2\".")
                             .arg(m_command.name, files().first())};
    }
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

qsizetype OptionReader::indexAmong(const QStringList &words, const char *name) const
{
    const qsizetype index = words.indexOf(text(name));
    if (index < 0) {
        throw UsageError{CommandLine::tr("--%1 must be %2, not \"%3\".").arg(name, joinedByOr(words), text(name))};
    }
    return index;
}

double OptionReader::number(const char *name, double defaultValue, const std::optional<Unit> &unit, double smallest,
                            double largest) const
{
    if (!has(name)) {
        return defaultValue;
    }
    const auto &[value, fault] = readQuantity(text(name), unit, QLocale::c());
    if (!fault && value >= smallest && value <= largest) {
        return value;
    }
    if (!fault || fault == QuantityFault::TooLarge) {
        throw UsageError{CommandLine::tr("--%1 must be from %2 to %3, not \"%4\".")
                             .arg(name, typedNumberText(smallest), typedNumberText(largest), text(name))};
    }
    if (unit && (fault == QuantityFault::UnknownUnit || fault == QuantityFault::WrongUnit)) {
        throw UsageError{CommandLine::tr("--%1 must be a number, alone or followed by %2, not \"%3\".")
                             .arg(name, joinedByOr(unitsFor(*unit)), text(name))};
    }
    throw UsageError{CommandLine::tr("--%1 must be a number with a decimal point, such as 60 or -0.5, not \"%2\".")
                         .arg(name, text(name))};
}

int OptionReader::integer(const char *name, int defaultValue, int smallest, int largest) const
{
    const double value = number(name, defaultValue, {}, smallest, largest);
    if (value != std::round(value)) {
        throw UsageError{CommandLine::tr("--%1 must be a whole number, not \"%2\".").arg(name, text(name))};
    }
    return static_cast<int>(value);
}

void OptionReader::refuse(const std::vector<const char *> &names, const QString &message) const
{
    for (const char *name : names) {
        if (has(name)) {
            throw UsageError{message.arg(QString("--") + name)};
        }
    }
}

} // namespace slidercrank
