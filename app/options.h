// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The command line → what is to be done, every value checked, or one sentence that says what is wrong and what to do.
// Numbers are read whole and with a decimal point, whatever the locale.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "core/study/cases.h"
#include "ui/document/reference_file.h"
#include "ui/export/motion_csv.h"
#include "ui/mechanism/mechanism_scene.h"
#include "ui/plots/plot_figure.h"
#include "ui/text/theme.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>
#include <variant>
#include <vector>

namespace slidercrank
{

enum class Format { Text, Csv, Json };

struct SolveOptions {
    Mechanism mechanism;
    Sampling sampling;
    std::optional<double> atInstant; ///< s; this one instant instead of the run
    SolverSettings solver;
    ChannelSet channels;
    AngleUnit angleUnit = AngleUnit::Degree;
    Format format = Format::Csv;
    QString output; ///< empty: standard output
};

struct LimitsOptions {
    Mechanism mechanism;
    Format format = Format::Text;
    QString output; ///< empty: standard output
};

struct CompareOptions {
    Mechanism mechanism;
    QList<QStringList> references; ///< at least one: a file, "-" for standard input, or several that are joined
    std::vector<NamedChoice> columns;
    Format format = Format::Text;
    bool failOnDifference = false;
    QString output; ///< empty: standard output
};

struct IdentifyOptions {
    Mechanism mechanism;           ///< where to start; gives what the file cannot fix
    QList<QStringList> references; ///< as of CompareOptions
    std::vector<NamedChoice> columns;
    Format format = Format::Text; ///< Text or Json
    QString output;               ///< empty: standard output
};

struct StudyOptions {
    std::vector<Case> cases; ///< at least one
    Format format = Format::Text;
    QString output; ///< empty: standard output
};

struct RenderOptions {
    enum class Subject { Figure, Mechanism, Plot, Report, Frames };
    Mechanism mechanism;
    Sampling sampling;
    SolverSettings solver;
    double poseInstant = 0.0; ///< s
    std::optional<ReferenceSource> reference;
    std::vector<Parameters> kept;     ///< motions to lie under the model's
    std::vector<NamedChoice> columns; ///< of the reference
    PlotSettings plots;
    PlotZoom zoom;
    MechanismSettings mechanismSettings;
    std::optional<QRectF> mechanismFrame; ///< mm; none: all of it
    Subject subject = Subject::Figure;
    QString plot; ///< for Subject::Plot, its channel, or error_position, error_velocity, error_acceleration
    QString output;
    QSize size; ///< px before scaling
    double scale = 1.0;
    double speed = 1.0; ///< for Subject::Frames, seconds of the motion in a second of the film
    Theme theme = Theme::Light;
};

struct WindowOptions {
    QString scene;               ///< empty: none
    QStringList reference;       ///< empty: none, or the scene's own; several are joined
    bool choosesDisplay = false; ///< by an option of the window system's
};

/// All that was remembered is to be forgotten, and done.
struct ResetSettings {
};

/// Help or version: to be printed, and done.
struct Answer {
    QString text;
};

struct WrongCommandLine {
    QString sentence;
};

/// The line is right, but a file that it names is not there, or is not what it should be.
struct UnreadableFile {
    QString sentence;
};

using Command = std::variant<WindowOptions, SolveOptions, LimitsOptions, CompareOptions, IdentifyOptions, StudyOptions,
                             RenderOptions, ResetSettings, Answer, WrongCommandLine, UnreadableFile>;

/// `arguments` as QCoreApplication::arguments() gives them, the program's name first.
Command parseCommandLine(const QStringList &arguments);

} // namespace slidercrank
