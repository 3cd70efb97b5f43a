// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a report as PDF on A4 or Letter: the mechanism with its drawing, the values at one crank angle, the motion
// limits, the plots with the method of computation, and the comparison with a reference file or a pinned motion.

#include "core/identification/identification.h"
#include "ui/document/result.h"
#include "ui/export/figure_export.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>

namespace slidercrank
{

enum class PaperSize { A4, Letter };

/// Returns the paper that is usual in the country of the locale.
PaperSize usualPaper();

struct ReportContent {
    std::shared_ptr<const Result> result; ///< not null
    Identification found;                 ///< the mechanism of the reference; not used if there is no reference
    double time = 0.0;                    ///< s, at which the values are stated and the mechanism is drawn
    double alpha2 = 0.0;                  ///< rad/s²: acceleration of the crank, in the values only
    PaperSize paper = PaperSize::A4;
    QDateTime timeOfWriting = QDateTime::currentDateTime();
};

/// The paragraphs that stand for the drawings in the text of a report.
inline constexpr const char *kMechanismPlace = "[mechanism]";
inline constexpr const char *kFigurePlace = "[figure]";

/// Returns the table of the parameters of the model as HTML. The mechanism is drawn beside it.
QString parameterTable(const ReportContent &content);

/// Returns the report as HTML. Each section begins with a heading.
QString reportHtml(const ReportContent &content);

/// Writes the report with the drawings `mechanism` and `figure`, on white. Returns nullopt on success, else a message;
/// an older file of that name is then unchanged.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure);

} // namespace slidercrank
