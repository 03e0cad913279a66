// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/site/clock_estimator.h"

#include <optional>
#include <span>
#include <string>

namespace teleta::console {

/// The way of one touch from the sensor to the skin. Times in s count from the read of the sample that
/// completed it.
struct TouchReceipt {
    pipeline::FeedbackSent sent;     ///< what was recognised, and the pattern that was sent for it
    std::optional<double> begin_s{}; ///< to the first frame of its pattern; empty: not yet, or never
    std::optional<double> onset_s{}; ///< to the first frame that is not off, the first one to be felt
    /// Of a touch at a site: what was known of its clock. The times here are off by at most its bound, since
    /// the sample was read by that clock. Empty: one clock, this computer's.
    std::optional<site::ClockOffset> clock{};

    /// Empty: one clock.
    [[nodiscard]] std::optional<double> clockBound_s() const {
        return clock ? std::optional(static_cast<double>(clock->bound_ns) * 1e-9) : std::nullopt;
    }
    /// From the read to the arrival here; empty: it was read by this computer.
    [[nodiscard]] std::optional<double> arrived_s() const {
        return sent.arrived_ns != 0
                   ? std::optional(static_cast<double>(sent.arrived_ns - sent.felt_ns) * 1e-9)
                   : std::nullopt;
    }
    /// From the read to its evaluation.
    [[nodiscard]] double evaluated_s() const {
        return static_cast<double>(sent.sent_ns - sent.felt_ns) * 1e-9;
    }
};

/// Writes receipts as CSV, one row each: touch, recognised, pattern, outcome (played, sent, missing, refused,
/// no_pattern), read_ns (steady clock here), site_read_ns (that of the site), clock_bound_s, arrived_s
/// (from a site), evaluated_s, first_frame_s, felt_s; NA where unknown. Error: ioFailed. Thread: any.
[[nodiscard]] core::Expected<void> writeReceipts(const std::string& path,
                                                 std::span<const TouchReceipt> receipts);

} // namespace teleta::console
