// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_conditioner.h"
#include "backend/core/data/taxel_layout.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

/// FrameConditioner for frames of vectors.
///   f = s gain taxelGain (raw - tare), s = -1 when inverted, else 1
///   load = max(0, -f . n),  shear = f - (f . n) n
/// n: normal of the taxel, z of {s} unless its place says otherwise. inverted: the sensor tells the force
/// that it exerts, not the one on it. A taxel that is marked dead, or of which any component is not finite,
/// is dead in this frame: load and shear 0. Thread: any (immutable); apply() allocates nothing.
class ForceConditioner {
public:
    /// tare has layout.values() entries or none, taxelGain and dead layout.taxels() or none; a wrong size is
    /// treated as none.
    ForceConditioner(const core::TaxelLayout& layout, const ConditioningSettings& settings);

    /// raw: layout.values() numbers; the others layout.taxels(). Shear is along x and y of {s}. Returns the
    /// number of dead taxels.
    std::size_t apply(std::span<const float> raw, std::span<float> load_N, std::span<float> shearX_N,
                      std::span<float> shearY_N, std::span<std::uint8_t> dead) const;

private:
    std::vector<float> m_tare;
    std::vector<double> m_gain; ///< with its sign
    std::vector<std::uint8_t> m_dead;
    std::vector<std::array<double, 3>> m_normal; ///< empty: all are z
};

} // namespace teleta::contact
