// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Explains why a reference file differs from the model, and what can be done about it. The window, the command line and
// the report use the same explanations.

#include "core/identification/identification.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace slidercrank
{

struct Explanation {
    enum class Cause {
        Convention, ///< the file has to be read differently from its headings
        Drive,      ///< the crank speed is not constant
        LeftOut,    ///< some columns do not contain the motion of the others
        Outlier,    ///< some rows are far from the motion of the others
        Length,     ///< one length of the model is different
        Mechanism,  ///< the mechanism that produced the file, or why it is unknown
        Agreement   ///< none: apart from the other causes, the file agrees with the model
    };
    enum class Action {
        None,
        Apply,       ///< reads the file with `convention`
        UseMechanism ///< makes the mechanism found the model, and reads the file with all conventions
    };
    QString text;
    Cause cause = Cause::Mechanism;
    Action action = Action::None;
    Convention convention = {}; ///< for Action::Apply
};

/// Returns the explanations of the difference between a file and the given mechanism, in the order in which they should
/// be read. `found`: the result of identifying the mechanism of the file; `layout`: the layout of the file.
std::vector<Explanation> explainDifferences(const Identification &found, const Parameters &given,
                                            const FileLayout &layout);

/// Returns the texts of the explanations.
QStringList textsOf(const std::vector<Explanation> &explanations);

} // namespace slidercrank
