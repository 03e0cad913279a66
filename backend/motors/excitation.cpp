// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/excitation.h"

#include "backend/core/data/csv_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace teleta::motors {

namespace {

constexpr int kStairs = 40;
constexpr int kPulses = 4;
constexpr double kMediumDrive = 0.7;

} // namespace

double Excitation::driveAt(double time_s) const {
    if (!(time_s >= 0.0 && time_s < duration_s))
        return 0.0;
    const auto next = std::ranges::upper_bound(steps, time_s, {}, &Step::begin_s);
    return next == steps.begin() ? 0.0 : (next - 1)->drive;
}

Excitation stairsAndPulses(double hold_s) {
    Excitation excitation;
    double now_s = 0.0;
    const auto add = [&](double drive) {
        excitation.steps.push_back({now_s, drive});
        now_s += hold_s;
    };
    for (int stair = 0; stair <= kStairs; ++stair)
        add(static_cast<double>(stair) / kStairs);
    add(0.0);
    for (const double drive : {1.0, kMediumDrive}) {
        for (int pulse = 0; pulse < kPulses; ++pulse) {
            add(0.0);
            add(drive);
        }
    }
    add(0.0);
    excitation.duration_s = now_s;
    return excitation;
}

core::Expected<void> writeExcitation(const Excitation& excitation, double rate_Hz, const std::string& path) {
    constexpr std::array<std::string_view, 2> kColumns{"time_s", "commanded"};
    TELETA_TRY(auto writer, core::CsvWriter::create(path, kColumns));
    const auto samples = static_cast<long long>(std::ceil(excitation.duration_s * rate_Hz));
    for (long long k = 0; k < samples && !writer.failed(); ++k) {
        const double time_s = static_cast<double>(k) / rate_Hz;
        writer.number(time_s);
        writer.number(excitation.driveAt(time_s));
        writer.endRow();
    }
    return writer.finish();
}

} // namespace teleta::motors
