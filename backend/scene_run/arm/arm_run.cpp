// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/arm/arm_run.h"

#include "backend/pipeline/touch/contour_explorer.h"
#include "backend/pipeline/touch/touch_estimator.h"
#include "backend/scene_run/arm/arm_evaluation.h"
#include "backend/scene_run/arm/arm_logs.h"
#include "backend/simulation/arm/simulated_arm.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace teleta::scene_run {

namespace {

using nlohmann::ordered_json;

void reportStiffness(const std::vector<ComparedTouch>& touches, ordered_json& measures) {
    std::vector<ordered_json> estimated;
    std::vector<ordered_json> truth;
    std::vector<ordered_json> material;
    for (const ComparedTouch& touch : touches) {
        const auto& stiffness = touch.record.stiffness;
        estimated.push_back(stiffness ? orNull(stiffness->object.value_NPerM) : nullptr);
        truth.push_back(jsonNumber(touch.trueStiffness_NPerM));
        material.push_back(stiffness && stiffness->materialKnown()
                               ? ordered_json(stiffness::toString(stiffness->material))
                               : nullptr);
    }
    if (touches.empty())
        return;
    measures["estimated_stiffness_n_per_m"] = oneOrList(estimated);
    measures["true_stiffness_n_per_m"] = oneOrList(truth);
    measures["material"] = oneOrList(material);
    reportStiffnessCovered(touches, measures);
}

void reportContour(const pipeline::ExploredContour& contour, const simulation::SimulatedArm& arm,
                   ordered_json& measures) {
    measures["shape"] =
        contour.recognition ? ordered_json(contour::toString(contour.recognition->shape)) : nullptr;
    measures["true_shape"] = trueShape(arm.objects().front().shape);
    std::vector<double> squares_m2;
    for (const contour::Point& point : contour.curve_m)
        squares_m2.push_back(std::pow(arm.outlineDistance_m(0, point), 2));
    measures["contour_rms_m"] = jsonNumber(std::sqrt(mean(squares_m2)));
}

core::Expected<void> writeContour(const std::string& outFolder, const std::vector<contour::Point>& points_m) {
    TELETA_TRY(RunCsv csv, RunCsv::open(outFolder, "contour.csv", "x_m,y_m"));
    for (const contour::Point& point : points_m)
        csv.row(point);
    return csv.finish();
}

} // namespace

core::Expected<SceneSummary> runArmScene(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(auto made, simulation::SimulatedArm::make(scene, options.seed));
    simulation::SimulatedArm& arm = *made;
    const core::ArmDescription description = arm.description();
    TELETA_TRY(ArmLogs logs, ArmLogs::open(options, scene, arm));

    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto samples = static_cast<std::uint64_t>(std::llround(duration_s * description.nominalRate_Hz));
    pipeline::TouchEstimator estimator(description);
    pipeline::ContourExplorer explorer;
    SkinReader reader(scene);
    SceneSummary summary;
    std::vector<ComparedTouch> touches;
    const auto take = [&](const std::optional<pipeline::TouchRecord>& record) {
        if (!record)
            return;
        logs.addTouch(*record);
        touches.push_back(compared(*record, arm));
        summary.events.push_back(touchEvent(touches.back()));
        if (record->located)
            explorer.add(record->p_Base_Contact_m);
    };

    core::JointSample sample;
    std::vector<float> values(arm.skinDescription().layout.taxels());
    for (std::uint64_t i = 0; i < samples && !logs.failed(); ++i) {
        summary.interrupted = options.endsAt(i, kSamplesBetweenReports, arm.time_s(), duration_s);
        if (summary.interrupted)
            break;
        arm.next({.drive = core::ArmDrive::program}, sample);
        sample.time_ns = std::llround(sample.sourceTime_s * 1e9);
        logs.add(sample);
        take(estimator.update(sample));
        if (!arm.skinFrame(values))
            continue;
        logs.addFrame(sample.sourceTime_s, values);
        take(estimator.update(reader.read(values, sample)));
    }
    TELETA_CHECK(logs.finish());
    TELETA_CHECK(writeTouches(options.outFolder, touches));
    TELETA_CHECK(writeContour(options.outFolder, explorer.contour().points_m));

    summary.takeTimes(arm);
    if (std::holds_alternative<scene::TouchProgram>(scene.arm().program))
        reportStiffness(touches, summary.measures);
    if (std::holds_alternative<scene::ContourProgram>(scene.arm().program))
        reportContour(explorer.contour(), arm, summary.measures);
    reportContacts(touches, summary.measures);
    summary.measures["frames"] = logs.frames();
    summary.measures["frames_lost"] = 0;
    return summary;
}

} // namespace teleta::scene_run
