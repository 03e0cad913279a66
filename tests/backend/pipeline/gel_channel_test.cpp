// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/recorded/recorded_gel.h"
#include "backend/recording/csv_export.h"
#include "backend/recording/event_words.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/simulation/camera/gel/gel_renderer.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace teleta;
using namespace std::chrono_literals;
using pipeline::GelChannel;
using pipeline::GelEvent;
using simulation::GelContact;

namespace {

constexpr int kRest = static_cast<int>(vision::MarkerGel::kReferencePictures);

/// A camera whose pictures come when the test says so.
class ScriptedCamera : public core::CameraSource {
public:
    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_consumer = &consumer; }
    void stop() override {}
    bool pop(core::CameraFrame& frame) override { return m_frames.pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override {
        core::DeviceStatus status;
        status.state = m_state;
        return status;
    }

    void push(core::CameraFrame frame) {
        frame.number = m_number++;
        m_frames.push(std::move(frame));
        m_consumer->notify();
    }
    void setState(core::DeviceState state) { m_state = state; }

private:
    core::CameraDescription m_description{
        .name = "/dev/video7", .nominalRate_Hz = 25.0, .simulated = true, .recorded = false};
    core::CameraFrameQueue m_frames{8};
    core::Wakeup* m_consumer = nullptr;
    std::uint64_t m_number = 0;
    std::atomic<core::DeviceState> m_state{core::DeviceState::live};
};

vision::MarkerGelFile gelFile() {
    vision::MarkerGelFile file;
    file.name = "left finger";
    file.grid = vision::MarkerGrid::rectangular;
    file.rows = 8;
    file.columns = 10;
    file.plane.mmPerPx = 0.1;
    return file;
}

/// Takes what a channel records.
class Sink : public recording::StreamSink {
public:
    std::shared_ptr<core::StreamTap> addStream(recording::StreamInfo info) override {
        infos.push_back(std::move(info));
        taps.push_back(std::make_shared<core::StreamTap>(1024));
        return taps.back();
    }
    void add(recording::RecordingEvent event) override { events.push_back(std::move(event)); }
    /// All frames of a stream.
    [[nodiscard]] std::vector<core::TappedFrames> frames(std::size_t stream) const {
        std::vector<core::TappedFrames> all;
        core::TappedFrames frame;
        while (taps[stream]->pop(frame))
            all.push_back(std::move(frame));
        return all;
    }

    std::vector<recording::StreamInfo> infos;
    std::vector<std::shared_ptr<core::StreamTap>> taps;
    std::vector<recording::RecordingEvent> events;
};

/// Remembers what it was told, and takes each contact for a bump once.
class ToldReaction : public pipeline::GelReaction {
public:
    struct Told {
        int reactions = 0, refusals = 0, holds = 0, forgets = 0;
        std::size_t contacts = 0;
    };
    explicit ToldReaction(core::LatestCopy<Told>& told)
        : m_out(told) {}

    int react(const std::vector<vision::GelContactState>& contacts, double /*time_s*/, double /*noise_m*/,
              bool allowed) override {
        ++(allowed ? m_told.reactions : m_told.refusals);
        m_told.contacts = contacts.size();
        m_out.set(m_told);
        const bool isNew = allowed && !contacts.empty() && contacts.front().id != m_bumped;
        m_doing = !allowed           ? pipeline::CarrierReport::Doing::held
                  : contacts.empty() ? pipeline::CarrierReport::Doing::stands
                                     : pipeline::CarrierReport::Doing::retreats;
        if (isNew)
            m_bumped = contacts.front().id;
        return isNew ? m_bumped : 0;
    }
    void hold() override {
        ++m_told.holds;
        m_doing = pipeline::CarrierReport::Doing::held;
        m_out.set(m_told);
    }
    void forget() override { ++m_told.forgets; }
    [[nodiscard]] pipeline::CarrierReport report() const override {
        return {.doing = m_doing, .contact = m_bumped};
    }

private:
    core::LatestCopy<Told>& m_out;
    Told m_told;
    pipeline::CarrierReport::Doing m_doing = pipeline::CarrierReport::Doing::stands;
    int m_bumped = 0;
};

class LiveGel : public testing::Test {
protected:
    void SetUp() override { open(gelFile()); }
    void open(const vision::MarkerGelFile& file) {
        auto source = std::make_unique<ScriptedCamera>();
        m_camera = source.get();
        m_channel = std::make_shared<GelChannel>(std::move(source), file, m_rest);
        m_channel->setLoads(m_loads);
        if (m_reacts)
            m_channel->setReaction(std::make_unique<ToldReaction>(m_told), m_stop);
        m_channel->start();
    }
    /// Waits for a snapshot of which this holds.
    template <typename Condition>
    [[nodiscard]] bool comesTo(Condition condition) {
        for (int i = 0; i < 20'000 && !condition(snapshot()); ++i) {
            std::this_thread::sleep_for(1ms);
            m_channel->update();
        }
        return condition(snapshot());
    }
    [[nodiscard]] core::GreyImage drawn(const std::optional<GelContact>& contact) {
        std::vector<Eigen::Vector2d> places = m_renderer.rest_px();
        for (Eigen::Vector2d& place : places)
            place += contact ? contact->displacement_m(place) : Eigen::Vector2d(Eigen::Vector2d::Zero());
        cv::Mat1b picture;
        m_renderer.draw(places, picture);
        return core::greyImageOf(picture.clone());
    }
    /// One picture after the other, each after the one before was worked on.
    void show(const std::optional<GelContact>& contact = {}, int pictures = 1) {
        for (int i = 0; i < pictures; ++i)
            give(drawn(contact));
    }
    void give(core::GreyImage image, bool discontinuity = false) {
        const std::uint64_t before = m_channel->framesProcessed();
        m_camera->push({.image = std::move(image),
                        .time_ns = core::steadyNow_ns(),
                        .capture_s = m_capture_s += 0.04,
                        .discontinuity = discontinuity});
        // The count goes up before the snapshot is there.
        for (int i = 0; i < 20'000 && snapshot().processed <= before; ++i) {
            std::this_thread::sleep_for(1ms);
            m_channel->update();
        }
        ASSERT_EQ(snapshot().processed, before + 1);
        GelEvent event;
        while (m_channel->popEvent(event))
            m_events.push_back(event);
    }
    [[nodiscard]] const pipeline::GelSnapshot& snapshot() const { return m_channel->snapshot(); }
    [[nodiscard]] long eventsOf(GelEvent::Kind kind) const {
        return std::ranges::count(m_events, kind, &GelEvent::kind);
    }

    simulation::GelRenderer m_renderer{simulation::SimulatedGel{}};
    ScriptedCamera* m_camera = nullptr;
    std::shared_ptr<GelChannel> m_channel;
    std::vector<GelEvent> m_events;
    double m_capture_s = 0.0;
    core::GreyImage m_rest; ///< with which the channel begins
    std::optional<pipeline::GelLoads> m_loads;
    bool m_reacts = false;
    core::StopSwitch m_stop;
    core::LatestCopy<ToldReaction::Told> m_told;
};

const GelContact kDragged{
    .centre_m = {160.0, 120.0}, .radius_m = 70.0, .slip_m = {8.0, 0.0}, .stick = 0.70710678};

} // namespace

TEST_F(LiveGel, aCalibrationGivesLoadsInNewtonsAndIsRecorded) {
    // 2 N per mm of shear beyond 0.1 mm, found with shears of up to 0.2 mm.
    equilibration::LoadCalibration calibration{.loads = {"shear_x_n"}, .channels = {"shear_proxy_x_m"}};
    calibration.gain = Eigen::MatrixXd::Constant(1, 1, 2000.0);
    calibration.error = Eigen::MatrixXd::Constant(1, 1, 10.0);
    calibration.rest = Eigen::VectorXd::Constant(1, 0.0001);
    calibration.least = Eigen::VectorXd::Constant(1, 0.0);
    calibration.greatest = Eigen::VectorXd::Constant(1, 0.0002);
    calibration.scatter = Eigen::VectorXd::Constant(1, 0.05);
    m_channel->stop();
    m_loads.emplace(calibration);
    open(gelFile());
    const auto sink = std::make_shared<Sink>();
    m_channel->watch(pipeline::Watcher::liveView, sink, "finger");
    show({}, kRest + 1);
    show(kDragged, 2);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    ASSERT_EQ(snapshot().loads.size(), 1U);
    const double past_m = snapshot().contacts[0].shearProxy_m.x() - 0.0001;
    EXPECT_NEAR(snapshot().loads[0].loads[0], 2000.0 * past_m, 1e-12);
    EXPECT_NEAR(snapshot().loads[0].errors[0], std::hypot(0.05, 10.0 * past_m), 1e-12);
    EXPECT_TRUE(snapshot().loads[0].extrapolated) << past_m;
    EXPECT_EQ(snapshot().loadNames, calibration.loads);
    // Who has the pictures has the calibration.
    ASSERT_EQ(sink->infos.size(), 3U);
    const auto gel = pipeline::gelOf(sink->infos[1], "recording");
    ASSERT_TRUE(gel) << core::describe(gel.error());
    ASSERT_TRUE(gel->loads);
    EXPECT_EQ(gel->loads->calibration().channels, calibration.channels);
    EXPECT_EQ(gel->loads->calibration().gain, calibration.gain);
}

TEST_F(LiveGel, theLoadsOfItsContactsAreInTheExportedTable) {
    // 2 N per mm of shear, beyond which nothing was pressed; the moment needs a slip index.
    equilibration::LoadCalibration calibration{.loads = {"shear_x_n", "moment_nm"},
                                               .channels = {"shear_proxy_x_m", "slip_index"}};
    calibration.gain = Eigen::Matrix2d{{2000.0, 0.0}, {0.0, 1.0}};
    calibration.error = Eigen::Matrix2d{{10.0, 0.0}, {0.0, 0.25}};
    calibration.rest = Eigen::Vector2d::Zero();
    calibration.least = Eigen::Vector2d::Zero();
    calibration.greatest = Eigen::Vector2d(0.0001, 1.0);
    calibration.scatter = Eigen::Vector2d(0.05, 0.01);
    m_channel->stop();
    m_loads.emplace(calibration);
    open(gelFile());
    test::TemporaryFolder folder;
    const std::string path = folder.path("gel.teleta");
    auto started = recording::Recorder::start(path, {});
    ASSERT_TRUE(started) << core::describe(started.error());
    const std::shared_ptr<recording::Recorder> recorder = std::move(*started);
    m_channel->record(recorder, "finger");
    show({}, kRest + 1);
    show(kDragged, 2);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    const vision::GelContactState contact = snapshot().contacts[0];
    m_channel->stop();
    m_channel->record(nullptr, {});
    ASSERT_TRUE(recorder->stop());

    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_TRUE(recording::exportCsv(*recording, folder.path("csv")));
    std::ifstream table(folder.path("csv/finger-contacts.csv"));
    std::string heading;
    ASSERT_TRUE(std::getline(table, heading));
    EXPECT_EQ(heading, "time_s,contact_id,x_m,y_m,area_m2,normal_proxy_m2,shear_proxy_x_m,shear_proxy_y_m,"
                       "torsion_rad,slip_index,shear_x_n,shear_x_n_se,moment_nm,moment_nm_se,extrapolated");
    std::vector<std::string> cells;
    for (std::string line; std::getline(table, line);) {
        cells.clear();
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(cell);
    }
    ASSERT_EQ(cells.size(), 15U);
    const double shear_m = contact.shearProxy_m.x();
    EXPECT_NEAR(std::stod(cells[10]), 2000.0 * shear_m, 1e-9);
    EXPECT_NEAR(std::stod(cells[11]), std::hypot(0.05, 10.0 * shear_m), 1e-9);
    ASSERT_TRUE(contact.slipIndex);
    EXPECT_NEAR(std::stod(cells[12]), *contact.slipIndex, 1e-9);
    EXPECT_NEAR(std::stod(cells[13]), std::hypot(0.01, 0.25 * *contact.slipIndex), 1e-9);
    EXPECT_EQ(std::stod(cells[14]), 1.0) << "beyond the presses";
}

TEST_F(LiveGel, anArmReactsUntilStopTakesThePermissionAway) {
    using Doing = pipeline::CarrierReport::Doing;
    EXPECT_FALSE(snapshot().carrier.has_value());
    m_reacts = true;
    m_channel->stop();
    open(gelFile());
    show({}, kRest + 1);
    ASSERT_TRUE(snapshot().carrier);
    EXPECT_TRUE(snapshot().mayReact);
    show(kDragged, 2);
    EXPECT_EQ(snapshot().carrier->doing, Doing::retreats);
    EXPECT_EQ(eventsOf(GelEvent::Kind::bumps), 1);

    m_stop.engage();
    EXPECT_TRUE(comesTo([](const auto& now) { return !now.mayReact; }));
    EXPECT_TRUE(comesTo([](const auto& now) { return now.carrier->doing == Doing::held; }));
    m_channel->setMayReact(true);
    show(kDragged);
    EXPECT_FALSE(snapshot().mayReact) << "STOP is engaged";
    m_stop.release();
    EXPECT_FALSE(snapshot().mayReact) << "its end gives no permission";
    m_channel->setMayReact(true);
    EXPECT_TRUE(comesTo([](const auto& now) { return now.mayReact; }));
    const int before = m_told.get().reactions;
    show(kDragged);
    EXPECT_EQ(m_told.get().reactions, before + 1);
    // No pictures come any more.
    EXPECT_TRUE(comesTo([](const auto& now) { return now.carrier->doing == Doing::held; }));
    EXPECT_GT(m_told.get().holds, 0);
}

TEST_F(LiveGel, takesItsRestThenTellsTheContactsThatBeginAndEnd) {
    show();
    EXPECT_FALSE(snapshot().hasReference());
    EXPECT_EQ(snapshot().missing, vision::MarkerGel::kReferencePictures - 1);
    EXPECT_EQ(snapshot().image.width_px, 320);
    show({}, kRest - 1);
    EXPECT_EQ(eventsOf(GelEvent::Kind::reference), 1);
    ASSERT_EQ(snapshot().markers.size(), 80U);
    EXPECT_EQ(snapshot().motions.size(), 80U);
    EXPECT_NEAR(snapshot().scale_m, 1e-4, 1e-9);
    show(kDragged);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    EXPECT_EQ(eventsOf(GelEvent::Kind::begins), 1);
    EXPECT_TRUE(snapshot().usable);
    EXPECT_GE(snapshot().contacts.front().outline_px.size(), 3U);
    show();
    EXPECT_EQ(eventsOf(GelEvent::Kind::ends), 1);
    EXPECT_EQ(m_channel->summary().name, "left finger");
    EXPECT_TRUE(m_channel->summary().simulated);
}

/// A ball is pressed, then dragged until all of it slips.
TEST_F(LiveGel, tellsIncipientSlipBeforeSlip) {
    show({}, kRest);
    GelContact ball{.centre_m = {160.0, 120.0}, .radius_m = 80.0};
    for (int i = 1; i <= 10; ++i) {
        ball.spread_m = 0.6 * i;
        show(ball);
    }
    EXPECT_EQ(eventsOf(GelEvent::Kind::slip), 0);
    ball.slip_m = {12.0, 0.0};
    for (int i = 1; i <= 55; ++i) {
        ball.stick = std::sqrt(1.0 - std::min(1.0, 0.02 * i));
        show(ball);
    }
    ASSERT_EQ(eventsOf(GelEvent::Kind::incipientSlip), 1);
    ASSERT_EQ(eventsOf(GelEvent::Kind::slip), 1);
    const auto incipient = std::ranges::find(m_events, GelEvent::Kind::incipientSlip, &GelEvent::kind);
    const auto slip = std::ranges::find(m_events, GelEvent::Kind::slip, &GelEvent::kind);
    EXPECT_LT(incipient->time_s, slip->time_s);
    EXPECT_GT(slip->slipIndex.value_or(0.0), incipient->slipIndex.value_or(1.0));
    EXPECT_EQ(slip->contact, incipient->contact);
}

TEST_F(LiveGel, aPersonRenewsTheRest) {
    show({}, kRest);
    show(kDragged);
    m_channel->renewReference();
    show(kDragged, kRest);
    EXPECT_EQ(eventsOf(GelEvent::Kind::reference), 2);
    EXPECT_TRUE(snapshot().contacts.empty());
}

TEST_F(LiveGel, tellsACoveredCameraAJumpOfLightAndATornGel) {
    show({}, kRest);
    give(core::greyImageOf(cv::Mat1b(240, 320, std::uint8_t{0})));
    give(core::greyImageOf(cv::Mat1b(240, 320, std::uint8_t{0})));
    EXPECT_EQ(eventsOf(GelEvent::Kind::dark), 1);
    EXPECT_FALSE(snapshot().usable);
    EXPECT_EQ(snapshot().unusable, 2U);
    EXPECT_FALSE(snapshot().problem.empty());
    show({}, 30);
    EXPECT_TRUE(snapshot().usable);
    const long jumps = eventsOf(GelEvent::Kind::lightJump);
    m_renderer.setLight(1.5);
    show();
    EXPECT_EQ(eventsOf(GelEvent::Kind::lightJump), jumps + 1);
    EXPECT_FALSE(snapshot().problem.empty());
    m_renderer.setLight(1.0);
    show({}, 2);
    cv::Mat1b torn;
    m_renderer.draw(m_renderer.rest_px(), torn);
    torn.colRange(0, 150).setTo(130);
    for (int i = 0; i < 30; ++i)
        give(core::greyImageOf(torn.clone()));
    EXPECT_EQ(eventsOf(GelEvent::Kind::torn), 1);
    give({});
    EXPECT_FALSE(snapshot().usable);
}

TEST_F(LiveGel, afterACutContactsAreNewAndTheRestHolds) {
    show({}, kRest);
    show(kDragged);
    const double before_s = snapshot().time_s;
    m_capture_s = 0.0; // a camera that was connected again counts anew
    give(drawn(kDragged), true);
    EXPECT_EQ(eventsOf(GelEvent::Kind::restart), 1);
    EXPECT_EQ(eventsOf(GelEvent::Kind::ends), 1) << "the contact before the cut";
    EXPECT_GT(snapshot().time_s, before_s);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    EXPECT_EQ(snapshot().contacts.front().id, 2);
    EXPECT_EQ(eventsOf(GelEvent::Kind::reference), 1);
}

TEST_F(LiveGel, aPictureThatHasWaitedTooLongIsPassedOverAndCounted) {
    show({}, kRest);
    const auto push = [&](double age_s) {
        m_camera->push({.image = drawn({}),
                        .time_ns = core::steadyNow_ns() - static_cast<std::int64_t>(age_s * 1e9),
                        .capture_s = m_capture_s += 0.04});
    };
    push(3.0);
    push(2.0);
    push(1.0);
    for (int i = 0; i < 20'000 && snapshot().frame < kRest + 2U; ++i) {
        std::this_thread::sleep_for(1ms);
        m_channel->update();
    }
    // The newest one is shown, however old it is. When it comes while an older one is worked on, that one is
    // the newest then.
    EXPECT_EQ(snapshot().frame, kRest + 2U);
    EXPECT_EQ(snapshot().processed + snapshot().passedOver, kRest + 3U);
}

TEST_F(LiveGel, showsOnlyThePartThatTheFileNames) {
    vision::MarkerGelFile file = gelFile();
    file.grid = vision::MarkerGrid::free;
    file.crop = {160.0, 0.0, 160.0, 240.0};
    file.flipX = true;
    m_channel->stop();
    open(file);
    show({}, kRest);
    EXPECT_EQ(snapshot().image.width_px, 160);
    EXPECT_EQ(snapshot().image.height_px, 240);
    EXPECT_EQ(snapshot().markers.size(), 40U);
    // The camera is exchanged for a smaller one.
    give(core::greyImageOf(cv::Mat1b(100, 100, std::uint8_t{50})));
    EXPECT_FALSE(snapshot().usable);
    EXPECT_NE(snapshot().problem.find("100 x 100"), std::string::npos) << snapshot().problem;
}

TEST_F(LiveGel, recordsPicturesRestContactsAndEvents) {
    show({}, kRest);
    const auto sink = std::make_shared<Sink>();
    m_channel->watch(pipeline::Watcher::plot, sink, "finger");
    show();
    show(kDragged, 2);
    show();
    ASSERT_EQ(sink->infos.size(), 3U);
    EXPECT_EQ(sink->infos[0].name, "finger-reference");
    EXPECT_EQ(sink->infos[1].name, "finger-camera");
    EXPECT_EQ(sink->infos[2].name, "finger-contacts");
    EXPECT_EQ(sink->infos[1].source, "left finger");
    const auto references = sink->frames(0);
    ASSERT_EQ(references.size(), 1U);
    EXPECT_EQ(references[0].image.height_px, 240 * kRest);
    const auto pictures = pipeline::unstackedReference(references[0].image, 320, 240);
    EXPECT_EQ(pictures.size(), static_cast<std::size_t>(kRest));
    EXPECT_TRUE(pipeline::unstackedReference(references[0].image, 320, 241).empty());
    EXPECT_EQ(sink->frames(1).size(), 4U);
    const auto contacts = sink->frames(2);
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_EQ(contacts[0].values.size(), pipeline::kGelContactValues * sizeof(double));
    ASSERT_EQ(sink->events.size(), 2U);
    EXPECT_EQ(sink->events[0].kind, recording::kContactBegins);
    EXPECT_EQ(sink->events[1].kind, recording::kContactEnds);
    EXPECT_EQ(sink->events[1].value, 1.0);
}

TEST_F(LiveGel, beginsWithTheRestThatARecordingHas) {
    const std::vector<core::GreyImage> quiet{drawn({}), drawn({}), drawn({})};
    m_rest = pipeline::stackedReference(quiet);
    m_channel->stop();
    open(gelFile());
    give({}); // a picture that cannot be decoded takes no rest away
    EXPECT_FALSE(snapshot().hasReference());
    show(kDragged);
    EXPECT_TRUE(snapshot().hasReference());
    EXPECT_EQ(eventsOf(GelEvent::Kind::reference), 1);
    EXPECT_EQ(snapshot().contacts.size(), 1U);
    // Another one comes with a picture of the recording.
    const std::vector<core::GreyImage> moved{drawn(kDragged), drawn(kDragged)};
    const std::uint64_t before = m_channel->framesProcessed();
    m_camera->push({.image = drawn(kDragged),
                    .time_ns = core::steadyNow_ns(),
                    .capture_s = m_capture_s += 0.04,
                    .reference = pipeline::stackedReference(moved)});
    for (int i = 0; i < 20'000 && snapshot().processed <= before; ++i) {
        std::this_thread::sleep_for(1ms);
        m_channel->update();
    }
    EXPECT_TRUE(snapshot().contacts.empty());
    GelEvent event;
    while (m_channel->popEvent(event))
        m_events.push_back(event);
    EXPECT_EQ(eventsOf(GelEvent::Kind::ends), 1);
}

TEST_F(LiveGel, tellsARestThatShowsNoGelAndTakesTheFirstPictures) {
    m_rest = core::greyImageOf(cv::Mat1b(240, 320, std::uint8_t{0}));
    m_channel->stop();
    open(gelFile());
    show();
    EXPECT_NE(snapshot().problem.find("black"), std::string::npos) << snapshot().problem;
    show();
    EXPECT_NE(snapshot().problem.find("black"), std::string::npos) << "as long as it holds";
    show({}, kRest - 2);
    EXPECT_TRUE(snapshot().hasReference());
    EXPECT_TRUE(snapshot().problem.empty()) << snapshot().problem;
}

TEST_F(LiveGel, tellsARestOfAnotherSize) {
    m_rest = core::greyImageOf(cv::Mat1b(100, 100, std::uint8_t{50}));
    m_channel->stop();
    open(gelFile());
    show({}, 2);
    EXPECT_NE(snapshot().problem.find("another size"), std::string::npos) << snapshot().problem;
}

TEST(RecordedGel, unstacksOnlyWhatWasStacked) {
    EXPECT_TRUE(pipeline::stackedReference({}).isEmpty());
    const std::vector<core::GreyImage> unlike{core::greyImageOf(cv::Mat1b(2, 3, std::uint8_t{1})),
                                              core::greyImageOf(cv::Mat1b(3, 3, std::uint8_t{1}))};
    EXPECT_TRUE(pipeline::stackedReference(unlike).isEmpty());
    const std::vector<core::GreyImage> alike{core::greyImageOf(cv::Mat1b(2, 3, std::uint8_t{1})),
                                             core::greyImageOf(cv::Mat1b(2, 3, std::uint8_t{9}))};
    const auto again = pipeline::unstackedReference(pipeline::stackedReference(alike), 3, 2);
    ASSERT_EQ(again.size(), 2U);
    EXPECT_EQ(again[1].pixels.get()[5], 9);
    EXPECT_TRUE(pipeline::unstackedReference(pipeline::stackedReference(alike), 2, 3).empty());
    EXPECT_TRUE(pipeline::unstackedReference({}, 3, 2).empty());
}
