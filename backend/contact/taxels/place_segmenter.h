// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/taxels/graph_watershed.h"
#include "backend/core/data/taxel_places.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace teleta::contact {

/// ContactSegmenter for taxels that stand on no grid: the same settings, by a watershed over the graph of
/// neighbours (core::TaxelPlaces). A contact's area is the sum of its taxels' areas; its bounding box counts
/// the taxels as one row. A taxel on the border of two contacts belongs to the one with the higher summit.
/// Thread: one; allocates nothing after the first frames.
class PlaceSegmenter {
public:
    /// places: not null.
    explicit PlaceSegmenter(std::shared_ptr<const core::TaxelPlaces> places,
                            const SegmentationSettings& settings = {});

    /// As ContactSegmenter::segment().
    [[nodiscard]] std::span<Contact> segment(std::span<const float> load_N,
                                             std::span<const std::uint8_t> dead = {});
    [[nodiscard]] std::span<const std::int32_t> labels() const { return m_labels; }

    void setSettings(const SegmentationSettings& settings) { m_settings = settings; }

private:
    void measure();
    void number();

    std::shared_ptr<const core::TaxelPlaces> m_places;
    SegmentationSettings m_settings;
    GraphWatershed m_watershed;
    std::vector<std::int32_t> m_labels;
    std::vector<Contact> m_contacts;

    // Working memory.
    std::vector<double> m_load_N;
    std::vector<std::uint8_t> m_active;
    std::vector<Contact> m_regions;
    std::vector<std::size_t> m_regionOf; ///< of each taxel that is a summit
    std::vector<std::size_t> m_order;
};

} // namespace teleta::contact
