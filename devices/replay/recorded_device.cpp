// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::replay {

core::Expected<std::shared_ptr<RecordedPlayer>> RecordedPlayer::open(RecordedConfig config) {
    const core::Expected<recording::Recording> recording = recording::Recording::open(config.path);
    if (!recording)
        return core::Unexpected(recording.error());
    const auto extent = recording->extent(config.arrayStream);
    if (!extent)
        return core::Unexpected(extent.error());
    if (!*extent)
        return core::Unexpected(core::Error{
            core::ErrorKind::refused,
            QCoreApplication::translate("ReplayDevice", "the recording has no frames").toStdString(),
            {},
            {config.path}});
    return std::make_shared<RecordedPlayer>(std::move(config), **extent, recording->head().start_ns);
}

} // namespace teleta::replay
