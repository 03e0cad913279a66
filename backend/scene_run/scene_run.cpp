// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/scene_run.h"

#include "backend/core/steady_time.h"
#include "backend/scene_run/arm/arm_run.h"
#include "backend/scene_run/arm/teleoperation_run.h"
#include "backend/scene_run/array/array_run.h"
#include "backend/scene_run/camera/camera_run.h"
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
    core::Error error;
    error.kind = core::ErrorKind::ioFailed;
    error.message = SceneRunText::tr("the folder cannot be created or written to").toStdString();
    error.where.file = path;
    return core::Unexpected(error);
}

} // namespace

core::Expected<SceneSummary> runScene(const scene::Scene& scene, const RunOptions& options) {
    if (!options.outFolder.empty()) {
        TELETA_CHECK(makeFolder(options.outFolder));
    }
    const std::int64_t start_ns = core::steadyNow_ns();
    core::Expected<SceneSummary> summary = scene.isCamera()         ? runCameraScene(scene, options)
                                           : scene.isServo()        ? runServoScene(scene, options)
                                           : scene.isTeleoperated() ? runTeleoperation(scene, options)
                                           : scene.isArm()          ? runArmScene(scene, options)
                                                                    : runArrayScene(scene, options);
    if (!summary)
        return summary;
    summary->wall_s = static_cast<double>(core::steadyNow_ns() - start_ns) * 1e-9;
    summary->scene = options.name;
    summary->seed = options.seed;
    if (!options.outFolder.empty()) {
        const core::Expected<void> written =
            writeJson(options.outFolder + "/summary.json", summary->toJson());
        TELETA_CHECK(written);
    }
    return summary;
}

} // namespace teleta::scene_run
