// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ghost.h"

#include "ui/document/session.h"
#include "ui/mechanism/mechanism_view.h"

#include <algorithm>

namespace slidercrank
{

GhostMotion findGhost(const Result &result, const Identification *found)
{
    const auto boundsOf = [](const Mechanism &mechanism) { return motionBounds(mechanism, motionLimits(mechanism)); };
    if (std::ranges::count(result.comparison, Verdict::Differs, &ChannelComparison::verdict) > 0) {
        const bool isFound = found && found->hasMechanism();
        const Mechanism lengths = isFound ? Mechanism(found->parameters) : result.mechanism;
        return {boundsOf(lengths), [lengths, reference = result.reference](double time) {
                    return referencePoseAt(reference->data, lengths, time);
                }};
    }
    if (result.difference && result.pinned.back() != result.mechanism.parameters()) {
        const Mechanism pinned(result.pinned.back());
        return {boundsOf(pinned), [pinned](double time) { return referencePoseAt(pinned, time); }};
    }
    return {};
}

Ghost::Ghost(Session *session, MechanismView *view)
    : QObject(view)
    , m_session(session)
    , m_view(view)
{
    connect(session, &Session::resultChanged, this, &Ghost::update);
    connect(session, &Session::identificationChanged, this, &Ghost::update);
    connect(session, &Session::timeChanged, this, &Ghost::showPose);
    update();
}

void Ghost::setShown(bool shown)
{
    m_isShown = shown;
    update();
}

void Ghost::update()
{
    const auto &identification = m_session->identification();
    const GhostMotion ghost =
        m_isShown ? findGhost(*m_session->result(), identification ? &identification->found : nullptr) : GhostMotion();
    m_motion = ghost.pose;
    m_view->setGhostBounds(ghost.bounds);
    showPose();
}

void Ghost::showPose()
{
    m_view->setGhost(m_motion ? m_motion(m_session->time()) : ReferencePose());
}

} // namespace slidercrank

#include "moc_ghost.cpp"
