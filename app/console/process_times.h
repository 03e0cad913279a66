// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::console {

/// Processor time of all threads of this process since it began, the loading of its libraries included, s.
[[nodiscard]] double processorTime_s();

/// Time by the clock since this process began, s, to 10 ms: the kernel counts the begin in such steps. NaN
/// where /proc cannot be read.
[[nodiscard]] double processAge_s();

} // namespace teleta::console
