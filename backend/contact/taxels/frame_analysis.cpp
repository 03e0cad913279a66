// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/frame_analysis.h"

#include "backend/contact/taxels/shear_sums.h"

#include <algorithm>
#include <utility>

namespace teleta::contact {

namespace {

/// The settings, with what the layout has no taxel for marked as dead.
ConditioningSettings withoutAbsent(ConditioningSettings settings, const core::TaxelLayout& layout) {
    if (layout.absent().empty())
        return settings;
    if (settings.dead.size() != layout.taxels()) // a list of another size is none
        settings.dead.assign(layout.taxels(), 0);
    for (std::size_t i = 0; i < layout.taxels(); ++i)
        if (layout.isAbsent(i))
            settings.dead[i] = 1;
    return settings;
}

core::ArrayLayout gridOf(const core::TaxelLayout& layout) {
    return layout.isGrid() ? layout.grid() : core::ArrayLayout{1, 1};
}

} // namespace

FrameAnalysis::FrameAnalysis(const core::TaxelLayout& layout, const AnalysisSettings& settings)
    : m_layout(layout)
    , m_range(settings.features.range)
    , m_absent(static_cast<std::size_t>(std::ranges::count(layout.absent(), 1)))
    , m_conditioner(layout.taxels(), {})
    , m_features(gridOf(layout))
    , m_segmenter(gridOf(layout))
    , m_tracker(trackingFor(layout)) {
    if (!layout.isGrid()) {
        m_placeFeatures.emplace(layout.places());
        m_placeSegmenter.emplace(layout.places());
    }
    setSettings(settings);
}

void FrameAnalysis::setSettings(const AnalysisSettings& settings) {
    m_range = settings.features.range;
    const ConditioningSettings conditioning = withoutAbsent(settings.conditioning, m_layout);
    if (m_layout.isVector())
        m_forces.emplace(m_layout, conditioning);
    else
        m_conditioner = FrameConditioner(m_layout.taxels(), conditioning);
    m_features.setSettings(settings.features);
    m_segmenter.setSettings(settings.segmentation);
    if (m_placeFeatures)
        m_placeFeatures->setSettings(settings.features);
    if (m_placeSegmenter)
        m_placeSegmenter->setSettings(settings.segmentation);
}

void FrameAnalysis::reset() {
    m_tracker.reset();
    m_features.reset();
    if (m_placeFeatures)
        m_placeFeatures->reset();
}

void FrameAnalysis::analyse(std::span<const float> raw, double time_s, TaxelFrame& frame) {
    const std::size_t taxels = m_layout.taxels();
    frame.layout = m_layout;
    frame.load_N.resize(taxels);
    frame.dead.resize(taxels);
    std::size_t dead = 0;
    if (m_forces) {
        frame.shearX_N.resize(taxels);
        frame.shearY_N.resize(taxels);
        dead = m_forces->apply(raw, frame.load_N, frame.shearX_N, frame.shearY_N, frame.dead);
    } else {
        dead = m_conditioner.apply(raw, frame.load_N, frame.dead);
    }

    const auto contacts = m_placeSegmenter ? m_placeSegmenter->segment(frame.load_N, frame.dead)
                                           : m_segmenter.segment(frame.load_N, frame.dead);
    m_tracker.assign(contacts, time_s);
    frame.contacts.assign(contacts.begin(), contacts.end());
    frame.features = m_placeFeatures ? m_placeFeatures->compute(frame.load_N, frame.dead)
                                     : m_features.compute(frame.load_N, frame.dead);
    frame.features.dead = static_cast<int>(dead - m_absent);
    if (m_forces) {
        setContactShear(frame, labels());
        setFeatureShear(frame, m_range);
    }
}

std::span<const std::int32_t> FrameAnalysis::labels() const {
    return m_placeSegmenter ? m_placeSegmenter->labels() : m_segmenter.labels();
}

} // namespace teleta::contact
