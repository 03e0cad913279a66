// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/decline_message.h"

#include <gtest/gtest.h>

using teleta::site_link::declineMessage;
using teleta::site_link::declineReason;

TEST(DeclineMessage, isReadAsItWasWritten) {
    EXPECT_EQ(declineMessage(""), "declined");
    EXPECT_EQ(declineMessage("nearly done: wait"), "declined: nearly done: wait");
    EXPECT_EQ(declineReason("declined"), "");
    EXPECT_EQ(declineReason("declined: nearly done: wait"), "nearly done: wait");
    for (const char* other : {"", "done", "nobody answered in time", "declined!", "declined:"})
        EXPECT_FALSE(declineReason(other)) << other;
}
