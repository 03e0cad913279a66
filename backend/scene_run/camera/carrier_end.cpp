// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/carrier_end.h"

#include <utility>

namespace teleta::scene_run {

namespace {

using Doing = pipeline::CarrierReport::Doing;

/// Slower than this the arm stands.
constexpr double kStill_mPerS = 1e-4;

} // namespace

CarrierEnd::CarrierEnd(std::shared_ptr<simulation::CarrierLink> link)
    : m_link(std::move(link)) {
}

void CarrierEnd::ask(const Wish& wish) {
    m_link->asked.post(wish.asked);
    m_doing = Doing::stands;
    if (wish.bump != 0)
        m_contact = wish.bump;
    if (wish.stopped) {
        if (wish.away_mPerS > kStill_mPerS)
            m_doing = Doing::retreats;
        return;
    }
    m_contact = wish.followed;
    if (wish.followed != 0)
        m_doing = Doing::follows;
}

void CarrierEnd::hold() {
    m_doing = Doing::held;
    m_link->asked.post({});
}

void CarrierEnd::forget() {
    m_doing = Doing::stands;
    m_contact = 0;
}

pipeline::CarrierReport CarrierEnd::report() const {
    pipeline::CarrierReport report;
    report.doing = m_doing == Doing::stands && m_link->state.get().held ? Doing::held : m_doing;
    report.contact = m_contact;
    return report;
}

} // namespace teleta::scene_run
