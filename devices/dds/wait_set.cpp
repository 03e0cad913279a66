// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/wait_set.h"

#include "devices/dds/endpoint.h"

#include <algorithm>
#include <dds/dds.h>
#include <utility>

namespace teleta::dds {

WaitSet::WaitSet(std::shared_ptr<const Participant> participant)
    : m_participant(std::move(participant))
    , m_entity(dds_create_waitset(m_participant->entity()))
    , m_guard(dds_create_guardcondition(m_participant->entity())) {
    (void)dds_waitset_attach(m_entity, m_guard, 0);
}

WaitSet::~WaitSet() {
    (void)dds_delete(m_entity);
    (void)dds_delete(m_guard);
}

void WaitSet::attach(const AnyReader& reader) {
    (void)dds_waitset_attach(m_entity, reader.entity(), 0);
}

void WaitSet::wait(std::int64_t longest_ns) {
    dds_attach_t triggered = 0;
    (void)dds_waitset_wait(m_entity, &triggered, 1, std::max(longest_ns, std::int64_t{0}));
    bool woken = false;
    (void)dds_take_guardcondition(m_guard, &woken);
}

void WaitSet::wake() {
    (void)dds_set_guardcondition(m_guard, true);
}

} // namespace teleta::dds
