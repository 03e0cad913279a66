// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/wearer_limits.h"

#include "backend/core/data/output_file.h"
#include "backend/core/data/toml_table.h"
#include "backend/core/failure.h"
#include "backend/core/number_text.h"
#include "backend/motors/motor_file.h"
#include "backend/motors/toml_string.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>
#include <vector>

namespace teleta::motors {

namespace {

using core::NumberRange;
using core::TomlDocument;
using core::TomlTable;

struct LimitsText {
    Q_DECLARE_TR_FUNCTIONS(MotorFile)
};

constexpr const char* kLimitsFormat = "teleta-limits";
constexpr long long kLimitsVersion = 1;

core::Expected<WearerLimits> readLimitsDocument(const TomlDocument& document) {
    TomlTable root = document.root();
    (void)root.choice("format", {kLimitsFormat});
    if (root.integer("version", 1, 1'000'000) > kLimitsVersion)
        root.fail("version", LimitsText::tr("the file was written by a newer version").toStdString(),
                  std::to_string(kLimitsVersion));
    WearerLimits limits;
    limits.bracelet = root.text("bracelet");
    std::vector<TomlTable> motors = root.tables("motor", core::kTactors);
    if (motors.size() > core::kTactors)
        root.fail("motor", LimitsText::tr("there are %1 motors").arg(motors.size()).toStdString(),
                  std::to_string(core::kTactors));
    root.finish();
    for (std::size_t i = 0; i < std::min(motors.size(), core::kTactors); ++i) {
        limits.strongest[i] = motors[i].number("strongest", NumberRange::between(0.0, 1.0));
        motors[i].finish();
    }
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return limits;
}

} // namespace

core::Expected<WearerLimits> readLimits(const std::string& path) {
    return TomlDocument::open(path).and_then(readLimitsDocument);
}

core::Expected<WearerLimits> parseLimits(std::string_view text, const std::string& file) {
    return TomlDocument::parse(text, file).and_then(readLimitsDocument);
}

std::string limitsText(const WearerLimits& limits) {
    std::string text = "format = " + quotedToml(kLimitsFormat) +
                       "\nversion = " + std::to_string(kLimitsVersion) +
                       "\nbracelet = " + quotedToml(limits.bracelet) + "\n";
    for (const double strongest : limits.strongest) {
        const core::NumberText number(strongest);
        ((text += "\n[[motor]]\nstrongest = ") += number.view()) += '\n';
    }
    return text;
}

core::Expected<void> writeLimits(const WearerLimits& limits, const std::string& path) {
    QDir().mkpath(QFileInfo(QString::fromStdString(path)).absolutePath());
    return core::writeFile(path, limitsText(limits));
}

std::string limitsPath(const std::string& serial) {
    constexpr std::string_view kEnding = ".toml";
    std::string path = profilePath(serial);
    if (!path.empty())
        path.replace(path.size() - kEnding.size(), kEnding.size(), ".limits.toml");
    return path;
}

core::Expected<WearerLimits> findLimits(const std::string& serial) {
    const std::string path = limitsPath(serial);
    if (path.empty() || !QFileInfo::exists(QString::fromStdString(path)))
        return WearerLimits{.bracelet = serial};
    auto read = readLimits(path);
    if (read && read->bracelet != serial)
        return core::failed(core::ErrorKind::badInput,
                            LimitsText::tr("the limits belong to the bracelet \"%1\"")
                                .arg(QString::fromStdString(read->bracelet)),
                            QString::fromStdString(serial), {path});
    return read;
}

} // namespace teleta::motors
