// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct AhapText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr std::size_t kMostParts = 100'000;
constexpr double kMostValue = 1e6;

/// An event that plays, before the intensity control is applied.
struct Event {
    double begin_s = 0.0;
    double end_s = 0.0;
    double intensity = 1.0;
    bool isTransient = false;
};

double clipped(double value, double time_s, LossCounter& losses) {
    if (value > 1.0)
        losses.add(LossKind::clipped, time_s);
    return std::clamp(value, 0.0, 1.0);
}

double intensityBetween(const Breakpoint& a, const Breakpoint& b, double time_s) {
    const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
    return a.intensity + share * (b.intensity - a.intensity);
}

/// The value of a control from a time on. lines: begins at 0 s; the last value stays.
double valueFrom(const Track& lines, double time_s) {
    const auto after = std::ranges::upper_bound(lines, time_s, {}, &Breakpoint::time_s);
    return after == lines.end() ? lines.back().intensity
                                : intensityBetween(*std::prev(after), *after, time_s);
}

/// The value of a control up to a time > 0.
double valueUpTo(const Track& lines, double time_s) {
    const auto at = std::ranges::lower_bound(lines, time_s, {}, &Breakpoint::time_s);
    return at == lines.end() ? lines.back().intensity : intensityBetween(*std::prev(at), *at, time_s);
}

/// One course of the intensity control: 1 until the first piece; a piece holds its last value until the next
/// one begins, which ends it.
Track controlOf(std::vector<Track> pieces) {
    std::ranges::stable_sort(pieces, {}, [](const Track& piece) { return piece.front().time_s; });
    Track lines{{0.0, 1.0}};
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const double end_s =
            k + 1 < pieces.size() ? pieces[k + 1].front().time_s : std::numeric_limits<double>::infinity();
        lines.push_back({pieces[k].front().time_s, lines.back().intensity});
        const Track& points = pieces[k];
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].time_s > end_s) {
                lines.push_back({end_s, intensityBetween(points[i - 1], points[i], end_s)});
                break;
            }
            lines.push_back(points[i]);
        }
    }
    return lines;
}

/// Straight lines for the square of a straight line, within kBakeTolerance: n pieces of a rise by d are off
/// by at most (d / n)^2 / 4.
void addSquare(Track& lines, const Breakpoint& from, const Breakpoint& to) {
    const double rise = std::abs(to.intensity - from.intensity);
    const int pieces = std::max(1, static_cast<int>(std::ceil(rise / (2.0 * std::sqrt(kBakeTolerance)))));
    for (int k = 1; k <= pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        const double value = std::lerp(from.intensity, to.intensity, share);
        lines.push_back({std::lerp(from.time_s, to.time_s, share), value * value});
    }
}

/// The amplitude of an event is the square of its intensity times the control.
Track amplitudeOf(const Event& event, const Track& control) {
    if (event.isTransient) {
        const double value = event.intensity * valueFrom(control, event.begin_s);
        return {{event.begin_s, value * value}, {event.end_s, value * value}};
    }
    Track values{{event.begin_s, event.intensity * valueFrom(control, event.begin_s)}};
    const auto first = std::ranges::upper_bound(control, event.begin_s, {}, &Breakpoint::time_s);
    for (auto point = first; point != control.end() && point->time_s < event.end_s; ++point)
        values.push_back({point->time_s, event.intensity * point->intensity});
    values.push_back({event.end_s, event.intensity * valueUpTo(control, event.end_s)});
    Track lines{{values.front().time_s, values.front().intensity * values.front().intensity}};
    for (std::size_t k = 1; k < values.size(); ++k)
        addSquare(lines, values[k - 1], values[k]);
    return lines;
}

class AhapReader {
public:
    AhapReader(JsonReader& reader, LossCounter& losses, bool isOwn)
        : m_reader(reader)
        , m_losses(losses)
        , m_isOwn(isOwn) {}

    void part(const ordered_json& part) {
        if (!part.is_object() || part.empty()) {
            m_reader.fail(part, AhapText::tr("this part is not known"), "Event, Parameter, ParameterCurve");
            return;
        }
        if (const ordered_json* found = m_reader.find(part, "Event"))
            event(*found);
        else if (const ordered_json* value = m_reader.find(part, "Parameter"))
            parameter(*value);
        else if (const ordered_json* lines = m_reader.find(part, "ParameterCurve"))
            curve(*lines);
        else
            m_losses.add(LossKind::parameter);
    }

    /// Error: too many points.
    void build(std::size_t tactor, Pattern& pattern) {
        const Track control = controlOf(std::move(m_control));
        TrackBuilder tracks;
        std::size_t points = 0;
        for (const Event& event : m_events) {
            Track lines = amplitudeOf(event, control);
            points += lines.size();
            if (points > Pattern::kMostBreakpoints) {
                tooMany();
                return;
            }
            tracks.add(tactor, std::move(lines));
        }
        Pattern signal;
        m_losses.add(LossKind::overlap, {}, tracks.build(signal));
        pattern.tracks[tactor] = std::move(signal.tracks[tactor]);
        pattern.objects.insert(pattern.objects.end(), signal.objects.begin(), signal.objects.end());
        pattern.duration_s = std::max(pattern.duration_s, signal.duration_s);
        if (pattern.objects.size() > Pattern::kMostObjects)
            tooMany();
    }

private:
    void tooMany() {
        m_reader.fail(m_reader.root(), AhapText::tr("too many pieces overlap"),
                      AhapText::tr("a pattern of at most %1 objects").arg(Pattern::kMostObjects));
    }

    double time_s(const ordered_json& object) {
        return m_reader.number(m_reader.member(object, "Time"), 0.0, Pattern::kLongest_s);
    }

    void event(const ordered_json& object) {
        const ordered_json& type = m_reader.member(object, "EventType");
        const std::string name = m_reader.text(type);
        Event event;
        event.begin_s = time_s(object);
        if (name.starts_with("Audio")) {
            m_losses.add(LossKind::audio, event.begin_s);
            return;
        }
        event.isTransient = name == "HapticTransient";
        if (!event.isTransient && name != "HapticContinuous") {
            m_reader.fail(type, AhapText::tr("this name is unknown"), "HapticTransient, HapticContinuous");
            return;
        }
        event.end_s = event.begin_s + kBurst_s;
        if (!event.isTransient) {
            const ordered_json& duration = m_reader.member(object, "EventDuration");
            event.end_s = event.begin_s + m_reader.number(duration, 0.0, Pattern::kLongest_s);
        }
        if (event.end_s > Pattern::kLongest_s)
            m_reader.fail(object, AhapText::tr("the times decrease or exceed the longest pattern"), {});
        if (const ordered_json* all = m_reader.find(object, "EventParameters"))
            eventParameters(*all, event);
        if (event.isTransient)
            m_losses.add(LossKind::burst, event.begin_s);
        if (event.end_s > event.begin_s)
            m_events.push_back(event);
    }

    void eventParameters(const ordered_json& all, Event& event) {
        bool hasEnvelope = false;
        for (const ordered_json& parameter : m_reader.array(all, 0, kMostParts)) {
            const std::string id = m_reader.text(m_reader.member(parameter, "ParameterID"));
            const double value =
                m_reader.number(m_reader.member(parameter, "ParameterValue"), -kMostValue, kMostValue);
            if (id == "HapticIntensity")
                event.intensity = clipped(value, event.begin_s, m_losses);
            else if (id == "HapticSharpness")
                frequency(event.begin_s, 1);
            else if (id == "AttackTime" || id == "DecayTime" || id == "ReleaseTime")
                hasEnvelope = hasEnvelope || value != 0.0;
            else if (id == "Sustained")
                hasEnvelope = hasEnvelope || value == 0.0;
            else
                m_losses.add(LossKind::parameter, event.begin_s);
        }
        if (hasEnvelope)
            m_losses.add(LossKind::envelope, event.begin_s);
    }

    /// The program writes one sharpness for all events, because a pattern has none.
    void frequency(double at_s, std::size_t count) {
        if (!m_isOwn)
            m_losses.add(LossKind::frequency, at_s, count);
    }

    /// Says whether a control is that of the intensity, and counts it as a loss otherwise.
    bool isIntensity(const ordered_json& object, double at_s, std::size_t points) {
        const std::string id = m_reader.text(m_reader.member(object, "ParameterID"));
        if (id == "HapticIntensityControl")
            return true;
        if (id == "HapticSharpnessControl")
            frequency(at_s, points);
        else if (id.starts_with("Audio"))
            m_losses.add(LossKind::audio, at_s);
        else if (id.ends_with("TimeControl"))
            m_losses.add(LossKind::envelope, at_s);
        else
            m_losses.add(LossKind::parameter, at_s);
        return false;
    }

    double controlValue(const ordered_json& object, double at_s) {
        const ordered_json& value = m_reader.member(object, "ParameterValue");
        return clipped(m_reader.number(value, -kMostValue, kMostValue), at_s, m_losses);
    }

    void parameter(const ordered_json& object) {
        const double at_s = time_s(object);
        if (isIntensity(object, at_s, 1))
            m_control.push_back({{at_s, controlValue(object, at_s)}});
    }

    void curve(const ordered_json& object) {
        const double begin_s = time_s(object);
        const ordered_json& points =
            m_reader.array(m_reader.member(object, "ParameterCurveControlPoints"), 0, kMostParts);
        if (m_reader.error() || !isIntensity(object, begin_s, points.size()))
            return;
        Track lines;
        for (const ordered_json& point : points) {
            const ordered_json& time = m_reader.member(point, "Time");
            const double at_s = begin_s + m_reader.number(time, 0.0, Pattern::kLongest_s);
            if (!lines.empty() && at_s < lines.back().time_s)
                m_reader.fail(time, AhapText::tr("the times decrease"),
                              AhapText::tr("a time that is not before the previous one"));
            if (m_reader.error())
                return;
            lines.push_back({at_s, controlValue(point, at_s)});
        }
        if (!lines.empty())
            m_control.push_back(std::move(lines));
    }

    JsonReader& m_reader;
    LossCounter& m_losses;
    bool m_isOwn;
    std::vector<Event> m_events;
    std::vector<Track> m_control;
};

core::Expected<std::string> addAhap(std::string text, const std::string& file, std::size_t tactor,
                                    Pattern& pattern, LossCounter& losses) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    (void)reader.number(root, "Version", 0.0, 1e6, 1.0);
    std::string source;
    bool isOwn = false;
    if (const ordered_json* metadata = reader.find(root, "Metadata")) {
        const std::string project = reader.text(*metadata, "Project", {});
        const std::string description = reader.text(*metadata, "Description", {});
        isOwn = reader.text(*metadata, "Created", {}) == kEditorName;
        if (pattern.name.empty())
            pattern.name = project;
        if (isOwn)
            source = description;
        else if (pattern.notes.empty())
            pattern.notes = description;
    }
    AhapReader parts(reader, losses, isOwn);
    for (const ordered_json& part : reader.array(reader.member(root, "Pattern"), 0, kMostParts)) {
        if (!reader.error())
            parts.part(part);
    }
    if (!reader.error())
        parts.build(tactor, pattern);
    if (reader.error())
        return core::Unexpected(*reader.error());
    return source;
}

} // namespace

core::Expected<PatternImport> patternFromAhap(std::string text, const std::string& file,
                                              const ImportOptions& options) {
    return importSignal(std::move(text), file, options, addAhap);
}

core::Expected<PatternImport> patternFromAhaps(std::vector<ZipEntry> entries, const std::string& file) {
    return importSignals(std::move(entries), file, ".ahap", addAhap);
}

} // namespace teleta::pattern
