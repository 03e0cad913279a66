// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/toml_table.h"
#include "devices/modbus/register_map.h"

#include <QCoreApplication>
#include <QFile>
#include <QString>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::modbus {

namespace {

using core::NumberRange;
using core::TomlDocument;
using core::TomlTable;

struct RegisterMapReader {
    Q_DECLARE_TR_FUNCTIONS(RegisterMapReader)
};

constexpr int kRegisters = 65536;
constexpr double kFastestInputs_Hz = 1000.0;

void fail(TomlTable& table, std::string_view key, const QString& message, const QString& expected) {
    table.fail(key, message.toStdString(), expected.toStdString());
}

int address(TomlTable& table) {
    return static_cast<int>(table.integer("address", 0, kRegisters - 1));
}

RegisterFormat readFormat(TomlTable& table) {
    RegisterFormat format;
    constexpr std::array kTypes = {RegisterType::int16, RegisterType::uint16, RegisterType::int32,
                                   RegisterType::float32};
    format.type = kTypes.at(table.choice("type", {"int16", "uint16", "int32", "float32"}));
    if (table.has("word_order") && table.choice("word_order", {"high_first", "low_first"}) == 1)
        format.order = WordOrder::lowFirst;
    format.scale = table.number("scale", NumberRange::any(), 1.0);
    if (format.scale == 0.0)
        fail(table, "scale", RegisterMapReader::tr("\"scale\" is 0"),
             RegisterMapReader::tr("the value of one count"));
    format.offset = table.number("offset", NumberRange::any(), 0.0);
    return format;
}

/// Registers from `first` on, `count` of them, must exist.
void checkEnd(TomlTable& table, int first, std::size_t count) {
    if (first + static_cast<int>(count) > kRegisters)
        fail(table, "address", RegisterMapReader::tr("the last register would be beyond 65535"),
             RegisterMapReader::tr("an address of at most %1").arg(kRegisters - static_cast<int>(count)));
}

InputRegister readInput(TomlTable& table) {
    InputRegister input;
    if (table.has("table") && table.choice("table", {"holding", "input"}) == 1)
        input.table = RegisterTable::input;
    const int first = address(table);
    input.address = static_cast<std::uint16_t>(first);
    input.format = readFormat(table);
    checkEnd(table, first, registersOf(input.format.type));
    return input;
}

std::variant<TcpLink, RtuLink> readLink(TomlTable table, RegisterMap& map) {
    const bool rtu = table.choice("kind", {"tcp", "rtu"}) == 1;
    map.server = static_cast<int>(table.integer("server", rtu ? 1 : 0, rtu ? 247 : 255, 1));
    map.answerTimeout_s =
        table.number("answer_timeout_s", NumberRange::between(0.001, 10.0), map.answerTimeout_s);
    std::variant<TcpLink, RtuLink> link;
    if (rtu) {
        RtuLink serial;
        serial.path = table.text("path");
        serial.baud = static_cast<int>(table.integer("baud", 300, 4'000'000, serial.baud));
        if (table.has("parity"))
            serial.parity = "NEO"[table.choice("parity", {"none", "even", "odd"})];
        serial.stopBits = static_cast<int>(table.integer("stop_bits", 1, 2, serial.stopBits));
        link = serial;
    } else {
        TcpLink tcp;
        tcp.host = table.text("host");
        tcp.port = static_cast<int>(table.integer("port", 1, 65535, tcp.port));
        link = tcp;
    }
    table.finish();
    return link;
}

TactorRegisters readTactors(TomlTable table) {
    TactorRegisters tactors;
    const int first = address(table);
    tactors.address = static_cast<std::uint16_t>(first);
    tactors.format = readFormat(table);
    checkEnd(table, first, tactors.registers());
    tactors.unit = table.text("unit");
    tactors.off = table.number("off", NumberRange::any(), 0.0);
    tactors.full = table.number("full", NumberRange::any());
    tactors.start = table.number("start", NumberRange::any(), tactors.off);
    table.finish();
    const std::array<std::pair<const char*, double>, 3> levels = {
        {{"off", tactors.off}, {"start", tactors.start}, {"full", tactors.full}}};
    for (const auto& [key, value] : levels) {
        if (!representable(tactors.format, value))
            fail(table, key,
                 RegisterMapReader::tr("\"%1\" does not fit into the register").arg(QLatin1String(key)),
                 RegisterMapReader::tr("a value that type, scale and offset can express"));
    }
    if (tactors.full == tactors.off)
        fail(table, "full", RegisterMapReader::tr("\"full\" and \"off\" are the same"),
             RegisterMapReader::tr("a value at which the motor runs as fast as it can"));
    // A driver may work the other way round: the more, the slower.
    const double ofFull = (tactors.start - tactors.off) / (tactors.full - tactors.off);
    if (!(ofFull >= 0.0 && ofFull <= 1.0))
        fail(table, "start", RegisterMapReader::tr("\"start\" is not between \"off\" and \"full\""),
             RegisterMapReader::tr("the value of the weakest intensity"));
    return tactors;
}

StatusRegister readStatus(TomlTable table) {
    StatusRegister status;
    status.input = readInput(table);
    status.input.name = "status";
    const auto bit = [&table, &status](std::string_view key) -> std::optional<int> {
        if (!table.has(key))
            return std::nullopt;
        return static_cast<int>(
            table.integer(key, 0, 16 * static_cast<long long>(registersOf(status.input.format.type)) - 1));
    };
    status.timedOutBit = bit("timed_out_bit");
    status.tooHotBit = bit("too_hot_bit");
    status.supplyLowBit = bit("supply_low_bit");
    table.finish();
    if (status.input.format.type == RegisterType::float32)
        fail(table, "type", RegisterMapReader::tr("a float has no bits to look at"),
             RegisterMapReader::tr("one of: %1").arg(QStringLiteral("int16, uint16, int32")));
    return status;
}

/// Index of the input that a key names, which must be in this unit.
std::size_t inputNamed(TomlTable& table, std::string_view key, const std::string& unit,
                       const std::vector<InputRegister>& inputs) {
    const std::string name = table.text(key);
    const auto found = std::ranges::find(inputs, name, &InputRegister::name);
    if (found == inputs.end()) {
        // A text that is missing or of the wrong type has its own message.
        if (!name.empty())
            fail(table, key,
                 RegisterMapReader::tr("there is no input \"%1\"").arg(QString::fromStdString(name)),
                 RegisterMapReader::tr("the name of an [[input]]"));
        return 0;
    }
    if (found->unit != unit)
        fail(table, key,
             RegisterMapReader::tr("the unit of \"%1\" is \"%2\"")
                 .arg(QString::fromStdString(name), QString::fromStdString(found->unit)),
             RegisterMapReader::tr("an input in %1").arg(QString::fromStdString(unit)));
    return static_cast<std::size_t>(found - inputs.begin());
}

void readInputs(TomlTable& root, RegisterMap& map) {
    for (TomlTable& table : root.tables("input", 0)) {
        const std::string name = table.text("name");
        InputRegister input = readInput(table);
        input.name = name;
        input.unit = table.text("unit");
        table.finish();
        if (std::ranges::find(map.inputs, name, &InputRegister::name) != map.inputs.end())
            fail(table, "name",
                 RegisterMapReader::tr("the name \"%1\" is used twice").arg(QString::fromStdString(name)),
                 RegisterMapReader::tr("a name of its own for each input"));
        map.inputs.push_back(std::move(input));
    }
}

void readJoints(TomlTable& root, RegisterMap& map) {
    std::vector<TomlTable> tables = root.tables("joint", 0);
    if (tables.empty())
        return;
    if (tables.size() != core::kArmJoints) {
        fail(root, "joint", RegisterMapReader::tr("the number of joints is wrong: %1").arg(tables.size()),
             RegisterMapReader::tr("%1, from the shoulder on").arg(core::kArmJoints));
        return;
    }
    auto& joints = map.joints.emplace();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        joints[i].angle = inputNamed(tables[i], "angle", "rad", map.inputs);
        joints[i].torque = inputNamed(tables[i], "torque", "N m", map.inputs);
        tables[i].finish();
    }
}

core::Expected<RegisterMap> readDocument(const TomlDocument& document) {
    TomlTable root = document.root();
    RegisterMap map;
    (void)root.choice("kind", {"modbus"});
    map.name = root.text("name");
    map.inputRate_Hz =
        root.number("input_rate_Hz", {.low = 0.0, .high = kFastestInputs_Hz, .lowOpen = true}, 50.0);
    const TomlTable link = root.table("link");
    const auto optionalTable = [&root](std::string_view key) -> std::optional<TomlTable> {
        return root.has(key) ? std::optional(root.table(key)) : std::nullopt;
    };
    const auto tactors = optionalTable("tactors");
    const auto watchdog = optionalTable("watchdog");
    const auto status = optionalTable("status");
    map.link = readLink(link, map);
    readInputs(root, map);
    readJoints(root, map);
    if (root.has("supply"))
        map.supply = inputNamed(root, "supply", "V", map.inputs);
    if (root.has("temperature"))
        map.temperature = inputNamed(root, "temperature", "degC", map.inputs);
    root.finish();
    if (tactors)
        map.tactors = readTactors(*tactors);
    if (status)
        map.status = readStatus(*status);
    if (watchdog) {
        TomlTable table = *watchdog;
        map.watchedByTraffic = table.boolean("by_traffic", false);
        const int first = map.watchedByTraffic && !table.has("address") ? -1 : address(table);
        table.finish();
        if (first >= 0)
            map.watchdogAddress = static_cast<std::uint16_t>(first);
        const bool inTactors = map.tactors && first >= map.tactors->address &&
                               first < map.tactors->address + static_cast<int>(map.tactors->registers());
        if (inTactors)
            fail(table, "address", RegisterMapReader::tr("the watchdog is a register of a motor"),
                 RegisterMapReader::tr("a register of its own"));
        if (!map.tactors)
            fail(root, "watchdog", RegisterMapReader::tr("there is no motor to watch"),
                 RegisterMapReader::tr("a table [tactors]"));
    }
    if (map.tactors && !watchdog)
        fail(root, "tactors",
             RegisterMapReader::tr(
                 "nothing turns the motors off when the program is killed or the line is cut"),
             RegisterMapReader::tr("[watchdog] with the address of the driver's watchdog register, or with "
                                   "by_traffic = true where it turns them off when nothing is written"));
    if (map.tactors && map.answerTimeout_s > kLongestMotorTimeout_s)
        fail(root, "link",
             RegisterMapReader::tr(
                 "\"answer_timeout_s\" is too long for motors: STOP may have to wait for it"),
             RegisterMapReader::tr("at most %1 s").arg(kLongestMotorTimeout_s));
    if (!map.tactors && map.inputs.empty())
        fail(root, "link", RegisterMapReader::tr("the file names no register"),
             RegisterMapReader::tr("[tactors] or [[input]]"));
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return map;
}

} // namespace

core::Expected<RegisterMap> readRegisterMap(const std::string& path) {
    if (!path.starts_with(":/"))
        return TomlDocument::open(path).and_then(readDocument);
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(
            core::Error{core::ErrorKind::notFound,
                        RegisterMapReader::tr("no such device comes with the program").toStdString(),
                        {},
                        {path}});
    return parseRegisterMap(file.readAll().toStdString(), path);
}

core::Expected<RegisterMap> parseRegisterMap(std::string_view text, const std::string& file) {
    return TomlDocument::parse(text, file).and_then(readDocument);
}

} // namespace teleta::modbus
