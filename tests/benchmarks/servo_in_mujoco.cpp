// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/servo_in_mujoco.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

namespace teleta::benchmarks {

namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using servo::kLwrJoints;

constexpr double kTaxelDepth_m = 0.002;

class Vector {
public:
    explicit Vector(const Vector3d& v)
        : m_v(v) {}
    friend std::ostream& operator<<(std::ostream& out, const Vector& vector) {
        return out << vector.m_v.x() << ' ' << vector.m_v.y() << ' ' << vector.m_v.z();
    }

private:
    Vector3d m_v;
};

std::string place(const Isometry3d& X) {
    const Quaterniond q(X.rotation());
    std::ostringstream out;
    out << std::setprecision(17) << " pos=\"" << Vector(X.translation()) << "\" quat=\"" << q.w() << ' '
        << q.x() << ' ' << q.y() << ' ' << q.z() << "\"";
    return out.str();
}

/// A uniform bar between two points, as lwrMassMatrix() has it.
std::string barInertia(const Vector3d& from, const Vector3d& to, double mass_kg) {
    Isometry3d X = Isometry3d::Identity();
    X.translation() = 0.5 * (from + to);
    X.linear() = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from).toRotationMatrix();
    const double across = mass_kg * (to - from).squaredNorm() / 12.0;
    std::ostringstream out;
    out << std::setprecision(17) << "<inertial" << place(X) << " mass=\"" << mass_kg << "\" diaginertia=\""
        << across << ' ' << across << " 1e-6\"/>\n";
    return out.str();
}

/// The scene as MuJoCo reads it. Every body's frame is the base's while all angles are zero.
std::string mjcfOf(const simulation::ImpedanceArm& arm, const scene::BarShape& bar) {
    const servo::LwrPosture zero = arm.kinematics().forward(servo::LwrVector::Zero());
    const Vector3d wrist = zero.p_Base_Joint[5];
    const Vector3d flange = wrist + servo::LwrKinematics::kWristToFlange_m * zero.axis[kLwrJoints - 1];
    std::ostringstream out;
    out << std::setprecision(17)
        << "<mujoco><option timestep=\"0.001\" gravity=\"0 0 0\"/>\n"
           "<size njmax=\"2000\" nconmax=\"500\"/>\n<worldbody>\n";
    Isometry3d X_Base_Bar = arm.X_Base_Object();
    X_Base_Bar.translation() -= bar.radius_m * X_Base_Bar.rotation().col(2);
    out << "<body" << place(X_Base_Bar)
        << "><geom type=\"capsule\" condim=\"1\" contype=\"0\" conaffinity=\"1\" size=\"" << bar.radius_m
        << "\" fromto=\"" << -bar.behind_m << " 0 0 " << bar.ahead_m << " 0 0\"/></body>\n";
    for (std::size_t i = 0; i < kLwrJoints; ++i) {
        out << "<body><joint type=\"hinge\" armature=\"0.05\" pos=\"" << Vector(zero.p_Base_Joint[i])
            << "\" axis=\"" << Vector(zero.axis[i]) << "\"/>\n";
        if (i == 2)
            out << barInertia(zero.p_Base_Joint[1], zero.p_Base_Joint[3], 7.0);
        else if (i == 4)
            out << barInertia(zero.p_Base_Joint[3], wrist, 6.0);
        else
            out << "<inertial pos=\"" << Vector(i + 1 == kLwrJoints ? flange : zero.p_Base_Joint[i])
                << "\" mass=\"" << (i + 1 == kLwrJoints ? 3.0 : 1e-9)
                << "\" diaginertia=\"1e-9 1e-9 1e-9\"/>\n";
    }
    const core::ArrayLayout& layout = arm.array().layout();
    std::ostringstream sensors;
    out << "<site name=\"s\"" << place(zero.X_Base_Tool) << "/>\n";
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column) {
            Isometry3d X = zero.X_Base_Tool;
            X.translation() +=
                X.rotation() * Vector3d(layout.x_m(column), layout.y_m(row), -0.5 * kTaxelDepth_m);
            std::ostringstream size;
            size << " size=\"" << 0.5 * layout.pitchX_m << ' ' << 0.5 * layout.pitchY_m << ' '
                 << 0.5 * kTaxelDepth_m << "\"";
            const std::string name = "t" + std::to_string(row) + "_" + std::to_string(column);
            // Each taxel is a body of its own, because a touch sensor counts the contacts of its body.
            out << "<body" << place(X)
                << "><inertial pos=\"0 0 0\" mass=\"1e-9\" diaginertia=\"1e-12 1e-12 1e-12\"/>"
                << "<geom type=\"box\" condim=\"1\" contype=\"1\" conaffinity=\"0\" mass=\"0\"" << size.str()
                << "/><site name=\"" << name << "\" type=\"box\" size=\"" << 0.6 * layout.pitchX_m << ' '
                << 0.6 * layout.pitchY_m << " 0.005\"/></body>\n";
            sensors << "<touch site=\"" << name << "\"/>\n";
        }
    for (int i = 0; i < kLwrJoints; ++i)
        out << "</body>";
    out << "\n</worldbody>\n<sensor>\n" << sensors.str() << "</sensor></mujoco>\n";
    return out.str();
}

mjModel* modelOf(const std::string& mjcf) {
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    constexpr const char* kName = "servo.xml";
    if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(mjcf.size())) != 0)
        std::exit(1);
    std::memcpy(files->filedata[mj_findFileVFS(files.get(), kName)], mjcf.data(), mjcf.size());
    char error[1000] = "";
    mjModel* model = mj_loadXML(kName, files.get(), error, sizeof(error));
    mj_deleteVFS(files.get());
    if (model == nullptr) {
        std::fprintf(stderr, "servo_benchmark: MuJoCo: %s\n", error);
        std::exit(1);
    }
    return model;
}

} // namespace

ServoInMujoco::ServoInMujoco(const simulation::ImpedanceArm& arm, const scene::BarShape& bar,
                             const simulation::Impedance& impedance)
    : m_X_Base_Reference(arm.X_Base_Reference())
    , m_model(modelOf(mjcfOf(arm, bar)))
    , m_data(mj_makeData(m_model.get())) {
    m_stiffness << Vector3d::Constant(impedance.stiffness_NPerM),
        Vector3d::Constant(impedance.rotationalStiffness_NmPerRad);
    const simulation::LwrMatrix mass = simulation::lwrMassMatrix(arm.posture());
    m_damping = simulation::modalDamping(mass, arm.posture().jacobian, m_stiffness, impedance.dampingRatio);
    m_damping.diagonal().array() += impedance.jointDamping_NmsPerRad;
    for (int i = 0; i < kLwrJoints; ++i)
        m_data->qpos[i] = arm.state().q_rad[i];
    mj_forward(m_model.get(), m_data.get());
    simulation::LwrMatrix theirs;
    mj_fullM(m_model.get(), theirs.data(), m_data->qM);
    m_massDifference_kgm2 = (theirs - mass).cwiseAbs().maxCoeff();
}

void ServoInMujoco::step() {
    mj_step1(m_model.get(), m_data.get());
    using Rows = Eigen::Matrix<double, 3, kLwrJoints, Eigen::RowMajor>;
    Rows turning, moving;
    mj_jacSite(m_model.get(), m_data.get(), moving.data(), turning.data(), 0);
    const Eigen::Map<const Vector3d> at(m_data->site_xpos);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(m_data->site_xmat);
    const Vector3d away = m_X_Base_Reference.translation() - at;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(m_X_Base_Reference.rotation() * axes.transpose()));
    Eigen::Map<servo::LwrVector> torque(m_data->qfrc_applied);
    const Eigen::Map<const servo::LwrVector> rate(m_data->qvel);
    torque = moving.transpose() * m_stiffness.head<3>().cwiseProduct(away) +
             turning.transpose() * m_stiffness.tail<3>().cwiseProduct(turn.angle() * turn.axis()) -
             m_damping * rate;
    mj_step2(m_model.get(), m_data.get());
}

double ServoInMujoco::force_N() const {
    double sum = 0.0;
    for (int i = 0; i < m_model->nsensordata; ++i)
        sum += m_data->sensordata[i];
    return sum;
}

int ServoInMujoco::pressedTaxels() const {
    int count = 0;
    for (int i = 0; i < m_model->nsensordata; ++i)
        count += m_data->sensordata[i] > 0.0 ? 1 : 0;
    return count;
}

} // namespace teleta::benchmarks
