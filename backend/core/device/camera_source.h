// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/device.h"
#include "backend/core/interface.h"
#include "backend/core/threads/wakeup.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace teleta::core {

/// A greyscale picture, row by row without gaps. Copies share the immutable pixels.
struct GreyImage {
    std::shared_ptr<const std::uint8_t> pixels; ///< null: no picture
    int width_px = 0;
    int height_px = 0;

    [[nodiscard]] bool isEmpty() const { return pixels == nullptr || width_px <= 0 || height_px <= 0; }
};

/// A picture that shares the pixels of an OpenCV matrix of bytes, which must not be written to afterwards.
template <typename Matrix>
[[nodiscard]] GreyImage greyImageOf(Matrix pixels) {
    if (pixels.empty())
        return {};
    const auto kept = std::make_shared<Matrix>(pixels.isContinuous() ? std::move(pixels) : pixels.clone());
    return {{kept, kept->data}, kept->cols, kept->rows};
}

/// One frame as it left a camera.
struct CameraFrame {
    GreyImage image;              ///< empty: it could not be decoded
    std::int64_t time_ns = 0;     ///< steady clock at the read
    double capture_s = 0.0;       ///< the source's own time, from the first frame of the connection
    std::uint64_t number = 0;     ///< since the source was started; a gap is a loss
    bool discontinuity = false;   ///< connected again, or the source starts over
    std::uint64_t passedOver = 0; ///< frames dropped before it because a newer one was there
    /// What this frame and those after it are compared with, if a recording says so; empty: as before.
    GreyImage reference = {};

    /// Takes the place of an older frame that nobody will look at.
    void replace(const CameraFrame& older) {
        discontinuity = discontinuity || older.discontinuity;
        if (reference.isEmpty())
            reference = older.reference;
        passedOver += older.passedOver + 1;
    }
};

/// Describes a camera; constant while it is open.
struct CameraDescription {
    std::string name; ///< shown to people
    double nominalRate_Hz = 0.0;
    bool simulated = false; ///< the data is not real, which every view must show
    bool recorded = false;  ///< the data was recorded earlier
};

/// A camera, real, simulated or recorded: facade over a worker thread that reads and stamps frames.
/// Thread: start and stop from one controlling thread; pop() by one consumer; status() by any.
class CameraSource : public Interface {
public:
    [[nodiscard]] virtual const CameraDescription& description() const = 0;
    /// Starts the worker, which notifies the consumer after each frame.
    virtual void start(Wakeup& consumer) = 0;
    /// Ends the worker and waits for it. Idempotent.
    virtual void stop() = 0;
    /// Takes the oldest frame that waits; false when there is none.
    virtual bool pop(CameraFrame& frame) = 0;
    [[nodiscard]] virtual DeviceStatus status() const = 0;
    /// Null when the source is not a playback that can be controlled.
    [[nodiscard]] virtual PlaybackControl* playback() { return nullptr; }
};

/// Makes the frames of a simulated camera, one call a frame. The device paces the calls and stamps the
/// frames; the generator knows only simulated time. Thread: one.
class CameraGenerator {
public:
    virtual ~CameraGenerator() = default;
    [[nodiscard]] virtual const CameraDescription& description() const = 0;
    /// Advances by one frame. held: STOP is engaged, and what carries the camera stands still. Returns true
    /// if the frame does not follow from the one before: the world has started over.
    virtual bool next(GreyImage& image, bool held) = 0;
    [[nodiscard]] virtual double time_s() const = 0;
};

} // namespace teleta::core
