// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage as the reference file has it, or without a file the one pinned last, drawn behind the mechanism where the
// two differ.

#include "core/comparison/reference_pose.h"

#include <QObject>

#include <functional>

namespace slidercrank
{

class MechanismView;
class Session;

class Ghost : public QObject
{
    Q_OBJECT

public:
    /// Shows it in `view` and follows the session.
    Ghost(Session *session, MechanismView *view);

    bool isWanted() const { return m_isWanted; }

    /// Its pose at any time (s); empty: it is not shown.
    const std::function<ReferencePose(double)> &motion() const { return m_motion; }

public slots:
    void setWanted(bool wanted);

private:
    void update();
    void showPose();

    Session *m_session;
    MechanismView *m_view;
    std::function<ReferencePose(double)> m_motion;
    bool m_isWanted = true;
};

} // namespace slidercrank
