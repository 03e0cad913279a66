// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote/remote_text.h"

#include "devices/site/site_client.h"

#include <QCoreApplication>

namespace teleta::site_link {

namespace {

struct RemoteDeviceText {
    Q_DECLARE_TR_FUNCTIONS(RemoteDeviceText)
};

} // namespace

std::string silenceText(const SiteClient& site) {
    return (site.view().reached ? RemoteDeviceText::tr("%1 sends nothing of this device")
                                : RemoteDeviceText::tr("%1 does not answer"))
        .arg(QString::fromStdString(site.file().name))
        .toStdString();
}

} // namespace teleta::site_link
