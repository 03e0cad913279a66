// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace teleta::view3d {

/// How finely the frames of a view are drawn, by how long the driver takes for them. It begins plain, tries
/// the next level when frames are quick, and leaves a level for good whose frames take too long. Thread: any
/// one.
class FrameQuality {
public:
    enum class Level {
        plain,  ///< what the driver draws by itself
        smooth, ///< edges are smoothed
        shaded, ///< corners are darker as well (ambient occlusion)
    };
    static constexpr std::int64_t kBudget_ns = 12'000'000; ///< a frame may take, 19 of 20 at least
    static constexpr std::int64_t kQuick_ns = 4'000'000;   ///< frames of the level below a trial
    static constexpr int kFrames = 40;                     ///< that a decision is made from

    [[nodiscard]] Level level() const { return m_level; }
    /// A frame was drawn at this level. Returns whether the level is another one now.
    bool drawn(std::int64_t duration_ns);
    /// Frames have another size: every level may be tried again.
    void restart();

private:
    Level m_level = Level::plain;
    Level m_highest = Level::shaded;
    std::vector<std::int64_t> m_durations_ns;
};

} // namespace teleta::view3d
