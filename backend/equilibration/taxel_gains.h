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
    dead,   ///< marked as dead, or without a reading in more than half of the frames
    weak,   ///< feels less than a tenth of what the others feel, or nothing above its noise
    strong, ///< feels more than ten times of what the others feel
    stuck,  ///< reads one value while the load changes: saturated, or broken
};

/// "good", "dead", ...: in files.
[[nodiscard]] std::string_view toString(TaxelState state);
[[nodiscard]] std::optional<TaxelState> taxelState(std::string_view text);

/// What one taxel's load is multiplied with, so that all taxels tell the same of the same load.
struct TaxelGain {
    TaxelState state = TaxelState::good;
    double gain = 1.0;  ///< > 0; NaN unless the state is good
    double error = 0.0; ///< its standard error; NaN unless the state is good

    [[nodiscard]] bool isGood() const { return state == TaxelState::good; }
};

/// Of the taxels that are good.
struct GainRange {
    double least = 0.0;
    double greatest = 0.0;
    double largestError = 0.0; ///< standard error as a share of the gain
};

/// The gains of all taxels, row-major, and how well they are known.
struct TaxelGains {
    core::ArrayLayout layout;
    std::vector<TaxelGain> taxels;

    std::size_t presses = 0;
    std::size_t frames = 0;     ///< under load, of all presses
    double level = 0.0;         ///< mean reading of a good taxel in these frames, raw units above the tare
    double scatter = 0.0;       ///< rms of what the gains do not explain in a frame, as a share of its level
    double tilt_x = 0.0;        ///< change of the response over the array's length, as a share of its mean
    double tilt_y = 0.0;        ///< over its width
    bool isTilted = false;      ///< more than kTilt, and not by chance
    double repeatability = 0.0; ///< rms deviation of one press's gains from the mean of all; 0 with one press

    [[nodiscard]] std::size_t good() const;
    /// Empty when no taxel is good.
    [[nodiscard]] std::optional<GainRange> range() const;
    /// For ConditioningSettings::taxelGain: NaN where a taxel is not good.
    [[nodiscard]] std::vector<float> values() const;
};

/// Raw frames of one press, and how the array was read then.
struct GainPress {
    std::span<const float> frames;              ///< frames x layout.taxels() values, row-major
    contact::ConditioningSettings conditioning; ///< tare, direction, dead taxels; its gains are not used
};

/// A load whose response changes by more than this from one end of the array to the other may have been
/// uneven.
inline constexpr double kTilt = 0.05;
/// A press needs so many frames under load.
inline constexpr std::size_t kFewestPressFrames = 20;

/// Finds the gain of each taxel (equilibration) from frames in which an even load of unknown size pressed on
/// the whole array: a bladder, a plate on foam, hands on a mat. The load may change.
///   y_fi = s (raw_fi - tare_i) = L_f r_i + noise,   gain_i = mean(r) / r_i
/// L_f, the load of a frame, and r_i, the response of a taxel, are fitted in turn, each as a robust slope
/// through the origin (Huber's weights): a frame in which a taxel has no reading, sparks or is clipped is
/// left out for this taxel alone, and its level is known from the others. Frames of less than half the
/// highest load are not used; the highest is the greatest below which, and above whose half, there are
/// kFewestPressFrames frames. A taxel that is clipped at high loads is judged by the lower ones, and frames
/// in which more than a quarter of the taxels are clipped are left out. The mean of the good taxels'
/// responses stays what it was, so that the force of an even load does. Of several presses the logarithms are
/// averaged: turn plate or bladder round by half between two presses, and what it pressed harder on one side
/// cancels. The error is made of the noise within and the differences between presses. Error: badInput, a
/// press is no whole number of frames; refused, there is no press, too few frames under load or below the end
/// of the taxels' range, or less than half of the taxels that are not marked dead feel it. Thread: any
/// (pure).
[[nodiscard]] core::Expected<TaxelGains> findTaxelGains(const core::ArrayLayout& layout,
                                                        std::span<const GainPress> presses);

} // namespace teleta::equilibration
