// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/link_address.h"

#include <QString>
#include <QUrl>

namespace teleta::link {

namespace {

std::string lastPart(const std::string& path) {
    return path.substr(path.rfind('/') + 1);
}

} // namespace

bool isWebAddress(const std::string& url) {
    const QUrl parsed(QString::fromStdString(url), QUrl::StrictMode);
    return parsed.isValid() && !parsed.host().isEmpty() &&
           (parsed.scheme() == QLatin1String("ws") || parsed.scheme() == QLatin1String("wss"));
}

std::string displayName(const Address& address) {
    if (const auto* tcp = std::get_if<TcpAddress>(&address))
        return tcp->host + ':' + std::to_string(tcp->port);
    if (const auto* udp = std::get_if<UdpAddress>(&address))
        return "udp:" + std::to_string(udp->port);
    if (const auto* file = std::get_if<FileAddress>(&address))
        return lastPart(file->path);
    if (const auto* web = std::get_if<WebAddress>(&address))
        return web->url;
    return lastPart(std::get<SerialAddress>(address).path);
}

} // namespace teleta::link
