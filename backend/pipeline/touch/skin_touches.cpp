// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/skin_touches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pipeline {

bool tellsTorques(const core::JointSample& sample) {
    return std::ranges::any_of(sample.torque_Nm, [](double torque) { return std::isfinite(torque); });
}

SkinTouches::SkinTouches(std::size_t joints, std::shared_ptr<const SkinKinematics> skin)
    : m_joints(joints)
    , m_skinAt(std::move(skin)) {
}

std::optional<TouchRecord> SkinTouches::update(const core::JointSample& sample,
                                               const TouchEstimatorSettings& settings) {
    if (sample.angle_rad.size() != m_joints || !std::isfinite(sample.sourceTime_s) ||
        !std::ranges::all_of(sample.angle_rad, [](double angle) { return std::isfinite(angle); }))
        return std::nullopt;
    if (sample.discontinuity || (m_newest && sample.sourceTime_s < m_newest->sourceTime_s)) {
        m_touch.reset();
        m_skin.reset();
    }
    m_newest = sample;
    return advance(settings.release_s);
}

std::optional<TouchRecord> SkinTouches::update(const SkinContact& contact,
                                               const TouchEstimatorSettings& settings) {
    if (!m_newest || !m_skinAt)
        return std::nullopt;
    if (!(contact.touching && std::isfinite(contact.x_m) && std::isfinite(contact.y_m) &&
          std::isgreaterequal(contact.force_N, settings.leastSkinForce_N))) {
        m_skin.reset();
        if (m_touch && !m_touch->left_s)
            m_touch->left_s = m_newest->sourceTime_s;
        return advance(settings.release_s);
    }
    m_skin = contact;
    m_felt_s = m_newest->sourceTime_s;
    if (!m_touch) {
        m_touch.emplace();
        m_touch->first_ns = contact.time_ns;
        m_touch->first_s = m_felt_s;
    }
    m_touch->left_s.reset();
    m_touch->pose = *m_newest;
    ++m_touch->frames;
    TouchedPlace::add(m_touch->place, contact, m_skinAt->centreSe_m());
    return advance(settings.release_s);
}

std::optional<TouchRecord> SkinTouches::advance(double release_s) {
    const double now_s = m_newest->sourceTime_s;
    const bool isSilent = now_s - m_felt_s >= kSilence_s;
    if (isSilent)
        m_skin.reset();
    if (!m_touch)
        return std::nullopt;
    const bool isOver = isSilent || (m_touch->left_s && now_s - *m_touch->left_s >= release_s);
    std::optional<TouchRecord> record;
    if (!m_touch->recorded && m_touch->frames >= kLeastFrames &&
        (isOver || now_s - m_touch->first_s >= kSettle_s)) {
        m_touch->recorded = true;
        record = makeRecord();
    }
    if (isOver)
        m_touch.reset();
    return record;
}

TouchRecord SkinTouches::makeRecord() {
    const TouchedPlace& place = *m_touch->place;
    const SkinPoint point = m_skinAt->at(m_touch->pose.angle_rad, place.x_m, place.y_m);
    TouchRecord record;
    record.number = ++m_touches;
    record.start_ns = m_touch->first_ns;
    record.start_s = m_touch->first_s;
    record.ready_ns = m_newest->time_ns;
    record.arrived_ns = m_newest->arrived_ns;
    record.ready_s = m_newest->sourceTime_s;
    record.joint = m_skinAt->pressingJoint();
    record.joints = m_joints;
    record.located = true;
    record.contactDistance_m = point.contactDistance_m;
    record.contactDistanceSe_m = place.xSe_m;
    record.side_rad = point.side_rad;
    record.contactType = place.type;
    record.p_Base_Contact_m = point.p_Base_m;
    record.refusal = stiffness::Refusal::noTorques;
    return record;
}

std::optional<LiveContact> SkinTouches::liveContact() const {
    if (!m_skin || !m_newest || !m_skinAt)
        return std::nullopt;
    const SkinPoint point = m_skinAt->at(m_newest->angle_rad, m_skin->x_m, m_skin->y_m);
    return LiveContact{point.contactDistance_m, point.side_rad, point.p_Base_m, std::nullopt};
}

} // namespace teleta::pipeline
