// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace teleta::ros {

enum class Reliability { bestEffort, reliable };
/// transientLocal: the writer hands its last samples to readers that come later ("latched").
enum class Durability { volatileData, transientLocal };

/// What an end of a topic offers or asks for. A reader never asks for a deadline, liveliness or lifespan: one
/// that does matches no ordinary ROS writer and gets nothing. Watchdogs are our own clocks.
struct QosProfile {
    Reliability reliability = Reliability::bestEffort;
    Durability durability = Durability::volatileData;
    int depth = 5; ///< samples that are kept (keep last); >= 1
    /// How long a reliable writer waits for a reader that is behind; the sample is then given up.
    double longestBlocking_s = 0.0;
    /// What a writer offers to readers that ask for it; 0: nothing.
    double deadline_s = 0.0;
    double livelinessLease_s = 0.0;

    [[nodiscard]] constexpr QosProfile withDepth(int samples) const {
        QosProfile profile = *this;
        profile.depth = samples;
        return profile;
    }
    [[nodiscard]] constexpr bool operator==(const QosProfile&) const = default;
};

/// What sensors send. A best-effort reader takes from every writer.
inline constexpr QosProfile kSensorReader{};
/// A reader that asks for reliable samples does not match it.
inline constexpr QosProfile kSensorWriter{};
/// Commands: the newest, to readers of either kind.
inline constexpr QosProfile kCommandWriter{Reliability::reliable, Durability::volatileData, 1, 0.005};
/// What is said once and holds, for example a robot's description.
inline constexpr QosProfile kLatchedReader{Reliability::reliable, Durability::transientLocal, 1, 0.005};
inline constexpr QosProfile kLatchedWriter = kLatchedReader;

/// Why a reader and a writer of one topic do not find each other.
enum class QosMismatch {
    reliability, ///< the writer is best effort, the reader asks for reliable
    durability,  ///< the writer keeps nothing, the reader asks for what came before it
    other,       ///< a policy that the profiles do not hold: deadline, liveliness, ...
};

/// Nothing: they match. Thread: any (pure). Source: OMG DDS 1.4, 2.2.3 (requested against offered).
[[nodiscard]] constexpr std::optional<QosMismatch> mismatch(const QosProfile& asked,
                                                            const QosProfile& offered) {
    if (asked.reliability > offered.reliability)
        return QosMismatch::reliability;
    if (asked.durability > offered.durability)
        return QosMismatch::durability;
    return std::nullopt;
}

} // namespace teleta::ros
