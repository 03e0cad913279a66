// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/vision/camera/cylinder_projection.h"
#include "backend/vision/contacts/camera_tracker.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::pipeline {

/// What the arm that carries the camera does about contacts.
struct CarrierReport {
    enum class Doing {
        stands,   ///< nothing to react to
        retreats, ///< from a bump
        follows,  ///< a contact
        held,     ///< by STOP, by the operator, or because no frames come
    };
    Doing doing = Doing::stands;
    int contact = 0; ///< that it retreats from or follows; 0: none
    Eigen::Isometry3d X_Base_Sensor = Eigen::Isometry3d::Identity();
};

/// Lets an arm react to contacts. Thread: one, the vision thread of a channel.
class CameraReaction {
public:
    virtual ~CameraReaction() = default;
    /// Commands the arm. allowed: otherwise it is to stand still, and what it reacted to is forgotten.
    virtual void react(const std::vector<vision::FollowedContact>& contacts,
                       const std::optional<vision::BumpDetector::Bump>& bump, bool allowed) = 0;
    /// No frames come: the arm stands until the next one.
    virtual void hold() = 0;
    /// All contacts are new.
    virtual void forget() = 0;
    [[nodiscard]] virtual CarrierReport report() const = 0;
};

/// A displacement of the skin on its surface, frame {s}.
struct SkinVector {
    Eigen::Vector3d p_Sensor_m;     ///< of the skin at rest
    Eigen::Vector3d displacement_m; ///< in the plane that touches the surface there
    double sd_m = 0.0;              ///< of either end, 1 sigma
};

/// What the pipeline knows of a camera after its newest frame. Views get it as a constant and own no truth.
struct CameraSnapshot {
    core::GreyImage image;    ///< the newest one that was decoded
    core::GreyImage preview;  ///< the same, at most CameraChannel::kPreview_px wide
    std::int64_t time_ns = 0; ///< steady clock at the read
    double time_s = 0.0;      ///< of the source, rising, from its first frame
    std::uint64_t frame = 0;

    std::vector<vision::FollowedContact> contacts;    ///< that are there or end with this frame
    std::vector<Eigen::Matrix3d> covariances_m2;      ///< of their centres; one a contact, NaN where unknown
    std::vector<vision::ContactFinder::Arrow> arrows; ///< what moved, in pixels of the image
    std::vector<SkinVector> vectors;                  ///< the same on the skin, where the rays meet it
    std::optional<vision::BumpDetector::Bump> bump;   ///< of this frame
    std::optional<CarrierReport> carrier;             ///< empty: no arm reacts to this camera
    vision::CylinderSurface surface;

    bool hasReference = false;
    bool usable = false;          ///< the newest frame could be used
    std::string problem;          ///< why it could not; translated; empty when all is well
    std::string_view rung;        ///< of the ladder, in use
    std::string_view nextRung;    ///< that is being made ready; empty: none
    std::string_view refusedRung; ///< that was asked for and cannot be used; empty: none
    std::string whyRefused;       ///< translated
    bool mayReact = false;        ///< the arm is allowed to move

    std::array<std::int64_t, vision::kFinderStages> stage_ns{};
    std::int64_t whole_ns = 0;    ///< from the frame to its contacts
    double processed_Hz = 0.0;    ///< frames a second that are processed
    std::uint64_t processed = 0;  ///< frames
    std::uint64_t passedOver = 0; ///< frames that were too old when their turn came
    std::uint64_t unusable = 0;   ///< frames that showed no skin or could not be decoded
};

/// Something that happened to the tube.
struct CameraEvent {
    enum class Kind { begins, bumps, ends, follows, reference, restart };
    Kind kind = Kind::begins;
    double time_s = 0.0;
    int contact = 0; ///< 0: not of a contact
    bool located = false;
    Eigen::Vector3d p_Sensor_m = Eigen::Vector3d::Zero();
    double depth_m = 0.0; ///< NaN: not known
};

} // namespace teleta::pipeline
