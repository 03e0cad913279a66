// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/echo_ledger.h"

namespace teleta::core {

std::uint16_t EchoLedger::send() {
    ++m_sent;
    if (inFlight() > kLongestFlight) {
        ++m_settled;
        ++m_lost;
    }
    return static_cast<std::uint16_t>(m_sent);
}

void EchoLedger::echo(std::uint16_t sequence) {
    if (const std::uint64_t frame = settle(sequence); frame != 0) {
        m_newestEchoed = frame;
        ++m_echoed;
    }
}

void EchoLedger::refuse(std::uint16_t sequence) {
    if (settle(sequence) != 0) {
        ++m_refused;
        ++m_lost;
    }
}

std::uint64_t EchoLedger::settle(std::uint16_t sequence) {
    const auto behind = static_cast<std::uint16_t>(static_cast<std::uint16_t>(m_sent) - sequence);
    if (behind >= inFlight()) {
        ++m_stray;
        return 0;
    }
    const std::uint64_t frame = m_sent - behind;
    m_lost += frame - m_settled - 1;
    m_settled = frame;
    return frame;
}

void EchoLedger::endConnection() {
    m_lost += inFlight();
    m_settled = m_sent;
}

} // namespace teleta::core
