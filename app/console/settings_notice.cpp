// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/settings_notice.h"

#include "app/console/base/console_settings.h"

#include <QCoreApplication>
#include <QDir>

namespace teleta::console {

namespace {

struct SettingsNotice {
    Q_DECLARE_TR_FUNCTIONS(SettingsNotice)
};

} // namespace

std::optional<chrome::Message> settingsNotice(const ConsoleSettings& settings) {
    const QString file = QDir::toNativeSeparators(settings.keptFile());
    chrome::Message message;
    message.severity = chrome::Message::Severity::warning;
    switch (settings.found()) {
    case ConsoleSettings::Found::usable:
        return std::nullopt;
    case ConsoleSettings::Found::damaged:
        message.text = SettingsNotice::tr(
            "The settings are damaged: what can be read of them is used, the rest is as at "
            "the first start.");
        message.advice = file.isEmpty() ? SettingsNotice::tr("No copy of the damaged file could be kept.")
                                        : SettingsNotice::tr("A copy of the damaged file: %1").arg(file);
        return message;
    case ConsoleSettings::Found::newer:
        message.text = SettingsNotice::tr("The settings are those of a newer version of this program: "
                                          "everything is as at the first start, and nothing is remembered.");
        message.advice = SettingsNotice::tr("The file stays as it is: %1").arg(file);
        return message;
    case ConsoleSettings::Found::unwritable:
        message.text =
            SettingsNotice::tr("The settings cannot be kept: what is set now is forgotten at the end.");
        message.advice = SettingsNotice::tr("This file cannot be written: %1").arg(file);
        return message;
    }
    return std::nullopt;
}

} // namespace teleta::console
