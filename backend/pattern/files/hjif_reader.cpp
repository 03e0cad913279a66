// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/bracelet/tactors.h"
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/hjif_values.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct HjifText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr long long kMostTicks = 1'000'000'000'000;
constexpr int kDeepestComposition = 8;
constexpr std::size_t kMostEffects = 200'000;
constexpr std::size_t kMostChannels = 65'536;

/// A frequency that the program wrote itself follows from the intensity and is no loss.
bool isOwnFrequency(double frequency_Hz, double intensity) {
    static const MotorProfile kMotor = MotorProfile::assumedCoinMotor();
    return frequency_Hz == static_cast<double>(hjifFrequency_Hz(kMotor, intensity));
}

bool isVibration(const std::string& modality) {
    return modality == "Vibrotactile" || modality == "Vibration" || modality == "Vibrotactile Texture" ||
           modality == "Other"; // what encoders write for sources that do not say
}

/// The size of a curve, with corners where it passes 0.
Track sizeOf(const Track& curve) {
    Track size;
    for (std::size_t k = 0; k < curve.size(); ++k) {
        if (k > 0 && curve[k - 1].intensity * curve[k].intensity < 0.0) {
            const double share = curve[k - 1].intensity / (curve[k - 1].intensity - curve[k].intensity);
            size.push_back({std::lerp(curve[k - 1].time_s, curve[k].time_s, share), 0.0});
        }
        size.push_back({curve[k].time_s, std::abs(curve[k].intensity)});
    }
    return size;
}

class HjifReader {
public:
    HjifReader(JsonReader& reader, LossCounter& losses, double timescale)
        : m_reader(reader)
        , m_losses(losses)
        , m_timescale(timescale) {}

    void perception(const ordered_json& perception, Pattern& pattern) {
        const std::string notes = m_reader.text(perception, "description", {});
        if (pattern.notes.empty())
            pattern.notes = notes;
        if (!isVibration(m_reader.text(perception, "perception_modality", "Vibrotactile"))) {
            m_losses.add(LossKind::modality);
            return;
        }
        m_library.clear();
        if (const ordered_json* library = m_reader.find(perception, "effect_library")) {
            for (const ordered_json& effect : m_reader.array(*library, 0, kMostEffects))
                m_library[m_reader.integer(m_reader.member(effect, "id"), -kMostTicks, kMostTicks)] = &effect;
        }
        for (const ordered_json& found :
             m_reader.array(m_reader.member(perception, "channels"), 0, kMostChannels)) {
            if (!m_reader.error())
                channel(found, pattern);
        }
    }

    void build(Pattern& pattern) {
        m_losses.add(LossKind::overlap, {}, m_tracks.build(pattern));
        if (pattern.objects.size() > Pattern::kMostObjects)
            m_reader.fail(m_reader.root(), HjifText::tr("too many pieces overlap"),
                          HjifText::tr("a pattern of at most %1 objects").arg(Pattern::kMostObjects));
        if (m_played == 0 && m_dropped > 0)
            m_reader.fail(m_reader.root(), HjifText::tr("a pattern cannot represent this"),
                          HjifText::tr("vectorial waves, transients or curves of vibration"));
        if (m_unplaced > 1 || (m_unplaced == 1 && m_channels > 1))
            m_losses.add(LossKind::place, {}, m_unplaced);
    }

    /// The file has a single channel that does not say where it belongs.
    [[nodiscard]] bool isOneSignal() const { return m_channels == 1 && m_unplaced == 1; }

private:
    void channel(const ordered_json& channel, Pattern& pattern) {
        const std::size_t tactor = tactorOf(channel);
        if (m_reader.error())
            return;
        if (tactor >= core::kTactors || m_taken[tactor]) {
            m_losses.add(LossKind::channel);
            ++m_dropped;
            return;
        }
        m_taken[tactor] = true;
        ++m_channels;
        if (const ordered_json* mask = m_reader.find(channel, "body_part_mask")) {
            const long long bits = m_reader.integer(*mask, 0, 0xFFFF'FFFFLL);
            if ((bits & (kHjifLeftForearm | kHjifLeftWrist)) != 0)
                pattern.arm = Arm::left;
        }
        m_tactor = tactor;
        m_gain = m_reader.number(channel, "gain", 0.0, 1e6, 1.0);
        for (const ordered_json& found :
             m_reader.array(m_reader.member(channel, "bands"), 0, Pattern::kMostObjects))
            band(found);
    }

    std::size_t tactorOf(const ordered_json& channel) {
        const std::size_t order = m_order++;
        const ordered_json* const found = m_reader.find(channel, "direction");
        double x = 0.0;
        double y = 0.0;
        if (found != nullptr) {
            x = m_reader.number(m_reader.member(*found, "X"), -128.0, 127.0);
            y = m_reader.number(m_reader.member(*found, "Y"), -128.0, 127.0);
        }
        if (x == 0.0 && y == 0.0) {
            ++m_unplaced;
            return order;
        }
        return core::wrappedTactor(std::lround(std::atan2(y, x) / core::kTactorAngle_rad));
    }

    enum class Band { vectorial, transient, curve, coded };

    void band(const ordered_json& band) {
        const ordered_json& type = m_reader.member(band, "band_type");
        const std::string name = m_reader.text(type);
        if (name == "VectorialWave")
            m_band = Band::vectorial;
        else if (name == "Transient")
            m_band = Band::transient;
        else if (name == "Curve")
            m_band = Band::curve;
        else if (name == "WaveletWave" || name == "Wavelet")
            m_band = Band::coded;
        else
            m_reader.fail(type, HjifText::tr("this name is unknown"),
                          "VectorialWave, Transient, Curve, WaveletWave");
        for (const ordered_json& found : m_reader.array(m_reader.member(band, "effects"), 0, kMostEffects))
            effect(found, 0.0, 0);
    }

    /// before: ticks at which what contains the effect begins.
    void effect(const ordered_json& effect, double before, int depth) {
        if (m_reader.error())
            return;
        if (++m_effects > kMostEffects || depth > kDeepestComposition) {
            m_reader.fail(effect, HjifText::tr("there are too many effects, or too many inside each other"),
                          HjifText::tr("at most %1").arg(kMostEffects));
            return;
        }
        const ordered_json& type = m_reader.member(effect, "effect_type");
        const std::string name = m_reader.text(type);
        const double position = before + ticks(m_reader.member(effect, "position"));
        if (name == "Reference") {
            const ordered_json& id = m_reader.member(effect, "id");
            const auto found = m_library.find(m_reader.integer(id, -kMostTicks, kMostTicks));
            if (found == m_library.end())
                m_reader.fail(id, HjifText::tr("there is no such effect in the library"),
                              HjifText::tr("the id of an effect in effect_library"));
            else
                content(*found->second, position, depth + 1);
            return;
        }
        content(effect, position, depth);
    }

    /// What an effect plays from a position on; its own position is not used.
    void content(const ordered_json& effect, double position, int depth) {
        const ordered_json& type = m_reader.member(effect, "effect_type");
        const std::string name = m_reader.text(type);
        if (name == "Composite") {
            for (const ordered_json& part :
                 m_reader.array(m_reader.member(effect, "composition"), 0, kMostEffects))
                this->effect(part, position, depth + 1);
            return;
        }
        if (name != "Basis") {
            m_reader.fail(type, HjifText::tr("this name is unknown"), "Basis, Reference, Composite");
            return;
        }
        if (m_band == Band::coded) {
            m_losses.add(LossKind::waveform, position / m_timescale);
            ++m_dropped;
            return;
        }
        ++m_played;
        const bool isSine = m_reader.text(effect, "base_signal", "Sine") == "Sine" &&
                            m_reader.number(effect, "phase", -1e6, 1e6, 0.0) == 0.0;
        if (!isSine && m_band == Band::vectorial)
            m_losses.add(LossKind::shape, position / m_timescale);
        const Track amplitudes = keyframes(effect, position);
        if (m_band == Band::transient) {
            for (const Breakpoint& at : amplitudes)
                burst(at);
        } else {
            if (m_band == Band::curve && !amplitudes.empty())
                m_losses.add(LossKind::curve, amplitudes.front().time_s);
            add(m_band == Band::curve ? sizeOf(amplitudes) : amplitudes);
        }
    }

    void burst(const Breakpoint& at) {
        // One at the end of the longest pattern comes early enough to be whole.
        const double begin_s = std::min(at.time_s, Pattern::kLongest_s - kBurst_s);
        m_losses.add(LossKind::burst, begin_s);
        add({{begin_s, at.intensity}, {std::min(begin_s + kBurst_s, Pattern::kLongest_s), at.intensity}});
    }

    /// The amplitudes of the keyframes. A vectorial wave lasts from its position to its last keyframe, with
    /// the first and last amplitude at its ends, and full amplitude without any.
    Track keyframes(const ordered_json& effect, double position) {
        Track lines;
        double last_s = position / m_timescale;
        const ordered_json& frames =
            m_reader.array(m_reader.member(effect, "keyframes"), 0, Pattern::kMostBreakpoints);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const ordered_json& keyframe = frames[i];
            const ordered_json& relative = m_reader.member(keyframe, "relative_position");
            double within = ticks(relative);
            if (isNegative(within, frames, i + 1)) {
                m_losses.add(LossKind::early, position / m_timescale);
                within = 0.0;
            }
            const double time_s = (position + within) / m_timescale;
            if (time_s > Pattern::kLongest_s || (time_s < last_s && m_band != Band::transient)) {
                m_reader.fail(relative, HjifText::tr("the times decrease or exceed the longest pattern"),
                              HjifText::tr("a time that is not before the previous one"));
                return {};
            }
            last_s = time_s;
            double size = 1.0;
            if (const ordered_json* amplitude = m_reader.find(keyframe, "amplitude_modulation")) {
                const double value = m_reader.number(*amplitude, -1.0, 1.0);
                size = std::abs(value);
                lines.push_back({time_s, m_band == Band::curve ? value : size});
            }
            if (const ordered_json* frequency = m_reader.find(keyframe, "frequency_modulation")) {
                if (!isOwnFrequency(m_reader.number(*frequency, -1e6, 1e6), size))
                    m_losses.add(LossKind::frequency, time_s);
            }
        }
        if (m_band == Band::vectorial) {
            const double begin_s = position / m_timescale;
            const double first = lines.empty() ? 1.0 : lines.front().intensity;
            if (lines.empty() || lines.front().time_s > begin_s)
                lines.insert(lines.begin(), {begin_s, first});
            if (lines.back().time_s < last_s)
                lines.push_back({last_s, lines.back().intensity});
        }
        return lines;
    }

    /// The reference encoder writes a place just before the effect as a number of 16 bits without a sign, as
    /// 65534 for -2; a keyframe after it begins anew. next: of the keyframe after it.
    bool isNegative(double within, const ordered_json& frames, std::size_t next) {
        constexpr double kFirst = 32'768.0;
        constexpr double kLast = 65'535.0;
        if (within < kFirst || within > kLast || m_band == Band::transient)
            return false;
        // Several may be just before the effect.
        constexpr std::size_t kMostWrapped = 8;
        for (const std::size_t end = std::min(frames.size(), next + kMostWrapped); next < end; ++next) {
            const double later = ticks(m_reader.member(frames[next], "relative_position"));
            if (later < within)
                return later < kFirst;
        }
        return false;
    }

    void add(Track lines) {
        m_points += lines.size();
        if (m_points > Pattern::kMostBreakpoints) {
            m_reader.fail(m_reader.root(), HjifText::tr("there are too many keyframes"),
                          HjifText::tr("at most %1").arg(Pattern::kMostBreakpoints));
            return;
        }
        for (Breakpoint& point : lines) {
            point.intensity *= m_gain;
            if (point.intensity > 1.0) {
                m_losses.add(LossKind::clipped, point.time_s);
                point.intensity = 1.0;
            }
        }
        m_tracks.add(m_tactor, std::move(lines));
    }

    double ticks(const ordered_json& value) {
        return static_cast<double>(m_reader.integer(value, 0, kMostTicks));
    }

    JsonReader& m_reader;
    LossCounter& m_losses;
    double m_timescale;
    TrackBuilder m_tracks;
    std::map<long long, const ordered_json*> m_library; ///< of the perception at hand
    std::array<bool, core::kTactors> m_taken{};
    std::size_t m_order = 0;
    std::size_t m_channels = 0; ///< on a tactor
    std::size_t m_unplaced = 0; ///< of them, or beyond them, those without a direction
    std::size_t m_effects = 0;
    std::size_t m_played = 0;
    std::size_t m_dropped = 0;
    std::size_t m_points = 0;
    std::size_t m_tactor = 0; ///< of the channel at hand
    double m_gain = 1.0;
    Band m_band = Band::vectorial;
};

} // namespace

core::Expected<PatternImport> patternFromHjif(std::string text, const std::string& file,
                                              const ImportOptions& options) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    (void)reader.text(reader.member(root, "version"));
    PatternImport result;
    LossCounter losses;
    result.pattern.name = reader.text(root, "description", {});
    HjifReader parts(reader, losses, reader.number(root, "timescale", 1.0, 1e9, kHjifTimescale));
    for (const ordered_json& perception : reader.array(reader.member(root, "perceptions"), 0, 64)) {
        if (!reader.error())
            parts.perception(perception, result.pattern);
    }
    if (!reader.error())
        parts.build(result.pattern);
    if (reader.error())
        return core::Unexpected(*reader.error());
    result.oneSignal = parts.isOneSignal();
    if (result.oneSignal)
        placeSignal(result.pattern, options, {}, losses);
    result.losses = losses.take();
    return result;
}

} // namespace teleta::pattern
