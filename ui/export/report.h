// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a report as PDF on A4. It contains the mechanism with its motion limits and its drawing, the plots, the errors
// relative to a reference file with the mechanism found for this file, and the method of computation.

#include "core/identification/diagnosis.h"
#include "ui/document/result.h"
#include "ui/export/figure_export.h"

#include <QByteArrayList>
#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>

namespace slidercrank
{

struct ReportContent {
    std::shared_ptr<const Result> result; ///< not null
    Diagnosis diagnosis;                  ///< of the reference; unused without one
    bool hasGhost = false;         ///< whether the drawing shows the linkage of the reference or of the pinned motion
    QByteArrayList checksums = {}; ///< SHA-256 of the reference's files, in hexadecimal; empty if unknown
    QDateTime written = QDateTime::currentDateTime();
};

/// The drawings in a report, on white.
struct ReportDrawings {
    FigureDrawing mechanism;
    FigureDrawing figure;
};

/// Returns the report as HTML. The paragraphs "[mechanism]" and "[figure]" stand for the drawings.
QString reportHtml(const ReportContent &content);

/// Writes the report. Returns nullopt on success, else a message; an older file of that name is then unchanged.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const ReportDrawings &drawings);

} // namespace slidercrank
