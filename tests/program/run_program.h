// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs commands in the process of the test or in a separate process, and reads their output.

#include "app/command_line.h"
#include "tests/support/files.h"
#include "tests/support/waiting.h"

#include <QBuffer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <limits>
#include <vector>

namespace slidercrank
{

/// The exit status and the output of a command.
struct RunResult {
    int status = -1; ///< -1: the program crashed, or did not end within kPatience
    QByteArray output;
    QByteArray error;

    QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
    QJsonObject firstFile() const { return json()["files"].toArray().first().toObject(); }

    bool hasOneLineError() const { return error.count('\n') == 1 && error.endsWith('\n'); }
};

/// Runs a command in this process.
inline RunResult run(const QStringList &arguments)
{
    QBuffer output;
    QBuffer error;
    output.open(QIODevice::WriteOnly);
    error.open(QIODevice::WriteOnly);
    const ExitStatus status = runCommandLine(QStringList("slidercrank") + arguments, {output, error});
    return {static_cast<int>(status), output.data(), error.data()};
}

/// Splits a command at spaces. An argument in quotes may contain spaces; the last one may be empty.
inline QStringList splitCommand(const QString &line)
{
    const QStringList arguments = QProcess::splitCommand(line);
    return line.endsWith("\"\"") ? arguments + QStringList("") : arguments;
}

inline RunResult run(const QString &line)
{
    return run(splitCommand(line));
}

/// Waits until a program ends, and returns its exit status and output.
inline RunResult waitForResult(QProcess &process)
{
    const bool exitedNormally = process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit;
    return {exitedNormally ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// Runs the program in a process of its own, without a display. `variables`: "NAME=value" in its environment.
inline RunResult runProgram(const QStringList &arguments, const QByteArray &input = {},
                            const QStringList &variables = {})
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) {
        environment.remove(name);
    }
    for (const QString &variable : variables) {
        environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
    }
    process.setProcessEnvironment(environment);
    process.start(SLIDERCRANK_PROGRAM, arguments);
    process.write(input);
    process.closeWriteChannel();
    return waitForResult(process);
}

/// A table in CSV.
struct CsvTable {
    QByteArrayList header;
    std::vector<QByteArrayList> rows;

    explicit CsvTable(const QByteArray &csv)
    {
        for (const QByteArray &line : csv.trimmed().split('\n')) {
            rows.push_back(line.split(','));
        }
        header = rows.front();
        rows.erase(rows.begin());
    }

    /// Returns the number in that row and column, or infinity if there is no such column.
    double at(std::size_t row, const char *name) const
    {
        const qsizetype column = header.indexOf(name);
        return column < 0 ? std::numeric_limits<double>::infinity() : rows[row][column].toDouble();
    }
};

} // namespace slidercrank
