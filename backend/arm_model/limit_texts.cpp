// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/limit_texts.h"

#include <QCoreApplication>

namespace teleta::arm_model {

namespace {

struct LimitText {
    Q_DECLARE_TR_FUNCTIONS(LimitText)
};

} // namespace

std::vector<NamedLimit> namedLimits() {
    return {{MotionFlag::jointRate, "joint_rate", LimitText::tr("joint speed")},
            {MotionFlag::tipSpeed, "tip_speed", LimitText::tr("tip speed")},
            {MotionFlag::jointEnd, "joint_end", LimitText::tr("joint limit")},
            {MotionFlag::workspace, "workspace", LimitText::tr("workspace box")},
            {MotionFlag::effort, "effort", LimitText::tr("effort")},
            {MotionFlag::force, "force", LimitText::tr("force")},
            {MotionFlag::leash, "leash", LimitText::tr("the arm lags behind")}};
}

QStringList limitTexts(std::uint32_t flags) {
    QStringList texts;
    for (const NamedLimit& limit : namedLimits()) {
        if ((flags & static_cast<std::uint32_t>(limit.flag)) != 0)
            texts << limit.text;
    }
    return texts;
}

} // namespace teleta::arm_model
