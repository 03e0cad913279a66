// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"

#include <array>
#include <string>

namespace teleta::pattern {

namespace {

constexpr double kShown_s = 2.0;
constexpr double kBesideMiddle = 0.5; ///< of an arc, to 1 in the middle

struct ShapeStimulus {
    char letter;
    const char* name;
    std::vector<std::size_t> tactors; ///< counter-clockwise
};

struct ImpulseStimulus {
    const char* name;
    double duration_s;
};

const std::vector<ShapeStimulus>& shapes() {
    static const std::vector<ShapeStimulus> kShapes{{'A', "Circle", {0, 1, 2, 3, 4, 5}},
                                                    {'B', "Rectangle", {1, 2, 4, 5}},
                                                    {'C', "Triangle", {0, 2, 4}},
                                                    {'D', "Arc", {5, 0, 1}},
                                                    {'E', "Line", {0, 3}},
                                                    {'F', "Point", {0}}};
    return kShapes;
}

/// The paper gives 0.3 s for the stiffest and 2 s for the sponge; the levels between have even ratios.
constexpr std::array<ImpulseStimulus, 5> kStiffness{
    {{"Sponge", 2.0}, {"Rubber sponge", 1.2}, {"Rubber", 0.75}, {"Wood", 0.48}, {"Metal", 0.3}}};

Pattern named(const std::string& group, char letter, const char* name, Task task, Condition condition) {
    Pattern pattern;
    pattern.id = group + '.' + letter + '.' + toString(condition);
    pattern.name = std::string(name) + ", " + toString(condition);
    pattern.task = task;
    pattern.condition = condition;
    pattern.tags = {"built-in", "TeleTA"};
    pattern.duration_s = kShown_s;
    return pattern;
}

Track constant(double begin_s, double end_s, double intensity) {
    return {{begin_s, intensity}, {end_s, intensity}};
}

Track swell(double duration_s, double peak) {
    return {{0.0, 0.0, Easing::easeInOut}, {0.5 * duration_s, peak, Easing::easeInOut}, {duration_s, 0.0}};
}

Track ramp(double duration_s, double from, double to) {
    return {{0.0, from}, {duration_s, to}};
}

Pattern constantShape(const ShapeStimulus& shape) {
    Pattern pattern = named("shape", shape.letter, shape.name, Task::shape, Condition::constant);
    for (const std::size_t tactor : shape.tactors)
        pattern.tracks[tactor] = constant(0.0, kShown_s, 1.0);
    return pattern;
}

Pattern dynamicShape(const ShapeStimulus& shape) {
    Pattern pattern = named("shape", shape.letter, shape.name, Task::shape, Condition::dynamic);
    const std::vector<std::size_t>& tactors = shape.tactors;
    switch (shape.letter) {
    case 'D':
        pattern.tracks[tactors[0]] = swell(kShown_s, kBesideMiddle);
        pattern.tracks[tactors[1]] = swell(kShown_s, 1.0);
        pattern.tracks[tactors[2]] = swell(kShown_s, kBesideMiddle);
        break;
    case 'E':
        pattern.tracks[tactors[0]] = ramp(kShown_s, 1.0, 0.0);
        pattern.tracks[tactors[1]] = ramp(kShown_s, 0.0, 1.0);
        break;
    case 'F':
        pattern.tracks[tactors[0]] = ramp(kShown_s, 0.0, 1.0);
        break;
    default: {
        const auto count = static_cast<double>(tactors.size());
        for (std::size_t k = 0; k < tactors.size(); ++k) {
            const auto turn = static_cast<double>(k);
            pattern.tracks[tactors[k]] =
                constant(turn * kShown_s / count, (turn + 1.0) * kShown_s / count, 1.0);
        }
    }
    }
    return pattern;
}

Pattern stiffness(int level, Condition condition) {
    const ImpulseStimulus& stimulus = kStiffness[static_cast<std::size_t>(level - 1)];
    Pattern pattern =
        named("stiffness", static_cast<char>('A' + level - 1), stimulus.name, Task::stiffness, condition);
    const double intensity = levelIntensity(level);
    Track track;
    if (condition == Condition::constant) {
        track = constant(0.0, kShown_s, intensity);
    } else {
        pattern.duration_s = stimulus.duration_s;
        track =
            level == 1 ? swell(stimulus.duration_s, intensity) : ramp(stimulus.duration_s, 0.0, intensity);
    }
    pattern.tracks.fill(track);
    return pattern;
}

/// Three short swells of all tactors: no level of the stiffness feels like it, and it has no place in a
/// study.
Pattern makeUnknownStiffness() {
    constexpr double kPulse_s = 0.2;
    constexpr double kApart_s = 0.35;
    constexpr double kIntensity = 0.6;
    Pattern pattern = named("stiffness", 'U', "Unknown stiffness", Task::other, Condition::dynamic);
    pattern.id = std::string(kUnknownStiffnessId);
    pattern.tags = {"built-in"};
    pattern.duration_s = 2.0 * kApart_s + kPulse_s;
    Track track;
    for (const double begin_s : {0.0, kApart_s, 2.0 * kApart_s}) {
        track.push_back({begin_s, 0.0, Easing::easeInOut});
        track.push_back({begin_s + 0.5 * kPulse_s, kIntensity, Easing::easeInOut});
        track.push_back({begin_s + kPulse_s, 0.0});
    }
    pattern.tracks.fill(track);
    return pattern;
}

std::vector<Pattern> makePatterns() {
    std::vector<Pattern> patterns;
    for (const ShapeStimulus& shape : shapes())
        patterns.push_back(constantShape(shape));
    for (const ShapeStimulus& shape : shapes())
        patterns.push_back(dynamicShape(shape));
    for (const Condition condition : {Condition::constant, Condition::dynamic}) {
        for (int level = 1; level <= 5; ++level)
            patterns.push_back(stiffness(level, condition));
    }
    return patterns;
}

} // namespace

std::span<const Pattern> builtInPatterns() {
    static const std::vector<Pattern> kPatterns = makePatterns();
    return kPatterns;
}

const Pattern& unknownStiffness() {
    static const Pattern kPattern = makeUnknownStiffness();
    return kPattern;
}

const Pattern* findBuiltIn(std::string_view id) {
    if (id == kUnknownStiffnessId)
        return &unknownStiffness();
    for (const Pattern& pattern : builtInPatterns()) {
        if (pattern.id == id)
            return &pattern;
    }
    return nullptr;
}

} // namespace teleta::pattern
