// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/cost/cost_result.h"
#include "backend/cost/ladder.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace teleta::cost {

/// A rung named "limit" that does what no way to do the job can leave out, such as reading the input once. It
/// has no error. parameter: what it does; calls: calls that a trial puts together, > 0; work: one call for
/// the trial of this index, whose result keeps the compiler from leaving it out.
[[nodiscard]] inline Rung limitRung(std::string parameter, std::size_t calls,
                                    std::function<double(std::size_t index)> work) {
    return {std::string(kLimitName), std::move(parameter), [calls, work = std::move(work)](Trial& trial) {
                volatile double result = 0.0;
                trial.timed(calls, [&] {
                    for (std::size_t call = 0; call < calls; ++call)
                        result = work(trial.index());
                });
            }};
}

} // namespace teleta::cost
