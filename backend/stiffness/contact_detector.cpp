// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/contact_detector.h"

#include <cmath>
#include <limits>

namespace teleta::stiffness {

ContactDetector::ContactDetector(const DetectionSettings& settings)
    : m_settings(settings) {
    if (!std::isgreater(m_settings.noiseFloor_Nm, 0.0))
        m_settings.noiseFloor_Nm = std::numeric_limits<double>::min();
    if (!std::isgreaterequal(m_settings.threshold_Nm, m_settings.noiseFloor_Nm))
        m_settings.threshold_Nm = m_settings.noiseFloor_Nm;
    m_transition.reserve(m_settings.capacity);
}

ContactPhase ContactDetector::update(const JointSample& sample, double reference_Nm) {
    if (!std::isfinite(sample.time_s) || !std::isfinite(sample.angle_rad) ||
        !std::isfinite(sample.torque_Nm) || !std::isfinite(reference_Nm)) {
        ++m_leftOut;
        return m_phase;
    }

    const double torque_Nm = sample.torque_Nm - reference_Nm;
    const double deviation_Nm = std::abs(torque_Nm);
    if (m_phase == ContactPhase::free) {
        if (deviation_Nm <= m_settings.noiseFloor_Nm)
            return m_phase;
        m_transition.clear();
        m_beyondCapacity = 0;
        m_phase = ContactPhase::transition;
    } else if (deviation_Nm < 0.5 * m_settings.noiseFloor_Nm) {
        m_phase = ContactPhase::free;
        return m_phase;
    }

    if (m_transition.size() < m_settings.capacity)
        m_transition.push_back({sample.time_s, sample.angle_rad, torque_Nm});
    else
        ++m_beyondCapacity;
    if (deviation_Nm > m_settings.threshold_Nm)
        m_phase = ContactPhase::contact;
    return m_phase;
}

void ContactDetector::reset() {
    m_phase = ContactPhase::free;
    m_transition.clear();
    m_leftOut = 0;
    m_beyondCapacity = 0;
}

} // namespace teleta::stiffness
