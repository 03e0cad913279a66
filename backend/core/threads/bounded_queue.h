// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <readerwriterqueue/readerwritercircularbuffer.h>
#include <utility>

namespace teleta::core {

/// Bounded lock-free queue between one producer and one consumer thread. When it is full the new item is
/// dropped and counted: a loss is never silent, and the producer never waits.
/// Thread: push from one, pop from one, counters from any.
template <typename T>
class BoundedQueue {
public:
    explicit BoundedQueue(std::size_t capacity)
        : m_buffer(capacity)
        , m_capacity(capacity) {}

    /// False when the queue was full; weight is what is then added to the overflow count (frames in a block).
    bool push(T&& item, std::uint64_t weight = 1) {
        if (m_buffer.try_enqueue(std::move(item)))
            return true;
        m_overflow.fetch_add(weight, std::memory_order_relaxed);
        return false;
    }

    /// For a producer that can wait: false when the queue is full; the item then stays with the caller and
    /// nothing is counted.
    bool tryPush(T& item) { return m_buffer.try_enqueue(std::move(item)); }

    bool pop(T& item) { return m_buffer.try_dequeue(item); }

    [[nodiscard]] std::uint64_t overflow() const { return m_overflow.load(std::memory_order_relaxed); }
    /// Items that a consumer could take. A full queue may say less than its capacity while an item is being
    /// taken.
    [[nodiscard]] std::size_t size() const { return m_buffer.size_approx(); }
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }

private:
    moodycamel::BlockingReaderWriterCircularBuffer<T> m_buffer;
    std::size_t m_capacity;
    std::atomic<std::uint64_t> m_overflow{0};
};

} // namespace teleta::core
