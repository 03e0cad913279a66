// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet_session.h"

#include "devices/bracelet/hid_bracelet.h"
#include "devices/simulated/simulated_bracelet.h"

#include <utility>

namespace teleta::console {

namespace {

core::Expected<std::unique_ptr<core::BraceletSource>> openSource(BraceletChoice choice,
                                                                 const core::StopSwitch& stop) {
    if (choice == BraceletChoice::simulated)
        return std::make_unique<simulated::SimulatedBracelet>(stop);
    return bracelet::openHidBracelet({}, stop).map([](std::unique_ptr<core::BraceletLink>&& link) {
        return std::unique_ptr<core::BraceletSource>(std::move(link));
    });
}

} // namespace

core::Expected<std::shared_ptr<BraceletSession>> BraceletSession::open(BraceletChoice choice,
                                                                       const core::StopSwitch& stop) {
    auto source = openSource(choice, stop);
    if (!source)
        return core::Unexpected(source.error());
    return std::make_shared<BraceletSession>(std::move(*source), stop);
}

BraceletSession::BraceletSession(std::unique_ptr<core::BraceletSource> source, const core::StopSwitch& stop)
    : m_source(std::move(source)) {
    m_source->start(m_wakeup);
    m_player = std::make_unique<playback::Player>(*m_source, stop);
}

BraceletSession::~BraceletSession() {
    // The player ends with a zero frame, and so does the device after it.
    m_player.reset();
    m_source->stop();
}

} // namespace teleta::console
