// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"

#include "backend/core/passwords.h"

#include <algorithm>
#include <string>

namespace teleta::app {

void hidePasswords(int argc, char** argv) {
    for (int i = 0; i < argc; ++i) {
        const std::string given = argv[i];
        const std::string shown = core::withoutPasswords(given);
        if (shown == given)
            continue;
        // The kernel shows the place where the arguments were, so it is written over from end to end.
        std::fill_n(argv[i], given.size(), '\0');
        std::copy_n(shown.begin(), std::min(shown.size(), given.size()), argv[i]);
    }
}

} // namespace teleta::app
