// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/file_kind.h"
#include "backend/frames/frame_reader.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/memory_file.h"

#include <cmath>
#include <cstring>
#include <utility>

namespace teleta::fuzz {

namespace {

/// Whether the file is read; what it gives is sound.
bool readsFrames(const std::string& path, frames::FrameRequest request) {
    request.path = path;
    request.guessesShape = true;
    const core::Expected<frames::FrameSeries> series = frames::readFrames(request);
    if (!series) {
        require(!series.error().message.empty(), "an error has a text");
        return false;
    }
    require(series->frames() > 0, "there is a frame");
    require(series->values.size() == series->frames() * series->layout.taxels(), "each frame has all taxels");
    require(series->layout.pitchX_m > 0.0 && std::isfinite(series->layout.pitchX_m), "the pitch is positive");
    for (std::size_t i = 0; i < series->frames(); ++i)
        require(std::isfinite(series->time_s[i]) && (i == 0 || series->time_s[i] >= series->time_s[i - 1]),
                "times never decrease");
    return true;
}

/// A frame with three numbers a row is taken for a grid when somebody says so. With times of its own, or at a
/// rate that is given.
bool readsThreeColumns(const std::string& path) {
    frames::FrameRequest request;
    request.columns = 3;
    const bool isRead = readsFrames(path, request);
    request.rate_Hz = 100.0;
    request.axis = frames::FrameAxis::first;
    return readsFrames(path, request) || isRead;
}

} // namespace

bool frameNumpy(Bytes bytes) {
    const bool isNumpy = bytes.size() >= 4 && (std::memcmp(bytes.data(), "\x93NUM", 4) == 0 ||
                                               std::memcmp(bytes.data(), "PK", 2) == 0);
    if (!isNumpy)
        return false;
    const MemoryFile file(bytes);
    frames::FrameRequest request;
    bool isRead = readsFrames(file.path(), request);
    request.rate_Hz = 100.0;
    request.axis = frames::FrameAxis::last;
    isRead = readsFrames(file.path(), request) || isRead;
    return readsThreeColumns(file.path()) || isRead;
}

bool frameArrays(Bytes bytes) {
    const core::FileKind kind =
        core::fileKindOf(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())
                             .substr(0, core::kFileKindBytes));
    if (kind != core::FileKind::hdf5 && kind != core::FileKind::matlab && kind != core::FileKind::matlab7)
        return false;
    // libhdf5 asks for the real path of a file, which one in memory does not have.
    const test::TemporaryFolder folder;
    const std::string path = folder.write("input", textOf(bytes));
    frames::FrameRequest request;
    request.rate_Hz = 100.0;
    request.axis = frames::FrameAxis::first;
    const bool isRead = readsFrames(path, request);
    return readsFrames(path, {}) || readsThreeColumns(path) || isRead;
}

bool frameTekscan(Bytes bytes) {
    return readsFrames(MemoryFile(bytes).path(), {});
}

bool frameTable(Bytes bytes) {
    const MemoryFile file(bytes);
    frames::FrameRequest request;
    const bool isOwn = readsFrames(file.path(), request);
    request.rate_Hz = 100.0;
    const bool isRead = readsFrames(file.path(), request);
    request.rate_Hz.reset();
    request.timeColumn = "1";
    return readsFrames(file.path(), std::move(request)) || isRead || isOwn;
}

} // namespace teleta::fuzz
