// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "backend/vision/finders/camera_contact.h"

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::vision {

/// Stages of processing a frame, for timing.
enum class FinderStage { prepare, displacement, segment, locate };
inline constexpr std::size_t kFinderStages = 4;

/// Finds contacts in a frame from the displacement of the pattern on the skin since the reference. Common
/// interface of the methods in contact_ladder.h. Thread: one.
class ContactFinder : public core::Interface {
public:
    /// Sets the reference frame, in which nothing touches the skin. Error: refused (wrong size, no visible
    /// pattern, no memory); cancelled by the stop token of the constructor.
    [[nodiscard]] core::Expected<void> setReference(const cv::Mat1b& frame);

    /// Finds the contacts in a frame, the strongest first. Error: refused: there is no reference, the frame
    /// does not have the size of the camera's image, or there is no memory.
    [[nodiscard]] core::Expected<std::vector<CameraContact>> find(const cv::Mat1b& frame);

    /// To be called when the stream has jumped: forgets earlier frames. CameraContact::deepened_m is unknown
    /// in the next frame.
    virtual void forget() {}

    /// Computing time of each stage for the newest frame.
    [[nodiscard]] const std::array<std::int64_t, kFinderStages>& stageTimes_ns() const { return m_stage_ns; }

    /// A displacement in the newest frame, for views: pixel at rest and how far it moved.
    struct Arrow {
        cv::Point2f at_px;
        cv::Point2f moved_px;
    };
    /// About this many displacements, evenly spread over the skin.
    [[nodiscard]] virtual std::vector<Arrow> arrows(std::size_t about) const = 0;

protected:
    /// Implement setReference() and find(), which convert exceptions of OpenCV to errors.
    [[nodiscard]] virtual core::Expected<void> takeReference(const cv::Mat1b& frame) = 0;
    [[nodiscard]] virtual core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b& frame) = 0;

    std::array<std::int64_t, kFinderStages> m_stage_ns{};
};

} // namespace teleta::vision
