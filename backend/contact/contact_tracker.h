// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"
#include "backend/core/data/taxel_layout.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

struct TrackingSettings {
    double gate_m = 0.015; ///< a contact that has moved further than this since it was last seen counts as a
                           ///< new one; 0..1000
    double memory_s = 0.1; ///< how long a lost contact keeps its identity; one that was seen in the previous
                           ///< frame always keeps it
};

/// The default settings with a gate that fits an array: two taxels, at least 15 mm, from one frame to the
/// next.
[[nodiscard]] TrackingSettings trackingFor(const core::TaxelLayout& layout);

/// Gives contacts an identity that is stable from frame to frame, by optimal assignment between the contacts
/// of this frame and the remembered ones:
///   least sum over the contacts of min(distance, gate)
/// A contact without a partner costs as much as one that moved by the gate. Groups that are further apart
/// than the gate cannot be confused and are solved separately. In a group of more than kExactLimit contacts
/// or tracks (noise taken for contacts) the nearest pairs are matched first. Identities count from 1 and are
/// not reused until reset(). Thread: one; allocates nothing after the first frames.
class ContactTracker {
public:
    explicit ContactTracker(const TrackingSettings& settings = {});

    /// Largest group, in contacts or tracks, that is assigned exactly; the cost grows with the third power.
    static constexpr std::size_t kExactLimit = 64;

    /// Sets Contact::id of each contact. Positions: finite. time_s: stream time, never decreasing.
    void assign(std::span<Contact> contacts, double time_s);
    void setSettings(const TrackingSettings& settings);
    void reset();

private:
    struct Track {
        int id = 0;
        double x_m = 0.0, y_m = 0.0;
        double lastSeen_s = 0.0;
        std::uint64_t lastFrame = 0; ///< number of the frame in which it was seen last
    };
    /// A contact and a track within the gate.
    struct Pair {
        std::size_t contact = 0;
        std::size_t track = 0;
        std::size_t group = 0;
        double distance_m = 0.0;
    };
    void findPairs(std::span<const Contact> contacts);
    void groupPairs(std::size_t contacts);
    void solveExactly(std::span<const Pair> group);
    void solveNearestFirst(std::span<Pair> group);

    TrackingSettings m_settings;
    std::vector<Track> m_tracks; ///< in order of identity
    int m_nextId = 1;
    std::uint64_t m_frame = 0;

    // Working memory, kept from frame to frame.
    std::vector<Pair> m_pairs;
    std::vector<std::size_t> m_trackOf;   ///< track of each contact, or kNone
    std::vector<std::size_t> m_contactOf; ///< contact of each track, or kNone
    std::vector<std::size_t> m_order;     ///< tracks in order of x
    std::vector<std::size_t> m_parent;    ///< union-find over contacts, then tracks
    std::vector<std::size_t> m_groupContacts, m_groupTracks;
    std::vector<double> m_cost_m;
    std::vector<double> m_rowPotential_m, m_columnPotential_m, m_slack_m;
    std::vector<std::size_t> m_rowOf, m_before;
    std::vector<std::uint8_t> m_visited;
};

} // namespace teleta::contact
