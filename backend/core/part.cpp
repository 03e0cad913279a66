// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/part.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <array>
#include <dlfcn.h>
#include <string>

namespace teleta::core {

namespace {

struct PartText {
    Q_DECLARE_TR_FUNCTIONS(PartText)
};

/// The dynamic linker knows $ORIGIN: the folder of the program or of the Python module that this code is in.
/// The last one is found by the search path that only programs of a build tree have.
constexpr std::array kFolders{"$ORIGIN/", "$ORIGIN/../lib/teleta-console/", ""};

} // namespace

Expected<const void*> loadPart(const char* name) {
    const std::string file = std::string(name) + ".so";
    std::string reason;
    for (const char* folder : kFolders) {
        void* const module = dlopen((folder + file).c_str(), RTLD_NOW | RTLD_LOCAL);
        const void* const constant = module == nullptr ? nullptr : dlsym(module, name);
        if (constant != nullptr)
            return constant;
        const char* const problem = dlerror();
        // Where a file is not, the message begins with it; what it lacks itself tells more.
        const std::string message = problem == nullptr ? std::string() : problem;
        if (reason.empty() || reason.find(file + ": cannot open") != std::string::npos)
            reason = message;
    }
    return failed(
        ErrorKind::unavailable,
        PartText::tr("a part of the program cannot be loaded: %1").arg(QString::fromStdString(reason)),
        PartText::tr("a complete installation of the program"));
}

} // namespace teleta::core
