// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/scene/scene.h"

#include <cmath>
#include <optional>

namespace teleta::simulation {

/// How long each message of one direction is on its way.
///   P(delay <= t) = 1 - exp(-(t - delay_s) / jitter_s),  t >= delay_s
/// so that the median is delay_s + jitter_s ln 2, and the mean delay_s + jitter_s. Each message draws two
/// numbers, whatever becomes of it: what is lost does not change the delays of the others. Thread: one.
class LinkDelay {
public:
    LinkDelay(const scene::LinkDelaySpec& spec, core::RandomStream random)
        : m_spec(spec)
        , m_random(random) {}

    /// Of a message that is sent at that time; empty: it is lost.
    [[nodiscard]] std::optional<double> next_s(double sentAt_s) {
        const bool lost = m_random.uniform() < m_spec.lossShare;
        const double jitter_s = -m_spec.jitter_s * std::log1p(-m_random.uniform());
        const bool isOut = sentAt_s >= m_spec.outageAt_s && sentAt_s < m_spec.outageAt_s + m_spec.outage_s;
        return lost || isOut ? std::nullopt : std::optional(m_spec.delay_s + jitter_s);
    }
    void restart() { m_random.restart(); }

private:
    scene::LinkDelaySpec m_spec;
    core::RandomStream m_random;
};

} // namespace teleta::simulation
