// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/uhid_device.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <linux/input.h>
#include <system_error>
#include <unistd.h>

namespace teleta::peer {

UhidDevice::UhidDevice()
    : m_device(::open("/dev/uhid", O_RDWR | O_CLOEXEC | O_NONBLOCK)) {
    if (m_device < 0)
        throw std::system_error(errno, std::generic_category(), "/dev/uhid");
}

UhidDevice::~UhidDevice() {
    ::close(m_device);
}

void UhidDevice::plugIn(const HidIdentity& identity) {
    uhid_event event{};
    event.type = UHID_CREATE2;
    uhid_create2_req& create = event.u.create2;
    // The last byte stays 0.
    identity.product.copy(reinterpret_cast<char*>(create.name), sizeof create.name - 1);
    identity.serial.copy(reinterpret_cast<char*>(create.uniq), sizeof create.uniq - 1);
    create.rd_size = static_cast<std::uint16_t>(identity.reportDescriptor.size());
    std::ranges::copy(identity.reportDescriptor, create.rd_data);
    create.bus = BUS_USB;
    create.vendor = 0x1209;
    create.product = identity.productId;
    send(event);
}

void UhidDevice::unplug() {
    uhid_event event{};
    event.type = UHID_DESTROY;
    send(event);
}

void UhidDevice::sendInput(std::span<const std::uint8_t> report) {
    uhid_event event{};
    event.type = UHID_INPUT2;
    event.u.input2.size = static_cast<std::uint16_t>(report.size());
    std::ranges::copy(report, event.u.input2.data);
    send(event);
}

void UhidDevice::send(const uhid_event& event) {
    if (::write(m_device, &event, sizeof event) != static_cast<ssize_t>(sizeof event))
        throw std::system_error(errno, std::generic_category(), "/dev/uhid");
}

bool UhidDevice::receive(uhid_event& event) {
    return ::read(m_device, &event, sizeof event) > 0;
}

} // namespace teleta::peer
