// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/chain_lines.h"

#include <array>
#include <cstddef>
#include <fcntl.h>
#include <unistd.h>

namespace teleta::cli {

void say(const std::string& line) {
    const std::string text = line + '\n';
    (void)!::write(STDOUT_FILENO, text.data(), text.size());
}

CommandReader::CommandReader() {
    fcntl(STDIN_FILENO, F_SETFL, fcntl(STDIN_FILENO, F_GETFL) | O_NONBLOCK);
}

std::optional<std::string> CommandReader::next() {
    std::array<char, 256> piece{};
    const ssize_t length = read(STDIN_FILENO, piece.data(), piece.size());
    m_closed = m_closed || length == 0;
    if (length > 0)
        m_text.append(piece.data(), static_cast<std::size_t>(length));
    const std::size_t end = m_text.find('\n');
    if (end == std::string::npos)
        return std::nullopt;
    std::string line = m_text.substr(0, end);
    m_text.erase(0, end + 1);
    return line;
}

} // namespace teleta::cli
