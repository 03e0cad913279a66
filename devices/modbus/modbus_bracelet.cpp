// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_bracelet.h"

#include "backend/core/quantile.h"
#include "devices/modbus/libmodbus_link.h"
#include "devices/modbus/modbus_bracelet_port.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <utility>

namespace teleta::modbus {

namespace {

constexpr double kHighestRate_Hz = 200.0;
constexpr double kShareOfTime = 0.8; ///< of the line that frames may take; the rest is for late answers

core::Unexpected failed(core::ErrorKind kind, std::string message, std::string expected = {}) {
    return core::Unexpected(core::Error{kind, std::move(message), std::move(expected), {}});
}

/// 0: a frame was not taken.
double measureRate_Hz(ModbusBraceletPort& port, const core::PacingClock& clock) {
    std::array<std::int64_t, 5> durations_ns{};
    for (std::int64_t& duration_ns : durations_ns) {
        const std::int64_t begin_ns = clock.now_ns();
        if (!port.write(0, {}, 1))
            return 0.0;
        duration_ns = clock.now_ns() - begin_ns;
    }
    const double median_s = static_cast<double>(core::upperMedianOf(durations_ns)) * 1e-9;
    return median_s > 0.0 ? std::min(kHighestRate_Hz, kShareOfTime / median_s) : kHighestRate_Hz;
}

} // namespace

core::BraceletOpener modbusBraceletOpener(RegisterMap map, LinkOpener link,
                                          std::shared_ptr<const core::PacingClock> clock) {
    return [map = std::move(map), link = std::move(link),
            clock = std::move(clock)]() -> core::Expected<core::OpenedBracelet> {
        if (!map.tactors)
            return failed(
                core::ErrorKind::refused,
                QCoreApplication::translate("Modbus", "The device has no motors.").toStdString(),
                QCoreApplication::translate("Modbus", "a table [tactors] in its file").toStdString());
        TELETA_TRY(auto opened, link());
        auto port = std::make_unique<ModbusBraceletPort>(map, std::move(opened), clock);
        core::BraceletDescription description;
        // The first frame also connects caches and wakes the line: it is not measured.
        if (port->write(0, {}, 1))
            description.maximumRate_Hz = measureRate_Hz(*port, *clock);
        if (const std::string why = port->failure(); !why.empty())
            return failed(core::ErrorKind::unavailable, why);
        for (core::BoardReport report; port->read(report) != core::BraceletPort::Read::nothing;) {
        }
        description.name = map.name;
        description.model = "Modbus";
        description.serial = linkName(map) + '#' + std::to_string(map.server);
        return core::OpenedBracelet{std::move(port), std::move(description)};
    };
}

core::Expected<std::unique_ptr<core::BraceletLink>> openModbusBracelet(const RegisterMap& map,
                                                                       const core::StopSwitch& stopSwitch,
                                                                       core::BraceletLinkConfig config) {
    core::BraceletOpener opener = modbusBraceletOpener(map, libmodbusOpener(map), config.clock);
    TELETA_TRY(auto opened, opener());
    return std::make_unique<core::BraceletLink>(std::move(opened), std::move(opener), stopSwitch,
                                                std::move(config));
}

} // namespace teleta::modbus
