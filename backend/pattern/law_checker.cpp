// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/law_checker.h"

#include "backend/pattern/laws.h"
#include "backend/pattern/sampled_output.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace teleta::pattern {

namespace {

constexpr double kSame_Hz = 0.05;  ///< a beat slower than 20 s is not felt
constexpr double kLook_s = 0.005;  ///< between two looks at the speeds
constexpr double kRounding = 1e-9; ///< that a value may be beyond a limit

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

    /// turns: what a ring is advised; all others a longer burst.
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
                 possible >= 1.0 ? std::optional(possible) : std::nullopt, true});
            return; // what a ring that is too fast does with its bursts follows from that
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
    void checkForm(const Stroke&) {}

    void checkEnd(const Span& span, std::optional<std::size_t> object, std::vector<int> tactors = {}) {
        if (span.end_s > m_pattern.duration_s + kRounding)
            add({Law::cutOff, object, std::move(tactors), span, span.end_s, m_pattern.duration_s,
                 span.end_s});
    }

    /// Tactors that a phantom or a stroke may use; empty for other objects.
    static std::vector<int> movedBetween(const ObjectForm& form) {
        if (const auto* phantom = std::get_if<Phantom>(&form))
            return {phantom->first, phantom->second};
        return std::holds_alternative<Stroke>(form) ? allTactors() : std::vector<int>();
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
                if (std::find(mine.begin(), mine.end(), tactor) != mine.end())
                    shared.push_back(tactor);
            }
            if (!shared.empty() && both.begin_s < both.end_s)
                add({Law::sharedPhantoms, m_object, shared, both, static_cast<double>(other), 0.0,
                     theirs.end_s});
        }
    }

    /// Stretches of a track in which the tactor is on.
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
            add({Law::burstTooShort, {}, {tactor}, {begin_s, end_s}, end_s - begin_s, rise_s, {}});
    }

    /// Counts periods of the beat of each pair, as long as their speeds stay near to each other.
    void checkBeats() {
        struct Beat {
            double periods = 0.0;
            double begin_s = 0.0;
            double largest_Hz = 0.0;
        };
        std::array<std::array<Beat, core::kTactors>, core::kTactors> beats{};
        const auto end = [&](std::size_t i, std::size_t j, double t_s) {
            Beat& beat = beats[i][j];
            if (beat.periods >= 1.0)
                add({Law::beating,
                     {},
                     {static_cast<int>(i), static_cast<int>(j)},
                     {beat.begin_s, t_s},
                     beat.largest_Hz,
                     kBeatBand_Hz,
                     {}});
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
                        if (beat.periods == 0.0)
                            beat.begin_s = t_s;
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
    if (!finding.object)
        return std::nullopt;
    ObjectForm& form = better.objects[*finding.object].form;
    switch (finding.law) {
    case Law::burstTooShort:
        setBurst(form, *finding.suggestion);
        break;
    case Law::ringTooFast:
        setBurst(form, *finding.suggestion);
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
