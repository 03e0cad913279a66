// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/core/data/taxel_places.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace teleta::contact {

/// FeatureExtractor for taxels that stand on no grid: the same formulas and settings over the taxels' own x
/// and y, in the plane of {s}. Thread: one.
class PlaceFeatures {
public:
    /// places: not null.
    explicit PlaceFeatures(std::shared_ptr<const core::TaxelPlaces> places,
                           const FeatureSettings& settings = {});

    /// As FeatureExtractor::compute().
    [[nodiscard]] TactileFeatures compute(std::span<const float> load_N,
                                          std::span<const std::uint8_t> dead = {});

    void setSettings(const FeatureSettings& settings) { m_types.setSettings(settings); }
    void reset() { m_types.reset(); }

private:
    void addPrincipalAxis(std::span<const float> load_N, TactileFeatures& features);

    std::shared_ptr<const core::TaxelPlaces> m_places;
    FeatureExtractor m_types; ///< settings, and the type of the frame before
    std::vector<float> m_usable;
    std::vector<std::size_t> m_active;
};

} // namespace teleta::contact
