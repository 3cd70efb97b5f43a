// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A file's comparison as text, CSV and JSON: what `compare` and `identify` share.

#include "core/comparison/comparison.h"
#include "ui/document/reference_file.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <memory>
#include <variant>
#include <vector>

namespace slidercrank
{

/// As answers call it: "file.csv", or "a.csv + b.csv" of files that are joined.
QString joinedName(const QStringList &files);

/// Of such files the list, as a member that others follow; empty for one.
QByteArray jsonJoined(const QStringList &files);

/// The file; where it counts by the crank's angle, with the instants of that mechanism.
std::variant<std::shared_ptr<const Reference>, QString>
readTimed(const ReferenceSource &source, const std::vector<NamedChoice> &columns, const Mechanism &mechanism);

/// As the contract names it in CSV and JSON.
const char *wordOf(Verdict verdict);

/// "file.csv: t = 0 s to 1 s, 201 instants"
QString headlineOf(const QString &file, const ReferenceData &data);

/// A row a channel, for people. `data`: what was compared.
QString tableOf(const std::vector<ChannelComparison> &channels, const ReferenceData &data);

QByteArray csvHeader();

/// A row a channel; in each the verdict of the file, and why it differs.
QByteArray csvOf(const QString &file, const std::vector<ChannelComparison> &channels, Verdict verdict,
                 const QString &sentence);

/// An array, an object a channel.
QByteArray jsonOf(const std::vector<ChannelComparison> &channels);

/// Says on standard error which rows and columns of the file were left out, and which columns were guessed at.
void warnOf(const QString &file, const ReferenceData &data);

} // namespace slidercrank
