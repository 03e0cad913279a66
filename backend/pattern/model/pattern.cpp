// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/pattern.h"

#include "backend/core/words.h"
#include "backend/pattern/model/easing.h"

#include <algorithm>

namespace teleta::pattern {

namespace {

constexpr core::Words<Task, 3> kTasks{{"shape", "stiffness", "other"}};
constexpr core::Words<Condition, 3> kConditions{{"", "static", "dynamic"}};
constexpr core::Words<Arm, 2> kArms{{"right", "left"}};
constexpr core::Words<Easing, 5> kEasings{{"linear", "hold", "ease-in", "ease-out", "ease-in-out"}};

/// a.time_s <= t_s < b.time_s.
double between(const Breakpoint& a, const Breakpoint& b, double t_s) {
    const double share = eased(a.easing, (t_s - a.time_s) / (b.time_s - a.time_s));
    return limitedIntensity(a.intensity + share * (b.intensity - a.intensity));
}

void raise(core::Intensities& intensities, const core::Intensities& other) {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        intensities[i] = std::max(intensities[i], other[i]);
}

} // namespace

const char* toString(Task task) {
    return kTasks.of(task);
}
const char* toString(Condition condition) {
    return kConditions.of(condition);
}
const char* toString(Arm arm) {
    return kArms.of(arm);
}
const char* toString(Easing easing) {
    return kEasings.of(easing);
}
std::optional<Task> taskFrom(std::string_view text) {
    return kTasks.find(text);
}
std::optional<Condition> conditionFrom(std::string_view text) {
    return kConditions.find(text);
}
std::optional<Arm> armFrom(std::string_view text) {
    return kArms.find(text);
}
std::optional<Easing> easingFrom(std::string_view text) {
    return kEasings.find(text);
}

core::Intensities evaluate(const Pattern& pattern, double t_s) {
    core::Intensities intensities{};
    if (!(t_s >= 0.0 && t_s < pattern.duration_s))
        return intensities;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const Track& track = pattern.tracks[i];
        const auto next = std::ranges::upper_bound(track, t_s, {}, &Breakpoint::time_s);
        if (next != track.begin() && next != track.end())
            intensities[i] = between(*(next - 1), *next, t_s);
    }
    for (const PatternObject& object : pattern.objects)
        raise(intensities, evaluate(object.form, t_s));
    return intensities;
}

CompiledPattern::CompiledPattern(const Pattern& pattern)
    : m_duration_s(pattern.duration_s) {
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        m_breakpoints.insert(m_breakpoints.end(), pattern.tracks[i].begin(), pattern.tracks[i].end());
        m_firstOfTrack[i + 1] = m_breakpoints.size();
    }
    m_times_s.reserve(m_breakpoints.size());
    for (const Breakpoint& point : m_breakpoints)
        m_times_s.push_back(point.time_s);

    for (const PatternObject& object : pattern.objects) {
        const Span span = spanOf(object.form);
        if (span.begin_s < span.end_s) // an object of zero duration is never on
            m_objects.push_back({object.form, span.begin_s, span.end_s});
    }
    std::ranges::stable_sort(m_objects, {}, &CompiledObject::begin_s);
    for (std::size_t i = 1; i < m_objects.size(); ++i)
        m_objects[i].latestEnd_s = std::max(m_objects[i].latestEnd_s, m_objects[i - 1].latestEnd_s);
}

core::Intensities CompiledPattern::evaluate(double t_s) const {
    core::Intensities intensities{};
    if (!(t_s >= 0.0 && t_s < m_duration_s))
        return intensities;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const double* const begin = m_times_s.data() + m_firstOfTrack[i];
        const double* const end = m_times_s.data() + m_firstOfTrack[i + 1];
        const double* const next = std::upper_bound(begin, end, t_s);
        if (next != begin && next != end) {
            const auto index = static_cast<std::size_t>(next - m_times_s.data());
            intensities[i] = between(m_breakpoints[index - 1], m_breakpoints[index], t_s);
        }
    }
    auto object = std::ranges::upper_bound(m_objects, t_s, {}, &CompiledObject::begin_s);
    while (object != m_objects.begin() && (object - 1)->latestEnd_s > t_s) {
        --object;
        raise(intensities, pattern::evaluate(object->form, t_s));
    }
    return intensities;
}

} // namespace teleta::pattern
