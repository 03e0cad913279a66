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

} // namespace

FrameAnalysis::FrameAnalysis(const core::TaxelLayout& layout, const AnalysisSettings& settings)
    : m_layout(layout)
    , m_range(settings.features.range)
    , m_absent(static_cast<std::size_t>(std::ranges::count(layout.absent(), 1)))
    , m_conditioner(conditionerFor(layout, settings.conditioning))
    , m_finders(findersFor(layout))
    , m_tracker(trackingFor(layout)) {
    setSettings(settings);
}

std::variant<FrameConditioner, ForceConditioner>
FrameAnalysis::conditionerFor(const core::TaxelLayout& layout, const ConditioningSettings& settings) {
    if (layout.isVector())
        return ForceConditioner(layout, withoutAbsent(settings, layout));
    return FrameConditioner(layout.taxels(), withoutAbsent(settings, layout));
}

std::variant<FrameAnalysis::OnGrid, FrameAnalysis::OnPlaces>
FrameAnalysis::findersFor(const core::TaxelLayout& layout) {
    if (layout.isGrid())
        return OnGrid{FeatureExtractor(layout.grid()), ContactSegmenter(layout.grid())};
    return OnPlaces{PlaceFeatures(layout.places()), PlaceSegmenter(layout.places())};
}

void FrameAnalysis::setSettings(const AnalysisSettings& settings) {
    m_range = settings.features.range;
    m_conditioner = conditionerFor(m_layout, settings.conditioning);
    std::visit(
        [&](auto& finders) {
            finders.features.setSettings(settings.features);
            finders.segmenter.setSettings(settings.segmentation);
        },
        m_finders);
}

void FrameAnalysis::reset() {
    m_tracker.reset();
    std::visit([](auto& finders) { finders.features.reset(); }, m_finders);
}

void FrameAnalysis::analyse(std::span<const float> raw, double time_s, TaxelFrame& frame) {
    const std::size_t taxels = m_layout.taxels();
    frame.layout = m_layout;
    frame.load_N.resize(taxels);
    frame.dead.resize(taxels);
    std::size_t dead = 0;
    const auto* forces = std::get_if<ForceConditioner>(&m_conditioner);
    if (forces != nullptr) {
        frame.shearX_N.resize(taxels);
        frame.shearY_N.resize(taxels);
        dead = forces->apply(raw, frame.load_N, frame.shearX_N, frame.shearY_N, frame.dead);
    } else {
        dead = std::get<FrameConditioner>(m_conditioner).apply(raw, frame.load_N, frame.dead);
    }

    std::visit(
        [&](auto& finders) {
            const auto contacts = finders.segmenter.segment(frame.load_N, frame.dead);
            m_tracker.assign(contacts, time_s);
            frame.contacts.assign(contacts.begin(), contacts.end());
            frame.features = finders.features.compute(frame.load_N, frame.dead);
        },
        m_finders);
    frame.features.dead = static_cast<int>(dead - m_absent);
    if (forces != nullptr) {
        setContactShear(frame, labels());
        setFeatureShear(frame, m_range);
    }
}

std::span<const std::int32_t> FrameAnalysis::labels() const {
    return std::visit([](const auto& finders) { return finders.segmenter.labels(); }, m_finders);
}

} // namespace teleta::contact
