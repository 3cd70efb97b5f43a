// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares methods of the study with the exact motion of one mechanism, and times them, in pieces of a few
// milliseconds.

#include "core/study/exact_values.h"
#include "core/study/study_methods.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace slidercrank
{

/// A method with the time stamps at which it is run, its output there and the times that it takes.
struct TimedMethod {
    const StudyMethod *method = nullptr;
    std::vector<double> timeStamps{};
    StudyRun run{};
    StudyOutput output{};
    long long repeats = 1;
    std::vector<double> nanoseconds{}; ///< per state, one value for each round
};

/// The exact motion at some time stamps, and the size of each channel, relative to which errors are stated.
struct ExactMotion {
    std::map<double, ExactValues> values{}; ///< the key is the time stamp, s

    /// The size of each channel, in the order of kPlottedChannels (mm, rad, s): its peak or, if that is 0,
    /// naturalSize(). Always positive.
    std::array<double, kPlottedChannels.size()> sizes{};
};

class Measurement
{
public:
    /// `timeStamps`: those at which the methods are compared with the exact motion, s.
    Measurement(const Parameters &parameters, std::vector<double> timeStamps);

    /// Adds a method, to be run at these time stamps, if it applies to the mechanism.
    void add(const StudyMethod &method, const std::vector<double> &timeStamps);

    /// Does the next piece of work. Returns false if everything is done.
    bool advance(const StudyRequest &request);

    /// Returns the fraction that is done, 0 … 1.
    double progress(const StudyRequest &request) const;

    /// Returns a row for each method. Requires that advance() has returned false.
    std::vector<MethodResult> results();

    const std::vector<double> &timeStamps() const { return m_timeStamps; }

private:
    std::size_t roundCount(const StudyRequest &request) const; ///< total of all methods

    Parameters m_parameters;
    std::vector<double> m_timeStamps;
    std::vector<TimedMethod> m_methods;
    ExactMotion m_motion;
    std::size_t m_exactCount = 0;    ///< number of time stamps whose exact motion is known
    std::size_t m_preparedCount = 0; ///< number of methods that have been prepared
    std::size_t m_timedRounds = 0;   ///< number of rounds that have been timed
};

/// Returns the worst status among those that occur. NotAssemblable, a property of the mechanism, is less
/// severe than the failures of a method.
Status worstStatus(const std::array<std::size_t, kStatusCount> &counts);

} // namespace slidercrank
