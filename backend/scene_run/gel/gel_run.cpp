// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/gel/gel_run.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/failure.h"
#include "backend/recording/event_words.h"
#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/scene_recording.h"
#include "backend/scene_run/gel/gel_scene_reaction.h"
#include "backend/scene_run/gel/scene_gel.h"
#include "backend/simulation/camera/gel/gel_stage.h"
#include "backend/vision/gel/gel_contact_rows.h"
#include "backend/vision/gel/gel_follower.h"
#include "backend/vision/gel/marker_rows.h"
#include "backend/vision/gel/slip_monitor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::scene_run {

namespace {

struct GelRunText {
    Q_DECLARE_TR_FUNCTIONS(GelRun)
};

using simulation::GelBallTruth;
using vision::GelContactState;

constexpr std::uint64_t kPicturesBetweenReports = 8;
constexpr double kLeastGelDepth_m = 0.0002;
constexpr double kLeastDrag_m = 0.0001;

/// markers.csv, contacts.csv and truth.csv, of an arm that reacts arm.csv, or nothing without a folder.
class GelLog {
public:
    [[nodiscard]] static core::Expected<GelLog> open(const std::string& folder, bool reacts) {
        GelLog log;
        if (reacts) {
            TELETA_TRY(log.m_arm, RunCsv::open(folder, "arm.csv", "time_s,along_m,aside_x_m,aside_y_m"));
        }
        if (!folder.empty()) {
            TELETA_TRY(log.m_markers,
                       core::CsvWriter::create(folder + "/markers.csv", vision::kMarkerColumns));
            TELETA_TRY(log.m_contacts,
                       core::CsvWriter::create(folder + "/contacts.csv", vision::kGelContactColumns));
        }
        TELETA_TRY(log.m_truth, RunCsv::open(folder, "truth.csv",
                                             "time_s,object,touches,x_m,y_m,radius_m,drag_x_m,drag_y_m,"
                                             "turn_rad,slip_share"));
        return log;
    }

    void add(std::uint64_t frame, double time_s, const vision::GelFollower& follower,
             const std::vector<GelBallTruth>& truths) {
        if (m_markers && follower.hasReference())
            vision::writeMarkers(*m_markers, static_cast<long long>(frame), time_s, follower.gel().markers(),
                                 follower.gel().motions());
        for (const GelContactState& contact : follower.contacts())
            if (m_contacts)
                vision::writeGelContact(*m_contacts, static_cast<long long>(frame), time_s, contact);
        for (const GelBallTruth& truth : truths)
            m_truth.row(time_s, truth.name, truth.touches ? 1 : 0, truth.centre_m.x(), truth.centre_m.y(),
                        truth.radius_m, truth.drag_m.x(), truth.drag_m.y(), truth.turn_rad, truth.slipShare);
    }

    void addArm(double time_s, const simulation::TubePose& pose) {
        m_arm.row(time_s, pose.along_m, pose.aside_m);
    }

    /// A full disk is reported at once, not at the end of a long run.
    [[nodiscard]] bool failed() const {
        return (m_markers && m_markers->failed()) || (m_contacts && m_contacts->failed()) ||
               m_truth.failed() || m_arm.failed();
    }

    [[nodiscard]] core::Expected<void> finish() {
        if (m_markers)
            TELETA_CHECK(m_markers->finish());
        if (m_contacts)
            TELETA_CHECK(m_contacts->finish());
        TELETA_CHECK(m_arm.finish());
        return m_truth.finish();
    }

private:
    std::optional<core::CsvWriter> m_markers, m_contacts;
    RunCsv m_truth, m_arm;
};

/// Compares what was found with what is true, picture by picture.
class GelMeasures {
public:
    explicit GelMeasures(const scene::GelWorld& world)
        : m_world(world) {}

    void add(double time_s, const simulation::GelStage& stage, const vision::GelFollower& follower) {
        addMarkers(stage, follower.gel());
        for (std::size_t i = 0; i < stage.truth().size(); ++i)
            addBall(time_s, stage.truth()[i], m_world.balls[i].radius_m, follower.contacts());
        for (const GelContactState& contact : follower.contacts()) {
            if (contact.event == vision::SlipEvent::incipientSlip)
                m_incipient_s = m_incipient_s.value_or(time_s);
            if (contact.event == vision::SlipEvent::slip)
                m_slip_s = m_slip_s.value_or(time_s);
        }
    }

    void report(nlohmann::ordered_json& measures) const {
        measures["marker_error_px"] = jsonNumber(std::sqrt(m_squares_px2 / m_coordinates));
        measures["markers_lost"] = m_lost;
        reportContactErrors(m_errors_m, measures);
        measures["contacts_missed"] = m_missed;
        measures["shear_direction_error_rad"] = jsonNumber(mean(m_directions_rad));
        measures["torsion_rad"] = jsonNumber(m_torsion_rad);
        measures["true_turn_rad"] = m_turn_rad;
        measures["slip_index_error"] = jsonNumber(mean(m_slipErrors));
        measures["incipient_slip_s"] = orNull(m_incipient_s);
        measures["true_incipient_slip_s"] = orNull(m_trueIncipient_s);
        measures["slip_s"] = orNull(m_slip_s);
        measures["true_slip_s"] = orNull(m_trueSlip_s);
    }

private:
    void addMarkers(const simulation::GelStage& stage, const vision::MarkerGel& gel) {
        if (m_printed.size() != gel.markers().size()) {
            m_printed.clear();
            for (const vision::GelMarker& marker : gel.markers()) {
                const auto near =
                    std::ranges::min_element(stage.rest_px(), {}, [&](const Eigen::Vector2d& place) {
                        return (place - marker.rest_px).squaredNorm();
                    });
                m_printed.push_back(static_cast<std::size_t>(near - stage.rest_px().begin()));
            }
        }
        for (std::size_t i = 0; i < m_printed.size(); ++i) {
            if (!gel.motions()[i].found) {
                ++m_lost;
                continue;
            }
            m_squares_px2 += (gel.motions()[i].place_px - stage.places_px()[m_printed[i]]).squaredNorm();
            m_coordinates += 2.0;
        }
    }

    void addBall(double time_s, const GelBallTruth& truth, double ballRadius_m,
                 const std::vector<GelContactState>& contacts) {
        const double depth_m = truth.radius_m * truth.radius_m / ballRadius_m;
        if (!truth.touches)
            return;
        if (truth.slipShare >= vision::kIncipientSlipIndex)
            m_trueIncipient_s = m_trueIncipient_s.value_or(time_s);
        if (truth.slipShare >= vision::kSlipIndex)
            m_trueSlip_s = m_trueSlip_s.value_or(time_s);
        if (depth_m < kLeastGelDepth_m)
            return;
        const auto near = std::ranges::min_element(contacts, {}, [&](const GelContactState& contact) {
            return (contact.centre_m - truth.centre_m).squaredNorm();
        });
        if (near == contacts.end()) {
            ++m_missed;
            return;
        }
        m_errors_m.push_back((near->centre_m - truth.centre_m).norm());
        if (truth.drag_m.norm() > kLeastDrag_m) {
            const Eigen::Vector2d& shear_m = near->shearProxy_m;
            const double off_rad =
                std::atan2(shear_m.y(), shear_m.x()) - std::atan2(truth.drag_m.y(), truth.drag_m.x());
            m_directions_rad.push_back(std::abs(std::remainder(off_rad, 2.0 * std::numbers::pi)));
        }
        if (std::abs(truth.turn_rad) > std::abs(m_turn_rad)) {
            m_turn_rad = truth.turn_rad;
            m_torsion_rad = near->torsion_rad;
        }
        if (near->slipIndex)
            m_slipErrors.push_back(std::abs(*near->slipIndex - truth.slipShare));
    }

    const scene::GelWorld& m_world;
    std::vector<std::size_t> m_printed; ///< of each marker, its number in the drawing
    double m_squares_px2 = 0.0, m_coordinates = 0.0;
    std::size_t m_lost = 0, m_missed = 0;
    std::vector<double> m_errors_m, m_directions_rad, m_slipErrors;
    double m_turn_rad = 0.0;
    double m_torsion_rad = std::numeric_limits<double>::quiet_NaN();
    std::optional<double> m_incipient_s, m_slip_s, m_trueIncipient_s, m_trueSlip_s;
};

/// What the arm does, against what the ball does.
class ReactionMeasures {
public:
    ReactionMeasures(const scene::GelWorld& world, double period_s)
        : m_world(world)
        , m_period_s(period_s) {}

    void add(double time_s, const simulation::GelStage& stage, const ReactingGel& arm) {
        const simulation::GelBallTruth& ball = stage.truth().front();
        if (const auto* bump = std::get_if<scene::GelBumpReaction>(&m_world.reaction)) {
            const double radius_m = m_world.balls.front().radius_m;
            const double spread_m =
                ball.touches ? m_world.balls.front().spreadPerDepth * ball.radius_m * ball.radius_m / radius_m
                             : 0.0;
            if (spread_m > bump->spread_m || spread_m - m_spread_m > bump->spread_mPerS * m_period_s)
                takeFirst(m_bump_s, time_s - m_period_s);
            m_spread_m = spread_m;
            if (arm.stopped())
                takeFirst(m_stop_s, time_s);
            m_deepest_m = std::max(m_deepest_m, ball.radius_m * ball.radius_m / radius_m);
        }
        if (!ball.touches)
            return;
        if (!m_touched)
            m_start_m = stage.arm().pose().aside_m;
        m_touched = true;
        m_lag_m = ball.drag_m.norm();
        m_way_m = (stage.arm().pose().aside_m - m_start_m).norm();
    }

    void report(nlohmann::ordered_json& measures) const {
        if (std::holds_alternative<scene::GelBumpReaction>(m_world.reaction)) {
            const bool early = std::isfinite(m_stop_s) && !(m_stop_s > m_bump_s);
            measures["bump_to_stop_s"] = early ? nullptr : jsonNumber(m_stop_s - m_bump_s);
            measures["stopped_without_bump"] = early ? 1 : 0;
            measures["deepest_m"] = m_deepest_m;
        } else {
            measures["followed_m"] = m_way_m;
            measures["follow_error_m"] = m_lag_m;
        }
    }

private:
    static void takeFirst(double& first_s, double time_s) {
        if (std::isnan(first_s))
            first_s = time_s;
    }

    const scene::GelWorld& m_world;
    double m_period_s;
    double m_spread_m = 0.0, m_deepest_m = 0.0, m_lag_m = 0.0, m_way_m = 0.0;
    double m_bump_s = std::numeric_limits<double>::quiet_NaN(); ///< until there is one
    double m_stop_s = std::numeric_limits<double>::quiet_NaN();
    bool m_touched = false;
    Eigen::Vector2d m_start_m = Eigen::Vector2d::Zero();
};

void addEvents(double time_s, const std::vector<int>& before, const std::vector<GelContactState>& contacts,
               nlohmann::ordered_json& events) {
    const auto add = [&](const char* event, int contact) {
        events.push_back({{"time_s", time_s}, {"event", event}, {"contact", contact}});
    };
    for (const int id : before)
        if (std::ranges::find(contacts, id, &GelContactState::id) == contacts.end())
            add(recording::kContactEnds, id);
    for (const GelContactState& contact : contacts) {
        if (std::ranges::find(before, contact.id) == before.end())
            add(recording::kContactBegins, contact.id);
        if (contact.event == vision::SlipEvent::incipientSlip)
            add(recording::kIncipientSlip, contact.id);
        if (contact.event == vision::SlipEvent::slip)
            add(recording::kSlip, contact.id);
    }
}

} // namespace

core::Expected<SceneSummary> runGelScene(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(const auto stage, simulation::GelStage::make(scene, options.seed));
    const vision::MarkerGelFile file = gelFile(scene);
    vision::GelFollower follower(file);
    const bool reacts = !std::holds_alternative<scene::NoReaction>(scene.gel().reaction);
    TELETA_TRY(GelLog log, GelLog::open(options.outFolder, reacts));
    TELETA_TRY(SceneRecording recording, SceneRecording::open(options, scene));
    if (recording.isOpen())
        recording.beginGel(
            {.name = options.name, .nominalRate_Hz = scene.rate_Hz, .simulated = true, .recorded = false},
            file);
    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto pictures = static_cast<std::uint64_t>(std::llround(duration_s * scene.rate_Hz));
    SceneSummary summary;
    GelMeasures measures(scene.gel());
    ReactingGel arm(scene.gel(), 1.0 / scene.rate_Hz);
    ReactionMeasures reaction(scene.gel(), 1.0 / scene.rate_Hz);
    simulation::TubeVelocity asked;
    std::uint64_t done = 0;
    for (; done < pictures; ++done) {
        summary.interrupted = options.endsAt(done, kPicturesBetweenReports, stage->time_s(), duration_s);
        if (summary.interrupted)
            break;
        cv::Mat1b picture;
        stage->next(asked, picture);
        const double time_s = stage->time_s();
        const std::size_t references = follower.references();
        std::vector<int> before;
        for (const GelContactState& contact : follower.contacts())
            before.push_back(contact.id);
        follower.next(picture, time_s);
        if (recording.isOpen())
            recording.addPicture(time_s, core::greyImageOf(picture));
        if (follower.references() != references)
            recording.addGelReference(follower.reference());
        if (follower.hasReference()) {
            addEvents(time_s, before, follower.contacts(), summary.events);
            measures.add(time_s, *stage, follower);
            log.add(done, time_s, follower, stage->truth());
            for (const GelContactState& contact : follower.contacts())
                recording.addGelContact(time_s, contact);
        }
        if (reacts && follower.usable()) {
            const vision::MarkerGel& gel = follower.gel();
            asked =
                arm.decide(follower.contacts(), time_s, gel.scale_m() * gel.noise_px(), stage->arm().pose());
            if (arm.bump() != 0)
                summary.events.push_back(
                    {{"time_s", time_s}, {"event", recording::kBump}, {"contact", arm.bump()}});
        }
        if (reacts) {
            reaction.add(time_s, *stage, arm);
            log.addArm(time_s, stage->arm().pose());
        }
        if (log.failed())
            break;
    }
    for (const core::Expected<void>& written : {log.finish(), recording.finish()})
        TELETA_CHECK(written);
    if (done < vision::MarkerGel::kReferencePictures && !summary.interrupted)
        return core::refused(
            GelRunText::tr("the scene ends before the gel at rest is known"),
            GelRunText::tr("at least %1 pictures").arg(vision::MarkerGel::kReferencePictures));
    if (!follower.hasReference() && !summary.interrupted)
        return core::refused(GelRunText::tr("the gel at rest could not be found: %1")
                                 .arg(QString::fromStdString(follower.problem())));
    summary.simulated_s = stage->time_s();
    measures.report(summary.measures);
    if (reacts)
        reaction.report(summary.measures);
    summary.measures["frames"] = done;
    return summary;
}

} // namespace teleta::scene_run
