// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/devices/device_files.h"

#include "backend/vision/camera/camera_model.h"
#include "devices/wts/wts_config.h"

namespace teleta::cli {

using core::Need;

void ArrayFile::describeKeys(core::Keys& keys) {
    keys.word("kind", "wts", "A Weiss array");
    keys.text("name", name, "Name on the screen");
    keys.text("address", address, "The path of its serial port, or `tcp://HOST:PORT`");
    keys.whole("baud", baud, {9600, 4'000'000}, "Bits a second, of a serial port", Need::optional);
    if (const auto parsed = wts::parseWtsAddress(address, baud); !parsed)
        keys.refuse("address", parsed.error().message, parsed.error().expected);
}

void CameraFile::describeKeys(core::Keys& keys) {
    const core::WholeRange side{0, vision::kLargestSide_px};
    keys.word("kind", "camera", "A camera in a soft tube");
    keys.text("name", name, "Name on the screen");
    keys.text("source", source, "Number of the camera, or the path of a video");
    keys.whole("width_px", width_px, side, "Width of the image; 0: the camera's own", Need::optional);
    keys.whole("height_px", height_px, side, "Height of the image; 0: the camera's own", Need::optional);
    keys.number("rate_Hz", rate_Hz, core::NumberRange::between(0.0, 10'000.0),
                "Frames a second; 0: the camera's own", Need::optional);
}

} // namespace teleta::cli
