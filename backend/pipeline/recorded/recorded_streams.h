// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/core/bracelet/bracelet_device.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/device/device.h"
#include "backend/core/error.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/pipeline/touch/touch_snapshot.h"
#include "backend/recording/recording_types.h"

#include <QString>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::pipeline {

/// How the streams of the running system are recorded, and what is needed to use them as sources again.
/// Thread: any (pure).

inline constexpr std::size_t kFeatureValues = 12;
inline constexpr std::size_t kShearValues = 4; ///< of frames of vectors besides
inline constexpr std::size_t kTouchValues = 14;
inline constexpr std::size_t kWrenchValues = 6;

/// Name of the stream of an array's frames, in a recording that knows the array by a name.
[[nodiscard]] inline std::string framesStreamName(const std::string& name) {
    return name + "-frames";
}
/// Raw frames of an array, with the settings in force for them. name: of the stream. loads: how its loads
/// follow from them; null: nobody knows. countsLosses: as core::LossCounting has it.
[[nodiscard]] recording::StreamInfo arrayStream(const std::string& name,
                                                const core::SourceDescription& description,
                                                const ChannelSettings& settings,
                                                const FrameLoads* loads = nullptr, bool countsLosses = true);
/// The event that the settings of an array are others from now on, but for its time. stream: of its frames.
[[nodiscard]] recording::RecordingEvent settingsEvent(const std::string& stream,
                                                      const ChannelSettings& settings);
/// Whether the settings of an array changed while it was recorded: those of its stream are the first ones.
[[nodiscard]] bool settingsChanged(const std::vector<recording::RecordingEvent>& events,
                                   const std::string& stream);
/// What was computed of them, in this unit of load.
[[nodiscard]] recording::StreamInfo featureStream(const std::string& name,
                                                  const core::SourceDescription& description,
                                                  const std::string& loadUnit);
/// Joint samples of an arm, and which stream its skin is. chain: its links, where they are known.
[[nodiscard]] recording::StreamInfo armStream(const std::string& name,
                                              const core::ArmDescription& description,
                                              const std::string& skinStream,
                                              const arm_model::SerialChain* chain = nullptr);
/// Force and torque at an arm's tip. chain: names the tip, where it is known.
[[nodiscard]] recording::StreamInfo wrenchStream(const std::string& name,
                                                 const core::ArmDescription& description,
                                                 const arm_model::SerialChain* chain);
/// A frame of such a stream.
[[nodiscard]] std::array<double, kWrenchValues> wrenchValues(const core::WrenchSample& sample);
/// Numbers that an array tells or that follow from it, one frame each; columns: their names and units.
[[nodiscard]] recording::StreamInfo numberStream(const std::string& name,
                                                 const core::SourceDescription& description,
                                                 std::vector<recording::Column> columns);
/// Touches of an arm.
[[nodiscard]] recording::StreamInfo touchStream(const std::string& name,
                                                const core::ArmDescription& description);

/// Frames that were sent to a bracelet: a share of the full drive for each tactor.
[[nodiscard]] recording::StreamInfo
tactorStream(const std::string& name, const core::BraceletDescription& description, double rate_Hz);

/// A frame of a stream of features; NaN where a feature is not defined.
[[nodiscard]] std::array<double, kFeatureValues> featureValues(const contact::TactileFeatures& features);
/// Appends a frame of such a stream, with the shear of frames of vectors.
void appendFeatures(const contact::TactileFeatures& features, bool vectors, std::vector<double>& values);
/// A frame of a stream of touches; NaN where nothing is known.
[[nodiscard]] std::array<double, kTouchValues> touchValues(const TouchRecord& touch);

/// The error that the details of a stream do not say what it is. file: the recording; why: translated.
[[nodiscard]] core::Unexpected notDescribed(const recording::StreamInfo& stream, const std::string& file,
                                            const QString& why);
[[nodiscard]] core::Unexpected notDescribed(const recording::StreamInfo& stream, const std::string& file,
                                            const core::Error& why);

/// An array as it was recorded; description.recorded is set.
struct RecordedArray {
    core::SourceDescription description;
    ChannelSettings settings;
    std::optional<FrameLoads> loads; ///< nothing: its loads were not calibrated
    bool countsLosses = true;        ///< as core::LossCounting has it; files of older versions do not say it
};
/// file: for errors. chips: that tell their temperatures; 0: none, or their number is not known. Error:
/// badInput, the stream's details do not say what an array is, or have temperatures of the tare of another
/// number of chips.
[[nodiscard]] core::Expected<RecordedArray> recordedArray(const recording::StreamInfo& stream,
                                                          const std::string& file, std::size_t chips = 0);

/// An arm as it was recorded.
struct RecordedArm {
    core::ArmDescription description;
    std::string skinStream;
    std::shared_ptr<const arm_model::SerialChain> chain; ///< null: its links were not recorded
};
[[nodiscard]] core::Expected<RecordedArm> recordedArm(const recording::StreamInfo& stream,
                                                      const std::string& file);

} // namespace teleta::pipeline
