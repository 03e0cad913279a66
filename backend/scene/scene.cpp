// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene.h"

#include "backend/core/failure.h"
#include "backend/core/keys/key_check.h"

#include <QCoreApplication>
#include <QString>

#include <span>

namespace teleta::scene {

namespace {

struct SceneCheck {
    Q_DECLARE_TR_FUNCTIONS(Scene)
};

constexpr double kHighestRate_Hz = 100'000.0;

void describeRate(Keys& keys, double& rate_Hz) {
    keys.number("rate_Hz", rate_Hz, NumberRange::positiveUpTo(kHighestRate_Hz),
                "Frames of the array or the camera, samples of the arm or cycles of the servo a second");
}

core::Expected<void> checkKind(const Scene& scene, bool fits, const QString& otherwise) {
    if (!fits)
        return core::failed(core::ErrorKind::badInput, otherwise);
    return checkScene(scene);
}

} // namespace

void Scene::describeHead(Keys& keys) {
    keys.text("name", name, "Name of the scene");
    keys.text("description", description, "What happens in it");
    keys.number("duration_s", duration_s, NumberRange::positive(), "How long a run takes, in simulated time");
    describeRate(keys, rate_Hz);
}

void Scene::describeWorld(Keys& keys) {
    std::visit([&keys](auto& known) { known.describeKeys(keys); }, world);
}

void Scene::describeEffects(Keys& keys) {
    keys.tables("effects", effects, 0, "Imperfections; what is not listed is not simulated",
                [this](Keys& table, std::vector<Effect>& all, std::size_t i) {
                    describeEffect(table, all[i], canHave(), taxels(), std::span(all).first(i));
                });
}

std::vector<ActsOn> Scene::canHave() const {
    if (isCamera())
        return {ActsOn::camera};
    if (isGel())
        return {};
    if (isServo())
        return {ActsOn::taxels, ActsOn::carriedArray};
    if (isTeleoperated())
        return {ActsOn::taxels, ActsOn::joints, ActsOn::armObjects, ActsOn::link};
    if (isArm())
        return {ActsOn::taxels, ActsOn::joints, ActsOn::armObjects};
    return {ActsOn::taxels};
}

core::Expected<void> checkScene(const Scene& scene) {
    Scene copy = scene;
    core::KeyCheck check;
    describeRate(check, copy.rate_Hz);
    copy.describeWorld(check);
    copy.describeEffects(check);
    if (check.firstError())
        return core::Unexpected(*check.firstError());
    return {};
}

core::Expected<void> checkArrayScene(const Scene& scene) {
    return checkKind(scene, std::holds_alternative<ArrayWorld>(scene.world),
                     SceneCheck::tr("the scene is not that of a tactile array"));
}

core::Expected<void> checkArmScene(const Scene& scene) {
    return checkKind(scene, scene.isArm(), SceneCheck::tr("the scene is not that of an arm"));
}

core::Expected<void> checkTeleoperatedScene(const Scene& scene) {
    return checkKind(scene, scene.isTeleoperated(),
                     SceneCheck::tr("the scene is not that of an arm with an operator"));
}

core::Expected<void> checkCameraScene(const Scene& scene) {
    return checkKind(scene, scene.isCamera(),
                     SceneCheck::tr("the scene is not that of a camera in a soft tube"));
}

core::Expected<void> checkGelScene(const Scene& scene) {
    return checkKind(scene, scene.isGel(), SceneCheck::tr("the scene is not that of a flat gel"));
}

core::Expected<void> checkServoScene(const Scene& scene) {
    return checkKind(scene, scene.isServo(), SceneCheck::tr("the scene is not that of a servoing arm"));
}

} // namespace teleta::scene
