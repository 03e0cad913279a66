// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/hid_input.h"

#include "backend/core/device/hidapi_mutex.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <hidapi/hidapi.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace teleta::mouse3d {

namespace {

constexpr unsigned short kGenericDesktop = 0x01;
constexpr unsigned short kMultiAxisController = 0x08;

struct MouseTexts {
    Q_DECLARE_TR_FUNCTIONS(Mouse3d)
};

hid_device* openPath(const std::string& path) {
    const std::scoped_lock lock(core::hidapiMutex());
    return hid_open_path(path.c_str());
}

class HidapiInput : public HidInput {
public:
    HidapiInput(hid_device* device, std::string name)
        : m_device(device)
        , m_name(std::move(name)) {}
    ~HidapiInput() override { hid_close(m_device); }

    [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) override {
        return hid_read_timeout(m_device, report.data(), report.size(), timeout_ms);
    }
    [[nodiscard]] std::string name() const override { return m_name; }

private:
    hid_device* m_device;
    std::string m_name;
};

} // namespace

std::vector<Mouse3dInfo> listMice() {
    std::vector<Mouse3dInfo> mice;
    const std::scoped_lock lock(core::hidapiMutex());
    const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(hid_enumerate(0, 0),
                                                                                 hid_free_enumeration);
    for (const hid_device_info* info = list.get(); info != nullptr; info = info->next) {
        if (info->usage_page != kGenericDesktop || info->usage != kMultiAxisController)
            continue;
        const QString product =
            info->product_string != nullptr ? QString::fromWCharArray(info->product_string) : QString();
        mice.push_back({info->path, product.toStdString(), info->vendor_id, info->product_id});
    }
    std::ranges::sort(mice, {}, &Mouse3dInfo::path);
    return mice;
}

core::Expected<std::unique_ptr<HidInput>> openMouse(const Mouse3dInfo& mouse) {
    if (hid_device* device = openPath(mouse.path))
        return std::make_unique<HidapiInput>(device, mouse.product);
    const QString where = QString::fromStdString(mouse.path);
    if (access(mouse.path.c_str(), F_OK) == 0 && access(mouse.path.c_str(), R_OK | W_OK) != 0)
        return core::failed(core::ErrorKind::ioFailed,
                            MouseTexts::tr("No permission to open the 3D mouse at %1.").arg(where),
                            MouseTexts::tr("read and write access, which the udev rule grants"));
    return core::failed(core::ErrorKind::unavailable,
                        MouseTexts::tr("The 3D mouse at %1 cannot be opened.").arg(where));
}

core::Expected<std::unique_ptr<HidInput>> openFirstMouse() {
    const std::vector<Mouse3dInfo> mice = listMice();
    if (mice.empty())
        return core::failed(core::ErrorKind::unavailable, MouseTexts::tr("No 3D mouse is plugged in."));
    return openMouse(mice.front());
}

} // namespace teleta::mouse3d
