// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"
#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet_port.h"

#include <QCoreApplication>
#include <QString>

#include <cstdio>
#include <optional>

namespace teleta::bracelet {

namespace {

struct BraceletText {
    Q_DECLARE_TR_FUNCTIONS(BraceletText)
};

core::Unexpected notPluggedIn(const HidBraceletConfig& config) {
    char ids[16];
    std::snprintf(ids, sizeof ids, "%04x:%04x", config.vendorId, config.productId);
    return core::failed(core::ErrorKind::unavailable, BraceletText::tr("No bracelet is plugged in."),
                        config.serial.empty()
                            ? BraceletText::tr("a USB device %1").arg(QLatin1String(ids))
                            : BraceletText::tr("a USB device %1 with the serial number %2")
                                  .arg(QLatin1String(ids), QString::fromStdString(config.serial)));
}

core::Expected<core::OpenedBracelet> openOnce(const HidBraceletConfig& config) {
    std::optional<core::Error> failure;
    for (const hid::HidDeviceInfo& device : listHidBracelets(config)) {
        auto opened = openBraceletNode(device.path).and_then(openHidBraceletPort);
        if (!opened)
            failure = opened.error();
        else if (config.serial.empty() || opened->description.serial == config.serial)
            return opened;
    }
    return failure ? core::Unexpected(*failure) : notPluggedIn(config);
}

} // namespace

std::vector<hid::HidDeviceInfo> listHidBracelets(const HidBraceletConfig& config) {
    std::vector<hid::HidDeviceInfo> devices = hid::listHidDevices(config.vendorId, config.productId);
    std::erase_if(devices, [](const hid::HidDeviceInfo& device) {
        return device.usagePage != 0 && device.usagePage != kUsagePage;
    });
    return devices;
}

core::Expected<std::unique_ptr<hid::HidDevice>> openBraceletNode(const std::string& path) {
    const QString where = QString::fromStdString(path);
    if (hid::isForbidden(path))
        return core::failed(core::ErrorKind::ioFailed,
                            BraceletText::tr("No permission to open the bracelet at %1.").arg(where),
                            BraceletText::tr("read and write access, which the udev rule grants"));
    // Claimed before it is opened: two programs must not drive the motors, not even for one frame.
    auto claim = core::NodeClaim::take(path);
    if (claim && !*claim)
        return core::failed(core::ErrorKind::unavailable,
                            BraceletText::tr("Another program uses the bracelet at %1.").arg(where),
                            BraceletText::tr("it to be closed there first"));
    auto device = claim ? hid::openHidDevice({path}, std::move(*claim)) : nullptr;
    if (!device)
        return core::failed(core::ErrorKind::unavailable,
                            BraceletText::tr("The bracelet at %1 cannot be opened.").arg(where));
    return device;
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
