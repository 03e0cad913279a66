// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/render_turns.h"

#include <algorithm>

namespace teleta::view3d {

void RenderTurns::ask(View view) {
    if (std::ranges::find(m_waiting, view) == m_waiting.end())
        m_waiting.push_back(view);
}

void RenderTurns::leave(View view) {
    std::erase(m_waiting, view);
}

RenderTurns::View RenderTurns::next(std::int64_t now_ns) {
    if (m_waiting.empty() || now_ns < m_free_ns)
        return nullptr;
    const View view = m_waiting.front();
    m_waiting.pop_front();
    m_free_ns = now_ns + m_drawing_ns + pause_ns();
    return view;
}

std::optional<std::int64_t> RenderTurns::nextTurn_ns() const {
    return m_waiting.empty() ? std::nullopt : std::optional(m_free_ns);
}

void RenderTurns::drawn(View view, std::int64_t begun_ns, std::int64_t ended_ns) {
    leave(view);
    m_drawing_ns = std::max<std::int64_t>(ended_ns - begun_ns, 0);
    m_free_ns = ended_ns + pause_ns();
}

std::int64_t RenderTurns::pause_ns() const {
    return std::min(kPausePerDrawing * m_drawing_ns, kLongestPause_ns);
}

} // namespace teleta::view3d
