// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/arm_report.h"
#include "backend/core/device/joint_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/wait_set.h"
#include "devices/site/remote/remote_stream.h"
#include "devices/site/site_client.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::site_link {

/// An arm at a site as a source of joint samples, moved by the operator as long as this console is in
/// control. Times are those of the reads at the site, by the clock here.
///   connecting -> live <-> stale; stop(): closed
/// Thread: as core::ArmSource.
class RemoteArm : public core::ArmSource, public core::ReportingArm {
public:
    /// name: of the arm at the site. description: as the site describes it. hasWrench: the site sends what
    /// the arm's sensor of force and torque measures. Error: unavailable, its topics cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<RemoteArm>> open(std::shared_ptr<SiteClient> site,
                                                                         const std::string& name,
                                                                         core::ArmDescription description,
                                                                         bool hasWrench);

    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::JointSample>& joints() override { return m_outlet.samples(); }
    [[nodiscard]] core::BoundedQueue<core::WrenchSample>* wrenches() override {
        return m_wrenchReader ? &m_wrenches : nullptr;
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }
    [[nodiscard]] core::ArmDrive drive() const override;
    [[nodiscard]] std::string hindrance() const override;
    /// The limits that act, as the site told last.
    [[nodiscard]] core::ArmReport report() const override;
    void post(const core::ArmCommand& command) override { m_site->post(m_name, command); }

private:
    friend core::DeviceThread<RemoteArm>;
    RemoteArm(std::shared_ptr<SiteClient> site, std::string name, core::ArmDescription description,
              dds::Reader<ros::JointBlock> reader,
              std::optional<dds::Reader<ros::TactileBlock>> wrenchReader);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_waitSet.wake(); }
    void take(const ros::JointBlock& block);
    void takeWrench(const ros::TactileBlock& block);

    std::shared_ptr<SiteClient> m_site;
    std::string m_name;
    core::ArmDescription m_description;
    dds::Reader<ros::JointBlock> m_reader;
    std::optional<dds::Reader<ros::TactileBlock>> m_wrenchReader; ///< nothing: the arm has no such sensor
    dds::WaitSet m_waitSet;
    core::JointOutlet m_outlet;
    core::BoundedQueue<core::WrenchSample> m_wrenches;
    RemoteStream m_stream;
    RemoteStream m_wrenchStream;
    core::DeviceThread<RemoteArm> m_thread{*this};
};

} // namespace teleta::site_link
