// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/servo/impedance_arm.h"

#include "backend/servo/arm/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::simulation {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using servo::kLwrJoints;

constexpr int kMostRestSteps = 60;
constexpr int kMostRestHalvings = 40;
/// A step of Gauss-Newton that promises less is not taken.
constexpr double kLeastGain_J = 1e-12;
constexpr double kInertiaRenewal_rad = 0.005;
/// Below it what sticks creeps.
constexpr double kCreep_mPerS = 1e-4;

/// x of A x = b by Cholesky's L L^T. A: symmetric, positive definite; its lower half is read. Eigen's takes
/// this size for a large one.
template <int kSize>
Eigen::Matrix<double, kSize, 1> solve(Eigen::Matrix<double, kSize, kSize> L,
                                      Eigen::Matrix<double, kSize, 1> x) {
    Eigen::Matrix<double, kSize, 1> perDiagonal;
    for (Eigen::Index k = 0; k < kSize; ++k) {
        perDiagonal[k] = 1.0 / std::sqrt(L(k, k));
        for (Eigen::Index i = k; i < kSize; ++i)
            L(i, k) *= perDiagonal[k];
        for (Eigen::Index j = k + 1; j < kSize; ++j)
            for (Eigen::Index i = j; i < kSize; ++i)
                L(i, j) -= L(i, k) * L(j, k);
    }
    for (Eigen::Index k = 0; k < kSize; ++k) {
        x[k] *= perDiagonal[k];
        for (Eigen::Index i = k + 1; i < kSize; ++i)
            x[i] -= L(i, k) * x[k];
    }
    for (Eigen::Index k = kSize - 1; k >= 0; --k) {
        for (Eigen::Index i = k + 1; i < kSize; ++i)
            x[k] -= L(i, k) * x[i];
        x[k] *= perDiagonal[k];
    }
    return x;
}

} // namespace

ImpedanceArm::ImpedanceArm(const Isometry3d& X_Flange_Sensor, const Impedance& impedance, ElasticArray array,
                           TouchedObject object)
    : m_kinematics(X_Flange_Sensor)
    , m_impedance(impedance)
    , m_array(std::move(array))
    , m_object(std::move(object)) {
    m_stiffness << Vector3d::Constant(impedance.stiffness_NPerM),
        Vector3d::Constant(impedance.rotationalStiffness_NmPerRad);
    if (impedance.friction > 0.0)
        m_rubbing.reserve(m_array.springs());
    setState({});
}

void ImpedanceArm::setState(const ImpedanceState& state) {
    m_state = state;
    m_curvature.isOfState = false;
    m_posture = m_kinematics.forward(state.q_rad);
    m_X_Base_Reference = m_posture.X_Base_Tool;
    m_contact = m_array.press(m_posture.X_Base_Tool.inverse(Eigen::Isometry) * objectAt(state.hinge_rad),
                              m_object.shape);
    followPosture();
}

void ImpedanceArm::setHinge(double inertia_kgm2, double torque_Nm) {
    m_mass(kLwrJoints, kLwrJoints) = inertia_kgm2;
    m_hingeTorque_Nm = torque_Nm;
}

void ImpedanceArm::followPosture() {
    const LwrMatrix mass = lwrMassMatrix(m_posture);
    m_mass.topLeftCorner<kLwrJoints, kLwrJoints>() = mass;
    m_damping.topLeftCorner<kLwrJoints, kLwrJoints>() =
        modalDamping(mass, m_posture.jacobian, m_stiffness, m_impedance.dampingRatio);
    m_damping.diagonal().head<kLwrJoints>().array() += m_impedance.jointDamping_NmsPerRad;
    m_damping(kLwrJoints, kLwrJoints) = m_object.damping_NmsPerRad;
    m_inertiaAt_rad = m_state.q_rad;
}

Isometry3d ImpedanceArm::objectAt(double hinge_rad) const {
    if (!m_object.turns || hinge_rad == 0.0)
        return m_object.X_Base_Object;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(hinge_rad, m_object.axis_Base).toRotationMatrix();
    Isometry3d X_Base_Object;
    X_Base_Object.linear() = turn * m_object.X_Base_Object.linear();
    X_Base_Object.translation() =
        m_object.p_Base_Hinge + turn * (m_object.X_Base_Object.translation() - m_object.p_Base_Hinge);
    X_Base_Object.makeAffine();
    return X_Base_Object;
}

void ImpedanceArm::evaluateSprings(Place& place) const {
    const Isometry3d& X = place.posture.X_Base_Tool;
    const Vector3d way_m = m_X_Base_Reference.translation() - X.translation();
    const Vector3d turn_rad = servo::logSO3(X.linear().transpose() * m_X_Base_Reference.linear());
    place.spring_Base.head<3>() = m_impedance.stiffness_NPerM * way_m;
    place.spring_Base.tail<3>() = m_impedance.rotationalStiffness_NmPerRad * (X.linear() * turn_rad);
    place.potential_J = 0.5 * m_impedance.stiffness_NPerM * way_m.squaredNorm() +
                        0.5 * m_impedance.rotationalStiffness_NmPerRad * turn_rad.squaredNorm() +
                        place.contact.energy_J - m_hingeTorque_Nm * place.at[kLwrJoints];
}

void ImpedanceArm::evaluate(const Freedoms& at, Place& place, servo::CycleTimes* times) const {
    place.at = at;
    {
        const servo::CycleTimer timer(times, servo::CyclePart::kinematics);
        place.posture = m_kinematics.forward(at.head<kLwrJoints>());
    }
    {
        const servo::CycleTimer timer(times, servo::CyclePart::contact);
        place.contact = m_array.press(
            place.posture.X_Base_Tool.inverse(Eigen::Isometry) * objectAt(at[kLwrJoints]), m_object.shape);
    }
    evaluateSprings(place);
}

ImpedanceArm::Relative ImpedanceArm::relativeTwist(const Place& place) const {
    const servo::LwrJacobian& J = place.posture.jacobian;
    const Eigen::Matrix3d R_Sensor_Base = place.posture.X_Base_Tool.linear().transpose();
    Relative relative = Relative::Zero();
    relative.topLeftCorner<3, kLwrJoints>() = R_Sensor_Base.lazyProduct(J.topRows<3>());
    relative.bottomLeftCorner<3, kLwrJoints>() = R_Sensor_Base.lazyProduct(J.bottomRows<3>());
    if (m_object.turns) {
        const Vector3d arm = place.posture.X_Base_Tool.translation() - m_object.p_Base_Hinge;
        relative.col(kLwrJoints).head<3>() = -(R_Sensor_Base * m_object.axis_Base.cross(arm));
        relative.col(kLwrJoints).tail<3>() = -(R_Sensor_Base * m_object.axis_Base);
    }
    return relative;
}

double ImpedanceArm::friction_J(const servo::Twist& way_Sensor, double creep_m, servo::Vector6* gradient,
                                servo::Matrix6* hessian) const {
    double energy_J = 0.0;
    for (const PressedPoint& point : m_rubbing) {
        const Vector3d way_m = way_Sensor.head<3>() + Vector3d(way_Sensor.tail<3>()).cross(point.p_Sensor);
        const Vector3d& n = point.normal_Sensor;
        const Vector3d slip_m = way_m - n.dot(way_m) * n;
        const double rounded_m = std::sqrt(slip_m.squaredNorm() + creep_m * creep_m);
        const double force_N = m_impedance.friction * point.force_N;
        energy_J += force_N * (rounded_m - creep_m);
        if (gradient == nullptr)
            continue;
        const Vector3d drag_N = force_N / rounded_m * slip_m;
        gradient->head<3>() += drag_N;
        gradient->tail<3>() += point.p_Sensor.cross(drag_N);
        const Eigen::Matrix3d stiffness = force_N / rounded_m *
                                          (Eigen::Matrix3d::Identity() - n * n.transpose() -
                                           slip_m * slip_m.transpose() / (rounded_m * rounded_m));
        const Eigen::Matrix3d cross = servo::skew(point.p_Sensor);
        hessian->topLeftCorner<3, 3>() += stiffness;
        hessian->topRightCorner<3, 3>() -= stiffness * cross;
        hessian->bottomLeftCorner<3, 3>() += cross * stiffness;
        hessian->bottomRightCorner<3, 3>() -= cross * stiffness * cross;
    }
    return energy_J;
}

void ImpedanceArm::findCurvature(const Place& place) {
    const servo::LwrJacobian& J = place.posture.jacobian;
    // Products coefficient by coefficient: Eigen takes these sizes for large ones, and packs them first.
    m_curvature.hessian.setZero();
    const servo::LwrJacobian stiff = m_stiffness.asDiagonal() * J;
    m_curvature.hessian.topLeftCorner<kLwrJoints, kLwrJoints>() = J.transpose().lazyProduct(stiff);
    m_curvature.isOfState = true;
    if (place.contact.springs == 0)
        return;
    m_curvature.relative = relativeTwist(place);
    const Relative pressed = place.contact.tangent_Sensor.lazyProduct(m_curvature.relative);
    m_curvature.ofContact = m_curvature.relative.transpose().lazyProduct(pressed);
    m_curvature.hessian += m_curvature.ofContact;
}

ImpedanceArm::Freedoms ImpedanceArm::gradientAt(const Place& place) const {
    Freedoms gradient;
    gradient.head<kLwrJoints>() = -place.posture.jacobian.transpose().lazyProduct(place.spring_Base);
    gradient[kLwrJoints] = -m_hingeTorque_Nm;
    if (place.contact.springs > 0)
        gradient -= m_curvature.relative.transpose().lazyProduct(place.contact.wrench_Sensor);
    return gradient;
}

double ImpedanceArm::kinetic_J(const Freedoms& rate) const {
    return 0.5 * rate.dot(m_mass.lazyProduct(rate));
}

double ImpedanceArm::energy_J() const {
    Place place;
    place.at << m_state.q_rad, m_state.hinge_rad;
    place.posture = m_posture;
    place.contact = m_contact;
    evaluateSprings(place);
    Freedoms rate;
    rate << m_state.rate_radPerS, m_state.hingeRate_radPerS;
    return kinetic_J(rate) + place.potential_J;
}

void ImpedanceArm::step(double step_s, servo::CycleTimes* times) {
    Place places[2];
    Place* here = &places[0];
    Place* next = &places[1];
    Freedoms rate;
    rate << m_state.rate_radPerS, m_state.hingeRate_radPerS;
    here->at << m_state.q_rad, m_state.hinge_rad;
    here->posture = m_posture;
    here->contact = m_contact;
    evaluateSprings(*here);

    const Freedoms start = here->at;
    const double allowed_J = here->potential_J + kinetic_J(rate);
    const FreedomsMatrix inertia = m_mass / (step_s * step_s);
    FreedomsMatrix quadratic = inertia + m_damping / step_s;
    // Where the last step ended it has been found.
    if (!m_curvature.isOfState)
        findCurvature(*here);
    if (m_impedance.contactDampingTime_s > 0.0 && here->contact.springs > 0)
        quadratic += m_impedance.contactDampingTime_s / step_s * m_curvature.ofContact;
    const Freedoms push = inertia.lazyProduct(step_s * rate);
    const double creep_m = kCreep_mPerS * step_s;
    const bool rubs = m_impedance.friction > 0.0 && here->contact.springs > 0;
    Relative relative;
    if (rubs) {
        relative = m_curvature.relative;
        m_array.listPressed(here->posture.X_Base_Tool.inverse(Eigen::Isometry) * objectAt(start[kLwrJoints]),
                            m_object.shape, m_rubbing);
    }
    // |x - h v|^2_M/2h^2 + |x|^2_D/2h without its constant, x the way from the start.
    const auto inertial_J = [&](const Freedoms& way) {
        const double smooth_J = 0.5 * way.dot(quadratic.lazyProduct(way)) - way.dot(push);
        return rubs ? smooth_J + friction_J(relative.lazyProduct(way), creep_m, nullptr, nullptr) : smooth_J;
    };

    double merit_J = here->potential_J;
    for (int i = 0; i < kMostRestSteps; ++i) {
        if (!m_curvature.isOfState)
            findCurvature(*here);
        Freedoms gradient = gradientAt(*here);
        FreedomsMatrix hessian = m_curvature.hessian;
        gradient += quadratic.lazyProduct(here->at - start) - push;
        hessian += quadratic;
        if (rubs) {
            servo::Vector6 drag = servo::Vector6::Zero();
            servo::Matrix6 stiffness = servo::Matrix6::Zero();
            (void)friction_J(relative.lazyProduct(here->at - start), creep_m, &drag, &stiffness);
            gradient += relative.transpose().lazyProduct(drag);
            const Relative stiff = stiffness.lazyProduct(relative);
            hessian += relative.transpose().lazyProduct(stiff);
        }
        if (!m_object.turns) {
            gradient[kLwrJoints] = 0.0;
            hessian(kLwrJoints, kLwrJoints) = 1.0;
        }
        const Freedoms move = -solve<kFreedoms>(hessian, gradient);
        if (-gradient.dot(move) < kLeastGain_J)
            break;
        double share = 1.0;
        int halving = 0;
        for (; halving < kMostRestHalvings; ++halving, share *= 0.5) {
            evaluate(here->at + share * move, *next, times);
            const double nextMerit_J = next->potential_J + inertial_J(next->at - start);
            if (nextMerit_J <= merit_J) {
                merit_J = nextMerit_J;
                std::swap(here, next);
                m_curvature.isOfState = false;
                break;
            }
        }
        if (halving == kMostRestHalvings)
            break;
    }

    rate = (here->at - start) / step_s;
    const double kinetic = kinetic_J(rate);
    if (kinetic > 0.0 && kinetic + here->potential_J > allowed_J)
        rate *= std::sqrt(std::max(allowed_J - here->potential_J, 0.0) / kinetic);

    m_state.q_rad = here->at.head<kLwrJoints>();
    m_state.hinge_rad = here->at[kLwrJoints];
    m_state.rate_radPerS = rate.head<kLwrJoints>();
    m_state.hingeRate_radPerS = rate[kLwrJoints];
    m_posture = here->posture;
    m_contact = here->contact;
    if ((m_state.q_rad - m_inertiaAt_rad).lpNorm<Eigen::Infinity>() > kInertiaRenewal_rad) {
        rate[kLwrJoints] = 0.0;
        const double before_J = kinetic_J(rate);
        followPosture();
        const double after_J = kinetic_J(rate);
        if (after_J > 0.0)
            m_state.rate_radPerS *= std::sqrt(before_J / after_J);
    }
}

} // namespace teleta::simulation
