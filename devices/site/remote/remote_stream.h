// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/steady_time.h"
#include "backend/site/control_arbiter.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace teleta::site_link {

/// Follows the numbers of a stream that comes in blocks over a network: what was lost, what came twice or
/// late, and whether the site was started anew. Times never go back. Thread: one.
class RemoteStream {
public:
    /// Between looks whether something still comes.
    static constexpr std::int64_t kLook_ns = 50'000'000;

    struct Step {
        bool use = false;           ///< the block is new
        bool discontinuity = false; ///< the site was started anew before it
        std::uint64_t lost = 0;     ///< samples that never came
        std::uint64_t atSite = 0;   ///< of them, those that the site did not have either
    };

    /// A block of count samples, the first of which has this number. lost: what the site says that it had
    /// lost by then.
    [[nodiscard]] Step take(const site::BootName& boot, std::uint64_t first, std::uint64_t count,
                            std::uint32_t lost = 0) {
        Step step;
        const bool other = m_boot && *m_boot != boot;
        if (!m_boot || other) {
            m_boot = boot;
            m_next = first;
            m_lostAtSite = lost;
        }
        // What lies behind was overtaken on the way.
        if (count == 0 || first < m_next)
            return step;
        step.use = true;
        step.discontinuity = other;
        step.lost = first - m_next;
        // The site's number begins at 0 again after 2^32.
        step.atSite = std::min<std::uint64_t>(step.lost, std::uint32_t{lost - m_lostAtSite});
        m_lostAtSite = lost;
        m_next = first + count;
        return step;
    }

    /// Marks a device as stale when nothing has come for too long, with the reason that why() gives. Called
    /// again and again: the reason is known a while later. last_ns: when something came.
    template <typename Outlet, typename Why>
    static void watchSilence(Outlet& outlet, std::int64_t last_ns, std::int64_t staleAfter_ns,
                             const Why& why) {
        const std::int64_t now_ns = core::steadyNow_ns();
        const bool hasCome =
            outlet.state() == core::DeviceState::live || outlet.state() == core::DeviceState::stale;
        if (hasCome && now_ns - last_ns > staleAfter_ns)
            outlet.setState(core::DeviceState::stale, now_ns, why());
    }

    /// A time that is not before the ones that came already.
    [[nodiscard]] std::int64_t inOrder(std::int64_t time_ns) {
        m_last_ns = std::max(m_last_ns, time_ns);
        return m_last_ns;
    }

private:
    std::optional<site::BootName> m_boot;
    std::uint64_t m_next = 0;
    std::uint32_t m_lostAtSite = 0;
    std::int64_t m_last_ns = 0;
};

} // namespace teleta::site_link
