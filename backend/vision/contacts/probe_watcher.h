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

/// Watches an uncalibrated camera while a probe touches the skin hole by hole, and gives one pixel per steady
/// touch. Contacts are found with nominalCamera(). Thread: one. Source: VTacArm, section III-B.
class ProbeWatcher {
public:
    /// settings: size of the image and the cylinder. stop: cancels the inversion of the lens in
    /// setReference(). Error: refused when contacts cannot be found in images of this size.
    [[nodiscard]] static core::Expected<std::unique_ptr<ProbeWatcher>>
    make(const CalibrationSettings& settings, const std::stop_token& stop = {});

    /// Sets the frame in which nothing touches the skin. Error: it shows no dots; the previous reference is
    /// then lost.
    [[nodiscard]] core::Expected<void> setReference(const cv::Mat1b& frame);
    [[nodiscard]] bool hasReference() const { return m_hasReference; }
    /// Processes the next frame. time_s: time of capture, rising. Returns the pixel in the frame in which it
    /// is taken. An unusable frame is counted, and the contact must be steady anew.
    [[nodiscard]] std::optional<Eigen::Vector2d> next(const cv::Mat1b& frame, double time_s);
    /// To be called when the stream has jumped or frames were lost.
    void skip() { m_collector.skip(); }
    /// The current touch does not count; the probe has to be lifted first.
    void awaitLift() { m_collector.awaitLift(); }

    /// Contacts in the newest frame.
    [[nodiscard]] const std::vector<CameraContact>& contacts() const { return m_contacts; }
    [[nodiscard]] PairCollector::Phase phase() const { return m_collector.phase(); }
    [[nodiscard]] double progress() const { return m_collector.progress(); }
    [[nodiscard]] std::uint64_t unusable() const { return m_unusable; }
    /// Why the newest frame was unusable, translated; empty if it was usable.
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
