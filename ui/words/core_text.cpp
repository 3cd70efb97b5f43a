// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/core_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <vector>

namespace slidercrank
{

namespace
{

/// As the core writes them; %1 and %2 stand for what differs.
constexpr std::array kSentences{
    QT_TRANSLATE_NOOP(
        "slidercrank::CoreText",
        "the unit is not known or does not suit the quantity: write for example [%1], rad in its place, or none."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "the unit is not known or does not suit the quantity: write for example "
                                               "[%1], m, cm or in in its place, or none."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText",
                      "the unit of the time is not known: write [s] or [ms], or none for seconds."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "two columns are chosen as the time: keep one of the two."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "two columns are chosen as %1: keep one of the two."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "there is a time column already: keep one of the two."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "there is a column of that name already: keep one of the two."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not a number: too large"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not a number: this file writes a decimal comma"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not a number: this file writes a decimal point"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not a number"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "no column beside the time has a known name: name them as in theta3, "
                                               "theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "no column beside the time can be told for certain (%1: %2): name them "
                                               "as in theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "another column could be the same quantity"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "its unit is not known or does not suit the quantity"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "its values are not the derivative that its name says"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "neither its unit nor its values tell an angle from a length"),
    QT_TRANSLATE_NOOP(
        "slidercrank::CoreText",
        "numbers stand where the names of the columns should: put a line such as time,theta3,R4_x above them."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "there is no time column: name the column of the instants \"time\"."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "a quotation mark that is not closed at the end of the cell"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "too many cells"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "too few cells"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "no time"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "this line and %1 more below it cannot be read either"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText",
                      "The file is a spreadsheet or an archive, not text: save the table as CSV."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "The file is a PDF document, not a table: export the table as CSV."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText",
                      "The file is HTML or XML, not a table of text: export the table as CSV."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "the file holds bytes that are not text: export the table as CSV."),
    QT_TRANSLATE_NOOP(
        "slidercrank::CoreText",
        "the time does not increase from the row before: sort the rows by time and keep one of each instant."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "Reading was stopped."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "there are no numbers below the names of the columns."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "no row can be read; here the reason is: %1. Numbers look like 0.005, "
                                               "or like 0,005 where semicolons or tabs separate the columns."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "no column beside the time holds a number."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText",
                      "the line of units contradicts the heading, %1: correct one of the two."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText",
                      "The file is empty: it needs a line with the names of the columns, and numbers below."),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "Table 1 of the report"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "this mechanism"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "the author's file"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "crossed"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "toggle gap %1"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "exact toggle"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "change point"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "a = b and c = 0"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "rocker"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "one arc"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "two arcs"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "rocker by a hair"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "gap %1"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "locked"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "never assemblable"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "lengths x %1"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "t near %1"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "%1 steps a turn"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "%1 threads"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not optimized"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "other"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "solved"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "singular"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "iteration-limit"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not-assemblable"),
    QT_TRANSLATE_NOOP("slidercrank::CoreText", "not-finite"),
};

QString translated(const char *sentence)
{
    return QCoreApplication::translate("slidercrank::CoreText", sentence);
}

/// Each sentence as a pattern that takes up what differs.
const std::vector<QRegularExpression> &patterns()
{
    static const std::vector<QRegularExpression> made = [] {
        std::vector<QRegularExpression> all;
        for (const char *sentence : kSentences) {
            QString pattern = QRegularExpression::escape(QString::fromUtf8(sentence));
            pattern.replace(QStringLiteral("\\%1"), QStringLiteral("(.+?)"));
            pattern.replace(QStringLiteral("\\%2"), QStringLiteral("(.+?)"));
            all.emplace_back(QRegularExpression::anchoredPattern(pattern));
        }
        return all;
    }();
    return made;
}

QString textOf(const QString &english)
{
    for (std::size_t i = 0; i < kSentences.size(); ++i) {
        const QRegularExpressionMatch match = patterns()[i].match(english);
        if (!match.hasMatch()) {
            continue;
        }
        QString text = translated(kSentences[i]);
        switch (match.lastCapturedIndex()) {
        case 0: return text;
        case 1: return text.arg(textOf(match.captured(1)));
        default: return text.arg(textOf(match.captured(1)), textOf(match.captured(2)));
        }
    }
    return english;
}

} // namespace

QString coreText(std::string_view english)
{
    return textOf(QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size())));
}

QString coreNames(std::string_view english)
{
    const QString separator = QStringLiteral(", ");
    QStringList names = QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size())).split(separator);
    for (QString &name : names) {
        name = textOf(name);
    }
    return names.join(separator);
}

} // namespace slidercrank
