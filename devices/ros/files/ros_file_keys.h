// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/toml_table.h"
#include "devices/dds/domain_config.h"

#include <optional>
#include <string>
#include <string_view>

namespace teleta::ros_arm {

// Keys that the files of all devices over ROS 2 have. Thread: any.

/// A topic; the fallback stands when the key is missing, without one the key is required.
[[nodiscard]] std::string readTopic(core::TomlTable& table, std::string_view key,
                                    const std::optional<std::string>& fallback = {});

/// Of the table [ros], where the other programs are: `domain`, `interface` and `peers`.
[[nodiscard]] dds::DomainConfig readDomain(core::TomlTable& ros);

/// What a sensor tells is too old after this time: the key `timeout_s`, 0.02 to 1 s.
[[nodiscard]] double readTimeout_s(core::TomlTable& table, std::string_view key, double fallback_s);

} // namespace teleta::ros_arm
