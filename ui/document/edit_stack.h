// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Undo and redo: a command for each edit, with all choices before and after it.

#include "ui/document/result.h"

#include <QTimer>
#include <QUndoStack>

#include <functional>

namespace slidercrank
{

/// What an edit does.
struct EditName {
    QString text;     ///< "change of b"
    int identity = 0; ///< of what is changed, if edits of it may become one step; otherwise 0

    /// The opening or closing of a reference file, which counts as no change of the scene.
    bool isOpening = false;
};

/// Edits that have an identity become one step within a drag. Elsewhere those of the same identity do if they follow each
/// other within a second, as when a key is held down.
class EditStack : public QUndoStack
{
    Q_OBJECT

public:
    using Apply = std::function<void(const Choices &)>;

    EditStack(const Apply &apply, QObject *parent);

    void edit(const Choices &before, const Choices &after, const EditName &name);

    void setDragging(bool isDragging);

    /// Whether there are edits since the stack was clean, other than the opening of files.
    bool isModified() const;

private:
    Apply m_apply;
    int m_identity = 0; ///< of the last edit, to which the next one may belong
    int m_step = 0;     ///< edits with the same number are undone together
    QTimer m_sameStep;  ///< runs for a second after each edit
    bool m_isDragging = false;
    bool m_dragHasEdit = false;
};

} // namespace slidercrank
