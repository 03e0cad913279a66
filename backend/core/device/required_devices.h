// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"

#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>

namespace teleta::core {

/// Devices without which an actuator must not move, by their names. Thread: any.
class RequiredDevices {
public:
    /// state: as a reader sees it now (observedState()); is called by other threads until clear().
    void add(const std::string& name, std::function<DeviceState()> state);
    /// From now on none of them is live; no state is asked for any more.
    void clear();

    /// The first of these that is not live, one that is not known included; empty: all are.
    [[nodiscard]] std::string firstMissing(std::span<const std::string> names) const;

private:
    mutable std::mutex m_mutex;
    std::map<std::string, std::function<DeviceState()>> m_devices;
};

} // namespace teleta::core
