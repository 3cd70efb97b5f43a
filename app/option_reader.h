// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads the options of a command and checks each value. All functions throw UsageError.

#include "app/command_line.h"
#include "app/option_table.h"
#include "core/import/unit_text.h"
#include "core/mechanism/mechanism.h"
#include "ui/document/scene.h"
#include "ui/text/enum_words.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

namespace slidercrank
{

/// Throws unless `word`, the value of an option, is one of the possible words.
void requireOneOf(const QStringList &words, const QString &word, const char *option);

/// Returns the value in `unit`. The text is a number or an expression such as 2*pi (readExpression()). It may contain a
/// different unit of the same dimension, or no unit; with nullopt it must not have one.
double parseNumber(const char *option, const QString &text, const std::optional<Unit> &unit,
                   double smallest = -kLargestParameter, double largest = kLargestParameter);

class OptionReader
{
public:
    /// `arguments`: the arguments after the names of the program and of the command.
    OptionReader(const CommandDescription &command, const QStringList &arguments);

    const CommandDescription &command() const { return m_command; }

    /// Returns the scene of --scene, or the default scene. Its values are used for options that are not given.
    const Scene &scene() const { return m_scene; }
    void readScene();

    bool has(const char *name) const;
    QString text(const char *name) const { return m_parser.value(QLatin1String(name)); }
    QStringList texts(const char *name) const; ///< all values of an option that may be repeated

    QStringList files() const { return m_parser.positionalArguments(); } ///< the arguments that are not options
    void refuseFiles() const;                                            ///< throws if files() is not empty
    QStringList inputFiles() const;                                      ///< all files that the command reads

    /// Throws if the argument names an option that takes a value, such as "b=8" instead of "--b 8".
    void refuseOptionWithoutDashes(const QString &argument) const;

    /// Returns the number that parseNumber() finds in the option, or the default value if the option is not given.
    double number(const char *name, double defaultValue, const std::optional<Unit> &unit = {},
                  double smallest = -kLargestParameter, double largest = kLargestParameter) const;
    int integer(const char *name, int defaultValue, int smallest, int largest) const;

    /// Returns the enumerator whose word is given, or the default value if the option is not given. Throws if the
    /// option of this command does not take the word.
    template <typename Enum>
    Enum choice(const char *name, Enum defaultValue) const
    {
        if (!has(name)) {
            return defaultValue;
        }
        checkWord(name);
        const auto &rows = EnumWords<Enum>::rows;
        return std::ranges::find(rows, text(name), [](const EnumWord<Enum> &row) { return QString(row.word); })->key;
    }

    /// Throws if any of these options was given. %1 in the message becomes the name of the option.
    void refuseIfGiven(const std::vector<const char *> &names, const QString &message) const;

private:
    void checkRepetitions() const; ///< throws if an option or standard input is given twice, or a file has no name
    /// Throws if an argument is the unit of the number before it, as in "--omega2 60 rpm".
    void checkDetachedUnits(const QStringList &arguments) const;
    void checkWord(const char *name) const; ///< throws if the value is none of the words in the table of options
    const OptionDescription *find(const char *name) const; ///< null if the command does not take the option

    const CommandDescription &m_command;
    std::vector<OptionDescription> m_options;
    QCommandLineParser m_parser;
    Scene m_scene;
};

} // namespace slidercrank
