// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/certify/chain.h"

#include "app/cli/base/interruption.h"
#include "app/cli/commands/certify/chain_lines.h"
#include "app/common/version.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/playback/player.h"
#include "backend/recording/recorder.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/base/scene_settings.h"
#include "backend/simulation/array/simulated_array.h"
#include "devices/modbus/modbus_bracelet.h"
#include "devices/simulated/simulated_array_device.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>

namespace teleta::cli {

namespace {

/// A ball that presses all the time and moves to and fro.
constexpr std::string_view kScene = R"(
name = "Fault certificate"
description = "A ball presses on an array all the time and moves to and fro."
duration_s = 3600.0
rate_Hz = 200.0
[sensor]
kind = "array"
rows = 6
columns = 14
pitch_m = 0.0034
stiffness_N_per_m = 1200.0
full_scale_N = 2.89
firing_threshold_N = 0.2
[[indenter]]
name = "ball"
shape = "sphere"
radius_m = 0.0052
loop = true
keyframes = [
    { time_s = 0.0, x_m = -0.016, y_m = 0.002, depth_m = 0.0016 },
    { time_s = 1.0, x_m = 0.016, y_m = -0.002, depth_m = 0.0020 },
    { time_s = 2.0, x_m = -0.016, y_m = 0.002, depth_m = 0.0016 },
]
[[effects]]
name = "noise"
why = "A connected array is never quite still."
sd_N = 0.015
)";
/// Of all contacts together, at which the motors are fully on.
constexpr double kFullForce_N = 20.0;
constexpr double kLeast = 0.3; ///< so that a light touch counts as "on", too
constexpr auto kLookAtChain = std::chrono::milliseconds(20);

/// Tells what changes.
class Reporter {
public:
    void look(const playback::Player& player, const recording::Recorder& recorder) {
        const playback::PlayerStatus status = player.status();
        if (status.begun_ns != m_begun_ns && status.mode == playback::PlayerMode::live) {
            m_begun_ns = status.begun_ns;
            say("driving");
        }
        if (status.ended_ns != m_ended_ns && status.mode == playback::PlayerMode::idle) {
            m_ended_ns = status.ended_ns;
            say("idle");
        }
        const recording::RecorderStatus recorded = recorder.status();
        if (recorded.frames != m_safe) {
            m_safe = recorded.frames;
            say("safe " + std::to_string(m_safe));
        }
        if (recorded.state == recording::RecorderStatus::State::failed && !m_failed) {
            m_failed = true;
            say("recording failed");
        }
    }

private:
    std::int64_t m_begun_ns = 0;
    std::int64_t m_ended_ns = 0;
    std::uint64_t m_safe = 0;
    bool m_failed = false;
};

core::Intensities intensitiesOf(const pipeline::TouchSnapshot& snapshot) {
    core::Intensities intensities{};
    if (!snapshot.contacts.empty())
        intensities.fill(std::clamp(snapshot.features.force_N / kFullForce_N, kLeast, 1.0));
    return intensities;
}

} // namespace

core::Expected<void> runChain(const ChainOptions& options) {
    // A file that may not grow gives an error, as a full disk does.
    std::signal(SIGXFSZ, SIG_IGN);
    core::StopSwitch stop;
    core::Wakeup wakeup;
    TELETA_TRY(const scene::Scene scene, scene::parseScene(kScene, "certify"));
    TELETA_TRY(auto generator, simulation::makeTactileArray(scene, 1));
    const auto channel = std::make_shared<pipeline::TouchChannel>(
        std::make_unique<simulated::SimulatedArrayDevice>(std::move(generator), stop),
        scene_run::channelSettings(scene));
    recording::RecordingHead head;
    head.appVersion = app::version().text().toStdString();
    head.scene = scene.name;
    head.start_ns = core::steadyNow_ns();
    TELETA_TRY(const std::shared_ptr<recording::Recorder> recorder,
               recording::Recorder::start(options.recording, head));
    channel->record(recorder, "array");

    TELETA_TRY(modbus::RegisterMap map, modbus::readRegisterMap(options.driver));
    map.link = modbus::TcpLink{"127.0.0.1", options.port};
    TELETA_TRY(const auto bracelet, modbus::openModbusBracelet(map, stop));
    core::Wakeup braceletNews;
    bracelet->start(braceletNews);
    {
        playback::Player player(*bracelet, stop);
        channel->start(wakeup);
        CommandReader commands;
        Reporter reporter;
        while (!interrupted() && !commands.closed()) {
            wakeup.waitFor(kLookAtChain);
            while (const std::optional<std::string> command = commands.next()) {
                if (*command == "go")
                    player.startLive();
                else if (*command == "stop")
                    stop.engage();
                else if (*command == "release")
                    stop.release();
            }
            channel->process([&player](const pipeline::TouchSnapshot& snapshot) {
                player.post(intensitiesOf(snapshot), snapshot.time_ns);
            });
            reporter.look(player, *recorder);
        }
        // First the motors; then there is time for the rest.
        player.stop();
    }
    bracelet->stop();
    channel->stop();
    channel->record(nullptr, {});
    return recorder->stop();
}

} // namespace teleta::cli
