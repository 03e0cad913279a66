// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/peer_process.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::taxels::test {

/// The board of tests/peer/taxels/board.py, which packs its frames with Python's own libraries.
class Board {
public:
    Board(const std::string& link, const std::string& format, const std::string& place) {
        m_process.start(QStringLiteral("/usr/bin/python3"),
                        {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/taxels/board.py"),
                         QString::fromStdString(link), QString::fromStdString(format),
                         QString::fromStdString(place)});
        const auto ready = m_process.waitFor("ready ");
        EXPECT_TRUE(ready) << m_process.errors();
        if (ready)
            m_place = ready->substr(6);
    }

    /// Path or port.
    [[nodiscard]] const std::string& place() const { return m_place; }
    /// Without waiting until it is done: who reads its link is the caller.
    void say(const std::string& line) { m_process.say(line); }
    [[nodiscard]] bool command(const std::string& line) { return m_process.command(line); }
    [[nodiscard]] bool done() { return m_process.waitFor("done").has_value(); }
    /// What it was sent, as hexadecimal digits.
    [[nodiscard]] std::string heard() {
        m_process.say("heard");
        return m_process.waitFor("heard ").value_or("heard ?").substr(6);
    }

private:
    teleta::test::PeerProcess m_process;
    std::string m_place;
};

/// The values of its frame of this number.
inline std::vector<float> valuesOf(std::uint32_t number) {
    std::vector<float> values(84);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>((number * 131 + i) & 0xFFFFU);
    return values;
}

} // namespace teleta::taxels::test
