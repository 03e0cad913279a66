// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/required_devices.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::core {

TEST(RequiredDevices, namesTheFirstThatIsNotLive) {
    RequiredDevices devices;
    DeviceState pad = DeviceState::live;
    devices.add("pad", [&pad] { return pad; });
    devices.add("camera", [] { return DeviceState::live; });
    const std::vector<std::string> both{"pad", "camera"};
    EXPECT_EQ(devices.firstMissing({}), "");
    EXPECT_EQ(devices.firstMissing(both), "");
    for (const DeviceState state : {DeviceState::closed, DeviceState::connecting, DeviceState::paused,
                                    DeviceState::stale, DeviceState::lost, DeviceState::finished}) {
        pad = state;
        EXPECT_EQ(devices.firstMissing(both), "pad");
    }
    pad = DeviceState::live;
    const std::vector<std::string> unknown{"camera", "glove"};
    EXPECT_EQ(devices.firstMissing(unknown), "glove");
    devices.clear();
    EXPECT_EQ(devices.firstMissing(both), "pad") << "none is live any more";
}

} // namespace teleta::core
