// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/site/control_arbiter.h"
#include "devices/site/image/picture_budget.h"
#include "devices/site/operator_domain.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::site_program {

/// A device of a site.
struct SiteDevice {
    std::string id; ///< as consoles see it: site_link::isSiteName()
    app::SourceRequest request;
    site_link::PictureSettings pictures = {}; ///< of a camera
    /// Of an array on an arm of the site: its link, and its pose there.
    std::optional<core::PadPlacement> pad = {};
};

/// What is at the robot's place (kind = "site"), as a TOML file describes it.
struct SiteFile {
    std::string name;
    std::set<std::string> supervisors; ///< consoles that may take control over and withdraw STOP of others
    site::LeaseTimes times;
    bool record = false;
    /// Where its arrays are sent to programs of ROS 2, and whether reliably (ros_reliable); empty: nowhere
    /// (publish_tactile_state = false).
    struct Publishing {
        dds::DomainConfig domain;
        bool reliable = false;
    };
    std::optional<Publishing> publishing;
    site_link::OperatorDomain meeting;
    std::vector<SiteDevice> devices; ///< at least one
};

/// Reads a site's file; paths in it count from its folder. Error: notFound, ioFailed, badInput with file,
/// line and column. Thread: any.
[[nodiscard]] core::Expected<SiteFile> readSite(const std::string& path);
/// The same of a text; file: named in errors.
[[nodiscard]] core::Expected<SiteFile> parseSite(std::string_view text, const std::string& file);

} // namespace teleta::site_program
