// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares methods of the study with the exact motion of one mechanism, and times them, in pieces of a few
// milliseconds.

#include "core/study/judge.h"
#include "core/study/study_methods.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace slidercrank
{

/// A method that is run at some time stamps.
struct Contender {
    const StudyMethod *method = nullptr;
    std::vector<double> timeStamps{};
    StudyRun run{};
    StudyAnswers answers{};
    long long repeats = 1;
    std::vector<double> nanoseconds{}; ///< per state, one value for each round
};

/// The exact motion at some time stamps, and the sizes with which errors are compared.
struct JudgedMotion {
    std::map<double, Judged> exact{}; ///< by time stamp
    std::array<double, kPlottedChannels.size()>
        sizes{}; ///< rad, mm: the peak, or naturalSize() where that is 0; positive
};

class Measurement
{
public:
    /// `timeStamps`: where the answers are compared with the exact motion.
    Measurement(const Parameters &parameters, std::vector<double> timeStamps);

    /// Adds a method at these time stamps, unless it does not apply to the mechanism.
    void add(const StudyMethod &method, const std::vector<double> &timeStamps);

    /// Does the next piece. Returns false if everything is done.
    bool advance(const StudyRequest &request);

    /// Returns the part that is done, 0 … 1.
    double progress(const StudyRequest &request) const;

    /// Returns a row for each method, when everything is done.
    std::vector<MethodResult> results();

    const std::vector<double> &timeStamps() const { return m_timeStamps; }

private:
    std::size_t roundCount(const StudyRequest &request) const; ///< number of rounds of all methods together

    Parameters m_parameters;
    std::vector<double> m_timeStamps;
    std::vector<Contender> m_contenders;
    JudgedMotion m_motion;
    std::size_t m_judged = 0;   ///< number of time stamps whose exact motion is known
    std::size_t m_prepared = 0; ///< number of methods that have been prepared
    std::size_t m_timed = 0;    ///< number of rounds that have been timed
};

/// Returns the worst status among those that occur. NotAssemblable is a property of the mechanism, the others are
/// failures of the method.
Status worstStatus(const std::array<std::size_t, kStatusCount> &counts);

} // namespace slidercrank
