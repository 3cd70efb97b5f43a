// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage as the reference file has it, or without a file the one kept last, drawn behind the mechanism where the
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
    /// In that view; follows the session.
    Ghost(Session *session, MechanismView *view, bool wanted);

    bool isWanted() const { return m_isWanted; }

    /// Where it is at any instant (s); empty: not shown.
    const std::function<ReferencePose(double)> &motion() const { return m_motion; }

public slots:
    void setWanted(bool wanted);

private:
    void find();
    void show();

    Session *m_session;
    MechanismView *m_view;
    std::function<ReferencePose(double)> m_motion;
    bool m_isWanted;
};

} // namespace slidercrank
