// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/touch_estimator.h"

#include "backend/stiffness/loading_ramp.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::pipeline {

namespace {

using core::JointSample;
using core::JointVector;
using stiffness::ContactPhase;

/// Over which the torque is averaged that becomes a new reference.
constexpr double kRecentTime_s = 0.05;

/// Between two looks at the references: they may be rounded, so it must be much longer than a sample.
constexpr double kMotionStep_s = 0.02;

/// For which an arm rings after it was accelerated.
constexpr double kInertiaMemory_s = 0.1;

/// After which a skin that says nothing any more feels nothing.
constexpr double kSkinMemory_ns = 0.25e9;

/// Sample times are decimal fractions: a difference that should be the duration may fall short by rounding.
bool hasPassed(double elapsed_s, double duration_s) {
    constexpr double kRounding_s = 1e-9;
    return elapsed_s >= duration_s - kRounding_s;
}

arm::AnyJointVector toVector(const JointVector& joints) {
    return arm::AnyJointVector::Map(joints.data(), static_cast<Eigen::Index>(joints.size()));
}

stiffness::JointSample ofJoint(const JointSample& sample, std::size_t joint) {
    return {sample.sourceTime_s, sample.angle_rad[joint], sample.torque_Nm[joint]};
}

/// From the first sample in the window to the first above it, or to the last one.
double timeInWindow_s(std::span<const stiffness::JointSample> rise, const stiffness::TorqueWindow& window) {
    const auto isBelow = [](double torque_Nm) {
        return [torque_Nm](const stiffness::JointSample& sample) {
            return std::abs(sample.torque_Nm) < torque_Nm;
        };
    };
    const auto first = std::ranges::find_if_not(rise, isBelow(window.low_Nm));
    if (first == rise.end())
        return 0.0;
    const auto above = std::find_if_not(first, rise.end(), isBelow(window.high_Nm));
    return (above == rise.end() ? rise.back() : *above).time_s - first->time_s;
}

std::size_t strongest(const JointVector& torque_Nm) {
    const auto found = std::max_element(torque_Nm.begin(), torque_Nm.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
    return static_cast<std::size_t>(found - torque_Nm.begin());
}

} // namespace

TouchEstimatorSettings touchSettings(const core::TouchTorques& torques) {
    constexpr double kFloor_sd = 5.0;
    TouchEstimatorSettings settings;
    settings.window = {torques.windowLow_Nm, torques.windowHigh_Nm};
    settings.detection.threshold_Nm = torques.threshold_Nm;
    settings.detection.noiseFloor_Nm = torques.noiseFloor_Nm;
    settings.force.torqueNoise_Nm = torques.noiseFloor_Nm / kFloor_sd;
    return settings;
}

TouchEstimator::TouchEstimator(const core::ArmDescription& arm, const TouchEstimatorSettings& settings,
                               std::shared_ptr<const SkinKinematics> skin)
    : m_arm(arm)
    , m_skinAt(skin ? std::move(skin) : skinAroundForearm(arm))
    , m_elbow(m_skinAt ? m_skinAt->pressingJoint() : std::max<std::size_t>(arm.joints(), 1) - 1)
    , m_settings(settings) {
    makeDetectors();
    reset();
}

void TouchEstimator::makeDetectors() {
    stiffness::DetectionSettings others = m_settings.detection;
    others.capacity = 0; // only the elbow's samples are evaluated
    m_detectors.fill(stiffness::ContactDetector(others));
    m_detectors[m_elbow] = stiffness::ContactDetector(m_settings.detection);
}

void TouchEstimator::setSettings(const TouchEstimatorSettings& settings) {
    const stiffness::DetectionSettings before = std::exchange(m_settings, settings).detection;
    const stiffness::DetectionSettings& now = m_settings.detection;
    if (before.threshold_Nm == now.threshold_Nm && before.noiseFloor_Nm == now.noiseFloor_Nm &&
        before.capacity == now.capacity)
        return;
    makeDetectors();
    reset();
}

void TouchEstimator::reset() {
    for (stiffness::ContactDetector& detector : m_detectors)
        detector.reset();
    m_newest.reset();
    m_skin.reset();
    m_referenceSamples = 0;
    m_raisedUnfelt_s = JointVector::zeros(m_arm.joints());
    m_motion.clear();
    m_accelerated_s.reset();
    m_free.clear();
    m_touch = {};
}

JointPhases TouchEstimator::phases() const {
    JointPhases phases{};
    std::ranges::transform(detectors(), phases.begin(), &stiffness::ContactDetector::phase);
    return phases;
}

std::span<const stiffness::ContactDetector> TouchEstimator::detectors() const {
    return std::span(m_detectors).first(m_arm.joints());
}

bool TouchEstimator::isUsable(const JointSample& sample) const {
    const auto complete = [this](const JointVector& values) {
        return values.size() == m_arm.joints() &&
               std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    };
    return std::isfinite(sample.sourceTime_s) && complete(sample.angle_rad) && complete(sample.torque_Nm);
}

bool TouchEstimator::anyPhaseIs(ContactPhase phase) const {
    return std::ranges::any_of(detectors(),
                               [phase](const auto& detector) { return detector.phase() == phase; });
}

std::optional<TouchRecord> TouchEstimator::update(const JointSample& sample) {
    if (!isUsable(sample)) {
        ++m_leftOut;
        return std::nullopt;
    }
    std::optional<TouchRecord> record;
    if (sample.discontinuity || (m_newest && sample.sourceTime_s < m_newest->sourceTime_s)) {
        record = recordWhenLocated(true);
        reset();
    }
    if (m_skin && static_cast<double>(sample.time_ns - m_skin->time_ns) > kSkinMemory_ns)
        m_skin.reset();
    const bool watched = m_referenceSamples > 0 && m_referenceSamples >= m_settings.referenceSamples;
    if (watched) {
        watch(sample);
        takeNewReferences(sample);
    }
    followReference(sample);
    followMotion(sample);
    m_newest = sample;
    // A touch that a discontinuity ended is over before the first sample after it.
    if (record || !watched)
        return record;
    return follow(sample);
}

void TouchEstimator::followReference(const JointSample& sample) {
    const double step_s = m_newest ? sample.sourceTime_s - m_newest->sourceTime_s : 0.0;
    const auto share = [step_s](double time_s) { return step_s < time_s ? step_s / time_s : 1.0; };
    const bool starting = m_referenceSamples < std::max(m_settings.referenceSamples, 1);
    if (starting && ++m_referenceSamples == 1) {
        m_reference_Nm = m_recent_Nm = sample.torque_Nm;
        return;
    }
    for (std::size_t joint = 0; joint < m_arm.joints(); ++joint) {
        const double torque_Nm = sample.torque_Nm[joint];
        m_recent_Nm[joint] += share(kRecentTime_s) * (torque_Nm - m_recent_Nm[joint]);
        const double weight = starting ? 1.0 / m_referenceSamples : share(m_settings.referenceTime_s);
        if (m_detectors[joint].phase() == ContactPhase::free)
            m_reference_Nm[joint] += weight * (torque_Nm - m_reference_Nm[joint]);
    }
}

void TouchEstimator::followMotion(const JointSample& sample) {
    if (!m_motion.empty() && !hasPassed(sample.sourceTime_s - m_motion.back().time_s, kMotionStep_s))
        return;
    m_motion.push_back({sample.sourceTime_s, sample.reference_rad});
    if (m_motion.size() < 3)
        return;
    const auto rate_radPerS = [this](std::size_t look, std::size_t joint) {
        return (m_motion[look + 1].reference_rad[joint] - m_motion[look].reference_rad[joint]) /
               (m_motion[look + 1].time_s - m_motion[look].time_s);
    };
    const double span_s = 0.5 * (m_motion[2].time_s - m_motion[0].time_s);
    for (std::size_t joint = 0; joint < m_arm.joints(); ++joint) {
        if (std::abs(rate_radPerS(1, joint) - rate_radPerS(0, joint)) > m_settings.inertia_radPerS2 * span_s)
            m_accelerated_s = sample.sourceTime_s;
    }
    m_motion.erase(m_motion.begin());
}

JointVector TouchEstimator::torqueWithoutReference(const JointSample& sample) const {
    JointVector torque_Nm = sample.torque_Nm;
    for (std::size_t joint = 0; joint < m_arm.joints(); ++joint)
        torque_Nm[joint] -= m_reference_Nm[joint];
    return torque_Nm;
}

void TouchEstimator::watch(const JointSample& sample) {
    const stiffness::ContactDetector& elbow = m_detectors[m_elbow];
    const ContactPhase before = elbow.phase();
    for (std::size_t joint = 0; joint < m_arm.joints(); ++joint)
        m_detectors[joint].update(ofJoint(sample, joint), m_reference_Nm[joint]);
    if (elbow.phase() == ContactPhase::free) {
        // What follows a touch is another free motion; a spike of noise, or what the links take to speed up,
        // ends none.
        if (before == ContactPhase::contact)
            m_free.clear();
        keepFree(sample);
        return;
    }
    const auto transition = elbow.transition();
    if (elbow.phase() == ContactPhase::transition && !transition.empty() &&
        sample.sourceTime_s - transition.front().time_s <= m_settings.newReference_s)
        m_free.push_back(sample);
    if (before == ContactPhase::free)
        m_riseAngles_rad.clear();
    if (m_riseAngles_rad.size() < elbow.transition().size())
        m_riseAngles_rad.push_back(sample.angle_rad);
}

void TouchEstimator::keepFree(const JointSample& sample) {
    m_free.push_back(sample);
    while (sample.sourceTime_s - m_free.front().sourceTime_s > kFreeTime_s)
        m_free.pop_front();
}

/// A payload that was hung on, a sensor whose zero jumped, a contact that was there from the start: without
/// this the joint would never be free again.
void TouchEstimator::takeNewReferences(const JointSample& sample) {
    const double step_s = m_newest ? sample.sourceTime_s - m_newest->sourceTime_s : 0.0;
    for (std::size_t joint = 0; joint < m_arm.joints(); ++joint) {
        double& raised_s = m_raisedUnfelt_s[joint];
        raised_s = m_skin || m_detectors[joint].phase() == ContactPhase::free ? 0.0 : raised_s + step_s;
        if (raised_s <= m_settings.newReference_s)
            continue;
        m_reference_Nm[joint] = m_recent_Nm[joint];
        m_detectors[joint].reset();
        raised_s = 0.0;
    }
}

std::optional<TouchRecord> TouchEstimator::follow(const JointSample& sample) {
    const double now_s = sample.sourceTime_s;
    const JointVector torque_Nm = torqueWithoutReference(sample);
    const bool allFree = !anyPhaseIs(ContactPhase::transition) && !anyPhaseIs(ContactPhase::contact);

    if (m_touch.stage == Stage::none) {
        if (allFree)
            return std::nullopt;
        m_touch = {};
        m_touch.stage = Stage::rising;
        m_touch.first = sample;
        const double slack_ns = 1e9 * m_settings.skinSlack_s;
        if (m_skin && static_cast<double>(sample.time_ns - m_skin->time_ns) <= slack_ns)
            addToPlace(*m_skin);
    }
    if (m_touch.stage == Stage::held) {
        if (!allFree)
            m_touch.free_s = now_s;
        else if (hasPassed(now_s - m_touch.free_s, m_settings.release_s))
            m_touch = {};
        return std::nullopt;
    }

    const double threshold_Nm = m_settings.detection.threshold_Nm;
    const double elbow_Nm = std::abs(torque_Nm[m_elbow]);
    const bool elbowFeels = elbow_Nm > threshold_Nm;
    if (m_accelerated_s && now_s - *m_accelerated_s < kInertiaMemory_s)
        m_touch.accelerated = true;
    const std::size_t joint = elbowFeels ? m_elbow : strongest(torque_Nm);
    // Once the elbow has felt the touch, a sample that only another joint feels belongs to the release; once
    // the skin feels nothing any more, what the joints feel is the inertia of the retreat.
    if (std::abs(torque_Nm[joint]) > threshold_Nm && anyPhaseIs(ContactPhase::contact) &&
        (elbowFeels || !m_touch.elbowFelt) && (!m_touch.skinLeft_ns || !m_touch.passed_s)) {
        m_touch.elbowFelt = elbowFeels;
        m_touch.loaded = sample;
        m_touch.torque_Nm = torque_Nm;
        m_touch.joint = joint;
        if (!m_touch.passed_s)
            m_touch.passed_s = now_s;
    }
    m_touch.reachedWindow = m_touch.reachedWindow || std::abs(torque_Nm[joint]) >= m_settings.window.low_Nm;
    if (!m_touch.elbowPassed_s && m_detectors[m_elbow].phase() == ContactPhase::contact &&
        elbow_Nm > m_settings.window.high_Nm)
        m_touch.elbowPassed_s = now_s;

    if (m_touch.stage == Stage::rising) {
        if (allFree && !m_touch.passed_s) {
            if (m_touch.reachedWindow)
                ++m_tooGentle;
            m_touch = {};
            return std::nullopt;
        }
        if (!isComplete(sample, allFree))
            return std::nullopt;
        m_touch.stage = Stage::complete;
        m_touch.complete_s = now_s;
    }
    return recordWhenLocated(allFree || hasPassed(now_s - m_touch.complete_s, m_settings.skinWait_s));
}

bool TouchEstimator::isComplete(const JointSample& sample, bool allFree) const {
    if (!m_touch.passed_s)
        return false;
    if (allFree)
        return true;
    // A frame of a skin may be empty in the middle of a touch.
    if (m_touch.skinLeft_ns &&
        hasPassed(1e-9 * static_cast<double>(sample.time_ns - *m_touch.skinLeft_ns), m_settings.release_s))
        return true;
    const double now_s = sample.sourceTime_s;
    if (m_touch.elbowPassed_s) {
        const stiffness::TorqueWindow& window = m_settings.window;
        const double elbow_Nm = std::abs(sample.torque_Nm[m_elbow] - m_reference_Nm[m_elbow]);
        return hasPassed(now_s - *m_touch.elbowPassed_s, m_settings.afterWindow_s) ||
               elbow_Nm > window.high_Nm + stiffness::kWindowMargin * window.width_Nm() ||
               elbow_Nm < window.middle_Nm();
    }
    if (m_touch.place && m_skinAt &&
        locate(m_touch.place->x_m, m_touch.place->y_m).lever_m() < m_settings.leastLever_m)
        return true;
    return hasPassed(now_s - *m_touch.passed_s, m_settings.elbowWait_s);
}

bool TouchEstimator::isNearlyComplete() const {
    return m_touch.stage == Stage::complete || (m_touch.stage == Stage::rising && m_touch.passed_s);
}

std::optional<TouchRecord> TouchEstimator::update(const SkinContact& contact) {
    if (contact.touching && std::isfinite(contact.x_m) && std::isfinite(contact.y_m) &&
        std::isgreaterequal(contact.force_N, m_settings.leastSkinForce_N)) {
        m_skin = contact;
        m_touch.skinLeft_ns.reset();
        const double slack_ns = 1e9 * m_settings.skinSlack_s;
        const bool open = m_touch.stage == Stage::rising || m_touch.stage == Stage::complete;
        if (open && static_cast<double>(m_touch.first.time_ns - contact.time_ns) <= slack_ns)
            addToPlace(contact);
    } else {
        m_skin.reset();
        if (m_touch.place && !m_touch.skinLeft_ns)
            m_touch.skinLeft_ns = contact.time_ns;
    }
    return recordWhenLocated(false);
}

void TouchEstimator::addToPlace(const SkinContact& contact) {
    TouchedPlace::add(m_touch.place, contact, m_skinAt ? m_skinAt->centreSe_m() : 0.0);
}

std::optional<TouchRecord> TouchEstimator::recordWhenLocated(bool waitNoLonger) {
    if (m_touch.stage != Stage::complete || !(m_touch.place || waitNoLonger))
        return std::nullopt;
    m_touch.stage = Stage::held;
    m_touch.free_s = m_newest->sourceTime_s;
    if (!m_touch.place && m_touch.accelerated) {
        ++m_byInertia;
        return std::nullopt;
    }
    return makeRecord();
}

TouchRecord TouchEstimator::makeRecord() {
    TouchRecord record;
    record.number = ++m_touches;
    record.start_ns = m_touch.first.time_ns;
    record.start_s = m_touch.first.sourceTime_s;
    record.ready_ns = m_newest->time_ns;
    record.arrived_ns = m_newest->arrived_ns;
    record.ready_s = m_newest->sourceTime_s;
    record.joint = m_touch.joint;
    record.joints = m_arm.joints();
    record.torque_Nm = m_touch.torque_Nm[record.joint];
    if (!m_touch.place || !m_skinAt)
        return record;

    const SkinPoint point = locate(m_touch.place->x_m, m_touch.place->y_m);
    record.located = true;
    record.contactDistance_m = point.contactDistance_m;
    record.contactDistanceSe_m = m_touch.place->xSe_m;
    record.side_rad = point.side_rad;
    record.contactType = m_touch.place->type;
    record.p_Base_Contact_m = point.p_Base_m;
    record.force = forceAt(m_touch.torque_Nm, point);
    estimate(point, record);
    return record;
}

void TouchEstimator::estimate(const SkinPoint& point, TouchRecord& record) const {
    if (point.contactDistance_m <= 0.0 || point.lever_m() < m_settings.leastLever_m) {
        record.refusal = stiffness::Refusal::notPositive;
        return;
    }
    // The detector keeps the rise of an earlier touch when the elbow felt nothing of this one.
    const auto transition = m_detectors[m_elbow].transition();
    // An elbow that stays in the lower half of the window stood still there while others went on: its samples
    // say nothing of the object.
    const auto bears = [this](const stiffness::JointSample& sample) {
        return std::abs(sample.torque_Nm) >= m_settings.window.middle_Nm();
    };
    if (transition.empty() || transition.front().time_s < m_touch.first.sourceTime_s ||
        std::ranges::none_of(transition, bears)) {
        record.refusal = stiffness::Refusal::windowNotReached;
        return;
    }
    const auto compliance_mPerN = complianceAt(point);
    if (!compliance_mPerN) {
        record.refusal = compliance_mPerN.error();
        return;
    }
    stiffness::TouchSettings settings = stiffnessSettings(point);
    settings.placeSe_mPerN = placeSe_mPerN(*compliance_mPerN);
    const auto stiffness = stiffness::estimateStiffness(pressingRise(point.depthPerAngle_m()), settings);
    if (!stiffness) {
        record.refusal = stiffness.error();
        return;
    }
    if (timeInWindow_s(transition, m_settings.window) < m_settings.leastRise_s) {
        record.refusal = stiffness::Refusal::tooQuick;
        return;
    }
    record.stiffness = *stiffness;
    record.joint = m_elbow;
    record.torque_Nm = m_touch.torque_Nm[m_elbow];
}

stiffness::TouchSettings TouchEstimator::stiffnessSettings(const SkinPoint& point) const {
    stiffness::TouchSettings settings;
    settings.contactDistance_m = point.lever_m();
    settings.contactDistanceSe_m = m_touch.place->xSe_m;
    settings.linkStiffness_NPerM = m_skinAt->linkStiffness_NPerM(point);
    settings.linkStiffnessSe_NPerM = m_skinAt->linkStiffnessSe_NPerM(point);
    settings.window = m_settings.window;
    settings.patternsAreErrors = true;
    settings.method = m_settings.method;
    settings.torqueNoise_Nm = m_settings.torqueNoise_Nm;
    settings.angleNoise_rad = m_settings.angleNoise_rad;
    return settings;
}

tl::expected<double, stiffness::Refusal> TouchEstimator::complianceAt(const SkinPoint& point) const {
    return stiffness::estimateObjectCompliance(pressingRise(point.depthPerAngle_m()),
                                               stiffnessSettings(point));
}

double TouchEstimator::placeSe_mPerN(double object_mPerN) const {
    const TouchedPlace& place = *m_touch.place;
    double squares = 0.0;
    for (const SkinPoint& moved :
         {locate(place.x_m + place.xSe_m, place.y_m), locate(place.x_m, place.y_m + place.ySe_m)}) {
        if (const auto there_mPerN = complianceAt(moved))
            squares += std::pow(*there_mPerN - object_mPerN, 2);
    }
    return std::sqrt(squares);
}

std::vector<stiffness::JointSample>
TouchEstimator::pressingRise(const arm::AnyJointVector& depthPerAngle_m) const {
    const arm::AnyJointVector pose_rad = toVector(m_touch.loaded.angle_rad);
    const auto transition = m_detectors[m_elbow].transition();
    const auto pressed_rad = [&](const JointVector& angle_rad) {
        return depthPerAngle_m.dot(toVector(angle_rad) - pose_rad) /
               depthPerAngle_m[static_cast<Eigen::Index>(m_elbow)];
    };
    std::vector<stiffness::JointSample> rise;
    rise.reserve(m_free.size() + transition.size());
    for (const JointSample& sample : m_free)
        if (transition.empty() || sample.sourceTime_s < transition.front().time_s)
            rise.push_back({sample.sourceTime_s, pressed_rad(sample.angle_rad),
                            sample.torque_Nm[m_elbow] - m_reference_Nm[m_elbow]});
    for (std::size_t i = 0; i < transition.size(); ++i)
        rise.push_back({transition[i].time_s, pressed_rad(m_riseAngles_rad[i]), transition[i].torque_Nm});
    return rise;
}

std::optional<arm::ContactForce> TouchEstimator::forceAt(const JointVector& torque_Nm,
                                                         const SkinPoint& point) const {
    const auto force = arm::solveContactForce(point.jacobian, toVector(torque_Nm), m_settings.force);
    return force ? std::optional(*force) : std::nullopt;
}

SkinPoint TouchEstimator::locate(double x_m, double y_m) const {
    return m_skinAt->at(m_touch.loaded.angle_rad, x_m, y_m);
}

std::optional<LiveContact> TouchEstimator::liveContact() const {
    if (!m_skin || !m_newest || !m_skinAt)
        return std::nullopt;
    const SkinPoint point = m_skinAt->at(m_newest->angle_rad, m_skin->x_m, m_skin->y_m);
    return LiveContact{point.contactDistance_m, point.side_rad, point.p_Base_m,
                       forceAt(torqueWithoutReference(*m_newest), point)};
}

} // namespace teleta::pipeline
