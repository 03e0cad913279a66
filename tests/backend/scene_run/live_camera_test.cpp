// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/camera_frame_queue.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/scene_run/camera/scene_reaction.h"
#include "backend/simulation/camera/tube_camera.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

using namespace teleta;
using namespace std::chrono_literals;
using pipeline::CameraChannel;
using pipeline::CameraEvent;
using pipeline::CarrierReport;

namespace {

/// A camera whose frames come when the test says so.
class SteppedCamera : public core::CameraSource {
public:
    explicit SteppedCamera(std::unique_ptr<core::CameraGenerator> generator)
        : m_generator(std::move(generator)) {}
    [[nodiscard]] const core::CameraDescription& description() const override {
        return m_generator->description();
    }
    void start(core::Wakeup& consumer) override { m_consumer = &consumer; }
    void stop() override {}
    bool pop(core::CameraFrame& frame) override { return m_frames.pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }

    /// Makes so many frames and hands them over together.
    void step(int frames, bool held = false, bool damaged = false) {
        for (int i = 0; i < frames; ++i) {
            core::CameraFrame frame;
            frame.discontinuity = m_generator->next(frame.image, held) || m_cut;
            m_cut = false;
            if (damaged)
                frame.image = {};
            frame.capture_s = m_generator->time_s();
            const double clock_s = frame.capture_s + m_clock_s;
            frame.time_ns = m_keepsTime ? core::steadyNow_ns()
                                        : m_start_ns + static_cast<std::int64_t>(frame.capture_s * 1e9);
            frame.capture_s = clock_s;
            frame.number = m_number++;
            m_frames.push(std::move(frame));
        }
        m_consumer->notify();
    }
    void cut() { m_cut = true; }
    /// Of its own clock.
    void beginAt(double time_s) { m_clock_s = time_s; }
    /// From now on frames are as old as they are, and a silence counts.
    void keepTime() { m_keepsTime = true; }

private:
    std::unique_ptr<core::CameraGenerator> m_generator;
    core::CameraFrameQueue m_frames{8}; ///< as the devices'; a slow finder lets it run over
    core::Wakeup* m_consumer = nullptr;
    std::uint64_t m_number = 0;
    /// However slowly the test goes, no frame is late.
    std::int64_t m_start_ns = core::steadyNow_ns() + 3'600'000'000'000;
    double m_clock_s = 0.0;
    bool m_cut = false;
    bool m_keepsTime = false;
};

scene::Scene smallScene(const scene::Reaction& reaction, std::vector<scene::FingerKeyframe> keyframes) {
    scene::Scene scene = test::smallCameraScene(false);
    scene::CameraWorld& world = std::get<scene::CameraWorld>(scene.world);
    world.skin.dragPerDepth = 0.3;
    scene::Finger finger;
    finger.name = "finger";
    finger.keyframes = std::move(keyframes);
    world.fingers.push_back(finger);
    world.reaction = reaction;
    scene.duration_s = finger.keyframes.back().time_s;
    return scene;
}

class LiveCamera : public testing::Test {
protected:
    void open(const scene::Scene& scene) {
        auto made = simulation::makeTubeCamera(scene, 1, m_link);
        ASSERT_TRUE(made);
        const scene::CameraWorld& world = scene.camera();
        auto source = std::make_unique<SteppedCamera>(std::move(made->generator));
        m_source = source.get();
        std::unique_ptr<pipeline::CameraReaction> reaction;
        if (!std::holds_alternative<scene::NoReaction>(world.reaction))
            reaction = std::make_unique<scene_run::SceneReaction>(world, 1.0 / scene.rate_Hz, m_link);
        auto channel = CameraChannel::make(std::move(source), made->camera, m_stop, std::move(reaction),
                                           {.tracker = scene_run::trackerSettings(world), .contacts = {}});
        ASSERT_TRUE(channel);
        m_channel = *channel;
        m_channel->start();
    }
    /// Lets frames come one by one, each after the one before was worked on.
    void run(int frames, bool held = false, bool damaged = false) {
        for (int i = 0; i < frames; ++i) {
            const std::uint64_t before = m_channel->framesProcessed();
            m_source->step(1, held, damaged);
            ASSERT_TRUE(processed(before + 1));
            m_channel->update();
            CameraEvent event;
            while (m_channel->popEvent(event))
                m_events.push_back(event);
        }
    }
    bool processed(std::uint64_t frames) {
        for (int i = 0; i < 20'000 && m_channel->framesProcessed() < frames; ++i)
            std::this_thread::sleep_for(1ms);
        // The count goes up before the snapshot is there.
        return comesTo([frames](const pipeline::CameraSnapshot& now) { return now.processed >= frames; });
    }
    /// Waits for a snapshot, without new frames.
    template <typename Condition>
    bool comesTo(Condition condition) {
        for (int i = 0; i < 20'000 && !condition(snapshot()); ++i) {
            std::this_thread::sleep_for(1ms);
            m_channel->update();
        }
        return condition(snapshot());
    }
    [[nodiscard]] const pipeline::CameraSnapshot& snapshot() const { return m_channel->snapshot(); }
    [[nodiscard]] long eventsOf(CameraEvent::Kind kind) const {
        return std::ranges::count(m_events, kind, &CameraEvent::kind);
    }

    core::StopSwitch m_stop;
    std::shared_ptr<simulation::CarrierLink> m_link = std::make_shared<simulation::CarrierLink>();
    SteppedCamera* m_source = nullptr;
    std::shared_ptr<CameraChannel> m_channel;
    std::vector<CameraEvent> m_events;
};

/// A tool that pokes at 50 mm/s, 3 mm deep if nothing gives way.
scene::Scene poke() {
    return smallScene(scene::BumpReaction{},
                      {{0.0, 0.8, 0.03, -0.015}, {0.36, 0.8, 0.03, 0.003}, {2.0, 0.8, 0.03, 0.003}});
}

/// A finger that goes round the tube by a radian.
scene::Scene leadRound() {
    return smallScene(scene::FollowReaction{.gain_perS = 10.0}, {{0.0, 0.4, 0.03, -0.003},
                                                                 {0.4, 0.4, 0.03, 0.0012},
                                                                 {0.6, 0.4, 0.03, 0.0012},
                                                                 {1.8, 1.4, 0.03, 0.0012},
                                                                 {2.6, 1.4, 0.03, 0.0012}});
}

} // namespace

TEST_F(LiveCamera, drawsBackFromABumpByTheSceneSWayAlongTheInwardNormal) {
    open(poke());
    run(60);
    EXPECT_EQ(eventsOf(CameraEvent::Kind::reference), 1);
    EXPECT_EQ(eventsOf(CameraEvent::Kind::bumps), 1);
    ASSERT_TRUE(snapshot().carrier);
    const Eigen::Vector3d way_m = snapshot().carrier->X_Base_Sensor.translation();
    EXPECT_NEAR(way_m.norm(), 0.030, 0.0003);
    // Away from the tool, which comes from 0.8 rad.
    EXPECT_LT(std::abs(std::remainder(std::atan2(way_m.y(), way_m.x()) - (0.8 + std::numbers::pi),
                                      2.0 * std::numbers::pi)),
              0.05);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::stands);
}

TEST_F(LiveCamera, followsAFingerRoundTheTube) {
    open(leadRound());
    run(100);
    EXPECT_EQ(eventsOf(CameraEvent::Kind::follows), 1);
    ASSERT_TRUE(snapshot().carrier);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::follows);
    const Eigen::Matrix3d& turn = snapshot().carrier->X_Base_Sensor.linear();
    EXPECT_NEAR(std::atan2(turn(1, 0), turn(0, 0)), 1.0, 0.05);
}

TEST_F(LiveCamera, stopHoldsTheArmUntilItIsAllowedAgain) {
    open(leadRound());
    run(40);
    m_stop.engage();
    run(8, true);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::held);
    EXPECT_FALSE(snapshot().mayReact);
    const Eigen::Matrix3d stopped = m_channel->snapshot().carrier->X_Base_Sensor.linear();
    m_stop.release();
    run(8);
    EXPECT_FALSE(snapshot().mayReact) << "releasing STOP lets nothing move";
    EXPECT_EQ(snapshot().carrier->X_Base_Sensor.linear(), stopped);
    m_channel->setMayReact(true);
    run(8);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::follows);
    EXPECT_NE(snapshot().carrier->X_Base_Sensor.linear(), stopped);
}

TEST_F(LiveCamera, aStopThatNoFrameSawTakesThePermissionAway) {
    open(leadRound());
    run(1);
    m_stop.engage();
    m_channel->setMayReact(true);
    m_stop.release();
    run(1);
    EXPECT_FALSE(snapshot().mayReact) << "while STOP is engaged nothing is allowed";
    m_channel->setMayReact(true);
    run(1);
    EXPECT_TRUE(snapshot().mayReact);
    m_stop.engage();
    m_stop.release();
    run(1);
    EXPECT_FALSE(snapshot().mayReact);
}

TEST_F(LiveCamera, aRetreatThatStopBrokeOffIsForgottenAlsoWhenNoFrameCouldBeUsedMeanwhile) {
    open(poke());
    for (int i = 0; i < 40 && eventsOf(CameraEvent::Kind::bumps) == 0; ++i)
        run(1);
    run(1);
    ASSERT_EQ(snapshot().carrier->doing, CarrierReport::Doing::retreats);
    m_stop.engage();
    run(12, true, true);
    const Eigen::Vector3d stopped_m = snapshot().carrier->X_Base_Sensor.translation();
    EXPECT_LT(stopped_m.norm(), 0.025);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::held);
    m_stop.release();
    m_channel->setMayReact(true);
    run(8);
    EXPECT_EQ(snapshot().carrier->X_Base_Sensor.translation(), stopped_m);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::stands);
}

TEST_F(LiveCamera, withoutFramesOrWithNoneThatCanBeUsedTheArmIsHeldAndGoesOnAfterwards) {
    open(leadRound());
    run(40);
    ASSERT_EQ(snapshot().carrier->doing, CarrierReport::Doing::follows);
    run(12, false, true); // 0.3 s
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::held);
    run(8);
    EXPECT_EQ(snapshot().carrier->doing, CarrierReport::Doing::follows);
    m_source->keepTime();
    run(1);
    const std::uint64_t frames = snapshot().processed;
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) {
        return now.carrier->doing == CarrierReport::Doing::held;
    }));
    EXPECT_TRUE(snapshot().mayReact);
    m_stop.engage();
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) { return !now.mayReact; }));
    EXPECT_EQ(snapshot().processed, frames) << "there was no frame";
}

TEST_F(LiveCamera, theNewestFrameWinsAndTheOthersAreCounted) {
    open(poke());
    run(1);
    m_source->step(20);
    for (int i = 0; i < 20'000 && snapshot().frame < 20; ++i) {
        std::this_thread::sleep_for(1ms);
        m_channel->update();
    }
    EXPECT_EQ(snapshot().frame, 20U);
    EXPECT_EQ(snapshot().processed - 1 + snapshot().passedOver, 20U);
}

TEST_F(LiveCamera, aFrameThatDoesNotDecodeIsToldAndThePictureStays) {
    open(poke());
    run(2);
    const auto* shown = snapshot().image.pixels.get();
    ASSERT_NE(shown, nullptr);
    run(1, false, true);
    EXPECT_FALSE(snapshot().usable);
    EXPECT_EQ(snapshot().problem, "The frame could not be decoded.");
    EXPECT_EQ(snapshot().unusable, 1U);
    EXPECT_EQ(snapshot().image.pixels.get(), shown);
    run(1);
    EXPECT_TRUE(snapshot().usable);
    EXPECT_TRUE(snapshot().problem.empty());
}

TEST_F(LiveCamera, aDamagedFirstFrameIsNoReferenceAndTheNextOneIs) {
    open(poke());
    run(1, false, true);
    EXPECT_FALSE(snapshot().hasReference);
    run(1);
    EXPECT_TRUE(snapshot().hasReference);
}

TEST_F(LiveCamera, anotherRungGoesOnWithTheSameContacts) {
    scene::Scene scene = poke();
    std::get<scene::CameraWorld>(scene.world).reaction = scene::NoReaction{};
    open(scene);
    run(30);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    const int id = snapshot().contacts.front().contact.id;
    EXPECT_EQ(snapshot().rung, "dots");
    m_channel->chooseRung("no such rung");
    run(2);
    EXPECT_EQ(snapshot().rung, "dots");
    m_channel->chooseRung("fast-1");
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) { return now.nextRung == "fast-1"; }));
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) { return now.rung == "fast-1"; }));
    EXPECT_TRUE(snapshot().nextRung.empty());
    EXPECT_TRUE(snapshot().refusedRung.empty());
    run(2);
    // Dense flow sees more than the dots do in so small an image; the contact is still the same one.
    EXPECT_TRUE(std::ranges::any_of(snapshot().contacts, [id](const vision::FollowedContact& followed) {
        return followed.contact.id == id && followed.seen;
    }));
    EXPECT_GT(snapshot().stage_ns[1], 0);
}

TEST_F(LiveCamera, aRungThatIsRefusedIsToldUntilAnotherOneIsAskedFor) {
    scene::Scene scene = poke();
    scene::CameraWorld& world = std::get<scene::CameraWorld>(scene.world);
    world.reaction = scene::NoReaction{};
    world.camera.width_px = 410;
    world.camera.height_px = 200;
    world.camera.focalLength_px = 147.0;
    open(scene);
    run(2);
    m_channel->chooseRung("fast-3.2");
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) { return !now.refusedRung.empty(); }));
    EXPECT_EQ(snapshot().rung, "dots");
    EXPECT_NE(snapshot().whyRefused.find("too small"), std::string::npos) << snapshot().whyRefused;
    EXPECT_TRUE(snapshot().usable);
    EXPECT_TRUE(snapshot().problem.empty()) << "every frame is used";
    m_channel->chooseRung("dots");
    EXPECT_TRUE(comesTo([](const pipeline::CameraSnapshot& now) { return now.refusedRung.empty(); }));
    EXPECT_TRUE(snapshot().whyRefused.empty());
}

TEST_F(LiveCamera, vectorsAndContactsLieOnTheSkinAndCarryAStandardDeviation) {
    open(poke());
    run(18);
    ASSERT_GT(snapshot().vectors.size(), 100U);
    double near_m = 0.0;
    double far_m = 0.0;
    for (const pipeline::SkinVector& vector : snapshot().vectors) {
        EXPECT_NEAR(vector.p_Sensor_m.head<2>().norm(), 0.025, 1e-9);
        EXPECT_NEAR(vector.p_Sensor_m.head<2>().dot(vector.displacement_m.head<2>()), 0.0, 1e-9);
        ASSERT_GT(vector.sd_m, 0.0);
        if (vector.p_Sensor_m.z() < 0.02)
            near_m = std::max(near_m, vector.sd_m);
        if (vector.p_Sensor_m.z() > 0.08)
            far_m = std::max(far_m, vector.sd_m);
    }
    EXPECT_GT(far_m, 2.0 * near_m) << "it grows toward the far end";
    ASSERT_EQ(snapshot().covariances_m2.size(), snapshot().contacts.size());
}

TEST_F(LiveCamera, aCutInTheStreamBeginsContactsAnewAndTimeGoesOn) {
    scene::Scene scene = poke();
    std::get<scene::CameraWorld>(scene.world).reaction = scene::NoReaction{};
    open(scene);
    run(30);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    const int id = snapshot().contacts.front().contact.id;
    const double before_s = snapshot().time_s;
    m_source->cut();
    run(1);
    EXPECT_GT(snapshot().time_s, before_s);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    EXPECT_GT(snapshot().contacts.front().contact.id, id);
    EXPECT_EQ(eventsOf(CameraEvent::Kind::restart), 1);
}

TEST_F(LiveCamera, aRecordingHasTheReferenceOnTheClockOfThePictures) {
    ASSERT_NO_FATAL_FAILURE(open(smallScene({}, {{0.0, 0.0, 0.02, 0.0}, {1.0, 0.0, 0.02, 0.0}})));
    m_source->beginAt(100.0);
    run(3);
    const auto taps = std::make_shared<pipeline::CameraTaps>(
        pipeline::CameraTaps{std::make_shared<core::StreamTap>(8), std::make_shared<core::StreamTap>(8),
                             std::make_shared<core::StreamTap>(8), [](const CameraEvent&, std::int64_t) {}});
    m_channel->record(taps);
    run(1);
    core::TappedFrames picture;
    core::TappedFrames reference;
    ASSERT_TRUE(taps->pictures->pop(picture));
    ASSERT_TRUE(taps->reference->pop(reference));
    // It was in use from the frame before on.
    EXPECT_LT(reference.sourceTime_s[0], picture.sourceTime_s[0]);
    EXPECT_NEAR(reference.sourceTime_s[0], picture.sourceTime_s[0], 0.1);
}

TEST_F(LiveCamera, aNewReferenceForgetsWhatPressesNow) {
    scene::Scene scene = poke();
    std::get<scene::CameraWorld>(scene.world).reaction = scene::NoReaction{};
    open(scene);
    run(30);
    ASSERT_EQ(snapshot().contacts.size(), 1U);
    m_channel->renewReference();
    run(3);
    EXPECT_TRUE(snapshot().contacts.empty());
    EXPECT_EQ(eventsOf(CameraEvent::Kind::reference), 2);
}

TEST(CameraChannel, isClosedWhileARungIsMadeReadyWithoutWaitingForTheWholeImage) {
    auto made = simulation::makeTubeCamera(poke(), 1, std::make_shared<simulation::CarrierLink>());
    ASSERT_TRUE(made);
    constexpr int kLarger = 15; // 114 million pixels, each of which takes about a microsecond
    vision::CameraParameters parameters = made->camera.camera().parameters();
    parameters.width_px *= kLarger;
    parameters.height_px *= kLarger;
    parameters.fx_px *= kLarger;
    parameters.fy_px *= kLarger;
    parameters.cx_px *= kLarger;
    parameters.cy_px *= kLarger;
    const auto model = vision::CameraModel::create(parameters);
    ASSERT_TRUE(model);
    auto source = std::make_unique<SteppedCamera>(std::move(made->generator));
    SteppedCamera& camera = *source;
    const core::StopSwitch stop;
    const auto channel = CameraChannel::make(std::move(source), {*model, made->camera.surface()}, stop);
    ASSERT_TRUE(channel);
    (*channel)->start();
    camera.step(1, false, true);
    (*channel)->chooseRung("medium-1");
    for (int i = 0; i < 20'000 && (*channel)->snapshot().nextRung.empty(); ++i) {
        std::this_thread::sleep_for(1ms);
        (*channel)->update();
    }
    ASSERT_EQ((*channel)->snapshot().nextRung, "medium-1");
    const std::int64_t begin_ns = core::steadyNow_ns();
    (*channel)->stop();
    constexpr double kGenerous_s = 20.0;
    EXPECT_LT(static_cast<double>(core::steadyNow_ns() - begin_ns) * 1e-9, kGenerous_s);
}

TEST(CameraChannel, refusesACameraTooSmallForItsDots) {
    scene::Scene scene = poke();
    std::get<scene::CameraWorld>(scene.world).camera.width_px = 40;
    std::get<scene::CameraWorld>(scene.world).camera.height_px = 40;
    auto made = simulation::makeTubeCamera(scene, 1, std::make_shared<simulation::CarrierLink>());
    ASSERT_TRUE(made);
    core::StopSwitch stop;
    const auto channel =
        CameraChannel::make(std::make_unique<SteppedCamera>(std::move(made->generator)), made->camera, stop);
    ASSERT_FALSE(channel);
    EXPECT_NE(channel.error().message.find("too small"), std::string::npos);
}
