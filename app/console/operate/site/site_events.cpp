// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/site/site_events.h"

#include <QCoreApplication>

#include <string_view>

namespace teleta::console {

namespace {

struct SiteEventText {
    Q_DECLARE_TR_FUNCTIONS(SiteEventText)
};

} // namespace

QString siteEventText(const QString& site, const site_link::RemoteEvent& event) {
    const std::string_view code = event.code;
    const QString source = QString::fromStdString(event.source);
    const QString message = QString::fromStdString(event.message);
    if (code == "console")
        return SiteEventText::tr("%1: the console %2 is there.").arg(site, source);
    if (code == "console_refused")
        return SiteEventText::tr("%1 cannot listen to the console %2: %3").arg(site, source, message);
    if (code == "name_in_use")
        return SiteEventText::tr("%1: another program named %2 is connected; it is ignored.")
            .arg(site, source);
    if (code == "kept_out")
        return SiteEventText::tr("%1 kept a program out: %2").arg(site, message);
    if (code == "granted")
        return SiteEventText::tr("%1: %2 is in control.").arg(site, source);
    if (code == "free")
        return SiteEventText::tr("%1: %2 is no longer in control.").arg(site, source);
    if (code == "stop")
        return SiteEventText::tr("%1: STOP is held by %2.").arg(site, source);
    if (code == "stop_withdrawn")
        return SiteEventText::tr("%1: %2 withdrew STOP.").arg(site, source);
    if (code == "fault")
        return SiteEventText::tr("%1: fault of %2: %3").arg(site, source, message);
    if (code == "device" && event.severity == 0)
        return SiteEventText::tr("%1: %2 is live.").arg(site, source);
    if (code == "recording_failed")
        return SiteEventText::tr("%1: its recording failed: %2").arg(site, message);
    if (code == "keys")
        return SiteEventText::tr("%1: its keys: %2").arg(site, message);
    return source.isEmpty() ? SiteEventText::tr("%1: %2", "a site and what it says").arg(site, message)
                            : SiteEventText::tr("%1: %2: %3", "a site, a device and what it says")
                                  .arg(site, source, message);
}

bool isNotice(const site_link::RemoteEvent& event) {
    // The bar and its messages tell who holds STOP.
    return event.severity > 0 && event.code != "stop";
}

} // namespace teleta::console
