// SPDX-License-Identifier: GPL-3.0-or-later
// The arm of tests/data/urdf/crooked_arm.urdf in MuJoCo, which reads URDF by itself.
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"

#include <gtest/gtest.h>

#include <memory>
#include <mujoco/mujoco.h>
#include <random>
#include <string>
#include <vector>

using namespace teleta;

namespace {

const std::string kFile = TELETA_SOURCE_DIR "/tests/data/urdf/crooked_arm.urdf";

struct Simulation {
    Simulation() {
        char error[1000] = "";
        model.reset(mj_loadXML(kFile.c_str(), nullptr, error, sizeof(error)));
        EXPECT_TRUE(model) << error;
        if (model)
            data.reset(mj_makeData(model.get()));
    }

    struct Delete {
        void operator()(mjModel* m) const { mj_deleteModel(m); }
        void operator()(mjData* d) const { mj_deleteData(d); }
    };
    std::unique_ptr<mjModel, Delete> model;
    std::unique_ptr<mjData, Delete> data;
};

arm_model::SerialChain chainOf(const std::string& tip) {
    const core::Expected<arm_model::ArmModel> model = arm_model::readUrdf(kFile);
    EXPECT_TRUE(model) << core::describe(model.error());
    const auto chain =
        arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model), "base_link", tip);
    EXPECT_TRUE(chain) << core::describe(chain.error());
    return *chain;
}

core::JointVector randomPose(const arm_model::SerialChain& chain, std::mt19937_64& random) {
    core::JointVector q = core::JointVector::zeros(chain.joints());
    for (std::size_t i = 0; i < q.size(); ++i) {
        const double low = std::max(chain.joint(i).lowest, -6.0);
        const double high = std::min(chain.joint(i).highest, 6.0);
        q[i] = std::uniform_real_distribution<double>(low, high)(random);
    }
    return q;
}

} // namespace

TEST(ArmModelPeer, posesDerivativesAndGravityAreThoseOfMujoco) {
    Simulation simulation;
    ASSERT_TRUE(simulation.data);
    mjModel* const m = simulation.model.get();
    mjData* const d = simulation.data.get();
    const arm_model::SerialChain chain = chainOf("hand");
    ASSERT_EQ(m->nq, static_cast<int>(chain.joints()));
    std::vector<int> addresses;
    for (std::size_t i = 0; i < chain.joints(); ++i) {
        const int joint = mj_name2id(m, mjOBJ_JOINT, chain.joint(i).name.c_str());
        ASSERT_GE(joint, 0);
        addresses.push_back(m->jnt_qposadr[joint]);
    }
    const int hand = mj_name2id(m, mjOBJ_BODY, "hand");
    ASSERT_GE(hand, 0);
    const Eigen::Vector3d point_Tip(0.03, -0.02, 0.07);

    std::mt19937_64 random(11);
    for (int round = 0; round < 500; ++round) {
        const core::JointVector q = randomPose(chain, random);
        for (std::size_t i = 0; i < q.size(); ++i)
            d->qpos[addresses[i]] = q[i];
        mj_forward(m, d);

        const Eigen::Isometry3d pose = chain.X_Base_Tip(q);
        const Eigen::Map<const Eigen::Vector3d> position(d->xpos + 3 * hand);
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(d->xmat + 9 * hand);
        EXPECT_LT((pose.translation() - position).norm(), 1e-12);
        EXPECT_LT((pose.linear() - rotation).norm(), 1e-12);

        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> linear(3, m->nv);
        Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> angular(3, m->nv);
        const Eigen::Vector3d point_Base = pose * point_Tip;
        mj_jac(m, d, linear.data(), angular.data(), point_Base.data(), hand);
        const arm_model::ChainJacobian jacobian = chain.jacobian(q, point_Tip);
        EXPECT_LT((jacobian.topRows<3>() - linear).norm(), 1e-12);
        EXPECT_LT((jacobian.bottomRows<3>() - angular).norm(), 1e-12);

        const std::optional<core::JointVector> gravity = chain.gravityTorque(q);
        ASSERT_TRUE(gravity);
        for (std::size_t i = 0; i < q.size(); ++i)
            EXPECT_NEAR((*gravity)[i], d->qfrc_bias[addresses[i]], 1e-10) << chain.joint(i).name;
    }
}
