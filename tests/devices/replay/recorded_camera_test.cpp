// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/recorded_device.h"
#include "tests/backend/recording/recorded_files.h"
#include "tests/devices/manual_clock.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

constexpr std::int64_t kStart_ns = 5'000'000'000;
constexpr std::int64_t kTenth_ns = 100'000'000;

class RecordedCameraTest : public testing::Test {
protected:
    RecordedCameraTest() { makeApplication(); }
    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    TemporaryFolder m_folder;
    std::shared_ptr<ManualClock> m_clock = std::make_shared<ManualClock>();
    core::Wakeup m_wakeup;
};

core::CameraFrame greyPicture(int level, std::int64_t time_ns) {
    std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[6]);
    std::fill_n(pixels.get(), 6, static_cast<std::uint8_t>(level));
    return {.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels.get()), 3, 2},
            .time_ns = time_ns,
            .capture_s = static_cast<double>(time_ns - kStart_ns) * 1e-9};
}

/// Four pictures at 10 Hz, all grey, ten times the number of each its grey level; and two references, the
/// second with the third picture.
void writePictures(const std::string& path) {
    StreamInfo info;
    info.name = "camera";
    info.kind = StreamKind::camera;
    info.type = ValueType::grey8;
    info.shape = {2, 3};
    auto recorder = Recorder::start(path, headAt(kStart_ns), {.simulatedTime = true}).value();
    const auto tap = recorder->addStream(info);
    for (int i = 0; i < 4; ++i)
        tap->append(greyPicture(10 * i, kStart_ns + i * kTenth_ns));
    info.name = "reference";
    const auto references = recorder->addStream(info);
    references->append(greyPicture(100, kStart_ns));
    references->append(greyPicture(120, kStart_ns + 2 * kTenth_ns));
    ASSERT_TRUE(recorder->stop());
}

} // namespace

TEST_F(RecordedCameraTest, aCameraIsPlayedPictureByPicture) {
    writePictures(path());
    replay::RecordedConfig config;
    config.path = path();
    config.camera = core::CameraDescription{.name = "tube", .nominalRate_Hz = 10.0, .recorded = true};
    config.clock = m_clock;
    auto player = replay::RecordedPlayer::open(config);
    ASSERT_TRUE(player) << core::describe(player.error());
    replay::RecordedCamera camera(*player);
    camera.start(m_wakeup);
    m_clock->settle();
    std::vector<int> levels;
    std::vector<core::CameraFrame> frames;
    const auto takeAll = [&] {
        core::CameraFrame frame;
        while (camera.pop(frame)) {
            levels.push_back(frame.image.pixels.get()[5]);
            frames.push_back(frame);
        }
    };
    takeAll();
    EXPECT_EQ(levels, std::vector<int>{0});
    m_clock->advance(kTenth_ns);
    m_clock->advance(kTenth_ns);
    takeAll();
    EXPECT_EQ(levels, (std::vector<int>{0, 10, 20}));
    EXPECT_TRUE(frames[0].discontinuity);
    EXPECT_FALSE(frames[1].discontinuity);
    EXPECT_EQ(frames[2].time_ns - frames[1].time_ns, kTenth_ns);
    EXPECT_NEAR(frames[2].capture_s, 0.2, 1e-9);
    EXPECT_EQ(frames[2].number, 2U);
    EXPECT_EQ(camera.status().state, core::DeviceState::live);
    m_clock->advance(kTenth_ns);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return camera.status().state == core::DeviceState::finished; }));
    ASSERT_NE(camera.playback(), nullptr);
    camera.playback()->seek(0.1);
    EXPECT_TRUE(eventually(m_wakeup, [&] {
        takeAll();
        return levels.back() == 10;
    })) << "a picture is shown although the playback is paused";
    EXPECT_TRUE(frames.back().discontinuity);
    camera.stop();
    EXPECT_EQ(camera.status().state, core::DeviceState::closed);
}

TEST_F(RecordedCameraTest, aPictureBringsItsReferenceWhereThatChanges) {
    writePictures(path());
    replay::RecordedConfig config;
    config.path = path();
    config.camera = core::CameraDescription{.name = "tube", .nominalRate_Hz = 10.0, .recorded = true};
    config.referenceStream = 1;
    config.clock = m_clock;
    replay::RecordedCamera camera(replay::RecordedPlayer::open(config).value());
    std::vector<int> levels;
    const auto takeAll = [&] {
        core::CameraFrame frame;
        while (camera.pop(frame))
            levels.push_back(frame.reference.isEmpty() ? 0 : frame.reference.pixels.get()[0]);
        return levels;
    };
    camera.start(m_wakeup);
    m_clock->settle();
    for (int i = 0; i < 3; ++i)
        m_clock->advance(kTenth_ns);
    EXPECT_EQ(takeAll(), (std::vector<int>{0, 0, 120, 0})) << "whoever plays it begins with the first one";
    EXPECT_TRUE(eventually(m_wakeup, [&] { return camera.status().state == core::DeviceState::finished; }));
    camera.seek(0.1);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return takeAll().size() == 5; }));
    EXPECT_EQ(levels.back(), 100);
    camera.seek(0.3);
    EXPECT_TRUE(eventually(m_wakeup, [&] { return takeAll().size() == 6; }));
    EXPECT_EQ(levels.back(), 120);
    camera.stop();
}
