// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet.h"
#include "devices/mouse3d/hid_input.h"

#include <gtest/gtest.h>

#include <thread>

using namespace teleta;

namespace {
constexpr int kTimes = 1000;
const hid::HidDeviceInfo kNowhere{"/dev/hidraw-that-is-not-there"};
} // namespace

// hidapi frees and writes the text of its last error, a global variable, in each of these calls: without one
// lock for both devices the heap is soon damaged.
TEST(HidapiThreads, looksForABraceletWhileAMouseIsLookedFor) {
    int refused = 0;
    std::jthread bracelet([&refused] {
        for (int i = 0; i < kTimes; ++i) {
            (void)bracelet::listHidBracelets();
            refused += bracelet::openBraceletNode("/dev/hidraw-that-is-not-there") ? 0 : 1;
        }
    });
    int refusedMice = 0;
    for (int i = 0; i < kTimes; ++i) {
        (void)mouse3d::listMice();
        refusedMice += mouse3d::openMouse(kNowhere) ? 0 : 1;
    }
    bracelet.join();
    EXPECT_EQ(refused, kTimes);
    EXPECT_EQ(refusedMice, kTimes);
}
