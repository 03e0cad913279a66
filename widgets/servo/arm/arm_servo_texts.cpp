// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/arm/arm_servo_texts.h"

#include "widgets/base/numbers/quantity_text.h"

#include <array>
#include <cstddef>

namespace teleta::arm_servo {

QString ArmServoTexts::task(ArmTask task) {
    static constexpr std::array kNames{QT_TR_NOOP("Follow a point"), QT_TR_NOOP("Explore an edge"),
                                       QT_TR_NOOP("Roll about a point"), QT_TR_NOOP("Co-manipulation")};
    return tr(kNames[static_cast<std::size_t>(task)]);
}

QString ArmServoTexts::stage(Stage stage, ArmTask task) {
    switch (stage) {
    case Stage::idle:
        return tr(
            "The next press is a rehearsal. Only a shadow of the arm moves, and the arm gets no command.");
    case Stage::rehearsing:
        return task == ArmTask::point || task == ArmTask::roll
                   ? tr("REHEARSAL: the arm gets no command. Its shadow touches a ball that is assumed in "
                        "front of the pad.")
                   : tr("REHEARSAL: the arm gets no command. Its shadow touches an edge that is assumed in "
                        "front of the pad.");
    case Stage::rehearsed:
        return tr("Rehearsed. The next press MOVES THE ARM.");
    case Stage::driving:
        break;
    }
    return tr("THE ARM MOVES as long as you hold the switch.");
}

QString ArmServoTexts::ending(Ending ending, const QString& hindrance) {
    switch (ending) {
    case Ending::none:
    case Ending::letGo:
        break;
    case Ending::tooShort:
        return tr("The rehearsal was too short to count.");
    case Ending::stopped:
        return tr("Ended: STOP was engaged.");
    case Ending::noFrames:
        return tr("Ended: the frames of the pad are old.");
    case Ending::noJoints:
        return tr("Ended: the joint readings are old or unusable.");
    case Ending::hindered:
        return hindrance.isEmpty() ? tr("Ended: the commands came too late, or the arm took none.")
                                   : tr("Ended: the arm took no commands: %1.").arg(hindrance);
    case Ending::jointEnd:
        return tr("Ended: a joint is at the end of its range.");
    case Ending::contactLost:
        return tr("Ended: the contact was lost, and the search did not find it.");
    case Ending::nothingFound:
        return tr("Ended: nothing was touched within %1.").arg(base::millimetres(ArmServo::kFarthest_m));
    case Ending::tooDeep:
        return tr("Ended: the pad went %1 into what it touches and felt less than half of the force.")
            .arg(base::millimetres(ArmServo::kDeepest_m));
    case Ending::notFollowed:
        return tr("Ended: the shadow could not follow.");
    case Ending::finished:
        return tr("The task is done.");
    case Ending::armMoved:
        return tr("The arm was moved otherwise: rehearse the task again.");
    case Ending::taskChanged:
        return tr("The task was changed: rehearse it again.");
    }
    return {};
}

} // namespace teleta::arm_servo
