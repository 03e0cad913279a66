// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/device/camera_frame_queue.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/pipeline/scene_camera_channel.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace teleta {
namespace {

using pipeline::SceneCameraChannel;

/// A camera whose pictures come when the test says so.
class ScriptedCamera : public core::CameraSource {
public:
    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& /*consumer*/) override {}
    void stop() override { stopped = true; }
    bool pop(core::CameraFrame& frame) override { return m_frames.pop(frame); }
    [[nodiscard]] core::DeviceStatus status() const override { return {}; }

    void push(core::GreyImage image) {
        core::CameraFrame frame;
        frame.image = std::move(image);
        frame.number = m_number++;
        frame.time_ns = 1'000'000'000 + static_cast<std::int64_t>(frame.number) * 40'000'000;
        frame.capture_s = 0.04 * static_cast<double>(frame.number);
        m_frames.push(std::move(frame));
    }
    bool stopped = false;

private:
    core::CameraDescription m_description{
        .name = "front", .nominalRate_Hz = 25.0, .simulated = false, .recorded = false};
    core::CameraFrameQueue m_frames{200};
    std::uint64_t m_number = 0;
};

using Bytes = std::vector<std::uint8_t>;

core::ColourImage imageOf(const Bytes& bytes, int width_px, int height_px) {
    const auto kept = std::make_shared<const Bytes>(bytes);
    return {{kept, kept->data()}, width_px, height_px};
}

/// Two pixels, one above the other; the first begins with a number.
core::GreyImage numbered(std::uint8_t number) {
    return core::bytesOf(imageOf({number, 10, 20, 30, 40, 50}, 1, 2));
}

class LookingCamera : public testing::Test {
protected:
    ScriptedCamera* m_camera = new ScriptedCamera;
    std::shared_ptr<SceneCameraChannel> m_channel =
        std::make_shared<SceneCameraChannel>(std::unique_ptr<core::CameraSource>(m_camera));
};

} // namespace

TEST(ColourImage, theBytesOfAFrameAreThoseOfThePicture) {
    const core::ColourImage image = imageOf({1, 2, 3, 4, 5, 6}, 2, 1);
    const core::GreyImage bytes = core::bytesOf(image);
    EXPECT_EQ(bytes.width_px, 6);
    EXPECT_EQ(bytes.height_px, 1);
    EXPECT_EQ(bytes.pixels.get(), image.pixels.get()) << "nothing is copied";
    const core::ColourImage again = core::colourOf(bytes);
    EXPECT_EQ(again.width_px, 2);
    EXPECT_EQ(again.pixels.get(), image.pixels.get());
    EXPECT_TRUE(core::colourOf({image.pixels, 5, 1}).isEmpty());
    EXPECT_TRUE(core::colourOf({}).isEmpty());
}

TEST_F(LookingCamera, theNewestPictureWinsAndIsNotCopied) {
    EXPECT_EQ(m_channel->process(), 0U);
    EXPECT_FALSE(m_channel->update());
    core::GreyImage last;
    for (std::uint8_t i = 0; i < 5; ++i)
        m_camera->push(last = numbered(i));
    EXPECT_EQ(m_channel->process(), 5U);
    EXPECT_TRUE(m_channel->update());
    EXPECT_FALSE(m_channel->update());
    const pipeline::SceneCameraSnapshot& shown = m_channel->snapshot();
    EXPECT_EQ(shown.image.pixels.get(), last.pixels.get());
    EXPECT_EQ(shown.image.width_px, 1);
    EXPECT_EQ(shown.image.height_px, 2);
    EXPECT_EQ(shown.frame, 4U);
    EXPECT_EQ(shown.pictures, 5U);
    EXPECT_EQ(shown.time_ns, 1'160'000'000);
    EXPECT_DOUBLE_EQ(shown.capture_s, 0.16);
    EXPECT_EQ(m_channel->framesProcessed(), 5U);
}

TEST_F(LookingCamera, aFrameWithoutAPictureLeavesTheLastOneAndIsCounted) {
    m_camera->push(numbered(9));
    m_camera->push({});
    m_camera->push({numbered(1).pixels, 4, 1}); // no whole number of pixels
    EXPECT_EQ(m_channel->process(), 3U);
    ASSERT_TRUE(m_channel->update());
    EXPECT_EQ(m_channel->snapshot().image.pixels.get()[0], 9);
    EXPECT_EQ(m_channel->snapshot().frame, 0U);
    EXPECT_EQ(m_channel->snapshot().pictures, 1U);
    EXPECT_EQ(m_channel->snapshot().undecodable, 2U);
}

TEST_F(LookingCamera, oneThatIsFasterThanItsReaderHoldsUpNobody) {
    for (int i = 0; i < 100; ++i)
        m_camera->push(numbered(static_cast<std::uint8_t>(i)));
    EXPECT_LT(m_channel->process(), 100U);
    while (m_channel->process() > 0) {
    }
    ASSERT_TRUE(m_channel->update());
    EXPECT_EQ(m_channel->snapshot().frame, 99U);
}

TEST_F(LookingCamera, stopsItsSource) {
    m_channel->stop();
    EXPECT_TRUE(m_camera->stopped);
}

TEST_F(LookingCamera, everyPictureIsRecordedAndFoundAgain) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("looking.teleta").toStdString();
    {
        auto recorder = recording::Recorder::start(path, {});
        ASSERT_TRUE(recorder) << core::describe(recorder.error());
        const std::shared_ptr<recording::Recorder> shared = std::move(*recorder);
        m_channel->record(shared, "front");
        for (std::uint8_t i = 0; i < 3; ++i)
            m_camera->push(numbered(i));
        m_camera->push({});
        EXPECT_EQ(m_channel->process(), 4U);
        m_channel->record(nullptr, {});
        m_camera->push(numbered(77));
        EXPECT_EQ(m_channel->process(), 1U);
        ASSERT_TRUE(shared->stop());
    }
    const auto recording = recording::Recording::open(path);
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    const recording::StreamInfo& stream = recording->streams().front();
    EXPECT_EQ(stream.name, "front-scene");
    EXPECT_TRUE(recording::isColour(stream));
    auto reader = recording->reader(0);
    core::TappedFrames block;
    for (std::uint8_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(reader.next(block).value_or(false)) << int{i};
        EXPECT_EQ(block.time_ns.front(), 1'000'000'000 + i * 40'000'000);
        const core::ColourImage image = core::colourOf(block.image);
        ASSERT_EQ(image.width_px, 1);
        ASSERT_EQ(image.height_px, 2);
        EXPECT_EQ(Bytes(image.pixels.get(), image.pixels.get() + 6), (Bytes{i, 10, 20, 30, 40, 50}));
    }
    EXPECT_FALSE(reader.next(block).value_or(true));

    const auto sources = pipeline::recordedSources(*recording);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    EXPECT_TRUE(sources->cameras.empty());
    EXPECT_TRUE(sources->gels.empty());
    ASSERT_EQ(sources->sceneCameras.size(), 1U);
    EXPECT_EQ(sources->sceneCameras.front().description.name, "front");
    EXPECT_EQ(sources->sceneCameras.front().description.nominalRate_Hz, 25.0);
    EXPECT_TRUE(sources->sceneCameras.front().description.recorded);
    EXPECT_FALSE(sources->sceneCameras.front().description.simulated);
    EXPECT_EQ(sources->last_ns - sources->first_ns, 80'000'000);
}

} // namespace teleta
