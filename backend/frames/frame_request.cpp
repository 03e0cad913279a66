// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/frame_request.h"

#include "backend/core/data/file_kind.h"

#include <QByteArray>
#include <QFile>
#include <QFileInfo>

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

std::string textOf(const std::vector<ColumnRange>& ranges) {
    std::string text;
    for (const ColumnRange& range : ranges) {
        if (!text.empty())
            text += ',';
        text += std::to_string(range.first);
        if (range.last != range.first)
            text += ".." + std::to_string(range.last);
    }
    return text;
}

std::optional<double> usualThreshold(std::string_view unit) {
    constexpr double kUsual = 0.2;
    return unit.empty() || unit == "N" || unit == "counts" ? std::optional(kUsual) : std::nullopt;
}

std::string familyOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!QFileInfo(file).isFile() || !file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray head = file.read(core::kFileKindBytes);
    const core::FileKind kind = core::fileKindOf(head.toStdString());
    std::string family = "kind " + std::to_string(static_cast<int>(kind));
    if (kind != core::FileKind::text)
        return family;
    const QByteArray line = head.split('\n').constFirst().trimmed();
    constexpr std::string_view kSeparators = ",;\t ";
    constexpr std::string_view kOfNumbers = "0123456789+-.eE,;\t ";
    if (line.toStdString().find_first_not_of(kOfNumbers) != std::string::npos)
        return family + ' ' + line.toStdString();
    const auto separators =
        std::ranges::count_if(line, [&](char c) { return kSeparators.find(c) != std::string_view::npos; });
    return family + ", " + std::to_string(separators) + " separators";
}

} // namespace teleta::frames
