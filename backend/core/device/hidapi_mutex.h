// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace teleta::core {

/// Held while a HID device is looked for or opened. hidapi keeps the text of its last error in a global
/// variable that each of these calls frees and writes; drivers of several devices do that on several threads.
/// Reading and writing an open device needs no lock. Thread: any.
[[nodiscard]] inline std::mutex& hidapiMutex() {
    static std::mutex mutex;
    return mutex;
}

} // namespace teleta::core
