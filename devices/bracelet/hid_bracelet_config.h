// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_worker.h"

#include <cstdint>
#include <string>

namespace teleta::bracelet {

/// Which bracelet is opened. The default ids are the ones that pid.codes reserves for tests; a board with its
/// own ids lists them in a file (readHidBracelet) and in the udev rule.
struct HidBraceletConfig {
    std::uint16_t vendorId = 0x1209;
    std::uint16_t productId = 0x0001;
    std::string serial{}; ///< empty: the first one that is found
    core::BraceletLinkConfig link{};
};

} // namespace teleta::bracelet
