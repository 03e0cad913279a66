// SPDX-License-Identifier: GPL-3.0-or-later
// Plays on the first HID bracelet until the program is killed.
#include "backend/playback/player.h"
#include "devices/bracelet/hid_bracelet.h"

#include <cstdio>
#include <limits>
#include <unistd.h>

using namespace teleta;

int main() {
    core::StopSwitch stop;
    auto bracelet = bracelet::openHidBracelet({}, stop);
    if (!bracelet) {
        std::fprintf(stderr, "%s\n", describe(bracelet.error()).c_str());
        return 1;
    }
    core::Wakeup wakeup;
    (*bracelet)->start(wakeup);
    while ((*bracelet)->connection() == 0)
        wakeup.waitFor(std::chrono::milliseconds(100));
    // Long enough for a machine that is emulated and busy.
    playback::Player player(**bracelet, stop, {.boardTimeout_ms = 500});
    player.play({[](double) { return core::Intensities{0.8, 0.8, 0.8, 0.8, 0.8, 0.8}; },
                 std::numeric_limits<double>::infinity()});
    for (;;)
        pause();
}
