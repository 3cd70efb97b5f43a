// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a report as PDF on A4 or Letter: the mechanism with its drawing, the values at one crank angle, the motion
// limits, the table of the motion and the polygons, the plots with the method of computation, and the comparison with a
// reference file or a pinned motion.
//
// A comparison with a file has neither the table nor the polygons: they are exercises about the model, and would
// separate the drawing from the errors by a page.

#include "core/identification/identification.h"
#include "ui/document/result.h"
#include "ui/document/view_settings.h"
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
    double alpha2 = 0.0;                  ///< rad/s²: acceleration of the crank in values, table and polygons
    std::optional<MotionTableSettings> table = {}; ///< nullopt: every 15°, with the usual columns
    std::optional<Interval> plottedTime = {};      ///< s; nullopt if the plots show the whole time range
    PaperSize paper = PaperSize::A4;
    QDateTime timeOfWriting = QDateTime::currentDateTime();
};

/// Returns the time range (s) that the plots of a report show: that of the zoom, if there is one, otherwise the first
/// revolution if the crank is so fast that the curves would look like bands and no motions are compared. Returns
/// nullopt for the whole time range.
std::optional<Interval> plottedTime(const Result &result, const PlotZoom &zoom);

/// The texts in reportHtml() that the drawings replace.
inline constexpr const char *kMechanismPlaceholder = "[mechanism]";
inline constexpr const char *kPolygonsPlaceholder = "[polygons]";
inline constexpr const char *kFigurePlaceholder = "[figure]";

/// Returns the table of the parameters of the model as HTML. The mechanism is drawn beside it.
QString parameterTable(const ReportContent &content);

/// Returns the report as HTML. Each section begins with a heading.
QString reportHtml(const ReportContent &content);

/// A report that is written in small pieces, so that a window can handle events between them.
class ReportExport
{
public:
    virtual ~ReportExport() = default;

    virtual bool advance() = 0; ///< does the next piece; the last one writes the file. Returns false if none is left
    double progress() const { return m_progress; } ///< the part that is done, 0 … 1, in ascending order

    /// Returns why the file was not written, or nullopt on success; an older file of that name is then unchanged.
    const std::optional<QString> &problem() const { return m_problem; }

protected:
    double m_progress = 0.0;
    std::optional<QString> m_problem;
};

/// Returns a report to be written, with the drawings `mechanism` and `figure`, on white, in the notation that is chosen
/// now. Neither the drawings nor the language may change before the report is written.
std::shared_ptr<ReportExport> beginReport(const QString &path, const ReportContent &content,
                                          const FigureDrawing &mechanism, const FigureDrawing &figure);

/// Writes the whole report. Returns nullopt on success, else a message; an older file of that name is then unchanged.
std::optional<QString> exportReport(const QString &path, const ReportContent &content, const FigureDrawing &mechanism,
                                    const FigureDrawing &figure);

} // namespace slidercrank
