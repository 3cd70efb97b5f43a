// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one mutable state: what the person chose, the reference data, the current time. Every change recomputes what is
// on show and publishes it as one immutable Result; moving the time publishes a Pose and recomputes nothing else. What
// a file has to say about itself follows as a ReferenceDiagnosis, when the parameters rest. Every edit can be undone.

#include "ui/document/edit_stack.h"
#include "ui/document/reference_file.h"
#include "ui/document/result.h"
#include "ui/document/work_aside.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <variant>
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
    Pose pose() const;
    const std::shared_ptr<const Result> &result() const { return m_result; } ///< never null
    const std::shared_ptr<const Reference> &reference() const { return m_choices.reference; }
    const std::vector<Parameters> &kept() const { return m_choices.kept; }

    /// Null without a reference, and until it is known. Of a reference's diagnoses the last stays until the parameters
    /// have rested and the next is there: it may be of other parameters than the ones on show
    /// (ReferenceDiagnosis::parameters).
    const std::shared_ptr<const ReferenceDiagnosis> &diagnosis() const { return m_diagnosis; }

    QUndoStack &undoStack() { return m_edits; }

    /// Names the edits that can be undone in the language now in use.
    void retranslateEdits() { m_edits.retranslate(); }

    /// Other choices and another time in place of all there was, which cannot be undone; the reference is read from
    /// `source` first, off the GUI thread, and what is on show stays until then. opened() follows; where something was
    /// edited meanwhile, editedMeanwhile() does.
    void open(const Choices &choices, double seconds, const std::optional<ReferenceSource> &source);

public slots:
    void setParameters(const slidercrank::Parameters &parameters);
    void setParameter(slidercrank::Parameter parameter, double value); ///< one of them, the others as they are
    void setSampling(const slidercrank::Sampling &sampling);
    void setSolver(const slidercrank::SolverSettings &solver);

    /// The motion of the present parameters stays under all that follows; up to kMostKept do.
    void keep();
    void forgetKept();

    /// Brought into the sampled range.
    void setTime(double seconds);

    /// Reads the file off the GUI thread, its columns as a person once chose them; referenceLoaded or referenceRefused
    /// follows. What is on show stays until then. Where its instants lie outside the run, the run becomes the file's.
    void loadReference(const QString &path);

    /// Of several files, a plot each, joined.
    void loadReference(const QStringList &paths);

    /// The same for the file on show, whose columns a person chose anew; conventions applied stay as far as their
    /// columns do.
    void readColumnsAnew(const QStringList &paths);

    /// The same as it reads with its instants, or what stands in their place, taken for that: Time or CrankAngle. The
    /// choice is remembered as those of columns are.
    void readAbscissaAs(slidercrank::ColumnRole role);

    /// Takes one that is already read, at once; null: none. The run stays as it is.
    void setReference(const std::shared_ptr<const slidercrank::Reference> &reference);

    /// The mechanism that was found for the file becomes the model, in round numbers; nothing where none was found.
    void takeOver();

    /// The reference as it reads with that convention; for Branch the model's other assembly.
    void apply(const slidercrank::Convention &convention);

    /// The reference without the conventions applied.
    void readAsPrinted();

    /// What is edited from one to the other is undone in one step. Elsewhere the same kind of edit, repeated at once
    /// (a key held down), is one step too.
    void beginDrag() { m_edits.beginDrag(); }
    void endDrag() { m_edits.endDrag(); }

    /// Stops what is computed or read aside. What is on show stays, and edits that have not come to be shown are taken
    /// back. False where it does not, because a scene asks for more: then problemFound says so.
    bool cancel();

signals:
    void parametersChanged(const slidercrank::Parameters &parameters); ///< the return edge, to the panels
    void settingsChanged(const slidercrank::Sampling &sampling, const slidercrank::SolverSettings &solver);
    void resultChanged(const std::shared_ptr<const slidercrank::Result> &result);
    void timeChanged(const slidercrank::Pose &pose);
    void diagnosisChanged(const std::shared_ptr<const slidercrank::ReferenceDiagnosis> &diagnosis); ///< may be null

    /// Another file, another reading of it, or none.
    void referenceLoaded(const std::shared_ptr<const slidercrank::Reference> &reference);

    /// The run is about to become that of the reference, which is about to be loaded.
    void runFollows(const std::shared_ptr<const slidercrank::Reference> &reference,
                    const slidercrank::Sampling &sampling);
    void referenceRefused(const QStringList &paths, const QString &sentence); ///< what is on show stays
    void opened(const QString &problem);                     ///< by open(); not empty: why it is without its reference
    void editedMeanwhile(const std::function<void()> &open); ///< open() is ready; its edits stay unless this is called
    void readingProgressed(double part);                     ///< 0 … 1 of the file being read
    void problemFound(const QString &sentence); ///< one sentence, for the message bar; nothing else changed
    void busyChanged(bool busy);                ///< a computation or a file takes longer than a moment

private:
    /// Puts the choices into force, as a step that can be undone. `name`: what was done, where that is more than the
    /// difference.
    void edit(const Choices &choices, const EditName &name = {});
    void putInForce(const Choices &choices);

    /// With the run that holds all of it, in one step.
    void follow(const std::shared_ptr<const Reference> &reference);

    /// Runs read(), which reads a file, off the GUI thread, then done(outcome) in this one, unless another file was
    /// asked for by then, or none.
    using Reading = std::variant<std::shared_ptr<const Reference>, QString>;
    using Read = std::function<Reading(std::stop_token stop, const ReadOptions &options)>;
    void readAside(const Read &read, const std::function<void(const Reading &)> &done);

    /// `before`: another reading of the file, whose conventions are to be kept; may be null.
    void loadReference(const QStringList &paths, const std::shared_ptr<const Reference> &before);
    void startWith(const Choices &choices, double seconds);

    void recompute();
    void publish(std::shared_ptr<const Result> result);
    void diagnoseAside();
    void endSearch();
    void publishDiagnosis(std::shared_ptr<const ReferenceDiagnosis> diagnosis);

    Choices m_choices;
    double m_time = 0.0;
    std::shared_ptr<const Result> m_result;
    std::shared_ptr<const ReferenceDiagnosis> m_diagnosis;
    WorkAside m_computation{WorkAside::Kind::OfAnEdit};
    WorkAside m_reading;
    WorkAside m_diagnosing;
    int m_running = 0;   ///< how many of these three
    QTimer m_rest{this}; ///< runs while the parameters may still be on the move

    EditStack m_edits{[this](const Choices &choices) { putInForce(choices); }, this};
};

} // namespace slidercrank
