// SPDX-License-Identifier: GPL-3.0-or-later
// What the cameras of a site see reaches its consoles, over the loopback interface. Each test has a domain of
// its own.
#include "backend/core/device/colour_image.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/recording/recording.h"
#include "devices/site/image/picture_budget.h"
#include "devices/site/remote/remote_camera.h"
#include "tests/app/cli/program_run.h"
#include "tests/peer/site/site_process.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using core::DeviceState;
using test::SiteProcess;
using test::TestConsole;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* kPractice = "[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n";
constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// Eight pictures: the left half is as bright as its number says, the right half is noise.
std::string writePictures(QTemporaryDir& folder) {
    cv::RNG random(3);
    for (int i = 0; i < 8; ++i) {
        cv::Mat picture(kHeight, kWidth, CV_8UC3);
        random.fill(picture, cv::RNG::UNIFORM, 0, 256);
        picture.colRange(0, kWidth / 2).setTo(cv::Scalar(30, 20 + 25 * i, 200));
        cv::imwrite(folder.filePath(QStringLiteral("%1.png").arg(i, 4, 10, QLatin1Char('0'))).toStdString(),
                    picture);
    }
    return folder.filePath(QStringLiteral("%04d.png")).toStdString();
}

std::string camera(const std::string& source, int quality, int most_kbitPerS) {
    return std::string(kPractice) + "[[device]]\nid = \"overview\"\ncamera = \"" + source +
           "\"\nquality = " + std::to_string(quality) + "\nmax_kbit_s = " + std::to_string(most_kbitPerS) +
           '\n';
}

/// What a console sees of the camera; as its pipeline does.
class Eye {
public:
    explicit Eye(const TestConsole& console, const std::string& name = "overview")
        : m_camera(*site_link::RemoteCamera::open(console.sharedClient(), name, {.name = "eye"})) {
        m_camera->start(m_wakeup);
    }
    ~Eye() { m_camera->stop(); }
    [[nodiscard]] core::DeviceStatus status() const { return m_camera->status(); }
    /// All that have come since.
    [[nodiscard]] std::vector<core::CameraFrame> take() {
        std::vector<core::CameraFrame> frames;
        for (core::CameraFrame frame; m_camera->pop(frame);)
            frames.push_back(frame);
        return frames;
    }
    /// Waits for one.
    [[nodiscard]] core::CameraFrame next() {
        core::CameraFrame frame;
        EXPECT_TRUE(TestConsole::eventually([&] { return m_camera->pop(frame); }));
        return frame;
    }

private:
    core::Wakeup m_wakeup;
    std::unique_ptr<site_link::RemoteCamera> m_camera;
};

/// The number of the picture by its colour; -1: it is none of them.
int numberOf(const core::CameraFrame& frame) {
    const core::ColourImage picture = core::colourOf(frame.image);
    if (picture.width_px != kWidth || picture.height_px != kHeight)
        return -1;
    const std::uint8_t* const pixel = picture.pixels.get() + std::size_t{3} * (kWidth * 60 + 40);
    const auto number = static_cast<int>(std::lround((pixel[1] - 20) / 25.0));
    const bool isRight = std::abs(pixel[0] - 200) < 12 && std::abs(pixel[2] - 30) < 12 &&
                         std::abs(pixel[1] - 20 - 25 * number) < 12;
    return isRight ? number : -1;
}

TEST(SiteCamera, operatorAndViewerSeeWhatTheCameraSees) {
    SiteProcess site(126, "");
    site.setDevices(camera(writePictures(site.folder()), 70, 20'000));
    site.start();
    TestConsole console(site, "a");
    TestConsole viewer(site, "v", true);
    ASSERT_TRUE(TestConsole::eventually([&] { return console.view().clock && viewer.view().clock; }));
    for (TestConsole* one : {&console, &viewer}) {
        Eye eye(*one);
        (void)eye.next();
        int before = -1;
        for (int i = 0; i < 20; ++i) {
            const core::CameraFrame frame = eye.next();
            const int number = numberOf(frame);
            EXPECT_GE(number, 0);
            EXPECT_NE(number, before);
            before = number;
            // One clock on both sides: read before now.
            EXPECT_GE(core::elapsed_s(frame.time_ns, core::steadyNow_ns()), 0.0);
        }
        EXPECT_EQ(eye.status().state, DeviceState::live);
    }
    Eye eye(console);
    (void)eye.next();
    site.send(SIGSTOP);
    EXPECT_TRUE(TestConsole::eventually([&] { return eye.status().state == DeviceState::stale; }));
    EXPECT_TRUE(TestConsole::eventually([&] { return eye.status().message == "lab does not answer"; }))
        << eye.status().message;
    site.send(SIGCONT);
    EXPECT_TRUE(TestConsole::eventually([&] { return eye.status().state == DeviceState::live; }));
    // Another program with the name of the site begins a stream of its own.
    site.kill();
    site.start();
    (void)eye.take();
    bool jumped = false;
    EXPECT_TRUE(TestConsole::eventually([&] {
        for (const core::CameraFrame& frame : eye.take())
            jumped = jumped || frame.discontinuity;
        return jumped;
    }));
}

TEST(SiteCamera, picturesTakeNoMoreThanTheyMay) {
    constexpr int kMost_kbitPerS = 1000;
    SiteProcess site(128, "");
    site.setDevices(camera(writePictures(site.folder()), 90, kMost_kbitPerS));
    site.start();
    TestConsole console(site, "a");
    auto reader = dds::Reader<ros::ImageFrame>::open(
        console.client().participant(), console.client().topics().image("overview"), site_link::kStreamed);
    ASSERT_TRUE(reader);
    double bits = 0.0;
    double largest = 0.0;
    int pictures = 0;
    std::int64_t first_ns = 0;
    std::int64_t last_ns = 0;
    for (const auto end = std::chrono::steady_clock::now() + 4s; std::chrono::steady_clock::now() < end;) {
        (void)reader->take([&](const ros::ImageFrame& message, const dds::SampleInfo& info) {
            const double one = site_link::PictureBudget::bitsOf(ros::view(message.image.data).size());
            first_ns = first_ns == 0 ? info.sent_ns : first_ns;
            last_ns = info.sent_ns;
            bits += one;
            largest = std::max(largest, one);
            ++pictures;
        });
        std::this_thread::sleep_for(2ms);
    }
    ASSERT_GT(pictures, 3);
    const double time_s = static_cast<double>(last_ns - first_ns) * 1e-9;
    EXPECT_LE(bits, kMost_kbitPerS * 1e3 * time_s + 1.05 * largest);
    ::testing::Test::RecordProperty("kbit_per_s", static_cast<int>((bits - largest) / time_s / 1e3));
    ::testing::Test::RecordProperty("pictures_per_10_s", static_cast<int>(10.0 * (pictures - 1) / time_s));
}

TEST(SiteCamera, whatIsNoPictureIsCountedAndNamedAndNothingElse) {
    SiteProcess site(130, kPractice);
    site.start();
    TestConsole console(site, "a");
    Eye eye(console, "broken");
    auto domain = site_link::readRemoteSite(site.fileOf("b"));
    ASSERT_TRUE(domain);
    const auto participant = domain->meeting.join();
    ASSERT_TRUE(participant);
    auto writer = dds::Writer<ros::ImageFrame>::open(*participant, console.client().topics().image("broken"),
                                                     site_link::kNewest);
    ASSERT_TRUE(writer);
    ASSERT_TRUE(TestConsole::eventually([&] { return writer->matched() == 1; }));

    Bytes whole;
    ASSERT_TRUE(cv::imencode(".jpg", cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(30, 45, 200)), whole));
    Bytes png;
    ASSERT_TRUE(cv::imencode(".png", cv::Mat(8, 8, CV_8UC3, cv::Scalar(1, 2, 3)), png));
    Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() / 2));
    // The frame header says 65535 x 65535.
    Bytes huge = whole;
    for (std::size_t i = 0; i + 9 < huge.size(); ++i) {
        if (huge[i] == 0xff && huge[i + 1] == 0xc0)
            std::fill_n(huge.begin() + static_cast<std::ptrdiff_t>(i + 5), 4, std::uint8_t{0xff});
    }
    // It begins and ends well; between is noise.
    Bytes noise = whole;
    cv::RNG random(5);
    for (std::size_t i = 20; i + 2 < noise.size(); ++i)
        noise[i] = static_cast<std::uint8_t>(random.uniform(0, 256));
    std::uint64_t number = 0;
    const auto send = [&](Bytes& bytes) {
        std::string empty;
        ros::ImageFrame message{};
        message.site_boot[0] = 9;
        message.number = number++;
        message.image.header.frame_id = empty.data();
        message.image.format = empty.data();
        ros::lend(message.image.data, std::span(bytes));
        return writer->write(message);
    };
    Bytes none;
    std::uint64_t lost = 0;
    for (Bytes* bad : {&none, &png, &cut, &huge, &noise}) {
        ASSERT_TRUE(send(*bad));
        ++lost;
        EXPECT_TRUE(TestConsole::eventually([&] { return eye.status().framesLost == lost; })) << lost;
        EXPECT_EQ(eye.status().message, "the received data are not a complete JPEG picture (0 bytes)");
    }
    EXPECT_TRUE(eye.take().empty());
    ASSERT_TRUE(send(whole));
    EXPECT_EQ(numberOf(eye.next()), 1);
    EXPECT_EQ(eye.status().state, DeviceState::live);
    EXPECT_EQ(eye.status().message, "");
    EXPECT_EQ(eye.status().framesLost, lost);
}

TEST(SiteCamera, theCommandLineRecordsIt) {
    SiteProcess site(132, "");
    site.setDevices(camera(writePictures(site.folder()), 70, 20'000));
    site.start();
    const std::string path = site.folder().filePath("site.teleta").toStdString();
    const auto record = test::run({"site", "record", site.fileOf("r"), "--seconds", "2", "--out", path});
    ASSERT_EQ(record.exitCode, 0) << record.err;
    const auto opened = recording::Recording::open(path);
    ASSERT_TRUE(opened) << core::describe(opened.error());
    const auto sources = pipeline::recordedSources(*opened);
    ASSERT_TRUE(sources) << core::describe(sources.error());
    ASSERT_EQ(sources->sceneCameras.size(), 1U);
    EXPECT_EQ(sources->arrays.size(), 1U);
}

} // namespace
} // namespace teleta
