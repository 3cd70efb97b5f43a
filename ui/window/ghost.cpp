// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ghost.h"

#include "ui/document/session.h"
#include "ui/mechanism/mechanism_view.h"

#include <algorithm>

namespace slidercrank
{

Ghost::Ghost(Session *session, MechanismView *view)
    : QObject(view)
    , m_session(session)
    , m_view(view)
{
    connect(session, &Session::resultChanged, this, &Ghost::update);
    connect(session, &Session::diagnosisChanged, this, &Ghost::update);
    connect(session, &Session::timeChanged, this, &Ghost::showPose);
    update();
}

void Ghost::setWanted(bool wanted)
{
    m_isWanted = wanted;
    update();
}

void Ghost::update()
{
    const Result &result = *m_session->result();
    const auto &diagnosis = m_session->diagnosis();
    std::optional<Mechanism> lengths; // of the mechanism that moves as in the file, or of the pinned one
    if (m_isWanted && std::ranges::count(result.comparison, Verdict::Differs, &ChannelComparison::verdict) > 0) {
        const bool isFound = diagnosis && diagnosis->found.identification.hasMechanism();
        lengths.emplace(isFound ? diagnosis->found.identification.parameters : m_session->parameters());
        m_motion = [lengths = *lengths, reference = result.reference](double time) {
            return referencePoseAt(reference->data, lengths, time);
        };
    } else if (m_isWanted && result.difference && result.pinned.back() != result.mechanism.parameters()) {
        lengths.emplace(result.pinned.back());
        m_motion = [pinned = *lengths](double time) { return referencePoseAt(pinned, time); };
    } else {
        m_motion = nullptr;
    }
    m_view->setGhostBounds(lengths ? motionBounds(*lengths, motionLimits(*lengths)) : QRectF());
    showPose();
}

void Ghost::showPose()
{
    m_view->setGhost(m_motion ? m_motion(m_session->time()) : ReferencePose());
}

} // namespace slidercrank
