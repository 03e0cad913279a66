// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include "backend/scene/arm_world_reader.h"
#include "backend/scene/camera_world_reader.h"
#include "backend/scene/servo_world_reader.h"
#include "backend/scene/toml_table.h"

#include <QCoreApplication>
#include <QString>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace teleta::scene {

namespace {

struct SceneReader {
    Q_DECLARE_TR_FUNCTIONS(SceneReader)
};

constexpr double kHighestRate_Hz = 100'000.0;

int side(TomlTable& table, std::string_view key) {
    return static_cast<int>(table.integer(key, 1, core::ArrayLayout::kMaximumSide));
}

ArraySensor readSensor(TomlTable table) {
    ArraySensor sensor;
    (void)table.choice("kind", {"array"});
    sensor.layout.rows = side(table, "rows");
    sensor.layout.columns = side(table, "columns");
    sensor.layout.pitch_m = table.number("pitch_m", NumberRange::positive());
    sensor.stiffness_NPerM = table.number("stiffness_N_per_m", NumberRange::positive());
    sensor.fullScale_N = table.number("full_scale_N", NumberRange::positive());
    sensor.firingThreshold_N = table.number("firing_threshold_N", NumberRange::notNegative(), 0.0);
    table.finish();
    return sensor;
}

IndenterShape readShape(TomlTable& table) {
    const auto size = [&table](std::string_view key) { return table.number(key, NumberRange::positive()); };
    switch (table.choice("shape", {"sphere", "cylinder", "box_edge", "flat_punch"})) {
    case 1:
        return Cylinder{.radius_m = size("radius_m"), .length_m = size("length_m")};
    case 2:
        return BoxEdge{.length_m = size("length_m")};
    case 3:
        return FlatPunch{.length_m = size("length_m"), .width_m = size("width_m")};
    default:
        return Sphere{.radius_m = size("radius_m")};
    }
}

std::vector<Keyframe> readKeyframes(TomlTable& indenter, bool loop) {
    std::vector<Keyframe> keyframes;
    for (TomlTable& table : indenter.tables("keyframes", 1)) {
        Keyframe frame;
        frame.time_s = table.number("time_s", NumberRange::notNegative());
        frame.x_m = table.number("x_m", NumberRange::any(), 0.0);
        frame.y_m = table.number("y_m", NumberRange::any(), 0.0);
        frame.depth_m = table.number("depth_m", NumberRange::any());
        frame.angle_rad = table.number("angle_rad", NumberRange::any(), 0.0);
        table.finish();
        if (!keyframes.empty() && frame.time_s <= keyframes.back().time_s)
            table.fail("time_s", SceneReader::tr("the keyframes are not in the order of time").toStdString(),
                       SceneReader::tr("a time after %1 s").arg(keyframes.back().time_s).toStdString());
        keyframes.push_back(frame);
    }
    if (loop && !keyframes.empty()) {
        const Keyframe& first = keyframes.front();
        const Keyframe& last = keyframes.back();
        // All shapes look the same after half a turn.
        const double turn_rad = std::remainder(last.angle_rad - first.angle_rad, std::numbers::pi);
        if (first.x_m != last.x_m || first.y_m != last.y_m || first.depth_m != last.depth_m ||
            std::abs(turn_rad) > 1e-3)
            indenter.fail("loop", SceneReader::tr("the motion does not end where it starts").toStdString(),
                          SceneReader::tr("a last keyframe like the first one").toStdString());
    }
    return keyframes;
}

Indenter readIndenter(TomlTable table) {
    Indenter indenter;
    indenter.name = table.text("name");
    indenter.shape = readShape(table);
    indenter.loop = table.boolean("loop", false);
    indenter.keyframes = readKeyframes(table, indenter.loop);
    table.finish();
    return indenter;
}

DeadTaxelsSpec readDeadTaxels(TomlTable& table, const core::ArrayLayout& layout) {
    DeadTaxelsSpec spec;
    spec.reading_N = table.number("reading_N", NumberRange::anyOrNan(), 0.0);
    if (table.has("taxels") == table.has("count"))
        table.fail("count", SceneReader::tr("which taxels are dead is not clear").toStdString(),
                   SceneReader::tr("either \"count\" or \"taxels\"").toStdString());
    if (table.has("count"))
        spec.count =
            static_cast<std::size_t>(table.integer("count", 1, static_cast<long long>(layout.taxels())));
    for (TomlTable& taxel : table.tables("taxels", 0)) {
        spec.taxels.push_back({.row = static_cast<int>(taxel.integer("row", 0, layout.rows - 1)),
                               .column = static_cast<int>(taxel.integer("column", 0, layout.columns - 1))});
        taxel.finish();
    }
    return spec;
}

HousingRimSpec readHousingRim(TomlTable& table, const core::ArrayLayout& layout) {
    HousingRimSpec spec;
    spec.stiffness_NPerM = table.number("stiffness_N_per_m", NumberRange::positive());
    spec.recess_m = table.number("recess_m", NumberRange::notNegative());
    spec.length_m = table.number("length_m", NumberRange{.low = layout.columns * layout.pitch_m});
    spec.width_m = table.number("width_m", NumberRange{.low = layout.rows * layout.pitch_m});
    return spec;
}

LinkDelaySpec readLinkDelay(TomlTable& table) {
    const NumberRange time{.low = 0.0, .high = 10.0};
    LinkDelaySpec spec;
    spec.delay_s = table.number("delay_s", time);
    spec.jitter_s = table.number("jitter_s", time, spec.jitter_s);
    spec.lossShare = table.number("loss_share", NumberRange::between(0.0, 1.0), spec.lossShare);
    spec.outageAt_s = table.number("outage_at_s", NumberRange::notNegative(), spec.outageAt_s);
    spec.outage_s = table.number("outage_s", NumberRange::notNegative(), spec.outage_s);
    return spec;
}

using EffectParameters = decltype(Effect::parameters);

struct EffectReader {
    std::string_view name;
    EffectParameters (*read)(TomlTable& table, const core::ArrayLayout& layout);
};

constexpr std::array kTaxelEffects{
    EffectReader{"noise",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NoiseSpec{.sd_N = table.number("sd_N", NumberRange::notNegative())};
                 }},
    EffectReader{"quantization",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return QuantizationSpec{.step_N = table.number("step_N", NumberRange::positive())};
                 }},
    EffectReader{"saturation",
                 [](TomlTable&, const core::ArrayLayout&) -> EffectParameters { return SaturationSpec{}; }},
    EffectReader{"dead_taxels",
                 [](TomlTable& table, const core::ArrayLayout& layout) -> EffectParameters {
                     return readDeadTaxels(table, layout);
                 }},
    EffectReader{"crosstalk",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return CrosstalkSpec{.share = table.number("share", NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"hysteresis",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return HysteresisSpec{.share = table.number("share", NumberRange::between(0.0, 10.0))};
                 }},
    EffectReader{"drift",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return DriftSpec{.sd_N = table.number("sd_N", NumberRange::notNegative()),
                                      .timeConstant_s =
                                          table.number("time_constant_s", NumberRange::positive())};
                 }},
    EffectReader{"latency",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return LatencySpec{.delay_s = table.number("delay_s", NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"nonlinear_response",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NonlinearResponseSpec{.bow =
                                                      table.number("bow", NumberRange::between(-0.25, 0.25))};
                 }},
    EffectReader{"gain_spread",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GainSpreadSpec{.sd = table.number("sd", NumberRange::between(0.0, 1.0))};
                 }},
};

constexpr std::array kArmEffects{
    EffectReader{"torque_noise",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return TorqueNoiseSpec{.sd_Nm = table.number("sd_Nm", NumberRange::notNegative())};
                 }},
    EffectReader{"encoder_quantization",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return EncoderQuantizationSpec{.step_rad =
                                                        table.number("step_rad", NumberRange::positive())};
                 }},
    EffectReader{"gravity_error",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GravityErrorSpec{.share = table.number("share", NumberRange::between(-1.0, 1.0))};
                 }},
    EffectReader{"gear_ripple",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GearRippleSpec{
                         .amplitude_Nm = table.number("amplitude_Nm", NumberRange::notNegative()),
                         .wavesPerTurn = table.number("waves_per_turn", NumberRange::positive())};
                 }},
    EffectReader{"nonlinear_object",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NonlinearObjectSpec{
                         .doublingDepth_m = table.number("doubling_depth_m", NumberRange::positive())};
                 }},
};

constexpr EffectReader kLinkDelay{
    "link_delay",
    [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters { return readLinkDelay(table); }};

constexpr std::array kServoEffects{
    EffectReader{"border_stiffening",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return BorderStiffeningSpec{.share =
                                                     table.number("share", NumberRange::between(0.0, 10.0))};
                 }},
    EffectReader{"housing_rim",
                 [](TomlTable& table, const core::ArrayLayout& layout) -> EffectParameters {
                     return readHousingRim(table, layout);
                 }},
    EffectReader{"damping",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return ContactDampingSpec{.time_s =
                                                   table.number("time_s", NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"friction",
                 [](TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return FrictionSpec{.coefficient =
                                             table.number("coefficient", NumberRange::between(0.0, 10.0))};
                 }},
};

Effect readEffect(TomlTable table, const Scene& scene, std::set<std::size_t>& listed) {
    if (scene.isCamera())
        return readCameraEffect(table, listed);
    std::vector<EffectReader> readers(kTaxelEffects.begin(), kTaxelEffects.end());
    if (scene.isArm())
        readers.insert(readers.end(), kArmEffects.begin(), kArmEffects.end());
    if (scene.isTeleoperated())
        readers.push_back(kLinkDelay);
    if (scene.isServo())
        readers.insert(readers.end(), kServoEffects.begin(), kServoEffects.end());
    std::vector<std::string_view> names;
    for (const EffectReader& reader : readers)
        names.push_back(reader.name);
    const std::size_t chosen = table.choice("name", names);
    if (!listed.insert(chosen).second)
        table.fail("name", SceneReader::tr("the effect is listed twice").toStdString(),
                   SceneReader::tr("each effect at most once").toStdString());
    Effect effect;
    effect.why = table.text("why");
    effect.parameters = readers[chosen].read(table, scene.taxels());
    table.finish();
    return effect;
}

core::Expected<Scene> readDocument(const TomlDocument& document) {
    TomlTable root = document.root();
    Scene scene;
    scene.name = root.text("name");
    scene.description = root.text("description");
    scene.duration_s = root.number("duration_s", NumberRange::positive());
    scene.rate_Hz = root.number("rate_Hz", {.low = 0.0, .high = kHighestRate_Hz, .lowOpen = true});
    std::vector<TomlTable> effects;
    // The root is finished before the tables are read: a misspelt name among them is the error to show.
    if (root.has("arm")) {
        const TomlTable arm = root.table("arm");
        const TomlTable skin = root.table("skin");
        const TomlTable program = root.table("program");
        const std::vector<TomlTable> objects = root.tables("object", 0);
        const std::optional<TomlTable> unknown =
            root.has("unknown") ? std::optional(root.table("unknown")) : std::nullopt;
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readArmWorld(arm, skin, program, objects, unknown);
    } else if (root.has("robot")) {
        const TomlTable robot = root.table("robot");
        const TomlTable sensor = root.table("sensor");
        const TomlTable object = root.table("object");
        const TomlTable task = root.table("task");
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readServoWorld(robot, sensor, object, task);
    } else if (root.has("camera")) {
        CameraTables tables(root);
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readCameraWorld(tables);
    } else {
        const TomlTable sensor = root.table("sensor");
        const std::vector<TomlTable> indenters = root.tables("indenter", 1);
        effects = root.tables("effects", 0);
        root.finish();
        scene.array().sensor = readSensor(sensor);
        for (const TomlTable& table : indenters)
            scene.array().indenters.push_back(readIndenter(table));
    }
    std::set<std::size_t> listed;
    for (const TomlTable& table : effects)
        scene.effects.push_back(readEffect(table, scene, listed));
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return scene;
}

} // namespace

core::Expected<Scene> readScene(const std::string& path) {
    return TomlDocument::open(path).and_then(readDocument);
}

core::Expected<Scene> parseScene(std::string_view text, const std::string& file) {
    return TomlDocument::parse(text, file).and_then(readDocument);
}

} // namespace teleta::scene
