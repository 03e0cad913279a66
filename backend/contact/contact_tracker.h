// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/contact_segmenter.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::contact {

struct TrackingSettings {
    double gate_m = 0.015; ///< a contact that moved further than this since it was seen is a new one; 0..1000
    double memory_s = 0.1; ///< how long a contact that is gone may come back under its identity; one that was
                           ///< there in the frame before keeps it in any case
};

/// The default settings, with a gate that fits an array: a contact may move by two taxels, or by 15 mm on an
/// array that is finer than 7.5 mm, from one frame to the next.
[[nodiscard]] TrackingSettings trackingFor(const core::ArrayLayout& layout);

/// Gives contacts an identity that is stable from frame to frame: optimal assignment between the contacts of
/// this frame and those remembered.
///   least sum over the contacts of min(distance, gate)
/// so a contact that is left without a partner costs as much as one that moved by the gate. Contacts and
/// tracks that cannot be mixed up, since more than the gate is between them, are solved apart; in a group of
/// more than kExactLimit (noise taken for contacts) the nearest pairs are taken first. Identities count from
/// 1 and are never reused until reset(). Thread: one; after the first frames nothing is allocated.
class ContactTracker {
public:
    explicit ContactTracker(const TrackingSettings& settings = {});

    /// Contacts, or tracks, of a group up to which the assignment is exact; its cost grows with the third
    /// power.
    static constexpr std::size_t kExactLimit = 64;

    /// Writes Contact::id of each contact. Positions are finite; time_s: stream time, not decreasing.
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
    /// A contact and a track that are no further apart than the gate.
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
