// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/alignment_watch.h"

#include "backend/simulation/servo/servo_loop.h"

#include <cmath>
#include <numbers>

namespace teleta::simulation {

namespace {

constexpr double kAlignedAngle_rad = std::numbers::pi / 180.0;
constexpr double kAlignedPlace_m = 0.0005;
constexpr double kAlignedFor_s = 0.2;

bool isAligned(const ServoFrameTruth& frame, double copY_m) {
    if (!(frame.loads.force_N > 0.0))
        return false;
    const double offY_m = frame.loads.copY_m - copY_m;
    if (!frame.alphaZ_rad)
        return std::hypot(frame.loads.copX_m, offY_m) < kAlignedPlace_m;
    return std::abs(*frame.alphaZ_rad) < kAlignedAngle_rad &&
           std::abs(frame.loads.copX_m - frame.loads.cocX_m) < kAlignedPlace_m &&
           std::abs(offY_m) < kAlignedPlace_m;
}

} // namespace

void AlignmentWatch::add(const ServoLoop& loop) {
    if (!loop.frameCame() || m_aligned_s)
        return;
    const double now_s = loop.world().time_s();
    if (!isAligned(loop.world().frameTruth(), m_copY_m))
        m_present_s.reset();
    else if (!m_present_s)
        m_present_s = now_s;
    if (m_present_s && now_s - *m_present_s >= kAlignedFor_s)
        m_aligned_s = m_present_s;
}

} // namespace teleta::simulation
