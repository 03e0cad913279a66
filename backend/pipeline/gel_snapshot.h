// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/camera_source.h"
#include "backend/equilibration/load_calibration.h"
#include "backend/pipeline/camera_snapshot.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace teleta::pipeline {

/// Lets the arm that carries a flat gel react to contacts. Thread: one, the channel's.
class GelReaction {
public:
    virtual ~GelReaction() = default;
    /// Commands the arm. noise_m: of a marker's place. allowed: otherwise the arm is to stand still, and what
    /// it reacted to is forgotten. A bump of this picture: the contact that was one; 0: none.
    virtual int react(const std::vector<vision::GelContactState>& contacts, double time_s, double noise_m,
                      bool allowed) = 0;
    /// No pictures come that can be used: the arm stands until the next one.
    virtual void hold() = 0;
    /// All contacts are new.
    virtual void forget() = 0;
    [[nodiscard]] virtual CarrierReport report() const = 0;
};

/// What the pipeline knows of a flat gel after its newest picture. Views get it as a constant and own no
/// truth.
struct GelSnapshot {
    core::GreyImage image;    ///< the newest one that was decoded, cropped and flipped
    std::int64_t time_ns = 0; ///< steady clock at the read
    double time_s = 0.0;      ///< of the source, rising, from its first frame
    std::uint64_t frame = 0;

    std::vector<vision::GelMarker> markers;        ///< empty: the rest is not known yet
    std::vector<vision::GelMotion> motions;        ///< one a marker; of the newest picture
    std::vector<vision::GelContactState> contacts; ///< of the newest picture
    /// Loads of each contact, where a calibration is known; otherwise none.
    std::vector<equilibration::LoadCalibration::Loads> loads;
    std::vector<std::string> loadNames; ///< of equilibration::kLoadColumns
    double noise_m = 0.0; ///< standard deviation of a marker's place along an axis, on the surface
    double scale_m = 0.0; ///< size of a pixel on the surface, in the middle of the picture
    /// Of the picture on the surface, as vision::MarkerGel::corners_m(); undefined without markers.
    std::array<Eigen::Vector2d, 4> corners_m{};

    std::optional<CarrierReport> carrier; ///< empty: no arm reacts to this gel
    bool mayReact = false;                ///< the arm is allowed to move

    std::size_t missing = 0;  ///< pictures to come before the rest can be taken; 0: none is being taken
    bool usable = false;      ///< the markers were followed into the newest picture
    std::string problem;      ///< what is wrong; translated; empty when all is well
    std::int64_t work_ns = 0; ///< from the picture to its contacts
    double processed_Hz = 0.0;
    std::uint64_t processed = 0;  ///< pictures
    std::uint64_t passedOver = 0; ///< pictures that were too old when their turn came
    std::uint64_t unusable = 0;   ///< pictures in which the markers could not be followed

    [[nodiscard]] bool hasReference() const { return !markers.empty(); }
};

/// Something that happened to the gel.
struct GelEvent {
    enum class Kind {
        begins,
        incipientSlip,
        slip,
        ends,
        reference,
        restart,
        dark,
        lightJump,
        torn,
        bumps,
        follows
    };
    Kind kind = Kind::begins;
    double time_s = 0.0;
    int contact = 0; ///< 0: not of a contact; the places below are undefined then
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d shear_m = Eigen::Vector2d::Zero(); ///< shear proxy
    std::optional<double> slipIndex;
};

} // namespace teleta::pipeline
