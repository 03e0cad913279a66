// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/finders/contact_finder.h"
#include "backend/vision/finders/contact_ladder.h"
#include "backend/vision/finders/skin_sample.h"

#include <opencv2/video/tracking.hpp>

#include <optional>
#include <stop_token>
#include <vector>

namespace teleta::vision {

/// Finds contacts from the dense optical flow between the reference and a frame:
///   mask -> resize -> dense inverse search -> displacement on the skin -> threshold -> contours -> mean on
///   the skin
/// The paper's method uses 512 x 288 pixels for any aspect ratio, a threshold of the flow in pixels, a
/// maximum filter, and the back projection of the mean pixel of a patch. Thread: one. Source: VTacArm,
/// section III-B; T. Kroeger et al., Fast optical flow using dense inverse search (2016).
class FlowContactFinder : public ContactFinder {
public:
    /// Error: refused when the image of the camera is too small or does not show the skin; cancelled.
    /// Unavailable: see opencv::denseFlow().
    [[nodiscard]] static core::Expected<std::unique_ptr<ContactFinder>> make(const ContactRung& rung,
                                                                             const CylinderCamera& camera,
                                                                             const ContactSettings& settings,
                                                                             const std::stop_token& stop);

    void forget() override { m_beforeKnown = false; }
    [[nodiscard]] std::vector<Arrow> arrows(std::size_t about) const override;

private:
    FlowContactFinder(const ContactRung& rung, const CylinderCamera& camera, const ContactSettings& settings,
                      cv::Ptr<cv::DISOpticalFlow> dis, const std::stop_token& stop);
    [[nodiscard]] core::Expected<void> takeReference(const cv::Mat1b& frame) override;
    [[nodiscard]] core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b& frame) override;
    /// The presets of OpenCV are made for large images; chooses a finest scale at which the dots are still
    /// resolved.
    void sharpen();
    void flow(const cv::Mat1b& reference, const cv::Mat1b& small, cv::Mat2f& flow);
    /// Pixel of the camera's image that corresponds to a pixel of the small image.
    [[nodiscard]] Eigen::Vector2d inImage_px(double x, double y) const;
    void prepare(const cv::Mat1b& frame, cv::Mat1b& small) const;
    /// Finds where the small image differs from the reference by more than noise.
    void findChange();
    /// Part of the small image in which the flow is needed; empty when nothing has changed.
    [[nodiscard]] cv::Rect aroundChange() const;
    void measure(const cv::Rect& part);
    /// Removes displacements further than one dot from any change of the image.
    void dropUnfounded();
    /// Displacement (around, inward) of a sample.
    [[nodiscard]] Eigen::Vector2d moved_m(const SkinSample& sample, const cv::Vec2f& flow_px) const;
    [[nodiscard]] std::vector<CameraContact> contacts();
    /// strength: displacement integrated over the moved skin.
    [[nodiscard]] CameraContact contactOf(const std::vector<cv::Point>& contour, const cv::Mat1i& labels,
                                          int label, double& strength);

    ContactRung m_rung;
    CylinderCamera m_camera;
    CylinderSurface m_skin;
    ContactSettings m_settings;
    cv::Rect m_crop; ///< of the camera's image
    cv::Mat1b m_cropMask;
    std::vector<SkinSample> m_samples; ///< one per pixel of the small image on the skin
    cv::Mat1i m_sampleOf;              ///< -1: not on the skin
    cv::Ptr<cv::DISOpticalFlow> m_dis;
    int m_finestScale = 0;
    int m_patchSize_px = 0;
    cv::Mat1b m_reference, m_small;
    cv::Mat1b m_smoothReference;
    cv::Mat1b m_changed;    ///< 255 where the small image differs from the reference, else 0
    cv::Mat2f m_flow;       ///< 0 where it was not computed
    cv::Mat2f m_flowBefore; ///< of the previous frame
    cv::Mat1f m_moved;      ///< in m; for the paper's method in px
    cv::Mat1b m_active;
    bool m_beforeKnown = false;                      ///< m_flow is that of the previous frame
    std::vector<float> m_inward_m, m_inwardBefore_m; ///< of one contact's pixels
};

} // namespace teleta::vision
