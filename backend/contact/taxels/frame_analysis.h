// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/contact/taxels/force_conditioner.h"
#include "backend/contact/taxels/place_features.h"
#include "backend/contact/taxels/place_segmenter.h"
#include "backend/contact/taxels/taxel_frame.h"
#include "backend/core/data/taxel_layout.h"

#include <cstdint>
#include <span>
#include <variant>

namespace teleta::contact {

/// How the frames of a source are turned into contacts and features.
struct AnalysisSettings {
    ConditioningSettings conditioning;
    FeatureSettings features;
    SegmentationSettings segmentation;
};

/// From raw frames of a source to loads, contacts with identities, and features, whatever its layout is.
/// Grids of loads are computed by FrameConditioner, ContactSegmenter and FeatureExtractor; places by
/// PlaceSegmenter and PlaceFeatures; of vectors ForceConditioner takes the load, and contacts and features
/// get their shear. Thread: one; allocates nothing after the first frames.
class FrameAnalysis {
public:
    explicit FrameAnalysis(const core::TaxelLayout& layout, const AnalysisSettings& settings = {});

    void setSettings(const AnalysisSettings& settings);
    /// The next frame does not follow the last one.
    void reset();

    /// raw: layout.values() numbers. frame: gets what was found, but for labels; its vectors are resized
    /// once.
    void analyse(std::span<const float> raw, double time_s, TaxelFrame& frame);
    /// Contact::region of each taxel of the last frame; 0: no contact.
    [[nodiscard]] std::span<const std::int32_t> labels() const;

private:
    struct OnGrid {
        FeatureExtractor features;
        ContactSegmenter segmenter;
    };
    struct OnPlaces {
        PlaceFeatures features;
        PlaceSegmenter segmenter;
    };
    [[nodiscard]] static std::variant<FrameConditioner, ForceConditioner>
    conditionerFor(const core::TaxelLayout& layout, const ConditioningSettings& settings);
    [[nodiscard]] static std::variant<OnGrid, OnPlaces> findersFor(const core::TaxelLayout& layout);

    core::TaxelLayout m_layout;
    MomentRange m_range;
    std::size_t m_absent = 0; ///< places without a taxel
    std::variant<FrameConditioner, ForceConditioner> m_conditioner;
    std::variant<OnGrid, OnPlaces> m_finders;
    ContactTracker m_tracker;
};

} // namespace teleta::contact
