// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/contacts/pair_collector.h"
#include "backend/vision/finders/contact_finder.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace teleta::vision {

/// Watches a camera that is not calibrated yet while a probe touches the skin hole by hole: contacts are
/// found with the camera as the arm is designed, one pixel a steady touch. Thread: one. Source: VTacArm,
/// section III-B.
class ProbeWatcher {
public:
    /// settings: of the image and the cylinder. stop: ends the work on the lens in setReference().
    /// Error: refused when no contacts can be found in images of this size.
    [[nodiscard]] static core::Expected<std::unique_ptr<ProbeWatcher>>
    make(const CalibrationSettings& settings, const std::stop_token& stop = {});

    /// A frame in which nothing touches the skin. Error: it shows no dots; the former one is lost.
    [[nodiscard]] core::Expected<void> setReference(const cv::Mat1b& frame);
    [[nodiscard]] bool hasReference() const { return m_hasReference; }
    /// The pixel in the frame in which it is taken. time_s: of its capture, rising. A frame that cannot be
    /// used is counted, and what was steady until then does not count.
    [[nodiscard]] std::optional<Eigen::Vector2d> next(const cv::Mat1b& frame, double time_s);
    /// The stream has jumped, or frames were lost.
    void skip() { m_collector.skip(); }
    /// A touch that goes on now does not count: the probe has to be lifted first.
    void awaitLift() { m_collector.awaitLift(); }

    /// Of the newest frame.
    [[nodiscard]] const std::vector<CameraContact>& contacts() const { return m_contacts; }
    [[nodiscard]] PairCollector::Phase phase() const { return m_collector.phase(); }
    [[nodiscard]] double progress() const { return m_collector.progress(); }
    [[nodiscard]] std::uint64_t unusable() const { return m_unusable; }
    /// Why the newest frame could not be used; translated; empty when it could.
    [[nodiscard]] const std::string& problem() const { return m_problem; }

private:
    explicit ProbeWatcher(std::unique_ptr<ContactFinder> finder)
        : m_finder(std::move(finder)) {}

    std::unique_ptr<ContactFinder> m_finder;
    PairCollector m_collector;
    std::vector<CameraContact> m_contacts;
    bool m_hasReference = false;
    std::uint64_t m_unusable = 0;
    std::string m_problem;
};

} // namespace teleta::vision
