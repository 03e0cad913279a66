// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/replay_device.h"

#include <filesystem>
#include <utility>

namespace teleta::replay {

namespace {

constexpr int kProbedFrames = 32;

/// Frame rate over the first frames; 0 when they span no time.
core::Expected<double> probeRate_Hz(ReplayCursor& cursor) {
    const core::Expected<bool> any = cursor.read();
    if (!any)
        return core::Unexpected(any.error());
    for (int i = 1; i < kProbedFrames; ++i) {
        // What is wrong further on is told when playing comes to it.
        if (const core::Expected<bool> more = cursor.read(); !more || !*more)
            break;
    }
    const double span_s = cursor.place().time_s - cursor.first().time_s;
    return span_s > 0.0 ? static_cast<double>(cursor.place().frame) / span_s : 0.0;
}

} // namespace

core::Expected<std::unique_ptr<ReplayDevice>> ReplayDevice::open(ReplayConfig config) {
    core::Expected<ReplayCursor> cursor = ReplayCursor::open(config.path, config.layout);
    if (!cursor)
        return core::Unexpected(cursor.error());
    const core::Expected<double> recordedRate_Hz = probeRate_Hz(*cursor);
    if (!recordedRate_Hz)
        return core::Unexpected(recordedRate_Hz.error());
    core::SourceDescription description{.name = std::filesystem::path(config.path).filename().string(),
                                        .layout = config.layout,
                                        .unit = config.unit,
                                        .nominalRate_Hz = config.rate_Hz.value_or(*recordedRate_Hz),
                                        .simulated = false,
                                        .recorded = true};
    return std::unique_ptr<ReplayDevice>(
        new ReplayDevice(std::move(description), std::move(*cursor), std::move(config)));
}

ReplayDevice::ReplayDevice(core::SourceDescription description, ReplayCursor cursor, ReplayConfig config)
    : m_description(std::move(description))
    , m_worker(std::move(cursor), m_description.nominalRate_Hz, std::move(config)) {
}

ReplayDevice::~ReplayDevice() {
    stop();
}

void ReplayDevice::start(core::Wakeup& consumer) {
    m_thread.start(m_worker, consumer);
    if (!m_indexThread.joinable())
        m_indexThread = std::jthread([this](const std::stop_token& stop) { m_worker.buildIndex(stop); });
}

void ReplayDevice::stop() {
    m_thread.stop(m_worker);
    if (m_indexThread.joinable()) {
        m_indexThread.request_stop();
        m_indexThread.join();
    }
}

} // namespace teleta::replay
