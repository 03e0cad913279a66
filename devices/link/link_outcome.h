// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::link {

/// How waiting for a link ended.
enum class Outcome {
    done,     ///< bytes were read; all bytes were written
    timedOut, ///< the deadline has passed
    woken,    ///< the wake pipe ended the wait
    gone,     ///< unplugged, closed or failed; the link's goneReason() says why
};

} // namespace teleta::link
