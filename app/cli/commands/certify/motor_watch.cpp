// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/motor_watch.h"

#include "backend/core/steady_time.h"
#include "devices/modbus/libmodbus_link.h"

#include <algorithm>
#include <chrono>

namespace teleta::cli {

namespace {

constexpr auto kPause = std::chrono::milliseconds(2);
constexpr std::size_t kLooksKept = 4096; ///< at least eight seconds
constexpr int kFailuresInARow = 20;

} // namespace

core::Expected<std::unique_ptr<MotorWatch>> MotorWatch::start(const modbus::RegisterMap& map) {
    TELETA_TRY(auto link, modbus::openLibmodbusLink(map));
    return std::make_unique<MotorWatch>(map, std::move(link));
}

MotorWatch::MotorWatch(modbus::RegisterMap map, std::unique_ptr<modbus::RegisterLink> link)
    : m_map(std::move(map))
    , m_off(modbus::tactorWords(*m_map.tactors, {}))
    , m_status(m_map.status && m_map.status->timedOutBit
                   ? std::optional<modbus::InputReader>(std::in_place, std::vector{m_map.status->input})
                   : std::nullopt)
    , m_link(std::move(link))
    , m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

ActuatorWatch::Look MotorWatch::newest() const {
    const std::lock_guard lock(m_mutex);
    return m_looks.empty() ? Look{} : m_looks.back();
}

std::optional<ActuatorWatch::Look> MotorWatch::offSince(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    std::optional<Look> first;
    for (auto look = m_looks.rbegin(); look != m_looks.rend() && look->asked_ns > from_ns && !look->on;
         ++look)
        first = *look;
    return first;
}

bool MotorWatch::wasOnAfter(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    return std::ranges::any_of(m_looks,
                               [from_ns](const Look& look) { return look.on && look.asked_ns > from_ns; });
}

std::int64_t MotorWatch::longestGap_ns(std::int64_t from_ns) const {
    const std::lock_guard lock(m_mutex);
    std::int64_t longest_ns = 0;
    for (std::size_t k = 1; k < m_looks.size(); ++k)
        if (m_looks[k].asked_ns > from_ns)
            longest_ns = std::max(longest_ns, m_looks[k].answered_ns - m_looks[k - 1].answered_ns);
    return longest_ns;
}

bool MotorWatch::failed() const {
    const std::lock_guard lock(m_mutex);
    return m_failed;
}

std::optional<bool> MotorWatch::readOn() {
    std::vector<std::uint16_t> words(m_off.size());
    if (!m_link->read(modbus::RegisterTable::holding, m_map.tactors->address, words).done())
        return std::nullopt;
    if (words == m_off)
        return false;
    if (!m_status)
        return true;
    double status = 0.0;
    if (!m_status->read(*m_link, {&status, 1}).done())
        return std::nullopt;
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(status));
    return ((bits >> static_cast<unsigned>(*m_map.status->timedOutBit)) & 1U) == 0;
}

void MotorWatch::run(const std::stop_token& stop) {
    int failures = 0;
    while (!stop.stop_requested()) {
        Look look{.asked_ns = core::steadyNow_ns()};
        const std::optional<bool> on = readOn();
        look.answered_ns = core::steadyNow_ns();
        failures = on ? 0 : failures + 1;
        {
            const std::lock_guard lock(m_mutex);
            m_failed = failures >= kFailuresInARow;
            if (on) {
                look.on = *on;
                if (m_looks.size() >= kLooksKept)
                    m_looks.erase(m_looks.begin(), m_looks.begin() + kLooksKept / 2);
                m_looks.push_back(look);
            }
        }
        std::this_thread::sleep_for(kPause);
    }
}

} // namespace teleta::cli
