// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A report on A4 as PDF: the mechanism with its motion limits and its drawing, the plots, then how far a reference file
// is from the motion and which mechanism the file belongs to, and how all of it was computed.

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
    std::shared_ptr<const Result> result; ///< not null; its reference may be
    Diagnosis diagnosis;                  ///< of the reference against the mechanism; of no meaning without one
    bool hasGhost = false;                ///< the drawing also shows the linkage of the reference or the pinned motion
    QByteArrayList checksums = {};        ///< SHA-256 of the reference's files, in hexadecimal; empty: unknown
    QDateTime written = QDateTime::currentDateTime();
};

/// The drawings in a report, on white.
struct ReportDrawings {
    FigureDrawing mechanism;
    FigureDrawing figure;
};

/// Everything but the drawings, which are the paragraphs "[mechanism]" and "[figure]".
QString reportHtml(const ReportContent &content);

/// Returns a sentence if the file cannot be written; then an older file of that name is still there.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const ReportDrawings &drawings);

} // namespace slidercrank
