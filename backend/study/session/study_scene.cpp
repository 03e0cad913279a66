// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/study_scene.h"

#include "backend/core/data/toml_table.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <iterator>
#include <set>

namespace teleta::study {

namespace {

using core::NumberRange;
using core::TomlTable;

struct StudySceneText {
    Q_DECLARE_TR_FUNCTIONS(StudyScene)
};

constexpr long long kMostParticipants = 1000;
constexpr double kHighestRate_Hz = 1000.0;

const std::vector<std::string_view>& effectNames() {
    static const std::vector<std::string_view> kNames{"confusion", "lapses",    "reaction_time",
                                                      "motor_lag", "dead_zone", "dropped_frames"};
    return kNames;
}

void readEffect(TomlTable table, StudyScene& scene, std::set<std::size_t>& listed) {
    const std::size_t kind = table.choice("name", effectNames());
    if (!listed.insert(kind).second)
        table.fail("name", StudySceneText::tr("the effect is listed twice").toStdString(),
                   StudySceneText::tr("each effect at most once").toStdString());
    scene.effects.push_back({std::string(effectNames()[kind]), table.text("why")});
    const NumberRange share = NumberRange::between(0.0, 1.0);
    switch (kind) {
    case 0:
        (void)table.choice("matrix", {"paper"});
        scene.confusion = true;
        break;
    case 1:
        scene.lapses = table.number("probability", share);
        break;
    case 2:
        scene.reactionTime = {table.number("median_s", NumberRange::positive()),
                              table.number("log_spread", NumberRange::notNegative())};
        break;
    case 3:
        scene.motorLag = {table.number("rise_s", NumberRange::positive()),
                          table.number("fall_s", NumberRange::positive())};
        break;
    case 4:
        scene.deadZone = table.number("start_share", share);
        break;
    default:
        scene.droppedFrames = table.number("share", share);
    }
    table.finish();
}

} // namespace

bool isStudyScene(std::string_view text) {
    const core::Expected<core::TomlDocument> document = core::TomlDocument::parse(text, {});
    return document && document->root().has("study");
}

core::Expected<StudyScene> parseStudyScene(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    TomlTable root = document.root();
    StudyScene scene;
    scene.name = root.text("name");
    scene.description = root.text("description");
    scene.duration_s = root.number("duration_s", NumberRange::positive());
    scene.frameRate_Hz = root.number("rate_Hz", {.low = 0.0, .high = kHighestRate_Hz, .lowOpen = true});
    TomlTable study = root.table("study");
    const std::vector<TomlTable> effects = root.tables("effects", 0);
    root.finish();
    const std::string protocol = study.text("protocol");
    scene.participants = static_cast<std::size_t>(study.integer("participants", 1, kMostParticipants));
    study.finish();
    std::set<std::size_t> listed;
    for (const TomlTable& table : effects)
        readEffect(table, scene, listed);
    if (document.firstError())
        return core::Unexpected(document.firstError());
    TELETA_TRY(Protocol read, protocol == "paper"
                                  ? paperProtocol()
                                  : readProtocol(QFileInfo(QString::fromStdString(file))
                                                     .dir()
                                                     .filePath(QString::fromStdString(protocol))
                                                     .toStdString()));
    scene.protocol = std::move(read);
    return scene;
}

StudyScene StudyScene::without(const std::string& effect) const {
    StudyScene others = *this;
    std::erase_if(others.effects, [&](const Effect& listed) { return listed.name == effect; });
    const std::vector<std::string_view>& names = effectNames();
    switch (std::distance(names.begin(), std::ranges::find(names, effect))) {
    case 0:
        others.confusion = false;
        break;
    case 1:
        others.lapses.reset();
        break;
    case 2:
        others.reactionTime.reset();
        break;
    case 3:
        others.motorLag.reset();
        break;
    case 4:
        others.deadZone.reset();
        break;
    case 5:
        others.droppedFrames.reset();
        break;
    default:
        break;
    }
    return others;
}

SimulatedParticipant StudyScene::participantFor(const StudyTask& task, const std::string& condition) const {
    SimulatedParticipant participant{std::nullopt, lapses.value_or(0.0), protocol.stimulus_s, 0.0};
    if (confusion)
        participant.matrix = knownMatrix(task, condition);
    if (reactionTime) {
        participant.medianResponse_s = reactionTime->median_s;
        participant.logSpread = reactionTime->logSpread;
    }
    return participant;
}

} // namespace teleta::study
