// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/study/stimulus_bracelet.h"

#include "backend/core/random_stream.h"
#include "backend/core/steady_time.h"
#include "backend/study/protocol/trial_order.h"

#include <algorithm>
#include <cmath>

namespace teleta::scene_run {

namespace {

/// Random stream of a trial, other than those of SimulatedParticipant.
constexpr std::uint64_t kDroppedFrames = 4;
constexpr double kFullSpeed_Hz = 250.0;
/// A motor with a lag and no dead zone.
constexpr double kNoStart = 1e-9;

pattern::MotorProfile motorOf(const study::StudyScene::MotorLag& lag) {
    pattern::MotorProfile motor;
    motor.startDrive = kNoStart;
    motor.riseTime_s = lag.rise_s;
    motor.fallTime_s = lag.fall_s;
    motor.curve = {{kNoStart, kNoStart * kFullSpeed_Hz}, {1.0, kFullSpeed_Hz}};
    return motor;
}

/// Adds its lifetime to the time of an effect.
class Stopwatch {
public:
    explicit Stopwatch(std::int64_t& total_ns)
        : m_total_ns(total_ns)
        , m_start_ns(core::steadyNow_ns()) {}
    ~Stopwatch() { m_total_ns += core::steadyNow_ns() - m_start_ns; }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    std::int64_t& m_total_ns;
    std::int64_t m_start_ns;
};

} // namespace

StimulusBracelet::StimulusBracelet(const study::StudyScene& scene, EffectTimes& times_ns)
    : m_scene(scene)
    , m_times_ns(times_ns) {
    if (scene.motorLag)
        m_motor = motorOf(*scene.motorLag);
}

StimulusBracelet::Shown StimulusBracelet::show(const pattern::Pattern& pattern, double atMost_s,
                                               std::uint64_t seed) {
    const double step_s = 1.0 / m_scene.frameRate_Hz;
    const auto frames =
        static_cast<std::size_t>(std::ceil(std::min(pattern.duration_s, atMost_s) * m_scene.frameRate_Hz));
    std::vector<core::Intensities> told(frames);
    for (std::size_t k = 0; k < frames; ++k)
        told[k] = pattern::evaluate(pattern, static_cast<double>(k) * step_s);
    std::vector<core::Intensities> felt = told;
    Shown shown{frames, 0};
    if (m_scene.droppedFrames) {
        const Stopwatch watch(m_times_ns["dropped_frames"]);
        core::RandomStream random(study::derivedSeed(seed, kDroppedFrames));
        for (std::size_t k = 0; k < frames; ++k) {
            if (random.uniform() >= *m_scene.droppedFrames)
                continue;
            ++shown.lost;
            // The board keeps the last command.
            felt[k] = k > 0 ? felt[k - 1] : core::Intensities{};
        }
    }
    if (m_scene.deadZone) {
        const Stopwatch watch(m_times_ns["dead_zone"]);
        for (core::Intensities& frame : felt) {
            for (double& drive : frame)
                drive = drive < *m_scene.deadZone ? 0.0 : drive;
        }
    }
    if (m_scene.motorLag) {
        const Stopwatch watch(m_times_ns["motor_lag"]);
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            pattern::MotorModel model(m_motor);
            for (core::Intensities& frame : felt) {
                const double drive = frame[tactor];
                frame[tactor] = model.speed_Hz() / kFullSpeed_Hz; // at the frame's beginning
                model.step(drive, step_s);
            }
        }
    }
    std::optional<double> onset_s;
    for (std::size_t k = 0; k < frames; ++k) {
        for (std::size_t tactor = 0; tactor < core::kTactors; ++tactor) {
            const double error = felt[k][tactor] - told[k][tactor];
            m_squares += error * error;
            if (!onset_s && told[k][tactor] > 0.0 && felt[k][tactor] >= 0.5 * told[k][tactor])
                onset_s = static_cast<double>(k) * step_s;
        }
    }
    m_values += frames * core::kTactors;
    if (onset_s)
        m_onsets_s.push_back(*onset_s);
    return shown;
}

std::optional<double> StimulusBracelet::rmsError() const {
    return m_values == 0 ? std::nullopt : std::optional(std::sqrt(m_squares / static_cast<double>(m_values)));
}

} // namespace teleta::scene_run
