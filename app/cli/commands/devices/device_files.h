// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"

#include <string>

namespace teleta::cli {

/// A Weiss array as a TOML file describes it.
struct ArrayFile {
    std::string name;
    std::string address; ///< as wts::parseWtsAddress takes it
    int baud = 115200;

    void describeKeys(core::Keys& keys);
};

/// A camera as a TOML file describes it; 0: what the camera has.
struct CameraFile {
    std::string name;
    std::string source; ///< as camera::probeCamera takes it
    int width_px = 0;
    int height_px = 0;
    double rate_Hz = 0.0;

    void describeKeys(core::Keys& keys);
};

} // namespace teleta::cli
