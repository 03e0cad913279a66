// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/register_link.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <iterator>
#include <utility>

namespace teleta::modbus {

namespace {

struct Modbus {
    Q_DECLARE_TR_FUNCTIONS(Modbus)
};

/// By the codes of the protocol.
constexpr std::pair<int, const char*> kExceptions[] = {
    {1, QT_TRANSLATE_NOOP("Modbus", "illegal function")},
    {2, QT_TRANSLATE_NOOP("Modbus", "illegal data address")},
    {3, QT_TRANSLATE_NOOP("Modbus", "illegal data value")},
    {4, QT_TRANSLATE_NOOP("Modbus", "device failure")},
    {5, QT_TRANSLATE_NOOP("Modbus", "acknowledge")},
    {6, QT_TRANSLATE_NOOP("Modbus", "device busy")},
    {7, QT_TRANSLATE_NOOP("Modbus", "negative acknowledge")},
    {8, QT_TRANSLATE_NOOP("Modbus", "memory parity error")},
    {10, QT_TRANSLATE_NOOP("Modbus", "gateway path unavailable")},
    {11, QT_TRANSLATE_NOOP("Modbus", "the device behind the gateway does not answer")},
};

QString exceptionName(int code) {
    const auto* const known = std::ranges::find(kExceptions, code, &std::pair<int, const char*>::first);
    return known != std::end(kExceptions) ? Modbus::tr(known->second) : Modbus::tr("not in the standard");
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
