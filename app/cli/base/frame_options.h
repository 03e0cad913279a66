// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/contact/taxels/taxel_frame.h"
#include "backend/core/data/array_layout.h"
#include "backend/core/data/taxel_layout.h"
#include "backend/core/error.h"
#include "backend/frames/frame_reader.h"
#include "backend/frames/frame_request.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace teleta::cli {

/// Options that say what the frames in some files are, the same for all commands that read frames.
struct ArrayOptions {
    double pitch_mm = 3.4;
    std::string tare; ///< a file, or a word of --tare
    bool inverted = false;
    std::vector<int> dead; ///< numbers of taxels that are not used

    void declare(CLI::App& app);
    /// The option --layout, of commands that take any array.
    void declareLayout(CLI::App& app);

    /// What is known of a file of frames. Error: as taxels::readLayout(). Throws CLI::ValidationError when
    /// the options do not fit each other.
    [[nodiscard]] core::Expected<frames::FrameRequest> request(const std::string& path) const;
    /// The file of --tare; empty: there is none.
    [[nodiscard]] std::string tarePath() const;
    /// The file of --layout; empty: there is none.
    [[nodiscard]] const std::string& layoutPath() const { return m_layoutPath; }
    /// N of one unit, as the file of --layout says it. unit: that of the frames; frames that say themselves
    /// that they are in N, although the layout has another unit, are not multiplied.
    [[nodiscard]] core::Expected<std::optional<double>> newtonsPerUnit(const std::string& unit) const;
    /// The threshold of loads in this unit: the given one, or that of --layout, or the usual one. Throws
    /// CLI::ValidationError when there is none of these.
    [[nodiscard]] core::Expected<double> threshold(const std::optional<double>& given,
                                                   const std::string& unit) const;
    /// Tare, direction and dead taxels of an array. Reads the tare's file, or path, the recording, for the
    /// tare. Throws CLI::ValidationError when a dead taxel is none of the array.
    [[nodiscard]] core::Expected<contact::ConditioningSettings> conditioning(const core::TaxelLayout& layout,
                                                                             const std::string& path) const;

private:
    int m_rows = core::ArrayLayout{}.rows;
    std::string m_columns; ///< of the array: a number; or of a table: ranges
    std::optional<double> m_rate_Hz;
    std::string m_array;
    std::string m_axis = "auto";
    std::string m_timeColumn;
    std::string m_timeUnit;
    std::string m_layoutPath;
    CLI::Option* m_rowsOption = nullptr;
    CLI::Option* m_pitchOption = nullptr;
};

/// Warns of what a file of frames says and nothing heeds.
void warnOfUnused(const frames::FrameReader& frames);

/// Throws CLI::ValidationError that names the option when the output would replace one of the inputs.
void refuseToReplace(const std::string& output, std::span<const std::string> inputs,
                     const char* option = "--out");

/// Arguments and options of the commands that compute something of each tactile frame.
struct FrameOptions {
    std::string path;
    ArrayOptions array;
    std::optional<double> threshold; ///< in the unit of the loads; see openFrames()
    std::optional<double> gain;      ///< N of one unit
    std::string gainsPath;           ///< of the taxels
    bool weighted = false;
    bool automaticThreshold = false;
    bool activeOnly = false;
    bool summit = false;
    std::optional<double> noise_N; ///< standard deviation of a taxel's load
    double noiseHeight = contact::SegmentationSettings{}.noiseHeight;
    int minimumTaxels = contact::SegmentationSettings{}.minimumTaxels;
    RowOptions output;

    void declare(CLI::App& app);

    [[nodiscard]] contact::FeatureSettings featureSettings() const;
    [[nodiscard]] contact::SegmentationSettings segmentationSettings() const;
};

/// One frame after tare and gain.
struct ConditionedFrame {
    double time_s = 0.0;
    std::span<const float> load_N;
    std::span<const std::uint8_t> dead; ///< 1: the taxel is left out
};

/// A recording of frames that is open.
struct OpenFrames {
    frames::FrameReader reader;
    double gain = 1.0;
    std::string loadUnit; ///< of the loads: N after a gain, and where nobody tells a unit

    /// A grid of loads; what else there is goes through analyseFrames().
    [[nodiscard]] bool isGridOfLoads() const {
        return reader.taxels().isGrid() && !reader.taxels().isVector();
    }
};

/// Opens the recording that the options name, and warns where its values are no forces. Sets the options'
/// threshold, which depends on the unit of the loads. Error: as frames::FrameReader::open(). Throws
/// CLI::ValidationError when the options do not fit each other.
[[nodiscard]] core::Expected<OpenFrames> openFrames(FrameOptions& options);

/// Reads a recording of a grid of loads frame by frame, conditions each frame and hands it to write(), which
/// adds rows of the given columns. Ends at the end of the file, at the first error, with an interruption (the
/// output is completed, the error is ErrorKind::cancelled), or when the output fails. Throws
/// CLI::ValidationError when the options do not fit each other.
[[nodiscard]] core::Expected<void>
processFrames(const FrameOptions& options, OpenFrames frames, const std::vector<std::string>& columns,
              const std::function<void(const ConditionedFrame&, RowOutput&)>& write);

/// The same of any array, with contacts and features of each frame. --summit and, for contacts,
/// --auto-threshold are for grids of loads.
[[nodiscard]] core::Expected<void>
analyseFrames(const FrameOptions& options, OpenFrames frames, const std::vector<std::string>& columns,
              const std::function<void(double time_s, const contact::TaxelFrame&, RowOutput&)>& write);

} // namespace teleta::cli
