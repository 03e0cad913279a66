// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace teleta::contact {

namespace {

constexpr double kLargestGate_m = 1000.0;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::size_t findRoot(std::vector<std::size_t>& parent, std::size_t node) {
    while (parent[node] != node)
        node = parent[node] = parent[parent[node]];
    return node;
}

void keepUnique(std::vector<std::size_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::size_t indexOf(const std::vector<std::size_t>& sorted, std::size_t value) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

} // namespace

TrackingSettings trackingFor(const core::TaxelLayout& layout) {
    TrackingSettings settings;
    settings.gate_m = std::max(settings.gate_m, 2.0 * layout.pitch_m());
    return settings;
}

ContactTracker::ContactTracker(const TrackingSettings& settings) {
    setSettings(settings);
}

void ContactTracker::setSettings(const TrackingSettings& settings) {
    m_settings = settings;
    // Turns NaN into 0, too: the assignment has no solution with an infinite or undefined cost.
    m_settings.gate_m = settings.gate_m > 0.0 ? std::min(settings.gate_m, kLargestGate_m) : 0.0;
}

void ContactTracker::reset() {
    m_tracks.clear();
    m_nextId = 1;
}

void ContactTracker::assign(std::span<Contact> contacts, double time_s) {
    // A contact of the previous frame is kept, however long ago that frame was.
    std::erase_if(m_tracks, [&](const Track& track) {
        return track.lastFrame != m_frame && time_s - track.lastSeen_s > m_settings.memory_s;
    });
    ++m_frame;

    m_trackOf.assign(contacts.size(), kNone);
    m_contactOf.assign(m_tracks.size(), kNone);
    findPairs(contacts);
    groupPairs(contacts.size());

    for (auto begin = m_pairs.begin(); begin != m_pairs.end();) {
        const auto end =
            std::find_if(begin, m_pairs.end(), [&](const Pair& pair) { return pair.group != begin->group; });
        m_groupContacts.clear();
        m_groupTracks.clear();
        for (auto pair = begin; pair != end; ++pair) {
            m_groupContacts.push_back(pair->contact);
            m_groupTracks.push_back(pair->track);
        }
        keepUnique(m_groupContacts);
        keepUnique(m_groupTracks);
        if (std::max(m_groupContacts.size(), m_groupTracks.size()) <= kExactLimit)
            solveExactly({begin, end});
        else
            solveNearestFirst({begin, end});
        begin = end;
    }

    for (std::size_t i = 0; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        if (m_trackOf[i] == kNone) {
            m_trackOf[i] = m_tracks.size();
            m_tracks.push_back({.id = m_nextId++});
        }
        Track& track = m_tracks[m_trackOf[i]];
        contact.id = track.id;
        track.x_m = contact.x_m;
        track.y_m = contact.y_m;
        track.lastSeen_s = time_s;
        track.lastFrame = m_frame;
    }
}

void ContactTracker::findPairs(std::span<const Contact> contacts) {
    m_pairs.clear();
    m_order.resize(m_tracks.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    std::sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(m_tracks[a].x_m, a) < std::tie(m_tracks[b].x_m, b);
    });
    const double gate_m = m_settings.gate_m;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        auto track = std::lower_bound(m_order.begin(), m_order.end(), contact.x_m - gate_m,
                                      [&](std::size_t t, double x_m) { return m_tracks[t].x_m < x_m; });
        for (; track != m_order.end() && m_tracks[*track].x_m <= contact.x_m + gate_m; ++track) {
            const double distance_m =
                std::hypot(m_tracks[*track].x_m - contact.x_m, m_tracks[*track].y_m - contact.y_m);
            if (distance_m <= gate_m)
                m_pairs.push_back({.contact = i, .track = *track, .distance_m = distance_m});
        }
    }
}

void ContactTracker::groupPairs(std::size_t contacts) {
    m_parent.resize(contacts + m_tracks.size());
    std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    for (const Pair& pair : m_pairs) {
        const std::size_t a = findRoot(m_parent, pair.contact);
        const std::size_t b = findRoot(m_parent, contacts + pair.track);
        m_parent[std::max(a, b)] = std::min(a, b);
    }
    for (Pair& pair : m_pairs)
        pair.group = findRoot(m_parent, pair.contact);
    std::sort(m_pairs.begin(), m_pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.group, a.contact, a.track) < std::tie(b.group, b.contact, b.track);
    });
}

void ContactTracker::solveNearestFirst(std::span<Pair> group) {
    std::sort(group.begin(), group.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.distance_m, a.contact, a.track) < std::tie(b.distance_m, b.contact, b.track);
    });
    for (const Pair& pair : group) {
        if (m_trackOf[pair.contact] != kNone || m_contactOf[pair.track] != kNone)
            continue;
        m_trackOf[pair.contact] = pair.track;
        m_contactOf[pair.track] = pair.contact;
    }
}

// The Hungarian method by shortest augmenting paths with potentials (Jonker and Volgenant 1987). Row and
// column 0 are the path's start; real rows (contacts) and columns (tracks) count from 1. The smaller side is
// padded with partners that cost the gate.
void ContactTracker::solveExactly(std::span<const Pair> group) {
    const std::size_t size = std::max(m_groupContacts.size(), m_groupTracks.size());
    const std::size_t stride = size + 1;
    m_cost_m.assign(stride * stride, m_settings.gate_m);
    for (const Pair& pair : group) {
        const std::size_t row = indexOf(m_groupContacts, pair.contact) + 1;
        const std::size_t column = indexOf(m_groupTracks, pair.track) + 1;
        m_cost_m[row * stride + column] = pair.distance_m;
    }
    m_rowPotential_m.assign(stride, 0.0);
    m_columnPotential_m.assign(stride, 0.0);
    m_rowOf.assign(stride, 0);
    m_before.assign(stride, 0);

    for (std::size_t start = 1; start <= size; ++start) {
        m_rowOf[0] = start;
        m_slack_m.assign(stride, std::numeric_limits<double>::infinity());
        m_visited.assign(stride, 0);
        std::size_t column = 0;
        do {
            m_visited[column] = 1;
            const std::size_t row = m_rowOf[column];
            double step_m = std::numeric_limits<double>::infinity();
            std::size_t next = 0;
            for (std::size_t j = 1; j <= size; ++j) {
                if (m_visited[j] != 0)
                    continue;
                const double reduced_m =
                    m_cost_m[row * stride + j] - m_rowPotential_m[row] - m_columnPotential_m[j];
                if (reduced_m < m_slack_m[j]) {
                    m_slack_m[j] = reduced_m;
                    m_before[j] = column;
                }
                if (m_slack_m[j] < step_m) {
                    step_m = m_slack_m[j];
                    next = j;
                }
            }
            for (std::size_t j = 0; j <= size; ++j) {
                if (m_visited[j] != 0) {
                    m_rowPotential_m[m_rowOf[j]] += step_m;
                    m_columnPotential_m[j] -= step_m;
                } else {
                    m_slack_m[j] -= step_m;
                }
            }
            column = next;
        } while (m_rowOf[column] != 0);
        for (; column != 0; column = m_before[column])
            m_rowOf[column] = m_rowOf[m_before[column]];
    }

    for (const Pair& pair : group) {
        const std::size_t row = indexOf(m_groupContacts, pair.contact) + 1;
        const std::size_t column = indexOf(m_groupTracks, pair.track) + 1;
        if (m_rowOf[column] == row) {
            m_trackOf[pair.contact] = pair.track;
            m_contactOf[pair.track] = pair.contact;
        }
    }
}

} // namespace teleta::contact
