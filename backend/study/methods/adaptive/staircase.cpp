// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/methods/adaptive/staircase.h"

#include <algorithm>

namespace teleta::study {

namespace {

enum class Move { none, down, up };

/// The state of a staircase, on the scale.
struct Steps {
    double place = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    std::size_t inARow = 0;
    std::size_t stuck = 0; ///< moves in a row that changed nothing
    Move last = Move::none;
};

/// Cut off by the range; what is left of a step by rounding is no step.
double within(double place, double lowest, double highest) {
    const double rounding = 1e-9 * (highest - lowest);
    if (place < lowest + rounding)
        return lowest;
    return place > highest - rounding ? highest : place;
}

} // namespace

std::optional<double> reversalEstimate(const StaircaseSettings& settings, LevelScale scale,
                                       std::span<const double> reversalLevels) {
    if (reversalLevels.size() < settings.skipReversals + 2)
        return std::nullopt;
    std::span<const double> used = reversalLevels.subspan(settings.skipReversals);
    used = used.subspan(used.size() % 2);
    double sum = 0.0;
    for (const double level : used)
        sum += onScale(scale, level);
    return fromScale(scale, sum / static_cast<double>(used.size()));
}

StaircaseTrack staircaseTrack(const StaircaseSettings& settings, const LevelRange& range,
                              std::span<const KeptTrial> kept) {
    StaircaseTrack track;
    std::vector<double> reversalLevels;
    Steps steps;
    steps.lowest = onScale(range.scale, range.lowest);
    steps.highest = onScale(range.scale, range.highest);
    steps.place = std::clamp(onScale(range.scale, settings.first), steps.lowest, steps.highest);
    // The ends of the range and the first level are shown as they are written, without a rounding error.
    const auto levelNow = [&] {
        if (steps.place == steps.lowest)
            return range.lowest;
        if (steps.place == steps.highest)
            return range.highest;
        return steps.last == Move::none ? settings.first : fromScale(range.scale, steps.place);
    };
    const auto end = [&](EndReason reason, TrackNote note) {
        TrackEnd over{reason};
        over.note = note;
        if (note == TrackNote::none) {
            over.estimate = reversalEstimate(settings, range.scale, reversalLevels);
            over.note = over.estimate ? TrackNote::none : TrackNote::tooFewReversals;
        }
        track.next = over;
        return track;
    };
    for (const KeptTrial& trial : kept) {
        if (!trial.counts)
            continue;
        track.levels.push_back(levelNow());
        steps.inARow = trial.correct ? steps.inARow + 1 : 0;
        Move move = Move::none;
        if (!trial.correct)
            move = Move::up;
        else if (steps.inARow == settings.down)
            move = Move::down;
        if (move != Move::none) {
            steps.inARow = 0;
            if (steps.last != Move::none && move != steps.last) {
                track.reversals.push_back(track.levels.size() - 1);
                reversalLevels.push_back(track.levels.back());
            }
            const double factor = reversalLevels.size() < settings.fastReversals ? settings.fastFactor : 1.0;
            const double wanted = move == Move::up ? steps.place + settings.stepUp * factor
                                                   : steps.place - settings.stepDown * factor;
            const double before = steps.place;
            steps.place = within(wanted, steps.lowest, steps.highest);
            steps.last = move;
            steps.stuck = steps.place == before ? steps.stuck + 1 : 0;
            if (steps.stuck == 3) {
                return move == Move::up ? end(EndReason::atCeiling, TrackNote::atCeiling)
                                        : end(EndReason::atFloor, TrackNote::atFloor);
            }
        }
        if (reversalLevels.size() == settings.reversals)
            return end(EndReason::reversals, TrackNote::none);
        if (track.levels.size() == settings.mostTrials)
            return end(EndReason::mostTrials, TrackNote::none);
    }
    track.next = NextLevel{levelNow()};
    return track;
}

} // namespace teleta::study
