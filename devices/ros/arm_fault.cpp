// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/arm_fault.h"

#include <QCoreApplication>

namespace teleta::ros_arm {

namespace {

struct ArmFaultText {
    Q_DECLARE_TR_FUNCTIONS(RosArmFault)
};

} // namespace

QString describe(const ArmFault& fault) {
    const QString what = QString::fromStdString(fault.what);
    switch (fault.kind) {
    case ArmFaultKind::otherWriter:
        return ArmFaultText::tr("someone else commands %1").arg(what);
    case ArmFaultKind::notFinite:
        return ArmFaultText::tr("%1 reports a position that is not a number").arg(what);
    case ArmFaultKind::jumped:
        return ArmFaultText::tr("the position of %1 jumped").arg(what);
    case ArmFaultKind::backward:
        return ArmFaultText::tr("the stamps of %1 went back").arg(what);
    case ArmFaultKind::silent:
        return ArmFaultText::tr("%1 fell silent").arg(what);
    case ArmFaultKind::notFollowing:
        break;
    }
    return ArmFaultText::tr("the arm does not follow its commands");
}

} // namespace teleta::ros_arm
