// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_link.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::modbus {

namespace {

struct Modbus {
    Q_DECLARE_TR_FUNCTIONS(Modbus)
};

QString exceptionName(int code) {
    switch (code) {
    case 1:
        return Modbus::tr("illegal function");
    case 2:
        return Modbus::tr("illegal data address");
    case 3:
        return Modbus::tr("illegal data value");
    case 4:
        return Modbus::tr("device failure");
    case 5:
        return Modbus::tr("acknowledge");
    case 6:
        return Modbus::tr("device busy");
    case 7:
        return Modbus::tr("negative acknowledge");
    case 8:
        return Modbus::tr("memory parity error");
    case 10:
        return Modbus::tr("gateway path unavailable");
    case 11:
        return Modbus::tr("the device behind the gateway does not answer");
    default:
        return Modbus::tr("not in the standard");
    }
}

} // namespace

std::string describe(const Answer& answer) {
    switch (answer.kind) {
    case Answer::Kind::done:
        return {};
    case Answer::Kind::exception:
        return Modbus::tr("The server answered with exception %1: %2.")
            .arg(answer.exceptionCode)
            .arg(exceptionName(answer.exceptionCode))
            .toStdString();
    case Answer::Kind::timedOut:
        return Modbus::tr("The server did not answer in time.").toStdString();
    case Answer::Kind::damaged:
        return Modbus::tr("The server's answer does not fit the request.").toStdString();
    case Answer::Kind::lost:
        return Modbus::tr("The connection was lost.").toStdString();
    }
    return {};
}

} // namespace teleta::modbus
