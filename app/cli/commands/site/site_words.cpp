// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/site/site_words.h"

#include <array>
#include <cstddef>

namespace teleta::cli {

const char* toString(site::Mode mode) {
    constexpr std::array<const char*, 6> kWords{"free", "held", "moving", "offered", "stopped", "fault"};
    return kWords.at(static_cast<std::size_t>(mode));
}

const char* toString(site::CommandRefusal why) {
    constexpr std::array<const char*, 11> kWords{"none",       "not_controller", "old_epoch", "stopped",
                                                 "press_anew", "old_number",     "old_loop",  "unknown_arm",
                                                 "not_finite", "not_live",       "other_boot"};
    return kWords.at(static_cast<std::size_t>(why));
}

} // namespace teleta::cli
