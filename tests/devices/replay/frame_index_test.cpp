// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/frame_index.h"

#include <gtest/gtest.h>

using teleta::replay::FrameIndex;
using teleta::replay::FramePlace;

namespace {

FramePlace placeOf(std::uint64_t frame) {
    return {.frame = frame,
            .time_s = 5.0 + 0.1 * static_cast<double>(frame),
            .offset = 100 + 7 * frame,
            .line = static_cast<long long>(frame) + 2};
}

void fill(FrameIndex& index, std::uint64_t frames) {
    for (std::uint64_t frame = 0; frame < frames; ++frame)
        index.add(placeOf(frame));
}

} // namespace

TEST(FrameIndex, knowsTheExtentAndWhetherItIsFinal) {
    FrameIndex index;
    EXPECT_EQ(index.extent().frames, 0U);
    fill(index, 11);
    EXPECT_EQ(index.extent().frames, 11U);
    EXPECT_DOUBLE_EQ(index.atFrame(0).time_s, 5.0);
    EXPECT_DOUBLE_EQ(index.extent().lastTime_s, 6.0);
    EXPECT_FALSE(index.extent().complete);
    index.complete();
    EXPECT_TRUE(index.extent().complete);
}

TEST(FrameIndex, findsEveryFrameOfAShortRecording) {
    FrameIndex index;
    fill(index, 1000);
    for (const std::uint64_t frame : {0U, 1U, 500U, 999U}) {
        EXPECT_EQ(index.atFrame(frame).frame, frame);
        EXPECT_EQ(index.atFrame(frame).offset, placeOf(frame).offset);
        EXPECT_EQ(index.atFrame(frame).line, placeOf(frame).line);
    }
    EXPECT_EQ(index.atFrame(5000).frame, 999U);
    EXPECT_EQ(index.beforeTime(5.0).frame, 0U);
    EXPECT_EQ(index.beforeTime(-1e9).frame, 0U);
    EXPECT_EQ(index.beforeTime(5.25).frame, 2U);
    EXPECT_EQ(index.beforeTime(1e9).frame, 999U);
}

TEST(FrameIndex, comesBeforeAllFramesOfOneTime) {
    FrameIndex index;
    for (std::uint64_t frame = 0; frame < 10; ++frame)
        index.add({.frame = frame, .time_s = frame < 3 ? 0.0 : 1.0, .offset = frame, .line = 1});
    EXPECT_EQ(index.beforeTime(1.0).frame, 2U);
}

TEST(FrameIndex, staysSmallAndNearForALongRecording) {
    FrameIndex index;
    constexpr std::uint64_t kFrames = 1'000'000;
    fill(index, kFrames);
    EXPECT_EQ(index.extent().frames, kFrames);
    // At most kMaximumPlaces places, evenly spaced: the stride is the next power of two.
    constexpr std::uint64_t kStride = 256;
    static_assert(kFrames / kStride < FrameIndex::kMaximumPlaces &&
                  kFrames / kStride * 2 >= FrameIndex::kMaximumPlaces);
    for (std::uint64_t frame = 0; frame < kFrames; frame += 997) {
        const FramePlace place = index.atFrame(frame);
        EXPECT_EQ(place.frame, frame / kStride * kStride);
        EXPECT_EQ(place.offset, placeOf(place.frame).offset);
    }
}
