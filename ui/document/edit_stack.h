// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Undo and redo: one command per edit, which holds all choices before and after the edit.

#include "ui/document/result.h"

#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <optional>

namespace slidercrank
{

/// The undo stack of a session. During a drag, edits are merged into one step. Otherwise edits of the same settings are
/// merged if they follow each other within a second, as when a key is held down.
class EditStack : public QUndoStack
{
    Q_OBJECT

public:
    /// The current time (s) before and after an edit that changes it.
    struct TimeChange {
        double before = 0.0;
        double after = 0.0;
    };

    using Apply = std::function<void(const Choices &, std::optional<double> time)>;

    /// `apply` makes the choices that it receives the current ones, and then goes to the time (s) if there is one.
    EditStack(const Apply &apply, QObject *parent);

    /// Makes `after` the current choices, as an edit that can be undone. Without a text, the edit is named by what
    /// differs, as "change of b". Undoing the edit also undoes its change of the time, if it has one.
    void edit(const Choices &before, const Choices &after, const QString &text = {},
              const std::optional<TimeChange> &time = {});

    /// Begins or ends a drag, whose edits are merged into one step.
    void setDragging(bool isDragging);

    /// Replaces the steps by those of `other`, the stack of a session that has the same choices now. The steps are
    /// named in the current language.
    void takeOver(const EditStack &other);

    /// Returns whether any edit was done or undone since the stack was clean, except opening and closing reference
    /// files.
    bool isModified() const;

private:
    Apply m_apply;
    int m_lastChanges = 0; ///< bits of the settings that the last edit changed; 0 if the next edit starts a new step
    int m_step = 0;        ///< number of the current step; edits with the same number are undone together
    QTimer m_mergeTimer;   ///< runs for kMergeInterval after each edit, while the next one can be merged with it
    bool m_isDragging = false;
};

} // namespace slidercrank
