// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <QFile>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::frames {

/// Reads a text line by line, without line ends and byte order mark. Thread: one.
class TextLines {
public:
    explicit TextLines(std::string path);

    /// Error: ioFailed.
    [[nodiscard]] core::Expected<void> open();
    /// The next line; empty at the end. It is valid until the next call. Error: badInput for a line over 16
    /// MiB or with bytes that no text has, ioFailed.
    [[nodiscard]] core::Expected<std::optional<std::string_view>> next();

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Of the line that was read last, from 1.
    [[nodiscard]] long long number() const { return m_number; }
    /// An error at a column of that line.
    [[nodiscard]] core::Unexpected wrong(const QString& message, const QString& expected,
                                         long long column = 0) const;

private:
    std::string_view readLine();

    std::string m_path;
    QFile m_file;
    std::vector<char> m_buffer;
    long long m_number = 0;
};

/// Splits a line at a separator; blank: at blanks. Blanks around a field and quotes are taken off.
void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// A number as text: finite, nan, inf or NA, in the C locale or with a decimal comma; nothing for others.
[[nodiscard]] std::optional<double> fieldNumber(std::string_view field, bool hasDecimalComma);

/// A field for a message: short, in quotes.
[[nodiscard]] QString shownField(std::string_view field);

} // namespace teleta::frames
