// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "app/console/study/running/stimulus_output.h"

namespace teleta::console {

/// Stimuli on the bracelet of the console, with its limits, watchdogs and STOP. Thread: GUI.
class BraceletStimulus : public StimulusOutput {
public:
    /// Both must outlive it.
    BraceletStimulus(BraceletService& station, const core::StopSwitch& stop)
        : m_station(station)
        , m_stop(stop) {}

    [[nodiscard]] QString obstacle() const override;
    [[nodiscard]] QString description() const override;
    [[nodiscard]] bool isSimulated() const override { return m_station.isSimulated(); }
    void begin(const pattern::Pattern& pattern, double atMost_s, OnsetFrame onset,
               std::int64_t now_ns) override;
    void stop() override;
    [[nodiscard]] StimulusState state(std::int64_t now_ns) const override;
    [[nodiscard]] std::function<std::int64_t()> onset() const override;

private:
    /// The one on which the last stimulus began, as long as the station has it; otherwise null.
    [[nodiscard]] BraceletSession* session() const;
    /// Weak, so that the board is closed as soon as the station leaves it.
    std::weak_ptr<BraceletSession> m_session;
    BraceletService& m_station;
    const core::StopSwitch& m_stop;
    std::int64_t m_request_ns = 0;
    OnsetFrame m_onset = OnsetFrame::notZero;
};

/// Plays nothing: a stimulus only takes its time. For rehearsals that are faster than a bracelet. Thread:
/// GUI.
class UnplayedStimulus : public StimulusOutput {
public:
    [[nodiscard]] QString obstacle() const override { return {}; }
    [[nodiscard]] QString description() const override;
    [[nodiscard]] bool isSimulated() const override { return true; }
    void begin(const pattern::Pattern& pattern, double atMost_s, OnsetFrame onset,
               std::int64_t now_ns) override;
    void stop() override { m_end_ns = 0; }
    [[nodiscard]] StimulusState state(std::int64_t now_ns) const override;
    [[nodiscard]] std::function<std::int64_t()> onset() const override;

private:
    std::int64_t m_onset_ns = 0;
    std::int64_t m_end_ns = 0;
};

} // namespace teleta::console
