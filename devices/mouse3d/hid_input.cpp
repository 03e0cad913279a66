// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/mouse3d/hid_input.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::mouse3d {

namespace {

constexpr unsigned short kGenericDesktop = 0x01;
constexpr unsigned short kMultiAxisController = 0x08;

struct MouseTexts {
    Q_DECLARE_TR_FUNCTIONS(Mouse3d)
};

} // namespace

std::vector<hid::HidDeviceInfo> listMice() {
    std::vector<hid::HidDeviceInfo> mice = hid::listHidDevices();
    std::erase_if(mice, [](const hid::HidDeviceInfo& device) {
        return device.usagePage != kGenericDesktop || device.usage != kMultiAxisController;
    });
    return mice;
}

core::Expected<std::unique_ptr<hid::HidDevice>> openMouse(const hid::HidDeviceInfo& mouse) {
    if (auto device = hid::openHidDevice(mouse))
        return device;
    const QString where = QString::fromStdString(mouse.path);
    if (hid::isForbidden(mouse.path))
        return core::failed(core::ErrorKind::ioFailed,
                            MouseTexts::tr("No permission to open the 3D mouse at %1.").arg(where),
                            MouseTexts::tr("read and write access, which the udev rule grants"));
    return core::failed(core::ErrorKind::unavailable,
                        MouseTexts::tr("The 3D mouse at %1 cannot be opened.").arg(where));
}

core::Expected<std::unique_ptr<hid::HidDevice>> openFirstMouse() {
    const std::vector<hid::HidDeviceInfo> mice = listMice();
    if (mice.empty())
        return core::failed(core::ErrorKind::unavailable, MouseTexts::tr("No 3D mouse is plugged in."));
    return openMouse(mice.front());
}

} // namespace teleta::mouse3d
