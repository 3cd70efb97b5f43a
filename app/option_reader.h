// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The values of the options of one command, each checked when it is read. All functions throw UsageError.

#include "app/command_line.h"
#include "app/option_table.h"
#include "core/import/unit_text.h"
#include "ui/document/scene.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace slidercrank
{

/// "x", "x or y", "x, y or z".
QString joinedByOr(const QStringList &names);

/// Throws that there is no such name, with the most similar of the names that exist.
[[noreturn]] void throwUnknownName(const QString &message, const QString &name, const QStringList &names);

class OptionReader
{
public:
    /// `arguments`: without the names of program and command.
    OptionReader(Subcommand subcommand, const QStringList &arguments);

    Subcommand subcommand() const { return m_subcommand; }

    /// What holds where no option says otherwise: the scene of --scene, or the defaults.
    const Scene &scene() const { return m_scene; }
    void readScene();

    bool has(const char *name) const;
    QString text(const char *name) const { return m_parser.value(QLatin1String(name)); }
    QStringList texts(const char *name) const;
    QStringList files() const { return m_parser.positionalArguments(); } ///< the arguments that are no options

    /// In `unit`, whatever unit the number was given in; without a unit, a number alone.
    double number(const char *name, double defaultValue, const std::optional<Unit> &unit = {}) const;
    double positiveNumber(const char *name, double defaultValue, const std::optional<Unit> &unit = {}) const;
    int integer(const char *name, int defaultValue, int smallest, int largest) const;

    /// The value of an option with a fixed list of words, "open|crossed" in the option table: the enumerator with the
    /// number that the word has in the list.
    template <typename Enum>
    Enum choice(const char *name, Enum defaultValue) const
    {
        return has(name) ? static_cast<Enum>(choiceIndex(name)) : defaultValue;
    }

    /// The option as the table describes it for this command; null if the command does not take it.
    const OptionDescription *description(const char *name) const;

    /// Throws if any of these options was given, with a message that names the option.
    void refuse(const std::vector<const char *> &names, const QString &message) const;

private:
    void checkSyntax(bool isParsed) const;
    qsizetype choiceIndex(const char *name) const;

    Subcommand m_subcommand;
    std::vector<OptionDescription> m_descriptions;
    QCommandLineParser m_parser;
    Scene m_scene;
};

} // namespace slidercrank
