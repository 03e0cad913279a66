// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::study {

/// Calls visit(name, field) for each field of a stored trial, by the name that the table and the journal of
/// trials give it, in the journal's order. trial: has the members result and time. Thread: any.
template <typename Trial, typename Visit>
void forEachField(Trial& trial, const Visit& visit) {
    auto& result = trial.result;
    visit("phase", result.planned.phase);
    visit("trial", result.planned.trial);
    visit("repetition", result.planned.repetition);
    visit("attempt", result.planned.attempt);
    visit("stimulus", result.planned.stimulus);
    visit("trial_in_block", result.trialInBlock);
    visit("response", result.response);
    visit("outcome", result.outcome);
    visit("response_time_s", result.responseTime_s);
    visit("response_time_offset_s", result.responseTimeOffset_s);
    visit("response_device", result.responseDevice);
    visit("response_key", result.responseKey);
    visit("n_replays", result.replays);
    visit("early_presses", result.earlyPresses);
    visit("onset_s", result.onset_s);
    visit("duration_s", result.duration_s);
    visit("device_latency_ms", result.deviceLatency_ms);
    visit("device_faults", result.deviceFaults);
    visit("frame_write_ms", result.frameWrite_ms);
    visit("frames_missed", result.framesMissed);
    visit("time_utc", trial.time);
    // Since schema 6.
    visit("track", result.planned.track);
    visit("level", result.planned.level);
    visit("target", result.planned.target);
    visit("trigger_ms", result.trigger_ms);
    visit("recording", result.recording);
    visit("recording_s", result.recording_s);
    // Since schema 8.
    visit("device_latency_spread_ms", result.latencySpread_ms);
}

} // namespace teleta::study
