// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_stack.h"

#include <algorithm>
#include <chrono>

namespace slidercrank
{

namespace
{

constexpr int kUndoLimit = 200;
constexpr std::chrono::seconds kSameStepWithin{1}; // longer than the delay before a held key repeats

/// Restores the choices before or after an edit. Qt merges successive commands with the same id().
class EditCommand : public QUndoCommand
{
public:
    EditCommand(const Choices &before, const Choices &after, const EditName &name, int step,
                const EditStack::Apply &apply)
        : m_before(before)
        , m_after(after)
        , m_isOpening(name.isOpening)
        , m_step(step)
        , m_apply(apply)
    {
        setText(name.text);
    }

    bool isOpening() const { return m_isOpening; }
    void undo() override { m_apply(m_before); }
    void redo() override { m_apply(m_after); }
    int id() const override { return m_step; }

    bool mergeWith(const QUndoCommand *next) override
    {
        m_after = static_cast<const EditCommand *>(next)->m_after;
        setObsolete(m_after == m_before);
        return true;
    }

private:
    Choices m_before;
    Choices m_after;
    bool m_isOpening;
    int m_step;
    EditStack::Apply m_apply;
};

} // namespace

EditStack::EditStack(const Apply &apply, QObject *parent)
    : QUndoStack(parent)
    , m_apply(apply)
    , m_sameStep(parent)
{
    setUndoLimit(kUndoLimit);
    m_sameStep.setSingleShot(true);
}

void EditStack::edit(const Choices &before, const Choices &after, const EditName &name)
{
    const bool isRepeated = m_sameStep.isActive() && name.identity == m_identity;
    const bool isMergeable = name.identity != 0 && m_identity != 0;
    if (!isMergeable || !(m_isDragging || isRepeated)) {
        ++m_step;
    }
    m_identity = name.identity;
    m_sameStep.start(kSameStepWithin);
    push(new EditCommand(before, after, name, m_step, m_apply));
}

void EditStack::setDragging(bool isDragging)
{
    m_isDragging = isDragging;
    m_identity = 0; // the next edit is a new step
}

bool EditStack::isModified() const
{
    const auto [first, last] = std::minmax({cleanIndex(), index()});
    for (int i = first; i < last; ++i) {
        if (i < 0 || !static_cast<const EditCommand *>(command(i))->isOpening()) {
            return true;
        }
    }
    return first < 0;
}

} // namespace slidercrank
