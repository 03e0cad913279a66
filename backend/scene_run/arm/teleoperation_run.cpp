// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pipeline/touch/found_objects.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/pipeline/touch/touch_estimator.h"
#include "backend/playback/pattern_program.h"
#include "backend/scene_run/arm/arm_evaluation.h"
#include "backend/scene_run/arm/arm_logs.h"
#include "backend/scene_run/arm/arm_run.h"
#include "backend/scene_run/arm/simulated_player.h"
#include "backend/simulation/arm/teleoperated_arm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace teleta::scene_run {

namespace {

using nlohmann::ordered_json;

/// The operator's side of the link.
class OperatorSide {
public:
    OperatorSide(const scene::Scene& scene, const simulation::TeleoperatedArm& arm, SimulatedPlayer& player,
                 ArmLogs& logs, SceneSummary& summary)
        : m_arm(arm)
        , m_player(player)
        , m_logs(logs)
        , m_summary(summary)
        , m_estimator(arm.description())
        , m_reader(scene)
        , m_feedback([this](playback::Program program) {
            m_player.play(std::move(program));
            return true;
        }) {
        m_feedback.setMap(pattern::PatternMap::defaults(), [](const std::string& id) {
            const pattern::Pattern* pattern = pattern::findBuiltIn(id);
            return pattern != nullptr ? playback::programOf(*pattern) : playback::Program{};
        });
    }

    /// In the order in which ArmChannel takes them: a sample, then the frame that was read with it.
    void take(const core::ArmArrival& arrival, double now_s) {
        m_heardAt_s = now_s;
        take(m_estimator.update(arrival.sample));
        if (arrival.hasFrame)
            take(m_estimator.update(m_reader.read(arrival.frame, arrival.sample)));
    }

    /// After all that has arrived by now.
    void playUntil(double now_s) {
        const bool silent = now_s - m_heardAt_s > SimulatedPlayer::kTimeout_s;
        if (silent != m_silent)
            m_summary.events.push_back({{"time_s", now_s}, {"event", silent ? "link_lost" : "link_back"}});
        m_silent = silent;
        m_player.advance(now_s, m_heardAt_s);
        if (m_waiting && m_player.onset_s()) {
            m_latencies_s.push_back(*m_player.onset_s() - *m_waiting);
            m_waiting.reset();
        }
    }

    void report();
    [[nodiscard]] const std::vector<ComparedTouch>& touches() const { return m_touches; }
    [[nodiscard]] core::Expected<void> writeObjects(const std::string& outFolder) const;

private:
    void take(const std::optional<pipeline::TouchRecord>& record) {
        if (!record)
            return;
        m_logs.addTouch(*record);
        m_touches.push_back(compared(*record, m_arm.arm()));
        ordered_json event = touchEvent(m_touches.back());
        m_feedback.onTouch(*record);
        if (const pipeline::FoundObject* object = m_found.add(*record)) {
            event["found_object"] = object->number;
            ++m_named[object->number][m_touches.back().object];
            m_feedback.onContour(*record, m_found.contour());
        }
        m_summary.events.push_back(std::move(event));
        pipeline::FeedbackSent sent;
        while (m_feedback.popSent(sent)) {
            if (sent.patternId.empty() || sent.missing)
                continue;
            ++m_patternsSent;
            m_waiting = record->ready_s;
            m_summary.events.push_back({{"time_s", m_arm.time_s()},
                                        {"event", "pattern"},
                                        {"touch", sent.touch},
                                        {"pattern", sent.patternId}});
        }
    }

    /// The true object that most of its touches were of; null: none.
    [[nodiscard]] const simulation::ArmObjectTruth* truthOf(const pipeline::FoundObject& object) const {
        const auto named = m_named.find(object.number);
        if (named == m_named.end())
            return nullptr;
        const auto most =
            std::ranges::max_element(named->second, {}, [](const auto& entry) { return entry.second; });
        const auto& objects = m_arm.arm().objects();
        const auto truth = std::ranges::find(objects, most->first, &simulation::ArmObjectTruth::name);
        return truth == objects.end() ? nullptr : &*truth;
    }

    /// The found object with the most touches of a true one; null: it was not found.
    [[nodiscard]] const pipeline::FoundObject* foundAs(const simulation::ArmObjectTruth& truth) const {
        const pipeline::FoundObject* most = nullptr;
        for (const pipeline::FoundObject& object : m_found.objects())
            if (truthOf(object) == &truth && (most == nullptr || object.touches > most->touches))
                most = &object;
        return most;
    }

    const simulation::TeleoperatedArm& m_arm;
    SimulatedPlayer& m_player;
    ArmLogs& m_logs;
    SceneSummary& m_summary;
    pipeline::TouchEstimator m_estimator;
    SkinReader m_reader;
    pipeline::TactileFeedback m_feedback;
    pipeline::FoundObjects m_found;
    std::vector<ComparedTouch> m_touches;
    std::map<std::uint64_t, std::map<std::string, int>> m_named; ///< touches of true objects, by found one
    std::vector<double> m_latencies_s;
    std::optional<double> m_waiting; ///< ready_s of the touch whose pattern has not begun
    std::uint64_t m_patternsSent = 0;
    double m_heardAt_s = 0.0;
    bool m_silent = false;
};

void OperatorSide::report() {
    std::vector<ordered_json> estimated;
    std::vector<ordered_json> truth;
    std::vector<ordered_json> material;
    std::vector<ordered_json> shape;
    std::vector<ordered_json> shapeTruth;
    for (const simulation::ArmObjectTruth& known : m_arm.arm().objects()) {
        const pipeline::FoundObject* object = foundAs(known);
        const bool hasStiffness = object != nullptr && object->stiffness;
        const bool hasShape = object != nullptr && object->recognition;
        estimated.push_back(hasStiffness ? orNull(object->stiffness->value_NPerM) : nullptr);
        truth.push_back(jsonNumber(known.stiffness_NPerM));
        material.push_back(hasStiffness ? ordered_json(stiffness::toString(*object->material)) : nullptr);
        shape.push_back(hasShape ? ordered_json(contour::toString(object->recognition->shape)) : nullptr);
        shapeTruth.emplace_back(trueShape(known.shape));
    }
    ordered_json& measures = m_summary.measures;
    if (!estimated.empty()) {
        measures["estimated_stiffness_n_per_m"] = oneOrList(estimated);
        measures["true_stiffness_n_per_m"] = oneOrList(truth);
        measures["material"] = oneOrList(material);
        measures["shape"] = oneOrList(shape);
        measures["true_shape"] = oneOrList(shapeTruth);
    }
    reportStiffnessCovered(m_touches, measures);
    reportContacts(m_touches, measures);
    measures["touch_to_tactor_p50_s"] = jsonNumber(quantile(m_latencies_s, 0.5));
    measures["touch_to_tactor_p99_s"] = jsonNumber(quantile(m_latencies_s, 0.99));
    measures["patterns_sent"] = m_patternsSent;
}

core::Expected<void> OperatorSide::writeObjects(const std::string& outFolder) const {
    TELETA_TRY(RunCsv csv,
               RunCsv::open(outFolder, "objects.csv",
                            "object,first_s,touches,contact_type,x_m,y_m,force_n,stiffness_n_per_m,"
                            "stiffness_lower_95,stiffness_upper_95,material,shape,confidence,true_object,"
                            "true_stiffness_n_per_m,true_shape"));
    for (const pipeline::FoundObject& object : m_found.objects()) {
        const simulation::ArmObjectTruth* known = truthOf(object);
        const stiffness::Stiffness stiffness = object.stiffness.value_or(stiffness::Stiffness{});
        const auto& shape = object.recognition;
        csv.row(object.number, object.first_s, object.touches, contact::toString(object.contact),
                object.p_Base_Centre_m.x(), object.p_Base_Centre_m.y(), object.highestForce_N,
                stiffness.value_NPerM, stiffness.lower95_NPerM, stiffness.upper95_NPerM,
                object.material ? stiffness::toString(*object.material) : "NA",
                shape ? contour::toString(shape->shape) : "NA",
                shape ? std::optional(shape->confidence) : std::nullopt,
                known != nullptr ? known->name : "NA",
                known != nullptr ? std::optional(known->stiffness_NPerM) : std::nullopt,
                known != nullptr ? trueShape(known->shape) : "NA");
    }
    return csv.finish();
}

} // namespace

core::Expected<SceneSummary> runTeleoperation(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(auto made, simulation::TeleoperatedArm::make(scene, options.seed));
    simulation::TeleoperatedArm& arm = *made;
    const core::ArmDescription description = arm.description();
    TELETA_TRY(ArmLogs logs, ArmLogs::open(options, scene, arm));
    TELETA_TRY(SimulatedPlayer player, SimulatedPlayer::open(options.outFolder));

    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto samples = static_cast<std::uint64_t>(std::llround(duration_s * description.nominalRate_Hz));
    SceneSummary summary;
    OperatorSide side(scene, arm, player, logs, summary);
    core::JointSample atArm;
    core::ArmArrival arrival;
    for (std::uint64_t i = 0; i < samples && !logs.failed(); ++i) {
        summary.interrupted = options.endsAt(i, kSamplesBetweenReports, arm.time_s(), duration_s);
        if (summary.interrupted)
            break;
        arm.next({.drive = core::ArmDrive::program}, atArm);
        while (arm.takeArrival(arrival)) {
            core::JointSample& sample = arrival.sample;
            sample.time_ns = std::llround(sample.sourceTime_s * 1e9);
            logs.add(sample);
            if (arrival.hasFrame)
                logs.addFrame(sample.sourceTime_s, arrival.frame);
            side.take(arrival, arm.time_s());
        }
        side.playUntil(arm.time_s());
    }
    for (const core::Expected<void>& written : {logs.finish(), player.finish()})
        TELETA_CHECK(written);
    TELETA_CHECK(writeTouches(options.outFolder, side.touches()));
    TELETA_CHECK(side.writeObjects(options.outFolder));

    summary.takeTimes(arm);
    side.report();
    summary.measures["frames"] = logs.frames();
    summary.measures["frames_lost"] = arm.linkCounters().framesLost;
    return summary;
}

} // namespace teleta::scene_run
