// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/pipeline/touch/skin_kinematics.h"

#include <opencv2/core.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

namespace teleta::test {

/// Of the arm with seven joints, eight around each of five links.
inline std::vector<std::shared_ptr<const pipeline::SkinKinematics>> patchesOnArm() {
    const auto model = arm_model::readUrdf(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
    if (!model)
        throw std::runtime_error(core::describe(model.error()));
    const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                      "base_link", "tool0");
    if (!chain)
        throw std::runtime_error(core::describe(chain.error()));
    const auto arm = std::make_shared<const arm_model::SerialChain>(*chain);
    std::vector<std::shared_ptr<const pipeline::SkinKinematics>> patches;
    for (const char* link : {"link_2", "link_3", "link_4", "link_5", "link_6"})
        for (int i = 0; i < 8; ++i) {
            const double angle_rad = 2.0 * std::numbers::pi * i / 8.0;
            const auto patch = pipeline::padOnLink(
                arm, {.link = link,
                      .position_m = {0.06 * std::cos(angle_rad), 0.06 * std::sin(angle_rad), 0.05},
                      .rollPitchYaw_rad = {0.0, 0.5 * std::numbers::pi, angle_rad},
                      .joint = "joint_2"});
            if (!patch)
                throw std::runtime_error(core::describe(patch.error()));
            patches.push_back(*patch);
        }
    return patches;
}

/// The skin of a whole body: 10 000 taxels in 40 patches on an arm that moves, some of them touched by a
/// moving ball.
struct WholeBodySkin {
    static constexpr std::size_t kPatches = 40;
    std::vector<std::shared_ptr<const pipeline::SkinKinematics>> places = patchesOnArm();
    core::JointVector angle_rad{0.1, 0.4, -0.2, 0.9, 0.3, -0.5, 0.2};
    Eigen::Vector3d sum_m = Eigen::Vector3d::Zero(); ///< of the contacts' places, so that none is left out
    core::ArrayLayout layout{10, 25, 0.01};
    std::vector<float> raw; ///< frame by frame, then patch by patch
    contact::FrameConditioner conditioner{layout.taxels(), {}};
    std::vector<contact::ContactSegmenter> segmenters{kPatches, contact::ContactSegmenter(layout)};
    std::vector<contact::ContactTracker> trackers{kPatches,
                                                  contact::ContactTracker(contact::trackingFor(layout))};
    std::vector<float> load_N = std::vector<float>(layout.taxels());
    std::vector<std::uint8_t> dead = std::vector<std::uint8_t>(layout.taxels());
    std::vector<cv::Mat> grey;
    double time_s = 0.0;

    WholeBodySkin(std::size_t touched, std::size_t frames) {
        std::mt19937 random(7);
        std::normal_distribution<float> noise_N(0.0F, 0.03F);
        for (std::size_t frame = 0; frame < frames; ++frame)
            for (std::size_t patch = 0; patch < kPatches; ++patch) {
                const bool isTouched = patch * touched / kPatches != (patch + 1) * touched / kPatches;
                const double phase =
                    2.0 * std::numbers::pi * static_cast<double>(frame) / static_cast<double>(frames);
                const double column = 12.0 + 8.0 * std::sin(phase + static_cast<double>(patch));
                const double row = 4.5 + 2.0 * std::cos(phase);
                for (int r = 0; r < layout.rows; ++r)
                    for (int c = 0; c < layout.columns; ++c) {
                        const double way = std::hypot(c - column, r - row);
                        const double ball_N = isTouched ? std::max(0.0, 2.0 - 0.32 * way * way) : 0.0;
                        raw.push_back(static_cast<float>(ball_N) + noise_N(random));
                    }
            }
        for (std::size_t i = 0; i < frames * kPatches; ++i)
            grey.push_back(cv::max(
                cv::Mat(layout.rows, layout.columns, CV_32F, raw.data() + i * layout.taxels()), 0.0F));
    }

    /// From raw values to contacts with identities and their places, directions and Jacobians on the arm, all
    /// patches. Returns how many contacts there are.
    std::size_t process(std::size_t frame) {
        std::size_t contacts = 0;
        for (std::size_t patch = 0; patch < kPatches; ++patch) {
            conditioner.apply(
                std::span(raw).subspan((frame * kPatches + patch) * layout.taxels(), layout.taxels()), load_N,
                dead);
            const std::span<contact::Contact> found = segmenters[patch].segment(load_N, dead);
            trackers[patch].assign(found, time_s);
            for (const contact::Contact& one : found) {
                const pipeline::SkinPoint point = places[patch]->at(angle_rad, one.x_m, one.y_m);
                sum_m += point.p_Base_m + point.normal_Base + point.jacobian.col(0);
            }
            contacts += found.size();
        }
        angle_rad[0] = 0.1 + 1e-3 * static_cast<double>(frame);
        time_s += 0.005;
        return contacts;
    }
};

} // namespace teleta::test
