// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ghost.h"

#include "ui/document/session.h"
#include "ui/mechanism/mechanism_view.h"

#include <algorithm>

namespace slidercrank
{

Ghost::Ghost(Session *session, MechanismView *view, bool wanted)
    : QObject(view)
    , m_session(session)
    , m_view(view)
    , m_isWanted(wanted)
{
    connect(session, &Session::resultChanged, this, &Ghost::find);
    connect(session, &Session::diagnosisChanged, this, &Ghost::find);
    connect(session, &Session::timeChanged, this, &Ghost::show);
    find();
}

void Ghost::setWanted(bool wanted)
{
    m_isWanted = wanted;
    find();
}

/// Its lengths, which the file does not tell, are those of the mechanism found for it.
void Ghost::find()
{
    const Result &result = *m_session->result();
    const bool differs = std::ranges::count(result.comparison, Verdict::Differs, &ChannelComparison::verdict) > 0;
    if (differs && m_isWanted) {
        const std::shared_ptr<const ReferenceDiagnosis> &diagnosis = m_session->diagnosis();
        const bool found = diagnosis && diagnosis->found.identification.stands();
        const Mechanism lengths(found ? diagnosis->found.identification.parameters : m_session->parameters());
        m_motion = [lengths, reference = result.reference](double time) {
            return referencePoseAt(reference->data, lengths, time);
        };
        m_view->setGhostBounds(motionBounds(lengths, motionLimits(lengths)));
    } else if (result.difference && m_isWanted && result.kept.back() != result.mechanism.parameters()) {
        const Mechanism kept(result.kept.back());
        m_motion = [kept](double time) { return referencePoseAt(kept, time); };
        m_view->setGhostBounds(motionBounds(kept, motionLimits(kept)));
    } else {
        m_motion = nullptr;
        m_view->setGhostBounds(QRectF());
    }
    show();
}

void Ghost::show()
{
    m_view->setGhost(m_motion ? m_motion(m_session->time()) : ReferencePose());
}

} // namespace slidercrank
