// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/mark_changes.h"
#include "tests/backend/recording/recorded_files.h"

#include <filesystem>
#include <numeric>

using namespace teleta;
using namespace teleta::recording;
using namespace teleta::test;

namespace {

class RecorderTest : public testing::Test {
protected:
    RecorderTest() { makeApplication(); }

    std::unique_ptr<Recorder> start(RecorderOptions options = {}) {
        auto recorder = Recorder::start(path(), headAt(m_start_ns), std::move(options));
        EXPECT_TRUE(recorder) << core::describe(recorder.error());
        return recorder ? std::move(*recorder) : nullptr;
    }
    [[nodiscard]] std::string path() const { return m_folder.path("run.teleta"); }

    TemporaryFolder m_folder;
    std::int64_t m_start_ns = core::steadyNow_ns();
};

} // namespace

TEST_F(RecorderTest, whatWasAppendedIsReadAgainWithItsTimesUnitsAndShape) {
    auto recorder = start();
    const auto tap = recorder->addStream(arrayInfo());
    for (int i = 0; i < 1200; ++i)
        appendFrame(*tap, m_start_ns + i * 5'000'000LL, static_cast<float>(i));
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(recorder->status().state, RecorderStatus::State::stopped);
    EXPECT_EQ(recorder->status().frames, 1200U);
    EXPECT_EQ(recorder->status().dropped, 0U);
    EXPECT_EQ(recorder->status().bytes, std::filesystem::file_size(path()));
    EXPECT_FALSE(std::filesystem::exists(path() + "-wal")) << "the file is to be complete by itself";

    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    EXPECT_TRUE(recording->isComplete());
    EXPECT_EQ(recording->head().appVersion, "1.2.3");
    EXPECT_EQ(recording->head().scene, "a scene");
    EXPECT_EQ(recording->head().sceneText, "[scene]\n");
    EXPECT_EQ(recording->head().start_ns, m_start_ns);
    ASSERT_EQ(recording->streams().size(), 1U);
    const StreamInfo& stream = recording->streams()[0];
    EXPECT_EQ(stream.kind, StreamKind::array);
    EXPECT_EQ(stream.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(stream.unit, "N");
    EXPECT_EQ(stream.source, "bench array");
    EXPECT_EQ(stream.nominalRate_Hz, 200.0);
    EXPECT_EQ(stream.details, arrayInfo().details);

    const ReadFrames all = readAllFrames(recording->reader(0));
    ASSERT_EQ(all.time_ns.size(), 1200U);
    EXPECT_EQ(all.jumps, 0U);
    for (std::size_t i = 0; i < all.time_ns.size(); ++i) {
        ASSERT_EQ(all.time_ns[i], m_start_ns + static_cast<std::int64_t>(i) * 5'000'000);
        ASSERT_EQ(all.values[i * kTaxels], static_cast<float>(i));
        ASSERT_EQ(all.values[i * kTaxels + 5], static_cast<float>(i) + 0.625F);
    }
    EXPECT_EQ(askFile(path(), QStringLiteral("PRAGMA integrity_check")), "ok");
}

TEST_F(RecorderTest, streamsOfEveryKindComeBackBesideEachOther) {
    auto recorder = start();
    StreamInfo numbers;
    numbers.name = "touches";
    numbers.kind = StreamKind::touches;
    numbers.type = ValueType::float64;
    numbers.shape = {2};
    numbers.columns = {{"touch", ""}, {"x_m", "m"}};
    StreamInfo camera;
    camera.name = "camera";
    camera.kind = StreamKind::camera;
    camera.type = ValueType::grey8;
    camera.shape = {0, 0};
    const auto array = recorder->addStream(arrayInfo());
    const auto touches = recorder->addStream(numbers);
    const auto pictures = recorder->addStream(camera);
    appendFrame(*array, m_start_ns, 1.0F);
    const std::array<double, 2> touch{1.0, 0.1};
    touches->append(m_start_ns + 1, 0.5, std::span<const double>(touch));
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(64U * 48U);
    std::iota(pixels->begin(), pixels->end(), std::uint8_t{0});
    core::CameraFrame frame;
    frame.image = {std::shared_ptr<const std::uint8_t>(pixels, pixels->data()), 64, 48};
    frame.time_ns = m_start_ns + 2;
    frame.capture_s = 0.025;
    pictures->append(frame);
    ASSERT_TRUE(recorder->stop());

    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording) << core::describe(recording.error());
    ASSERT_EQ(recording->streams().size(), 3U);
    EXPECT_EQ(recording->streams()[1].columns[1].name, "x_m");
    EXPECT_EQ(recording->streams()[1].columns[1].unit, "m");
    EXPECT_EQ(recording->first(StreamKind::camera), std::size_t{2});
    EXPECT_EQ(recording->first(StreamKind::joints), std::nullopt);
    core::TappedFrames block;
    auto reader = recording->reader(1);
    ASSERT_TRUE(reader.next(block).value());
    EXPECT_EQ(valuesOf<double>(block, 0, 2)[1], 0.1);
    auto images = recording->reader(2);
    ASSERT_TRUE(images.next(block).value());
    ASSERT_EQ(block.image.width_px, 64);
    ASSERT_EQ(block.image.height_px, 48);
    EXPECT_TRUE(std::equal(pixels->begin(), pixels->end(), block.image.pixels.get()));
    EXPECT_EQ(block.sourceTime_s, std::vector<double>{0.025});
    EXPECT_FALSE(images.next(block).value());
}

TEST_F(RecorderTest, marksAndEventsKeepTheirTimesAndNotes) {
    auto recorder = start();
    recorder->add({.time_ns = m_start_ns + 2'000'000'000, .kind = kMark, .text = "the second one"});
    recorder->add({.time_ns = m_start_ns + 1'000'000'000, .kind = kMark, .text = "grün, 触覚"});
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(recorder->status().marks, 2U);
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording);
    std::vector<RecordingEvent> marks;
    for (const RecordingEvent& event : recording->events()) {
        if (event.kind == kMark)
            marks.push_back(event);
    }
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_EQ(marks[0].text, "grün, 触覚");
    EXPECT_DOUBLE_EQ(recording->time_s(marks[0].time_ns), 1.0);
    EXPECT_EQ(marks[1].text, "the second one");
}

TEST_F(RecorderTest, twoStreamsOfOneNameGetDifferentOnes) {
    auto recorder = start();
    (void)recorder->addStream(arrayInfo());
    (void)recorder->addStream(arrayInfo());
    ASSERT_TRUE(recorder->stop());
    const auto recording = Recording::open(path());
    EXPECT_EQ(recording->streams()[0].name, "frames");
    EXPECT_EQ(recording->streams()[1].name, "frames-2");
}

TEST_F(RecorderTest, aTapThatOutlivesItsRecorderTakesNothingMore) {
    auto recorder = start();
    const auto tap = recorder->addStream(arrayInfo());
    appendFrame(*tap, m_start_ns, 1.0F);
    ASSERT_TRUE(recorder->stop());
    EXPECT_TRUE(tap->isClosed());
    for (int i = 0; i < 100'000; ++i)
        appendFrame(*tap, m_start_ns + i, 2.0F);
    EXPECT_EQ(tap->dropped(), 0U);
    EXPECT_TRUE(recorder->addStream(arrayInfo("late"))->isClosed());
    EXPECT_EQ(readAllFrames(Recording::open(path())->reader(0)).time_ns.size(), 1U);
}

TEST_F(RecorderTest, framesThatTheWriterCannotTakeAreCountedAndToldInTheFile) {
    // The writer first sees the stream at its next look, so that so many never fit.
    auto recorder = start({.queueBlocks = 8});
    const auto tap = recorder->addStream(arrayInfo());
    constexpr std::uint64_t kFrames = 100'000;
    for (std::uint64_t i = 0; i < kFrames; ++i)
        appendFrame(*tap, m_start_ns + static_cast<std::int64_t>(i), 0.0F);
    ASSERT_TRUE(recorder->stop());
    const RecorderStatus status = recorder->status();
    EXPECT_GT(status.dropped, 0U);
    EXPECT_EQ(status.frames + status.dropped, kFrames);
    const auto recording = Recording::open(path());
    double told = 0.0;
    for (const RecordingEvent& event : recording->events()) {
        if (event.kind == kDropped) {
            EXPECT_EQ(event.text, "frames");
            told += event.value;
        }
    }
    EXPECT_EQ(told, static_cast<double>(status.dropped));
}

TEST_F(RecorderTest, aClockThatIsSetBackGetsAnAnchorAndChangesNoTimeOfAFrame) {
    // Each look at the wall clock finds it an hour earlier than the one before.
    const QDateTime begin(QDate(2030, 1, 1), QTime(12, 0), Qt::UTC);
    auto looks = std::make_shared<std::atomic<int>>(0);
    auto recorder = start({.utcNow = [begin, looks] { return begin.addSecs(-3600LL * (*looks)++); }});
    const auto tap = recorder->addStream(arrayInfo());
    for (int i = 0; i < 10; ++i)
        appendFrame(*tap, m_start_ns + i, 0.0F);
    ASSERT_TRUE(recorder->stop());
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording);
    ASSERT_GE(recording->anchors().size(), 2U);
    EXPECT_EQ(recording->anchors()[0].utc, begin);
    EXPECT_EQ(recording->anchors()[1].utc, begin.addSecs(-3600));
    EXPECT_LT(recording->anchors()[0].time_ns, recording->anchors()[1].time_ns);
    EXPECT_EQ(recording->utcOf(recording->anchors()[0].time_ns), begin);
    EXPECT_EQ(recording->utcOf(recording->anchors()[1].time_ns + 2'000'000'000), begin.addSecs(-3598));
    EXPECT_EQ(readAllFrames(recording->reader(0)).time_ns.size(), 10U);
}

TEST_F(RecorderTest, aSteadyClockGetsOneAnchor) {
    auto recorder = start();
    // Several transactions.
    while (recorder->status().duration_s < 0.5)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(Recording::open(path())->anchors().size(), 1U);
}

TEST_F(RecorderTest, aMarkThatIsSetAgainTwiceIsThereOnce) {
    auto recorder = start();
    const std::uint64_t number = recorder->mark("one", m_start_ns + 10);
    ASSERT_TRUE(recorder->stop());
    const std::vector<MarkChange> changes{
        {.number = number, .note = "again", .restored_ns = m_start_ns + 20}};
    for (int time = 0; time < 2; ++time) {
        const auto changed = changeMarks(path(), changes);
        ASSERT_TRUE(changed) << core::describe(changed.error());
    }
    std::vector<std::pair<std::string, std::int64_t>> marks;
    const auto recording = Recording::open(path());
    for (const RecordingEvent& event : recording->events())
        if (event.kind == kMark)
            marks.emplace_back(event.text, event.time_ns - m_start_ns);
    EXPECT_EQ(marks, (std::vector<std::pair<std::string, std::int64_t>>{{"again", 20}}));
}

TEST_F(RecorderTest, marksCanBeRenamedTakenOutAndSetAgain) {
    auto recorder = start();
    const std::uint64_t first = recorder->mark("one", m_start_ns + 10);
    const std::uint64_t second = recorder->mark("two", m_start_ns + 20);
    const std::uint64_t third = recorder->mark("three", m_start_ns + 30);
    recorder->renameMark(first, "the first");
    // Once they are in the file as well.
    while (recorder->status().marks < 3)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    recorder->removeMark(second);
    recorder->removeMark(third);
    recorder->restoreMark(third, "again", m_start_ns + 30);
    recorder->renameMark(third, "and again");
    ASSERT_TRUE(recorder->stop());
    EXPECT_EQ(recorder->status().marks, 2U);
    const auto recording = Recording::open(path());
    ASSERT_TRUE(recording);
    std::vector<std::pair<std::string, std::int64_t>> marks;
    for (const RecordingEvent& event : recording->events())
        if (event.kind == kMark)
            marks.emplace_back(event.text, event.time_ns - m_start_ns);
    EXPECT_EQ(marks,
              (std::vector<std::pair<std::string, std::int64_t>>{{"the first", 10}, {"and again", 30}}));
}
