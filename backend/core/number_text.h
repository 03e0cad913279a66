// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string_view>

namespace teleta::core {

/// A number as text in the C locale, whatever the locale of the program is. Doubles get the fewest digits
/// that read back as the same double; nan and inf become "nan", "inf", "-inf". Thread: any; nothing is
/// allocated.
class NumberText {
public:
    template <typename Number>
    explicit NumberText(Number value)
        : m_end(std::to_chars(m_text, m_text + sizeof m_text, value).ptr) {}

    /// With so many significant digits at most.
    NumberText(double value, int digits)
        : m_end(
              std::to_chars(m_text, m_text + sizeof m_text, value, std::chars_format::general, digits).ptr) {}

    NumberText(const NumberText&) = delete;
    NumberText& operator=(const NumberText&) = delete;

    [[nodiscard]] std::string_view view() const { return {m_text, static_cast<std::size_t>(m_end - m_text)}; }

private:
    char m_text[48]; // a double needs at most 24, with digits at most 17 of them
    char* m_end;
};

} // namespace teleta::core
