// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/arm/arm_commands.h"
#include "app/cli/commands/arm/arm_jog.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/core/data/output_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

namespace {

using arm_model::ArmModel;
using arm_model::JointType;
using arm_model::ModelJoint;
using arm_model::SerialChain;

struct ArmText {
    Q_DECLARE_TR_FUNCTIONS(ArmCommand)
};

constexpr auto kFolder = ":/arms";

/// The file, or the description of that name that comes with the program. A file goes first.
std::string placeOf(const std::string& pathOrName) {
    const QFileInfo file(QString::fromStdString(pathOrName));
    const QString resource = QStringLiteral("%1/%2.urdf").arg(kFolder, file.filePath());
    return !file.isFile() && QFileInfo::exists(resource) ? resource.toStdString() : pathOrName;
}

QString shippedNames() {
    QStringList names;
    for (const QFileInfo& file : QDir(kFolder).entryInfoList(QDir::Files, QDir::Name))
        names << file.completeBaseName();
    return names.join(QStringLiteral(", "));
}

const char* typeName(JointType type) {
    switch (type) {
    case JointType::revolute:
        return "revolute";
    case JointType::continuous:
        return "continuous";
    case JointType::prismatic:
        return "prismatic";
    case JointType::fixed:
        break;
    }
    return "fixed";
}

std::size_t movableOnTheWay(const ArmModel& model, std::size_t link) {
    std::size_t count = 0;
    for (; link != 0; link = model.joints[link - 1].parentLink)
        count += model.joints[link - 1].type != JointType::fixed ? 1 : 0;
    return count;
}

/// A link that is called as in REP 105, else the leaf to which most joints lead.
std::size_t likelyTip(const ArmModel& model) {
    for (const char* name : {"tool0", "flange", "ee_link"}) {
        if (const std::optional<std::size_t> link = model.findLink(name))
            return *link;
    }
    std::size_t best = 0;
    for (const std::size_t leaf : model.leaves()) {
        if (movableOnTheWay(model, leaf) > movableOnTheWay(model, best))
            best = leaf;
    }
    return best;
}

/// What the description says of a joint, for people.
struct JointRow {
    QString name;
    QString type;
    QString range;
    QString speed;
    QString effort;
    QString remark;
};

JointRow rowOf(const ModelJoint& joint) {
    const bool slides = joint.type == JointType::prismatic;
    JointRow row;
    row.name = QString::fromStdString(joint.name);
    row.type = QLatin1String(typeName(joint.type));
    row.range = joint.type == JointType::continuous
                    ? ArmText::tr("no end")
                    : QStringLiteral("%1 .. %2 %3")
                          .arg(forPeople(joint.lowest), forPeople(joint.highest),
                               QLatin1String(slides ? "m" : "rad"));
    row.speed = joint.fastest > 0.0 ? forPeople(joint.fastest) + QLatin1String(slides ? " m/s" : " rad/s")
                                    : ArmText::tr("not stated");
    row.effort = joint.strongest > 0.0 ? forPeople(joint.strongest) + QLatin1String(slides ? " N" : " Nm")
                                       : ArmText::tr("not stated");
    if (!(joint.fastest > 0.0))
        row.remark = ArmText::tr("cannot be moved: the description states no speed");
    return row;
}

class ArmCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        app.require_subcommand(1);
        CLI::App& show =
            addPart(app, "show", ArmText::tr("Chain, limits and mass of an arm, and what cannot be moved"),
                    [this] { return showArm(); });
        addOption(
            show, "urdf", m_path,
            ArmText::tr("URDF file, or the name of one that comes with the program: %1").arg(shippedNames()),
            "URDF")
            ->required();
        addOption(show, "--base", m_base, ArmText::tr("Link that stands still; default: the root"), "LINK");
        addOption(show, "--tip", m_tip,
                  ArmText::tr("Link that is moved; default: tool0, flange or ee_link, else the end of the "
                              "longest chain"),
                  "LINK");
        declareJson(show, m_json);
        CLI::App& jog = addPart(app, "jog", ArmText::tr("Move a joint of an arm for a short time"), [this] {
            m_jog.json = m_json;
            return jogArm(m_jog);
        });
        addOption(jog, "arm", m_jog.path,
                  ArmText::tr("File that describes the arm (kind = \"ros_arm\"), or with which its "
                              "site is reached (kind = \"remote_site\")"),
                  "FILE.toml")
            ->required();
        addOption(jog, "--arm", m_jog.arm, ArmText::tr("Which arm of a site; default: its only one"), "NAME");
        addOption(jog, "--joint", m_jog.joint, ArmText::tr("Joint to move, as the URDF names it"), "NAME")
            ->required();
        addOption(jog, "--rate", m_jog.rate, ArmText::tr("Speed in rad/s, of a prismatic joint in m/s"), "R")
            ->check(nonZero())
            ->required();
        addOption(jog, "--seconds", m_jog.time_s,
                  ArmText::tr("Duration of the motion, at most %1").arg(kLongestJog_s), "S")
            ->check(positive() & between(0.0, kLongestJog_s))
            ->required();
        addFlag(jog, "--yes", m_jog.yes, ArmText::tr("Move without asking"));
        declareJson(jog, m_json);
    }

private:
    [[nodiscard]] core::Expected<void> showArm() const {
        TELETA_TRY(ArmModel read, arm_model::readUrdf(placeOf(m_path)));
        const auto model = std::make_shared<const ArmModel>(std::move(read));
        const std::string base = m_base.empty() ? model->links.front().name : m_base;
        const std::string tip = m_tip.empty() ? model->links[likelyTip(*model)].name : m_tip;
        core::Expected<SerialChain> chain = SerialChain::create(model, base, tip);
        if (!chain) {
            core::Error error = chain.error();
            error.where.file = m_path;
            return core::Unexpected(error);
        }
        return m_json ? printJson(*chain) : printText(*chain);
    }

    /// Movable joints that do not move the tip.
    static std::vector<const ModelJoint*> others(const SerialChain& chain) {
        std::vector<const ModelJoint*> found;
        for (const ModelJoint& joint : chain.model().joints) {
            bool moves = false;
            for (std::size_t i = 0; i < chain.joints(); ++i)
                moves = moves || &chain.joint(i) == &joint;
            if (joint.movable() && !moves)
                found.push_back(&joint);
        }
        return found;
    }

    static nlohmann::ordered_json jointJson(const ModelJoint& joint) {
        const bool turns = joint.type == JointType::continuous;
        return {{"name", joint.name},
                {"type", typeName(joint.type)},
                {"unit", joint.type == JointType::prismatic ? "m" : "rad"},
                {"lowest", orNull(turns ? std::nullopt : std::optional(joint.lowest))},
                {"highest", orNull(turns ? std::nullopt : std::optional(joint.highest))},
                {"fastest_per_s", orNull(joint.fastest > 0.0 ? std::optional(joint.fastest) : std::nullopt)},
                {"strongest", orNull(joint.strongest > 0.0 ? std::optional(joint.strongest) : std::nullopt)}};
    }

    [[nodiscard]] static core::Expected<void> printJson(const SerialChain& chain) {
        nlohmann::ordered_json joints = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < chain.joints(); ++i)
            joints.push_back(jointJson(chain.joint(i)));
        nlohmann::ordered_json shown = nlohmann::ordered_json::array();
        for (const ModelJoint* joint : others(chain))
            shown.push_back(jointJson(*joint));
        nlohmann::ordered_json mimics = nlohmann::ordered_json::array();
        for (const ModelJoint& joint : chain.model().joints) {
            if (joint.mimic)
                mimics.push_back({{"name", joint.name},
                                  {"follows", chain.model().joints[joint.mimic->followed].name},
                                  {"factor", joint.mimic->factor},
                                  {"offset", joint.mimic->offset}});
        }
        const std::optional<std::string> missing = chain.linkWithoutMass();
        const nlohmann::ordered_json document{
            {"name", chain.model().name},
            {"base", chain.baseLink()},
            {"tip", chain.tipLink()},
            {"joints", joints},
            {"not_moved", shown},
            {"mimics", mimics},
            {"moved_mass_kg", orNull(missing ? std::nullopt : std::optional(chain.movedMass_kg()))},
            {"link_without_mass",
             missing ? nlohmann::ordered_json(*missing) : nlohmann::ordered_json(nullptr)}};
        return printDocument(document);
    }

    [[nodiscard]] static core::Expected<void> printText(const SerialChain& chain) {
        std::vector<JointRow> rows{{ArmText::tr("Joint"),
                                    ArmText::tr("Type"),
                                    ArmText::tr("Range"),
                                    ArmText::tr("Speed"),
                                    ArmText::tr("Effort"),
                                    {}}};
        for (std::size_t i = 0; i < chain.joints(); ++i)
            rows.push_back(rowOf(chain.joint(i)));
        for (const ModelJoint* joint : others(chain)) {
            rows.push_back(rowOf(*joint));
            rows.back().remark = ArmText::tr("shown, not moved");
        }
        for (const ModelJoint& joint : chain.model().joints) {
            if (!joint.mimic)
                continue;
            rows.push_back(rowOf(joint));
            rows.back().remark =
                ArmText::tr("follows %1")
                    .arg(QString::fromStdString(chain.model().joints[joint.mimic->followed].name));
        }
        core::OutputFile output = core::OutputFile::standardOutput();
        const auto line = [&output](const QString& text) {
            output.write((text.trimmed() + QLatin1Char('\n')).toStdString());
        };
        line(ArmText::tr("%1: %n joint(s) from %2 to %3", nullptr, static_cast<int>(chain.joints()))
                 .arg(QString::fromStdString(chain.model().name), QString::fromStdString(chain.baseLink()),
                      QString::fromStdString(chain.tipLink())));
        constexpr std::array<QString JointRow::*, 6> kColumns{&JointRow::name,   &JointRow::type,
                                                              &JointRow::range,  &JointRow::speed,
                                                              &JointRow::effort, &JointRow::remark};
        std::array<qsizetype, kColumns.size()> widths{};
        for (std::size_t c = 0; c < kColumns.size(); ++c) {
            for (const JointRow& row : rows)
                widths[c] = std::max(widths[c], (row.*kColumns[c]).size());
        }
        for (const JointRow& row : rows) {
            QString text;
            for (std::size_t c = 0; c < kColumns.size(); ++c)
                text += (row.*kColumns[c]).leftJustified(widths[c] + 2);
            line(text);
        }
        if (const std::optional<std::string> missing = chain.linkWithoutMass())
            line(ArmText::tr("The link '%1' has no mass, so the torque of gravity is not known.")
                     .arg(QString::fromStdString(*missing)));
        else
            line(ArmText::tr("%1 kg are moved.").arg(forPeople(chain.movedMass_kg())));
        return output.finish();
    }

    static constexpr double kLongestJog_s = 2.0;

    ArmJogOptions m_jog;
    std::string m_path;
    std::string m_base;
    std::string m_tip;
    bool m_json = false;
};

} // namespace

Command armCommand() {
    return makeCommand<ArmCommand>("arm",
                                   ArmText::tr("Show the description of a robot arm (URDF), or jog an arm"),
                                   "teleta arm show seven-joints\n"
                                   "  teleta arm show four-joints --json");
}

} // namespace teleta::cli
