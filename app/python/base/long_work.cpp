// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/base/long_work.h"

#include "backend/core/steady_time.h"

namespace teleta::python {

namespace {

constexpr std::int64_t kBetweenLooks_ns = 50'000'000;
constexpr std::int64_t kBetweenProgress_ns = 100'000'000;

} // namespace

bool LongWork::goOn(double done, double all) {
    if (m_raised)
        return false;
    const std::int64_t now_ns = core::steadyNow_ns();
    if (m_nextLook_ns == 0)
        m_nextLook_ns = now_ns + kBetweenLooks_ns;
    if (now_ns < m_nextLook_ns)
        return true;
    m_nextLook_ns = now_ns + kBetweenLooks_ns;
    const py::gil_scoped_acquire lock;
    // Exceptions do not pass through the backend: it ends its work, and rethrow() goes on with them.
    try {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!m_progress.is_none() && now_ns >= m_nextProgress_ns) {
            m_nextProgress_ns = now_ns + kBetweenProgress_ns;
            m_progress(done, all);
        }
    } catch (py::error_already_set& raised) {
        m_raised.emplace(raised);
        return false;
    }
    return true;
}

void LongWork::rethrow() {
    if (m_raised)
        throw py::error_already_set(*m_raised);
}

} // namespace teleta::python
