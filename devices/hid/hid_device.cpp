// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/hid_device.h"

#include <QString>

#include <algorithm>
#include <hidapi/hidapi.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace teleta::hid {

namespace {

/// Held while a device is looked for or opened. hidapi keeps the text of its last error in a global variable
/// that each of these calls frees and writes; drivers of several devices do that on several threads. Reading
/// and writing an open device needs no lock.
std::mutex& hidapiMutex() {
    static std::mutex mutex;
    return mutex;
}

std::string toUtf8(const wchar_t* text) {
    return text == nullptr ? std::string() : QString::fromWCharArray(text).toStdString();
}

class HidapiDevice : public HidDevice {
public:
    HidapiDevice(hid_device* device, std::string name, std::optional<core::NodeClaim> claim)
        : m_claim(std::move(claim))
        , m_device(device)
        , m_name(std::move(name)) {}
    ~HidapiDevice() override { hid_close(m_device); }

    [[nodiscard]] bool write(std::span<const std::uint8_t> report) override {
        return hid_write(m_device, report.data(), report.size()) == static_cast<int>(report.size());
    }
    [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) override {
        return hid_read_timeout(m_device, report.data(), report.size(), timeout_ms);
    }
    [[nodiscard]] int getFeature(std::span<std::uint8_t> report) override {
        return hid_get_feature_report(m_device, report.data(), report.size());
    }
    [[nodiscard]] std::string name() const override { return m_name; }

private:
    std::optional<core::NodeClaim> m_claim;
    hid_device* m_device;
    std::string m_name;
};

} // namespace

std::vector<HidDeviceInfo> listHidDevices(std::uint16_t vendorId, std::uint16_t productId) {
    std::vector<HidDeviceInfo> devices;
    const std::scoped_lock lock(hidapiMutex());
    const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(
        hid_enumerate(vendorId, productId), hid_free_enumeration);
    for (const hid_device_info* info = list.get(); info != nullptr; info = info->next)
        devices.push_back({info->path, toUtf8(info->serial_number), toUtf8(info->product_string),
                           info->vendor_id, info->product_id, info->usage_page, info->usage});
    std::ranges::sort(devices, {}, &HidDeviceInfo::path);
    return devices;
}

std::unique_ptr<HidDevice> openHidDevice(const HidDeviceInfo& info, std::optional<core::NodeClaim> claim) {
    const std::scoped_lock lock(hidapiMutex());
    hid_device* device = hid_open_path(info.path.c_str());
    return device == nullptr ? nullptr
                             : std::make_unique<HidapiDevice>(device, info.product, std::move(claim));
}

bool isForbidden(const std::string& path) {
    return access(path.c_str(), F_OK) == 0 && access(path.c_str(), R_OK | W_OK) != 0;
}

} // namespace teleta::hid
