// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::recording {

/// What the frames of a stream are; decides how they are read back.
enum class StreamKind {
    array,    ///< raw values of a tactile array, float32, shape rows x columns
    features, ///< what was computed of them, float64
    joints,   ///< angles, torques and references of an arm, float64
    touches,  ///< touches of an arm as they were estimated, float64
    camera,   ///< pictures, grey levels, shape height x width
    contacts, ///< contacts in them, float64, one frame a contact
    tactors,  ///< what was sent to a bracelet, float32
    wrench,   ///< force and torque as another program measured them, float64
    numbers,  ///< others of a source, which its columns name, float64
};

/// How the numbers of a stream are kept; little-endian.
enum class ValueType {
    float32,
    float64,
    grey8, ///< one byte a pixel, deflated (RFC 1950)
};

/// Their words in files.
[[nodiscard]] const char* toString(StreamKind kind);
[[nodiscard]] const char* toString(ValueType type);
/// The inverse; empty for any other word.
[[nodiscard]] std::optional<StreamKind> streamKindOf(std::string_view word);
[[nodiscard]] std::optional<ValueType> valueTypeOf(std::string_view word);

/// One column of a stream.
struct Column {
    std::string name; ///< as in the CSV files: "force_n"
    std::string unit; ///< "N"; empty: none
};

/// Describes a stream; constant within a recording.
struct StreamInfo {
    std::string name{}; ///< unique in the recording; the name of its CSV file
    StreamKind kind = StreamKind::array;
    ValueType type = ValueType::float32;
    std::string source{}; ///< the device, as people know it
    /// Of one frame, row-major; [height, width] of a picture, [h, w, 3] in colour; 0 where it varies.
    std::vector<std::size_t> shape{};
    std::string unit{};            ///< of all values; empty when the columns say it
    std::vector<Column> columns{}; ///< empty: t0, t1, ...
    double nominalRate_Hz = 0.0;
    std::string details{}; ///< JSON: what playback needs to know of the source; may be empty

    /// Values of a frame; of a picture, 0.
    [[nodiscard]] std::size_t channels() const;
    [[nodiscard]] std::size_t bytesPerValue() const { return type == ValueType::float64 ? 8 : 4; }
};

/// Describes a recording as a whole.
struct RecordingHead {
    std::string appVersion;
    std::string scene;         ///< name of the scene; empty: no simulation
    std::string sceneText;     ///< the scene file as it was; may be empty
    std::string configuration; ///< JSON of the settings in force at the start; may be empty
    std::int64_t start_ns = 0; ///< steady clock: zero of all times in exported files
};

/// Wall clock time at a steady time. A new one is written whenever the wall clock was set.
struct TimeAnchor {
    std::int64_t time_ns = 0;
    QDateTime utc;
};

/// An event during the recording.
struct RecordingEvent {
    std::int64_t time_ns = 0;
    std::string kind; ///< "mark", "stopped", "dropped", ...
    std::string text; ///< the note of a mark, the name of a stream
    double value = 0.0;
};

/// Kind of the marks that people set; value: number of the mark, by which it can be changed.
inline constexpr char kMark[] = "mark";
/// Frames of a stream (text) that the writer could not take: value.
inline constexpr char kDropped[] = "dropped";
/// The recording was ended, not cut off.
inline constexpr char kStopped[] = "stopped";

/// A change to a mark.
struct MarkChange {
    std::uint64_t number = 0;
    std::optional<std::string> note;                        ///< empty: the mark is taken away
    std::optional<std::int64_t> restored_ns = std::nullopt; ///< it is set again, at this time
};

} // namespace teleta::recording
