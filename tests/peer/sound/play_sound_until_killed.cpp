// SPDX-License-Identifier: GPL-3.0-or-later
// Plays on the sound card of a device file until the program is killed.
#include "backend/playback/player.h"
#include "devices/described/described_bracelet.h"

#include <chrono>
#include <cstdio>
#include <limits>
#include <unistd.h>

using namespace teleta;

int main(int count, char** arguments) {
    core::StopSwitch stop;
    auto bracelet = described::openBracelet(count > 1 ? arguments[1] : "", stop);
    if (!bracelet) {
        std::fprintf(stderr, "%s\n", describe(bracelet.error()).c_str());
        return 1;
    }
    core::Wakeup wakeup;
    (*bracelet)->start(wakeup);
    while ((*bracelet)->connection() == 0)
        wakeup.waitFor(std::chrono::milliseconds(100));
    playback::Player player(**bracelet, stop);
    player.play({[](double) { return core::Intensities{0.8, 0.8, 0.8, 0.8, 0.8, 0.8}; },
                 std::numeric_limits<double>::infinity()});
    for (;;)
        pause();
}
