// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Undo and redo: one command for every edit, which knows all that was chosen before it and after it.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"

#include <QString>
#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <vector>

namespace slidercrank
{

/// Everything that an edit may change.
struct Choices {
    Parameters parameters;
    Sampling sampling;
    SolverSettings solver;
    std::shared_ptr<const Reference> reference; ///< may be null
    std::vector<Parameters> kept = {};          ///< motions to stay under what follows, the first kept first

    friend bool operator==(const Choices &, const Choices &) = default;
};

/// What was done, as it reads behind "Undo", in the language now in use.
using EditName = std::function<QString()>;

/// Of the same kind of edit, repeated at once (a key held down) or within a drag, all are undone in one step.
class EditStack : public QUndoStack
{
public:
    using Show = std::function<void(const Choices &)>;

    /// `show` puts choices into force.
    EditStack(const Show &show, QObject *parent);

    /// Without a name the difference is it.
    void edit(const Choices &before, const Choices &after, const EditName &name = {});

    /// From `before` to what was chosen some steps ago, or undone some steps ago; where it was in the middle of a step
    /// (of a drag), what follows is taken out of the last one.
    void goTo(const Choices &after, const Choices &before);

    void beginDrag();
    void endDrag();
    void beginStep(); ///< with the next edit, whatever it is

    /// Says in the language now in use what was done.
    void retranslate();

private:
    Show m_show;
    int m_step = 0;    ///< edits of the same number are undone together
    QString m_last;    ///< empty: the next one begins a new step
    QTimer m_sameStep; ///< runs for a while after each edit
    bool m_dragging = false;
};

} // namespace slidercrank
