// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/motors/motor_file.h"
#include "backend/motors/motor_fit.h"
#include "backend/motors/motor_recording.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/scene/scene_reader.h"
#include "backend/vision/calibration/camera_calibration.h"
#include "backend/vision/calibration/camera_file.h"
#include "tests/fuzz/memory_file.h"
#include "tests/support/floating_point_traps.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace teleta::fuzz {

namespace {

void requireLocates(const vision::CylinderCamera& camera) {
    const vision::CameraParameters& image = camera.camera().parameters();
    for (const double share : {0.0, 0.1, 0.5, 0.75, 1.0}) {
        const Eigen::Vector2d pixel(share * image.width_px, (1.0 - share * share) * image.height_px);
        const auto point_m = camera.locate_m(pixel);
        if (!point_m)
            continue;
        require(point_m->allFinite(), "a located point is finite");
        const auto deviation_m = camera.standardDeviation_m(*point_m);
        require(!deviation_m || *deviation_m >= 0.0, "a standard deviation is none below 0");
    }
}

} // namespace

bool scene(Bytes bytes) {
    const core::Expected<scene::Scene> read = scene::parseScene(textOf(bytes), kInput);
    if (!read)
        requireExplained(read.error());
    return read.has_value();
}

bool cameraJson(Bytes bytes) {
    const core::Expected<vision::CameraFile> file = vision::parseCamera(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    const std::string text = vision::cameraJson(*file).dump();
    const core::Expected<vision::CameraFile> again = vision::parseCamera(text, kInput);
    require(again.has_value(), again ? "" : describe(again.error()));
    require(vision::cameraJson(*again).dump() == text, "a camera comes back as it was written");
    const test::FloatingPointTraps traps;
    requireLocates(file->camera);
    return true;
}

bool cameraPairs(Bytes bytes) {
    const MemoryFile file(bytes);
    const core::Expected<std::vector<vision::CalibrationPair>> pairs = vision::readPairs(file.path());
    if (!pairs) {
        requireExplained(pairs.error(), file.path());
        return false;
    }
    constexpr std::size_t kMostPairs = 64;
    if (pairs->size() > kMostPairs)
        return true;
    const test::FloatingPointTraps traps;
    for (const vision::CalibrationMethod method :
         {vision::CalibrationMethod::dlt, vision::CalibrationMethod::paper}) {
        const auto calibration = vision::calibrate(*pairs, {}, method);
        if (!calibration)
            continue;
        require(calibration->residuals.size() == pairs->size(), "every pair has a residual");
        require(std::isfinite(calibration->rms_px), "a calibration has a residual");
        requireLocates(calibration->camera);
    }
    return true;
}

bool urdf(Bytes bytes) {
    core::Expected<arm_model::ArmModel> read = arm_model::parseUrdf(textOf(bytes), kInput);
    if (!read) {
        requireExplained(read.error());
        return false;
    }
    const auto model = std::make_shared<const arm_model::ArmModel>(*std::move(read));
    require(model->joints.size() + 1 == model->links.size(), "each joint carries a link");
    for (std::size_t i = 0; i < model->joints.size(); ++i) {
        const arm_model::ModelJoint& joint = model->joints[i];
        require(joint.parentLink <= i, "parents stand before their children");
        require(joint.lowest <= joint.highest, "a range is not empty");
        require(std::abs(joint.axis.norm() - 1.0) < 1e-12, "an axis has length 1");
        require(!joint.mimic || !model->joints[joint.mimic->followed].mimic, "a mimic follows what moves");
    }
    const test::FloatingPointTraps traps;
    for (const std::size_t tip : model->leaves()) {
        const auto chain =
            arm_model::SerialChain::create(model, model->links.front().name, model->links[tip].name);
        if (!chain)
            continue;
        core::JointVector q = core::JointVector::zeros(chain->joints());
        for (std::size_t i = 0; i < q.size(); ++i)
            q[i] = std::clamp(0.3, chain->joint(i).lowest, chain->joint(i).highest);
        require(chain->X_Base_Tip(q).matrix().allFinite(), "a pose is finite");
        require(chain->jacobian(q).allFinite(), "a derivative is finite");
        if (const auto torque = chain->gravityTorque(q))
            require(std::ranges::all_of(*torque, [](double value) { return std::isfinite(value); }),
                    "a torque is finite");
    }
    return true;
}

bool motorProfile(Bytes bytes) {
    const core::Expected<motors::MotorCalibration> motors = motors::parseMotors(textOf(bytes), kInput);
    if (!motors) {
        requireExplained(motors.error());
        return false;
    }
    for (const pattern::MotorProfile& profile : motors->profiles())
        require(profile.valid(), "a profile that is read is valid");
    const core::Expected<motors::MotorCalibration> again =
        motors::parseMotors(motors::motorsText(*motors), kInput);
    require(again && *again == *motors, "a profile comes back as it was written");
    const test::FloatingPointTraps traps;
    const pattern::Pattern& shape = pattern::builtInPatterns().front();
    pattern::forEachPredictedSample(
        shape, motors->profiles(), 50.0,
        [](double, const core::Intensities& intensities, const core::Intensities& speeds_Hz) {
            for (std::size_t i = 0; i < intensities.size(); ++i)
                require(intensities[i] >= 0.0 && intensities[i] <= 1.0 && std::isfinite(speeds_Hz[i]),
                        "predictions are 0..1");
            return true;
        });
    return true;
}

bool motorRecording(Bytes bytes) {
    const MemoryFile file(bytes);
    const test::FloatingPointTraps traps;
    const core::Expected<motors::MotorRecording> recording = motors::readMotorRecording(file.path());
    if (!recording) {
        requireExplained(recording.error(), file.path());
        return false;
    }
    const core::Expected<motors::MotorFit> fit = motors::fitMotor(*recording);
    require(!fit || fit->profile.valid(), "a fitted profile is valid");
    return true;
}

} // namespace teleta::fuzz
