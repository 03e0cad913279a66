// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>
#include <unistd.h>

namespace teleta::peer {

/// PROGRAM DOMAIN KEYS publish|subscribe TOPIC [SECONDS]: one member of a domain on the loopback interface.
/// It says on standard output "joined", "started", "matched N", "received TEXT" for each message, "error
/// TEXT", and "end" after its seconds. It sends the name of its keys, 50 times a second.
struct MemberOptions {
    int domain = 0;
    std::string keys; ///< the folder of a member, or "none"
    bool publishes = false;
    std::string ddsTopic;
    int seconds = 60;

    MemberOptions(int count, char** arguments) {
        if (count < 5)
            std::exit(2);
        domain = std::atoi(arguments[1]);
        keys = arguments[2];
        publishes = std::string_view(arguments[3]) == "publish";
        ddsTopic = arguments[4];
        if (count > 5)
            seconds = std::atoi(arguments[5]);
        // Whatever happens to the test.
        (void)alarm(90);
    }
    [[nodiscard]] bool secured() const { return keys != "none"; }
};

} // namespace teleta::peer
