// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/contact/tactile_features.h"

#include <array>
#include <string_view>

namespace teleta::cli {

/// Columns of tactile features, a row a frame.
inline constexpr std::array<std::string_view, 13> kFeatureColumns{
    "time_s",   "contact_type", "force_n",     "cop_x_m",    "cop_y_m",    "coc_x_m", "coc_y_m",
    "dzmp_x_m", "dzmp_y_m",     "alpha_z_rad", "lambda1_m2", "lambda2_m2", "active"};

void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features);

} // namespace teleta::cli
