// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_stack.h"

#include "ui/text/finding_text.h"

#include <QCoreApplication>

#include <chrono>

namespace slidercrank
{

namespace
{

constexpr int kMostUndone = 200;                   // steps
constexpr std::chrono::seconds kSameStepWithin{1}; // longer than the wait before a key held down repeats itself

struct EditCommandText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::EditCommandText)
};

QString changeName(const Parameters &before, const Parameters &after)
{
    QStringList changed;
    for (const Parameter parameter : kParameters) {
        if (valueOf(before, parameter) != valueOf(after, parameter)) {
            changed << symbolOf(parameter);
        }
    }
    if (before.branch != after.branch) {
        changed << EditCommandText::tr("the assembly");
    }
    return changed.size() == 1 ? EditCommandText::tr("change of %1").arg(changed.first())
                               : EditCommandText::tr("change of the mechanism");
}

/// What was changed from one to the other: "change of b".
QString changeName(const Choices &before, const Choices &after)
{
    if (before.reference != after.reference) {
        if (!after.reference) {
            return EditCommandText::tr("closing of %1").arg(before.reference->name);
        }
        const bool sameFile = before.reference && before.reference->paths == after.reference->paths;
        return (sameFile ? EditCommandText::tr("other reading of %1") : EditCommandText::tr("opening of %1"))
            .arg(after.reference->name);
    }
    if (before.kept != after.kept) {
        return after.kept.empty() ? EditCommandText::tr("removal of the pinned motions")
                                  : EditCommandText::tr("pinning of the motion");
    }
    if (before.parameters != after.parameters) { // whatever follows from it
        return changeName(before.parameters, after.parameters);
    }
    return before.sampling != after.sampling ? EditCommandText::tr("change of the time range")
                                             : EditCommandText::tr("change of the method");
}

/// One edit: all that was chosen before it and after it. Edits in a row become one where `step` is the same.
class EditCommand : public QUndoCommand
{
public:
    EditCommand(const Choices &before, const Choices &after, const EditName &name, int step,
                const EditStack::Show &show)
        : QUndoCommand(name())
        , m_before(before)
        , m_after(after)
        , m_name(name)
        , m_step(step)
        , m_show(show)
    {
    }

    const Choices &before() const { return m_before; }
    const Choices &after() const { return m_after; }

    void retranslate() { setText(m_name()); }

    void undo() override { m_show(m_before); }
    void redo() override { m_show(m_after); }
    int id() const override { return m_step; }

    bool mergeWith(const QUndoCommand *next) override
    {
        m_after = static_cast<const EditCommand *>(next)->m_after; // of the same id: the stack asks no other
        setObsolete(m_after == m_before);
        return true;
    }

private:
    Choices m_before;
    Choices m_after;
    EditName m_name;
    int m_step;
    EditStack::Show m_show;
};

const EditCommand &commandOf(const QUndoStack &stack, int index)
{
    return *static_cast<const EditCommand *>(stack.command(index));
}

/// What is chosen after so many steps; there is at least one.
const Choices &choicesAfter(const QUndoStack &stack, int steps)
{
    return steps == 0 ? commandOf(stack, 0).before() : commandOf(stack, steps - 1).after();
}

} // namespace

EditStack::EditStack(const Show &show, QObject *parent)
    : QUndoStack(parent)
    , m_show(show)
    , m_sameStep(parent)
{
    setUndoLimit(kMostUndone);
    m_sameStep.setSingleShot(true);
}

void EditStack::edit(const Choices &before, const Choices &after, const EditName &name)
{
    const EditName difference = [before, after] { return changeName(before, after); };
    const EditName &used = name ? name : difference;
    const QString text = used();
    const bool continues = text == m_last && (m_dragging || m_sameStep.isActive());
    if (!continues) {
        ++m_step;
    }
    m_last = text;
    m_sameStep.start(kSameStepWithin);
    push(new EditCommand(before, after, used, m_step, m_show));
}

void EditStack::goTo(const Choices &after, const Choices &before)
{
    for (int away = 1; away <= count(); ++away) {
        for (const int steps : {index() - away, index() + away}) {
            if (steps >= 0 && steps <= count() && choicesAfter(*this, steps) == after) {
                setIndex(steps);
                beginStep();
                return;
            }
        }
    }
    push(new EditCommand(
        before, after, [before, after] { return changeName(before, after); }, m_step, m_show));
    beginStep();
}

void EditStack::beginDrag()
{
    beginStep();
    m_dragging = true;
}

void EditStack::endDrag()
{
    beginStep();
    m_dragging = false;
}

void EditStack::beginStep()
{
    m_last.clear();
}

void EditStack::retranslate()
{
    for (int i = 0; i < count(); ++i) { // the stack gives its commands for reading; these are ours
        const_cast<EditCommand &>(commandOf(*this, i)).retranslate();
    }
    beginStep();
}

} // namespace slidercrank
