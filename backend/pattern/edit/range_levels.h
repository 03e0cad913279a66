// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace teleta::pattern {

/// Joined ranges of blocks of entries, of blocks of blocks and so on, so that the range of any part of a long
/// list takes O(log entries). Range: has join(other). Thread: any (immutable).
template <typename Range>
class RangeLevels {
public:
    RangeLevels() = default;
    /// at(i): the range of entry i < count.
    template <typename At>
    RangeLevels(std::size_t count, const At& at) {
        for (std::vector<Range> level = blocks(count, at); level.size() > 1;) {
            m_levels.push_back(std::move(level));
            const std::vector<Range>& below = m_levels.back();
            level = blocks(below.size(), [&below](std::size_t i) { return below[i]; });
        }
    }

    /// Joins the entries first .. last - 1 to a range. at: as in the constructor.
    template <typename At>
    void join(Range& range, std::size_t first, std::size_t last, const At& at) const {
        for (std::size_t level = 0; first < last; ++level) {
            const auto joinAll = [&](std::size_t from, std::size_t to) {
                for (std::size_t i = from; i < to; ++i)
                    range.join(level == 0 ? at(i) : m_levels[level - 1][i]);
            };
            const std::size_t firstBlock = (first + kBlock - 1) / kBlock;
            const std::size_t lastBlock = last / kBlock;
            if (level == m_levels.size() || firstBlock >= lastBlock)
                return joinAll(first, last);
            // Incomplete blocks are searched on this level, complete ones on the next.
            joinAll(first, firstBlock * kBlock);
            joinAll(lastBlock * kBlock, last);
            first = firstBlock;
            last = lastBlock;
        }
    }

private:
    static constexpr std::size_t kBlock = 32;

    template <typename At>
    static std::vector<Range> blocks(std::size_t count, const At& at) {
        std::vector<Range> joined;
        joined.reserve(count / kBlock + 1);
        for (std::size_t i = 0; i < count; ++i) {
            if (i % kBlock == 0)
                joined.push_back(at(i));
            else
                joined.back().join(at(i));
        }
        return joined;
    }

    std::vector<std::vector<Range>> m_levels; ///< each entry covers kBlock of the level below
};

} // namespace teleta::pattern
