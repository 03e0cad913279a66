// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene/scene_reader.h"

#include "backend/core/data/toml_table.h"
#include "backend/scene/arm_world_reader.h"
#include "backend/scene/camera_world_reader.h"
#include "backend/scene/servo_world_reader.h"

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

int side(core::TomlTable& table, std::string_view key) {
    return static_cast<int>(table.integer(key, 1, core::ArrayLayout::kMaximumSide));
}

ArraySensor readSensor(core::TomlTable table) {
    ArraySensor sensor;
    (void)table.choice("kind", {"array"});
    sensor.layout.rows = side(table, "rows");
    sensor.layout.columns = side(table, "columns");
    sensor.layout.pitch_m = table.number("pitch_m", core::NumberRange::positive());
    sensor.stiffness_NPerM = table.number("stiffness_N_per_m", core::NumberRange::positive());
    sensor.fullScale_N = table.number("full_scale_N", core::NumberRange::positive());
    sensor.firingThreshold_N = table.number("firing_threshold_N", core::NumberRange::notNegative(), 0.0);
    table.finish();
    return sensor;
}

IndenterShape readShape(core::TomlTable& table) {
    const auto size = [&table](std::string_view key) { return table.number(key, core::NumberRange::positive()); };
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

std::vector<Keyframe> readKeyframes(core::TomlTable& indenter, bool loop) {
    std::vector<Keyframe> keyframes;
    for (core::TomlTable& table : indenter.tables("keyframes", 1)) {
        Keyframe frame;
        frame.time_s = table.number("time_s", core::NumberRange::notNegative());
        frame.x_m = table.number("x_m", core::NumberRange::any(), 0.0);
        frame.y_m = table.number("y_m", core::NumberRange::any(), 0.0);
        frame.depth_m = table.number("depth_m", core::NumberRange::any());
        frame.angle_rad = table.number("angle_rad", core::NumberRange::any(), 0.0);
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

Indenter readIndenter(core::TomlTable table) {
    Indenter indenter;
    indenter.name = table.text("name");
    indenter.shape = readShape(table);
    indenter.loop = table.boolean("loop", false);
    indenter.keyframes = readKeyframes(table, indenter.loop);
    table.finish();
    return indenter;
}

DeadTaxelsSpec readDeadTaxels(core::TomlTable& table, const core::ArrayLayout& layout) {
    DeadTaxelsSpec spec;
    spec.reading_N = table.number("reading_N", core::NumberRange::anyOrNan(), 0.0);
    if (table.has("taxels") == table.has("count"))
        table.fail("count", SceneReader::tr("which taxels are dead is not clear").toStdString(),
                   SceneReader::tr("either \"count\" or \"taxels\"").toStdString());
    if (table.has("count"))
        spec.count =
            static_cast<std::size_t>(table.integer("count", 1, static_cast<long long>(layout.taxels())));
    for (core::TomlTable& taxel : table.tables("taxels", 0)) {
        spec.taxels.push_back({.row = static_cast<int>(taxel.integer("row", 0, layout.rows - 1)),
                               .column = static_cast<int>(taxel.integer("column", 0, layout.columns - 1))});
        taxel.finish();
    }
    return spec;
}

HousingRimSpec readHousingRim(core::TomlTable& table, const core::ArrayLayout& layout) {
    HousingRimSpec spec;
    spec.stiffness_NPerM = table.number("stiffness_N_per_m", core::NumberRange::positive());
    spec.recess_m = table.number("recess_m", core::NumberRange::notNegative());
    spec.length_m = table.number("length_m", core::NumberRange{.low = layout.columns * layout.pitch_m});
    spec.width_m = table.number("width_m", core::NumberRange{.low = layout.rows * layout.pitch_m});
    return spec;
}

LinkDelaySpec readLinkDelay(core::TomlTable& table) {
    const core::NumberRange time{.low = 0.0, .high = 10.0};
    LinkDelaySpec spec;
    spec.delay_s = table.number("delay_s", time);
    spec.jitter_s = table.number("jitter_s", time, spec.jitter_s);
    spec.lossShare = table.number("loss_share", core::NumberRange::between(0.0, 1.0), spec.lossShare);
    spec.outageAt_s = table.number("outage_at_s", core::NumberRange::notNegative(), spec.outageAt_s);
    spec.outage_s = table.number("outage_s", core::NumberRange::notNegative(), spec.outage_s);
    return spec;
}

using EffectParameters = decltype(Effect::parameters);

struct EffectReader {
    std::string_view name;
    EffectParameters (*read)(core::TomlTable& table, const core::ArrayLayout& layout);
};

constexpr std::array kTaxelEffects{
    EffectReader{"noise",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NoiseSpec{.sd_N = table.number("sd_N", core::NumberRange::notNegative())};
                 }},
    EffectReader{"quantization",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return QuantizationSpec{.step_N = table.number("step_N", core::NumberRange::positive())};
                 }},
    EffectReader{"saturation",
                 [](core::TomlTable&, const core::ArrayLayout&) -> EffectParameters { return SaturationSpec{}; }},
    EffectReader{"dead_taxels",
                 [](core::TomlTable& table, const core::ArrayLayout& layout) -> EffectParameters {
                     return readDeadTaxels(table, layout);
                 }},
    EffectReader{"crosstalk",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return CrosstalkSpec{.share = table.number("share", core::NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"hysteresis",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return HysteresisSpec{.share = table.number("share", core::NumberRange::between(0.0, 10.0))};
                 }},
    EffectReader{"drift",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return DriftSpec{.sd_N = table.number("sd_N", core::NumberRange::notNegative()),
                                      .timeConstant_s =
                                          table.number("time_constant_s", core::NumberRange::positive())};
                 }},
    EffectReader{"latency",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return LatencySpec{.delay_s = table.number("delay_s", core::NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"nonlinear_response",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NonlinearResponseSpec{.bow =
                                                      table.number("bow", core::NumberRange::between(-0.25, 0.25))};
                 }},
    EffectReader{"gain_spread",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GainSpreadSpec{.sd = table.number("sd", core::NumberRange::between(0.0, 1.0))};
                 }},
};

constexpr std::array kArmEffects{
    EffectReader{"torque_noise",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return TorqueNoiseSpec{.sd_Nm = table.number("sd_Nm", core::NumberRange::notNegative())};
                 }},
    EffectReader{"encoder_quantization",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return EncoderQuantizationSpec{.step_rad =
                                                        table.number("step_rad", core::NumberRange::positive())};
                 }},
    EffectReader{"gravity_error",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GravityErrorSpec{.share = table.number("share", core::NumberRange::between(-1.0, 1.0))};
                 }},
    EffectReader{"gear_ripple",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return GearRippleSpec{
                         .amplitude_Nm = table.number("amplitude_Nm", core::NumberRange::notNegative()),
                         .wavesPerTurn = table.number("waves_per_turn", core::NumberRange::positive())};
                 }},
    EffectReader{"nonlinear_object",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return NonlinearObjectSpec{
                         .doublingDepth_m = table.number("doubling_depth_m", core::NumberRange::positive())};
                 }},
};

constexpr EffectReader kLinkDelay{
    "link_delay",
    [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters { return readLinkDelay(table); }};

constexpr std::array kServoEffects{
    EffectReader{"border_stiffening",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return BorderStiffeningSpec{.share =
                                                     table.number("share", core::NumberRange::between(0.0, 10.0))};
                 }},
    EffectReader{"housing_rim",
                 [](core::TomlTable& table, const core::ArrayLayout& layout) -> EffectParameters {
                     return readHousingRim(table, layout);
                 }},
    EffectReader{"damping",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return ContactDampingSpec{.time_s =
                                                   table.number("time_s", core::NumberRange::between(0.0, 1.0))};
                 }},
    EffectReader{"friction",
                 [](core::TomlTable& table, const core::ArrayLayout&) -> EffectParameters {
                     return FrictionSpec{.coefficient =
                                             table.number("coefficient", core::NumberRange::between(0.0, 10.0))};
                 }},
};

Effect readEffect(core::TomlTable table, const Scene& scene, std::set<std::size_t>& listed) {
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

core::Expected<Scene> readDocument(const core::TomlDocument& document) {
    core::TomlTable root = document.root();
    Scene scene;
    scene.name = root.text("name");
    scene.description = root.text("description");
    scene.duration_s = root.number("duration_s", core::NumberRange::positive());
    scene.rate_Hz = root.number("rate_Hz", {.low = 0.0, .high = kHighestRate_Hz, .lowOpen = true});
    std::vector<core::TomlTable> effects;
    // The root is finished before the tables are read: a misspelt name among them is the error to show.
    if (root.has("arm")) {
        const core::TomlTable arm = root.table("arm");
        const core::TomlTable skin = root.table("skin");
        const core::TomlTable program = root.table("program");
        const std::vector<core::TomlTable> objects = root.tables("object", 0);
        const std::optional<core::TomlTable> unknown =
            root.has("unknown") ? std::optional(root.table("unknown")) : std::nullopt;
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readArmWorld(arm, skin, program, objects, unknown);
    } else if (root.has("robot")) {
        const core::TomlTable robot = root.table("robot");
        const core::TomlTable sensor = root.table("sensor");
        const core::TomlTable object = root.table("object");
        const core::TomlTable task = root.table("task");
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readServoWorld(robot, sensor, object, task);
    } else if (root.has("camera")) {
        CameraTables tables(root);
        effects = root.tables("effects", 0);
        root.finish();
        scene.world = readCameraWorld(tables);
    } else {
        const core::TomlTable sensor = root.table("sensor");
        const std::vector<core::TomlTable> indenters = root.tables("indenter", 1);
        effects = root.tables("effects", 0);
        root.finish();
        scene.array().sensor = readSensor(sensor);
        for (const core::TomlTable& table : indenters)
            scene.array().indenters.push_back(readIndenter(table));
    }
    std::set<std::size_t> listed;
    for (const core::TomlTable& table : effects)
        scene.effects.push_back(readEffect(table, scene, listed));
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    return scene;
}

} // namespace

core::Expected<Scene> readScene(const std::string& path) {
    return core::TomlDocument::open(path).and_then(readDocument);
}

core::Expected<Scene> parseScene(std::string_view text, const std::string& file) {
    return core::TomlDocument::parse(text, file).and_then(readDocument);
}

} // namespace teleta::scene
