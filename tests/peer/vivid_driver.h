// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace teleta::test {

/// The camera of the kernel's driver vivid in the virtual machine of tests/peer/vm.
inline constexpr const char* kVividNode = "/dev/video0";
/// The machine is emulated.
inline constexpr auto kVividPatience = std::chrono::seconds(90);

/// Tells the driver to "bind" or "unbind" the camera.
void toVividDriver(const std::string& what);

/// Another program sets the size of the pictures, which works while nobody else reads them. Returns the error
/// number, 0 for none.
[[nodiscard]] int setVividFormat(unsigned width, unsigned height);

/// How many of a hundred frames the camera loses. Returns the error number, 0 for none.
[[nodiscard]] int setVividLoss(int percent);

} // namespace teleta::test
