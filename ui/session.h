// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one mutable state: what the person chose, the reference data, the current time. Every change recomputes what is
// on show and publishes it as one immutable Result; moving the time publishes a Pose and recomputes nothing else.

#include "core/comparison.h"
#include "core/mobility.h"
#include "core/trajectory.h"
#include "ui/reference_file.h"

#include <QObject>
#include <QString>

#include <memory>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The mechanism at one instant, by one closed-form evaluation. Lengths mm, angles rad.
struct Pose {
    double time = 0.0;
    double theta2 = 0.0; ///< not wrapped
    double theta3 = 0.0;
    double pinX = 0.0, pinY = 0.0;  ///< A
    double sliderX = 0.0;           ///< B, at y = c
    Status status = Status::Solved; ///< Solved or Singular: the pose exists
    bool exists() const { return status == Status::Solved || status == Status::Singular; }
};

/// Everything the views draw, of one moment; immutable once published.
struct Result {
    Mechanism mechanism;
    Sampling sampling;
    SolverSettings solver;
    Trajectory trajectory; ///< the six plotted channels
    MotionLimits limits;
    std::shared_ptr<const Reference> reference; ///< may be null

    // Filled when there is a reference: the model at the file's own instants, one comparison per series of the file.
    Trajectory atReference;
    std::vector<ChannelComparison> comparison;

    double computeSeconds = 0.0;
};

class Session : public QObject
{
    Q_OBJECT

public:
    explicit Session(QObject *parent = nullptr);
    ~Session() override;

    const Parameters &parameters() const { return m_parameters; }
    const Sampling &sampling() const { return m_sampling; }
    const SolverSettings &solver() const { return m_solver; }
    double time() const { return m_time; }
    Pose pose() const;
    const std::shared_ptr<const Result> &result() const { return m_result; } ///< never null
    const std::shared_ptr<const Reference> &reference() const { return m_reference; }

public slots:
    void setParameters(const slidercrank::Parameters &parameters);
    void setSampling(const slidercrank::Sampling &sampling);
    void setSolver(const slidercrank::SolverSettings &solver);

    /// Brought into the sampled range.
    void setTime(double seconds);

    /// Reads the file off the GUI thread; referenceLoaded or problemFound follows. What is on show stays until then.
    void loadReference(const QString &path);

    /// Takes one that is already read, at once; null: none.
    void setReference(const std::shared_ptr<const slidercrank::Reference> &reference);

    /// Stops what is computed or read aside; what is on show stays.
    void cancel();

signals:
    void parametersChanged(const slidercrank::Parameters &parameters); ///< the return edge, to the panels
    void settingsChanged(const slidercrank::Sampling &sampling, const slidercrank::SolverSettings &solver);
    void resultChanged(const std::shared_ptr<const slidercrank::Result> &result);
    void timeChanged(const slidercrank::Pose &pose);
    void referenceLoaded(const std::shared_ptr<const slidercrank::Reference> &reference);
    void problemFound(const QString &sentence); ///< one sentence, for the message bar; nothing else changed
    void busyChanged(bool busy);                ///< a computation or a file takes longer than a moment

private:
    void recompute();
    void publish(std::shared_ptr<const Result> result);

    /// Runs work() in another thread, then done(its outcome) in this one.
    template <typename Work, typename Done>
    void runAside(Work work, Done done);

    Parameters m_parameters;
    Sampling m_sampling;
    SolverSettings m_solver;
    double m_time = 0.0;
    std::shared_ptr<const Reference> m_reference;
    std::shared_ptr<const Result> m_result;
    std::stop_source m_computation;
    std::stop_source m_reading;
    int m_pending = 0; ///< jobs aside
};

} // namespace slidercrank

Q_DECLARE_METATYPE(slidercrank::Parameters)
Q_DECLARE_METATYPE(slidercrank::Pose)
