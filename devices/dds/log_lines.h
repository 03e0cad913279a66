// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::dds {

/// Lets one line a second through and counts the others: with its interface down, the middleware complains a
/// thousand times a second. Thread: one.
class LogLimit {
public:
    /// The line as it is to be printed, with the number of lines that were kept back before it; nothing: keep
    /// it back. now_ns: steady, not decreasing.
    [[nodiscard]] std::optional<std::string> pass(std::string_view line, std::int64_t now_ns);

private:
    std::optional<std::int64_t> m_last_ns;
    std::uint64_t m_keptBack = 0;
};

/// Sends what the middleware reports to standard error, as LogLimit lets it. Once is enough. Thread: any.
void limitLog();

/// What the middleware reported of programs that security keeps out of a domain.
struct RefusalLines {
    std::uint64_t count = 0;
    std::string last;
};

/// Those of a domain since forgetRefusals(). Counted while limitLog() is in force. Thread: any.
[[nodiscard]] RefusalLines refusalLines(int domain);
void forgetRefusals(int domain);

/// Collects what the middleware reports on this thread while it lives, instead of printing it: the reason of
/// a call that fails. Thread: one; not nested.
class CollectedLog {
public:
    CollectedLog();
    ~CollectedLog();
    CollectedLog(const CollectedLog&) = delete;
    CollectedLog& operator=(const CollectedLog&) = delete;

    /// The lines, separated by "; ".
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

} // namespace teleta::dds
