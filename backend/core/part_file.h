// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <dlfcn.h>
#include <string>

namespace teleta::core {

/// Finds and loads the module of loadPart(), with nothing but the standard library: also for a program that
/// loads no other one. The module itself is bound at once (it is linked so), its libraries as they are used,
/// as those of a program are.
///
/// name: that of the file without ".so", and of the constant with C linkage that the module exports.
/// Returns the constant, which is valid until the program ends; null when there is none, and then reason says
/// why, in the words of the dynamic linker.
/// Thread: any.
[[nodiscard]] inline const void* findPart(const char* name, std::string& reason) {
    // The dynamic linker knows $ORIGIN: the folder of the program or of the module that this code is in. The
    // package of teleta-site has a folder of its own. The last one is found by the search path that only
    // programs of a build tree have.
    constexpr std::array kFolders{"$ORIGIN/", "$ORIGIN/../lib/teleta-console/", "$ORIGIN/../lib/teleta-site/",
                                  ""};
    const std::string file = std::string(name) + ".so";
    for (const char* folder : kFolders) {
        void* const module = dlopen((folder + file).c_str(), RTLD_LAZY | RTLD_LOCAL);
        const void* const constant = module == nullptr ? nullptr : dlsym(module, name);
        if (constant != nullptr)
            return constant;
        const char* const problem = dlerror();
        // Where a file is not, the message begins with it; what it lacks itself tells more.
        const std::string message = problem == nullptr ? std::string() : problem;
        if (reason.empty() || reason.find(file + ": cannot open") != std::string::npos)
            reason = message;
    }
    return nullptr;
}

} // namespace teleta::core
