// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_bracelet_port.h"

#include <array>
#include <cstddef>
#include <utility>

namespace teleta::modbus {

namespace {

constexpr std::int64_t kBoardPeriod_ns = 100'000'000;
constexpr std::int64_t kLongestFrame_ns = 20'000'000;

std::vector<InputRegister> boardInputs(const RegisterMap& map) {
    std::vector<InputRegister> inputs;
    if (map.status)
        inputs.push_back(map.status->input);
    if (map.supply)
        inputs.push_back(map.inputs[*map.supply]);
    if (map.temperature)
        inputs.push_back(map.inputs[*map.temperature]);
    return inputs;
}

core::Intensities toIntensities(const core::Drive& drive) {
    core::Intensities intensities{};
    for (std::size_t i = 0; i < drive.size(); ++i)
        intensities[i] = static_cast<double>(drive[i]) / core::kFullDrive;
    return intensities;
}

} // namespace

ModbusBraceletPort::ModbusBraceletPort(const RegisterMap& map, std::unique_ptr<RegisterLink> link,
                                       std::shared_ptr<const core::PacingClock> clock)
    : m_tactors(*map.tactors)
    , m_watchdogAddress(map.watchdogAddress)
    , m_status(map.status)
    , m_tellsSupply(map.supply.has_value())
    , m_tellsTemperature(map.temperature.has_value())
    , m_link(std::move(link))
    , m_clock(std::move(clock))
    , m_boardReader(boardInputs(map))
    , m_boardValues(m_boardReader.inputs()) {
}

bool ModbusBraceletPort::write(std::uint16_t sequence, const core::Drive& drive,
                               std::uint16_t /*timeout_ms*/) {
    if (const Answer answer = writeAll(drive); !answer.done()) {
        m_failure = describe(answer);
        zeroOnTheWayOut(answer);
        return false;
    }
    core::BoardReport report;
    report.sequence = sequence;
    report.driving = !core::isOff(drive);
    std::size_t next = 0;
    if (m_status) {
        ++next;
        report.timedOut = statusBit(m_status->timedOutBit);
        report.tooHot = statusBit(m_status->tooHotBit);
        report.supplyLow = statusBit(m_status->supplyLowBit);
    }
    if (m_tellsSupply)
        report.supply_V = m_boardValues[next++];
    if (m_tellsTemperature)
        report.temperature_degC = m_boardValues[next];
    m_reports.push_back(report);
    return true;
}

core::BraceletPort::Read ModbusBraceletPort::read(core::BoardReport& report) {
    if (m_reports.empty())
        return Read::nothing;
    report = m_reports.front();
    m_reports.pop_front();
    return Read::report;
}

Answer ModbusBraceletPort::writeAll(const core::Drive& drive) {
    const std::int64_t begin_ns = m_clock->now_ns();
    Answer answer = m_link->write(m_tactors.address, tactorWords(m_tactors, toIntensities(drive)));
    if (answer.done() && m_watchdogAddress) {
        const std::array<std::uint16_t, 1> count = {++m_watchdog};
        answer = m_link->write(*m_watchdogAddress, count);
    }
    const bool inTime = core::isOff(drive) || m_clock->now_ns() - begin_ns <= kLongestFrame_ns;
    return answer.done() && inTime ? readBoard() : answer;
}

Answer ModbusBraceletPort::readBoard() {
    const std::int64_t now_ns = m_clock->now_ns();
    if (m_boardValues.empty() || (m_boardWasRead && now_ns - m_boardRead_ns < kBoardPeriod_ns))
        return {};
    m_boardRead_ns = now_ns;
    m_boardWasRead = true;
    return m_boardReader.read(*m_link, m_boardValues);
}

void ModbusBraceletPort::zeroOnTheWayOut(const Answer& answer) {
    const std::vector<std::uint16_t> zero = tactorWords(m_tactors, {});
    if (answer.kind == Answer::Kind::exception)
        (void)m_link->write(m_tactors.address, zero);
    else
        m_link->writeUnanswered(m_tactors.address, zero);
}

bool ModbusBraceletPort::statusBit(std::optional<int> bit) const {
    if (!bit)
        return false;
    const auto raw = static_cast<std::uint64_t>(static_cast<std::int64_t>(m_boardValues.front()));
    return ((raw >> static_cast<unsigned>(*bit)) & 1U) != 0;
}

} // namespace teleta::modbus
