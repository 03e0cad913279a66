// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/core/keys/toml_keys.h"
#include "devices/modbus/register_map.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <utility>

namespace teleta::modbus {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;

struct RegisterMapReader {
    Q_DECLARE_TR_FUNCTIONS(RegisterMapReader)
};

constexpr int kRegisters = 65536;
constexpr double kFastestInputs_Hz = 1000.0;
const NumberRange kAny = NumberRange::any();

void refuse(Keys& keys, std::string_view key, const QString& message, const QString& expected) {
    keys.refuse(key, message.toStdString(), expected.toStdString());
}

void describeAddress(Keys& keys, std::uint16_t& address, std::string_view about) {
    keys.whole("address", address, {0, kRegisters - 1}, about);
}

void describeFormat(Keys& keys, RegisterFormat& format) {
    keys.choice("type", format.type, {"int16", "uint16", "int32", "float32"}, "How the value is stored");
    keys.choice("word_order", format.order, {"high_first", "low_first"}, "Which of two registers comes first",
                Need::optional);
    keys.number("scale", format.scale, kAny, "Value of one count, not 0", Need::optional);
    if (format.scale == 0.0)
        refuse(keys, "scale", RegisterMapReader::tr("\"scale\" is 0"),
               RegisterMapReader::tr("the value of one count"));
    keys.number("offset", format.offset, kAny, "Value at 0 counts", Need::optional);
}

/// Registers from the address on, so many, must exist.
void checkEnd(Keys& keys, int address, std::size_t count) {
    if (address + static_cast<int>(count) > kRegisters)
        refuse(keys, "address", RegisterMapReader::tr("the last register would be beyond 65535"),
               RegisterMapReader::tr("an address of at most %1").arg(kRegisters - static_cast<int>(count)));
}

void describeInput(Keys& keys, InputRegister& input) {
    keys.choice("table", input.table, {"holding", "input"}, "Which table of registers it is in",
                Need::optional);
    describeAddress(keys, input.address, "The register, counted from 0");
    describeFormat(keys, input.format);
    checkEnd(keys, input.address, registersOf(input.format.type));
}

void describeTcp(Keys& keys, RegisterMap& map) {
    TcpLink tcp;
    keys.text("host", tcp.host, "Name or address of the device");
    keys.whole("port", tcp.port, {1, 65535}, "Its port", Need::optional);
    keys.whole("server", map.server, {0, 255}, "Unit identifier", Need::optional);
    map.link = tcp;
}

void describeRtu(Keys& keys, RegisterMap& map) {
    constexpr std::string_view kParities = "NEO";
    RtuLink rtu;
    keys.text("path", rtu.path, "The serial port, as `/dev/ttyUSB0`");
    keys.whole("baud", rtu.baud, {300, 4'000'000}, "Bits a second", Need::optional);
    keys.choose("parity", kParities.find(rtu.parity), {"none", "even", "odd"}, "Parity of a byte",
                Need::optional, [&](Keys&, std::size_t chosen) { rtu.parity = kParities[chosen]; });
    keys.whole("stop_bits", rtu.stopBits, {1, 2}, "Stop bits of a byte", Need::optional);
    keys.whole("server", map.server, {1, 247}, "Address of the device on the line", Need::optional);
    map.link = rtu;
}

void describeLink(Keys& keys, RegisterMap& map) {
    keys.choose("kind", map.link.index(),
                {{"tcp", "Modbus over a network"}, {"rtu", "Modbus over a serial line"}},
                "How the device is connected", Need::required, [&map](Keys& same, std::size_t chosen) {
                    chosen == 0 ? describeTcp(same, map) : describeRtu(same, map);
                });
    keys.number("answer_timeout_s", map.answerTimeout_s, NumberRange::between(0.001, 10.0),
                "How long an answer may take; at most 0.2 s for a device with motors", Need::optional);
}

void describeTactors(Keys& keys, TactorRegisters& tactors) {
    describeAddress(keys, tactors.address, "Register of the first motor; the others follow");
    describeFormat(keys, tactors.format);
    checkEnd(keys, tactors.address, tactors.registers());
    keys.text("unit", tactors.unit, "Unit of off, start and full");
    keys.number("off", tactors.off, kAny, "Value at which a motor stands", Need::optional);
    keys.number("full", tactors.full, kAny, "Value at which it runs as fast as it can");
    tactors.start = tactors.off;
    keys.number("start", tactors.start, kAny, "Value of the weakest intensity; otherwise that of off",
                Need::optional);
    const std::array<std::pair<const char*, double>, 3> levels = {
        {{"off", tactors.off}, {"start", tactors.start}, {"full", tactors.full}}};
    for (const auto& [key, value] : levels) {
        if (!representable(tactors.format, value))
            refuse(keys, key,
                   RegisterMapReader::tr("\"%1\" does not fit into the register").arg(QLatin1String(key)),
                   RegisterMapReader::tr("a value that type, scale and offset can express"));
    }
    if (tactors.full == tactors.off)
        refuse(keys, "full", RegisterMapReader::tr("\"full\" and \"off\" are the same"),
               RegisterMapReader::tr("a value at which the motor runs as fast as it can"));
    // A driver may work the other way round: the more, the slower.
    const double ofFull = (tactors.start - tactors.off) / (tactors.full - tactors.off);
    if (!(ofFull >= 0.0 && ofFull <= 1.0))
        refuse(keys, "start", RegisterMapReader::tr("\"start\" is not between \"off\" and \"full\""),
               RegisterMapReader::tr("the value of the weakest intensity"));
}

void describeStatus(Keys& keys, StatusRegister& status) {
    describeInput(keys, status.input);
    status.input.name = "status";
    const core::WholeRange bits{0, 16 * static_cast<long long>(registersOf(status.input.format.type)) - 1,
                                "bits of the type - 1"};
    keys.whole("timed_out_bit", status.timedOutBit, bits,
               "Bit that tells that the watchdog has stopped the motors");
    keys.whole("too_hot_bit", status.tooHotBit, bits, "Bit that tells that the driver is too hot");
    keys.whole("supply_low_bit", status.supplyLowBit, bits, "Bit that tells that the supply is too low");
    if (status.input.format.type == RegisterType::float32)
        refuse(keys, "type", RegisterMapReader::tr("a float has no bits to look at"),
               RegisterMapReader::tr("one of: %1").arg(QStringLiteral("int16, uint16, int32")));
}

/// Index of the input of this name, which must be in this unit.
std::size_t inputNamed(Keys& keys, std::string_view key, const std::string& name, const std::string& unit,
                       const std::vector<InputRegister>& inputs) {
    const auto found = std::ranges::find(inputs, name, &InputRegister::name);
    if (found == inputs.end()) {
        // A text that is missing or of the wrong type has its own message.
        if (!name.empty())
            refuse(keys, key,
                   RegisterMapReader::tr("there is no input \"%1\"").arg(QString::fromStdString(name)),
                   RegisterMapReader::tr("the name of an [[input]]"));
        return 0;
    }
    if (found->unit != unit)
        refuse(keys, key,
               RegisterMapReader::tr("the unit of \"%1\" is \"%2\"")
                   .arg(QString::fromStdString(name), QString::fromStdString(found->unit)),
               RegisterMapReader::tr("an input in %1").arg(QString::fromStdString(unit)));
    return static_cast<std::size_t>(found - inputs.begin());
}

void describeJoints(Keys& keys, RegisterMap& map) {
    keys.tables("joint", map.joints, 0, "The joints of an arm, from the base to the tip",
                [&map](Keys& table, std::vector<JointRegisters>& all, std::size_t i) {
                    const auto input = [&](std::string_view key, const char* unit, std::string_view about) {
                        std::string name;
                        table.text(key, name, about);
                        return inputNamed(table, key, name, unit, map.inputs);
                    };
                    all[i].angle = input("angle", "rad", "Name of the input with its angle");
                    all[i].torque = input("torque", "N m", "Name of the input with its torque");
                });
    if (map.joints.size() > core::JointVector::kCapacity)
        refuse(
            keys, "joint", RegisterMapReader::tr("too many joints: %1").arg(map.joints.size()),
            RegisterMapReader::tr("at most %1, from the base to the tip").arg(core::JointVector::kCapacity));
}

void describeWatchdog(Keys& keys, RegisterMap& map) {
    constexpr std::string_view kAbout = "Register that counts up with every cycle: the driver turns its "
                                        "motors off when it stands still; not needed "
                                        "with by_traffic";
    const core::WholeRange range{0, kRegisters - 1};
    keys.flag("by_traffic", map.watchedByTraffic, "The driver turns its motors off when nothing is written");
    if (map.watchedByTraffic)
        keys.whole("address", map.watchdogAddress, range, kAbout);
    else
        keys.whole("address", map.watchdogAddress.emplace(), range, kAbout);
    const int address = map.watchdogAddress ? *map.watchdogAddress : -1;
    if (map.tactors && address >= map.tactors->address &&
        address < map.tactors->address + static_cast<int>(map.tactors->registers()))
        refuse(keys, "address", RegisterMapReader::tr("the watchdog is a register of a motor"),
               RegisterMapReader::tr("a register of its own"));
}

void describeOneInput(Keys& keys, std::vector<InputRegister>& inputs, std::size_t i) {
    InputRegister& input = inputs[i];
    keys.text("name", input.name, "Name of the quantity");
    describeInput(keys, input);
    keys.text("unit", input.unit, "Its unit, `1` for none");
    const auto before = inputs.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find_if(inputs.begin(), before,
                     [&](const InputRegister& other) { return other.name == input.name; }) != before)
        refuse(keys, "name",
               RegisterMapReader::tr("the name \"%1\" is used twice").arg(QString::fromStdString(input.name)),
               RegisterMapReader::tr("a name of its own for each input"));
}

void describeNamedInput(Keys& keys, std::string_view key, std::optional<std::size_t>& input,
                        const std::string& unit, const std::vector<InputRegister>& inputs,
                        std::string_view about) {
    std::string name;
    keys.text(key, name, about, Need::optional);
    if (!name.empty())
        input = inputNamed(keys, key, name, unit, inputs);
}

} // namespace

void RegisterMap::describeKeys(Keys& keys) {
    keys.word("kind", "modbus", "A device with Modbus registers");
    keys.text("name", name, "Name on the screen");
    keys.number("input_rate_Hz", inputRate_Hz, NumberRange::positiveUpTo(kFastestInputs_Hz),
                "How often the inputs are read", Need::optional);
    keys.table("link", "How the device is reached", Need::required,
               [this](Keys& table) { describeLink(table, *this); });
    keys.table("tactors", tactors, "The six motors, in neighbouring registers",
               [](Keys& table, TactorRegisters& known) { describeTactors(table, known); });
    bool watched = false;
    keys.table("watchdog", "What turns the motors off when the program is killed; required with [tactors]",
               Need::optional, [&](Keys& table) {
                   watched = true;
                   describeWatchdog(table, *this);
               });
    keys.table("status", status, "Register with bits that tell what is wrong",
               [](Keys& table, StatusRegister& known) { describeStatus(table, known); });
    keys.tables("input", inputs, 0, "Quantities that are read", describeOneInput);
    describeJoints(keys, *this);
    describeNamedInput(keys, "supply", supply, "V", inputs, "Name of the input with the supply voltage");
    describeNamedInput(keys, "temperature", temperature, "degC", inputs,
                       "Name of the input with the temperature");
    if (watched && !tactors)
        refuse(keys, "watchdog", RegisterMapReader::tr("there is no motor to watch"),
               RegisterMapReader::tr("a table [tactors]"));
    if (tactors && !watched)
        refuse(keys, "tactors",
               RegisterMapReader::tr(
                   "nothing turns the motors off when the program is killed or the line is cut"),
               RegisterMapReader::tr("[watchdog] with the address of the driver's watchdog register, or with "
                                     "by_traffic = true where it turns them off when nothing is written"));
    if (tactors && answerTimeout_s > kLongestMotorTimeout_s)
        refuse(keys, "link",
               RegisterMapReader::tr(
                   "\"answer_timeout_s\" is too long for motors: STOP may have to wait for it"),
               RegisterMapReader::tr("at most %1 s").arg(kLongestMotorTimeout_s));
    if (!tactors && inputs.empty())
        refuse(keys, "link", RegisterMapReader::tr("the file names no register"),
               RegisterMapReader::tr("[tactors] or [[input]]"));
}

core::Expected<RegisterMap> readRegisterMap(const std::string& path) {
    auto document = core::TomlDocument::open(path);
    if (!document && document.error().kind == core::ErrorKind::notFound && path.starts_with(":/"))
        return core::failed(core::ErrorKind::notFound,
                            RegisterMapReader::tr("no such device comes with the program"), {}, {path});
    return document.and_then(core::readKeys<RegisterMap>);
}

core::Expected<RegisterMap> parseRegisterMap(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(core::readKeys<RegisterMap>);
}

} // namespace teleta::modbus
