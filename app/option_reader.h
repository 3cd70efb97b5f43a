// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The values of options, each checked as it is taken, and what is said of a word that nobody knows.

#include "app/command_line.h"
#include "core/import/unit_text.h"
#include "ui/document/scene.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <initializer_list>
#include <optional>
#include <utility>

namespace slidercrank
{

/// The names that are nearest to a word or begin with it, at most four; none farther than a third of its letters.
QStringList nearest(const QString &word, const QStringList &names);

/// "x", "x or y", "x, y or z".
QString alternatives(const QStringList &names);

/// The whole text as a number.
std::optional<int> parsedInteger(const QString &text);

/// Takes checked values from what was parsed. The first fault is kept; after it the values mean nothing.
class OptionReader
{
public:
    explicit OptionReader(const QCommandLineParser &parser);

    const std::optional<QString> &fault() const { return m_fault; }
    const std::optional<QString> &fileFault() const { return m_fileFault; }

    /// What holds where no option says otherwise.
    const Scene &scene() const { return m_scene; }
    void takeScene(const QString &path);

    void refuse(const QString &sentence);
    void refuseFile(const QString &sentence);

    bool has(const char *name) const { return m_parser.isSet(QLatin1String(name)); }
    QString text(const char *name) const { return m_parser.value(QLatin1String(name)); }

    /// All that were given, in their order, also where there is no such option.
    QStringList texts(const char *name) const
    {
        return m_parser.optionNames().contains(QLatin1String(name)) ? m_parser.values(QLatin1String(name))
                                                                    : QStringList();
    }

    /// In that unit, whatever unit was written behind it; without: a number alone.
    double number(const char *name, double otherwise, const std::optional<Unit> &unit = {});

    /// Of a magnitude that every computation bears.
    double boundedNumber(const char *name, double otherwise, const Unit &unit);

    int integer(const char *name, int otherwise, int smallest, int largest);

    template <typename Choice>
    Choice choice(const char *name, Choice otherwise, std::initializer_list<std::pair<const char *, Choice>> choices)
    {
        if (!has(name)) {
            return otherwise;
        }
        QStringList words;
        for (const auto &[word, meaning] : choices) {
            if (text(name) == QLatin1String(word)) {
                return meaning;
            }
            words += QLatin1String(word);
        }
        refuse(
            CommandLine::tr("--%1 must be %2, not \"%3\".").arg(QLatin1String(name), alternatives(words), text(name)));
        return otherwise;
    }

    /// Empty when not given.
    QString file(const char *name);
    QStringList files(const char *name); ///< all that were given

    static QString tooLarge(const char *name);

private:
    const QCommandLineParser &m_parser;
    Scene m_scene;
    std::optional<QString> m_fault;
    std::optional<QString> m_fileFault;
};

} // namespace slidercrank
