// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/tact_layout.h"
#include "backend/pattern/model/track_builder.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct TactText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

QString unknownName() {
    return TactText::tr("this name is unknown");
}

constexpr double kMost_ms = Pattern::kLongest_s * 1000.0;
constexpr std::size_t kMostPoints = 1000; ///< of one feedback
/// A path is followed in pieces of at most this length, and at least so many between two of its points.
constexpr double kPathPiece_s = 0.005;
constexpr int kFewestPathPieces = 16;

struct PathPoint {
    double time_s = 0.0;
    double x = 0.0;
    double y = 0.0;
    double intensity = 0.0;
};

/// The share of the energy that each motor has of a point; the sum is 1.
std::array<double, core::kTactors> energyShares(double x, double y) {
    std::array<double, core::kTactors> shares{};
    for (std::size_t motor = 0; motor < core::kTactors; ++motor) {
        const TactPlace place = tactPlace(motor);
        shares[motor] =
            std::max(0.0, 1.0 - 2.0 * std::abs(place.x - x)) * std::max(0.0, 1.0 - std::abs(place.y - y));
    }
    return shares;
}

/// How an intensity changes during a piece of feedback. share: 0..1 of its time.
double fade(const std::string& playback, double share) {
    if (playback == "FADE_IN")
        return share;
    if (playback == "FADE_OUT")
        return 1.0 - share;
    if (playback == "FADE_IN_OUT")
        return 1.0 - std::abs(2.0 * share - 1.0);
    return 1.0;
}

class TactReader {
public:
    TactReader(JsonReader& reader, LossCounter& losses, std::optional<Arm> arm)
        : m_reader(reader)
        , m_losses(losses)
        , m_chosen(arm) {}

    void project(const ordered_json& project, Pattern& pattern) {
        const ordered_json& tracks = m_reader.array(m_reader.member(project, "tracks"), 0, 1000);
        for (const ordered_json& track : tracks)
            look(track);
        if (m_reader.error())
            return;
        if (!m_hasForearm && m_otherModes != nullptr) {
            m_reader.fail(*m_otherModes, TactText::tr("this effect is for other devices"),
                          "ForearmL, ForearmR");
            return;
        }
        const bool left = m_hasArm[0] || (!m_hasArm[1] && m_hasLeftKey);
        pattern.arm = m_chosen.value_or(left ? Arm::left : Arm::right);
        for (const ordered_json& track : tracks) {
            if (!m_reader.boolean(track, "enable", true)) {
                m_losses.add(LossKind::disabled);
                continue;
            }
            for (const ordered_json& effect : effectsOf(track)) {
                if (!m_reader.error())
                    this->effect(effect, pattern);
            }
        }
        m_losses.add(LossKind::overlap, {}, m_tracks.build(pattern));
        if (pattern.objects.size() > Pattern::kMostObjects)
            m_reader.fail(m_reader.root(), TactText::tr("too many pieces overlap"),
                          TactText::tr("a pattern of at most %1 objects").arg(Pattern::kMostObjects));
    }

    [[nodiscard]] bool hasBothArms() const { return m_hasArm[0] && m_hasArm[1]; }

private:
    const ordered_json& effectsOf(const ordered_json& track) {
        return m_reader.array(m_reader.member(track, "effects"), 0, Pattern::kMostObjects);
    }

    /// The feedback of a device in the mode that it plays.
    const ordered_json& feedbackOf(const ordered_json& device, bool& isPath) {
        const ordered_json* const mode = m_reader.find(device, "mode");
        const std::string name = mode == nullptr ? "DOT_MODE" : m_reader.text(*mode);
        isPath = name == "PATH_MODE";
        if (!isPath && name != "DOT_MODE" && mode != nullptr)
            m_reader.fail(*mode, unknownName(), "DOT_MODE, PATH_MODE");
        const ordered_json& content = m_reader.member(device, isPath ? "pathMode" : "dotMode");
        return m_reader.array(m_reader.member(content, "feedback"), 0, Pattern::kMostBreakpoints);
    }

    bool plays(const ordered_json& device) {
        bool isPath = false;
        for (const ordered_json& feedback : feedbackOf(device, isPath)) {
            if (!m_reader.array(m_reader.member(feedback, "pointList"), 0, kMostPoints).empty())
                return true;
        }
        return false;
    }

    /// Finds out which arms have effects.
    void look(const ordered_json& track) {
        if (!m_reader.boolean(track, "enable", true))
            return;
        for (const ordered_json& effect : effectsOf(track)) {
            const ordered_json& modes = m_reader.member(effect, "modes");
            const ordered_json* const left = m_reader.find(modes, kTactLeft);
            const ordered_json* const right = m_reader.find(modes, kTactRight);
            m_hasLeftKey = m_hasLeftKey || left != nullptr;
            m_hasForearm = m_hasForearm || left != nullptr || right != nullptr;
            if (left == nullptr && right == nullptr && m_otherModes == nullptr)
                m_otherModes = &modes;
            m_hasArm[0] = (left != nullptr && plays(*left)) || m_hasArm[0];
            m_hasArm[1] = (right != nullptr && plays(*right)) || m_hasArm[1];
            if (m_reader.error())
                return;
        }
    }

    void effect(const ordered_json& effect, Pattern& pattern) {
        const double start_s = time_s(m_reader.member(effect, "startTime"), 0.0);
        if (const ordered_json* length = m_reader.find(effect, "offsetTime"))
            pattern.duration_s = std::max(pattern.duration_s, time_s(*length, start_s));
        const char* const side = pattern.arm == Arm::left ? kTactLeft : kTactRight;
        const char* const other = pattern.arm == Arm::left ? kTactRight : kTactLeft;
        const ordered_json& modes = m_reader.member(effect, "modes");
        if (m_reader.error() || !modes.is_object())
            return;
        for (const auto& [name, device] : modes.items()) {
            if (name == side)
                this->device(device, start_s);
            else if (name == other && plays(device))
                m_losses.add(LossKind::otherArm, start_s);
            else if (name != other && device.is_object() && device.contains("mode") && plays(device))
                m_losses.add(LossKind::otherDevice, start_s);
        }
    }

    void device(const ordered_json& device, double start_s) {
        bool isPath = false;
        for (const ordered_json& feedback : feedbackOf(device, isPath)) {
            if (m_reader.error())
                return;
            if (isPath)
                path(feedback, start_s);
            else
                dots(feedback, start_s);
        }
    }

    std::string playbackOf(const ordered_json& feedback) {
        const ordered_json& type = m_reader.member(feedback, "playbackType");
        std::string name = m_reader.text(type);
        if (name != "NONE" && name != "FADE_IN" && name != "FADE_OUT" && name != "FADE_IN_OUT")
            m_reader.fail(type, unknownName(), "NONE, FADE_IN, FADE_OUT, FADE_IN_OUT");
        return name;
    }

    const ordered_json& pointsOf(const ordered_json& feedback) {
        return m_reader.array(m_reader.member(feedback, "pointList"), 0, kMostPoints);
    }

    void dots(const ordered_json& feedback, double start_s) {
        const ordered_json& end = m_reader.member(feedback, "endTime");
        const double begin_s = time_s(m_reader.member(feedback, "startTime"), start_s);
        const double end_s = time_s(end, start_s);
        if (end_s < begin_s)
            m_reader.fail(end, TactText::tr("the times decrease or exceed the longest pattern"),
                          TactText::tr("a time that is not before the start"));
        const std::string playback = playbackOf(feedback);
        for (const ordered_json& point : pointsOf(feedback)) {
            const auto tactor = static_cast<std::size_t>(
                m_reader.integer(m_reader.member(point, "index"), 0, core::kTactors - 1));
            const double intensity = m_reader.number(m_reader.member(point, "intensity"), 0.0, 1.0);
            if (m_reader.error())
                return;
            Track lines;
            for (const double share : {0.0, 0.5, 1.0}) {
                if (share != 0.5 || playback == "FADE_IN_OUT")
                    lines.push_back({std::lerp(begin_s, end_s, share), intensity * fade(playback, share)});
            }
            if (end_s > begin_s)
                add(tactor, std::move(lines));
        }
    }

    void path(const ordered_json& feedback, double start_s) {
        const std::string playback = playbackOf(feedback);
        std::vector<PathPoint> points;
        for (const ordered_json& found : pointsOf(feedback)) {
            const ordered_json& time = m_reader.member(found, "time");
            points.push_back({time_s(time, start_s), m_reader.number(m_reader.member(found, "x"), 0.0, 1.0),
                              m_reader.number(m_reader.member(found, "y"), 0.0, 1.0),
                              m_reader.number(m_reader.member(found, "intensity"), 0.0, 1.0)});
            if (points.size() > 1 && points.back().time_s < points[points.size() - 2].time_s)
                m_reader.fail(time, TactText::tr("the times decrease"),
                              TactText::tr("a time that is not before the previous one"));
            if (m_reader.error())
                return;
        }
        if (points.empty())
            return;
        if (points.size() == 1 || points.back().time_s == points.front().time_s) {
            m_losses.add(LossKind::point, points.front().time_s);
            return;
        }
        m_losses.add(LossKind::path, points.front().time_s);
        follow(points, playback);
    }

    void follow(const std::vector<PathPoint>& points, const std::string& playback) {
        const double begin_s = points.front().time_s;
        const double length_s = points.back().time_s - begin_s;
        Tracks lines;
        for (std::size_t k = 1; k < points.size(); ++k) {
            const PathPoint& a = points[k - 1];
            const PathPoint& b = points[k];
            if (a.time_s == b.time_s)
                continue;
            const double needed = std::ceil((b.time_s - a.time_s) / kPathPiece_s);
            const double pieces = std::max<double>(needed, kFewestPathPieces);
            m_points += static_cast<std::size_t>(pieces) * core::kTactors;
            if (m_points > Pattern::kMostBreakpoints) {
                m_reader.fail(m_reader.root(), TactText::tr("the paths are too long"),
                              TactText::tr("at most %1 points").arg(Pattern::kMostBreakpoints));
                return;
            }
            for (double piece = 0.0; piece <= pieces; piece += 1.0) {
                const double share = piece / pieces;
                const double time_s = std::lerp(a.time_s, b.time_s, share);
                const double intensity = std::lerp(a.intensity, b.intensity, share) *
                                         fade(playback, std::min(1.0, (time_s - begin_s) / length_s));
                const auto shares = energyShares(std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share));
                for (std::size_t motor = 0; motor < core::kTactors; ++motor)
                    lines[motor].push_back({time_s, intensity * std::sqrt(shares[motor])});
            }
        }
        for (std::size_t motor = 0; motor < core::kTactors; ++motor) {
            for (Track& stretch : stretches(lines[motor]))
                add(motor, std::move(stretch));
        }
    }

    void add(std::size_t tactor, Track lines) { m_tracks.add(tactor, std::move(lines)); }

    /// A time in ms after a start.
    double time_s(const ordered_json& value, double start_s) {
        const double ms = m_reader.number(value, 0.0, kMost_ms);
        if (start_s + 1e-3 * ms > Pattern::kLongest_s)
            m_reader.fail(value, TactText::tr("the times decrease or exceed the longest pattern"),
                          TactText::tr("at most %1 s").arg(Pattern::kLongest_s));
        return (1000.0 * start_s + ms) / 1000.0;
    }

    JsonReader& m_reader;
    LossCounter& m_losses;
    std::optional<Arm> m_chosen;
    TrackBuilder m_tracks;
    std::array<bool, 2> m_hasArm{}; ///< left, right: something plays there
    bool m_hasForearm = false;
    bool m_hasLeftKey = false;
    const ordered_json* m_otherModes = nullptr; ///< of the first effect without a forearm
    std::size_t m_points = 0;
};

} // namespace

core::Expected<PatternImport> patternFromTact(std::string text, const std::string& file,
                                              const ImportOptions& options) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& project = reader.member(reader.root(), "project");
    PatternImport result;
    LossCounter losses;
    if (!reader.error()) {
        result.pattern.name = reader.text(project, "name", {});
        result.pattern.notes = reader.text(project, "description", {});
    }
    TactReader tact(reader, losses, options.arm);
    if (!reader.error())
        tact.project(project, result.pattern);
    if (reader.error())
        return core::Unexpected(*reader.error());
    result.bothArms = tact.hasBothArms();
    result.losses = losses.take();
    return result;
}

} // namespace teleta::pattern
