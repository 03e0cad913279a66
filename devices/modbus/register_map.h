// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/tactors.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "devices/modbus/register_value.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace teleta::modbus {

struct TcpLink {
    std::string host; ///< name or address
    int port = 502;
};

struct RtuLink {
    std::string path; ///< of the serial port
    int baud = 115200;
    char parity = 'N'; ///< N, E or O
    int stopBits = 1;
};

/// The two tables of 16-bit registers that a server has.
enum class RegisterTable {
    holding, ///< function 3; can be written
    input,   ///< function 4; read-only
};

/// A quantity that is read.
struct InputRegister {
    std::string name;
    RegisterTable table = RegisterTable::holding;
    std::uint16_t address = 0; ///< as sent, counted from 0
    RegisterFormat format;
    std::string unit;
};

/// The six motors: contiguous registers, written together, tactor 1 first.
///   value = off                                  intensity 0
///   value = start + (full - start) * intensity   above it, in `unit`
struct TactorRegisters {
    std::uint16_t address = 0;
    RegisterFormat format;
    std::string unit;
    double off = 0.0;
    double start = 0.0;
    double full = 1.0;

    [[nodiscard]] std::size_t registers() const { return core::kTactors * registersOf(format.type); }
};

/// Bits of the status register, 0 the lowest; empty: the driver has none.
struct StatusRegister {
    InputRegister input;
    std::optional<int> timedOutBit;
    std::optional<int> tooHotBit;
    std::optional<int> supplyLowBit;
};

/// Which inputs belong to a joint: indices into RegisterMap::inputs.
struct JointRegisters {
    std::size_t angle = 0;  ///< in rad
    std::size_t torque = 0; ///< in N m
};

/// A frame may wait this long for its answer, and STOP may have to wait for the frame.
inline constexpr double kLongestMotorTimeout_s = 0.2;

/// A Modbus device as its TOML file describes it. A device with motors must have its own watchdog: nothing
/// else stops them when the program is killed.
struct RegisterMap {
    std::string name;
    std::variant<TcpLink, RtuLink> link;
    int server = 1;               ///< unit identifier
    double answerTimeout_s = 0.1; ///< also for connecting; with motors at most kLongestMotorTimeout_s
    double inputRate_Hz = 50.0;   ///< of reading the inputs
    std::optional<TactorRegisters> tactors;
    /// Holding register that counts up with every cycle; the driver turns its motors off when it stands
    /// still.
    std::optional<std::uint16_t> watchdogAddress;
    /// The driver needs no such register: it turns its motors off when nothing is written.
    bool watchedByTraffic = false;
    std::optional<StatusRegister> status;
    std::vector<InputRegister> inputs;
    std::optional<std::size_t> supply;      ///< input in V
    std::optional<std::size_t> temperature; ///< input in degC
    std::vector<JointRegisters> joints;     ///< from the base to the tip; empty: none

    void describeKeys(core::Keys& keys);
};

/// The link as people write it: "tcp://host:port" or the path of the serial port.
[[nodiscard]] std::string linkName(const RegisterMap& map);

/// Registers for these intensities, in one write. NaN is off, the rest is limited to 0..1. Returns
/// tactors.registers() words. Thread: any (pure).
[[nodiscard]] std::vector<std::uint16_t> tactorWords(const TactorRegisters& tactors,
                                                     const core::Intensities& intensities);

/// One read of neighbouring registers.
struct ReadRequest {
    RegisterTable table = RegisterTable::holding;
    std::uint16_t address = 0;
    int count = 0;
    std::vector<std::size_t> inputs; ///< indices of those that it brings
};

/// The fewest reads that cover these inputs. Only listed registers are read, since a server answers an
/// unknown one with an exception; at most 125 per read, as the protocol allows. Thread: any (pure).
[[nodiscard]] std::vector<ReadRequest> planReads(const std::vector<InputRegister>& inputs);

/// Reads the description of a device. path: a TOML file, or ":/devices/NAME.toml" for a built-in one.
/// Error: notFound, ioFailed, or badInput with line and column. Thread: any.
[[nodiscard]] core::Expected<RegisterMap> readRegisterMap(const std::string& path);
[[nodiscard]] core::Expected<RegisterMap> parseRegisterMap(std::string_view text, const std::string& file);

} // namespace teleta::modbus
