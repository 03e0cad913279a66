// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"
#include "backend/simulation/servo/servo_loop.h"

#include <optional>
#include <string>

namespace teleta::scene_run {

/// What a servo felt, wanted and did, as CSV, one row a servo cycle. Columns ending in _true are the world's
/// own.
///   time_s, phase, contact (none, touching, searching, lost), type (none, point, edge),
///   force_N, force_desired_N, force_true_N, rim_true_N, peak_N,
///   cop_x_m, cop_y_m, coc_x_m, coc_y_m, dzmp_x_m, dzmp_y_m, alpha_z_rad,
///   cop_x_desired_m, cop_y_desired_m, alpha_z_desired_rad,
///   cop_x_true_m, cop_y_true_m, dzmp_y_true_m, alpha_z_true_rad,
///   x_m, y_m, z_m, qw, qx, qy, qz (pose of the array in the base),
///   x_commanded_m, y_commanded_m, z_commanded_m,
///   vx_m_per_s, vy_m_per_s, vz_m_per_s, wx_rad_per_s, wy_rad_per_s, wz_rad_per_s (commanded, in {s}),
///   tray_rad, energy_J (of the simulated arm), limits (those that acted, with + between them),
///   coc_x_desired_m (of a slide the CoP_x that is wanted, as the paper draws it), dzmp_y_desired_m,
///   mass_x_true_m (of a weight on a tray)
/// Without a folder nothing is written.
class ServoLog {
public:
    [[nodiscard]] static core::Expected<ServoLog> open(const std::string& outFolder);

    void add(const simulation::ServoLoop& loop, const std::string& phase, double desiredForce_N);
    [[nodiscard]] bool failed() const { return m_csv && m_csv->failed(); }
    [[nodiscard]] core::Expected<void> finish() { return m_csv ? m_csv->finish() : core::Expected<void>(); }

private:
    std::optional<core::CsvWriter> m_csv;
};

} // namespace teleta::scene_run
