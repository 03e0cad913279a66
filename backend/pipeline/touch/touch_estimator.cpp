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

arm::JointVector toVector(const JointVector& joints) {
    return arm::JointVector(joints.data());
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

double TouchEstimator::Located::lever_m() const {
    return contactDistance_m * std::abs(std::cos(side_rad));
}

TouchEstimator::TouchEstimator(const core::ArmDescription& arm, const TouchEstimatorSettings& settings)
    : m_arm(arm)
    , m_kinematics({arm.upperArmLength_m, arm.forearmLength_m, arm.halfThickness_m})
    , m_settings(settings) {
    makeDetectors();
    reset();
}

void TouchEstimator::makeDetectors() {
    stiffness::DetectionSettings others = m_settings.detection;
    others.capacity = 0; // only the elbow's samples are evaluated
    m_detectors.fill(stiffness::ContactDetector(others));
    m_detectors[kElbow] = stiffness::ContactDetector(m_settings.detection);
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

bool TouchEstimator::canLocate() const {
    return m_arm.joints() == arm::JointVector::SizeAtCompileTime;
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
    const stiffness::ContactDetector& elbow = m_detectors[kElbow];
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
    const double elbow_Nm = std::abs(torque_Nm[kElbow]);
    const bool elbowFeels = elbow_Nm > threshold_Nm;
    if (m_accelerated_s && now_s - *m_accelerated_s < kInertiaMemory_s)
        m_touch.accelerated = true;
    const std::size_t joint = elbowFeels ? kElbow : strongest(torque_Nm);
    // Once the elbow has felt the touch, a sample that only another joint feels belongs to the release; once
    // the skin feels nothing any more, what the joints feel is the inertia of the retreat.
    if (std::abs(torque_Nm[joint]) > threshold_Nm && anyPhaseIs(ContactPhase::contact) &&
        (elbowFeels || !m_touch.elbowFelt) && (!m_touch.skinLeft || !m_touch.passed_s)) {
        m_touch.elbowFelt = elbowFeels;
        m_touch.loaded = sample;
        m_touch.torque_Nm = torque_Nm;
        m_touch.joint = joint;
        if (!m_touch.passed_s)
            m_touch.passed_s = now_s;
    }
    m_touch.reachedWindow = m_touch.reachedWindow || std::abs(torque_Nm[joint]) >= m_settings.window.low_Nm;
    if (!m_touch.elbowPassed_s && m_detectors[kElbow].phase() == ContactPhase::contact &&
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
    if (allFree || m_touch.skinLeft)
        return true;
    const double now_s = sample.sourceTime_s;
    if (m_touch.elbowPassed_s) {
        const stiffness::TorqueWindow& window = m_settings.window;
        const double elbow_Nm = std::abs(sample.torque_Nm[kElbow] - m_reference_Nm[kElbow]);
        return hasPassed(now_s - *m_touch.elbowPassed_s, m_settings.afterWindow_s) ||
               elbow_Nm > window.high_Nm + stiffness::kWindowMargin * window.width_Nm() ||
               elbow_Nm < window.middle_Nm();
    }
    if (m_touch.place && locate(m_touch.place->x_m, m_touch.place->y_m).lever_m() < m_settings.leastLever_m)
        return true;
    return hasPassed(now_s - *m_touch.passed_s, m_settings.elbowWait_s);
}

std::optional<TouchRecord> TouchEstimator::update(const SkinContact& contact) {
    if (contact.touching && std::isfinite(contact.x_m) && std::isfinite(contact.y_m) &&
        std::isgreaterequal(contact.force_N, m_settings.leastSkinForce_N)) {
        m_skin = contact;
        m_touch.skinLeft = false;
        const double slack_ns = 1e9 * m_settings.skinSlack_s;
        const bool open = m_touch.stage == Stage::rising || m_touch.stage == Stage::complete;
        if (open && static_cast<double>(m_touch.first.time_ns - contact.time_ns) <= slack_ns)
            addToPlace(contact);
    } else {
        m_skin.reset();
        m_touch.skinLeft = m_touch.place.has_value();
    }
    return recordWhenLocated(false);
}

void TouchEstimator::addToPlace(const SkinContact& contact) {
    // leastSkinForce_N may be 0: a contact without force still has a place.
    constexpr double kLeastWeight_N = 1e-9;
    const double weight_N = std::max(contact.force_N, kLeastWeight_N);
    if (!m_touch.place ||
        std::hypot(contact.x_m - m_touch.place->x_m, contact.y_m - m_touch.place->y_m) > kSamePlace_m)
        m_touch.place = Place{.x_m = contact.x_m, .y_m = contact.y_m, .type = contact.type};
    Place& place = *m_touch.place;
    place.type = contact.type;
    place.weight_N += weight_N;
    const double share = weight_N / place.weight_N;
    place.x_m += share * (contact.x_m - place.x_m);
    place.y_m += share * (contact.y_m - place.y_m);
    place.xSe_m += share * (std::hypot(contact.xSe_m, m_arm.skin.centreSe_m) - place.xSe_m);
    place.ySe_m += share * (std::hypot(contact.ySe_m, m_arm.skin.centreSe_m) - place.ySe_m);
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
    if (!m_touch.place || !canLocate())
        return record;

    const Located located = locate(m_touch.place->x_m, m_touch.place->y_m);
    const arm::JointVector angle_rad = toVector(m_touch.loaded.angle_rad);
    record.located = true;
    record.contactDistance_m = located.contactDistance_m;
    record.contactDistanceSe_m = m_touch.place->xSe_m;
    record.side_rad = located.side_rad;
    record.contactType = m_touch.place->type;
    record.p_Base_Contact_m = p_Base(angle_rad, located);
    record.force = forceAt(angle_rad, m_touch.torque_Nm, located);
    estimate(located, record);
    return record;
}

void TouchEstimator::estimate(const Located& located, TouchRecord& record) const {
    if (located.contactDistance_m <= 0.0 || located.lever_m() < m_settings.leastLever_m) {
        record.refusal = stiffness::Refusal::notPositive;
        return;
    }
    // The detector keeps the rise of an earlier touch when the elbow felt nothing of this one.
    const auto transition = m_detectors[kElbow].transition();
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
    auto stiffness = stiffnessAt(located, std::nullopt);
    if (stiffness)
        stiffness = stiffnessAt(located, placeSe_mPerN(stiffness->objectCompliance.value_mPerN));
    if (!stiffness) {
        record.refusal = stiffness.error();
        return;
    }
    if (timeInWindow_s(transition, m_settings.window) < m_settings.leastRise_s) {
        record.refusal = stiffness::Refusal::tooQuick;
        return;
    }
    record.stiffness = *stiffness;
    record.joint = kElbow;
    record.torque_Nm = m_touch.torque_Nm[kElbow];
}

tl::expected<stiffness::TouchStiffness, stiffness::Refusal>
TouchEstimator::stiffnessAt(const Located& located, std::optional<double> placeSe_mPerN) const {
    const double lever_m = located.lever_m();
    const arm::JointVector depthPerAngle_m = depthPerAngle(located);
    stiffness::TouchSettings settings;
    settings.contactDistance_m = lever_m;
    settings.contactDistanceSe_m = m_touch.place->xSe_m;
    settings.placeSe_mPerN = placeSe_mPerN;
    settings.linkStiffness_NPerM = linkStiffness_NPerM(lever_m, depthPerAngle_m);
    // 1/k_ri = lever^2 / K and the rest.
    settings.linkStiffnessSe_NPerM =
        std::pow(settings.linkStiffness_NPerM * lever_m / m_arm.elbowStiffness_NmPerRad, 2) *
        m_arm.elbowStiffnessSe_NmPerRad;
    settings.window = m_settings.window;
    settings.patternsAreErrors = true;
    settings.method = m_settings.method;
    settings.torqueNoise_Nm = m_settings.torqueNoise_Nm;
    settings.angleNoise_rad = m_settings.angleNoise_rad;
    return stiffness::estimateStiffness(pressingRise(depthPerAngle_m), settings);
}

double TouchEstimator::placeSe_mPerN(double object_mPerN) const {
    const Place& place = *m_touch.place;
    double squares = 0.0;
    for (const Located& moved :
         {locate(place.x_m + place.xSe_m, place.y_m), locate(place.x_m, place.y_m + place.ySe_m)}) {
        const auto there = stiffnessAt(moved, std::nullopt);
        if (there)
            squares += std::pow(there->objectCompliance.value_mPerN - object_mPerN, 2);
    }
    return std::sqrt(squares);
}

double TouchEstimator::linkStiffness_NPerM(double lever_m, const arm::JointVector& depthPerAngle_m) const {
    double compliance_mPerN = lever_m * lever_m / m_arm.elbowStiffness_NmPerRad;
    for (std::size_t i = 0; i < m_arm.shoulderStiffness_NmPerRad.size(); ++i)
        if (m_arm.shoulderStiffness_NmPerRad[i] > 0.0)
            compliance_mPerN += std::pow(depthPerAngle_m[static_cast<Eigen::Index>(i)], 2) /
                                m_arm.shoulderStiffness_NmPerRad[i];
    return 1.0 / compliance_mPerN;
}

arm::JointVector TouchEstimator::depthPerAngle(const Located& located) const {
    const arm::JointVector pose_rad = toVector(m_touch.loaded.angle_rad);
    const Eigen::Vector3d p_Link = m_kinematics.p_Link_Skin(located.contactDistance_m, located.side_rad);
    const Eigen::Vector3d normal_Link = Eigen::Vector3d(0.0, p_Link.y(), p_Link.z()).normalized();
    const Eigen::Vector3d normal =
        m_kinematics.X_Base_Link(arm::Link::forearm, pose_rad).linear() * normal_Link;
    return m_kinematics.pointJacobian(arm::Link::forearm, pose_rad, p_Link).transpose() * normal;
}

std::vector<stiffness::JointSample>
TouchEstimator::pressingRise(const arm::JointVector& depthPerAngle_m) const {
    const arm::JointVector pose_rad = toVector(m_touch.loaded.angle_rad);
    const auto transition = m_detectors[kElbow].transition();
    const auto pressed_rad = [&](const JointVector& angle_rad) {
        return depthPerAngle_m.dot(toVector(angle_rad) - pose_rad) / depthPerAngle_m[kElbow];
    };
    std::vector<stiffness::JointSample> rise;
    rise.reserve(m_free.size() + transition.size());
    for (const JointSample& sample : m_free)
        if (transition.empty() || sample.sourceTime_s < transition.front().time_s)
            rise.push_back({sample.sourceTime_s, pressed_rad(sample.angle_rad),
                            sample.torque_Nm[kElbow] - m_reference_Nm[kElbow]});
    for (std::size_t i = 0; i < transition.size(); ++i)
        rise.push_back({transition[i].time_s, pressed_rad(m_riseAngles_rad[i]), transition[i].torque_Nm});
    return rise;
}

std::optional<arm::ContactForce> TouchEstimator::forceAt(const arm::JointVector& angle_rad,
                                                         const JointVector& torque_Nm,
                                                         const Located& located) const {
    const Eigen::Vector3d p_Link = m_kinematics.p_Link_Skin(located.contactDistance_m, located.side_rad);
    const auto force =
        arm::solveContactForce(m_kinematics.pointJacobian(arm::Link::forearm, angle_rad, p_Link),
                               toVector(torque_Nm), m_settings.force);
    return force ? std::optional(*force) : std::nullopt;
}

Eigen::Vector3d TouchEstimator::p_Base(const arm::JointVector& angle_rad, const Located& located) const {
    return m_kinematics.p_Base_Point(arm::Link::forearm, angle_rad,
                                     m_kinematics.p_Link_Skin(located.contactDistance_m, located.side_rad));
}

TouchEstimator::Located TouchEstimator::locate(double x_m, double y_m) const {
    return {m_arm.skin.distance_m(x_m), m_arm.skin.side_rad(y_m)};
}

std::optional<LiveContact> TouchEstimator::liveContact() const {
    if (!m_skin || !m_newest || !canLocate())
        return std::nullopt;
    const Located located = locate(m_skin->x_m, m_skin->y_m);
    const arm::JointVector angle_rad = toVector(m_newest->angle_rad);
    return LiveContact{located.contactDistance_m, located.side_rad, p_Base(angle_rad, located),
                       forceAt(angle_rad, torqueWithoutReference(*m_newest), located)};
}

} // namespace teleta::pipeline
