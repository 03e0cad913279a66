// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/trigger/serial_trigger.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace teleta::trigger {

namespace {

struct SerialTriggerText {
    Q_DECLARE_TR_FUNCTIONS(SerialTriggerText)
};

core::Unexpected problem(core::ErrorKind kind, const std::string& device, int code) {
    return core::failed(kind,
                        SerialTriggerText::tr("the trigger's serial line cannot be used: %1")
                            .arg(QString::fromLocal8Bit(std::strerror(code))),
                        {}, {device});
}

} // namespace

SerialTrigger::SerialTrigger(std::string device, core::FileDescriptor line, std::int64_t pulse_ns)
    : m_device(std::move(device))
    , m_line(std::move(line))
    , m_pulse_ns(pulse_ns) {
}

core::Expected<std::unique_ptr<core::TriggerPort>> SerialTrigger::open(const std::string& device,
                                                                       double pulse_ms) {
    // Without O_NONBLOCK, opening would wait for a carrier.
    core::FileDescriptor line(::open(device.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!line.isOpen())
        return problem(errno == ENOENT || errno == ENXIO || errno == ENODEV ? core::ErrorKind::notFound
                                                                            : core::ErrorKind::ioFailed,
                       device, errno);
    termios settings{};
    if (::tcgetattr(line.get(), &settings) != 0)
        return core::failed(core::ErrorKind::refused, SerialTriggerText::tr("this is not a serial line"),
                            SerialTriggerText::tr("a serial port, such as /dev/ttyUSB0"), {device});
    if (::flock(line.get(), LOCK_EX | LOCK_NB) != 0)
        return errno == EWOULDBLOCK ? core::usedByAnother(device)
                                    : problem(core::ErrorKind::ioFailed, device, errno);
    ::cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    ::cfsetispeed(&settings, B115200);
    ::cfsetospeed(&settings, B115200);
    if (::tcsetattr(line.get(), TCSANOW, &settings) != 0)
        return problem(core::ErrorKind::ioFailed, device, errno);
    return std::unique_ptr<core::TriggerPort>(
        new SerialTrigger(device, std::move(line), std::llround(1e6 * pulse_ms)));
}

core::Expected<void> SerialTrigger::write(const core::TriggerEvent& event) {
    return send(event.byte());
}

core::Expected<void> SerialTrigger::clear() {
    return send(0);
}

core::Expected<void> SerialTrigger::send(std::uint8_t byte) const {
    // A line whose buffer is full has been stuck for some time: that is an error, not a reason to wait.
    if (::write(m_line.get(), &byte, 1) != 1)
        return problem(core::ErrorKind::ioFailed, m_device, errno);
    return {};
}

} // namespace teleta::trigger
