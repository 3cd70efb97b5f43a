// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A report on A4 pages, as a PDF with real text.

#include "ui/export/figure_export.h"
#include "ui/export/report.h"

#include <QString>

#include <optional>

namespace slidercrank
{

/// The drawings in a report, black on white.
struct ReportDrawings {
    FigureDrawing mechanism;
    FigureDrawing figure;
};

/// Nothing when the file was written, else a sentence that says why not; then an older file of that name is still
/// there.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const ReportDrawings &drawings);

} // namespace slidercrank
