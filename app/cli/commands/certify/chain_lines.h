// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace teleta::cli {

/// Says a line on standard output at once, whatever is buffered elsewhere. A reader who is gone is not this
/// program's concern.
void say(const std::string& line);

/// Commands from standard input, without waiting. Thread: one.
class CommandReader {
public:
    CommandReader();

    /// The next whole line; empty: there is none yet.
    [[nodiscard]] std::optional<std::string> next();
    /// Whoever gave commands is gone.
    [[nodiscard]] bool closed() const { return m_closed; }

private:
    std::string m_text;
    bool m_closed = false;
};

} // namespace teleta::cli
