// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/arm/teleoperated_arm.h"

#include <chrono>
#include <string_view>
#include <utility>

namespace teleta::simulation {

namespace {

using core::ArmArrival;
using core::ArmDemand;
using core::ArmDrive;
using Clock = std::chrono::steady_clock;

constexpr double kWatchdog_s = 1e-9 * static_cast<double>(core::ArmCommand::kJogLifetime_ns);

std::optional<LinkDelay> delayOf(const scene::Scene& scene, std::uint64_t seed, std::string_view stream) {
    const auto* spec = scene.listed<scene::LinkDelaySpec>();
    return spec != nullptr ? std::optional(LinkDelay(*spec, core::RandomStream(seed, stream))) : std::nullopt;
}

} // namespace

core::Expected<std::unique_ptr<TeleoperatedArm>> TeleoperatedArm::make(const scene::Scene& scene,
                                                                       std::uint64_t seed) {
    TELETA_CHECK(checkTeleoperatedScene(scene));
    TELETA_TRY(auto arm, SimulatedArm::make(scene, seed));
    return std::unique_ptr<TeleoperatedArm>(new TeleoperatedArm(std::move(arm), scene, seed));
}

TeleoperatedArm::TeleoperatedArm(std::unique_ptr<SimulatedArm> arm, const scene::Scene& scene,
                                 std::uint64_t seed)
    : m_arm(std::move(arm))
    , m_step_s(1.0 / scene.rate_Hz)
    , m_operator(scene.arm())
    , m_commands(LineOrder::newestWins, delayOf(scene, seed, "link_delay.commands"))
    , m_told(LineOrder::inOrder, delayOf(scene, seed, "link_delay.told"))
    , m_timed(scene.listed<scene::LinkDelaySpec>() != nullptr)
    , m_frame(scene.arm().skin.layout.taxels()) {
}

void TeleoperatedArm::restart() {
    m_arm->restart();
    m_operator.restart();
    m_commands.restart();
    m_told.restart();
    m_framesLost = 0;
    m_seen.reset();
    m_seenAt_s = 0.0;
    m_command = {};
    m_heardAt_s = 0.0;
    m_obeyed = ArmDrive::held;
    m_operatorLeft = false;
    m_linkTime_s = 0.0;
}

void TeleoperatedArm::next(const ArmDemand& demand, core::JointSample& sample) {
    const double now_s = m_arm->time_s();
    const Clock::time_point start = m_timed ? Clock::now() : Clock::time_point();
    m_commands.send(now_s, asked(demand, now_s));
    const ArmDemand obeyed = heard(now_s);
    const Clock::time_point between = m_timed ? Clock::now() : Clock::time_point();
    m_obeyed = obeyed.drive;
    m_arm->next(obeyed, sample);
    const Clock::time_point again = m_timed ? Clock::now() : Clock::time_point();
    ArmArrival told;
    told.sample = sample;
    told.hasFrame = m_arm->skinFrame(m_frame);
    if (told.hasFrame)
        told.frame = m_frame;
    const bool hasFrame = told.hasFrame;
    if (!m_told.send(m_arm->time_s(), std::move(told)) && hasFrame)
        ++m_framesLost;
    if (m_timed)
        m_linkTime_s += std::chrono::duration<double>((between - start) + (Clock::now() - again)).count();
}

ArmDemand TeleoperatedArm::asked(const ArmDemand& demand, double now_s) {
    if (demand.drive != ArmDrive::program) {
        m_operatorLeft = m_operatorLeft || demand.drive == ArmDrive::jog;
        return demand;
    }
    if (m_seen && now_s - m_seenAt_s > kWatchdog_s)
        return {};
    if (std::exchange(m_operatorLeft, false))
        m_operator.takeOver();
    return {ArmDrive::jog, m_operator.rates_radPerS(m_step_s, m_seen)};
}

ArmDemand TeleoperatedArm::heard(double now_s) {
    if (m_commands.receive(now_s, m_command))
        m_heardAt_s = now_s;
    return now_s - m_heardAt_s <= kWatchdog_s ? m_command : ArmDemand{};
}

bool TeleoperatedArm::takeArrival(ArmArrival& arrival) {
    if (!m_told.receive(m_arm->time_s(), arrival))
        return false;
    m_operatorLeft =
        m_operatorLeft || (m_seen && arrival.sample.sourceTime_s - m_seen->sourceTime_s > kWatchdog_s);
    m_seen = arrival.sample;
    m_seenAt_s = m_arm->time_s();
    return true;
}

core::ArmLinkCounters TeleoperatedArm::linkCounters() const {
    return {.commandsLost = m_commands.lost(), .samplesLost = m_told.lost(), .framesLost = m_framesLost};
}

core::Expected<std::unique_ptr<core::ArmGenerator>> makeArm(const scene::Scene& scene, std::uint64_t seed) {
    if (scene.isTeleoperated())
        return TeleoperatedArm::make(scene, seed);
    return SimulatedArm::make(scene, seed);
}

std::vector<EffectTime> TeleoperatedArm::effectTimes() const {
    std::vector<EffectTime> times = m_arm->effectTimes();
    if (m_timed)
        times.push_back({.name = scene::LinkDelaySpec::kRow.name, .time_s = m_linkTime_s});
    return times;
}

} // namespace teleta::simulation
