// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <deque>
#include <vector>

namespace teleta::view3d {

/// Where a point was during the last seconds. Thread: one.
class Trail {
public:
    static constexpr double kMemory_s = 5.0;
    static constexpr double kStep_m = 5e-4; ///< way after which a place is kept
    /// So long without news nobody knows where it was: the trail begins anew.
    static constexpr double kGap_s = 0.5;
    static constexpr std::size_t kMost = 4096; ///< places

    struct Place {
        Eigen::Vector3d p_m;
        double time_s;
    };

    /// Takes the newest place. Ignored unless finite. Begins anew when the time goes back.
    void add(const Eigen::Vector3d& p_m, double time_s);
    void clear() { m_places.clear(); }
    /// Of a point that stands still nothing is seen.
    [[nodiscard]] bool isSeen() const {
        return m_places.size() > 2 ||
               (m_places.size() == 2 && (m_places[1].p_m - m_places[0].p_m).norm() >= kStep_m);
    }
    [[nodiscard]] bool isEmpty() const { return m_places.empty(); }
    /// From the oldest place to the newest, which is where the point is now.
    [[nodiscard]] const std::deque<Place>& places() const { return m_places; }
    /// What is left of a place: 1 now, falling evenly to 0 after kMemory_s.
    [[nodiscard]] double shareLeft(const Place& place) const;

private:
    std::deque<Place> m_places; ///< the last one moves until it is kStep_m from the one before
};

} // namespace teleta::view3d
