// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet.h"

#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet_port.h"

#include <QCoreApplication>
#include <QString>

#include <cstdio>
#include <optional>

namespace teleta::bracelet {

namespace {

core::Error notPluggedIn(const HidBraceletConfig& config) {
    char ids[16];
    std::snprintf(ids, sizeof ids, "%04x:%04x", config.vendorId, config.productId);
    const QString expected =
        config.serial.empty()
            ? QCoreApplication::translate("Bracelet", "a USB device %1").arg(QLatin1String(ids))
            : QCoreApplication::translate("Bracelet", "a USB device %1 with the serial number %2")
                  .arg(QLatin1String(ids), QString::fromStdString(config.serial));
    return {core::ErrorKind::unavailable,
            QCoreApplication::translate("Bracelet", "No bracelet is plugged in.").toStdString(),
            expected.toStdString(),
            {}};
}

core::Expected<core::OpenedBracelet> openOnce(const HidBraceletConfig& config) {
    std::optional<core::Error> failure;
    for (const HidDeviceInfo& device : listHidBracelets(config)) {
        auto transport = openHidTransport(device.path);
        if (!transport) {
            failure = transport.error();
            continue;
        }
        auto opened = openHidBraceletPort(std::move(*transport));
        if (!opened) {
            failure = opened.error();
            continue;
        }
        if (config.serial.empty() || opened->description.serial == config.serial)
            return opened;
    }
    return core::Unexpected(failure.value_or(notPluggedIn(config)));
}

} // namespace

std::vector<HidDeviceInfo> listHidBracelets(const HidBraceletConfig& config) {
    std::vector<HidDeviceInfo> devices = listHidDevices(config.vendorId, config.productId);
    std::erase_if(devices, [](const HidDeviceInfo& device) {
        return device.usagePage != 0 && device.usagePage != kUsagePage;
    });
    return devices;
}

core::Expected<std::unique_ptr<core::BraceletLink>> openHidBracelet(const HidBraceletConfig& config,
                                                                    const core::StopSwitch& stopSwitch) {
    TELETA_TRY(auto opened, openOnce(config));
    // From now on only this board is accepted.
    HidBraceletConfig same = config;
    same.serial = opened.description.serial;
    return std::make_unique<core::BraceletLink>(
        std::move(opened), [same] { return openOnce(same); }, stopSwitch, config.link);
}

} // namespace teleta::bracelet
