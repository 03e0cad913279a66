// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/failure.h"
#include "backend/cost/ladders/ladders.h"
#include "backend/cost/limit_rung.h"
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace teleta::cost {

namespace {

constexpr std::size_t kFramesPerPart = 100;
constexpr std::size_t kParts = 40;
constexpr std::uint64_t kSceneSeed = 1;

/// The scene whose effects are left out; it comes with the programs.
core::Expected<scene::Scene> indenterScene() {
    const QString path = QStringLiteral(":/scenes/tactile-indenter.toml");
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::notFound, file.errorString(), {}, {path.toStdString()});
    return scene::parseScene(file.readAll().toStdString(), path.toStdString());
}

/// Frames of the scene, part by part.
using SceneFrames = std::vector<std::vector<float>>;

/// The array of a scene at the beginning of a part. It only goes forwards, so a part that is asked for again
/// is reached from the start.
class SceneArray {
public:
    explicit SceneArray(std::unique_ptr<simulation::SimulatedArray> array)
        : m_array(std::move(array)) {}

    /// The array before the first frame of the part; the caller takes the part's frames.
    simulation::SimulatedArray& at(std::size_t part) {
        if (m_part != part) {
            m_array->restart();
            std::vector<float> frame(m_array->description().layout.taxels());
            for (std::size_t i = 0; i < part * kFramesPerPart; ++i)
                m_array->next(frame, false);
        }
        m_part = part + 1;
        return *m_array;
    }

private:
    std::unique_ptr<simulation::SimulatedArray> m_array;
    std::size_t m_part = 0; ///< the next
};

core::Expected<Rung> effectRung(const std::string& name, const std::string& parameter,
                                const scene::Scene& scene, const std::shared_ptr<const SceneFrames>& truth) {
    TELETA_TRY(auto made, simulation::SimulatedArray::make(scene, kSceneSeed));
    const auto array = std::make_shared<SceneArray>(std::move(made));
    const auto run = [=](Trial& trial) {
        const std::size_t part = trial.index() % kParts;
        simulation::SimulatedArray& taxels = array->at(part);
        std::vector<std::vector<float>> frames(kFramesPerPart, std::vector<float>(scene.taxels().taxels()));
        trial.timed(kFramesPerPart, [&] {
            for (std::vector<float>& frame : frames)
                taxels.next(frame, false);
        });
        for (std::size_t i = 0; i < kFramesPerPart; ++i) {
            const std::vector<float>& with = (*truth)[part * kFramesPerPart + i];
            double squares = 0.0;
            for (std::size_t taxel = 0; taxel < with.size(); ++taxel) {
                const double difference =
                    static_cast<double>(frames[i][taxel]) - static_cast<double>(with[taxel]);
                squares += difference * difference;
            }
            trial.error(std::sqrt(squares / static_cast<double>(with.size())));
        }
    };
    return Rung{name, parameter, run};
}

} // namespace

Ladder sceneEffectsLadder() {
    Ladder ladder;
    ladder.name = "scene-effects";
    ladder.topic = Topic::simulation;
    ladder.title =
        LadderText::tr("A frame of a simulated array without one of the sensor's effects").toStdString();
    ladder.truth =
        LadderText::tr("difference of a taxel from the scene with all effects, root mean square of a frame")
            .toStdString();
    ladder.errorUnit = "N";
    ladder.trials = kParts;
    ladder.makeRungs = []() -> core::Expected<std::vector<Rung>> {
        TELETA_TRY(const scene::Scene scene, indenterScene());
        TELETA_TRY(auto all, simulation::SimulatedArray::make(scene, kSceneSeed));
        auto truth = std::make_shared<SceneFrames>(kParts * kFramesPerPart,
                                                   std::vector<float>(scene.taxels().taxels()));
        for (std::vector<float>& frame : *truth)
            all->next(frame, false);
        std::vector<Rung> rungs;
        const auto add = [&](const std::string& name, const std::string& parameter,
                             const scene::Scene& variant) -> core::Expected<void> {
            TELETA_TRY(Rung rung, effectRung(name, parameter, variant, truth));
            rungs.push_back(std::move(rung));
            return {};
        };
        TELETA_CHECK(add("all", "all effects", scene));
        for (std::size_t i = 0; i < scene.effects.size(); ++i) {
            scene::Scene variant = scene;
            variant.effects.erase(variant.effects.begin() + static_cast<std::ptrdiff_t>(i));
            const std::string name(scene::nameOf(scene.effects[i]));
            TELETA_CHECK(add("without-" + name, "no " + name, variant));
        }
        scene::Scene bare = scene;
        bare.effects.clear();
        TELETA_CHECK(add("none", "no effects", bare));
        const auto copy = std::make_shared<std::vector<float>>(scene.taxels().taxels());
        rungs.push_back(limitRung("each taxel written once", kFramesPerPart, [=](std::size_t index) {
            std::ranges::copy((*truth)[index % truth->size()], copy->begin());
            return static_cast<double>(copy->back());
        }));
        return rungs;
    };
    return ladder;
}

} // namespace teleta::cost
