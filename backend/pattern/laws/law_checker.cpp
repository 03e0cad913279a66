// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/laws/law_checker.h"

#include "backend/pattern/model/laws.h"
#include "backend/pattern/motors/sampled_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace teleta::pattern {

namespace {

constexpr double kSame_Hz = 0.05;  ///< a beat slower than 20 s is not felt
constexpr double kLook_s = 0.005;  ///< between two looks at the speeds
constexpr double kRounding = 1e-9; ///< that a value may be beyond a limit
constexpr double kStrokeLook_s = 0.001;
constexpr int kFewestLooks = 1000;
constexpr int kMostLooks = 20'000;
constexpr double kFeltShare = 0.5;      ///< of a stroke's intensity
constexpr double kStretchMargin = 1.05; ///< that a stroke is stretched beyond what looks say
constexpr double kLeastShare = 0.05;    ///< of its intensity that a motor is left

std::vector<int> allTactors() {
    return {0, 1, 2, 3, 4, 5};
}

class Checker {
public:
    Checker(const Pattern& pattern, const MotorProfiles& motors, const std::atomic<bool>* cancelled)
        : m_pattern(pattern)
        , m_motors(motors)
        , m_cancelled(cancelled) {}

    std::vector<Finding> check() {
        for (m_object = 0; m_object < m_pattern.objects.size(); ++m_object) {
            const ObjectForm& form = m_pattern.objects[m_object].form;
            std::visit([this](const auto& object) { checkForm(object); }, form);
            const Span span = spanOf(form);
            if (!std::holds_alternative<Ring>(form) || std::get<Ring>(form).duration_s > 0.0)
                checkEnd(span, m_object);
            checkSharing(form);
        }
        checkTracks();
        checkBeats();
        return std::move(m_findings);
    }

private:
    void add(Finding finding) {
        if (m_findings.size() < kMostFindings)
            m_findings.push_back(std::move(finding));
    }

    double slowestRise_s(const std::vector<int>& tactors) const {
        double slowest_s = 0.0;
        for (const int tactor : tactors)
            slowest_s = std::max(slowest_s, m_motors[static_cast<std::size_t>(tactor) % 6].riseTime_s);
        return slowest_s;
    }

    /// turns: the suggestion for a ring; for all other objects it is a longer burst.
    void checkBurst(double burst_s, const std::vector<int>& tactors, std::optional<double> turns = {}) {
        const double rise_s = slowestRise_s(tactors);
        if (!tactors.empty() && burst_s < rise_s - kRounding)
            add({Law::burstTooShort, m_object, tactors, spanOf(m_pattern.objects[m_object].form), burst_s,
                 rise_s, turns.value_or(rise_s), turns.has_value()});
    }

    void checkOnset(double onset_s, double burst_s, const std::vector<int>& tactors) {
        const double lawful_s = apparentMotionOnset_s(burst_s);
        if (std::abs(onset_s - lawful_s) > kOnsetTolerance * lawful_s + kRounding)
            add({Law::onsetOffLaw, m_object, tactors, spanOf(m_pattern.objects[m_object].form), onset_s,
                 lawful_s, lawful_s});
    }

    void checkForm(const Sweep& sweep) {
        checkBurst(sweep.burst_s, sweep.tactors);
        if (sweep.onset_s && sweep.tactors.size() > 1)
            checkOnset(*sweep.onset_s, sweep.burst_s, sweep.tactors);
    }

    void checkForm(const Ring& ring) {
        if (ring.turns <= 0)
            return; // plays nothing
        const double turn_s = ring.duration_s / ring.turns;
        const double possible = std::floor(ring.duration_s / kShortestTurn_s + kRounding);
        if (turn_s < kShortestTurn_s - kRounding) {
            add({Law::ringTooFast, m_object, allTactors(), spanOf(ObjectForm(ring)), turn_s, kShortestTurn_s,
                 possible >= 1.0 ? possible : kShortestTurn_s, possible >= 1.0});
            return; // the bursts of a ring that is too fast follow from that
        }
        if (ring.burst_s)
            checkOnset(onsetOf_s(ring), *ring.burst_s, allTactors());
        const double burst_s = burstOf_s(ring);
        const double rise_s = slowestRise_s(allTactors());
        double turns = ring.turns;
        while (turns > 1.0 && ringBurst_s(static_cast<int>(turns), ring.duration_s).value_or(0.0) < rise_s)
            turns -= 1.0;
        checkBurst(burst_s, allTactors(), turns);
    }

    void checkForm(const Ramp& ramp) { checkBurst(ramp.duration_s, ramp.tactors); }
    void checkForm(const PulseTrain& train) { checkBurst(train.width_s, train.tactors); }
    void checkForm(const Phantom& phantom) {
        checkBurst(phantom.duration_s, {phantom.first, phantom.second});
    }

    /// A motor is on for as long as the moving point is near it.
    void checkForm(const Stroke& stroke) {
        const ObjectForm form(stroke);
        const Span span = spanOf(form);
        const double length_s = span.end_s - span.begin_s;
        if (!(length_s > 0.0))
            return;
        struct Passing {
            int looks = 0;
            double peak = 0.0;
        };
        std::array<Passing, core::kTactors> passings{};
        Finding worst;
        worst.object = m_object;
        worst.span = span;
        double lack = 1.0;
        const int looks =
            static_cast<int>(std::clamp(length_s / kStrokeLook_s, 1.0 * kFewestLooks, 1.0 * kMostLooks));
        const double look_s = length_s / looks;
        const auto end = [&](std::size_t i) {
            const Passing passing = std::exchange(passings[i], {});
            if (passing.looks == 0)
                return;
            const double dwell_s = passing.looks * look_s;
            const double rise_s = m_motors[i].riseTime_s;
            // A motor at the edge of the path is hardly felt anyway.
            if (passing.peak < kFeltShare * stroke.intensity || dwell_s + look_s >= rise_s)
                return;
            worst.tactors.push_back(static_cast<int>(i));
            if (rise_s / dwell_s <= lack)
                return;
            lack = rise_s / dwell_s;
            worst.value = dwell_s;
            worst.limit = rise_s;
        };
        for (int k = 0; k < looks; ++k) {
            const core::Intensities intensities = evaluate(form, span.begin_s + (k + 0.5) * look_s);
            for (std::size_t i = 0; i < core::kTactors; ++i) {
                if (intensities[i] > 0.0) {
                    ++passings[i].looks;
                    passings[i].peak = std::max(passings[i].peak, intensities[i]);
                } else {
                    end(i);
                }
            }
        }
        for (std::size_t i = 0; i < core::kTactors; ++i)
            end(i);
        if (worst.tactors.empty())
            return;
        std::ranges::sort(worst.tactors);
        worst.tactors.erase(std::unique(worst.tactors.begin(), worst.tactors.end()), worst.tactors.end());
        worst.suggestion = length_s * lack * kStretchMargin;
        add(std::move(worst));
    }

    void checkEnd(const Span& span, std::optional<std::size_t> object, std::vector<int> tactors = {}) {
        if (span.end_s > m_pattern.duration_s + kRounding)
            add({Law::cutOff, object, std::move(tactors), span, span.end_s, m_pattern.duration_s,
                 span.end_s});
    }

    /// Tactors that a phantom or a stroke may use; empty for other objects.
    static std::vector<int> movedBetween(const ObjectForm& form) {
        const bool moves = std::holds_alternative<Phantom>(form) || std::holds_alternative<Stroke>(form);
        return moves ? listedTactors(form) : std::vector<int>();
    }

    void checkSharing(const ObjectForm& form) {
        const std::vector<int> mine = movedBetween(form);
        if (mine.empty())
            return;
        const Span span = spanOf(form);
        for (std::size_t other = 0; other < m_object; ++other) {
            const ObjectForm& before = m_pattern.objects[other].form;
            const Span theirs = spanOf(before);
            const Span both{std::max(span.begin_s, theirs.begin_s), std::min(span.end_s, theirs.end_s)};
            std::vector<int> shared;
            for (const int tactor : movedBetween(before)) {
                if (std::ranges::find(mine, tactor) != mine.end())
                    shared.push_back(tactor);
            }
            if (!shared.empty() && both.begin_s < both.end_s)
                add({Law::sharedPhantoms, m_object, shared, both, static_cast<double>(other), 0.0,
                     theirs.end_s});
        }
    }

    /// Checks the intervals of each track in which the tactor is on.
    void checkTracks() {
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            const Track& track = m_pattern.tracks[i];
            const int tactor = static_cast<int>(i);
            if (!track.empty())
                checkEnd({track.front().time_s, track.back().time_s}, {}, {tactor});
            bool wasOn = false;
            double begin_s = 0.0;
            for (std::size_t k = 1; k < track.size(); ++k) {
                const Breakpoint& from = track[k - 1];
                const Breakpoint& to = track[k];
                if (!(from.time_s < to.time_s))
                    continue;
                const bool on = from.intensity > 0.0 || (from.easing != Easing::hold && to.intensity > 0.0);
                if (on && !wasOn)
                    begin_s = from.time_s;
                if (!on && wasOn)
                    checkStretch(begin_s, from.time_s, tactor);
                wasOn = on;
            }
            if (wasOn)
                checkStretch(begin_s, track.back().time_s, tactor);
        }
    }

    void checkStretch(double begin_s, double end_s, int tactor) {
        const double rise_s = m_motors[static_cast<std::size_t>(tactor)].riseTime_s;
        if (end_s - begin_s < rise_s - kRounding)
            add({Law::burstTooShort, {}, {tactor}, {begin_s, end_s}, end_s - begin_s, rise_s, rise_s});
    }

    /// Factor on the intensity of the slower motor of a pair at which their speeds are far enough apart; 0:
    /// there is none.
    double shareOffBeat(std::size_t slower, double intensity, double other_Hz) const {
        const MotorProfile& motor = m_motors[slower];
        const auto speed_Hz = [&](double share) {
            return steadySpeed_Hz(motor, driveOf(motor, share * intensity));
        };
        const double wanted_Hz = other_Hz - kBeatBand_Hz;
        if (!(wanted_Hz > speed_Hz(kLeastShare)))
            return 0.0;
        double low = kLeastShare, high = 1.0;
        for (int k = 0; k < 30; ++k)
            (speed_Hz(0.5 * (low + high)) > wanted_Hz ? high : low) = 0.5 * (low + high);
        return low;
    }

    /// Whether only tracks drive the motor in the span; a weaker track does not help if an object drives it,
    /// too.
    bool onlyByTracks(std::size_t tactor, const Span& span) const {
        return std::ranges::none_of(m_pattern.objects, [&](const PatternObject& object) {
            const Span theirs = spanOf(object.form);
            if (std::max(theirs.begin_s, span.begin_s) >= std::min(theirs.end_s, span.end_s))
                return false;
            const std::vector<int> used = listedTactors(object.form);
            return std::ranges::find(used, static_cast<int>(tactor)) != used.end();
        });
    }

    /// Counts the periods of the beat of each pair while their speeds stay close together.
    void checkBeats() {
        struct Beat {
            double periods = 0.0;
            double begin_s = 0.0;
            double largest_Hz = 0.0;
            std::size_t slower = 0;
            double share = 1.0;          ///< of its intensity that ends the beat
            double seen[2] = {0.0, 0.0}; ///< intensities for which the share is known
        };
        std::array<std::array<Beat, core::kTactors>, core::kTactors> beats{};
        const auto end = [&](std::size_t i, std::size_t j, double t_s) {
            Beat& beat = beats[i][j];
            if (beat.periods >= 1.0) {
                Finding finding{Law::beating,
                                {},
                                {static_cast<int>(i), static_cast<int>(j)},
                                {beat.begin_s, t_s},
                                beat.largest_Hz,
                                kBeatBand_Hz,
                                {}};
                if (beat.share > 0.0 && onlyByTracks(beat.slower, finding.span)) {
                    finding.suggestion = beat.share;
                    finding.weaker = static_cast<int>(beat.slower);
                }
                add(std::move(finding));
            }
            beat = {};
        };
        forEachSample(m_pattern, 1.0 / kLook_s, [&](double t_s, const core::Intensities& intensities) {
            core::Intensities speeds_Hz{};
            for (std::size_t i = 0; i < core::kTactors; ++i)
                speeds_Hz[i] = steadySpeed_Hz(m_motors[i], driveOf(m_motors[i], intensities[i]));
            for (std::size_t i = 0; i < core::kTactors; ++i) {
                for (std::size_t j = i + 1; j < core::kTactors; ++j) {
                    const double apart_Hz = std::abs(speeds_Hz[i] - speeds_Hz[j]);
                    Beat& beat = beats[i][j];
                    if (speeds_Hz[i] > 0.0 && speeds_Hz[j] > 0.0 && apart_Hz < kBeatBand_Hz &&
                        apart_Hz > kSame_Hz) {
                        if (beat.periods == 0.0) {
                            beat.begin_s = t_s;
                            beat.slower = speeds_Hz[i] < speeds_Hz[j] ? i : j;
                        }
                        // Most beats are steady, so the factor is computed only when an intensity changes.
                        if (beat.seen[0] != intensities[i] || beat.seen[1] != intensities[j]) {
                            beat.seen[0] = intensities[i];
                            beat.seen[1] = intensities[j];
                            const std::size_t faster = beat.slower == i ? j : i;
                            beat.share =
                                std::min(beat.share, shareOffBeat(beat.slower, intensities[beat.slower],
                                                                  speeds_Hz[faster]));
                        }
                        beat.periods += apart_Hz * kLook_s;
                        beat.largest_Hz = std::max(beat.largest_Hz, apart_Hz);
                    } else {
                        end(i, j, t_s);
                    }
                }
            }
            return m_findings.size() < kMostFindings &&
                   (m_cancelled == nullptr || !m_cancelled->load(std::memory_order_relaxed));
        });
        for (std::size_t i = 0; i < core::kTactors; ++i) {
            for (std::size_t j = i + 1; j < core::kTactors; ++j)
                end(i, j, m_pattern.duration_s);
        }
    }

    const Pattern& m_pattern;
    const MotorProfiles& m_motors;
    const std::atomic<bool>* m_cancelled;
    std::size_t m_object = 0;
    std::vector<Finding> m_findings;
};

void setBurst(ObjectForm& form, double value) {
    if (auto* sweep = std::get_if<Sweep>(&form))
        sweep->burst_s = value;
    if (auto* train = std::get_if<PulseTrain>(&form)) {
        train->width_s = value;
        train->period_s = std::max(train->period_s, value);
    }
    if (auto* ramp = std::get_if<Ramp>(&form))
        ramp->duration_s = value;
    if (auto* phantom = std::get_if<Phantom>(&form))
        phantom->duration_s = value;
    if (auto* ring = std::get_if<Ring>(&form)) {
        ring->turns = static_cast<int>(value);
        ring->burst_s.reset();
    }
    if (auto* stroke = std::get_if<Stroke>(&form)) {
        const Span span = spanOf(form);
        for (StrokePoint& point : stroke->points)
            point.time_s *= value / (span.end_s - span.begin_s);
    }
}

/// Makes the ring a single turn of this duration.
void setTurn(ObjectForm& form, double turn_s) {
    if (auto* ring = std::get_if<Ring>(&form)) {
        ring->turns = 1;
        ring->duration_s = turn_s;
        ring->burst_s.reset();
    }
}

/// Stretches what lies in a span to this length; what follows stays where it is, or begins when this ends.
void lengthen(Track& track, const Span& span, double length_s) {
    const double factor = length_s / (span.end_s - span.begin_s);
    for (Breakpoint& point : track) {
        if (point.time_s > span.end_s)
            point.time_s = std::max(point.time_s, span.begin_s + length_s);
        else if (point.time_s > span.begin_s)
            point.time_s = span.begin_s + (point.time_s - span.begin_s) * factor;
    }
}

/// Reduces the intensity of all segments that lie at least partly in a span.
void weaken(Track& track, const Span& span, double share) {
    const auto first = std::ranges::upper_bound(track, span.begin_s, {}, &Breakpoint::time_s);
    const auto last = std::ranges::lower_bound(track, span.end_s, {}, &Breakpoint::time_s);
    for (auto point = first == track.begin() ? first : std::prev(first);
         point != track.end() && point <= last; ++point)
        point->intensity *= share;
}

void followLaw(ObjectForm& form) {
    if (auto* sweep = std::get_if<Sweep>(&form))
        sweep->onset_s.reset();
    if (auto* ring = std::get_if<Ring>(&form))
        ring->burst_s.reset();
}

void startAt(ObjectForm& form, double begin_s) {
    std::visit([shift_s = begin_s - spanOf(form).begin_s](auto& object) { object.start_s += shift_s; }, form);
}

} // namespace

std::vector<Finding> checkLaws(const Pattern& pattern, const MotorProfiles& motors,
                               const std::atomic<bool>* cancelled) {
    return Checker(pattern, motors, cancelled).check();
}

std::optional<Pattern> fixed(const Pattern& pattern, const Finding& finding) {
    if (!finding.suggestion || (finding.object && *finding.object >= pattern.objects.size()))
        return std::nullopt;
    Pattern better = pattern;
    if (finding.law == Law::cutOff) {
        better.duration_s = *finding.suggestion;
        return better;
    }
    if (!finding.object) {
        const int motor = finding.law == Law::beating ? finding.weaker : finding.tactors.at(0);
        if (motor < 0 || motor >= static_cast<int>(core::kTactors))
            return std::nullopt;
        Track& track = better.tracks[static_cast<std::size_t>(motor)];
        if (track.empty())
            return std::nullopt;
        if (finding.law == Law::beating)
            weaken(track, finding.span, *finding.suggestion);
        else
            lengthen(track, finding.span, *finding.suggestion);
        better.duration_s = std::max(better.duration_s, track.back().time_s);
        return better;
    }
    ObjectForm& form = better.objects[*finding.object].form;
    switch (finding.law) {
    case Law::burstTooShort:
        setBurst(form, *finding.suggestion);
        break;
    case Law::ringTooFast:
        (finding.suggestsTurns ? setBurst : setTurn)(form, *finding.suggestion);
        break;
    case Law::onsetOffLaw:
        followLaw(form);
        break;
    case Law::sharedPhantoms:
        startAt(form, *finding.suggestion);
        break;
    case Law::beating:
    case Law::cutOff:
        return std::nullopt;
    }
    better.duration_s = std::max(better.duration_s, spanOf(form).end_s);
    return better;
}

} // namespace teleta::pattern
