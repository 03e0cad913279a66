// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/frames/frame_reader.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace teleta::test {

/// Reads texts and bytes as files of frames.
class FrameReadingTest : public testing::Test {
protected:
    core::Expected<frames::FrameSeries> read(const std::string& content, frames::FrameRequest request = {}) {
        request.path = m_folder.write("frames", content);
        return frames::readFrames(request);
    }

    /// Why the content is refused, with what was expected; empty when it is read.
    std::string refusal(const std::string& content, frames::FrameRequest request = {}) {
        const auto series = read(content, std::move(request));
        return series ? std::string() : core::describe(series.error());
    }

    TemporaryFolder m_folder;
};

} // namespace teleta::test
