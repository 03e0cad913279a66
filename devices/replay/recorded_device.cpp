// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_device.h"

#include "devices/replay/csv_recording.h"
#include "devices/replay/teleta_recording.h"

#include <filesystem>
#include <utility>

namespace teleta::replay {

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(RecordedConfig config) {
    TELETA_TRY(std::unique_ptr<PlaybackRecording> recording, TeletaRecording::open(config));
    return std::make_shared<RecordedPlayer>(std::move(config), std::move(recording));
}

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(CsvConfig config) {
    TELETA_TRY(std::unique_ptr<CsvRecording> recording, CsvRecording::open(config));
    config.array = {.name = std::filesystem::path(config.path).filename().string(),
                    .layout = config.layout,
                    .unit = config.unit,
                    .nominalRate_Hz = recording->nominalRate_Hz(),
                    .simulated = false,
                    .recorded = true};
    config.startsQuietly = true;
    return std::make_shared<RecordedPlayer>(std::move(config), std::move(recording));
}

void RecordedPlayer::start(core::Wakeup& consumer) {
    m_thread.start(consumer);
    m_worker.recording().startIndexing();
}

void RecordedPlayer::stop() {
    m_thread.stop();
    m_worker.recording().stopIndexing();
}

} // namespace teleta::replay
