// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_stack.h"

#include "ui/words/finding_text.h"

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
        const bool sameFile = before.reference && before.reference->path == after.reference->path;
        return (sameFile ? EditCommandText::tr("other reading of %1") : EditCommandText::tr("opening of %1"))
            .arg(after.reference->name);
    }
    if (before.sampling != after.sampling) {
        return EditCommandText::tr("change of the sampling");
    }
    if (before.solver != after.solver) {
        return EditCommandText::tr("change of the method");
    }
    return changeName(before.parameters, after.parameters);
}

/// One edit: all that was chosen before it and after it. Edits in a row become one where `step` is the same.
class EditCommand : public QUndoCommand
{
public:
    EditCommand(const Choices &before, const Choices &after, const QString &name, int step, const EditStack::Show &show)
        : QUndoCommand(name)
        , m_before(before)
        , m_after(after)
        , m_step(step)
        , m_show(show)
    {
    }

    void retranslate() { setText(changeName(m_before, m_after)); }

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
    int m_step;
    EditStack::Show m_show;
};

} // namespace

EditStack::EditStack(const Show &show, QObject *parent)
    : QUndoStack(parent)
    , m_show(show)
    , m_sameStep(parent)
{
    setUndoLimit(kMostUndone);
    m_sameStep.setSingleShot(true);
}

void EditStack::edit(const Choices &before, const Choices &after, const QString &text)
{
    const QString name = text.isEmpty() ? changeName(before, after) : text;
    const bool continues = name == m_last && (m_dragging || m_sameStep.isActive());
    if (!continues) {
        ++m_step;
    }
    m_last = name;
    m_sameStep.start(kSameStepWithin);
    push(new EditCommand(before, after, name, m_step, m_show));
}

void EditStack::takeBack(const Choices &before, const Choices &after)
{
    push(new EditCommand(before, after, changeName(before, after), m_step, m_show));
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
        const_cast<EditCommand *>(static_cast<const EditCommand *>(command(i)))->retranslate();
    }
    beginStep();
}

} // namespace slidercrank
