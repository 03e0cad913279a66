// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/core/keys/toml_edit.h"
#include "backend/scene/scene_reader.h"
#include "backend/scene_run/base/flat_measures.h"
#include "backend/scene_run/scene_run.h"
#include "backend/scene_run/study/study_run.h"
#include "backend/study/session/study_scene.h"
#include "backend/sweep/subjects.h"

#include <QFileInfo>
#include <QString>

#include <nlohmann/json.hpp>

#include <limits>
#include <variant>

namespace teleta::sweep {

namespace {

using SweptScene = std::variant<scene::Scene, study::StudyScene>;

/// The text of the scene, and the name of its file.
struct SceneText {
    std::string text;
    std::string file;
};

core::Expected<SweptScene> sceneOf(const SceneText& base, const CellSettings& settings) {
    CellSettings named;
    for (const auto& [key, value] : settings) {
        // A file has [[effects]]; one of them is an effect, and one that the scene does not list needs a
        // reason.
        std::string path = key.starts_with("effect.") ? "effects." + key.substr(7) : key;
        if (path.starts_with("effects."))
            named.emplace_back(path.substr(0, path.rfind('.')) + ".why",
                               std::string("It is varied by a sweep."));
        named.emplace_back(std::move(path), value);
    }
    TELETA_TRY(const std::string text, core::withTomlValues(base.text, base.file, named));
    if (study::isStudyScene(text)) {
        TELETA_TRY(study::StudyScene scene, study::parseStudyScene(text, base.file));
        return SweptScene(std::move(scene));
    }
    TELETA_TRY(scene::Scene scene, scene::parseScene(text, base.file));
    TELETA_CHECK(scene::checkScene(scene));
    return SweptScene(std::move(scene));
}

class SceneWorker : public SweepWorker {
public:
    explicit SceneWorker(SceneText base)
        : m_base(std::move(base)) {}

    core::Expected<RunMeasures>
    run(const SweepPlan& plan, std::uint64_t cell, std::uint64_t seed,
        const std::function<void(const scene_run::LabelledFrame&)>& onFrame) override {
        TELETA_CHECK(goTo(plan, cell));
        scene_run::RunOptions options;
        options.name = plan.subject;
        options.seed = seed;
        options.onFrame = onFrame;
        const auto* study = std::get_if<study::StudyScene>(m_scene.get());
        TELETA_TRY(const scene_run::SceneSummary summary,
                   study != nullptr ? scene_run::runStudyScene(*study, options)
                                    : scene_run::runScene(std::get<scene::Scene>(*m_scene), options));
        RunMeasures measures;
        for (const auto& [name, value] : summary.measures.items()) {
            if (value.is_null())
                measures.emplace_back(name, std::numeric_limits<double>::quiet_NaN());
            const nlohmann::ordered_json one{{name, value}};
            for (auto& number : scene_run::flatMeasures(one).numbers)
                measures.push_back(std::move(number));
        }
        if (summary.verdict)
            measures.emplace_back("completed", summary.verdict->completed ? 1.0 : 0.0);
        return measures;
    }

    std::optional<core::ArrayLayout> layoutOf(const SweepPlan& plan, std::uint64_t cell) override {
        if (!goTo(plan, cell))
            return std::nullopt;
        const auto* world = std::get_if<scene::Scene>(m_scene.get());
        return world != nullptr ? std::optional(world->taxels()) : std::nullopt;
    }

private:
    core::Expected<void> goTo(const SweepPlan& plan, std::uint64_t cell) {
        if (m_scene && cell == m_cell)
            return {};
        m_scene.reset();
        TELETA_TRY(SweptScene scene, sceneOf(m_base, plan.settingsOf(cell)));
        m_scene = std::make_unique<SweptScene>(std::move(scene));
        m_cell = cell;
        return {};
    }

    SceneText m_base;
    std::unique_ptr<const SweptScene> m_scene; ///< of the cell
    std::uint64_t m_cell = 0;
};

class SceneSubject : public SweepSubject {
public:
    SceneSubject(SceneText base, bool frames)
        : m_base(std::move(base))
        , m_frames(frames) {}

    [[nodiscard]] std::unique_ptr<SweepWorker> makeWorker() const override {
        return std::make_unique<SceneWorker>(m_base);
    }
    [[nodiscard]] std::string source() const override { return m_base.text; }
    [[nodiscard]] bool hasFrames() const override { return m_frames; }

private:
    SceneText m_base;
    bool m_frames;
};

} // namespace

core::Expected<std::unique_ptr<SweepSubject>> makeSceneSubject(const SweepPlan& plan,
                                                               const SubjectSources& sources) {
    SceneText base{{}, pathBeside(plan, plan.subject)};
    if (!QFileInfo::exists(QString::fromStdString(base.file)))
        base.file = plan.subject;
    TELETA_TRY(base.text, sources.sceneText(base.file));
    TELETA_TRY(const SweptScene plain, sceneOf(base, {}));
    TELETA_CHECK(checkCells(plan, sources.checked, [&](std::uint64_t cell) -> core::Expected<void> {
        return sceneOf(base, plan.settingsOf(cell)).map([](const SweptScene&) {});
    }));
    const auto* world = std::get_if<scene::Scene>(&plain);
    const bool frames = world != nullptr && !world->isArm() && !world->isSeen();
    return std::make_unique<SceneSubject>(std::move(base), frames);
}

} // namespace teleta::sweep
