// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_file.h"

#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/toml_string.h"
#include "backend/core/keys/toml_table.h"
#include "backend/core/number_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <utility>
#include <vector>

namespace teleta::motors {

namespace {

using core::NumberRange;
using core::TomlDocument;
using core::TomlTable;
using Origin = CalibratedMotor::Origin;

struct FileText {
    Q_DECLARE_TR_FUNCTIONS(FileText)
};

constexpr const char* kFormat = "teleta-motors";
constexpr long long kVersion = 1;
constexpr double kLongest_s = 10.0;
constexpr double kFastest_Hz = 1e4;
const std::vector<std::string_view> kOrigins{"assumed", "answers", "recording"};

CalibratedMotor readMotor(TomlTable table) {
    CalibratedMotor motor;
    pattern::MotorProfile& profile = motor.profile;
    profile.name = table.text("name", std::string());
    motor.startFrom = static_cast<Origin>(table.choice("start_from", kOrigins));
    motor.lagFrom = static_cast<Origin>(table.choice("lag_from", kOrigins));
    profile.rangeAssumed = motor.startFrom == Origin::assumed;
    profile.assumed = motor.lagFrom == Origin::assumed;
    profile.startDrive = table.number("start_drive", NumberRange::positiveUpTo(1.0));
    profile.fullDrive = table.number("full_drive", NumberRange::positiveUpTo(1.0), 1.0);
    profile.riseTime_s = table.number("rise_s", NumberRange::positiveUpTo(kLongest_s));
    profile.fallTime_s = table.number("fall_s", NumberRange::positiveUpTo(kLongest_s));
    profile.overdrive = table.number("overdrive", NumberRange::between(1.0, 10.0), 1.0);
    profile.longestOverdrive_s =
        table.number("longest_overdrive_s", NumberRange::between(0.0, kLongest_s), 0.0);
    motor.startError = table.number("start_error", NumberRange::between(0.0, 1.0), 0.0);
    motor.riseError_s = table.number("rise_error_s", NumberRange::between(0.0, kLongest_s), 0.0);
    motor.fallError_s = table.number("fall_error_s", NumberRange::between(0.0, kLongest_s), 0.0);
    profile.curve.clear();
    for (TomlTable& point : table.tables("curve", 2)) {
        const double drive = point.number("drive", NumberRange::between(0.0, 1.0));
        profile.curve.push_back({drive, point.number("speed_Hz", NumberRange::between(0.0, kFastest_Hz))});
        point.finish();
    }
    table.finish();
    if (!profile.valid())
        table.fail(
            "curve", FileText::tr("these values are inconsistent").toStdString(),
            FileText::tr(
                "0 < start_drive < full_drive, and a curve that rises from the start or below it to drive 1")
                .toStdString());
    return motor;
}

core::Expected<MotorCalibration> readDocument(const TomlDocument& document) {
    MotorCalibration calibration;
    calibration.bracelet =
        readBraceletFile(document, kFormat, [&](const TomlTable& table, std::size_t motor) {
            calibration.motors[motor] = readMotor(table);
        });
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return calibration;
}

std::string number(double value) {
    return std::string(core::NumberText(value).view());
}

} // namespace

pattern::MotorProfiles MotorCalibration::profiles() const {
    pattern::MotorProfiles profiles;
    std::ranges::transform(motors, profiles.begin(), &CalibratedMotor::profile);
    return profiles;
}

bool MotorCalibration::measured() const {
    return std::ranges::any_of(motors, &CalibratedMotor::measured);
}

pattern::MotorProfile withStart(pattern::MotorProfile motor, double start) {
    motor.startDrive = start;
    motor.rangeAssumed = false;
    if (motor.curve.front().drive <= start)
        return motor;
    const pattern::SpeedPoint a = motor.curve[0];
    // A curve that ends at rest cannot fall further.
    if (a.speed_Hz <= 0.0) {
        motor.curve[0].drive = start;
        return motor;
    }
    const double slope = (motor.curve[1].speed_Hz - a.speed_Hz) / (motor.curve[1].drive - a.drive);
    const double speed_Hz = std::clamp(a.speed_Hz - slope * (a.drive - start), 0.0, 0.999 * a.speed_Hz);
    std::vector<pattern::SpeedPoint> curve{{start, speed_Hz}};
    curve.insert(curve.end(), motor.curve.begin(), motor.curve.end());
    motor.curve = std::move(curve);
    return motor;
}

std::string readBraceletFile(const TomlDocument& document, const char* format,
                             const std::function<void(TomlTable, std::size_t)>& read) {
    TomlTable root = document.root();
    (void)root.choice("format", {format});
    if (root.integer("version", 1, 1'000'000) > kVersion)
        root.fail("version", FileText::tr("the file was written by a newer version").toStdString(),
                  std::to_string(kVersion));
    std::string bracelet = root.text("bracelet");
    const std::vector<TomlTable> motors = root.tables("motor", core::kTactors);
    if (motors.size() > core::kTactors)
        root.fail("motor", FileText::tr("there are %1 motors").arg(motors.size()).toStdString(),
                  std::to_string(core::kTactors));
    root.finish();
    for (std::size_t i = 0; i < std::min(motors.size(), core::kTactors); ++i)
        read(motors[i], i);
    return bracelet;
}

core::Expected<MotorCalibration> readMotors(const std::string& path) {
    return TomlDocument::open(path).and_then(readDocument);
}

core::Expected<MotorCalibration> parseMotors(std::string_view text, const std::string& file) {
    return TomlDocument::parse(text, file).and_then(readDocument);
}

std::string motorsText(const MotorCalibration& calibration) {
    std::string text;
    const auto line = [&text](std::string_view key, const std::string& value) {
        (((text += key) += " = ") += value) += '\n';
    };
    line("format", core::quotedToml(kFormat));
    line("version", std::to_string(kVersion));
    line("bracelet", core::quotedToml(calibration.bracelet));
    for (const CalibratedMotor& motor : calibration.motors) {
        const pattern::MotorProfile& profile = motor.profile;
        text += "\n[[motor]]\n";
        if (!profile.name.empty())
            line("name", core::quotedToml(profile.name));
        line("start_from",
             core::quotedToml(std::string(kOrigins[static_cast<std::size_t>(motor.startFrom)])));
        line("start_drive", number(profile.startDrive));
        line("start_error", number(motor.startError));
        line("full_drive", number(profile.fullDrive));
        line("lag_from", core::quotedToml(std::string(kOrigins[static_cast<std::size_t>(motor.lagFrom)])));
        line("rise_s", number(profile.riseTime_s));
        line("rise_error_s", number(motor.riseError_s));
        line("fall_s", number(profile.fallTime_s));
        line("fall_error_s", number(motor.fallError_s));
        line("overdrive", number(profile.overdrive));
        line("longest_overdrive_s", number(profile.longestOverdrive_s));
        text += "curve = [\n";
        for (const pattern::SpeedPoint& point : profile.curve)
            text +=
                "    { drive = " + number(point.drive) + ", speed_Hz = " + number(point.speed_Hz) + " },\n";
        text += "]\n";
    }
    return text;
}

core::Expected<void> writeMotors(const MotorCalibration& calibration, const std::string& path) {
    TELETA_CHECK(core::makeFolder(QFileInfo(QString::fromStdString(path)).absolutePath().toStdString()));
    return core::writeFile(path, motorsText(calibration));
}

std::string profilePath(const std::string& serial) {
    if (serial.empty())
        return {};
    constexpr char kHex[] = "0123456789ABCDEF";
    std::string name;
    for (const char c : serial) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_';
        if (plain)
            name += c;
        else
            ((name += '%') += kHex[byte >> 4U]) += kHex[byte & 15U];
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    return (folder + QStringLiteral("/teleta/motors/")).toStdString() + name + ".toml";
}

core::Expected<std::optional<MotorCalibration>> findMotors(const std::string& serial) {
    const std::string path = profilePath(serial);
    if (path.empty() || !QFileInfo::exists(QString::fromStdString(path)))
        return std::nullopt;
    TELETA_TRY(MotorCalibration read, readMotors(path));
    if (read.bracelet != serial)
        return core::failed(core::ErrorKind::badInput,
                            FileText::tr("the profile belongs to the bracelet \"%1\"")
                                .arg(QString::fromStdString(read.bracelet)),
                            QString::fromStdString(serial), {path});
    return read;
}

} // namespace teleta::motors
