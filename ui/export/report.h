// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a report as PDF on A4. It contains the mechanism with its motion limits and its drawing, the plots, the errors
// relative to a reference file with the mechanism found for this file, and the method of computation.

#include "core/identification/diagnosis.h"
#include "ui/document/result.h"
#include "ui/export/figure_export.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>

namespace slidercrank
{

struct ReportContent {
    std::shared_ptr<const Result> result; ///< not null
    Diagnosis diagnosis;                  ///< of the reference; unused without one
    QDateTime written = QDateTime::currentDateTime();
};

/// Returns the report as HTML. The paragraphs "[mechanism]" and "[figure]" stand for the drawings.
QString reportHtml(const ReportContent &content);

/// Writes the report with these drawings, on white. Returns nullopt on success, else a message; an older file of that
/// name is then unchanged.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure);

} // namespace slidercrank
