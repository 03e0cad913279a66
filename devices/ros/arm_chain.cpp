// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/ros/arm_chain.h"

#include "backend/arm_model/urdf_reader.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/wait_set.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <utility>

namespace teleta::ros_arm {

namespace {

struct ArmChainText {
    Q_DECLARE_TR_FUNCTIONS(ArmChainText)
};

constexpr const char* kDescriptionTopic = "/robot_description";
/// Between looks whether to go on.
constexpr std::int64_t kDescriptionLook_ns = 50'000'000;

core::Expected<std::string> takeDescription(const std::shared_ptr<const dds::Participant>& participant,
                                            const std::function<bool()>& cancelled) {
    TELETA_TRY(auto reader, dds::Reader<ros::String>::open(participant, ros::ddsTopicOf(kDescriptionTopic),
                                                           ros::kLatchedReader));
    dds::WaitSet waitSet(participant);
    waitSet.attach(reader);
    std::optional<std::string> text;
    for (const std::int64_t end_ns = core::steadyNow_ns() + kDescriptionWait_ns;
         core::steadyNow_ns() < end_ns;) {
        if (cancelled && cancelled())
            return core::failed(core::ErrorKind::cancelled, ArmChainText::tr("interrupted"));
        (void)reader.take([&text](const ros::String& message, const dds::SampleInfo&) {
            text = message.data == nullptr ? "" : message.data;
        });
        if (text)
            return *text;
        waitSet.wait(kDescriptionLook_ns);
    }
    return core::failed(core::ErrorKind::unavailable,
                        ArmChainText::tr("nobody published %1 in domain %2 within %3 s")
                            .arg(QLatin1String(kDescriptionTopic))
                            .arg(participant->config().domain)
                            .arg(kDescriptionWait_ns / 1'000'000'000),
                        reader.incompatible()
                            ? ArmChainText::tr("a publisher that is reliable and transient local")
                            : ArmChainText::tr("the robot in this domain, or description = \"FILE.urdf\""));
}

} // namespace

core::Expected<std::shared_ptr<const arm_model::SerialChain>>
findChain(const std::shared_ptr<const dds::Participant>& participant, const RosArmFile& file,
          const std::function<bool()>& cancelled) {
    std::shared_ptr<const arm_model::ArmModel> model;
    if (file.description.empty()) {
        TELETA_TRY(const std::string text, takeDescription(participant, cancelled));
        TELETA_TRY(arm_model::ArmModel read, arm_model::parseUrdf(text, kDescriptionTopic));
        model = std::make_shared<const arm_model::ArmModel>(std::move(read));
    } else {
        TELETA_TRY(arm_model::ArmModel read, arm_model::readUrdf(file.description));
        model = std::make_shared<const arm_model::ArmModel>(std::move(read));
    }
    TELETA_TRY(arm_model::SerialChain chain,
               arm_model::SerialChain::create(model, file.baseFrame, file.tipFrame));
    return std::make_shared<const arm_model::SerialChain>(std::move(chain));
}

core::Expected<std::vector<std::string>> wireNames(const RosArmFile& file,
                                                   const arm_model::SerialChain& chain) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < chain.joints(); ++i) {
        std::string name = file.wireName(chain.joint(i).name);
        if (std::ranges::find(names, name) != names.end())
            return core::failed(core::ErrorKind::badInput,
                                ArmChainText::tr("two joints of the arm have the ROS name \"%1\"")
                                    .arg(QString::fromStdString(name)),
                                ArmChainText::tr("a unique name for each joint in [joint_names]"));
        names.push_back(std::move(name));
    }
    return names;
}

QStringList obstacles(const RosArmFile& file, const arm_model::SerialChain& chain,
                      const core::RequiredDevices* required) {
    QStringList found;
    for (std::size_t i = 0; i < chain.joints(); ++i) {
        if (!(chain.joint(i).fastest > 0.0))
            found << ArmChainText::tr("the description gives no velocity limit for %1")
                         .arg(QString::fromStdString(chain.joint(i).name));
    }
    for (const auto& [joint, name] : file.jointNames) {
        if (!chain.model().findJoint(joint))
            found << ArmChainText::tr("[joint_names] names %1, which is not in the description")
                         .arg(QString::fromStdString(joint));
    }
    const std::size_t efforts = file.limits.effortStop_Nm.size();
    if (efforts != 0 && efforts != chain.joints())
        found << ArmChainText::tr("effort_stop has %1 numbers, the arm has %2 joints")
                     .arg(efforts)
                     .arg(chain.joints());
    if (file.effortContainsGravity && chain.linkWithoutMass())
        found << ArmChainText::tr("effort_contains_gravity needs the mass of every link; %1 has none")
                     .arg(QString::fromStdString(*chain.linkWithoutMass()));
    if (!file.required.empty() && required == nullptr) {
        QStringList devices;
        for (const std::string& device : file.required)
            devices << QString::fromStdString(device);
        found << ArmChainText::tr(
                     "the file requires %1, which is not monitored when the arm is driven directly")
                     .arg(devices.join(QStringLiteral(", ")));
    }
    if (file.adapter == Adapter::moveitServo && required == nullptr)
        found << ArmChainText::tr(
            "MoveIt Servo compares stamps with the robot's clock, so only teleta-site sends "
            "commands to it");
    if (file.limits.forceStop_N && !file.wrench)
        found << ArmChainText::tr(
            "force_stop_N needs a force sensor: wrench = \"FILE\" names the file of one");
    if (file.wrench && !file.wrench->frame.empty() && !chain.model().findLink(file.wrench->frame))
        found << ArmChainText::tr("the force sensor is in the frame %1, which the description does not have")
                     .arg(QString::fromStdString(file.wrench->frame));
    if (file.wrench && file.wrench->domain && *file.wrench->domain != file.domain)
        found << ArmChainText::tr(
            "the force sensor must be in the domain of the arm, over the same interface");
    return found;
}

} // namespace teleta::ros_arm
