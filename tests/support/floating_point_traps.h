// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace teleta::test {

/// While it lives, an invalid operation or a division by zero ends the program with SIGFPE (glibc).
class FloatingPointTraps {
public:
    FloatingPointTraps() {
        std::feclearexcept(FE_ALL_EXCEPT);
        m_before = fegetexcept();
        feenableexcept(FE_INVALID | FE_DIVBYZERO);
    }
    ~FloatingPointTraps() {
        fedisableexcept(FE_ALL_EXCEPT);
        feenableexcept(m_before);
    }
    FloatingPointTraps(const FloatingPointTraps&) = delete;
    FloatingPointTraps& operator=(const FloatingPointTraps&) = delete;

private:
    int m_before = 0;
};

} // namespace teleta::test
