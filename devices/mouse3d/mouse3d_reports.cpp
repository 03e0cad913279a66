// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/mouse3d_reports.h"

#include <algorithm>
#include <cstddef>

namespace teleta::mouse3d {

namespace {

constexpr std::uint8_t kTranslationId = 0x01;
constexpr std::uint8_t kRotationId = 0x02;
constexpr std::uint8_t kButtonsId = 0x03;
constexpr std::size_t kThreeAxes = 6;
constexpr std::size_t kSixAxes = 12;
constexpr std::size_t kMostButtonBytes = 4;

std::array<std::int16_t, 3> threeAxes(std::span<const std::uint8_t> bytes) {
    std::array<std::int16_t, 3> axes{};
    for (std::size_t i = 0; i < axes.size(); ++i)
        axes[i] = static_cast<std::int16_t>(bytes[2 * i] | (bytes[2 * i + 1] << 8));
    return axes;
}

} // namespace

ReportKind decodeReport(std::span<const std::uint8_t> report, RawAxes& state) {
    if (report.empty())
        return ReportKind::damaged;
    const std::span<const std::uint8_t> bytes = report.subspan(1);
    switch (report[0]) {
    case kTranslationId:
        if (bytes.size() != kThreeAxes && bytes.size() != kSixAxes)
            return ReportKind::damaged;
        state.translation = threeAxes(bytes);
        if (bytes.size() == kSixAxes)
            state.rotation = threeAxes(bytes.subspan(kThreeAxes));
        return ReportKind::axes;
    case kRotationId:
        if (bytes.size() != kThreeAxes)
            return ReportKind::damaged;
        state.rotation = threeAxes(bytes);
        return ReportKind::axes;
    case kButtonsId:
        if (bytes.empty())
            return ReportKind::damaged;
        state.buttons = 0;
        for (std::size_t i = 0; i < std::min(bytes.size(), kMostButtonBytes); ++i)
            state.buttons |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
        return ReportKind::buttons;
    default:
        return ReportKind::other;
    }
}

} // namespace teleta::mouse3d
