// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace teleta::contour {

/// While it lives, a floating-point operation without a value (0/0, inf - inf) or a division by zero ends the
/// program.
class TrappedExceptions {
public:
    TrappedExceptions()
        : m_before(fegetexcept()) {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(FE_INVALID | FE_DIVBYZERO);
    }
    ~TrappedExceptions() {
        fedisableexcept(FE_INVALID | FE_DIVBYZERO);
        feenableexcept(m_before);
    }
    TrappedExceptions(const TrappedExceptions&) = delete;
    TrappedExceptions& operator=(const TrappedExceptions&) = delete;

private:
    int m_before;
};

} // namespace teleta::contour
