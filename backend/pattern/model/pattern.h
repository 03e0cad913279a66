// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/pattern/model/parametric_object.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::pattern {

/// One corner of a track. easing is that of the segment that begins here.
struct Breakpoint {
    double time_s = 0.0;
    double intensity = 0.0; ///< 0..1
    Easing easing = Easing::linear;

    bool operator==(const Breakpoint&) const = default;
};

/// Intensity of one tactor over time. Times never decrease; two breakpoints at one time are a step. The
/// tactor is off before the first breakpoint and from the last one on.
using Track = std::vector<Breakpoint>;
using Tracks = std::array<Track, core::kTactors>;

/// What a pattern tells the wearer.
enum class Task { shape, stiffness, other };
enum class Condition { none, constant, dynamic };

/// The arm with the bracelet: counter-clockwise is outwards on one arm and inwards on the other.
enum class Arm { right, left };

/// A vibration pattern of six tactors. Tracks and objects play together; where they overlap on a tactor the
/// stronger one counts. Tactor i is at 60 i degrees, counted counter-clockwise.
struct Pattern {
    static constexpr double kLongest_s = 86400.0;
    static constexpr std::size_t kMostBreakpoints = 2'000'000; ///< of a track or a stroke
    static constexpr std::size_t kMostObjects = 10'000;

    std::string id;
    std::string name;
    Task task = Task::other;
    Condition condition = Condition::none;
    Arm arm = Arm::right;
    std::string notes;
    std::vector<std::string> tags;
    double duration_s = 0.0;
    Tracks tracks;
    std::vector<PatternObject> objects;
    UnknownKeys unknown;

    bool operator==(const Pattern&) const = default;
};

/// Names in files and on the command line: "shape"; "static" for Condition::constant, "" for none;
/// "ease-in-out".
[[nodiscard]] const char* toString(Task task);
[[nodiscard]] const char* toString(Condition condition);
[[nodiscard]] const char* toString(Arm arm);
[[nodiscard]] const char* toString(Easing easing);
[[nodiscard]] std::optional<Task> taskFrom(std::string_view text);
[[nodiscard]] std::optional<Condition> conditionFrom(std::string_view text);
[[nodiscard]] std::optional<Arm> armFrom(std::string_view text);
[[nodiscard]] std::optional<Easing> easingFrom(std::string_view text);

/// All six intensities at a time; the single source for drawing, preview, simulation, files and hardware. 0
/// before time 0, from the duration on, and at NaN. Values are always 0..1, whatever the breakpoints contain.
/// Takes O(log breakpoints + objects). Thread: any (pure).
[[nodiscard]] core::Intensities evaluate(const Pattern& pattern, double t_s);

/// The same values, prepared for many calls: one block of memory, and only objects that may be on are
/// evaluated. Thread: any (immutable).
class CompiledPattern {
public:
    CompiledPattern() = default;
    explicit CompiledPattern(const Pattern& pattern);

    [[nodiscard]] core::Intensities evaluate(double t_s) const;
    [[nodiscard]] double duration_s() const { return m_duration_s; }

private:
    struct CompiledObject {
        ObjectForm form;
        double begin_s = 0.0;
        double latestEnd_s = 0.0; ///< latest end of this object and all before it
    };

    double m_duration_s = 0.0;
    std::vector<double> m_times_s; ///< of all tracks, one after another
    std::vector<Breakpoint> m_breakpoints;
    std::array<std::size_t, core::kTactors + 1> m_firstOfTrack{};
    std::vector<CompiledObject> m_objects; ///< sorted by their begin
};

} // namespace teleta::pattern
