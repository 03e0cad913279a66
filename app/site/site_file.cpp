// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_file.h"

#include "app/sources/source_list.h"
#include "backend/core/beside_file.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/core/keys/toml_table.h"
#include "devices/ros/files/ros_file_keys.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_topics.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <utility>

namespace teleta::site_program {

namespace {

using core::TomlTable;

struct SiteFileText {
    Q_DECLARE_TR_FUNCTIONS(SiteFileText)
};

constexpr std::int64_t kPerMs = 1'000'000;

std::int64_t milliseconds(TomlTable& table, std::string_view key, long long low, long long high,
                          std::int64_t fallback_ns) {
    return table.integer(key, low, high, fallback_ns / kPerMs) * kPerMs;
}

/// The id that the device has, or else the name of its file.
std::string readId(TomlTable& table, const std::string& file) {
    if (table.has("id") || file.empty())
        return site_link::readSiteName(table, "id");
    std::string name = QFileInfo(QString::fromStdString(file)).completeBaseName().toStdString();
    if (!site_link::isSiteName(name))
        table.fail(
            "file", SiteFileText::tr("the device needs an id").toStdString(),
            SiteFileText::tr("id = \"a small letter, then small letters, digits and _\"").toStdString());
    return name;
}

/// A file of its own: that of an arm, of an array, or of a camera over ROS 2.
app::SourceRequest readFile(TomlTable& table, const std::string& path) {
    if (!app::isSourceList(path))
        return app::ArmRequest{path};
    auto list = app::readSourceList(path);
    if (!list)
        table.fail("file", core::describe(list.error()), {});
    else if (list->size() == 1)
        return std::move(list->front());
    else
        table.fail(
            "file", SiteFileText::tr("a site does not send this kind of device").toStdString(),
            SiteFileText::tr("the file of an arm, an array, a gel or a camera over ROS 2").toStdString());
    return app::ArmRequest{path};
}

/// How much of a link a camera may take.
site_link::PictureSettings readPictures(TomlTable& table) {
    using Settings = site_link::PictureSettings;
    Settings pictures;
    pictures.quality =
        static_cast<int>(table.integer("quality", Settings::kLowestQuality, 100, pictures.quality));
    pictures.most_kbitPerS = table.number(
        "max_kbit_s", core::NumberRange::between(Settings::kLowest_kbitPerS, Settings::kHighest_kbitPerS),
        pictures.most_kbitPerS);
    return pictures;
}

/// Where on an arm an array is.
std::optional<core::PadPlacement> readPad(TomlTable& table) {
    core::PadPlacement pad;
    if (!table.has("frame")) {
        if (table.has("pose"))
            table.fail("pose", SiteFileText::tr("a pose needs a frame").toStdString(),
                       SiteFileText::tr("frame = \"the link of the arm\"").toStdString());
        return std::nullopt;
    }
    pad.link = table.text("frame");
    ros_arm::readPose(table, pad);
    return pad;
}

bool isArray(const app::SourceRequest& request) {
    return std::holds_alternative<app::WtsRequest>(request) ||
           std::holds_alternative<app::TaxelsRequest>(request);
}

void readDevice(TomlTable& table, const std::string& path, SiteFile& site) {
    std::vector<app::SourceRequest> requests;
    std::string id;
    if (table.has("file")) {
        const std::string file = table.text("file");
        id = readId(table, file);
        requests.push_back(readFile(table, core::besideFile(path, file)));
    } else {
        id = readId(table, {});
        if (const char* key = "recording"; table.has(key))
            table.fail(key, SiteFileText::tr("a site does not send this kind of device").toStdString(),
                       SiteFileText::tr("file, wts, taxels, gel, scene or scene_camera").toStdString());
        core::TomlKeys keys(table);
        if (const char* key = table.has("camera") ? "camera" : "scene_camera"; table.has(key)) {
            app::SceneCameraRequest camera;
            app::describeSceneCamera(keys, key, path, camera);
            requests.emplace_back(std::move(camera));
        } else {
            const app::SourceKind kind = table.has("wts")      ? app::SourceKind::wts
                                         : table.has("taxels") ? app::SourceKind::taxels
                                         : table.has("gel")    ? app::SourceKind::gel
                                                               : app::SourceKind::scene;
            app::describeSource(keys, kind, path, requests);
        }
    }
    for (app::SourceRequest& request : requests) {
        SiteDevice device{id, std::move(request)};
        if (std::holds_alternative<app::SceneCameraRequest>(device.request) ||
            std::holds_alternative<app::GelRequest>(device.request))
            device.pictures = readPictures(table);
        if (isArray(device.request))
            device.pad = readPad(table);
        site.devices.push_back(std::move(device));
    }
    table.finish();
}

core::Expected<SiteFile> read(const core::TomlDocument& document, const std::string& path) {
    SiteFile site;
    TomlTable root = document.root();
    (void)root.choice("kind", {"site"});
    site.name = site_link::readSiteName(root, "name");
    for (const std::string& name : root.textList("supervisors")) {
        if (!site_link::isSiteName(name))
            root.fail("supervisors",
                      SiteFileText::tr("\"%1\" is no name of a console")
                          .arg(QString::fromStdString(name))
                          .toStdString(),
                      SiteFileText::tr("a small letter, then at most 30 small letters, digits and _")
                          .toStdString());
        site.supervisors.insert(name);
    }
    site.times.motion_ns = milliseconds(root, "motion_lease_ms", 60, 300, site.times.motion_ns);
    site.times.control_ns = milliseconds(root, "control_lease_ms", 500, 60'000, site.times.control_ns);
    site.times.loopLimit_ns = milliseconds(root, "loop_limit_ms", 50, 5'000, site.times.loopLimit_ns);
    site.record = root.boolean("record", false);
    site.meeting = site_link::readOperatorDomain(root, path);
    const bool reliable = root.boolean("ros_reliable", false);
    const std::optional<dds::DomainConfig> ros = ros_arm::readRos(root);
    if (root.boolean("publish_tactile_state", false))
        site.publishing = SiteFile::Publishing{ros.value_or(dds::DomainConfig()), reliable};
    std::set<std::string> ids;
    for (TomlTable& table : root.tables("device", 1)) {
        readDevice(table, path, site);
        if (!site.devices.empty() && !ids.insert(site.devices.back().id).second)
            table.fail("id",
                       SiteFileText::tr("two devices are called \"%1\"")
                           .arg(QString::fromStdString(site.devices.back().id))
                           .toStdString(),
                       SiteFileText::tr("a unique id for each device").toStdString());
    }
    root.finish();
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return site;
}

} // namespace

core::Expected<SiteFile> readSite(const std::string& path) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::open(path));
    return read(document, path);
}

core::Expected<SiteFile> parseSite(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    return read(document, file);
}

} // namespace teleta::site_program
