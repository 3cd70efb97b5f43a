// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mutable state of the program: the settings of the user, the reference data, the current time. Every edit computes
// an immutable Result and publishes it; a change of the time only publishes a Pose. When the parameters have not
// changed for a moment, the mechanism of the reference file is identified in the background. Every edit can be undone.

#include "ui/document/background_task.h"
#include "ui/document/edit_stack.h"
#include "ui/document/reference_file.h"
#include "ui/document/result.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace slidercrank
{

class Session : public QObject
{
    Q_OBJECT

public:
    explicit Session(QObject *parent = nullptr);
    ~Session() override;

    const Parameters &parameters() const { return m_choices.parameters; }
    const Sampling &sampling() const { return m_choices.sampling; }
    const SolverSettings &solver() const { return m_choices.solver; }
    double alpha2() const { return m_choices.alpha2; } ///< rad/s²: acceleration of the crank (Choices::alpha2)
    double time() const { return m_time; }
    Pose pose() const { return poseAt(m_choices.parameters, m_time); }
    const std::shared_ptr<const Result> &result() const { return m_result; } ///< never null
    const std::shared_ptr<const Reference> &reference() const { return m_choices.reference; }
    const std::vector<Parameters> &pinned() const { return m_choices.pinned; }

    /// Returns null until a reference file has been identified. While the parameters change, this is the identification
    /// for earlier parameters (ReferenceIdentification::parameters).
    const std::shared_ptr<const ReferenceIdentification> &identification() const { return m_identification; }

    QUndoStack &undoStack() { return m_edits; }

    /// Takes over the undo steps of another session. Requires that open() has given this session the choices of that
    /// one.
    void takeOverSteps(const Session &other) { m_edits.takeOver(other.m_edits); }

    bool isReading() const { return m_reading.isRunning(); }

    /// Returns whether anything was edited since the undo stack was clean. Opening a reference file is not an edit.
    bool isModified() const { return m_edits.isModified(); }

    /// Replaces all choices and the time, which cannot be undone. If their result takes long to compute, that of
    /// simpler choices is published first. Reads the reference from `source` in the background; the time range in
    /// `choices` is kept, even if the data exceed it.
    void open(const Choices &choices, double seconds, const std::optional<ReferenceSource> &source);

public slots:
    void setParameters(const slidercrank::Parameters &parameters);
    void setParameter(slidercrank::Parameter parameter, double value);
    /// Sets ω2 (rad/s) and goes to the first time at which the crank has its present angle, as one edit.
    void setCrankSpeedHere(double omega2);

    void setSampling(const slidercrank::Sampling &sampling);
    void setSolver(const slidercrank::SolverSettings &solver);
    void setAlpha2(double alpha2); ///< rad/s²

    void pinMotion(); ///< pins the current motion, in place of the oldest one if kMaxPinned motions are pinned
    void unpinMotions();

    void setTime(double seconds); ///< clamped to the time range

    /// Reads a file, or joins several files, in the background. Uses the column choices that are saved for these files
    /// (column_choices.h). Emits referenceLoaded() or referenceRefused(). If the time range does not contain the data,
    /// it is replaced by that of the data.
    void loadReference(const QString &path) { loadReference(QStringList(path)); }
    void loadReference(const QStringList &paths);

    /// Uses data that have been read, or no data if null. Does not change the time range.
    void setReference(const std::shared_ptr<const slidercrank::Reference> &reference);

    /// Makes the mechanism that was found in the file the model, with nominal values, and reads the file with the
    /// conventions that were found. If the crank speed is not constant, reads it over the crank angle, in the
    /// background, and says with confirmed() what the window then shows. Does nothing if no mechanism was found.
    void useFoundMechanism();

    /// Applies a convention to the reference data. Convention::Kind::OtherAssembly changes the assembly of the model
    /// instead.
    void apply(const slidercrank::Convention &convention);

    void readAsPrinted(); ///< removes the conventions from the reference data

    /// Edits of parameters between the two calls are undone in one step.
    void beginDrag() { m_edits.setDragging(true); }
    void endDrag() { m_edits.setDragging(false); }

    /// Stops all background tasks, and restores the choices of the current result.
    void cancel();

    /// Makes a task of another object one of the background tasks: busyChanged() and progressed() report it, and
    /// cancel() discards it.
    void track(BackgroundTask *task);

    /// Emit failed() and confirmed().
    void reportFailure(const QString &sentence) { emit failed(sentence); }
    void confirm(const QString &sentence) { emit confirmed(sentence); }

    /// Confirms that a file was written, or says why not.
    void reportWritten(const QString &path, const std::optional<QString> &problem);

signals:
    void parametersChanged(const slidercrank::Parameters &parameters);
    void alpha2Changed(double alpha2); ///< rad/s²
    void settingsChanged(const slidercrank::Sampling &sampling, const slidercrank::SolverSettings &solver);
    void resultChanged(const std::shared_ptr<const slidercrank::Result> &result);
    void timeChanged(const slidercrank::Pose &pose);
    void identificationChanged(
        const std::shared_ptr<const slidercrank::ReferenceIdentification> &identification); ///< may be null
    void referenceLoaded(const std::shared_ptr<const slidercrank::Reference> &reference);   ///< may be null

    void referenceRefused(const QStringList &paths, const QString &sentence); ///< nothing has changed
    void problemFound(const QString &sentence);                               ///< nothing has changed
    void failed(const QString &sentence);    ///< a file could not be opened, written or copied
    void fileWritten(const QString &path);   ///< a file that the user asked for: a scene or an export
    void confirmed(const QString &sentence); ///< a file was written or copied
    void progressed(double fraction);        ///< 0 … 1 of a background task
    void busyChanged(bool busy);             ///< emitted when a background task starts or ends
    void cancelled();                        ///< cancel() was called

private:
    enum class TimeRange {
        Kept,
        OfReference ///< the time range becomes that of the reference, unless it already contains that range
    };
    enum class Asker { User, Scene }; ///< who asks for a reference to be read

    /// Applies the choices as one step that can be undone. Without a name, the step is named by what it changes.
    void edit(const Choices &choices, const QString &name = {}, TimeRange timeRange = TimeRange::Kept,
              std::optional<double> time = {});
    void editReference(const std::shared_ptr<const Reference> &reference, TimeRange timeRange);
    void applyChoices(const Choices &choices, std::optional<double> time = {});

    /// Reads in the background, and then makes the data the reference or emits referenceRefused(). The source of a
    /// scene states all column choices. A source that the user chose is read with the saved column choices, and then
    /// the time range follows the data.
    void read(const ReferenceSource &source, Asker asker);

    void recompute();
    void publish(std::shared_ptr<const Result> result);
    void startIdentification();
    bool isIdentificationCurrent() const;
    void stopIdentification(); ///< publishes an identification without a result
    void publishIdentification(std::shared_ptr<const ReferenceIdentification> identification);

    Choices m_choices;
    double m_time = 0.0;
    std::shared_ptr<const Result> m_result;
    std::shared_ptr<const ReferenceIdentification> m_identification;
    BackgroundTask m_computation;
    BackgroundTask m_reading;
    BackgroundTask m_identifying;
    QTimer m_settlingTimer{this}; ///< runs while the parameters may still be changing

    EditStack m_edits{[this](const Choices &choices, std::optional<double> time) { applyChoices(choices, time); },
                      this};
};

} // namespace slidercrank
