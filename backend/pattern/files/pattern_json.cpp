// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_json.h"

#include "backend/core/data/json_document.h"

#include <QCoreApplication>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace teleta::pattern {

namespace {

using core::JsonDocument;
using core::JsonReader;
using nlohmann::ordered_json;

struct PatternText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr const char* kFormat = "teleta-pattern";
constexpr const char* kMapFormat = "teleta-pattern-map";
constexpr int kVersion = 1;
constexpr int kMostTurnsInFile = 10'000;
constexpr double kMostAngle_rad = 1e6;

UnknownKeys unknownKeys(const ordered_json& object, std::initializer_list<std::string_view> known) {
    UnknownKeys unknown;
    if (!object.is_object())
        return unknown;
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::find(known, key) == known.end())
            unknown.emplace_back(key, value.dump());
    }
    return unknown;
}

void addUnknown(ordered_json& object, const UnknownKeys& unknown) {
    for (const auto& [key, value] : unknown)
        object[key] = ordered_json::parse(value);
}

/// Reads the name of an enumerator.
template <typename Value, typename From>
Value named(JsonReader& reader, const ordered_json& value, From from, Value missing, const char* expected) {
    const std::optional<Value> found = from(reader.text(value));
    if (!found)
        reader.fail(value, PatternText::tr("this name is unknown"), expected);
    return found.value_or(missing);
}

Easing easing(JsonReader& reader, const ordered_json& value) {
    return named(reader, value, easingFrom, Easing::linear, "linear, hold, ease-in, ease-out, ease-in-out");
}

void checkFormat(JsonReader& reader, const char* format) {
    const ordered_json& name = reader.member(reader.root(), "format");
    if (reader.text(name) != format)
        reader.fail(name, PatternText::tr("this is a different format"), format);
    const ordered_json& version = reader.member(reader.root(), "version");
    if (reader.integer(version, 1, 1'000'000) > kVersion)
        reader.fail(version, PatternText::tr("the file was written by a newer version"),
                    QString::number(kVersion));
}

/// Refuses the last of some points, whose time is read from `time`, when it is earlier than the one before.
template <typename Point>
void checkOrder(JsonReader& reader, const std::vector<Point>& points, const ordered_json& time) {
    if (points.size() > 1 && points.back().time_s < points[points.size() - 2].time_s)
        reader.fail(time, PatternText::tr("the times decrease"),
                    PatternText::tr("a time that is not before the previous one"));
}

Track track(JsonReader& reader, const ordered_json& value) {
    Track track;
    const ordered_json& points = reader.array(value, 0, Pattern::kMostBreakpoints);
    track.reserve(points.size());
    for (const ordered_json& entry : points) {
        const ordered_json& point = reader.array(entry, 2, 3);
        if (reader.error())
            break;
        track.push_back({reader.number(point[0], 0.0, Pattern::kLongest_s), reader.number(point[1], 0.0, 1.0),
                         point.size() > 2 ? easing(reader, point[2]) : Easing::linear});
        checkOrder(reader, track, point[0]);
    }
    return track;
}

// Reading objects.

double time_s(JsonReader& reader, const ordered_json& object, const char* key) {
    return reader.number(reader.member(object, key), 0.0, Pattern::kLongest_s);
}

double intensity(JsonReader& reader, const ordered_json& object, const char* key = "intensity") {
    return reader.number(object, key, 0.0, 1.0, 1.0);
}

int tactor(JsonReader& reader, const ordered_json& value) {
    return static_cast<int>(reader.integer(value, 1, core::kTactors)) - 1;
}

std::vector<int> tactors(JsonReader& reader, const ordered_json& object) {
    std::vector<int> tactors;
    for (const ordered_json& value :
         reader.array(reader.member(object, "tactors"), 0, Pattern::kMostBreakpoints))
        tactors.push_back(tactor(reader, value));
    return tactors;
}

std::optional<double> optionalTime_s(JsonReader& reader, const ordered_json& object, const char* key) {
    if (reader.find(object, key) == nullptr)
        return std::nullopt;
    return time_s(reader, object, key);
}

ObjectForm sweep(JsonReader& reader, const ordered_json& object) {
    return Sweep{time_s(reader, object, "start_s"), time_s(reader, object, "burst_s"),
                 optionalTime_s(reader, object, "onset_s"), tactors(reader, object),
                 intensity(reader, object)};
}

ObjectForm ring(JsonReader& reader, const ordered_json& object) {
    return Ring{time_s(reader, object, "start_s"),
                time_s(reader, object, "duration_s"),
                static_cast<int>(reader.integer(reader.member(object, "turns"), 1, kMostTurnsInFile)),
                tactor(reader, reader.member(object, "first_tactor")),
                reader.boolean(object, "counter_clockwise", true),
                optionalTime_s(reader, object, "burst_s"),
                intensity(reader, object)};
}

ObjectForm phantom(JsonReader& reader, const ordered_json& object) {
    return Phantom{time_s(reader, object, "start_s"),
                   time_s(reader, object, "duration_s"),
                   tactor(reader, reader.member(object, "first_tactor")),
                   tactor(reader, reader.member(object, "second_tactor")),
                   reader.number(reader.member(object, "balance_from"), 0.0, 1.0),
                   reader.number(reader.member(object, "balance_to"), 0.0, 1.0),
                   intensity(reader, object)};
}

ObjectForm ramp(JsonReader& reader, const ordered_json& object) {
    const ordered_json* const eased = reader.find(object, "easing");
    return Ramp{time_s(reader, object, "start_s"),
                time_s(reader, object, "duration_s"),
                tactors(reader, object),
                reader.number(reader.member(object, "from"), 0.0, 1.0),
                reader.number(reader.member(object, "to"), 0.0, 1.0),
                eased == nullptr ? Easing::linear : easing(reader, *eased)};
}

ObjectForm pulses(JsonReader& reader, const ordered_json& object) {
    return PulseTrain{time_s(reader, object, "start_s"),
                      time_s(reader, object, "duration_s"),
                      time_s(reader, object, "period_s"),
                      time_s(reader, object, "width_s"),
                      tactors(reader, object),
                      intensity(reader, object)};
}

ObjectForm stroke(JsonReader& reader, const ordered_json& object) {
    Stroke stroke{time_s(reader, object, "start_s"), {}, intensity(reader, object)};
    for (const ordered_json& entry :
         reader.array(reader.member(object, "points"), 0, Pattern::kMostBreakpoints)) {
        const ordered_json& point = reader.array(entry, 3, 3);
        if (reader.error())
            break;
        stroke.points.push_back({reader.number(point[0], 0.0, Pattern::kLongest_s),
                                 reader.number(point[1], -kMostAngle_rad, kMostAngle_rad),
                                 reader.number(point[2], 0.0, 1.0)});
        checkOrder(reader, stroke.points, point[0]);
    }
    return stroke;
}

struct ObjectType {
    const char* name;
    ObjectForm (*read)(JsonReader&, const ordered_json&);
    std::initializer_list<std::string_view> keys;
};

/// In the order of ObjectForm.
const std::array<ObjectType, std::variant_size_v<ObjectForm>>& objectTypes() {
    static const std::array<ObjectType, std::variant_size_v<ObjectForm>> kTypes{
        {{"sweep", sweep, {"type", "name", "start_s", "burst_s", "onset_s", "tactors", "intensity"}},
         {"ring",
          ring,
          {"type", "name", "start_s", "duration_s", "turns", "first_tactor", "counter_clockwise", "burst_s",
           "intensity"}},
         {"phantom",
          phantom,
          {"type", "name", "start_s", "duration_s", "first_tactor", "second_tactor", "balance_from",
           "balance_to", "intensity"}},
         {"ramp", ramp, {"type", "name", "start_s", "duration_s", "tactors", "from", "to", "easing"}},
         {"pulses",
          pulses,
          {"type", "name", "start_s", "duration_s", "period_s", "width_s", "tactors", "intensity"}},
         {"stroke", stroke, {"type", "name", "start_s", "points", "intensity"}}}};
    return kTypes;
}

PatternObject object(JsonReader& reader, const ordered_json& value) {
    PatternObject object;
    const ordered_json& type = reader.member(value, "type");
    const std::string name = reader.text(type);
    if (reader.error())
        return object;
    for (const ObjectType& candidate : objectTypes()) {
        if (name != candidate.name)
            continue;
        object.name = reader.text(value, "name", {});
        object.form = candidate.read(reader, value);
        object.unknown = unknownKeys(value, candidate.keys);
        return object;
    }
    reader.fail(type, PatternText::tr("this name is unknown"), "sweep, ring, phantom, ramp, pulses, stroke");
    return object;
}

// Writing objects.

ordered_json numbered(const std::vector<int>& tactors) {
    ordered_json numbers = ordered_json::array();
    for (const int index : tactors)
        numbers.push_back(index + 1);
    return numbers;
}

struct WriteForm {
    ordered_json& out;

    void operator()(const Sweep& sweep) const {
        out["start_s"] = sweep.start_s;
        out["burst_s"] = sweep.burst_s;
        if (sweep.onset_s)
            out["onset_s"] = *sweep.onset_s;
        out["tactors"] = numbered(sweep.tactors);
        out["intensity"] = sweep.intensity;
    }
    void operator()(const Ring& ring) const {
        out["start_s"] = ring.start_s;
        out["duration_s"] = ring.duration_s;
        out["turns"] = ring.turns;
        out["first_tactor"] = ring.firstTactor + 1;
        out["counter_clockwise"] = ring.counterClockwise;
        if (ring.burst_s)
            out["burst_s"] = *ring.burst_s;
        out["intensity"] = ring.intensity;
    }
    void operator()(const Phantom& phantom) const {
        out["start_s"] = phantom.start_s;
        out["duration_s"] = phantom.duration_s;
        out["first_tactor"] = phantom.first + 1;
        out["second_tactor"] = phantom.second + 1;
        out["balance_from"] = phantom.balanceFrom;
        out["balance_to"] = phantom.balanceTo;
        out["intensity"] = phantom.intensity;
    }
    void operator()(const Ramp& ramp) const {
        out["start_s"] = ramp.start_s;
        out["duration_s"] = ramp.duration_s;
        out["tactors"] = numbered(ramp.tactors);
        out["from"] = ramp.from;
        out["to"] = ramp.to;
        out["easing"] = toString(ramp.easing);
    }
    void operator()(const PulseTrain& train) const {
        out["start_s"] = train.start_s;
        out["duration_s"] = train.duration_s;
        out["period_s"] = train.period_s;
        out["width_s"] = train.width_s;
        out["tactors"] = numbered(train.tactors);
        out["intensity"] = train.intensity;
    }
    void operator()(const Stroke& stroke) const {
        out["start_s"] = stroke.start_s;
        ordered_json points = ordered_json::array();
        for (const StrokePoint& point : stroke.points)
            points.push_back(ordered_json::array({point.time_s, point.angle_rad, point.along}));
        out["points"] = std::move(points);
        out["intensity"] = stroke.intensity;
    }
};

std::string line(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// Writes one line per member, track and object, so that versions of a file can be compared.
std::string lines(const ordered_json& root) {
    std::string text = "{";
    const char* separator = "\n";
    for (const auto& [key, value] : root.items()) {
        text += separator + ("  " + line(key) + ": ");
        separator = ",\n";
        if ((key != "tracks" && key != "objects") || value.empty()) {
            text += line(value);
            continue;
        }
        text += "[";
        for (std::size_t i = 0; i < value.size(); ++i)
            text += (i == 0 ? "\n    " : ",\n    ") + line(value[i]);
        text += "\n  ]";
    }
    return text + "\n}\n";
}

} // namespace

core::Expected<Pattern> patternFromJson(std::string text, const std::string& file) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    const ordered_json& root = reader.root();
    checkFormat(reader, kFormat);
    Pattern pattern;
    pattern.id = reader.text(root, "id", {});
    pattern.name = reader.text(root, "name", {});
    if (const ordered_json* task = reader.find(root, "task"))
        pattern.task = named(reader, *task, taskFrom, Task::other, "shape, stiffness, other");
    if (const ordered_json* condition = reader.find(root, "condition"))
        pattern.condition =
            named(reader, *condition, conditionFrom, Condition::none, "static, dynamic, \"\"");
    if (const ordered_json* arm = reader.find(root, "arm"))
        pattern.arm = named(reader, *arm, armFrom, Arm::right, "right, left");
    pattern.notes = reader.text(root, "notes", {});
    if (const ordered_json* tags = reader.find(root, "tags")) {
        for (const ordered_json& tag : reader.array(*tags, 0, Pattern::kMostObjects))
            pattern.tags.push_back(reader.text(tag));
    }
    pattern.duration_s = time_s(reader, root, "duration_s");
    const ordered_json& tracks = reader.array(reader.member(root, "tracks"), core::kTactors, core::kTactors);
    for (std::size_t i = 0; i < tracks.size(); ++i)
        pattern.tracks[i] = track(reader, tracks[i]);
    if (const ordered_json* objects = reader.find(root, "objects")) {
        for (const ordered_json& value : reader.array(*objects, 0, Pattern::kMostObjects))
            pattern.objects.push_back(object(reader, value));
    }
    pattern.unknown = unknownKeys(root, {"format", "version", "id", "name", "task", "condition", "arm",
                                         "notes", "tags", "duration_s", "tracks", "objects"});
    if (reader.error())
        return core::Unexpected(*reader.error());
    return pattern;
}

core::Expected<std::string> patternToJson(const Pattern& pattern) {
    ordered_json root{{"format", kFormat},
                      {"version", kVersion},
                      {"id", pattern.id},
                      {"name", pattern.name},
                      {"task", toString(pattern.task)},
                      {"condition", toString(pattern.condition)}};
    if (pattern.arm != Arm::right)
        root["arm"] = toString(pattern.arm);
    root["notes"] = pattern.notes;
    root["tags"] = pattern.tags;
    root["duration_s"] = pattern.duration_s;
    ordered_json tracks = ordered_json::array();
    for (const Track& track : pattern.tracks) {
        ordered_json points = ordered_json::array();
        for (const Breakpoint& point : track) {
            ordered_json entry = ordered_json::array({point.time_s, point.intensity});
            if (point.easing != Easing::linear)
                entry.push_back(toString(point.easing));
            points.push_back(std::move(entry));
        }
        tracks.push_back(std::move(points));
    }
    root["tracks"] = std::move(tracks);
    ordered_json objects = ordered_json::array();
    for (const PatternObject& object : pattern.objects) {
        ordered_json out{{"type", objectTypes()[object.form.index()].name}};
        if (!object.name.empty())
            out["name"] = object.name;
        std::visit(WriteForm{out}, object.form);
        addUnknown(out, object.unknown);
        objects.push_back(std::move(out));
    }
    root["objects"] = std::move(objects);
    addUnknown(root, pattern.unknown);

    std::string text = lines(root);
    core::Expected<Pattern> again = patternFromJson(text, {});
    if (again)
        return text;
    core::Error error = again.error();
    error.kind = core::ErrorKind::refused;
    error.where = {};
    return core::Unexpected(std::move(error));
}

core::Expected<PatternMap> patternMapFromJson(std::string text, const std::string& file) {
    TELETA_TRY(const JsonDocument document, JsonDocument::parse(std::move(text), file));
    JsonReader reader(document);
    checkFormat(reader, kMapFormat);
    PatternMap map;
    const ordered_json& stiffness =
        reader.array(reader.member(reader.root(), "stiffness"), kStiffnessLevels, kStiffnessLevels);
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        map.stiffness[i] = reader.text(stiffness[i]);
    // Files of older versions lack it.
    map.unknownStiffness =
        reader.text(reader.root(), "unknown_stiffness", PatternMap::defaults().unknownStiffness);
    const ordered_json& shape = reader.member(reader.root(), "shape");
    for (std::size_t i = 0; i < kRecognisedShapes.size(); ++i)
        map.shape[i] = reader.text(shape, kRecognisedShapes[i].data(), {});
    if (shape.is_object()) {
        for (const auto& [key, value] : shape.items()) {
            if (std::ranges::find(kRecognisedShapes, key) == kRecognisedShapes.end())
                reader.fail(value, PatternText::tr("this name is unknown"),
                            "circle, rectangle, triangle, arc, line, point, unknown");
        }
    }
    if (reader.error())
        return core::Unexpected(*reader.error());
    return map;
}

std::string patternMapToJson(const PatternMap& map) {
    ordered_json shape = ordered_json::object();
    for (std::size_t i = 0; i < kRecognisedShapes.size(); ++i)
        shape[std::string(kRecognisedShapes[i])] = map.shape[i];
    return lines({{"format", kMapFormat},
                  {"version", kVersion},
                  {"stiffness", map.stiffness},
                  {"unknown_stiffness", map.unknownStiffness},
                  {"shape", std::move(shape)}});
}

} // namespace teleta::pattern
