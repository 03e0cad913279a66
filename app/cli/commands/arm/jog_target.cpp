// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/arm/jog_target.h"

#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/common/version.h"
#include "app/sources/source_list.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/failure.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "devices/ros/files/ros_arm_file.h"
#include "devices/ros/ros_arm.h"
#include "devices/site/site_streams.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace teleta::cli {

namespace {

struct JogTargetText {
    Q_DECLARE_TR_FUNCTIONS(JogTargetText)
};

std::vector<JogTarget::Joint> jointsOf(const arm_model::SerialChain& chain) {
    std::vector<JogTarget::Joint> joints;
    for (std::size_t i = 0; i < chain.joints(); ++i)
        joints.push_back(
            {chain.joint(i).name, chain.joint(i).type == arm_model::JointType::prismatic ? "m" : "rad"});
    return joints;
}

class RosTarget : public JogTarget {
public:
    explicit RosTarget(std::unique_ptr<ros_arm::RosArm> arm)
        : m_arm(std::move(arm)) {}

    core::ArmSource& arm() override { return *m_arm; }
    QString name() const override { return QString::fromStdString(m_arm->file().name); }
    std::vector<Joint> joints() const override { return jointsOf(m_arm->chain()); }
    bool ready() const override {
        const ros_arm::RosArmState state = m_arm->state();
        return state.ready && !state.mover.needsRelease;
    }
    std::string problem() const override { return m_arm->hindrance(); }
    std::uint32_t flags() const override { return m_arm->state().mover.flags; }

private:
    std::unique_ptr<ros_arm::RosArm> m_arm;
};

class SiteTarget : public JogTarget {
public:
    explicit SiteTarget(SiteArm arm)
        : m_at(std::move(arm)) {
        m_at.site->request(site::RequestKind::request);
    }

    core::ArmSource& arm() override { return *m_at.arm; }
    QString name() const override {
        return QStringLiteral("%1 (%2)").arg(QString::fromStdString(m_at.device),
                                             QString::fromStdString(m_at.site->file().name));
    }
    std::vector<Joint> joints() const override { return m_at.joints; }
    bool ready() const override { return m_at.site->view().controls(m_at.site->file().console); }
    std::string problem() const override { return m_at.arm->hindrance(); }
    std::uint32_t flags() const override {
        const site_link::SiteView view = m_at.site->view();
        const auto found = std::ranges::find(view.arms, m_at.device, &site_link::RemoteArmState::name);
        return found == view.arms.end() ? 0 : found->flags;
    }

private:
    SiteArm m_at;
};

} // namespace

core::Expected<SiteArm> openSiteArm(const site_link::RemoteSiteFile& file, const std::string& device,
                                    const char* option, const core::StopSwitch& stop) {
    TELETA_TRY(auto site,
               site_link::SiteClient::open(file, app::version().text().toStdString(), stop, interrupted));
    QStringList names;
    const recording::StreamInfo* chosen = nullptr;
    for (const recording::StreamInfo& stream : site->streams()) {
        if (stream.kind != recording::StreamKind::joints)
            continue;
        names << QString::fromStdString(site_link::deviceOf(stream));
        if (device.empty() || names.back().toStdString() == device)
            chosen = &stream;
    }
    if (chosen == nullptr || (device.empty() && names.size() > 1))
        return core::failed(
            core::ErrorKind::badInput,
            device.empty()
                ? JogTargetText::tr("%1 has no arm, or several").arg(QString::fromStdString(file.name))
                : JogTargetText::tr("%1 has no arm \"%2\"")
                      .arg(QString::fromStdString(file.name), QString::fromStdString(device)),
            names.isEmpty() ? QString()
                            : JogTargetText::tr("%1 with one of %2")
                                  .arg(QLatin1String(option), names.join(QStringLiteral(", "))));
    const std::string name = site_link::deviceOf(*chosen);
    TELETA_TRY(const pipeline::RecordedArm described, pipeline::recordedArm(*chosen, file.name));
    TELETA_TRY(auto arm, site_link::RemoteArm::open(site, name, described.description, false));
    std::vector<JogTarget::Joint> joints;
    if (described.chain) {
        joints = jointsOf(*described.chain);
    } else {
        for (std::size_t i = 1; i <= described.description.joints(); ++i)
            joints.push_back({"joint_" + std::to_string(i)});
    }
    return SiteArm{std::move(site), name, std::move(arm), std::move(joints)};
}

std::size_t jointOf(const std::vector<JogTarget::Joint>& joints, const std::string& name) {
    QStringList names;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (joints[i].name == name)
            return i;
        names << QString::fromStdString(joints[i].name);
    }
    refuse("--joint", JogTargetText::tr("the arm has no joint \"%1\"; it has %2")
                          .arg(QString::fromStdString(name), names.join(QStringLiteral(", "))));
}

core::Expected<void> checkJogFile(const std::string& path) {
    if (app::isSiteFile(path))
        TELETA_CHECK(site_link::readRemoteSite(path));
    else
        TELETA_CHECK(ros_arm::readRosArm(path));
    return {};
}

core::Expected<std::unique_ptr<JogTarget>> openJogTarget(const std::string& path, const std::string& device,
                                                         const core::StopSwitch& stop) {
    if (app::isSiteFile(path)) {
        TELETA_TRY(const auto file, site_link::readRemoteSite(path));
        TELETA_TRY(SiteArm arm, openSiteArm(file, device, "--arm", stop));
        return std::make_unique<SiteTarget>(std::move(arm));
    }
    TELETA_TRY(const ros_arm::RosArmFile file, ros_arm::readRosArm(path));
    TELETA_TRY(auto arm, ros_arm::RosArm::open(file, stop, interrupted));
    return std::make_unique<RosTarget>(std::move(arm));
}

} // namespace teleta::cli
