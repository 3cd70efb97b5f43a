// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one mutable state: the choices of a person, the reference data, the current time. Every change computes an
// immutable Result and publishes it; a change of the time publishes a Pose and computes nothing else. When the
// parameters have rested for a moment, the reference file is identified in the background. Every edit can be undone.

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
    double time() const { return m_time; }
    Pose pose() const { return poseAt(m_choices.parameters, m_time); }
    const std::shared_ptr<const Result> &result() const { return m_result; } ///< never null
    const std::shared_ptr<const Reference> &reference() const { return m_choices.reference; }
    const std::vector<Parameters> &pinned() const { return m_choices.pinned; } ///< pinned motions

    /// Null without a reference file, and until it is known. It may have been found beside other parameters than the
    /// current ones (ReferenceDiagnosis::parameters), until these have rested and the next one is published.
    const std::shared_ptr<const ReferenceDiagnosis> &diagnosis() const { return m_diagnosis; }

    QUndoStack &undoStack() { return m_edits; }

    /// Whether something was edited since the undo stack was clean; opening a reference file is no edit.
    bool isModified() const { return m_edits.isModified(); }

    /// Replaces all choices and the time; that cannot be undone. The reference is read from `source` first, in the
    /// background. Emits opened(), or editedMeanwhile() if something was edited before the file was read.
    void open(const Choices &choices, double seconds, const std::optional<ReferenceSource> &source);

public slots:
    void setParameters(const slidercrank::Parameters &parameters);
    void setParameter(slidercrank::Parameter parameter, double value);
    void setSampling(const slidercrank::Sampling &sampling);
    void setSolver(const slidercrank::SolverSettings &solver);

    void pinMotion(); ///< pins the current motion; up to kMaxPinned
    void unpinMotions();

    void setTime(double seconds); ///< moved into the time range

    /// Reads a file, or several that are joined, in the background, with the columns that a person has chosen for such
    /// files. Emits referenceLoaded() or referenceRefused(). If the time range does not contain the data, it becomes
    /// that of the data.
    void loadReference(const QString &path) { loadReference(QStringList(path)); }
    void loadReference(const QStringList &paths) { loadReference(paths, std::nullopt); }

    /// Reads the current file again with its time or crank angle column taken as `role`, which is Time or CrankAngle,
    /// and remembers that choice.
    void readAbscissaAs(slidercrank::ColumnRole role);

    /// Takes data that have been read, or null, and leaves the time range as it is.
    void setReference(const std::shared_ptr<const slidercrank::Reference> &reference);

    /// Takes the mechanism that was found in the file, with nominal values; does nothing if none was found.
    void useFoundMechanism();

    /// Applies a convention to the reference data; Branch changes the assembly of the model.
    void apply(const slidercrank::Convention &convention);

    void readAsPrinted(); ///< without the conventions

    /// Edits of the same parameter between these two are undone in one step.
    void beginDrag() { m_edits.setDragging(true); }
    void endDrag() { m_edits.setDragging(false); }

    /// Stops what is computed or read in the background, and returns to the choices of the current result. Returns
    /// false if that is not possible because a scene was opened: then it is simplified until its result is soon there.
    bool cancel();

signals:
    void parametersChanged(const slidercrank::Parameters &parameters); ///< for the controls
    void settingsChanged(const slidercrank::Sampling &sampling, const slidercrank::SolverSettings &solver);
    void resultChanged(const std::shared_ptr<const slidercrank::Result> &result);
    void timeChanged(const slidercrank::Pose &pose);
    void diagnosisChanged(const std::shared_ptr<const slidercrank::ReferenceDiagnosis> &diagnosis); ///< may be null
    void referenceLoaded(const std::shared_ptr<const slidercrank::Reference> &reference);           ///< may be null

    /// Before a reference is loaded whose time range replaces the current one.
    void timeRangeReplaced(const std::shared_ptr<const slidercrank::Reference> &reference,
                    const slidercrank::Sampling &sampling);
    void referenceRefused(const QStringList &paths, const QString &sentence); ///< nothing has changed
    void opened(const QString &problem); ///< not empty: why the scene was opened without its reference
    void editedMeanwhile(const std::function<void()> &open); ///< call it to open the scene, and lose the edits
    void readingProgressed(double part);                     ///< 0 … 1 of the reference file
    void problemFound(const QString &sentence);              ///< nothing has changed
    void busyChanged(bool busy);                             ///< something is computed or read in the background

private:
    void edit(const Choices &choices, const EditName &name);
    void applyChoices(const Choices &choices);
    void follow(const std::shared_ptr<const Reference> &reference);

    /// Reads in the background, with these columns or else the remembered ones, then calls follow().
    void loadReference(const QStringList &paths, const std::optional<std::vector<ColumnChoice>> &columns);
    void read(const std::function<ReferenceSource()> &source,
              const std::function<void(const ReferenceOutcome &)> &done);
    void startWith(const Choices &choices, double seconds, const QString &problem);

    void recompute();
    void publish(std::shared_ptr<const Result> result);
    void startDiagnosis();
    bool isDiagnosisCurrent() const;
    void stopDiagnosis();
    void publishDiagnosis(std::shared_ptr<const ReferenceDiagnosis> diagnosis);

    Choices m_choices;
    double m_time = 0.0;
    std::shared_ptr<const Result> m_result;
    std::shared_ptr<const ReferenceDiagnosis> m_diagnosis;
    BackgroundTask m_computation;
    BackgroundTask m_reading;
    BackgroundTask m_diagnosing;
    int m_running = 0;   ///< how many of these three
    QTimer m_rest{this}; ///< runs while the parameters may still be moving

    EditStack m_edits{[this](const Choices &choices) { applyChoices(choices); }, this};
};

} // namespace slidercrank
