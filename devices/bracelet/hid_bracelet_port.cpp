// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_bracelet_port.h"

#include "backend/core/failure.h"
#include "devices/bracelet/bracelet_reports.h"

#include <QCoreApplication>
#include <QString>

#include <array>

namespace teleta::bracelet {

bool HidBraceletPort::write(std::uint16_t sequence, const core::Drive& drive, std::uint16_t timeout_ms) {
    return m_device->write(encodeFrame(sequence, drive, timeout_ms));
}

core::BraceletPort::Read HidBraceletPort::read(core::BoardReport& report) {
    // Longer than any report of the bracelet, so that a wrong report can be told by its length.
    std::array<std::uint8_t, 64> bytes{};
    const int size = m_device->read(bytes, 0);
    if (size < 0)
        return Read::lost;
    if (size == 0)
        return Read::nothing;
    const auto decoded = decodeReport(std::span(bytes).first(static_cast<std::size_t>(size)));
    if (!decoded)
        return Read::damaged;
    report = *decoded;
    return Read::report;
}

core::Expected<core::OpenedBracelet> openHidBraceletPort(std::unique_ptr<hid::HidDevice> device) {
    std::array<std::uint8_t, 64> bytes{};
    bytes[0] = kIdentityId;
    const int size = device->getFeature(bytes);
    const auto identity =
        size > 0 ? decodeIdentity(std::span(bytes).first(static_cast<std::size_t>(size))) : std::nullopt;
    if (!identity)
        return core::failed(
            core::ErrorKind::unavailable,
            QCoreApplication::translate("Bracelet", "The device does not respond like a bracelet."),
            QCoreApplication::translate("Bracelet", "a feature report of layout version %1")
                .arg(kLayoutVersion));
    core::BraceletDescription description;
    description.serial = identity->serial;
    description.model = std::to_string(identity->model);
    description.firmware =
        std::to_string(identity->firmwareMajor) + '.' + std::to_string(identity->firmwareMinor);
    description.name = QCoreApplication::translate("Bracelet", "Bracelet %1")
                           .arg(QString::fromStdString(identity->serial))
                           .toStdString();
    description.maximumRate_Hz = identity->maximumRate_Hz;
    description.highestDrive = identity->highestDrive;
    description.longestTimeout_ms = identity->longestTimeout_ms;
    return core::OpenedBracelet{std::make_unique<HidBraceletPort>(std::move(device)), std::move(description)};
}

} // namespace teleta::bracelet
