// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <functional>
#include <string>

namespace teleta::recording {

/// Makes a recording under a free name, whole or not at all: write() makes it as a file beside, NAME.part,
/// which gets the name when it is complete and is removed when it fails. Error: refused, the name is taken;
/// ioFailed; that of write(). Thread: any.
[[nodiscard]] core::Expected<void>
makeRecording(const std::string& path, const std::function<core::Expected<void>(const std::string&)>& write);

} // namespace teleta::recording
