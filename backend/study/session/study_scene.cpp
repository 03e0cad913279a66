// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/session/study_scene.h"

#include "backend/core/keys/toml_keys.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <array>

namespace teleta::study {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;

struct StudySceneText {
    Q_DECLARE_TR_FUNCTIONS(StudyScene)
};

constexpr long long kMostParticipants = 1000;
constexpr double kHighestRate_Hz = 1000.0;

/// What simulated participants and their bracelet can have: name, what it stands for, its keys, and how to do
/// without.
struct EffectRow {
    std::string_view name;
    std::string_view why;
    void (*describe)(Keys& keys, StudyScene& scene);
    void (*leaveOut)(StudyScene& scene);
};

void describeShare(Keys& keys, std::string_view key, std::optional<double>& share, std::string_view about) {
    keys.number(key, share.emplace(0.0), NumberRange::between(0.0, 1.0), about);
}

constexpr std::array kEffects{
    EffectRow{"confusion", "Participants confuse patterns",
              [](Keys& keys, StudyScene& scene) {
                  keys.word("matrix", "paper", "As the participants of the paper did");
                  scene.confusion = true;
              },
              [](StudyScene& scene) { scene.confusion = false; }},
    EffectRow{"lapses", "Participants do not always answer",
              [](Keys& keys, StudyScene& scene) {
                  describeShare(keys, "probability", scene.lapses, "Probability of no answer");
              },
              [](StudyScene& scene) { scene.lapses.reset(); }},
    EffectRow{"reaction_time", "Answers take time",
              [](Keys& keys, StudyScene& scene) {
                  StudyScene::ReactionTime& time = scene.reactionTime.emplace();
                  keys.number("median_s", time.median_s, NumberRange::positive(), "Median time of an answer");
                  keys.number("log_spread", time.logSpread, NumberRange::notNegative(),
                              "Standard deviation of its logarithm");
              },
              [](StudyScene& scene) { scene.reactionTime.reset(); }},
    EffectRow{"motor_lag", "Motors take time to speed up and to slow down",
              [](Keys& keys, StudyScene& scene) {
                  StudyScene::MotorLag& lag = scene.motorLag.emplace();
                  keys.number("rise_s", lag.rise_s, NumberRange::positive(), "From rest to 90 % of a speed");
                  keys.number("fall_s", lag.fall_s, NumberRange::positive(), "From a speed to 10 % of it");
              },
              [](StudyScene& scene) { scene.motorLag.reset(); }},
    EffectRow{"dead_zone", "A motor stands at a weak drive",
              [](Keys& keys, StudyScene& scene) {
                  describeShare(keys, "start_share", scene.deadZone,
                                "Share of the full drive at which a motor starts");
              },
              [](StudyScene& scene) { scene.deadZone.reset(); }},
    EffectRow{"dropped_frames", "Not all commands reach the bracelet",
              [](Keys& keys, StudyScene& scene) {
                  describeShare(keys, "share", scene.droppedFrames, "Share of the frames that are lost");
              },
              [](StudyScene& scene) { scene.droppedFrames.reset(); }},
};

void describeEffect(Keys& keys, StudyScene& scene, std::size_t i) {
    core::KeyNames names;
    for (const EffectRow& row : kEffects)
        names.push_back({row.name, row.why});
    keys.choose("name", 0, names, "Which effect", Need::required,
                [&scene, i](Keys& same, std::size_t chosen) {
                    StudyScene::Effect& effect = scene.effects[i];
                    effect.name = kEffects[chosen].name;
                    const auto before = scene.effects.begin() + static_cast<std::ptrdiff_t>(i);
                    if (std::find_if(scene.effects.begin(), before, [&](const StudyScene::Effect& other) {
                            return other.name == effect.name;
                        }) != before)
                        same.refuse("name", StudySceneText::tr("the effect is listed twice").toStdString(),
                                    StudySceneText::tr("each effect at most once").toStdString());
                    same.text("why", effect.why, "What the scene would lose without the effect");
                    kEffects[chosen].describe(same, scene);
                });
}

} // namespace

void StudyScene::describeKeys(Keys& keys) {
    keys.text("name", name, "Name of the scene");
    keys.text("description", description, "What happens in it");
    keys.number("duration_s", duration_s, NumberRange::positive(),
                "Longest simulated time; the rehearsal ends when all sessions are done");
    keys.number("rate_Hz", frameRate_Hz, NumberRange::positiveUpTo(kHighestRate_Hz),
                "Frames of the bracelet a second");
    keys.table("study", "The study that is rehearsed", Need::required, [this](Keys& table) {
        table.text("protocol", protocolPath, "Protocol file, relative to the scene; `paper` for the paper's");
        table.whole("participants", participants, {1, kMostParticipants}, "Simulated participants");
    });
    keys.tables(
        "effects", effects, 0, "Imperfections; what is not listed is not simulated",
        [this](Keys& table, std::vector<Effect>&, std::size_t i) { describeEffect(table, *this, i); });
}

bool isStudyScene(std::string_view text) {
    const core::Expected<core::TomlDocument> document = core::TomlDocument::parse(text, {});
    return document && document->root().has("study");
}

core::Expected<StudyScene> parseStudyScene(std::string_view text, const std::string& file) {
    TELETA_TRY(StudyScene scene, core::TomlDocument::parse(text, file).and_then(core::readKeys<StudyScene>));
    TELETA_TRY(scene.protocol, scene.protocolPath == "paper"
                                   ? paperProtocol()
                                   : readProtocol(QFileInfo(QString::fromStdString(file))
                                                      .dir()
                                                      .filePath(QString::fromStdString(scene.protocolPath))
                                                      .toStdString()));
    return scene;
}

StudyScene StudyScene::without(const std::string& effect) const {
    StudyScene others = *this;
    std::erase_if(others.effects, [&](const Effect& listed) { return listed.name == effect; });
    const auto row = std::ranges::find(kEffects, effect, &EffectRow::name);
    if (row != kEffects.end())
        row->leaveOut(others);
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
