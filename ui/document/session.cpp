// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"

#include "core/sampling/crank_time.h"
#include "ui/document/column_choices.h"
#include "ui/document/whole_file.h"
#include "ui/document/with.h"
#include "ui/text/identification_text.h"
#include "ui/text/parameter_text.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::chrono::milliseconds kSettlingTime{200}; // longer than the time between two edits of a drag

/// Returns the range from the first time stamp to the last, or `sampling` if that is not a valid range.
Sampling rangeOf(const std::vector<double> &times, const Sampling &sampling)
{
    const double start = times.empty() ? kNone : times.front();
    const double span = times.empty() ? kNone : times.back() - start;
    const bool isUsable = std::abs(start) <= kLargestParameter && span <= kLargestParameter;
    if (!isUsable) {
        return sampling;
    }
    return {.start = start, .duration = span > 0.0 ? span : sampling.duration, .steps = sampling.steps};
}

/// Returns whether the range of `outer` contains the range of `inner`, within rounding errors.
bool contains(const Sampling &outer, const Sampling &inner)
{
    constexpr double kRounding = 1e-9; // fraction of the duration
    const double slack = kRounding * outer.duration;
    return inner.start >= outer.start - slack && inner.start + inner.duration <= outer.start + outer.duration + slack;
}

/// Returns the sentence that says which values the parameter may have.
QString faultText(const ParameterFault &fault)
{
    const QString symbol = symbolText(fault.parameter);
    const bool isTooShort =
        fault.reason == ParameterFault::Reason::NotPositive || fault.reason == ParameterFault::Reason::TooShort;
    return isTooShort ? Session::tr("%1 must be at least %2 mm.").arg(symbol, QLocale().toString(kShortestLink))
                      : Session::tr("%1 must be a number up to %2.").arg(symbol, QLocale().toString(kLargestParameter));
}

} // namespace

Session::Session(QObject *parent)
    : QObject(parent)
{
    m_choices.solver = initialSolver();
    m_result = compute(m_choices, std::stop_token());
    m_settlingTimer.setSingleShot(true);
    connect(&m_settlingTimer, &QTimer::timeout, this, &Session::startIdentification);
    for (BackgroundTask *task : {&m_computation, &m_reading, &m_identifying}) {
        track(task);
    }
}

Session::~Session()
{
    m_edits.disconnect(); // the destructor of QUndoStack emits signals
}

void Session::setParameters(const Parameters &parameters)
{
    edit(with(m_choices, &Choices::parameters, parameters));
}

void Session::setParameter(Parameter parameter, double value)
{
    Parameters parameters = m_choices.parameters;
    valueOf(parameters, parameter) = value;
    setParameters(parameters);
}

void Session::setCrankSpeedHere(double omega2)
{
    const Choices choices =
        with(m_choices, &Choices::parameters, with(m_choices.parameters, &Parameters::omega2, omega2));
    const auto time = timeAtCrankAngle(Mechanism(choices.parameters), pose().motion.theta2, m_choices.sampling.start);
    edit(choices, {}, TimeRange::Kept, time);
}

void Session::setSampling(const Sampling &sampling)
{
    edit(with(m_choices, &Choices::sampling, sampling));
}

void Session::setSolver(const SolverSettings &solver)
{
    edit(with(m_choices, &Choices::solver, solver));
}

void Session::setAlpha2(double alpha2)
{
    edit(with(m_choices, &Choices::alpha2, alpha2));
}

void Session::pinMotion()
{
    std::vector<Parameters> pinned = m_choices.pinned;
    std::erase(pinned, m_choices.parameters);
    pinned.push_back(m_choices.parameters);
    if (pinned.size() > kMaxPinned) {
        pinned.erase(pinned.begin());
    }
    edit(with(m_choices, &Choices::pinned, pinned));
}

void Session::unpinMotions()
{
    edit(with(m_choices, &Choices::pinned, {}));
}

void Session::edit(const Choices &choices, const QString &name, TimeRange timeRange, std::optional<double> time)
{
    if (choices == m_choices) {
        return;
    }
    const std::optional<ParameterFault> fault = findFault(choices.parameters);
    const ReferenceOutcome timed =
        fault ? faultText(*fault) : timedBy(Mechanism(choices.parameters), choices.reference);
    if (const QString *sentence = std::get_if<QString>(&timed)) {
        if (timeRange == TimeRange::OfReference) {
            emit referenceRefused(choices.reference->source.paths, *sentence);
        } else {
            emit problemFound(*sentence);
            emit parametersChanged(m_choices.parameters); // widgets show these again
        }
        return;
    }
    Choices adjusted = choices;
    if (choices.reference) {
        // If the time range is that of the file, it remains so: a new ω₂ changes the time stamps of an angle-indexed
        // file.
        const Reference *shownReference = m_result->reference.get();
        const bool isOfFile = shownReference && shownReference->source.paths == choices.reference->source.paths &&
                              choices.sampling == rangeOf(shownReference->data.time, choices.sampling);
        const auto &reference = std::get<std::shared_ptr<const Reference>>(timed);
        const Sampling range = rangeOf(reference->data.time, choices.sampling);
        const bool isReplaced = timeRange == TimeRange::OfReference && !contains(choices.sampling, range);
        adjusted.sampling = isOfFile || isReplaced ? range : choices.sampling;
    }
    using TimeChange = EditStack::TimeChange;
    m_edits.edit(m_choices, adjusted, name, time ? std::optional(TimeChange{m_time, *time}) : std::nullopt);
}

void Session::applyChoices(const Choices &choices, std::optional<double> time)
{
    const Choices before = std::exchange(m_choices, choices);
    if (m_choices.reference != before.reference) {
        publishIdentification(nullptr);
        emit referenceLoaded(m_choices.reference);
    }
    if (m_choices.reference != before.reference || m_choices.parameters != before.parameters) {
        m_identifying.discard();
        m_settlingTimer.stop();
    }
    if (m_choices.parameters != before.parameters) {
        emit parametersChanged(m_choices.parameters);
    }
    if (m_choices.alpha2 != before.alpha2) {
        emit alpha2Changed(m_choices.alpha2);
    }
    if (m_choices.sampling != before.sampling || m_choices.solver != before.solver) {
        emit settingsChanged(m_choices.sampling, m_choices.solver);
    }
    recompute();
    if (time || m_choices.sampling != before.sampling) {
        setTime(time.value_or(m_time));
    }
}

void Session::setTime(double seconds)
{
    const Sampling &sampling = m_choices.sampling;
    m_time = std::clamp(seconds, sampling.start, sampling.start + sampling.duration);
    emit timeChanged(pose());
}

void Session::recompute()
{
    const bool isCurrent = m_choices == m_result->choices;
    if (isCurrent || !takesLong(m_choices)) {
        m_computation.discard();
        publish(isCurrent ? m_result : compute(m_choices, {}));
        return;
    }
    m_computation.start(
        [choices = m_choices](const std::stop_token &stop, const auto &) { return compute(choices, stop); },
        [this](const std::shared_ptr<const Result> &result) { publish(result); },
        [this](const QString &sentence) { emit problemFound(sentence); });
}

void Session::publish(std::shared_ptr<const Result> result)
{
    const bool isNewReference = result->choices.reference != m_result->choices.reference;
    m_result = std::move(result);
    emit resultChanged(m_result);
    emit timeChanged(pose());
    if (m_result->reference) {
        m_settlingTimer.start(isNewReference ? std::chrono::milliseconds(0) : kSettlingTime);
    }
}

bool Session::isIdentificationCurrent() const
{
    return m_identification && m_identification->parameters == m_choices.parameters;
}

void Session::startIdentification()
{
    if (isIdentificationCurrent()) {
        return;
    }
    m_identifying.start(
        [reference = m_choices.reference, parameters = m_choices.parameters](const std::stop_token &stop,
                                                                             const auto &) {
            return std::make_shared<const ReferenceIdentification>(
                ReferenceIdentification{.reference = reference,
                                        .parameters = parameters,
                                        .found = identify(reference->data, Mechanism(parameters), stop)});
        },
        [this](const std::shared_ptr<const ReferenceIdentification> &identification) {
            publishIdentification(identification);
        },
        [this](const QString &sentence) {
            stopIdentification();
            emit problemFound(sentence);
        });
}

void Session::stopIdentification()
{
    m_settlingTimer.stop();
    if (m_choices.reference && !isIdentificationCurrent()) {
        ReferenceIdentification stopped{
            .reference = m_choices.reference, .parameters = m_choices.parameters, .found = {}};
        stopped.found.stopped = true;
        publishIdentification(std::make_shared<ReferenceIdentification>(std::move(stopped)));
    }
}

void Session::publishIdentification(std::shared_ptr<const ReferenceIdentification> identification)
{
    if (m_identification != identification) {
        m_identification = std::move(identification);
        emit identificationChanged(m_identification);
    }
}

void Session::read(const ReferenceSource &source, Asker asker)
{
    const auto work = [source, asker](const std::stop_token &stop, const BackgroundTask::Progress &progress) {
        ReferenceSource complete = source;
        if (asker == Asker::User) {
            complete.columns = savedChoices(readLayout(source.paths), source.paths);
        }
        ReadOptions options;
        options.progress = [&](double part) {
            progress(part);
            return !stop.stop_requested();
        };
        return readReference(complete, options);
    };
    const auto finish = [this, source, asker](const ReferenceOutcome &outcome) {
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            emit referenceRefused(source.paths, *sentence);
        } else {
            editReference(std::get<std::shared_ptr<const Reference>>(outcome),
                          asker == Asker::User ? TimeRange::OfReference : TimeRange::Kept);
        }
    };
    m_reading.start(work, finish, finish); // a failure is a refusal, too
}

void Session::loadReference(const QStringList &paths)
{
    const auto pipe = std::ranges::find_if(paths, [](const QString &path) { return isPipeOrDevice(QFileInfo(path)); });
    if (pipe != paths.end()) { // reading a pipe might never end
        emit referenceRefused(
            paths, tr("%1 is a pipe or a device: save the data in a file, and open that.").arg(displayName(*pipe)));
    } else {
        read({.paths = paths}, Asker::User);
    }
}

/// Returns choices for the same motion whose result is computed at once: in closed form, with the default number of
/// time steps, and without a reference or pinned motions.
static Choices quickChoices(const Choices &choices)
{
    return {.parameters = choices.parameters,
            .sampling = {.start = choices.sampling.start, .duration = choices.sampling.duration},
            .solver = with(choices.solver, &SolverSettings::method, Method::ClosedForm),
            .reference = nullptr};
}

void Session::open(const Choices &choices, double seconds, const std::optional<ReferenceSource> &source)
{
    m_reading.discard();
    m_edits.clear();
    if (takesLong(choices)) { // shows a quick result first, instead of that of the previous scene
        applyChoices(quickChoices(choices));
    }
    applyChoices(choices);
    setTime(seconds);
    if (source) {
        read(*source, Asker::Scene);
    }
}

void Session::setReference(const std::shared_ptr<const Reference> &reference)
{
    m_reading.discard();
    editReference(reference, TimeRange::Kept);
}

void Session::editReference(const std::shared_ptr<const Reference> &reference, TimeRange timeRange)
{
    edit(with(m_choices, &Choices::reference, reference), {}, timeRange);
}

void Session::useFoundMechanism()
{
    if (!m_identification || !m_identification->found.hasMechanism() || !m_choices.reference) {
        return;
    }
    const Identification &found = m_identification->found;
    const Parameters parameters = mechanismToUse(found);
    std::shared_ptr<const Reference> reference = m_choices.reference;
    for (const ConventionFinding &finding : found.conventions) {
        if (finding.convention.kind != Convention::Kind::OtherAssembly) { // the assembly is one of the parameters
            reference = applied(finding.convention, reference);
        }
    }
    const auto use = [this, parameters](const std::shared_ptr<const Reference> &usedReference) {
        Choices choices = m_choices;
        choices.parameters = parameters;
        choices.reference = usedReference;
        edit(choices, EditStack::tr("use of the file's mechanism"), TimeRange::OfReference);
    };
    const std::optional<ReferenceSource> angleIndexed = found.drive ? sourceOverCrankAngle(*reference) : std::nullopt;
    if (!angleIndexed) {
        use(reference);
        return;
    }
    const auto finish = [this, use, reference,
                         text = shownDriveText(found, parameters.omega2)](const ReferenceOutcome &outcome) {
        const auto *overAngle = std::get_if<std::shared_ptr<const Reference>>(&outcome);
        use(overAngle ? *overAngle : reference); // a crank that reverses its direction cannot be read over its angle
        emit confirmed(text);
    };
    const auto work = [source = *angleIndexed](const auto &, const auto &) { return readReference(source); };
    m_reading.start(work, finish, finish);
}

void Session::apply(const Convention &convention)
{
    if (convention.kind == Convention::Kind::OtherAssembly) {
        setParameters(with(parameters(), &Parameters::branch, oppositeBranch(parameters().branch)));
    } else if (m_choices.reference) {
        editReference(applied(convention, m_choices.reference), TimeRange::OfReference);
    }
}

void Session::readAsPrinted()
{
    if (m_choices.reference && m_choices.reference->asPrinted) {
        editReference(m_choices.reference->asPrinted, TimeRange::OfReference);
    }
}

void Session::cancel()
{
    emit cancelled();
    if (m_choices == m_result->choices) {
        stopIdentification();
    } else {
        edit(m_result->choices, EditStack::tr("cancelling"));
    }
    emit confirmed(tr("Cancelled."));
}

void Session::track(BackgroundTask *task)
{
    connect(task, &BackgroundTask::progressed, this, &Session::progressed);
    connect(task, &BackgroundTask::runningChanged, this, &Session::busyChanged);
    connect(this, &Session::cancelled, task, &BackgroundTask::discard);
}

void Session::reportWritten(const QString &path, const std::optional<QString> &problem)
{
    if (problem) {
        emit failed(*problem);
    } else {
        emit fileWritten(path);
        emit confirmed(tr("Exported to %1").arg(displayName(path)));
    }
}

} // namespace slidercrank

#include "moc_session.cpp"
