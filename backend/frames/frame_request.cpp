// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/frame_request.h"

#include <algorithm>
#include <charconv>

namespace teleta::frames {

namespace {

/// A number from 1, and nothing else.
std::optional<std::size_t> columnNumber(std::string_view text) {
    constexpr std::size_t kMost = std::size_t{1} << 21U;
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, number);
    if (stop != end || code != std::errc() || number < 1 || number > kMost)
        return std::nullopt;
    return number;
}

} // namespace

std::optional<std::vector<ColumnRange>> columnRangesOf(std::string_view text) {
    std::vector<ColumnRange> ranges;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, end - begin);
        const std::size_t dots = part.find("..");
        const auto first = columnNumber(part.substr(0, dots));
        const auto last = dots == std::string_view::npos ? first : columnNumber(part.substr(dots + 2));
        if (!first || !last || *last < *first)
            return std::nullopt;
        ranges.push_back({*first, *last});
        begin = end + 1;
    }
    return ranges;
}

} // namespace teleta::frames
