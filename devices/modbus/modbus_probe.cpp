// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/modbus_probe.h"

#include "backend/core/quantile.h"
#include "devices/modbus/input_reader.h"
#include "devices/modbus/modbus_bracelet.h"

#include <array>

namespace teleta::modbus {

namespace {

core::Unexpected failed(const Answer& answer) {
    return core::Unexpected(core::Error{core::ErrorKind::unavailable, describe(answer), {}, {}});
}

/// Reads all inputs some times.
core::Expected<void> probeInputs(const RegisterMap& map, RegisterLink& link, const core::PacingClock& clock,
                                 ModbusProbe& probe) {
    InputReader reader(map.inputs);
    probe.values.assign(reader.inputs(), 0.0);
    std::array<std::int64_t, 5> durations_ns{};
    for (std::int64_t& duration_ns : durations_ns) {
        const std::int64_t begin_ns = clock.now_ns();
        if (const Answer answer = reader.read(link, probe.values); !answer.done())
            return failed(answer);
        duration_ns = clock.now_ns() - begin_ns;
    }
    const std::int64_t median_ns = core::upperMedianOf(durations_ns);
    if (median_ns > 0)
        probe.inputRate_Hz = 1e9 / static_cast<double>(median_ns);
    return {};
}

} // namespace

core::Expected<ModbusProbe> probeModbus(const RegisterMap& map, const LinkOpener& opener,
                                        const std::shared_ptr<const core::PacingClock>& clock) {
    ModbusProbe probe;
    if (map.tactors) {
        TELETA_TRY(const auto opened, modbusBraceletOpener(map, opener, clock)());
        probe.frameRate_Hz = opened.description.maximumRate_Hz;
    }
    if (map.inputs.empty())
        return probe;
    TELETA_TRY(const auto link, opener());
    TELETA_CHECK(probeInputs(map, *link, *clock, probe));
    return probe;
}

} // namespace teleta::modbus
