// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::replay {

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(RecordedConfig config) {
    const core::Expected<recording::Recording> recording = recording::Recording::open(config.path);
    if (!recording)
        return core::Unexpected(recording.error());
    const auto extent = recording->extent(config.stream);
    if (!extent)
        return core::Unexpected(extent.error());
    if (!*extent)
        return core::Unexpected(core::Error{
            core::ErrorKind::refused,
            QCoreApplication::translate("ReplayDevice", "the recording has no frames").toStdString(),
            {},
            {config.path}});
    RecordedFacts facts{.extent = **extent, .start_ns = recording->head().start_ns, .marks = {}};
    for (const recording::RecordingEvent& event : recording->events())
        if (event.kind == recording::kMark)
            facts.marks.push_back({event.time_ns, event.text});
    return std::make_shared<RecordedPlayer>(std::move(config), std::move(facts));
}

} // namespace teleta::replay
