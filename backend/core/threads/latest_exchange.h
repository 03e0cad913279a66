// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace teleta::core {

/// Hands the latest value from one writer thread to one reader thread without a lock (triple buffer). The
/// reader sees either the whole new value or the whole old one, and a generation number that grows by one a
/// publication. T's storage is recycled between the three slots, so publishing a value of the same size
/// allocates nothing. Thread: back/publish from the writer, update/front/generation from the reader.
template <typename T>
class LatestExchange {
public:
    /// The slot that the writer fills. Its content is that of an earlier publication: overwrite all of it.
    [[nodiscard]] T& back() { return m_slots[m_back].value; }

    void publish() {
        m_slots[m_back].generation = ++m_published;
        m_back =
            m_middle.exchange(static_cast<std::uint8_t>(m_back | kFresh), std::memory_order_acq_rel) & kIndex;
    }

    /// Fetches the newest value if there is one since the last call; true when front() changed.
    bool update() {
        if ((m_middle.load(std::memory_order_relaxed) & kFresh) == 0)
            return false;
        m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
        return true;
    }

    [[nodiscard]] const T& front() const { return m_slots[m_front].value; }

    /// 0 before the first publication has been fetched.
    [[nodiscard]] std::uint64_t generation() const { return m_slots[m_front].generation; }

private:
    static constexpr std::uint8_t kIndex = 3;
    static constexpr std::uint8_t kFresh = 4;

    struct alignas(64) Slot {
        T value{};
        std::uint64_t generation = 0;
    };

    std::array<Slot, 3> m_slots;
    alignas(64) std::uint8_t m_back = 0;
    std::uint64_t m_published = 0;
    alignas(64) std::atomic<std::uint8_t> m_middle{1};
    alignas(64) std::uint8_t m_front = 2;
};

} // namespace teleta::core
