// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace teleta::pattern {

/// What differs between a pattern and the file that it was read from or written to.
enum class LossKind {
    // when read
    frequency,   ///< frequencies and sharpness; those of the motors follow the intensity
    shape,       ///< waves that are no sines, or begin in another phase
    burst,       ///< short pulses that became bursts of kBurst_s
    longer,      ///< the pattern ends after the file, so that its last burst is whole
    oneSignal,   ///< one signal, put on the tactors in detail
    place,       ///< channels without a direction, put on the tactors in their order
    channel,     ///< channels for which no tactor is left
    otherArm,    ///< effects for the other arm
    otherDevice, ///< effects for other devices or body parts
    modality,    ///< perceptions that are not vibration
    disabled,    ///< tracks that are switched off
    overlap,     ///< pieces that overlap on a tactor, of which the stronger one counts
    path,        ///< paths that are shared among the nearest motors
    point,       ///< paths and envelopes of a single point, which have no length
    audio,       ///< sounds
    envelope,    ///< events with attack, decay or release
    parameter,   ///< parameters of a kind that a pattern does not have
    waveform,    ///< coded wave forms
    curve,       ///< curves of displacement, of which the size is played
    clipped,     ///< intensities beyond 1
    early,       ///< keyframes before the start of their effect, which count from it
    // when written
    objects,  ///< objects that are written as what they play
    steps,    ///< slopes that became steps; detail: the largest difference
    rounding, ///< points whose time was rounded to milliseconds
};

/// One kind of loss in a file.
struct Loss {
    LossKind kind{};
    std::size_t count = 0;         ///< how many values, effects or tracks
    std::optional<double> first_s; ///< where the first one is in the pattern
    std::string where;             ///< the first file of an archive that has it
    std::string detail;            ///< see LossKind

    bool operator==(const Loss&) const = default;
};

/// For programs: "frequency", "other-arm".
[[nodiscard]] const char* toString(LossKind kind);

/// For people, one sentence with number and place. Thread: any (pure).
[[nodiscard]] std::string describe(const Loss& loss);

/// Counts losses by kind, in the order in which they were first met. Thread: one.
class LossCounter {
public:
    void add(LossKind kind, std::optional<double> at_s = std::nullopt, std::size_t count = 1);
    /// Nothing is counted when the detail is empty.
    void note(LossKind kind, std::size_t count, std::string detail);
    /// where: of what is added from now on.
    void setWhere(std::string where) { m_where = std::move(where); }

    [[nodiscard]] std::size_t count(LossKind kind) const;
    [[nodiscard]] std::vector<Loss> take() { return std::move(m_losses); }

private:
    Loss& of(LossKind kind);

    std::vector<Loss> m_losses;
    std::string m_where;
};

} // namespace teleta::pattern
