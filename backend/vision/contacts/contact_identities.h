// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/depth_rate.h"
#include "backend/vision/finders/camera_contact.h"

#include <vector>

namespace teleta::vision {

/// What becomes of a contact in a frame.
enum class ContactEvent { none, begins, ends };

/// A contact that is followed from frame to frame. Frame {s} of the sensor.
struct FollowedContact {
    CameraContact contact; ///< as it was seen last
    Eigen::Vector3d p_Sensor_Start_m = Eigen::Vector3d::Zero();
    double begin_s = 0.0;
    double seen_s = 0.0;
    ContactEvent event = ContactEvent::none; ///< in the newest frame
    bool seen = false;                       ///< in the newest frame
    /// How fast it deepens; the places of a new one may have moved before it was seen, so it has one at once.
    DepthRate depthRate;

    /// Displacement since its start; zero while it is not located.
    [[nodiscard]] Eigen::Vector3d displacement_m() const {
        return contact.p_Sensor_Centre_m - p_Sensor_Start_m;
    }
};

/// Gives located contacts identities that stay from frame to frame: pairs of a contact and one that is
/// followed are taken in order of their distance, up to the gate. Identities count from 1 and are never
/// reused. Contacts that are not located get none. Thread: one.
class ContactIdentities {
public:
    struct Settings {
        double gate_m = 0.012;  ///< further than this in one frame is another contact
        double memory_s = 0.06; ///< how long one may be away before it has ended
    };
    ContactIdentities() = default;
    explicit ContactIdentities(const Settings& settings)
        : m_settings(settings) {}

    /// time_s: of the frame, rising. framePeriod_s: > 0, since the frame before that showed the skin. Returns
    /// those that are there, and those that end with this frame, in order of identity.
    const std::vector<FollowedContact>& update(std::vector<CameraContact> contacts, double time_s,
                                               double framePeriod_s);
    /// All that are followed end with the next frame; its contacts are new.
    void endAll() { m_endAll = true; }
    /// The stream has jumped: all contacts are new.
    void forget() { m_followed.clear(); }

    [[nodiscard]] const std::vector<FollowedContact>& followed() const { return m_followed; }

private:
    Settings m_settings;
    std::vector<FollowedContact> m_followed;
    int m_nextId = 1;
    bool m_endAll = false;
};

} // namespace teleta::vision
