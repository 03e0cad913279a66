// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace teleta::site {

/// One question about the time and its answer; steady clocks of both machines, ns.
struct ClockProbe {
    std::int64_t sent_console_ns = 0;     ///< t1
    std::int64_t received_site_ns = 0;    ///< t2
    std::int64_t answered_site_ns = 0;    ///< t3
    std::int64_t received_console_ns = 0; ///< t4
};

/// What is known of the site's clock: site time = console time + offset.
struct ClockOffset {
    std::int64_t offset_ns = 0;
    std::int64_t bound_ns = 0; ///< the true offset is within +- bound
    std::int64_t delay_ns = 0; ///< of the probe that was used, there and back
};

/// Offset between the clocks of two machines, from probes:
///   offset = ((t2 - t1) + (t3 - t4)) / 2,   delay = (t4 - t1) - (t3 - t2)
///   |error| <= delay / 2 + 100e-6 age       (two clocks of 50 ppm each)
/// The probe of least bound among the newest kWindow is used. The bound holds for any split of the delay
/// between the two ways; how it is split cannot be seen. A probe whose interval does not meet the interval so
/// far means that a clock jumped (the machine slept): the window is emptied and counted. Thread: one. Source:
/// Mills, RFC 5905, section 8.
class ClockEstimator {
public:
    static constexpr std::size_t kWindow = 64;

    /// False: the times contradict themselves (a delay below 0, an answer before its question, negative or
    /// beyond 73 years) and are ignored.
    bool add(const ClockProbe& probe);

    /// As of now_ns, console's clock. Nothing before the first probe.
    [[nodiscard]] std::optional<ClockOffset> offset(std::int64_t now_console_ns) const;

    [[nodiscard]] std::uint64_t jumps() const { return m_jumps; }
    [[nodiscard]] std::uint64_t ignored() const { return m_ignored; }
    void reset();

private:
    struct Sample {
        std::int64_t at_console_ns = 0;
        std::int64_t offset_ns = 0;
        std::int64_t delay_ns = 0;
    };
    [[nodiscard]] static std::int64_t bound_ns(const Sample& sample, std::int64_t now_console_ns);

    std::array<Sample, kWindow> m_samples{};
    std::size_t m_count = 0;
    std::size_t m_next = 0;
    std::uint64_t m_jumps = 0;
    std::uint64_t m_ignored = 0;
};

/// An offset for the screen: follows the estimate by at most 1 ms a second, so that shown times do not jump.
/// Thread: one.
class SlewedOffset {
public:
    static constexpr double kSlew = 1e-3;

    /// The offset to show at now_ns; the first one is taken as it is.
    [[nodiscard]] std::int64_t follow(std::int64_t offset_ns, std::int64_t now_ns);
    void reset() { m_started = false; }

private:
    bool m_started = false;
    std::int64_t m_shown_ns = 0;
    std::int64_t m_last_ns = 0;
};

} // namespace teleta::site
