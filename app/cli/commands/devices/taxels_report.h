// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/core/data/taxel_layout.h"
#include "devices/taxels/taxels_probe.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace teleta::cli {

/// What a described array sent, for who writes its description.
struct TaxelsReport {
    taxels::TaxelsProbe probe;
    core::TaxelLayout layout;
    std::string unit;
};

/// What was counted.
void addFields(const TaxelsReport& report, Fields& fields);

/// The bytes in hexadecimal digits, with > before the first byte of each frame, and the first frame as a
/// grid, the last row first, as it is drawn.
[[nodiscard]] std::string textOf(const TaxelsReport& report);

[[nodiscard]] nlohmann::ordered_json toJson(const TaxelsReport& report);

} // namespace teleta::cli
