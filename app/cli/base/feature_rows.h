// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/contact/summit.h"
#include "backend/contact/tactile_features.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::cli {

/// Columns of tactile features, a row a frame.
inline constexpr std::array<std::string_view, 13> kFeatureColumns{
    "time_s",   "contact_type", "force_n",     "cop_x_m",    "cop_y_m",    "coc_x_m", "coc_y_m",
    "dzmp_x_m", "dzmp_y_m",     "alpha_z_rad", "lambda1_m2", "lambda2_m2", "active"};

/// The caller ends the row.
void writeFeatures(RowOutput& rows, double time_s, const contact::TactileFeatures& features);

/// Columns of the summit of a contact, behind those of the features or of the contact.
inline constexpr std::array<std::string_view, 4> kSummitColumns{"summit_x_m", "summit_y_m", "summit_x_se_m",
                                                                "summit_y_se_m"};

/// The columns, and those of the summit where it is asked for.
[[nodiscard]] std::vector<std::string_view> withSummit(std::span<const std::string_view> columns,
                                                       bool summit);

/// The caller ends the row.
void writeSummit(RowOutput& rows, const std::optional<contact::Summit>& summit);

} // namespace teleta::cli
