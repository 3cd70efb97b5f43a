// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the linkage of the reference file behind the mechanism if the two differ. Without a file it draws the motion
// that was pinned last.

#include "core/comparison/reference_pose.h"

#include <QObject>
#include <QRectF>

#include <functional>

namespace slidercrank
{

class MechanismView;
class Session;
struct Identification;
struct Result;

/// The linkage that is drawn behind the mechanism.
struct GhostMotion {
    QRectF bounds;                                  ///< of the whole motion, mm
    std::function<ReferencePose(double)> pose = {}; ///< at a time (s); empty if nothing is drawn
};

/// Returns the linkage of the reference file if the file differs from the model. Without a file, returns the motion
/// that was pinned last. The lengths are those of the mechanism found, or of the model if `found` is null or has no
/// mechanism. The window and the command line draw the same linkage.
GhostMotion findGhost(const Result &result, const Identification *found);

/// Draws the linkage that findGhost() returns behind the mechanism.
class Ghost : public QObject
{
    Q_OBJECT

public:
    /// Draws the ghost in `view`, and updates it when the session changes.
    Ghost(Session *session, MechanismView *view);

    /// Returns a function that computes the pose at a time (s); empty if nothing is drawn.
    const std::function<ReferencePose(double)> &motion() const { return m_motion; }

public slots:
    void setShown(bool shown);

private:
    void update();
    void showPose();

    Session *m_session;
    MechanismView *m_view;
    std::function<ReferencePose(double)> m_motion;
    bool m_isShown = true;
};

} // namespace slidercrank
