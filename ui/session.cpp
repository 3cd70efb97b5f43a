// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session.h"

#include "core/closed_form.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QLocale>
#include <QPointer>
#include <QThreadPool>

#include <algorithm>
#include <variant>

namespace slidercrank
{

namespace
{

/// What a Result is computed from: a value that can travel to another thread.
struct Request {
    Mechanism mechanism;
    Sampling sampling;
    SolverSettings solver;
    std::shared_ptr<const Reference> reference;
};

/// Null when stopped.
std::shared_ptr<const Result> compute(const Request &request, std::stop_token stop)
{
    QElapsedTimer clock;
    clock.start();
    auto result = std::make_shared<Result>();
    result->mechanism = request.mechanism;
    result->sampling = request.sampling;
    result->solver = request.solver;
    result->reference = request.reference;
    result->limits = motionLimits(request.mechanism);
    const std::vector<double> instants = request.sampling.instants();
    result->trajectory = sample(request.mechanism, instants, plottedChannels(), request.solver, stop);
    if (request.reference && result->trajectory.complete) {
        ChannelSet channels;
        for (const ReferenceSeries &series : request.reference->data.series) {
            channels.set(indexOf(series.channel));
        }
        result->atReference = sample(request.mechanism, request.reference->data.time, channels, request.solver, stop);
        if (result->atReference.complete) {
            result->comparison = compare(request.mechanism, result->atReference, request.reference->data);
        }
    }
    if (!result->trajectory.complete || !result->atReference.complete) {
        return nullptr;
    }
    result->computeSeconds = static_cast<double>(clock.nsecsElapsed()) * 1e-9;
    return result;
}

/// A request that would keep the window waiting for more than a moment goes to another thread. Costs per instant are
/// those of a slow machine.
bool takesLong(const Request &request)
{
    constexpr double kMoment = 0.05; // s: below what a person takes for a stop
    constexpr double kDenseSeconds = 20e-6;
    constexpr double kStructuredSeconds = 1e-6;
    constexpr double kClosedFormSeconds = 0.2e-6;
    const double newton = request.solver.newton.elimination == Elimination::Dense ? kDenseSeconds : kStructuredSeconds;
    const double each = request.solver.method == Method::Newton ? newton : kClosedFormSeconds;
    const std::size_t atReference = request.reference ? request.reference->data.time.size() : 0;
    return each * static_cast<double>(static_cast<std::size_t>(request.sampling.steps) + 1 + atReference) > kMoment;
}

QString symbolOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return QStringLiteral("a");
    case Parameter::B: return QStringLiteral("b");
    case Parameter::C: return QStringLiteral("c");
    case Parameter::Omega2: return QStringLiteral("ω₂");
    case Parameter::Theta20: return QStringLiteral("θ₂₀");
    }
    return {};
}

} // namespace

Session::Session(QObject *parent)
    : QObject(parent)
{
    qRegisterMetaType<Parameters>();
    qRegisterMetaType<Pose>();
    m_solver.method = Method::ClosedForm; // the cheapest that is exact; Newton-Raphson where somebody chooses it,
    m_solver.newton.elimination = Elimination::Structured; // with the report's iterates, an order of magnitude sooner
    m_result = compute({Mechanism(m_parameters), m_sampling, m_solver, nullptr}, {});
}

Session::~Session()
{
    m_computation.request_stop();
    m_reading.request_stop();
}

Pose Session::pose() const
{
    const Motion motion = ClosedForm(Mechanism(m_parameters)).motionAt(m_time);
    Pose pose;
    pose.time = m_time;
    pose.theta2 = motion.theta2;
    pose.theta3 = motion.theta3;
    pose.pinX = m_parameters.a * motion.crank.cos;
    pose.pinY = m_parameters.a * motion.crank.sin;
    pose.sliderX = motion.R4x;
    pose.status = motion.status;
    return pose;
}

void Session::setParameters(const Parameters &parameters)
{
    if (parameters == m_parameters) {
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
        }
        emit parametersChanged(m_parameters);
        return;
    }
    m_parameters = parameters;
    emit parametersChanged(m_parameters);
    recompute();
}

void Session::setSampling(const Sampling &sampling)
{
    if (sampling == m_sampling) {
        return;
    }
    m_sampling = sampling;
    emit settingsChanged(m_sampling, m_solver);
    recompute();
    setTime(m_time);
}

void Session::setSolver(const SolverSettings &solver)
{
    if (solver == m_solver) {
        return;
    }
    m_solver = solver;
    emit settingsChanged(m_sampling, m_solver);
    recompute();
}

void Session::setTime(double seconds)
{
    const double end = m_sampling.start + m_sampling.duration;
    m_time = std::clamp(seconds, std::min(m_sampling.start, end), std::max(m_sampling.start, end));
    emit timeChanged(pose());
}

template <typename Work, typename Done>
void Session::runAside(Work work, Done done)
{
    if (m_pending++ == 0) {
        emit busyChanged(true);
    }
    QThreadPool::globalInstance()->start([session = QPointer<Session>(this), work = std::move(work), done]() {
        auto outcome = work();
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [session, done, outcome = std::move(outcome)] {
                if (!session) {
                    return;
                }
                done(outcome);
                if (--session->m_pending == 0) {
                    emit session->busyChanged(false);
                }
            },
            Qt::QueuedConnection);
    });
}

void Session::recompute()
{
    m_computation.request_stop(); // whatever is still under way is out of date
    Request request{Mechanism(m_parameters), m_sampling, m_solver, m_reference};
    if (!takesLong(request)) {
        publish(compute(request, {}));
        return;
    }
    m_computation = std::stop_source();
    runAside([request = std::move(request), stop = m_computation.get_token()] { return compute(request, stop); },
             [this](const std::shared_ptr<const Result> &result) {
                 if (result) {
                     publish(result);
                 }
             });
}

void Session::publish(std::shared_ptr<const Result> result)
{
    m_result = std::move(result);
    emit resultChanged(m_result);
    emit timeChanged(pose());
}

void Session::loadReference(const QString &path)
{
    m_reading.request_stop();
    m_reading = std::stop_source();
    using Outcome = std::variant<std::shared_ptr<const Reference>, QString>;
    const auto read = [path, stop = m_reading.get_token()]() -> Outcome { return readReference(path, stop); };
    const auto done = [this, stop = m_reading.get_token()](const Outcome &outcome) {
        if (stop.stop_requested()) {
            return; // another file was asked for, or none
        }
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            emit problemFound(*sentence);
            return;
        }
        setReference(std::get<std::shared_ptr<const Reference>>(outcome));
    };
    runAside(read, done);
}

void Session::setReference(const std::shared_ptr<const Reference> &reference)
{
    m_reading.request_stop();
    if (reference == m_reference) {
        return;
    }
    m_reference = reference;
    emit referenceLoaded(m_reference);
    recompute();
}

void Session::cancel()
{
    m_computation.request_stop();
    m_reading.request_stop();
}

} // namespace slidercrank
