// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace teleta::view3d {

/// Decides which of several views may draw, and when: one after the other, and after each drawing a pause of
/// kPausePerDrawing times its duration (at most kLongestPause_ns), so that drawing leaves most of the
/// thread's time to others however slow the driver is. Thread: any one.
class RenderTurns {
public:
    static constexpr int kPausePerDrawing = 2;
    static constexpr std::int64_t kLongestPause_ns = 200'000'000;
    using View = void*;

    /// The view wants to draw. Asking again while it waits changes nothing.
    void ask(View view);
    /// The view no longer wants to draw.
    void leave(View view);
    /// The view whose turn has come by now_ns; it is no longer waiting. Null: none. If it does not draw after
    /// all, the others wait no longer than if it had.
    [[nodiscard]] View next(std::int64_t now_ns);
    /// Time of the next turn. Empty: no view is waiting.
    [[nodiscard]] std::optional<std::int64_t> nextTurn_ns() const;
    /// The view has drawn, whether or not it was its turn.
    void drawn(View view, std::int64_t begun_ns, std::int64_t ended_ns);

private:
    [[nodiscard]] std::int64_t pause_ns() const;

    std::deque<View> m_waiting;
    std::int64_t m_free_ns = 0;
    std::int64_t m_drawing_ns = 0; ///< duration of the last drawing
};

} // namespace teleta::view3d
