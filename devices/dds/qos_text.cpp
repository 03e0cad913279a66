// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/dds/qos_text.h"

#include <QCoreApplication>

namespace teleta::dds {

namespace {

struct QosText {
    Q_DECLARE_TR_FUNCTIONS(QosText)
};

} // namespace

QString describe(ros::QosMismatch mismatch) {
    switch (mismatch) {
    case ros::QosMismatch::reliability:
        return QosText::tr("the publisher is best effort, the subscriber asks for reliable");
    case ros::QosMismatch::durability:
        return QosText::tr("the publisher is volatile, the subscriber asks for transient local");
    case ros::QosMismatch::other:
        break;
    }
    return QosText::tr("publisher and subscriber have incompatible qualities of service (QoS)");
}

} // namespace teleta::dds
