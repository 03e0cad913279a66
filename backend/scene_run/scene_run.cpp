// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/scene_run.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/scene_run/arm/arm_run.h"
#include "backend/scene_run/array/array_run.h"
#include "backend/scene_run/camera/camera_run.h"
#include "backend/scene_run/gel/gel_run.h"
#include "backend/scene_run/servo/servo_run.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

namespace teleta::scene_run {

namespace {

struct SceneRunText {
    Q_DECLARE_TR_FUNCTIONS(SceneRun)
};

core::Expected<void> makeFolder(const std::string& path) {
    const QString name = QString::fromStdString(path);
    if (QDir().mkpath(name) && QFileInfo(name).isWritable())
        return {};
    return core::failed(core::ErrorKind::ioFailed,
                        SceneRunText::tr("the folder cannot be created or written to"), {}, {path});
}

} // namespace

core::Expected<SceneSummary> runScene(const scene::Scene& scene, const RunOptions& options) {
    if (!options.outFolder.empty())
        TELETA_CHECK(makeFolder(options.outFolder));
    const std::int64_t start_ns = core::steadyNow_ns();
    TELETA_TRY(SceneSummary summary, scene.isCamera()         ? runCameraScene(scene, options)
                                     : scene.isGel()          ? runGelScene(scene, options)
                                     : scene.isServo()        ? runServoScene(scene, options)
                                     : scene.isTeleoperated() ? runTeleoperation(scene, options)
                                     : scene.isArm()          ? runArmScene(scene, options)
                                                              : runArrayScene(scene, options));
    summary.wall_s = core::elapsed_s(start_ns, core::steadyNow_ns());
    summary.scene = options.name;
    summary.seed = options.seed;
    if (!options.outFolder.empty()) {
        TELETA_CHECK(writeJson(options.outFolder + "/summary.json", summary.toJson()));
    }
    return summary;
}

} // namespace teleta::scene_run
