// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"

#include "ui/document/column_choices.h"
#include "ui/document/with.h"
#include "ui/text/finding_text.h"

#include <QLocale>

#include <algorithm>
#include <chrono>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::chrono::milliseconds kRest{200}; // parameters that move sooner than this are on the move

Request requestOf(const Choices &choices)
{
    return {Mechanism(choices.parameters), choices.sampling, choices.solver, choices.reference, choices.kept};
}

/// What the result was computed from.
Choices choicesOf(const Result &result)
{
    return {result.mechanism.parameters(), result.sampling, result.solver, result.chosenReference(), result.kept};
}

/// From the first of these instants to the last; the same run where that is none.
Sampling runOf(const std::vector<double> &instants, const Sampling &run)
{
    if (instants.empty()) {
        return run;
    }
    const double first = instants.front();
    const double span = instants.back() - first;
    const bool isUsable = std::abs(first) <= kLargestParameter && span <= kLargestParameter;
    return isUsable ? Sampling{first, span > 0.0 ? span : run.duration, run.steps} : run;
}

bool holds(const Sampling &run, const std::vector<double> &instants)
{
    const double end = run.start + run.duration;
    const double room = 1e-9 * std::abs(run.duration); // of rounding
    return instants.empty() ||
           (instants.front() >= std::min(run.start, end) - room && instants.back() <= std::max(run.start, end) + room);
}

bool isRunOf(const std::vector<double> &instants, const Sampling &run)
{
    const Sampling whole = runOf(instants, run);
    return holds(run, instants) && holds(whole, {run.start, run.start + run.duration});
}

/// As much of them as can be shown at once.
Choices soonShown(Choices choices)
{
    const auto takesLong = [&choices] { return slidercrank::takesLong(requestOf(choices)); };
    choices.solver.method = Method::ClosedForm;
    if (takesLong()) {
        choices.sampling.steps = std::min(choices.sampling.steps, Sampling().steps);
    }
    if (takesLong()) {
        choices.reference = nullptr;
    }
    return choices;
}

/// Null when stopped. Takes longer than a moment.
std::shared_ptr<const ReferenceDiagnosis> diagnosisOf(const std::shared_ptr<const Reference> &reference,
                                                      const Mechanism &mechanism, std::stop_token stop)
{
    ReferenceDiagnosis diagnosis{reference, mechanism.parameters(), diagnose(reference->data, mechanism, stop)};
    return stop.stop_requested() ? nullptr : std::make_shared<const ReferenceDiagnosis>(std::move(diagnosis));
}

} // namespace

Session::Session(QObject *parent)
    : QObject(parent)
{
    SolverSettings &solver = m_choices.solver;
    solver.method = Method::ClosedForm; // the cheapest that is exact; Newton-Raphson where somebody chooses it,
    solver.newton.elimination = Elimination::Structured; // with the report's iterates, an order of magnitude sooner
    m_result = compute(requestOf(m_choices), {});
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &Session::diagnoseAside);
    connect(&m_reading, &WorkAside::progressed, this, &Session::readingProgressed);
    for (const WorkAside *work : {&m_computation, &m_reading, &m_diagnosing}) {
        connect(work, &WorkAside::runningChanged, this, [this](bool running) {
            m_running += running ? 1 : -1;
            if (m_running == (running ? 1 : 0)) {
                emit busyChanged(running);
            }
        });
    }
}

Session::~Session()
{
    m_edits.disconnect(); // it says that it empties itself, to whom is there no more
}

Pose Session::pose() const
{
    return poseAt(m_choices.parameters, m_time);
}

void Session::setParameters(const Parameters &parameters)
{
    if (parameters == m_choices.parameters) {
        return;
    }
    if (const std::optional<ParameterFault> fault = findFault(parameters)) {
        const QString symbol = symbolOf(fault->parameter);
        switch (fault->reason) {
        case ParameterFault::Reason::NotFinite: emit problemFound(tr("%1 must be a number.").arg(symbol)); break;
        case ParameterFault::Reason::TooLarge:
            emit problemFound(tr("%1 must not exceed %2.").arg(symbol, QLocale().toString(kLargestParameter)));
            break;
        case ParameterFault::Reason::NotPositive:
            emit problemFound(tr("%1 must be greater than 0.").arg(symbol));
            break;
        case ParameterFault::Reason::TooShort:
            emit problemFound(tr("%1 must be at least %2 mm.").arg(symbol, QLocale().toString(kShortestLink)));
            break;
        }
        emit parametersChanged(m_choices.parameters);
        return;
    }
    edit(with(m_choices, &Choices::parameters, parameters));
}

void Session::setParameter(Parameter parameter, double value)
{
    Parameters parameters = m_choices.parameters;
    valueOf(parameters, parameter) = value;
    setParameters(parameters);
}

void Session::setSampling(const Sampling &sampling)
{
    edit(with(m_choices, &Choices::sampling, sampling));
}

void Session::setSolver(const SolverSettings &solver)
{
    edit(with(m_choices, &Choices::solver, solver));
}

void Session::keep()
{
    std::vector<Parameters> kept = m_choices.kept;
    if (std::ranges::count(kept, m_choices.parameters) > 0) {
        emit problemFound(tr("This motion is already pinned: change the mechanism to see the difference."));
    } else if (kept.size() == kMostKept) {
        emit problemFound(tr("%1 motions are already pinned: remove them before you pin another one.").arg(kMostKept));
    } else {
        kept.push_back(m_choices.parameters);
        m_edits.beginStep();
        edit(with(m_choices, &Choices::kept, kept));
    }
}

void Session::forgetKept()
{
    m_edits.beginStep();
    edit(with(m_choices, &Choices::kept, {}));
}

void Session::edit(const Choices &choices, const EditName &name)
{
    if (choices == m_choices) {
        return;
    }
    const Reading timed = timedBy(Mechanism(choices.parameters), choices.reference);
    if (const QString *sentence = std::get_if<QString>(&timed)) {
        emit problemFound(*sentence);
        emit parametersChanged(m_choices.parameters);
        return;
    }
    const std::shared_ptr<const Reference> &shown = m_result->reference;
    const bool isOtherDrive = choices.reference && choices.reference->data.crank &&
                              choices.reference == m_choices.reference && choices.parameters != m_choices.parameters;
    if (isOtherDrive && shown && isRunOf(shown->data.time, choices.sampling)) { // the run that was the file's still is
        const std::vector<double> &instants = std::get<std::shared_ptr<const Reference>>(timed)->data.time;
        m_edits.edit(m_choices, with(choices, &Choices::sampling, runOf(instants, choices.sampling)), name);
        return;
    }
    m_edits.edit(m_choices, choices, name);
}

void Session::putInForce(const Choices &choices)
{
    const Choices before = std::exchange(m_choices, choices);
    if (m_choices.reference != before.reference) {
        m_diagnosing.drop();
        publishDiagnosis(nullptr);
        emit referenceLoaded(m_choices.reference);
    }
    if (m_choices.parameters != before.parameters) {
        m_diagnosing.drop();
        emit parametersChanged(m_choices.parameters);
    }
    if (m_choices.sampling != before.sampling || m_choices.solver != before.solver) {
        emit settingsChanged(m_choices.sampling, m_choices.solver);
    }
    recompute();
    if (m_choices.sampling != before.sampling) {
        setTime(m_time);
    }
}

void Session::setTime(double seconds)
{
    const double end = m_choices.sampling.start + m_choices.sampling.duration;
    m_time = std::clamp(seconds, std::min(m_choices.sampling.start, end), std::max(m_choices.sampling.start, end));
    emit timeChanged(pose());
}

void Session::recompute()
{
    Request request = requestOf(m_choices);
    const bool isOnShow = m_choices == choicesOf(*m_result);
    if (isOnShow || !takesLong(request)) {
        m_computation.drop(); // what is still under way is out of date
        publish(isOnShow ? m_result : compute(request, {}));
        return;
    }
    m_computation.start(
        [request = std::move(request)](const std::stop_token &stop, const auto &) { return compute(request, stop); },
        [this](const std::shared_ptr<const Result> &result) { publish(result); },
        [this](const QString &sentence) { emit problemFound(sentence); });
}

void Session::publish(std::shared_ptr<const Result> result)
{
    const bool newReference = result->chosenReference() != m_result->chosenReference();
    m_result = std::move(result);
    emit resultChanged(m_result);
    emit timeChanged(pose());
    if (m_result->reference) {
        m_rest.start(newReference ? std::chrono::milliseconds(0) : kRest);
    }
}

void Session::diagnoseAside()
{
    const std::shared_ptr<const Reference> &reference = m_choices.reference;
    const bool upToDate =
        m_result->chosenReference() == reference && m_result->mechanism.parameters() == m_choices.parameters;
    const bool known = m_diagnosis && m_diagnosis->parameters == m_choices.parameters;
    if (!reference || !upToDate || known) {
        return; // nothing to say, or not yet: the next result asks again
    }
    m_diagnosing.start(
        [reference, mechanism = m_result->mechanism](const std::stop_token &stop, const auto &) {
            return diagnosisOf(reference, mechanism, stop);
        },
        [this](const std::shared_ptr<const ReferenceDiagnosis> &diagnosis) { publishDiagnosis(diagnosis); },
        [this](const QString &sentence) {
            endSearch();
            emit problemFound(sentence);
        });
}

/// Without an answer, where there is none.
void Session::endSearch()
{
    m_rest.stop();
    const bool isKnown = m_diagnosis && m_diagnosis->parameters == m_choices.parameters;
    if (m_choices.reference && !isKnown) {
        auto stopped =
            std::make_shared<ReferenceDiagnosis>(ReferenceDiagnosis{m_choices.reference, m_choices.parameters, {}});
        stopped->found.identification.stopped = true;
        publishDiagnosis(std::move(stopped));
    }
}

void Session::publishDiagnosis(std::shared_ptr<const ReferenceDiagnosis> diagnosis)
{
    if (m_diagnosis != diagnosis) {
        m_diagnosis = std::move(diagnosis);
        emit diagnosisChanged(m_diagnosis);
    }
}

void Session::readAside(const Read &read, const std::function<void(const Reading &)> &done)
{
    const auto work = [read](const std::stop_token &stop, const WorkAside::Progress &progress) {
        ReadOptions options;
        options.progress = [&progress](std::size_t bytes, std::size_t all) {
            progress(all > 0 ? static_cast<double>(bytes) / static_cast<double>(all) : 0.0);
        };
        return read(stop, options);
    };
    m_reading.start(work, done, done);
}

void Session::loadReference(const QString &path)
{
    loadReference(QStringList(path));
}

void Session::loadReference(const QStringList &paths)
{
    loadReference(paths, nullptr);
}

void Session::readColumnsAnew(const QStringList &paths)
{
    const bool isOnShow = m_choices.reference && m_choices.reference->paths == paths;
    loadReference(paths, isOnShow ? m_choices.reference : nullptr);
}

void Session::loadReference(const QStringList &paths, const std::shared_ptr<const Reference> &before)
{
    const auto read = [paths, before](std::stop_token stop, const ReadOptions &options) {
        const ReferenceSource source{paths, rememberedChoices(layoutOf(paths), paths), {}};
        Reading outcome = readReference(source, stop, options);
        if (auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome); reference && before) {
            *reference = withConventionsOf(*before, *reference);
        }
        return outcome;
    };
    readAside(read, [this, paths](const Reading &outcome) {
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            emit referenceRefused(paths, *sentence);
        } else {
            follow(std::get<std::shared_ptr<const Reference>>(outcome));
        }
    });
}

void Session::readAbscissaAs(ColumnRole role)
{
    const std::shared_ptr<const Reference> before = m_choices.reference;
    if (!before) {
        return;
    }
    const ReferenceSource source{before->paths, withAbscissaAs(role, *before), {}};
    const auto read = [source, before](std::stop_token stop, const ReadOptions &options) {
        Reading outcome = readReference(source, stop, options);
        if (auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome)) {
            *reference = withConventionsOf(*before, *reference);
        }
        return outcome;
    };
    readAside(read, [this, source](const Reading &outcome) {
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            emit referenceRefused(source.paths, *sentence);
            return;
        }
        const auto &reference = std::get<std::shared_ptr<const Reference>>(outcome);
        rememberChoices(reference->data.layout, source.paths, source.columns);
        follow(reference);
    });
}

void Session::open(const Choices &choices, double seconds, const std::optional<ReferenceSource> &source)
{
    if (!source) {
        m_reading.drop();
        startWith(choices, seconds);
        emit opened(QString());
        return;
    }
    readAside([source = *source](std::stop_token stop,
                                 const ReadOptions &options) { return readReference(source, stop, options); },
              [this, choices, seconds, before = m_choices](const Reading &read) {
                  const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&read);
                  const Reading outcome = reference ? timedBy(Mechanism(choices.parameters), *reference) : read;
                  const QString *problem = std::get_if<QString>(&outcome);
                  Choices complete = choices;
                  complete.reference = problem ? nullptr : *reference;
                  const auto start = [this, complete, seconds, sentence = problem ? *problem : QString()] {
                      startWith(complete, seconds);
                      emit opened(sentence);
                  };
                  if (m_choices == before) {
                      start();
                  } else {
                      emit editedMeanwhile(start);
                  }
              });
}

void Session::startWith(const Choices &choices, double seconds)
{
    m_edits.clear();
    m_edits.beginStep();
    putInForce(choices);
    setTime(seconds);
}

void Session::setReference(const std::shared_ptr<const Reference> &reference)
{
    m_reading.drop();
    m_edits.beginStep(); // one file opened after the other: two steps
    edit(with(m_choices, &Choices::reference, reference));
}

void Session::follow(const std::shared_ptr<const Reference> &reference)
{
    const Mechanism model(m_choices.parameters);
    const Reading timed = timedBy(model, reference);
    const Reading timedBefore = timedBy(model, m_choices.reference);
    if (const QString *sentence = std::get_if<QString>(&timed)) {
        emit referenceRefused(reference->paths, *sentence);
        return;
    }
    const std::vector<double> &instants = std::get<std::shared_ptr<const Reference>>(timed)->data.time;
    Choices choices = with(m_choices, &Choices::reference, reference);
    const std::shared_ptr<const Reference> &before = std::get<std::shared_ptr<const Reference>>(timedBefore);
    const bool hasFollowed = before && before->paths == reference->paths &&
                             m_choices.sampling == runOf(before->data.time, m_choices.sampling);
    if (hasFollowed || !holds(m_choices.sampling, instants)) {
        choices.sampling = runOf(instants, m_choices.sampling);
    }
    if (choices.sampling != m_choices.sampling) {
        emit runFollows(reference, choices.sampling);
    }
    m_reading.drop();
    m_edits.beginStep();
    edit(choices);
}

void Session::takeOver()
{
    if (m_diagnosis && m_diagnosis->found.identification.stands()) {
        edit(with(m_choices, &Choices::parameters, m_diagnosis->found.rounded),
             [] { return tr("use of the file's mechanism"); });
    }
}

void Session::apply(const Convention &convention)
{
    if (convention.kind == Convention::Kind::Branch) {
        setParameters(with(parameters(), &Parameters::branch, oppositeBranch(parameters().branch)));
    } else if (m_choices.reference) {
        follow(applied(convention, m_choices.reference));
    }
}

void Session::readAsPrinted()
{
    if (m_choices.reference && m_choices.reference->asPrinted) {
        follow(m_choices.reference->asPrinted);
    }
}

bool Session::cancel()
{
    m_computation.drop();
    m_reading.drop();
    m_diagnosing.drop();
    const Choices shown = choicesOf(*m_result);
    if (m_choices == shown) {
        endSearch();
    } else if (m_edits.count() > 0) {
        m_edits.goTo(shown, m_choices);
    } else { // they came with a scene, and no edit is to turn it into the one before
        edit(soonShown(m_choices), [] { return tr("showing the scene in less"); });
        emit problemFound(tr("Cancelled: what the scene asks for takes longer, and is left out. Undo computes it."));
        return false;
    }
    return true;
}

} // namespace slidercrank
