// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a reference file says about itself, as lines to read, each with at most one thing to do about it.

#include "core/identification/convention.h"

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;

namespace slidercrank
{

struct ReferenceDiagnosis;
struct Result;

struct Finding {
    enum class Remedy {
        None,
        TakeOver,     ///< the mechanism that was found becomes the model
        Apply,        ///< the convention
        ReadAsPrinted ///< without the conventions applied
    };
    Remedy remedy = Remedy::None;
    Convention convention; ///< where the remedy is to apply it
    QString sentence;
    QString remedyText;
    QString details; ///< what the remedy would change, rich text; may be empty

    friend bool operator==(const Finding &, const Finding &) = default;
};

/// What is to be said while these results are on show. `diagnosis`: of the same reference, or null while unknown.
/// Empty where there is nothing to say: every channel agrees, and nothing was applied.
std::vector<Finding> findingsOf(const Result &result, const ReferenceDiagnosis *diagnosis);

/// The lines, one below the other; hidden while there are none.
class FindingList : public QWidget
{
    Q_OBJECT

public:
    explicit FindingList(QWidget *parent = nullptr);

    void setFindings(const std::vector<Finding> &findings);

    /// Sentences that are not of the parameters on show are dimmed.
    void setUpToDate(bool upToDate);

signals:
    void remedyRequested(const slidercrank::Finding &finding);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void takeRoom(); ///< for every line of the sentences: a table can be scrolled, these cannot

    std::vector<Finding> m_findings;
    std::vector<QLabel *> m_sentences;
    QWidget *m_lines = nullptr; ///< replaced when there are others
};

} // namespace slidercrank
