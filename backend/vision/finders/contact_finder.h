// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/finders/camera_contact.h"

#include <opencv2/core.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::vision {

/// What a frame's time goes into.
enum class FinderStage { prepare, displacement, segment, locate };
inline constexpr std::size_t kFinderStages = 4;

/// Finds contacts in a frame by how the pattern on the skin has moved since the reference. What the rungs of
/// the ladder have in common; see contact_ladder.h. Thread: one.
class ContactFinder {
public:
    virtual ~ContactFinder() = default;
    ContactFinder() = default;
    ContactFinder(const ContactFinder&) = delete;
    ContactFinder& operator=(const ContactFinder&) = delete;

    /// Takes the frame in which nothing touches the skin.
    /// Error: refused (wrong size, no pattern to be seen, no memory), cancelled by the token that it was made
    /// with.
    [[nodiscard]] core::Expected<void> setReference(const cv::Mat1b& frame);

    /// Contacts of a frame, the strongest first. Before a reference was set: refused. frame: as large as the
    /// camera's image, otherwise refused, as when there is no memory.
    [[nodiscard]] core::Expected<std::vector<CameraContact>> find(const cv::Mat1b& frame);

    /// The stream has jumped: nothing of the frames before may help. Contacts of the next frame do not know
    /// how much they have deepened.
    virtual void forget() {}

    /// Time of each stage in the newest frame.
    [[nodiscard]] const std::array<std::int64_t, kFinderStages>& stageTimes_ns() const { return m_stage_ns; }

    /// What moved in the newest frame, for views: pixels at rest and their displacement.
    struct Arrow {
        cv::Point2f at_px;
        cv::Point2f moved_px;
    };
    /// About so many of them, evenly over the skin.
    [[nodiscard]] virtual std::vector<Arrow> arrows(std::size_t about) const = 0;

protected:
    /// setReference() and find(); what OpenCV throws in them becomes an error.
    [[nodiscard]] virtual core::Expected<void> takeReference(const cv::Mat1b& frame) = 0;
    [[nodiscard]] virtual core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b& frame) = 0;

    std::array<std::int64_t, kFinderStages> m_stage_ns{};
};

} // namespace teleta::vision
