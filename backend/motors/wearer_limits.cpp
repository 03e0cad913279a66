// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/wearer_limits.h"

#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/toml_string.h"
#include "backend/core/number_text.h"
#include "backend/motors/motor_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <string_view>

namespace teleta::motors {

namespace {

using core::TomlDocument;

struct LimitsText {
    Q_DECLARE_TR_FUNCTIONS(MotorFile)
};

constexpr const char* kLimitsFormat = "teleta-limits";

core::Expected<WearerLimits> readLimitsDocument(const TomlDocument& document) {
    WearerLimits limits;
    limits.bracelet =
        readBraceletFile(document, kLimitsFormat, [&](core::TomlTable table, std::size_t motor) {
            limits.strongest[motor] = table.number("strongest", core::NumberRange::between(0.0, 1.0));
            table.finish();
        });
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
    std::string text = "format = " + core::quotedToml(kLimitsFormat) +
                       "\nversion = 1\nbracelet = " + core::quotedToml(limits.bracelet) + "\n";
    for (const double strongest : limits.strongest) {
        const core::NumberText number(strongest);
        ((text += "\n[[motor]]\nstrongest = ") += number.view()) += '\n';
    }
    return text;
}

core::Expected<void> writeLimits(const WearerLimits& limits, const std::string& path) {
    TELETA_CHECK(core::makeFolder(QFileInfo(QString::fromStdString(path)).absolutePath().toStdString()));
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
