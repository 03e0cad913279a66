// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_servo/channel_servo.h"

#include "backend/core/device/device_state.h"
#include "backend/core/failure.h"
#include "backend/pipeline/touch/skin_kinematics.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::arm_servo {

namespace {

struct ChannelServoText {
    Q_DECLARE_TR_FUNCTIONS(ChannelServo)
};

/// A pad whose taxels stand at places of their own is rehearsed as the usual grid.
core::ArrayLayout rehearsedLayout(const pipeline::TouchChannel& pad) {
    const core::TaxelLayout& layout = pad.description().layout;
    return layout.isGrid() ? layout.grid() : core::ArrayLayout{};
}

bool isOld(const core::DeviceStatus& status, double nominalRate_Hz, std::int64_t now_ns) {
    const core::DeviceState state =
        core::observedState(status.state, status.lastData_ns, now_ns, core::staleAfter_ns(nominalRate_Hz));
    return state == core::DeviceState::stale || state == core::DeviceState::lost ||
           state == core::DeviceState::reconnecting;
}

} // namespace

core::Expected<std::unique_ptr<ChannelServo>> ChannelServo::open(std::shared_ptr<pipeline::ArmChannel> arm) {
    if (!arm->chain() || !arm->pad())
        return core::failed(core::ErrorKind::badInput, ChannelServoText::tr("the arm has no pad on a link"));
    if (arm->description().recorded)
        return core::failed(core::ErrorKind::badInput,
                            ChannelServoText::tr("a recording is played, and nothing can be moved"));
    if (arm->skin()->settings().loadUnit != "N")
        return core::failed(core::ErrorKind::badInput,
                            ChannelServoText::tr("the pad is not calibrated: its loads are not in N"));
    TELETA_TRY(auto pad, PadArm::create(arm->chain(), arm->description(), *arm->pad()));
    return std::unique_ptr<ChannelServo>(new ChannelServo(std::move(arm), std::move(pad)));
}

ChannelServo::ChannelServo(std::shared_ptr<pipeline::ArmChannel> arm, std::shared_ptr<const PadArm> pad)
    : m_arm(std::move(arm))
    , m_servo(m_arm->chain(), std::move(pad), rehearsedLayout(*m_arm->skin()),
              m_arm->skin()->settings().features) {
}

const ArmServoStep& ChannelServo::tick(std::int64_t now_ns, bool held, bool stopped, bool jointsOld) {
    core::ArmSource& device = m_arm->device();
    const pipeline::TouchChannel& pad = *m_arm->skin();
    ArmServoInput input;
    input.now_ns = now_ns;
    input.held = held;
    input.stopped = stopped || device.drive() == core::ArmDrive::stopped;
    input.jointsOld = jointsOld || isOld(m_arm->jointStatus(), m_arm->description().nominalRate_Hz, now_ns);
    input.hindered = !device.hindrance().empty();
    input.q_rad = m_arm->newestAngles_rad();
    if (pad.generation() > 0) {
        const pipeline::TouchSnapshot& snapshot = pad.snapshot();
        input.frame = snapshot.framesProcessed;
        input.frame_ns = snapshot.time_ns;
        input.pad = snapshot.features;
    }
    m_step = m_servo.step(input);
    if (m_step.rate)
        device.post({*m_step.rate, now_ns});
    return m_step;
}

} // namespace teleta::arm_servo
