// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Undo and redo: one command for every edit, which knows all that was chosen before it and after it.

#include "core/mechanism/mechanism.h"
#include "core/run/trajectory.h"
#include "ui/document/reference_file.h"

#include <QUndoCommand>

#include <functional>
#include <memory>

namespace slidercrank
{

/// Everything that an edit may change.
struct Choices {
    Parameters parameters;
    Sampling sampling;
    SolverSettings solver;
    std::shared_ptr<const Reference> reference; ///< may be null

    friend bool operator==(const Choices &, const Choices &) = default;
};

/// What was changed from one to the other, as it reads behind "Undo": "change of b".
QString changeName(const Choices &before, const Choices &after);

class EditCommand : public QUndoCommand
{
public:
    using Show = std::function<void(const Choices &)>;

    /// `text`: what was done, as it reads behind "Undo". Edits in a row become one where `step` is the same. `show`
    /// puts choices into force.
    EditCommand(const Choices &before, const Choices &after, const QString &text, int step, const Show &show);

    /// Says in the language now in use what was done.
    void retranslate();

    void undo() override;
    void redo() override;
    int id() const override;
    bool mergeWith(const QUndoCommand *next) override;

private:
    Choices m_before;
    Choices m_after;
    int m_step;
    Show m_show;
};

} // namespace slidercrank
