// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/error.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/scene/scene.h"
#include "backend/simulation/arm/simulated_arm.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace teleta::scene_run {

/// How often a run tells how far it is, and may be ended.
inline constexpr std::uint64_t kSamplesBetweenReports = 1024;

/// The strongest contact of each skin frame of a scene's arm.
class SkinReader {
public:
    explicit SkinReader(const scene::Scene& scene);

    /// sample: with which the frame was read.
    [[nodiscard]] pipeline::SkinContact read(std::span<const float> values, const core::JointSample& sample);

private:
    contact::FrameConditioner m_conditioner;
    contact::ContactSegmenter m_segmenter;
    contact::FeatureExtractor m_features;
    core::ArrayLayout m_layout;
    std::vector<float> m_load_N;
    std::vector<std::uint8_t> m_dead;
};

/// One touch as it was estimated, and what the world knows of it.
struct ComparedTouch {
    pipeline::TouchRecord record;
    std::string object; ///< its name in the scene; empty: no object was touched
    double trueStiffness_NPerM = 0.0;
    Eigen::Vector3d p_Base_Truth_m = Eigen::Vector3d::Zero();
};

/// A touch beside what the world knows of it: the newest touch that had begun when it was evaluated.
[[nodiscard]] ComparedTouch compared(const pipeline::TouchRecord& record,
                                     const simulation::SimulatedArm& arm);

/// Writes touches.csv; NA where nothing is known or observed. Without a folder nothing is written.
[[nodiscard]] core::Expected<void> writeTouches(const std::string& outFolder,
                                                const std::vector<ComparedTouch>& touches);

/// One touch as an event of the summary.
[[nodiscard]] nlohmann::ordered_json touchEvent(const ComparedTouch& touch);

/// The measures of where the contacts were located, beside where they truly were, and of the first one.
void reportContacts(const std::vector<ComparedTouch>& touches, nlohmann::ordered_json& measures);

/// The measures stiffness_covered: share of the reliable touches with an interval, or a bound, that holds the
/// truth; and stiffness_error_mean: mean of |estimate / truth - 1| over those with an estimate. Null when
/// there is none.
void reportStiffnessCovered(const std::vector<ComparedTouch>& touches, nlohmann::ordered_json& measures);

/// Name of the shape that an outline is recognised as.
[[nodiscard]] const char* trueShape(const scene::Outline& outline);

/// One value as such, several as a list.
[[nodiscard]] nlohmann::ordered_json oneOrList(const std::vector<nlohmann::ordered_json>& values);

} // namespace teleta::scene_run
