// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/source_watch.h"

#include "widgets/base/numbers/number_format.h"

#include <QLocale>

#include <cmath>
#include <variant>

namespace teleta::console {

void SourceWatch::look(const SourceManager::Item& item) {
    lookForFailures(item);
    lookForDamage(item);
    lookAtTemperature(item);
}

void SourceWatch::lookForFailures(const SourceManager::Item& item) {
    const core::DeviceStatus status = item.channel->status();
    if (status.state != core::DeviceState::lost) {
        m_reportedLost.erase(item.key);
        return;
    }
    if (!m_reportedLost.insert(item.key).second)
        return;
    const bool recorded = item.channel->summary().recorded;
    m_messages.post({chrome::Message::Severity::error, tr("%1 was lost.", "a source").arg(item.name),
                     recorded ? tr("The file cannot be read further: it is damaged, or its disk is gone. "
                                   "Open it again when it can be read.")
                              : tr("Check the cable and the power supply; it is tried again by itself."),
                     QString::fromStdString(status.message)});
}

void SourceWatch::lookForDamage(const SourceManager::Item& item) {
    const auto* playback = std::get_if<app::RecordingRequest>(&item.request);
    if (playback != nullptr && playback->settingsChanged && m_reportedChanged.insert(item.key).second)
        m_messages.post({chrome::Message::Severity::information,
                         tr("The settings of %1 changed while it was recorded.", "a source").arg(item.name),
                         tr("It is played with those of the beginning; the events of the recording have the "
                            "others."),
                         QString::fromStdString(playback->path)});
    const core::PlaybackControl* control = item.playback();
    if (control == nullptr || control->position().damagedBlocks == 0 ||
        !m_reportedDamaged.insert(item.key).second)
        return;
    m_messages.post({chrome::Message::Severity::warning,
                     tr("The recording of %1 is damaged.", "a source").arg(item.name),
                     tr("The blocks that cannot be read are passed over; the others are played."),
                     playback != nullptr ? QString::fromStdString(playback->path) : QString()});
}

void SourceWatch::lookAtTemperature(const SourceManager::Item& item) {
    const auto array = item.array();
    const auto moved = array ? array->temperatureDrift() : std::nullopt;
    if (!moved) {
        m_reportedWarm.erase(item.key);
        return;
    }
    if (!m_reportedWarm.insert(item.key).second)
        return;
    const QString change =
        base::withUnit(QLocale().toString(std::abs(moved->change_K), 'f', 1), QStringLiteral("K"));
    m_messages.post(
        {chrome::Message::Severity::warning,
         moved->change_K > 0.0 ? tr("%1 has become warmer since its tare.", "a source").arg(item.name)
                               : tr("%1 has become colder since its tare.", "a source").arg(item.name),
         item.channel->summary().recorded
             ? tr("What it reads at rest moved with temperature while it was recorded.")
             : tr("What it reads at rest moves with temperature. Tare it again with nothing touching."),
         tr("Chip %1: %2").arg(moved->chip).arg(change)});
}

} // namespace teleta::console
