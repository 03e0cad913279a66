// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace teleta::playback {

/// Remembers how hot each bracelet's motors were when it was turned off, so that one that is chosen again
/// continues from there. It lasts as long as the program: a bracelet that another program drove until now
/// begins cold, as with `teleta pattern play` in a loop. Thread: any.
class HeatMemory {
public:
    struct Kept {
        core::Intensities heat{};
        std::int64_t time_ns = 0; ///< steady time from which on the motors were off
    };

    void keep(const std::string& bracelet, const Kept& kept) {
        const std::scoped_lock lock(m_mutex);
        m_kept.insert_or_assign(bracelet, kept);
    }
    /// Empty: it was never driven.
    [[nodiscard]] std::optional<Kept> of(const std::string& bracelet) const {
        const std::scoped_lock lock(m_mutex);
        const auto found = m_kept.find(bracelet);
        return found == m_kept.end() ? std::nullopt : std::optional(found->second);
    }

private:
    mutable std::mutex m_mutex;
    std::map<std::string, Kept> m_kept; ///< by the bracelet's serial number; guarded by m_mutex
};

} // namespace teleta::playback
