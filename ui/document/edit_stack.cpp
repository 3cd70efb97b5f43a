// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_stack.h"

#include "ui/text/parameter_text.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr int kUndoLimit = 200;
constexpr std::chrono::seconds kMergeInterval{1}; // longer than the delay before a held key repeats

/// Bits of EditName::changes. The lower bits are those of the parameters: 1 << indexOf(parameter).
constexpr int kBranchBit = 1 << kParameterCount;
constexpr int kSamplingBit = kBranchBit << 1;
constexpr int kSolverBit = kBranchBit << 2;
constexpr int kAccelerationBit = kBranchBit << 3;

struct EditName {
    QString text;
    int changes = 0; ///< a bit for each setting that changes; 0 if the edit is always a step of its own
};

bool haveSameFile(const Choices &first, const Choices &second)
{
    return first.reference && second.reference ? first.reference->source.paths == second.reference->source.paths
                                               : first.reference == second.reference;
}

/// Returns the name of an edit, and what it changes: the most important of the choices that differ, because an edit of
/// the reference or of parameters may also change the time range.
EditName nameEdit(const Choices &before, const Choices &after)
{
    if (after.reference != before.reference) {
        if (!after.reference) {
            return {.text = EditStack::tr("closing of %1").arg(before.reference->name)};
        }
        const QString text =
            haveSameFile(before, after) ? EditStack::tr("new interpretation of %1") : EditStack::tr("opening of %1");
        return {.text = text.arg(after.reference->name)};
    }
    if (after.pinned != before.pinned) {
        return {.text = after.pinned.empty() ? EditStack::tr("removal of the pinned motions")
                                             : EditStack::tr("pinning of the motion")};
    }
    std::vector<Parameter> changed;
    for (const Parameter parameter : kAllParameters) {
        if (valueOf(before.parameters, parameter) != valueOf(after.parameters, parameter)) {
            changed.push_back(parameter);
        }
    }
    const bool isBranchChanged = before.parameters.branch != after.parameters.branch;
    const bool isMechanismChanged = isBranchChanged || !changed.empty();
    if (!isMechanismChanged && after.alpha2 != before.alpha2) {
        return {.text = EditStack::tr("change of %1").arg(QStringLiteral("α₂")), .changes = kAccelerationBit};
    }
    if (!isMechanismChanged && after.sampling != before.sampling) {
        return {.text = EditStack::tr("change of the time range"), .changes = kSamplingBit};
    }
    if (!isMechanismChanged) {
        return {.text = EditStack::tr("change of the method"), .changes = kSolverBit};
    }
    int changes = isBranchChanged ? kBranchBit : 0;
    for (const Parameter parameter : changed) {
        changes |= 1 << indexOf(parameter);
    }
    const bool isOneParameter = changed.size() == 1 && !isBranchChanged;
    return {.text = isOneParameter ? EditStack::tr("change of %1").arg(symbolText(changed.front()))
                                   : EditStack::tr("change of the mechanism"),
            .changes = changes};
}

/// Restores the choices before or after an edit. Qt merges successive commands with the same id().
class EditCommand : public QUndoCommand
{
public:
    EditCommand(const Choices &before, const Choices &after, const std::optional<EditStack::TimeChange> &time,
                const QString &text, int step, const EditStack::Apply &apply)
        : QUndoCommand(text)
        , m_before(before)
        , m_after(after)
        , m_time(time)
        , m_step(step)
        , m_apply(apply)
    {
    }

    /// Returns whether the edit opens or closes a reference file, which does not modify the scene.
    bool opensOrClosesFile() const { return !haveSameFile(m_before, m_after); }

    const Choices &before() const { return m_before; }
    const Choices &after() const { return m_after; }
    const std::optional<EditStack::TimeChange> &time() const { return m_time; }

    void undo() override { m_apply(m_before, m_time ? std::optional(m_time->before) : std::nullopt); }
    void redo() override { m_apply(m_after, m_time ? std::optional(m_time->after) : std::nullopt); }
    int id() const override { return m_step; }

    bool mergeWith(const QUndoCommand *next) override
    {
        const auto *nextEdit = static_cast<const EditCommand *>(next);
        m_after = nextEdit->m_after;
        if (m_time && nextEdit->m_time) {
            m_time->after = nextEdit->m_time->after;
        }
        setObsolete(m_after == m_before);
        return true;
    }

private:
    Choices m_before;
    Choices m_after;
    std::optional<EditStack::TimeChange> m_time;
    int m_step;
    EditStack::Apply m_apply;
};

} // namespace

EditStack::EditStack(const Apply &apply, QObject *parent)
    : QUndoStack(parent)
    , m_apply(apply)
    , m_mergeTimer(parent)
{
    setUndoLimit(kUndoLimit);
    m_mergeTimer.setSingleShot(true);
}

void EditStack::edit(const Choices &before, const Choices &after, const QString &text,
                     const std::optional<TimeChange> &time)
{
    const EditName name = text.isEmpty() ? nameEdit(before, after) : EditName{.text = text};
    const bool isRepeated = m_mergeTimer.isActive() && name.changes == m_lastChanges;
    const bool isMergeable = name.changes != 0 && m_lastChanges != 0;
    if (!isMergeable || !(m_isDragging || isRepeated)) {
        ++m_step;
    }
    m_lastChanges = name.changes;
    m_mergeTimer.start(kMergeInterval);
    push(new EditCommand(before, after, time, name.text, m_step, m_apply));
}

void EditStack::takeOver(const EditStack &other)
{
    clear();
    // push() and setIndex() apply the choices of the steps that they pass. Meanwhile that must have no effect, because
    // the session already has the choices of other.index().
    const Apply apply = std::exchange(m_apply, [](const Choices &, std::optional<double>) {});
    // Later, the steps call the restored m_apply.
    const auto applyByMember = [this](const Choices &choices, std::optional<double> time) { m_apply(choices, time); };
    for (int i = 0; i < other.count(); ++i) {
        const auto *step = static_cast<const EditCommand *>(other.command(i));
        const QString text = nameEdit(step->before(), step->after()).text;
        push(new EditCommand(step->before(), step->after(), step->time(), text, ++m_step, applyByMember));
    }
    if (other.cleanIndex() < 0) {
        resetClean();
    } else {
        setIndex(other.cleanIndex());
        setClean();
    }
    setIndex(other.index());
    m_apply = apply;
}

void EditStack::setDragging(bool isDragging)
{
    m_isDragging = isDragging;
    m_lastChanges = 0; // the next edit is a new step
}

bool EditStack::isModified() const
{
    const auto [first, last] = std::minmax({cleanIndex(), index()});
    for (int i = first; i < last; ++i) {
        if (i < 0 || !static_cast<const EditCommand *>(command(i))->opensOrClosesFile()) {
            return true;
        }
    }
    return first < 0;
}

} // namespace slidercrank

#include "moc_edit_stack.cpp"
