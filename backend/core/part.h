// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

namespace teleta::core {

/// Loads a part of the program: a module that links large libraries, so that only those who need them load
/// them. It is looked for beside the program (or the Python module), then in ../lib/teleta-console, then
/// where the build put it. It is never unloaded.
///
/// name: that of the file without ".so", and of the constant with C linkage that the module exports.
/// Returns the constant, which is valid until the program ends.
/// Error: unavailable, when the module or one of its libraries is missing or damaged.
/// Thread: any.
[[nodiscard]] Expected<const void*> loadPart(const char* name);

/// The same for a constant of type T, which is loaded once:
///   static const Expected<const Pictures*> loaded = part<Pictures>("teleta_opencv_pictures");
template <typename T>
[[nodiscard]] Expected<const T*> part(const char* name) {
    TELETA_TRY(const void* constant, loadPart(name));
    return static_cast<const T*>(constant);
}

} // namespace teleta::core
