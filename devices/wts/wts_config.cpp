// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_config.h"

#include "backend/core/failure.h"
#include "devices/wts/wts_text.h"

#include <QString>

#include <charconv>

namespace teleta::wts {

namespace {

constexpr std::string_view kTcp = "tcp://";

core::Unexpected badAddress(std::string_view text) {
    return core::failed(core::ErrorKind::badInput,
                        WtsText::tr("\"%1\" is not the address of a tactile array")
                            .arg(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))),
                        WtsText::tr("the path of a serial port, or tcp://HOST:PORT"));
}

} // namespace

core::Expected<WtsAddress> parseWtsAddress(std::string_view text, int baud) {
    if (!text.starts_with(kTcp)) {
        if (text.empty() || text.find("://") != std::string_view::npos)
            return badAddress(text);
        return SerialAddress{std::string(text), baud};
    }
    const std::string_view place = text.substr(kTcp.size());
    const std::size_t colon = place.rfind(':');
    if (colon == std::string_view::npos)
        return badAddress(text);
    std::string_view host = place.substr(0, colon);
    const bool bracketed = host.starts_with('[') && host.ends_with(']');
    if (bracketed)
        host = host.substr(1, host.size() - 2);
    const std::string_view number = place.substr(colon + 1);
    std::uint16_t port = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), port);
    const bool wholeNumber = error == std::errc{} && end == number.data() + number.size();
    if (host.empty() || !wholeNumber || port == 0 || (!bracketed && host.find(':') != std::string_view::npos))
        return badAddress(text);
    return TcpAddress{std::string(host), port};
}

} // namespace teleta::wts
