// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_session.h"

#include "backend/playback/pattern_program.h"
#include "devices/bracelet/hid_bracelet.h"
#include "devices/described/described_bracelet.h"
#include "devices/simulated/simulated_bracelet.h"

namespace teleta::console {

namespace {

/// A sensor of the simulated bracelet is off by so much.
constexpr double kSpeedNoise_Hz = 1.5;

core::Expected<std::unique_ptr<core::BraceletSource>>
openSource(BraceletChoice choice, const std::string& deviceFile, const core::StopSwitch& stop) {
    const auto asSource = [](std::unique_ptr<core::BraceletLink>&& link) {
        return std::unique_ptr<core::BraceletSource>(std::move(link));
    };
    if (choice == BraceletChoice::simulated)
        return std::make_unique<simulated::SimulatedBracelet>(
            stop, simulated::SimulatedBraceletConfig{.motors = simulated::unequalMotors(),
                                                     .speedNoise_Hz = kSpeedNoise_Hz});
    if (choice == BraceletChoice::hid)
        return bracelet::openHidBracelet({}, stop).map(asSource);
    return described::openBracelet(deviceFile, stop).map(asSource);
}

} // namespace

core::Expected<std::shared_ptr<BraceletSession>> BraceletSession::open(BraceletChoice choice,
                                                                       const std::string& deviceFile,
                                                                       const core::StopSwitch& stop,
                                                                       playback::PlayerConfig player) {
    TELETA_TRY(auto source, openSource(choice, deviceFile, stop));
    return std::make_shared<BraceletSession>(std::move(source), stop, std::move(player));
}

BraceletSession::BraceletSession(std::unique_ptr<core::BraceletSource> source, const core::StopSwitch& stop,
                                 playback::PlayerConfig player)
    : m_source(std::make_unique<TappedBracelet>(std::move(source))) {
    const std::string& serial = m_source->description().serial;
    auto found = motors::findMotors(serial);
    if (!found)
        m_calibrationError = found.error();
    else if (*found)
        m_calibration = std::move(**found);
    m_calibration.bracelet = serial;
    if (auto limits = motors::findLimits(serial)) {
        m_limits = std::move(*limits);
    } else {
        m_limitsError = limits.error();
        m_limits.bracelet = serial;
        m_limits.strongest.fill(motors::kUnknownStrongest);
    }
    m_source->start(m_wakeup);
    player.limits.userLimit = m_limits.strongest;
    player.ranges = playback::rangesOf(m_calibration.profiles());
    m_player = std::make_unique<playback::Player>(*m_source, stop, std::move(player));
}

BraceletSession::~BraceletSession() {
    // The player ends with a zero frame, and so does the device after it.
    m_player.reset();
    m_source->stop();
}

} // namespace teleta::console
