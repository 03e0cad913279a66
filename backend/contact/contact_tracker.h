// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

struct TrackingSettings {
    double gate_m = 0.015;  ///< a contact that moved further than this since it was seen is a new one
    double memory_s = 0.1;  ///< how long a contact that is gone may come back under its identity
};

/// Gives contacts an identity that is stable from frame to frame: optimal assignment (least total distance) between
/// the contacts of this frame and those remembered, gated by distance. Identities count from 1 and are never reused
/// until reset().
/// Thread: one.
class ContactTracker {
public:
    explicit ContactTracker(const TrackingSettings& settings = {});

    /// Writes Contact::id of each contact. time_s: stream time, not decreasing.
    void assign(std::span<Contact> contacts, double time_s);
    void setSettings(const TrackingSettings& settings) { m_settings = settings; }
    void reset();

private:
    struct Track {
        int id = 0;
        double x_m = 0.0, y_m = 0.0;
        double lastSeen_s = 0.0;
    };
    TrackingSettings m_settings;
    std::vector<Track> m_tracks;
    int m_nextId = 1;
};

} // namespace teleta::contact
