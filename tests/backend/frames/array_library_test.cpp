// SPDX-License-Identifier: GPL-3.0-or-later
// Files that h5py and SciPy wrote (tests/data/README.md): 5 frames of 2 x 3 taxels, 0, 0.25, 0.5, ...
#include "backend/core/failure.h"
#include "backend/frames/arrays/file_apart.h"
#include "tests/backend/frames/frame_reading.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

using teleta::frames::ArrayFile;
using teleta::frames::FrameAxis;
using teleta::frames::FrameRequest;
using teleta::test::readAll;
namespace core = teleta::core;

namespace {

std::string kept(const std::string& name) {
    return TELETA_SOURCE_DIR "/tests/data/frames/" + name;
}

class ArrayLibraryTest : public teleta::test::FrameReadingTest {
protected:
    static core::Expected<teleta::frames::FrameSeries> open(const std::string& name,
                                                            FrameRequest request = {}) {
        request.path = kept(name);
        request.guessesShape = true;
        asGrid(request);
        return teleta::frames::readFrames(request);
    }
    /// 2 x 3 taxels, which could be 2 with three values each.
    static void asGrid(FrameRequest& request) {
        if (request.axis == FrameAxis::last || request.rows)
            return;
        request.rows = 2;
        request.columns = 3;
    }
    static std::string whyNot(const std::string& name, FrameRequest request = {}) {
        const auto series = open(name, std::move(request));
        return series ? std::string() : core::describe(series.error());
    }
    static void expectValues(const teleta::frames::FrameSeries& series, std::size_t taxels = 6) {
        ASSERT_EQ(series.values.size(), 30U);
        EXPECT_EQ(series.layout.taxels(), taxels);
        for (std::size_t i = 0; i < 30; ++i)
            EXPECT_EQ(series.values[i], static_cast<float>(i) / 4.0F) << i;
        for (std::size_t i = 0; i < 5; ++i)
            EXPECT_DOUBLE_EQ(series.time_s[i], static_cast<double>(i) * 0.01);
    }
    /// Cut off or with a byte turned, a file is either refused or read as it was; and nothing crashes.
    void survives(const std::string& name, FrameRequest request, std::size_t step) {
        const std::string whole = readAll(kept(name));
        request.guessesShape = true;
        asGrid(request);
        for (std::size_t size = 1; size < whole.size(); size += step)
            if (const auto series = read(whole.substr(0, size), request)) {
                expectValues(*series);
            }
        for (std::size_t i = 0; i < whole.size(); i += step) {
            std::string turned = whole;
            turned[i] = static_cast<char>(turned[i] ^ 0x5a);
            if (const auto series = read(turned, request)) {
                EXPECT_GT(series->frames(), 0U);
            }
        }
    }
};

/// What an opener does that a library does with a hostile file.
core::Expected<std::unique_ptr<ArrayFile>> crashes(const std::string&) {
    std::abort();
}
// Not where a sanitizer takes more memory than any limit.
[[maybe_unused]] core::Expected<std::unique_ptr<ArrayFile>> takesAllMemory(const std::string&) {
    std::vector<std::unique_ptr<char[]>> taken;
    for (;;)
        taken.push_back(std::make_unique<char[]>(std::size_t{1} << 26U));
}
core::Expected<std::unique_ptr<ArrayFile>> talks(const std::string& path) {
    std::fprintf(stderr, "HDF5-DIAG: error\n");
    std::printf("noise\n");
    std::fflush(stdout);
    return core::failed(core::ErrorKind::badInput, QStringLiteral("no"), {}, {path});
}

/// One array of 3 values that ends after two.
class BreakingFile : public ArrayFile {
public:
    explicit BreakingFile(const std::string& path)
        : ArrayFile(path) {
        m_arrays.push_back({.name = "a", .shape = {3}});
    }
    core::Expected<void> read(std::size_t, const Take& take) override {
        const std::vector<double> values{1.0, 2.0};
        take(values);
        std::abort();
    }
};
core::Expected<std::unique_ptr<ArrayFile>> breaks(const std::string& path) {
    return std::make_unique<BreakingFile>(path);
}

} // namespace

TEST_F(ArrayLibraryTest, readsHdf5WithGzipInAGroup) {
    const auto series = open("packed.h5");
    ASSERT_TRUE(series) << core::describe(series.error());
    expectValues(*series);
    EXPECT_EQ(series->layout.rows, 2);
    EXPECT_EQ(series->unit, "N");
    EXPECT_TRUE(series->hasPitch);
    EXPECT_DOUBLE_EQ(series->layout.pitchX_m, 0.004);
}

TEST_F(ArrayLibraryTest, listsTheCandidatesOfAFileThatHasSeveral) {
    const std::string why = whyNot("several.h5");
    EXPECT_NE(why.find("left (5 x 2 x 3), right (5 x 2 x 3)"), std::string::npos) << why;
    EXPECT_NE(why.find("--array"), std::string::npos) << why;
    EXPECT_EQ(why.find("notes"), std::string::npos) << why;
    for (const char* name : {"left", "/left"}) {
        const auto left = open("several.h5", {.array = name});
        ASSERT_TRUE(left) << core::describe(left.error());
        EXPECT_EQ(left->values[29], 7.0F); // 29 / 4 as an integer
        EXPECT_DOUBLE_EQ(left->time_s[4], 0.04);
    }
    EXPECT_TRUE(open("several.h5:/left"));
    EXPECT_FALSE(open("several.h5:/none"));
    EXPECT_NE(whyNot("several.h5", {.array = "notes"}).find("contains text"), std::string::npos);
    EXPECT_NE(whyNot("several.h5", {.array = "right"}).find("--rate"), std::string::npos);
}

TEST_F(ArrayLibraryTest, readsEveryVersionOfMatFiles) {
    for (const char* name : {"plain.mat", "version4.mat", "version73.mat"}) {
        const auto series = open(name);
        ASSERT_TRUE(series) << core::describe(series.error());
        expectValues(*series);
    }
}

TEST_F(ArrayLibraryTest, asksForTheDimensionThatCountsTheFramesOfAMatFile) {
    const std::string why = whyNot("packed.mat");
    EXPECT_NE(why.find("pad (5 x 2 x 3)"), std::string::npos) << why;
    EXPECT_NE(why.find("--frame-axis"), std::string::npos) << why;
    const auto series = open("packed.mat", {.axis = FrameAxis::first});
    ASSERT_TRUE(series) << core::describe(series.error());
    expectValues(*series);
    const auto last = open("packed.mat", {.axis = FrameAxis::last});
    ASSERT_TRUE(last);
    EXPECT_EQ(last->frames(), 3U);
    EXPECT_EQ(last->frame(1)[0], 0.25F);
}

TEST_F(ArrayLibraryTest, survivesDamagedFiles) {
    survives("packed.h5", {}, 397);
    survives("several.h5", {.array = "left"}, 397);
    survives("plain.mat", {}, 17);
    survives("packed.mat", {.axis = FrameAxis::first}, 7);
    survives("version4.mat", {}, 13);
    survives("version73.mat", {}, 197);
}

TEST_F(ArrayLibraryTest, givesAnErrorWhereALibraryCrashesOrWantsTooMuch) {
    const auto crash = teleta::frames::openApart("a.h5", crashes);
    ASSERT_FALSE(crash);
    EXPECT_EQ(crash.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(crash.error().where.file, "a.h5");
    EXPECT_NE(crash.error().message.find("stopped"), std::string::npos);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const auto large = teleta::frames::openApart("a.h5", takesAllMemory);
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().message.find("memory"), std::string::npos) << large.error().message;
#endif
}

TEST_F(ArrayLibraryTest, showsNothingThatALibraryPrints) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const auto refused = teleta::frames::openApart("a.h5", talks);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "no");
    EXPECT_EQ(refused.error().where.file, "a.h5");
}

TEST_F(ArrayLibraryTest, tellsWhenReadingEndsEarly) {
    const auto file = teleta::frames::openApart("a.h5", breaks);
    ASSERT_TRUE(file);
    std::size_t taken = 0;
    const auto count = [&](std::span<const double> values) {
        taken += values.size();
        return true;
    };
    const auto broken = (*file)->read(0, count);
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().kind, core::ErrorKind::badInput);
    EXPECT_EQ(taken, 2U);
    const auto ended = (*file)->read(0, [](std::span<const double>) { return false; });
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().kind, core::ErrorKind::cancelled);
}
