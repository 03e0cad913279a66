// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/simulated_player.h"

#include <algorithm>
#include <utility>

namespace teleta::scene_run {

SimulatedPlayer::SimulatedPlayer()
    : m_limiter({}, 1.0 / kRate_Hz) {
}

core::Expected<SimulatedPlayer> SimulatedPlayer::open(const std::string& outFolder) {
    SimulatedPlayer player;
    TELETA_TRY(player.m_csv, RunCsv::open(outFolder, "bracelet.csv", "time_s,t1,t2,t3,t4,t5,t6"));
    return player;
}

void SimulatedPlayer::play(playback::Program program) {
    m_program = std::move(program);
    m_begun_s.reset();
    m_onset_s.reset();
}

void SimulatedPlayer::advance(double now_s, double heardAt_s) {
    // Rounding must not delay a frame that is due with a sample.
    constexpr double kRounding_s = 1e-9;
    for (; static_cast<double>(m_frames) / kRate_Hz <= now_s + kRounding_s; ++m_frames)
        writeFrame(static_cast<double>(m_frames) / kRate_Hz, now_s - heardAt_s <= kTimeout_s);
}

void SimulatedPlayer::writeFrame(double now_s, bool heard) {
    core::Intensities wanted{};
    if (!heard)
        m_program.reset();
    if (m_program) {
        if (!m_begun_s)
            m_begun_s = now_s;
        const double position_s = now_s - *m_begun_s;
        if (position_s >= m_program->duration_s)
            m_program.reset();
        else
            wanted = m_program->evaluate(position_s);
    }
    if (heard)
        (void)m_limiter.step(wanted, 1.0 / kRate_Hz);
    else
        m_limiter.off(1.0 / kRate_Hz);
    const core::Intensities& given = m_limiter.output();
    const bool isOn = std::ranges::any_of(given, [](double intensity) { return intensity > 0.0; });
    if (isOn && m_program && !m_onset_s)
        m_onset_s = now_s;
    if (given == m_written && m_frames > 0)
        return;
    m_written = given;
    m_csv.row(now_s, given);
}

} // namespace teleta::scene_run
