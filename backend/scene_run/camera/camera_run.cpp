// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/camera_run.h"

#include "backend/core/data/csv_writer.h"
#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/scene_recording.h"
#include "backend/scene_run/camera/camera_image.h"
#include "backend/scene_run/camera/reacting_arm.h"
#include "backend/scene_run/camera/scene_reaction.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/contacts/contact_rows.h"
#include "backend/vision/finders/contact_ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace teleta::scene_run {

namespace {

constexpr std::uint64_t kCameraFramesBetweenReports = 8;
constexpr double kLeastDepth_m = 0.0006; ///< a lighter touch falls between the dots

/// contacts.csv and arm.csv, or nothing without a folder.
class CameraLog {
public:
    [[nodiscard]] static core::Expected<CameraLog> open(const std::string& folder) {
        CameraLog log;
        if (!folder.empty()) {
            TELETA_TRY(log.m_contacts,
                       core::CsvWriter::create(folder + "/contacts.csv", vision::kContactColumns));
        }
        TELETA_TRY(log.m_arm, RunCsv::open(folder, "arm.csv", "time_s,turn_rad,along_m,aside_x_m,aside_y_m"));
        return log;
    }

    void add(std::uint64_t frame, double time_s, const std::vector<vision::FollowedContact>& contacts,
             int bumped, const simulation::TubePose& pose) {
        m_arm.row(time_s, pose.turn_rad, pose.along_m, pose.aside_m);
        for (const vision::FollowedContact& followed : contacts) {
            if (!m_contacts)
                return;
            if (followed.seen || followed.event == vision::ContactEvent::ends)
                vision::writeContact(*m_contacts, static_cast<long long>(frame), time_s, followed, bumped);
        }
    }

    /// A full disk is reported at once, not at the end of a long run.
    [[nodiscard]] bool failed() const { return (m_contacts && m_contacts->failed()) || m_arm.failed(); }

    [[nodiscard]] core::Expected<void> finish() {
        if (m_contacts)
            TELETA_CHECK(m_contacts->finish());
        return m_arm.finish();
    }

private:
    std::optional<core::CsvWriter> m_contacts;
    RunCsv m_arm;
};

/// Compares what was found with what is true, frame by frame.
class CameraMeasures {
public:
    CameraMeasures(const scene::CameraWorld& world, double period_s)
        : m_world(world)
        , m_period_s(period_s) {}

    void add(double time_s, const std::vector<simulation::FingerTruth>& truths,
             const std::vector<vision::FollowedContact>& contacts, const simulation::TubePose& pose) {
        bool bumps = false;
        for (std::size_t i = 0; i < truths.size(); ++i) {
            const simulation::FingerTruth& truth = truths[i];
            const double depth_m = truth.touches ? truth.press.depth_m : 0.0;
            m_depths_m.resize(truths.size(), 0.0);
            if (const auto* bump = std::get_if<scene::BumpReaction>(&m_world.reaction))
                bumps = bumps || depth_m > bump->depth_m ||
                        (depth_m > 0.0 && (depth_m - m_depths_m[i]) / m_period_s > bump->speed_mPerS);
            m_depths_m[i] = depth_m;
            if (depth_m < kLeastDepth_m)
                continue;
            double nearest_m = std::numeric_limits<double>::infinity();
            for (const vision::FollowedContact& followed : contacts) {
                if (followed.seen)
                    nearest_m = std::min(
                        nearest_m, (followed.contact.p_Sensor_Centre_m - truth.p_Sensor_Centre_m).norm());
            }
            if (std::isfinite(nearest_m))
                m_errors_m.push_back(nearest_m);
            else
                ++m_missed;
        }
        if (bumps && !m_bump_s)
            m_bump_s = time_s - m_period_s;
        follow(truths, pose);
    }

    void stopCommanded(double time_s) {
        if (!m_stop_s)
            m_stop_s = time_s;
    }

    void report(nlohmann::ordered_json& measures) {
        reportContactErrors(m_errors_m, measures);
        measures["contacts_missed"] = m_missed;
        if (std::holds_alternative<scene::BumpReaction>(m_world.reaction)) {
            const bool early = m_stop_s && (!m_bump_s || *m_stop_s <= *m_bump_s);
            measures["bump_to_stop_s"] =
                m_bump_s && m_stop_s && !early ? jsonNumber(*m_stop_s - *m_bump_s) : nullptr;
            measures["stopped_without_bump"] = early ? 1 : 0;
        }
        if (std::holds_alternative<scene::FollowReaction>(m_world.reaction)) {
            measures["follow_angle_error_rad"] = jsonNumber(std::abs(m_angleError_rad));
            measures["follow_axial_error_m"] = jsonNumber(std::abs(m_axialError_m));
        }
    }

private:
    void follow(const std::vector<simulation::FingerTruth>& truths, const simulation::TubePose& pose) {
        if (truths.empty() || !truths.front().touches)
            return;
        const simulation::SkinPlace& finger = truths.front().inBase;
        if (!m_touched) {
            m_touched = true;
            m_fingerStart = finger;
            m_armStart = pose;
        }
        m_angleError_rad =
            (finger.angle_rad - m_fingerStart.angle_rad) - (pose.turn_rad - m_armStart.turn_rad);
        m_axialError_m = (finger.z_m - m_fingerStart.z_m) - (pose.along_m - m_armStart.along_m);
    }

    const scene::CameraWorld& m_world;
    double m_period_s;
    std::vector<double> m_errors_m, m_depths_m;
    std::size_t m_missed = 0;
    std::optional<double> m_bump_s, m_stop_s;
    bool m_touched = false;
    simulation::SkinPlace m_fingerStart;
    simulation::TubePose m_armStart;
    double m_angleError_rad = std::numeric_limits<double>::quiet_NaN(); ///< until it touches
    double m_axialError_m = std::numeric_limits<double>::quiet_NaN();
};

} // namespace

core::Expected<SceneSummary> runCameraScene(const scene::Scene& scene, const RunOptions& options) {
    if (scene.camera().probing)
        return runProbingScene(scene, options);
    TELETA_TRY(auto made, simulation::SimulatedTube::make(scene, options.seed));
    simulation::SimulatedTube& tube = *made;
    const scene::CameraWorld& world = scene.camera();
    cv::Mat1b frame;
    tube.untouched(frame);
    TELETA_CHECK(writeReference(options.outFolder, frame));
    SceneSummary summary;
    TELETA_TRY(auto finder, vision::makeContactFinder(vision::contactLadder().front(), tube.camera()));
    vision::CameraTracker tracker(std::move(finder), trackerSettings(world));
    TELETA_CHECK(tracker.next(frame, 0.0));
    TELETA_TRY(CameraLog log, CameraLog::open(options.outFolder));

    TELETA_TRY(SceneRecording recording, SceneRecording::open(options, scene));
    if (recording.isOpen())
        recording.beginCamera(
            {.name = options.name, .nominalRate_Hz = scene.rate_Hz, .simulated = true, .recorded = false},
            tube.camera(), trackerSettings(world).bump, core::greyImageOf(cv::Mat1b(frame.clone())));

    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto frames = static_cast<std::uint64_t>(std::llround(duration_s * scene.rate_Hz));
    CameraMeasures measures(world, 1.0 / scene.rate_Hz);
    ReactingArm reaction(world, 1.0 / scene.rate_Hz);
    simulation::TubeVelocity asked;
    std::optional<double> firstContact_s;
    std::uint64_t done = 0;
    for (; done < frames; ++done) {
        summary.interrupted = options.endsAt(done, kCameraFramesBetweenReports, tube.time_s(), duration_s);
        if (summary.interrupted)
            break;
        tube.next(asked, frame);
        const double time_s = tube.time_s();
        TELETA_TRY(const auto contacts, tracker.next(frame, time_s));
        for (const vision::FollowedContact& followed : contacts) {
            if (followed.event == vision::ContactEvent::none)
                continue;
            const bool begins = followed.event == vision::ContactEvent::begins;
            summary.events.push_back({{"time_s", time_s},
                                      {"event", begins ? "contact_begins" : "contact_ends"},
                                      {"contact", followed.contact.id}});
            if (begins && !firstContact_s)
                firstContact_s = time_s;
        }
        if (tracker.bump())
            summary.events.push_back(
                {{"time_s", time_s}, {"event", "bump"}, {"contact", tracker.bump()->contact}});
        asked = reaction.decide(contacts, tracker.bump(), tube.arm().pose());
        if (reaction.stopped())
            measures.stopCommanded(time_s);
        measures.add(time_s, tube.truth(), contacts, tube.arm().pose());
        log.add(done + 1, time_s, contacts, tracker.bump() ? tracker.bump()->contact : 0, tube.arm().pose());
        if (recording.isOpen())
            recording.addPicture(time_s, core::greyImageOf(cv::Mat1b(frame.clone())));
        for (const vision::FollowedContact& followed : contacts) {
            if (followed.seen || followed.event == vision::ContactEvent::ends)
                recording.addContact(time_s, followed);
        }
        if (log.failed())
            break;
    }
    for (const core::Expected<void>& written : {log.finish(), recording.finish()})
        TELETA_CHECK(written);
    summary.takeTimes(tube);
    measures.report(summary.measures);
    summary.measures["first_contact_s"] = orNull(firstContact_s);
    summary.measures["frames"] = done;
    summary.measures["frames_lost"] = tracker.unusableFrames();
    return summary;
}

} // namespace teleta::scene_run
