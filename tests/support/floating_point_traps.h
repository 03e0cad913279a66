// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace teleta::test {

/// While it exists, an invalid operation or a division by zero ends the program with SIGFPE (glibc).
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

/// Suspends the traps while it exists: comparing with NaN is an invalid operation, so passing one to the code
/// under test would end the program.
class WithoutFloatingPointTraps {
public:
    WithoutFloatingPointTraps()
        : m_before(fegetexcept()) {
        fedisableexcept(FE_ALL_EXCEPT);
    }
    ~WithoutFloatingPointTraps() {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(m_before);
    }
    WithoutFloatingPointTraps(const WithoutFloatingPointTraps&) = delete;
    WithoutFloatingPointTraps& operator=(const WithoutFloatingPointTraps&) = delete;

private:
    int m_before = 0;
};

} // namespace teleta::test
