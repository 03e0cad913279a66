// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/frame_conditioner.h"
#include "backend/core/data/array_layout.h"
#include "backend/core/error.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace teleta::equilibration {

enum class TaxelState {
    good,
    dead,   ///< marked as dead, or without a finite reading in more than half of the frames
    weak,   ///< reads less than a tenth of what the others read, or nothing above its noise
    strong, ///< reads more than ten times what the others read
    stuck,  ///< reads one value while the load changes: saturated or broken
};

/// Name in files: "good", "dead", "weak", "strong", "stuck".
[[nodiscard]] std::string_view toString(TaxelState state);
[[nodiscard]] std::optional<TaxelState> taxelState(std::string_view text);

/// Factor on the load of one taxel that makes all taxels read the same under the same load.
struct TaxelGain {
    TaxelState state = TaxelState::good;
    double gain = 1.0;  ///< > 0; NaN unless the state is good
    double error = 0.0; ///< standard error of the gain; NaN unless the state is good

    [[nodiscard]] bool isGood() const { return state == TaxelState::good; }
};

/// Range of the gains of the good taxels.
struct GainRange {
    double least = 0.0;
    double greatest = 0.0;
    double largestError = 0.0; ///< largest standard error, as a share of the gain
};

/// The gains of all taxels, row-major, and their accuracy.
struct TaxelGains {
    core::ArrayLayout layout;
    std::vector<TaxelGain> taxels;

    std::size_t presses = 0;
    std::size_t frames = 0; ///< number of frames under load in all presses
    double level = 0.0;     ///< mean reading of the good taxels in these frames, in raw units above the tare
    double scatter =
        0.0; ///< root mean square of what the gains do not explain in a frame, as a share of its level
    double tilt_x = 0.0;   ///< change of the response along the length of the array, as a share of its mean
    double tilt_y = 0.0;   ///< the same along its width
    bool isTilted = false; ///< one of them exceeds kTilt significantly
    double repeatability =
        0.0; ///< root mean square deviation of the gains of one press from the mean of all; 0 for one press

    [[nodiscard]] std::size_t good() const;
    /// Empty when no taxel is good.
    [[nodiscard]] std::optional<GainRange> range() const;
    /// For ConditioningSettings::taxelGain: NaN where a taxel is not good.
    [[nodiscard]] std::vector<float> values() const;
};

/// Raw frames of one press and the conditioning of the array at that time.
struct GainPress {
    std::span<const float> frames;              ///< frames x layout.taxels() values, row-major
    contact::ConditioningSettings conditioning; ///< tare, direction and dead taxels; its gains are ignored
};

/// A press whose response changes by more than this from one end of the array to the other may have been
/// uneven.
inline constexpr double kTilt = 0.05;
/// Least number of frames under load in a press.
inline constexpr std::size_t kFewestPressFrames = 20;

/// Finds the gain of each taxel (equilibration) from frames in which an even load of unknown size presses on
/// the whole array: a bladder, a plate on foam, hands on a mat. The load may change over time.
///   y_fi = s (raw_fi - tare_i) = L_f r_i + noise,   gain_i = mean(r) / r_i
/// The load L_f of each frame and the response r_i of each taxel are fitted in turn, each as a robust slope
/// through the origin (Huber's weights). A frame in which a taxel has no reading, sparks or is clipped is
/// left out for that taxel only; the level of the frame is known from the others. Frames with less than half
/// the highest load are not used, where the highest load is the greatest one with kFewestPressFrames frames
/// between its half and itself. A taxel that is clipped at high loads is judged by its lower readings; frames
/// in which more than a quarter of the taxels are clipped are left out. The mean response of the good taxels
/// is kept, and with it the force of an even load. Over several presses the logarithms are averaged: when the
/// plate or bladder is turned by 180 degrees between two presses, an uneven pressure cancels. The standard
/// error combines the noise within the presses and the differences between them. Error: badInput: a press is
/// not a whole number of frames; refused: there is no press, too few frames are under load or below the end
/// of the taxels' range, or less than half of the taxels that are not marked dead feel the load. Thread: any
/// (pure).
[[nodiscard]] core::Expected<TaxelGains> findTaxelGains(const core::ArrayLayout& layout,
                                                        std::span<const GainPress> presses);

} // namespace teleta::equilibration
