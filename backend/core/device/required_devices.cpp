// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/required_devices.h"

#include <utility>

namespace teleta::core {

void RequiredDevices::add(const std::string& name, std::function<DeviceState()> state) {
    const std::lock_guard lock(m_mutex);
    m_devices.insert_or_assign(name, std::move(state));
}

void RequiredDevices::clear() {
    const std::lock_guard lock(m_mutex);
    m_devices.clear();
}

std::string RequiredDevices::firstMissing(std::span<const std::string> names) const {
    const std::lock_guard lock(m_mutex);
    for (const std::string& name : names) {
        const auto device = m_devices.find(name);
        if (device == m_devices.end() || device->second() != DeviceState::live)
            return name;
    }
    return {};
}

} // namespace teleta::core
