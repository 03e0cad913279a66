// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/site/remote/remote_arm.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_client.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace teleta::cli {

/// An arm that a command moves: over ROS 2 in its own network, or at a site, of which control is given up at
/// the end. Thread: one.
class JogTarget : public core::Interface {
public:
    struct Joint {
        std::string name;
        const char* unit = "rad";
    };

    [[nodiscard]] virtual core::ArmSource& arm() = 0;
    [[nodiscard]] virtual QString name() const = 0;
    [[nodiscard]] virtual std::vector<Joint> joints() const = 0;
    /// The arm was looked for long enough, and nothing is in the way but what problem() says.
    [[nodiscard]] virtual bool ready() const = 0;
    /// Why it does not move, a translated sentence without a full stop; empty: it may.
    [[nodiscard]] virtual std::string problem() const = 0;
    /// Limits that act, arm_model::MotionFlag.
    [[nodiscard]] virtual std::uint32_t flags() const = 0;
};

/// Whether such a file can be read, before a person is asked. Error: that of the file.
[[nodiscard]] core::Expected<void> checkJogFile(const std::string& path);

/// An arm at a site, whoever controls it.
struct SiteArm {
    std::shared_ptr<site_link::SiteClient> site;
    std::string device;
    std::unique_ptr<site_link::RemoteArm> arm;
    std::vector<JogTarget::Joint> joints;
};

/// device: as for openJogTarget(). option: with which it was chosen, for the error. Error: that of
/// site_link::SiteClient::open(); badInput, the site has no such arm.
[[nodiscard]] core::Expected<SiteArm> openSiteArm(const site_link::RemoteSiteFile& file,
                                                  const std::string& device, const char* option,
                                                  const core::StopSwitch& stop);

/// The place of a joint in the list. Throws CLI::ValidationError for --joint.
[[nodiscard]] std::size_t jointOf(const std::vector<JogTarget::Joint>& joints, const std::string& name);

/// Opens the arm of a file (kind = "ros_arm"), or an arm of the site of a file (kind = "remote_site"), of
/// which control is then asked for. device: the arm's name at the site; empty: the only one. stop outlives
/// the target. Error: that of the file and of opening; badInput, the site has no such arm.
[[nodiscard]] core::Expected<std::unique_ptr<JogTarget>>
openJogTarget(const std::string& path, const std::string& device, const core::StopSwitch& stop);

} // namespace teleta::cli
