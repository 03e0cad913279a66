// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/ros/arm_check_report.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/failure.h"
#include "backend/pipeline/touch/skin_kinematics.h"
#include "devices/ros/check/arm_check.h"
#include "devices/ros/files/ros_arm_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct ArmCheckReportText {
    Q_DECLARE_TR_FUNCTIONS(RosArmCheckReport)
};

constexpr double kCheckTime_s = 5.0;

/// Words for other programs, as columns have them.
std::string_view wordOf(ros_arm::FindingLevel level) {
    switch (level) {
    case ros_arm::FindingLevel::good:
        return "ok";
    case ros_arm::FindingLevel::note:
        return "note";
    case ros_arm::FindingLevel::problem:
        break;
    }
    return "problem";
}

/// Whether the pad that the file names can be where the file says; nothing: it names none.
std::optional<ros_arm::ArmFinding> padFinding(const ros_arm::RosArmFile& file,
                                              const std::shared_ptr<const arm_model::SerialChain>& chain) {
    using Level = ros_arm::FindingLevel;
    if (!file.touch || file.touch->array.empty())
        return std::nullopt;
    const auto pad = pipeline::padOnLink(chain, file.touch->pad);
    if (!pad)
        return ros_arm::ArmFinding{"pad", Level::problem,
                                   QString::fromStdString(core::describe(pad.error()))};
    const QString link = QString::fromStdString(file.touch->pad.link);
    if (file.effortUnit != ros_arm::EffortUnit::newtonMetre)
        return ros_arm::ArmFinding{
            "pad", Level::note,
            ArmCheckReportText::tr("on %1; touches have a place, but no force and no stiffness, since the "
                                   "arm's efforts are not in Nm")
                .arg(link)};
    return ros_arm::ArmFinding{
        "pad", Level::good,
        ArmCheckReportText::tr("on %1, pressed by %2")
            .arg(link, QString::fromStdString(chain->joint((*pad)->pressingJoint()).name))};
}

} // namespace

core::Expected<void> reportArmCheck(const std::string& path, bool json) {
    TELETA_TRY(const ros_arm::RosArmFile file, ros_arm::readRosArm(path));
    const core::Expected<ros_arm::WatchedArm> watched = ros_arm::watchArm(file, kCheckTime_s, interrupted);
    if (!watched)
        return core::Unexpected(interrupted() ? interruption() : watched.error());
    std::vector<ros_arm::ArmFinding> findings =
        ros_arm::findingsOf(file, *watched->chain, watched->observation);
    if (auto pad = padFinding(file, watched->chain))
        findings.push_back(std::move(*pad));
    constexpr std::array<std::string_view, 3> kColumns{"check", "result", "detail"};
    TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, {json, {}}));
    for (const ros_arm::ArmFinding& finding : findings) {
        rows.text(finding.check);
        rows.text(wordOf(finding.level));
        rows.text(finding.text.toStdString());
        rows.endRow();
    }
    TELETA_CHECK(rows.finish());
    const auto problems =
        std::ranges::count(findings, ros_arm::FindingLevel::problem, &ros_arm::ArmFinding::level);
    if (problems > 0)
        return core::refused(ArmCheckReportText::tr("the arm cannot be moved: %n problem(s)", nullptr,
                                                    static_cast<int>(problems)));
    return {};
}

} // namespace teleta::cli
