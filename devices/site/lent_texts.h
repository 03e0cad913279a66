// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <utility>

namespace teleta::site_link {

/// Keeps the texts of a message that is to be sent. Every text of a message must be set, "" where there is
/// nothing to say. Thread: one.
class LentTexts {
public:
    /// Valid while this lives.
    [[nodiscard]] char* operator()(std::string text) {
        m_texts.push_back(std::move(text));
        return m_texts.back().data();
    }

private:
    std::deque<std::string> m_texts;
};

/// A text of a received message.
[[nodiscard]] inline std::string textOf(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

} // namespace teleta::site_link
