// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/bracelet/hid_transport.h"

#include "backend/core/device/hidapi_mutex.h"
#include "backend/core/device/node_claim.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <hidapi/hidapi.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace teleta::bracelet {

namespace {

std::string toUtf8(const wchar_t* text) {
    return text == nullptr ? std::string() : QString::fromWCharArray(text).toStdString();
}

hid_device* openPath(const std::string& path) {
    const std::scoped_lock lock(core::hidapiMutex());
    return hid_open_path(path.c_str());
}

class HidapiTransport : public HidTransport {
public:
    HidapiTransport(hid_device* device, core::NodeClaim claim)
        : m_claim(std::move(claim))
        , m_device(device) {}
    ~HidapiTransport() override { hid_close(m_device); }

    [[nodiscard]] bool write(std::span<const std::uint8_t> report) override {
        return hid_write(m_device, report.data(), report.size()) == static_cast<int>(report.size());
    }
    [[nodiscard]] int read(std::span<std::uint8_t> report) override {
        return hid_read_timeout(m_device, report.data(), report.size(), 0);
    }
    [[nodiscard]] int getFeature(std::span<std::uint8_t> report) override {
        return hid_get_feature_report(m_device, report.data(), report.size());
    }

private:
    core::NodeClaim m_claim;
    hid_device* m_device;
};

core::Error refusal(const QString& text, const std::string& path, const QString& wanted = {}) {
    return {core::ErrorKind::unavailable,
            text.arg(QString::fromStdString(path)).toStdString(),
            wanted.toStdString(),
            {}};
}

} // namespace

std::vector<HidDeviceInfo> listHidDevices(std::uint16_t vendorId, std::uint16_t productId) {
    std::vector<HidDeviceInfo> devices;
    const std::scoped_lock lock(core::hidapiMutex());
    const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(
        hid_enumerate(vendorId, productId), hid_free_enumeration);
    for (const hid_device_info* info = list.get(); info != nullptr; info = info->next)
        devices.push_back(
            {info->path, toUtf8(info->serial_number), toUtf8(info->product_string), info->usage_page});
    std::sort(devices.begin(), devices.end(),
              [](const HidDeviceInfo& a, const HidDeviceInfo& b) { return a.path < b.path; });
    return devices;
}

core::Expected<std::unique_ptr<HidTransport>> openHidTransport(const std::string& path) {
    if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), R_OK | W_OK) != 0) {
        core::Error error = refusal(
            QCoreApplication::translate("Bracelet", "No permission to open the bracelet at %1."), path,
            QCoreApplication::translate("Bracelet", "read and write access, which the udev rule grants"));
        error.kind = core::ErrorKind::ioFailed;
        return core::Unexpected(error);
    }
    // Claimed before it is opened: two programs must not drive the motors, not even for one frame.
    auto claim = core::NodeClaim::take(path);
    if (claim && !*claim)
        return core::Unexpected(
            refusal(QCoreApplication::translate("Bracelet", "Another program uses the bracelet at %1."), path,
                    QCoreApplication::translate("Bracelet", "it to be closed there first")));
    hid_device* device = claim ? openPath(path) : nullptr;
    if (device == nullptr)
        return core::Unexpected(
            refusal(QCoreApplication::translate("Bracelet", "The bracelet at %1 cannot be opened."), path));
    return std::make_unique<HidapiTransport>(device, std::move(**claim));
}

} // namespace teleta::bracelet
