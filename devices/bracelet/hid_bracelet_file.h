// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "devices/bracelet/hid_bracelet.h"

#include <string>
#include <string_view>

namespace teleta::bracelet {

/// A bracelet over USB HID as its TOML file describes it.
struct HidBraceletFile {
    std::string name;
    HidBraceletConfig config;

    void describeKeys(core::Keys& keys);
};

/// Error: notFound, ioFailed, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<HidBraceletFile> readHidBracelet(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<HidBraceletFile> parseHidBracelet(std::string_view text,
                                                               const std::string& file);

} // namespace teleta::bracelet
