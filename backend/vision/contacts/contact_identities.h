// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/depth_rate.h"
#include "backend/vision/finders/camera_contact.h"

#include <vector>

namespace teleta::vision {

/// What happens to a contact in a frame.
enum class ContactEvent { none, begins, ends };

/// A contact that is tracked from frame to frame. Points are in the sensor frame {s}.
struct FollowedContact {
    CameraContact contact; ///< as last seen
    Eigen::Vector3d p_Sensor_Start_m = Eigen::Vector3d::Zero();
    double begin_s = 0.0;
    double seen_s = 0.0;
    ContactEvent event = ContactEvent::none; ///< what happens in the newest frame
    bool seen = false;                       ///< it is visible in the newest frame
    /// How fast it deepens. Known from the first frame on: its places on the skin may have moved before it
    /// was seen.
    DepthRate depthRate;

    /// Displacement since its start; zero while the centre is not located.
    [[nodiscard]] Eigen::Vector3d displacement_m() const {
        return contact.p_Sensor_Centre_m - p_Sensor_Start_m;
    }
};

/// Gives located contacts identities that are stable from frame to frame: new and tracked contacts are
/// matched in order of their distance, up to the gate. Identities count from 1 and are never reused. Contacts
/// that are not located get none. Thread: one.
class ContactIdentities {
public:
    struct Settings {
        double gate_m = 0.012;  ///< a contact further away than this in one frame is another one
        double memory_s = 0.06; ///< how long a contact may be missing before it ends
    };
    ContactIdentities() = default;
    explicit ContactIdentities(const Settings& settings)
        : m_settings(settings) {}

    /// Takes the contacts of the next frame. time_s: of the frame, rising. framePeriod_s: time since the
    /// previous usable frame, > 0. Returns the contacts that exist and those that end in this frame, sorted
    /// by identity.
    const std::vector<FollowedContact>& update(std::vector<CameraContact> contacts, double time_s,
                                               double framePeriod_s);
    /// All tracked contacts end in the next frame; the contacts of that frame are new.
    void endAll() { m_endAll = true; }
    /// To be called when the stream has jumped: all contacts are new.
    void forget() { m_followed.clear(); }

    [[nodiscard]] const std::vector<FollowedContact>& followed() const { return m_followed; }

private:
    Settings m_settings;
    std::vector<FollowedContact> m_followed;
    int m_nextId = 1;
    bool m_endAll = false;
};

} // namespace teleta::vision
