// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_command.h"

#include "ui/words/finding_text.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct EditCommandText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::EditCommandText)
};

QString changeName(const Parameters &before, const Parameters &after)
{
    QStringList changed;
    const auto note = [&changed](bool differs, const QString &name) {
        if (differs) {
            changed << name;
        }
    };
    note(before.a != after.a, symbolOf(Parameter::A));
    note(before.b != after.b, symbolOf(Parameter::B));
    note(before.c != after.c, symbolOf(Parameter::C));
    note(before.omega2 != after.omega2, symbolOf(Parameter::Omega2));
    note(before.theta20 != after.theta20, symbolOf(Parameter::Theta20));
    note(before.branch != after.branch, EditCommandText::tr("the assembly"));
    return changed.size() == 1 ? EditCommandText::tr("change of %1").arg(changed.first())
                               : EditCommandText::tr("change of the mechanism");
}

} // namespace

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

EditCommand::EditCommand(const Choices &before, const Choices &after, const QString &text, int step, const Show &show)
    : QUndoCommand(text)
    , m_before(before)
    , m_after(after)
    , m_step(step)
    , m_show(show)
{
}

void EditCommand::retranslate()
{
    setText(changeName(m_before, m_after));
}

void EditCommand::undo()
{
    m_show(m_before);
}

void EditCommand::redo()
{
    m_show(m_after);
}

int EditCommand::id() const
{
    return m_step;
}

bool EditCommand::mergeWith(const QUndoCommand *next)
{
    m_after = static_cast<const EditCommand *>(next)->m_after; // of the same id: the stack asks no other
    setObsolete(m_after == m_before);
    return true;
}

} // namespace slidercrank
