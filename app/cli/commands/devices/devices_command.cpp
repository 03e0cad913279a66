// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/camera/gel_frames.h"
#include "app/cli/commands/devices/device_files.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "app/cli/commands/devices/found_device.h"
#include "app/cli/commands/devices/measured_rate.h"
#include "app/cli/commands/devices/ros_probes.h"
#include "app/cli/commands/devices/taxels_report.h"
#include "backend/core/beside_file.h"
#include "backend/core/data/output_file.h"
#include "backend/core/data/sample_block.h"
#include "backend/core/failure.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/vision/gel/marker_gel.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "devices/bracelet/hid_bracelet.h"
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/camera/camera_list.h"
#include "devices/camera/video_stream.h"
#include "devices/link/link_address.h"
#include "devices/modbus/libmodbus_link.h"
#include "devices/modbus/modbus_probe.h"
#include "devices/mouse3d/hid_input.h"
#include "devices/sound_bracelet/latency/sound_latency_file.h"
#include "devices/sound_bracelet/sound_bracelet.h"
#include "devices/taxels/magnetometers_file.h"
#include "devices/taxels/taxels_file.h"
#include "devices/taxels/taxels_probe.h"
#include "devices/wts/wts_device.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct DevicesText {
    Q_DECLARE_TR_FUNCTIONS(DevicesCommand)
};

void open(FoundDevice& found, const bracelet::HidBraceletConfig& config) {
    const core::StopSwitch stopSwitch;
    const auto opened = bracelet::openHidBracelet(config, stopSwitch);
    found.error = errorOf(opened);
    if (opened) {
        found.name = (*opened)->description().name;
        found.frameRate_Hz = (*opened)->description().maximumRate_Hz;
    }
}

FoundDevice describeBracelet(const hid::HidDeviceInfo& info) {
    FoundDevice found{.kind = "hid_bracelet", .name = info.product, .where = info.path};
    bracelet::HidBraceletConfig config;
    config.serial = info.serial;
    open(found, config);
    return found;
}

std::vector<FoundDevice> listDevices() {
    std::vector<FoundDevice> devices;
    for (const hid::HidDeviceInfo& info : bracelet::listHidBracelets())
        devices.push_back(describeBracelet(info));
    for (const hid::HidDeviceInfo& info : mouse3d::listMice())
        devices.push_back({.kind = "mouse3d",
                           .name = info.product,
                           .where = info.path,
                           .error = errorOf(mouse3d::openMouse(info))});
    for (const camera::CameraInfo& info : camera::listCameras())
        devices.push_back({.kind = "camera",
                           .name = info.name,
                           .where = "/dev/video" + std::to_string(info.number),
                           .error = info.error});
    return devices;
}

core::Expected<FoundDevice> probeRegisters(const std::string& path) {
    TELETA_TRY(const auto map, modbus::readRegisterMap(path));
    FoundDevice found{.kind = "modbus", .name = map.name, .where = modbus::linkName(map)};
    const auto probe =
        modbus::probeModbus(map, modbus::libmodbusOpener(map), std::make_shared<const core::PacingClock>());
    found.error = errorOf(probe);
    if (probe) {
        found.frameRate_Hz = probe->frameRate_Hz;
        found.inputRate_Hz = probe->inputRate_Hz;
        for (std::size_t i = 0; i < probe->values.size(); ++i)
            found.values.push_back({map.inputs[i].name, probe->values[i], map.inputs[i].unit});
    }
    return found;
}

core::Expected<FoundDevice> probeBracelet(const std::string& path) {
    TELETA_TRY(const auto file, bracelet::readHidBracelet(path));
    FoundDevice found{.kind = "hid_bracelet", .name = file.name, .where = "USB"};
    for (const hid::HidDeviceInfo& info : bracelet::listHidBracelets(file.config)) {
        if (file.config.serial.empty() || info.serial == file.config.serial) {
            found.where = info.path;
            break;
        }
    }
    open(found, file.config);
    return found;
}

/// Opens the card and plays silence for a moment. latencyInput: an input on which clicks are heard; empty:
/// none are played.
core::Expected<FoundDevice> probeSound(const std::string& path, const std::string& latencyInput) {
    constexpr std::chrono::milliseconds kLook{50};
    constexpr int kLooks = 20;
    TELETA_TRY(const auto file, sound::readSoundBracelet(path));
    FoundDevice found{.kind = "sound_bracelet", .name = file.name, .where = file.device};
    const core::StopSwitch stopSwitch;
    const auto opened = sound::openSoundBracelet(file, stopSwitch);
    found.error = errorOf(opened);
    if (!opened)
        return found;
    core::BraceletSource& bracelet = **opened;
    const core::BraceletDescription& description = bracelet.description();
    found.where = description.model;
    found.frameRate_Hz = description.maximumRate_Hz;
    core::Wakeup wakeup;
    bracelet.start(wakeup);
    for (int i = 0; i < kLooks && !interrupted(); ++i)
        (void)wakeup.waitFor(kLook);
    const core::DeviceStatus status = bracelet.status();
    if (bracelet.connection() == 0)
        found.error = core::Error{core::ErrorKind::unavailable, status.message, {}, {found.where}};
    found.values = {{"period", file.period_s(), "s"}, {"stated_latency", description.statedLatency_s, "s"}};
    if (!latencyInput.empty() && !found.error) {
        playback::Player player(bracelet, stopSwitch);
        const auto latency = sound::measureSoundLatency(file, bracelet, player, latencyInput,
                                                        {.goesOn = [] { return !interrupted(); }});
        if (latency) {
            found.values.push_back({"latency", latency->median_s(), "s"});
            found.values.push_back({"latency_spread", latency->spread_s(), "s"});
            found.lines = sound::latencyLines(*latency);
        } else {
            found.error = interruptedInstead(latency.error());
        }
    } else if (std::isfinite(description.measuredLatency_s)) {
        found.values.push_back({"measured_latency", description.measuredLatency_s, "s"});
        if (std::isfinite(description.latencySpread_s))
            found.values.push_back({"measured_latency_spread", description.latencySpread_s, "s"});
    }
    if (const auto& sound = bracelet.telemetry().board.sound) {
        found.values.push_back({"callback_share", sound->meanShare, "1"});
        found.values.push_back({"missed_periods", static_cast<double>(sound->missedPeriods), "1"});
    }
    bracelet.stop();
    return found;
}

core::Expected<FoundDevice> probeArray(const core::TomlDocument& document) {
    TELETA_TRY(const ArrayFile file, core::readKeys<ArrayFile>(document));
    FoundDevice found{.kind = "wts", .name = file.name, .where = file.address};
    wts::WtsConfig config;
    config.address = wts::parseWtsAddress(file.address, file.baud).value();
    const auto opened = wts::WtsDevice::open(std::move(config));
    found.error = errorOf(opened);
    if (opened) {
        found.frameRate_Hz = lookAt(**opened).rate_Hz;
        if (!found.frameRate_Hz)
            found.error = core::Error{core::ErrorKind::unavailable,
                                      DevicesText::tr("it answers, but sends no frames").toStdString(),
                                      {},
                                      {file.address}};
        const core::SourceDescription& array = (*opened)->description();
        found.values = {{"rows", static_cast<double>(array.layout.grid().rows), "1"},
                        {"columns", static_cast<double>(array.layout.grid().columns), "1"},
                        {"pitch", array.layout.grid().largerPitch_m(), "m"}};
    }
    return found;
}

/// What a camera or a video said of its pictures.
void takePictures(const camera::CameraProbe& probe, FoundDevice& found) {
    if (probe.measuredRate_Hz)
        found.frameRate_Hz = probe.measuredRate_Hz;
    else if (probe.nominalRate_Hz > 0.0)
        found.frameRate_Hz = probe.nominalRate_Hz;
    found.values = {{"width", static_cast<double>(probe.width_px), "px"},
                    {"height", static_cast<double>(probe.height_px), "px"}};
}

core::Expected<FoundDevice> probeCamera(const core::TomlDocument& document) {
    TELETA_TRY(const CameraFile file, core::readKeys<CameraFile>(document));
    FoundDevice found{.kind = "camera", .name = file.name, .where = file.source};
    const auto probe = camera::probeCamera(file.source, file.width_px, file.height_px, file.rate_Hz);
    found.error = errorOf(probe);
    if (probe)
        takePictures(*probe, found);
    return found;
}

core::Expected<FoundDevice> probeGel(const std::string& path) {
    TELETA_TRY(const auto file, vision::readMarkerGel(path));
    const std::string source =
        camera::isCameraNumber(file.source) ? file.source : core::besideFile(path, file.source);
    FoundDevice found{.kind = "marker_gel", .name = file.name, .where = source};
    if (file.source.empty()) {
        found.error =
            core::Error{core::ErrorKind::badInput,
                        DevicesText::tr("the sensor file names no camera and no video").toStdString(),
                        DevicesText::tr("a key \"source\"").toStdString(),
                        {path}};
        return found;
    }
    const auto probe = camera::probeCamera(source, file.width_px, file.height_px, file.rate_Hz);
    found.error = errorOf(probe);
    if (!probe)
        return found;
    takePictures(*probe, found);
    const auto frames = firstGelFrames(file, source);
    if (!frames || frames->empty()) {
        found.error = errorOf(frames);
        return found;
    }
    const auto gel = vision::MarkerGel::make(file, *frames);
    found.error = errorOf(gel);
    if (gel) {
        found.values.push_back({"markers", static_cast<double>(gel->markers().size()), "1"});
        found.values.push_back({"marker_diameter", gel->diameter_px(), "px"});
        found.values.push_back({"marker_pitch", gel->pitch_px(), "px"});
        found.values.push_back({"place_noise", gel->noise_px(), "px"});
    }
    return found;
}

/// What is wrong with what came, in which there is no frame.
QString withoutFrames(const taxels::TaxelsProbe& probe, const std::string& kind) {
    if (probe.bytes.empty())
        return DevicesText::tr("nothing came from it");
    const std::optional<int> chips = kind == "magnetometers" ? taxels::chipsOf(probe.bytes) : std::nullopt;
    return chips ? DevicesText::tr("it sends frames of %n chip(s)", nullptr, *chips)
                 : DevicesText::tr("there is no frame in what came from it, as the file describes them");
}

core::Expected<FoundDevice> probeStream(const std::string& path, const std::string& kind, std::size_t bytes) {
    TELETA_TRY(auto file, taxels::readTaxels(path));
    if (!file.loads.empty())
        TELETA_CHECK(pipeline::FrameLoads::read(file.loads, file.grid.layout(), file.grid.loadUnit()));
    FoundDevice found{.kind = kind, .name = file.name, .where = link::displayName(file.address)};
    auto probe = taxels::probeTaxels(file, {.bytes = bytes}, [] { return interrupted(); });
    found.error = errorOf(probe);
    if (!probe)
        return found;
    found.frameRate_Hz = probe->rate_Hz;
    if (probe->frames.empty())
        found.error = core::Error{
            core::ErrorKind::unavailable, withoutFrames(*probe, kind).toStdString(), {}, {found.where}};
    for (std::size_t i = 0; i < probe->others.size(); ++i)
        found.values.push_back(
            {"temperature_" + std::to_string(i), static_cast<double>(probe->others[i]), "degC"});
    if (const auto& moved = probe->drift.largest())
        found.values.push_back({"temperature_change", moved->change_K, "K"});
    if (probe->drift.isTold())
        found.warning =
            DevicesText::tr("the temperature of chip %1 changed by %2 K while it was probed: what the sensor "
                            "reads at rest moves with it. Wait until it is warm")
                .arg(probe->drift.largest()->chip)
                .arg(forPeople(probe->drift.largest()->change_K))
                .toStdString();
    found.stream.emplace(TaxelsReport{std::move(*probe), file.grid.layout(), file.grid.unit()});
    return found;
}

core::Expected<FoundDevice> probeFile(const std::string& path, std::size_t bytes,
                                      const std::string& latencyInput) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    core::TomlTable root = document.root();
    const std::size_t kind =
        root.choice("kind", {"modbus", "wts", "camera", "hid_bracelet", "taxels", "magnetometers", "xela",
                             "sound_bracelet", "marker_gel", "ros_tactile", "ros_camera"});
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    // Without a kind the other keys say nothing either.
    if (!root.has("kind")) {
        root.finish();
        return core::failed(
            core::ErrorKind::badInput, DevicesText::tr("\"kind\" is missing"),
            DevicesText::tr("kind = \"modbus\", \"wts\", \"camera\", \"hid_bracelet\", \"taxels\", "
                            "\"magnetometers\", \"xela\", \"sound_bracelet\", \"marker_gel\", "
                            "\"ros_tactile\" or \"ros_camera\""),
            {path, 1, 1});
    }
    if (!latencyInput.empty() && kind != 7)
        refuse("--latency", DevicesText::tr("this is for a bracelet on a sound card"));
    if (kind == 0)
        return probeRegisters(path);
    if (kind == 3)
        return probeBracelet(path);
    if (kind == 7)
        return probeSound(path, latencyInput);
    if (kind == 8)
        return probeGel(path);
    if (kind == 9)
        return probeRosArray(path);
    if (kind == 10)
        return probeRosCamera(path);
    if (const std::string name = root.text("kind"); taxels::isArrayKind(name))
        return probeStream(path, name, bytes);
    return kind == 1 ? probeArray(document) : probeCamera(document);
}

nlohmann::ordered_json toJson(const FoundDevice& device) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const DeviceValue& value : device.values)
        values.push_back({{"name", value.name}, {"value", value.value}, {"unit", value.unit}});
    nlohmann::ordered_json json{{"kind", device.kind},
                                {"name", device.name},
                                {"where", device.where},
                                {"connected", !device.error},
                                {"reason", device.error
                                               ? nlohmann::ordered_json(core::describe(*device.error))
                                               : nlohmann::ordered_json(nullptr)},
                                {"frame_rate_hz", orNull(device.frameRate_Hz)},
                                {"input_rate_hz", orNull(device.inputRate_Hz)},
                                {"values", std::move(values)}};
    if (!device.warning.empty())
        json["warning"] = device.warning;
    if (device.stream)
        json["stream"] = toJson(*device.stream);
    return json;
}

bool isArray(const std::string& kind) {
    return kind == "wts" || kind == "ros_tactile" || taxels::isArrayKind(kind);
}

QString kindName(const std::string& kind) {
    if (kind == "hid_bracelet" || kind == "sound_bracelet")
        return DevicesText::tr("Bracelet");
    if (kind == "mouse3d")
        return DevicesText::tr("3D mouse");
    if (isArray(kind))
        return DevicesText::tr("Tactile array");
    if (kind == "camera" || kind == "ros_camera")
        return DevicesText::tr("Camera");
    if (kind == "marker_gel")
        return DevicesText::tr("Flat gel with markers");
    return DevicesText::tr("Modbus device");
}

QString withUnit(const DeviceValue& value) {
    const QString number = forPeople(value.value);
    return value.unit == "1" ? number : number + QLatin1Char(' ') + QString::fromStdString(value.unit);
}

core::Expected<void> printTable(const std::vector<FoundDevice>& devices) {
    Fields fields;
    for (const FoundDevice& device : devices) {
        if (!fields.empty())
            fields.emplace_back();
        fields.emplace_back(kindName(device.kind), DevicesText::tr("%1 at %2")
                                                       .arg(QString::fromStdString(device.name),
                                                            QString::fromStdString(device.where)));
        fields.emplace_back(DevicesText::tr("State"),
                            device.error ? DevicesText::tr("not connected: %1")
                                               .arg(QString::fromStdString(core::describe(*device.error)))
                                         : DevicesText::tr("connected"));
        if (device.frameRate_Hz)
            fields.emplace_back(DevicesText::tr("Frames"),
                                isArray(device.kind)
                                    ? DevicesText::tr("%1 Hz").arg(forPeople(*device.frameRate_Hz))
                                    : DevicesText::tr("up to %1 Hz").arg(forPeople(*device.frameRate_Hz)));
        if (device.inputRate_Hz)
            fields.emplace_back(DevicesText::tr("Inputs"),
                                DevicesText::tr("up to %1 Hz").arg(forPeople(*device.inputRate_Hz)));
        for (const DeviceValue& value : device.values)
            fields.emplace_back(QString::fromStdString(value.name), withUnit(value));
        if (!device.warning.empty())
            fields.emplace_back(DevicesText::tr("Warning"), QString::fromStdString(device.warning));
        if (device.stream)
            addFields(*device.stream, fields);
    }
    if (fields.empty())
        fields.emplace_back(DevicesText::tr("No device is connected."), QString());
    TELETA_CHECK(printFields(fields));
    for (const FoundDevice& device : devices) {
        if (device.stream)
            TELETA_CHECK(printText(textOf(*device.stream)));
        if (!device.lines.empty())
            TELETA_CHECK(printText(device.lines));
    }
    return {};
}

class DevicesCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "--probe", m_probePath,
                  DevicesText::tr(
                      "Connect to the device of this description and read it; its motors are set to zero"),
                  "DEVICE.toml");
        addOption(
            app, "--bytes", m_bytes,
            DevicesText::tr("Of a described array: show at most so many of the bytes that it sends until a "
                            "second after its first frame"),
            CLI::Range(1, 1'000'000).description(""), "N")
            ->needs("--probe");
        addOption(app, "--latency", m_latencyInput,
                  DevicesText::tr(
                      "Of a bracelet on a sound card: play clicks on tactor 1 and measure when they are "
                      "heard on this input, at which an accelerometer or a cable is"),
                  "INPUT")
            ->needs("--probe");
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        std::vector<FoundDevice> devices;
        if (m_probePath.empty()) {
            devices = listDevices();
        } else {
            TELETA_TRY(auto found, probeFile(m_probePath, m_bytes, m_latencyInput));
            devices.push_back(std::move(found));
        }
        if (m_json) {
            nlohmann::ordered_json list = nlohmann::ordered_json::array();
            for (const FoundDevice& device : devices)
                list.push_back(toJson(device));
            TELETA_CHECK(printDocument({{"devices", std::move(list)}}));
        } else {
            TELETA_CHECK(printTable(devices));
        }
        // A list tells what is there; a device that was asked for and is not there is a failure.
        if (m_probePath.empty() || !devices.front().error)
            return {};
        core::Error error = *devices.front().error;
        // The description was right: it is not the input's fault that a path or a host does not exist.
        error.kind = core::ErrorKind::unavailable;
        return core::Unexpected(std::move(error));
    }

private:
    std::string m_probePath;
    std::size_t m_bytes = 4096;
    std::string m_latencyInput;
    bool m_json = false;
};

} // namespace

Command devicesCommand() {
    return makeCommand<DevicesCommand>(
        "devices",
        DevicesText::tr("List connected devices, how fast they are, and why others cannot be used"),
        "teleta devices --json");
}

} // namespace teleta::cli
