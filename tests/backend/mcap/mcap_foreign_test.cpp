// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/recording/stream_columns.h"
#include "tests/backend/mcap/mcap_recordings.h"

using namespace teleta;
using namespace teleta::test;

namespace {

/// What other programs write.
class McapForeign : public McapRecording {};

} // namespace

TEST_F(McapForeign, anImageOfFloatsIsAnArray) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/tactile/left", 30, [](int i, std::string& bytes) {
            image<float>(bytes, 2, 3, "32FC1", {0.5F, 1.0F, 2.0F, 3.0F, 4.0F, static_cast<float>(i)});
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    const StreamInfo& stream = recording->streams()[0];
    EXPECT_EQ(stream.name, "tactile_left");
    EXPECT_EQ(stream.kind, StreamKind::array);
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_NEAR(stream.nominalRate_Hz, 200.0, 0.001);
    EXPECT_TRUE(recording->isComplete());
    const test::ReadFrames frames = test::readAllFrames(recording->reader(0));
    ASSERT_EQ(frames.time_ns.size(), 30U);
    EXPECT_EQ(frames.values[5 + 6 * 29], 29.0F);
    // UTC to 1 ns, though an anchor has milliseconds.
    const auto& anchor = recording->anchors().at(0);
    EXPECT_EQ(frames.time_ns[7] - anchor.time_ns + anchor.utc.toMSecsSinceEpoch() * 1'000'000,
              static_cast<std::int64_t>(kLog_ns) + 7 * 5'000'001);
}

TEST_F(McapForeign, pointsWithForcesAreAnArrayOfVectorsWhereTheyStand) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/skin", 4, [](int i, std::string& bytes) {
            points(bytes, {"force_z", "x", "y", "z", "intensity", "force_x", "force_y"},
                   {-1.5, 0.0, 0.0, 0.0, 9.0, 0.25, 0.5, -static_cast<double>(i), 0.004, 0.001, 0.0, 9.0, 0.0,
                    0.0});
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 1U);
    const StreamInfo& stream = recording->streams()[0];
    EXPECT_EQ(stream.kind, StreamKind::array);
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(stream.unit, "N");
    const auto layout = pipeline::layoutOf(stream);
    ASSERT_TRUE(layout);
    EXPECT_FALSE(layout->isGrid());
    EXPECT_NEAR(layout->x_m(1), 0.004, 1e-12);
    const test::ReadFrames frames = test::readAllFrames(recording->reader(0));
    ASSERT_EQ(frames.time_ns.size(), 4U);
    EXPECT_EQ(frames.values[0], 0.25F);
    EXPECT_EQ(frames.values[2], -1.5F);
    EXPECT_EQ(frames.values[3 * 6 + 5], -3.0F);
}

TEST_F(McapForeign, pointsOfADepthCameraAndDamagedOnesAreNoArray) {
    const auto depth =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/depth", 3, [](int, std::string& bytes) {
            points(bytes, {"x", "y", "z", "intensity"}, {0.0, 0.0, 1.0, 3.0});
        }));
    ASSERT_TRUE(depth) << core::describe(depth.error());
    EXPECT_TRUE(depth->streams().empty());
    EXPECT_EQ(m_report->topics.at(0).messages, 0U);
    const auto other =
        importedFrom(foreign("sensor_msgs/msg/PointCloud2", "/skin", 5, [](int i, std::string& bytes) {
            std::vector<double> numbers{0.0, 0.0, 0.0, 1.0};
            if (i == 1)
                numbers.insert(numbers.end(), {1.0, 0.0, 0.0, 1.0}); // another number of points
            if (i == 2)
                numbers[0] = std::numeric_limits<double>::infinity();
            points(bytes, {"x", "y", "z", "value"}, numbers);
            if (i == 3)
                bytes.resize(bytes.size() - 20);
        }));
    ASSERT_TRUE(other) << core::describe(other.error());
    EXPECT_EQ(m_report->topics.at(0).messages, 2U);
    EXPECT_EQ(m_report->topics.at(0).bad, 3U);
}

/// The fields say what a cloud is, not its first points.

TEST_F(McapForeign, pointsOfTaxelsMayBeginWithADamagedMessage) {
    for (const int kind : {0, 1, 2}) {
        const auto recording = importedFrom(
            foreign("sensor_msgs/msg/PointCloud2", "/skin", 4, [kind](int i, std::string& bytes) {
                std::vector<double> numbers{0.0, 0.0, 0.0, 1.0};
                if (i == 0 && kind == 0)
                    numbers[0] = std::numeric_limits<double>::infinity();
                if (i == 0 && kind == 1)
                    numbers.clear(); // no point yet
                points(bytes, {"x", "y", "z", "value"}, numbers);
                if (i == 0 && kind == 2)
                    bytes.resize(bytes.size() - 90); // within the fields
            }));
        ASSERT_TRUE(recording) << core::describe(recording.error());
        ASSERT_EQ(recording->streams().size(), 1U) << kind;
        EXPECT_EQ(recording->streams()[0].kind, StreamKind::array);
        EXPECT_EQ(m_report->topics.at(0).messages, 3U) << kind;
        EXPECT_EQ(m_report->topics.at(0).bad, 1U) << kind;
    }
}

TEST_F(McapForeign, numbersWithOtherNamesAreBad) {
    const auto recording =
        importedFrom(foreign("teleta_msgs/msg/Numbers", "/chips", 4, [](int i, std::string& bytes) {
            CdrWriter cdr(bytes);
            header(cdr);
            cdr.number(std::uint32_t{2});
            cdr.text("one");
            cdr.text(i == 2 ? "other" : "two");
            cdr.number(std::uint32_t{2});
            cdr.number(1.5);
            cdr.number(static_cast<double>(i));
        }));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_EQ(m_report->topics.at(0).messages, 3U);
    EXPECT_EQ(m_report->topics.at(0).bad, 1U);
    ASSERT_EQ(recording->streams().size(), 1U);
    EXPECT_EQ(recording->streams()[0].columns.at(1).name, "two");
}

TEST_F(McapForeign, plainGreyImagesAreACameraUnlessAPersonSaysOtherwise) {
    const auto write = [](int i, std::string& bytes) {
        image<std::uint8_t>(bytes, 2, 2, "mono8", {1, 2, 3, static_cast<std::uint8_t>(i)});
    };
    const std::string file = foreign("sensor_msgs/msg/Image", "/eye", 3, write);
    auto recording = importedFrom(file);
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::camera);
    EXPECT_EQ(contentOf(*recording, 0).pictures.at(2), (std::vector<std::uint8_t>{1, 2, 3, 2}));
    recording = importedFrom(file, {.topics = {{"/eye", TopicKind::array}}});
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::array);
    const auto refused = importedFrom(file, {.topics = {{"/eye", TopicKind::joints}}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    const auto unknown = importedFrom(file, {.topics = {{"/nose", TopicKind::array}}});
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().expected.find("/eye"), std::string::npos);
}

/// Red, green, blue of two pixels, in the order of the encoding.
TEST_F(McapForeign, picturesInColourAreASceneCameraInEachOrder) {
    using Colour = std::array<std::uint8_t, 3>;
    for (const bool isBgr : {false, true}) {
        const auto recording = importedFrom(
            foreign("sensor_msgs/msg/Image", "/look/image_raw", 3, [&](int i, std::string& bytes) {
                Colour first{250, 20, static_cast<std::uint8_t>(i)};
                Colour second{1, 2, 3};
                if (isBgr) {
                    std::swap(first[0], first[2]);
                    std::swap(second[0], second[2]);
                }
                image<Colour>(bytes, 1, 2, isBgr ? "bgr8" : "rgb8", {first, second});
            }));
        ASSERT_TRUE(recording) << core::describe(recording.error());
        ASSERT_EQ(recording->streams().size(), 1U);
        EXPECT_EQ(recording->streams()[0].kind, StreamKind::camera);
        EXPECT_TRUE(recording::isColour(recording->streams()[0]));
        EXPECT_EQ(contentOf(*recording, 0).pictures.at(2), (std::vector<std::uint8_t>{250, 20, 2, 1, 2, 3}));
        std::optional<core::Error> why;
        const auto cameras = pipeline::recordedSceneCameras(*recording, why);
        ASSERT_TRUE(cameras) << core::describe(cameras.error());
        EXPECT_EQ(cameras->size(), 1U) << "the dock Scene shows it";
        EXPECT_FALSE(why);
    }
}

TEST_F(McapForeign, codedPicturesInColourAreASceneCameraUnlessAPersonSaysOtherwise) {
    const auto write = [](bool isColour) {
        return [isColour](int, std::string& bytes) {
            CdrWriter cdr(bytes);
            header(cdr);
            cdr.text("png");
            const auto png = mcap::encodePng(pictureAt(0, 100, 6).image, 1,
                                             isColour ? mcap::PngPixel::colour : mcap::PngPixel::grey);
            cdr.byteSequence({png.data(), png.size()});
        };
    };
    const std::string type = "sensor_msgs/msg/CompressedImage";
    auto recording = importedFrom(foreign(type, "/look", 2, write(true)));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_TRUE(recording::isColour(recording->streams().at(0)));
    const auto bytes = contentOf(*recording, 0).pictures.at(1);
    const core::GreyImage wanted = pictureAt(0, 100, 6).image;
    EXPECT_EQ(bytes, std::vector<std::uint8_t>(wanted.pixels.get(), wanted.pixels.get() + bytes.size()));

    recording =
        importedFrom(foreign(type, "/look", 2, write(true)), {.topics = {{"/look", TopicKind::camera}}});
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_FALSE(recording::isColour(recording->streams().at(0)));
    EXPECT_EQ(contentOf(*recording, 0).pictures.at(1).size(), bytes.size() / 3);

    recording = importedFrom(foreign(type, "/look", 2, write(false)));
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_FALSE(recording::isColour(recording->streams().at(0)));
}

/// ITU-R BT.601: Y = 0.299 R + 0.587 G + 0.114 B.
TEST_F(McapForeign, aPictureInColourIsReadInGreyWhereAPersonSaysSo) {
    using Colour = std::array<std::uint8_t, 3>;
    const auto recording = importedFrom(
        foreign(
            "sensor_msgs/msg/Image", "/tube", 1,
            [](int, std::string& bytes) {
                image<Colour>(bytes, 1, 3, "rgb8", {Colour{200, 0, 0}, Colour{0, 200, 0}, Colour{0, 0, 200}});
            }),
        {.topics = {{"/tube", TopicKind::camera}}});
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_FALSE(recording::isColour(recording->streams().at(0)));
    EXPECT_EQ(contentOf(*recording, 0).pictures.at(0), (std::vector<std::uint8_t>{60, 117, 23}));
}

TEST_F(McapForeign, imagesOf16BitsKeepTheirValues) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/mat", 1, [](int, std::string& bytes) {
            image<std::uint16_t>(bytes, 1, 6, "16UC1", {0, 1, 256, 1000, 65534, 65535});
        }));
    ASSERT_TRUE(recording);
    const StreamContent content = contentOf(*recording, 0);
    std::vector<float> values(6);
    std::memcpy(values.data(), content.values.data(), content.values.size());
    EXPECT_EQ(values, (std::vector<float>{0.0F, 1.0F, 256.0F, 1000.0F, 65534.0F, 65535.0F}));
}

TEST_F(McapForeign, jointStatesWithoutEffortHaveNoTorque) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/JointState", "/joint_states", 3, [](int i, std::string& bytes) {
            CdrWriter cdr(bytes);
            header(cdr);
            cdr.number(std::uint32_t{2});
            cdr.text("a");
            cdr.text("b");
            const std::array<double, 2> position{static_cast<double>(i), 2.0};
            cdr.sequence(std::span<const double>(position));
            cdr.sequence(std::span<const double>());
            cdr.sequence(std::span<const double>());
        }));
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->streams().at(0).kind, StreamKind::joints);
    const StreamContent content = contentOf(*recording, 0);
    std::vector<double> values(content.values.size() / sizeof(double));
    std::memcpy(values.data(), content.values.data(), content.values.size());
    ASSERT_EQ(values.size(), 18U);
    EXPECT_EQ(values[6], 1.0);
    EXPECT_TRUE(std::isnan(values[8]));
}

TEST_F(McapForeign, aMultiArrayOfTwoDimensionsIsAnArrayRowByRow) {
    const auto write = [](int i, std::string& bytes) {
        CdrWriter cdr(bytes);
        cdr.number(std::uint32_t{i == 2 ? 1U : 2U});
        for (int dimension = 0; dimension < (i == 2 ? 1 : 2); ++dimension) {
            cdr.text("d");
            cdr.number(std::uint32_t{2});
            cdr.number(std::uint32_t{dimension == 0 ? 6U : 3U});
        }
        cdr.number(std::uint32_t{1}); // data_offset
        constexpr std::array<float, 7> kData{9.0F, 1.0F, 2.0F, 9.0F, 3.0F, 4.0F, 9.0F};
        cdr.sequence(std::span<const float>(kData));
    };
    const auto recording = importedFrom(foreign("std_msgs/msg/Float32MultiArray", "/grid", 3, write));
    ASSERT_TRUE(recording);
    const StreamContent content = contentOf(*recording, 0);
    ASSERT_EQ(content.time_ns.size(), 2U) << "one of a single dimension is none";
    std::vector<float> values(8);
    std::memcpy(values.data(), content.values.data(), content.values.size());
    EXPECT_EQ(values, (std::vector<float>{1.0F, 2.0F, 3.0F, 4.0F, 1.0F, 2.0F, 3.0F, 4.0F}));
    EXPECT_EQ(m_report->topics.at(0).bad, 1U);
}

TEST_F(McapForeign, messagesOfAnotherShapeAndDamagedOnesAreCounted) {
    const auto recording =
        importedFrom(foreign("sensor_msgs/msg/Image", "/mat", 4, [](int i, std::string& bytes) {
            if (i == 1)
                bytes += "rubbish";
            else
                image<float>(bytes, i == 2 ? 2 : 1, 1, "32FC1", std::vector<float>(i == 2 ? 2 : 1, 1.0F));
        }));
    ASSERT_TRUE(recording);
    EXPECT_EQ(m_report->topics.at(0).messages, 2U);
    EXPECT_EQ(m_report->topics.at(0).bad, 2U);
}

TEST_F(McapForeign, aFileWithoutReadableTopicsIsRefusedWithItsList) {
    const auto refused = importedFrom(
        foreign("std_msgs/msg/Header", "/chatter", 1, [](int, std::string& bytes) { bytes += "x"; }));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    EXPECT_NE(refused.error().message.find("/chatter (cdr, std_msgs/msg/Header)"), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("in.teleta")));
    EXPECT_FALSE(std::filesystem::exists(m_folder.path("in.teleta.part")));
}
