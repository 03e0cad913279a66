// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/camera/video_stream.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/devices/camera/written_video.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace teleta::camera {
namespace {

using Outcome = VideoStream::Outcome;

constexpr int kFrames = 12;
constexpr double kRate_Hz = 25.0;

std::string content(const std::string& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

class VideoStreamTest : public testing::Test {
protected:
    test::TemporaryFolder m_folder;
    std::string m_path = m_folder.path("video.avi");
};

} // namespace

TEST_F(VideoStreamTest, readsAllFramesOfAFileInGreyWithTheirTimes) {
    ASSERT_NO_FATAL_FAILURE(test::writeVideo(m_path, kFrames, kRate_Hz));
    auto stream = VideoStream::open(m_path);
    ASSERT_TRUE(stream) << describe(stream.error());
    EXPECT_FALSE(stream->isCamera());
    EXPECT_NEAR(stream->rate_Hz(), kRate_Hz, 1e-6);
    EXPECT_EQ(stream->framesTotal(), static_cast<std::uint64_t>(kFrames));
    cv::Mat1b frame;
    double time_s = 0.0;
    for (int i = 0; i < kFrames; ++i) {
        ASSERT_EQ(stream->next(frame, time_s), Outcome::frame) << i;
        EXPECT_NEAR(time_s, i / kRate_Hz, 1e-6);
        EXPECT_NEAR(frame(110, 150), 40 + 5 * i, 4);
    }
    EXPECT_EQ(stream->next(frame, time_s), Outcome::ended);
    EXPECT_EQ(stream->framesSkipped(), 0U);
}

TEST_F(VideoStreamTest, readsColoursInTheOrderRedGreenBlue) {
    // Compressed, so that the colours are near those that were written.
    const cv::Scalar written(40, 90, 200); // blue, green, red
    cv::VideoWriter writer(m_path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kRate_Hz, {64, 48});
    ASSERT_TRUE(writer.isOpened());
    writer.write(cv::Mat(48, 64, CV_8UC3, written));
    writer.release();
    VideoStream::Options options;
    options.channel = VideoChannel::colour;
    auto stream = VideoStream::open(m_path, options);
    ASSERT_TRUE(stream) << describe(stream.error());
    cv::Mat1b frame;
    double time_s = 0.0;
    ASSERT_EQ(stream->next(frame, time_s), Outcome::frame);
    ASSERT_EQ(frame.cols, 3 * 64);
    ASSERT_EQ(frame.rows, 48);
    EXPECT_NEAR(frame(20, 3 * 30), 200, 8);
    EXPECT_NEAR(frame(20, 3 * 30 + 1), 90, 8);
    EXPECT_NEAR(frame(20, 3 * 30 + 2), 40, 8);
    const cv::Mat1b first = frame;
    EXPECT_EQ(stream->next(frame, time_s), Outcome::ended);
    EXPECT_NEAR(first(47, 3 * 63), 200, 8) << "the pixels stay with whoever has them";
}

TEST_F(VideoStreamTest, aCameraThatHangsIsWaitedForNoLongerThanItSays) {
    const char* const wait_s = std::getenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT");
    ASSERT_NE(wait_s, nullptr);
    EXPECT_EQ(wait_s, std::to_string(VideoStream::kLongestWait_s));
}

TEST_F(VideoStreamTest, countsAFrameThatCannotBeDecodedAndGoesOnAfterIt) {
    ASSERT_NO_FATAL_FAILURE(test::writeVideo(m_path, kFrames, kRate_Hz));
    std::string bytes = content(m_path);
    // The fifth picture of the file, from its start marker on, becomes zeros.
    std::size_t picture = 0;
    for (int i = 0; i < 5; ++i) {
        picture = bytes.find("\xFF\xD8\xFF", picture + 1);
        ASSERT_NE(picture, std::string::npos);
    }
    const std::size_t next = bytes.find("\xFF\xD8\xFF", picture + 1);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(picture),
              bytes.begin() + static_cast<std::ptrdiff_t>(next - 16), '\0');
    std::ofstream(m_path, std::ios::binary) << bytes;
    auto stream = VideoStream::open(m_path);
    ASSERT_TRUE(stream) << describe(stream.error());
    cv::Mat1b frame;
    double time_s = 0.0;
    std::uint64_t good = 0;
    std::uint64_t bad = 0;
    for (Outcome outcome = stream->next(frame, time_s); outcome != Outcome::ended;
         outcome = stream->next(frame, time_s))
        ++(outcome == Outcome::frame ? good : bad);
    EXPECT_EQ(good, static_cast<std::uint64_t>(kFrames - 1));
    EXPECT_EQ(bad + stream->framesSkipped(), 1U);
    EXPECT_NEAR(time_s, (kFrames - 1) / kRate_Hz, 1e-6);
}

TEST_F(VideoStreamTest, readsWhatIsThereOfATruncatedFile) {
    ASSERT_NO_FATAL_FAILURE(test::writeVideo(m_path, kFrames, kRate_Hz));
    const std::string bytes = content(m_path);
    std::ofstream(m_path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    auto stream = VideoStream::open(m_path);
    if (!stream)
        return; // refused is an answer, too
    cv::Mat1b frame;
    double time_s = 0.0;
    int good = 0;
    while (stream->next(frame, time_s) == Outcome::frame)
        ++good;
    EXPECT_LT(good, kFrames);
}

TEST_F(VideoStreamTest, refusesWhatIsNoVideoAndSaysWhy) {
    EXPECT_EQ(VideoStream::open(m_folder.path("missing.avi")).error().kind, core::ErrorKind::notFound);
    const std::string text = m_folder.write("text.avi", "this is no video");
    const auto refused = VideoStream::open(text);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(refused.error().where.file, text);
    EXPECT_FALSE(refused.error().expected.empty());
    EXPECT_EQ(VideoStream::open(m_folder.path("")).error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(VideoStream::open("97").error().kind, core::ErrorKind::unavailable); // no such camera
}

} // namespace teleta::camera
