// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/place_segmenter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::contact {

PlaceSegmenter::PlaceSegmenter(std::shared_ptr<const core::TaxelPlaces> places,
                               const SegmentationSettings& settings)
    : m_places(std::move(places))
    , m_settings(settings)
    , m_labels(m_places->size())
    , m_load_N(m_places->size())
    , m_active(m_places->size())
    , m_regionOf(m_places->size()) {
}

std::span<Contact> PlaceSegmenter::segment(std::span<const float> load_N,
                                           std::span<const std::uint8_t> dead) {
    std::ranges::fill(m_labels, 0);
    m_contacts.clear();
    if (load_N.size() != m_places->size())
        return m_contacts;
    if (dead.size() != load_N.size())
        dead = {};
    const auto threshold = static_cast<float>(m_settings.threshold_N);
    double peak_N = 0.0;
    for (std::size_t i = 0; i < load_N.size(); ++i) {
        const bool usable = std::isfinite(load_N[i]) && (dead.empty() || dead[i] == 0);
        m_active[i] = usable && load_N[i] > 0.0F && load_N[i] >= threshold ? 1 : 0;
        m_load_N[i] = usable ? static_cast<double>(load_N[i]) : 0.0;
        if (m_active[i] != 0)
            peak_N = std::max(peak_N, m_load_N[i]);
    }
    const double height_N = std::max(m_settings.noiseHeight * peak_N, m_settings.noiseHeight_N);
    m_watershed.flood(
        m_load_N, m_places->neighbours(), [&](std::size_t taxel) { return m_active[taxel] != 0; },
        [&](double summit_N, double pass_N) { return summit_N == pass_N || summit_N - pass_N < height_N; });
    measure();
    number();
    return m_contacts;
}

/// The sums of each region, with those of load times place where the centroid will be.
void PlaceSegmenter::measure() {
    m_regions.clear();
    for (const std::size_t i : m_watershed.order()) {
        const std::size_t summit = m_watershed.rootOf(i);
        const auto index = static_cast<int>(i);
        if (summit == i) { // the first of its region
            m_regionOf[i] = m_regions.size();
            m_regions.push_back({.peak_N = m_load_N[i], .minColumn = index, .maxColumn = index});
        }
        Contact& region = m_regions[m_regionOf[summit]];
        region.force_N += m_load_N[i];
        region.x_m += m_load_N[i] * (*m_places)[i].x_m;
        region.y_m += m_load_N[i] * (*m_places)[i].y_m;
        region.area_m2 += m_places->area_m2(i);
        ++region.taxels;
        region.minColumn = std::min(region.minColumn, index);
        region.maxColumn = std::max(region.maxColumn, index);
    }
}

void PlaceSegmenter::number() {
    m_order.clear();
    for (std::size_t i = 0; i < m_regions.size(); ++i)
        if (m_regions[i].taxels >= m_settings.minimumTaxels)
            m_order.push_back(i);
    // Regions stand in order of their summits.
    std::ranges::sort(m_order, [&](std::size_t a, std::size_t b) {
        return m_regions[a].force_N != m_regions[b].force_N ? m_regions[a].force_N > m_regions[b].force_N
                                                            : a < b;
    });
    for (const std::size_t i : m_order) {
        Contact& contact = m_contacts.emplace_back(m_regions[i]);
        contact.region = static_cast<int>(m_contacts.size());
        contact.x_m /= contact.force_N;
        contact.y_m /= contact.force_N;
        m_regions[i].region = contact.region;
    }
    for (const std::size_t i : m_watershed.order())
        m_labels[i] = m_regions[m_regionOf[m_watershed.rootOf(i)]].region;
}

} // namespace teleta::contact
