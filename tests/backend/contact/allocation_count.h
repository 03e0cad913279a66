// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace teleta::contact::test {

/// How often operator new was called in this program.
[[nodiscard]] std::size_t allocationCount();

} // namespace teleta::contact::test
