// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/trigger/trigger_opener.h"

#include "backend/core/failure.h"
#include "devices/trigger/osc_trigger.h"
#include "devices/trigger/serial_trigger.h"

#include <QCoreApplication>

#include <charconv>

namespace teleta::trigger {

namespace {

struct OpenerText {
    Q_DECLARE_TR_FUNCTIONS(TriggerOpener)
};

constexpr char kOsc[] = "osc:";

} // namespace

core::Expected<std::unique_ptr<core::TriggerPort>> openTrigger(const core::TriggerSettings& settings) {
    switch (settings.kind) {
    case core::TriggerSettings::Kind::serial:
        return SerialTrigger::open(settings.device, settings.pulse_ms);
    case core::TriggerSettings::Kind::osc:
        return OscTrigger::open(settings.host, settings.port);
    case core::TriggerSettings::Kind::none:
        break;
    }
    return nullptr;
}

core::Expected<core::TriggerSettings> triggerSettingsOf(const std::string& word) {
    core::TriggerSettings settings;
    if (word.starts_with('/')) {
        settings.kind = core::TriggerSettings::Kind::serial;
        settings.device = word;
        return settings;
    }
    const std::string place = word.starts_with(kOsc) ? word.substr(sizeof(kOsc) - 1) : word;
    const std::size_t colon = place.rfind(':');
    unsigned port = 0;
    const char* end = place.data() + place.size();
    if (colon != std::string::npos && colon > 0) {
        const auto [stop, code] = std::from_chars(place.data() + colon + 1, end, port);
        if (code != std::errc{} || stop != end || port > 65535)
            port = 0;
    }
    if (port == 0)
        return core::failed(core::ErrorKind::badInput, OpenerText::tr("this is no trigger device"),
                            OpenerText::tr("a serial port such as /dev/ttyUSB0, or HOST:PORT for OSC"),
                            {word});
    settings.kind = core::TriggerSettings::Kind::osc;
    settings.host = place.substr(0, colon);
    settings.port = static_cast<std::uint16_t>(port);
    return settings;
}

} // namespace teleta::trigger
