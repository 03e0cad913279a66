// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site/operator_hand.h"

namespace teleta::site {

void OperatorHand::post(bool moves, std::int64_t given_ns) {
    m_blocked = m_blocked && moves;
    if (m_blocked)
        return;
    if (moves) {
        m_press += m_letGo ? 1 : 0;
        m_given_ns = given_ns;
    } else if (m_held) {
        m_holdsLeft = kHolds;
    }
    m_held = moves;
    m_letGo = !moves;
}

void OperatorHand::stop() {
    if (m_held)
        m_holdsLeft = kHolds;
    m_held = false;
    m_blocked = m_blocked || !m_letGo;
}

OperatorHand::Send OperatorHand::step(std::int64_t now_ns) {
    if (m_held && now_ns - m_given_ns > kLifetime_ns) {
        m_held = false;
        m_holdsLeft = kHolds;
    }
    if (m_held)
        return Send::move;
    if (m_holdsLeft == 0)
        return Send::nothing;
    --m_holdsLeft;
    return Send::hold;
}

} // namespace teleta::site
