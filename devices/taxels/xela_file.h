// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"
#include "devices/taxels/taxels_file.h"

namespace teleta::taxels {

/// A XELA uSkin as the maker's xela_server serves it, as a described array: one JSON document a WebSocket
/// message, with the forces (taken as N) or the raw numbers of the three axes of each taxel. Losses are the
/// gaps of "message"; after 1 s without a frame the source is stale, after 3 s it connects again. A frame of
/// another model or number of taxels, or without the values, is dropped; after 1 s of it the source is lost.
/// Sources: mcsix/xela_server_ros2 at 3a890cf (MIT); spec sensors.md section 3.3.
struct XelaFile {
    TaxelsFile taxels;

    void describeKeys(core::Keys& keys);
};

} // namespace teleta::taxels
