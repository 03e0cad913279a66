// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/contact_finder.h"
#include "backend/vision/finders/contact_ladder.h"
#include "backend/vision/finders/dot_tracker.h"
#include "backend/vision/finders/skin_patches.h"
#include "backend/vision/finders/skin_sample.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace teleta::vision {

/// Finds contacts from the displacements of the printed dots. The reference is unrolled to find the dots,
/// which are then tracked in the image itself. Thread: one.
class DotContactFinder : public ContactFinder {
public:
    /// stop: cancels the inversion of the lens in the first setReference().
    DotContactFinder(const CylinderCamera& camera, const ContactSettings& settings,
                     std::stop_token stop = {});

    void forget() override;
    [[nodiscard]] std::vector<Arrow> arrows(std::size_t about) const override;

    [[nodiscard]] const std::optional<DotTracker>& tracker() const { return m_tracker; }

private:
    [[nodiscard]] core::Expected<void> takeReference(const cv::Mat1b& frame) override;
    [[nodiscard]] core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b& frame) override;

    struct Unrolled {
        cv::Mat2f toImage;
        cv::Mat1b mask;
        double step_m = 0.0;
        int wrap = 0; ///< columns repeated on each side
    };
    [[nodiscard]] Unrolled unrolled() const;
    [[nodiscard]] cv::Mat1b skinMask() const;
    /// Computes once what depends on the camera only: the lens is inverted for each pixel. Returns false when
    /// stopped.
    [[nodiscard]] bool prepareMaps();
    /// Removes dots of neighbouring rings that the image cannot resolve, such as those at the far end of a
    /// small image, where noise alone would look like a contact.
    void dropUnresolved(std::vector<TrackedDot>& dots, std::vector<SkinSample>& samples) const;
    void findNeighbours(const std::vector<SkinSample>& samples);
    [[nodiscard]] CameraContact contactOf(const SkinPatch& patch) const;
    void outline(const SkinPatch& patch, CameraContact& contact) const;

    CylinderCamera m_camera;
    CylinderSurface m_skin;
    ContactSettings m_settings;
    SkinPatches m_patches;
    std::stop_token m_stop;
    Unrolled m_unrolled;
    cv::Mat1b m_skinMask;
    std::optional<DotTracker> m_tracker;
    std::vector<SkinSample> m_samples; ///< one per dot
    std::vector<SkinNode> m_nodes;
    std::vector<std::vector<std::size_t>> m_neighbours;
    double m_pitch_m = 0.0;     ///< median distance to the nearest dot
    bool m_beforeKnown = false; ///< m_nodes are those of the previous frame
};

} // namespace teleta::vision
