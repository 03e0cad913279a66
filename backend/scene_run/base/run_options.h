// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/scene_run/base/labelled_frame.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace teleta::scene_run {

/// How a scene is run.
struct RunOptions {
    std::string name; ///< of the scene in the summary: its file without folder and extension
    std::uint64_t seed = 1;
    std::optional<double> duration_s; ///< > 0; empty: the scene's own
    std::string outFolder;            ///< made when it is missing; empty: no files
    std::string sceneText;            ///< the scene file, kept in the recording
    /// Called now and then with the simulated time; false ends the run early and completes its files.
    std::function<bool(double simulated_s, double duration_s)> goOn;
    /// Called with every frame of the tactile array of an array's or a servo's scene.
    std::function<void(const LabelledFrame& frame)> onFrame;

    /// Whether the run is to end early; asks goOn every so many steps.
    [[nodiscard]] bool endsAt(std::uint64_t step, std::uint64_t every, double simulated_s,
                              double whole_s) const {
        return step % every == 0 && goOn && !goOn(simulated_s, whole_s);
    }
};

} // namespace teleta::scene_run
