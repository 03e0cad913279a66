// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/dds/participant.h"

#include <cstdint>
#include <memory>

namespace teleta::dds {

class AnyReader;

/// Lets a thread of ours sleep until a reader has samples. Nothing of ours runs on the threads of the
/// middleware, which must not wait. Thread: wait() from one; wake() from any; attach() before wait().
class WaitSet {
public:
    explicit WaitSet(std::shared_ptr<const Participant> participant);
    ~WaitSet();
    WaitSet(const WaitSet&) = delete;
    WaitSet& operator=(const WaitSet&) = delete;

    void attach(const AnyReader& reader);

    /// Returns when a reader has samples, after wake(), or when the time is over.
    void wait(std::int64_t longest_ns);

    /// Ends the wait; a call before the wait counts.
    void wake();

private:
    std::shared_ptr<const Participant> m_participant;
    std::int32_t m_entity;
    std::int32_t m_guard;
};

} // namespace teleta::dds
