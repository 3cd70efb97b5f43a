// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include <charconv>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The fewest digits that read back the same; `otherwise` for what does not exist.
std::string numberText(std::optional<double> value, const char *otherwise)
{
    if (!value || !std::isfinite(*value)) {
        return otherwise;
    }
    char text[32];
    const std::to_chars_result end = std::to_chars(text, text + sizeof text, *value);
    return {text, end.ptr};
}

std::string countText(std::optional<std::size_t> count, const char *otherwise)
{
    return count ? std::to_string(*count) : otherwise;
}

/// Both formats quote; JSON with a backslash, CSV by doubling.
std::string quoted(std::string_view text, std::string_view beforeSpecial)
{
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"') {
            result += beforeSpecial;
        }
        result += letter;
    }
    return result + '"';
}

std::string textOf(const Machine &machine)
{
    return (machine.processor.empty() ? "other" : machine.processor) + ", " + std::to_string(machine.threads) +
           " threads" + (machine.compiler.empty() ? "" : ", " + machine.compiler) +
           (machine.isOptimized ? "" : ", not optimized");
}

std::string jsonOf(const MethodResult &row)
{
    std::string counts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        counts += i == 0 ? "\"" : ",\"";
        counts += wordOf(static_cast<Status>(i));
        counts += "\":" + std::to_string(row.counts[i]);
    }
    return "{\"method\":" + quoted(nameOf(row.method), "\\") + ",\"tolerance\":" + numberText(row.tolerance, "null") +
           ",\"channels\":" + std::to_string(row.channels) + ",\"nsPerState\":" + numberText(row.nsPerState, "null") +
           ",\"spread\":" + numberText(row.spread, "null") +
           ",\"iterationsPerState\":" + numberText(row.iterationsPerState, "null") +
           ",\"maxError\":" + numberText(row.maxError, "null") +
           ",\"errorBound\":" + numberText(row.errorBound, "null") + ",\"status\":" + quoted(wordOf(row.status), "\\") +
           ",\"counts\":{" + counts + "},\"silentFailures\":" + countText(row.silentFailures, "null") + '}';
}

} // namespace

std::string nameOf(const MethodName &method)
{
    constexpr std::array kNames{"newton-dense", "newton-dense-taylor", "newton-structured", "newton-structured-taylor",
                                "closed-form",  "closed-form-batch",   "finite-difference"};
    return method.kind == MethodName::Kind::Harmonics ? "harmonic-" + std::to_string(method.harmonics)
                                                      : kNames[static_cast<std::size_t>(method.kind)];
}

std::string studyJson(const StudyResult &result)
{
    std::string text = "{\"machine\":" + quoted(textOf(result.machine), "\\") + ",\"cases\":[";
    for (const CaseResult &which : result.cases) {
        text += &which == &result.cases.front() ? "\n" : ",\n";
        text += "{\"name\":" + quoted(nameOf(which.traits), "\\") + ",\"methods\":[";
        for (const MethodResult &row : which.methods) {
            text += &row == &which.methods.front() ? "\n" : ",\n";
            text += jsonOf(row);
        }
        text += "]}";
    }
    return text + "]}\n";
}

std::string studyCsv(const StudyResult &result)
{
    std::string text = "case,method,tolerance,channels,nsPerState,spread,iterationsPerState,maxError,errorBound,status";
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        text += ',';
        text += wordOf(static_cast<Status>(i));
    }
    text += ",silentFailures\n";
    for (const CaseResult &which : result.cases) {
        for (const MethodResult &row : which.methods) {
            text += quoted(nameOf(which.traits), "\"") + ',' + nameOf(row.method) + ',' +
                    numberText(row.tolerance, "") + ',' + std::to_string(row.channels) + ',' +
                    numberText(row.nsPerState, "") + ',' + numberText(row.spread, "") + ',' +
                    numberText(row.iterationsPerState, "") + ',' + numberText(row.maxError, "") + ',' +
                    numberText(row.errorBound, "") + ',';
            text += wordOf(row.status);
            for (const std::size_t count : row.counts) {
                text += ',' + std::to_string(count);
            }
            text += ',' + countText(row.silentFailures, "") + '\n';
        }
    }
    return text;
}

} // namespace slidercrank
