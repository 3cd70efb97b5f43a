// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_reader.h"

#include "core/mechanism/mechanism.h"
#include "core/import/quantity.h"
#include "ui/text/quantity_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <variant>
#include <vector>

namespace slidercrank
{

namespace
{

/// How many letters must be inserted, removed or replaced to make one word the other (Levenshtein), whatever their
/// case.
qsizetype distance(const QString &from, const QString &to)
{
    std::vector<qsizetype> row(static_cast<std::size_t>(to.size()) + 1);
    for (std::size_t j = 0; j < row.size(); ++j) {
        row[j] = static_cast<qsizetype>(j);
    }
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

QStringList nearest(const QString &word, const QStringList &names)
{
    qsizetype least = (word.size() + 1) / 3;
    QStringList near;
    for (const QString &name : names) {
        const bool begun = word.size() > 1 && name.startsWith(word, Qt::CaseInsensitive);
        const qsizetype far = begun ? std::min<qsizetype>(1, distance(word, name)) : distance(word, name);
        if (far < least) {
            near.clear();
            least = far;
        }
        if (far == least) {
            near += name;
        }
    }
    return near.first(std::min<qsizetype>(near.size(), 4));
}

QString alternatives(const QStringList &names)
{
    if (names.size() < 2) {
        return names.join(QString());
    }
    return CommandLine::tr("%1 or %2").arg(names.first(names.size() - 1).join(QStringLiteral(", ")), names.last());
}

std::optional<int> parsedInteger(const QString &text)
{
    const QByteArray bytes = text.toUtf8();
    const char *first = bytes.constData();
    const char *const last = first + bytes.size();
    if (last - first > 1 && *first == '+' && first[1] != '-') {
        ++first; // from_chars knows no plus sign
    }
    int number = 0;
    const std::from_chars_result result = std::from_chars(first, last, number);
    return result.ec == std::errc() && result.ptr == last ? std::optional(number) : std::nullopt;
}

OptionReader::OptionReader(const QCommandLineParser &parser)
    : m_parser(parser)
{
    // The report's iterates, an order of magnitude sooner.
    m_scene.solver.newton.elimination = Elimination::Structured;
}

void OptionReader::takeScene(const QString &path)
{
    const std::variant<Scene, QString> outcome = readScene(path);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        refuseFile(*sentence);
    } else {
        m_scene = std::get<Scene>(outcome);
    }
}

void OptionReader::refuse(const QString &sentence)
{
    if (!m_fault) {
        m_fault = sentence;
    }
}

void OptionReader::refuseFile(const QString &sentence)
{
    if (!m_fileFault) {
        m_fileFault = sentence;
    }
}

double OptionReader::number(const char *name, double otherwise, const std::optional<Unit> &unit)
{
    if (!has(name)) {
        return otherwise;
    }
    const Quantity quantity = readQuantity(text(name), unit, QLocale::c());
    if (!quantity.fault) {
        return quantity.value;
    }
    if (*quantity.fault == QuantityFault::TooLarge) {
        refuse(tooLarge(name));
        return otherwise;
    }
    const bool asksForUnit =
        *quantity.fault == QuantityFault::UnknownUnit || *quantity.fault == QuantityFault::WrongUnit;
    refuse(unit && asksForUnit
               ? CommandLine::tr("--%1 must be a number, alone or with %2 behind it, not \"%3\".")
                     .arg(QLatin1String(name), alternatives(unitsFor(*unit)), text(name))
               : CommandLine::tr("--%1 must be a number with a decimal point, such as 60 or -0.5, not \"%2\".")
                     .arg(QLatin1String(name), text(name)));
    return otherwise;
}

double OptionReader::boundedNumber(const char *name, double otherwise, const Unit &unit)
{
    const double value = number(name, otherwise, unit);
    if (std::abs(value) > kLargestParameter) {
        refuse(tooLarge(name));
    }
    return value;
}

int OptionReader::integer(const char *name, int otherwise, int smallest, int largest)
{
    if (!has(name)) {
        return otherwise;
    }
    const double number = readQuantity(text(name), {}, QLocale::c()).value; // a fault: NaN
    if (!(number >= smallest && number <= largest) || number != std::round(number)) {
        refuse(CommandLine::tr("--%1 must be a whole number from %2 to %3, not \"%4\".")
                   .arg(QLatin1String(name))
                   .arg(smallest)
                   .arg(largest)
                   .arg(text(name)));
        return otherwise;
    }
    return static_cast<int>(number);
}

QString OptionReader::file(const char *name)
{
    if (has(name) && text(name).isEmpty()) {
        refuse(CommandLine::tr("--%1 needs the name of a file.").arg(QLatin1String(name)));
    }
    return text(name);
}

QStringList OptionReader::files(const char *name)
{
    file(name);
    return texts(name);
}

QString OptionReader::tooLarge(const char *name)
{
    return CommandLine::tr("--%1 must not exceed 1e12 in magnitude.").arg(QLatin1String(name));
}

} // namespace slidercrank
