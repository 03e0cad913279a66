// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_streams.h"

#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/core/data/json_document.h"
#include "backend/core/failure.h"
#include "backend/core/number_text.h"
#include "backend/pipeline/recorded/recorded_layout.h"
#include "backend/pipeline/recorded/recorded_loads.h"
#include "backend/recording/event_words.h"
#include "backend/recording/stream_columns.h"
#include "backend/stiffness/material.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace teleta::pipeline {

namespace {

using nlohmann::ordered_json;

struct RecordedStreamText {
    Q_DECLARE_TR_FUNCTIONS(RecordedStreamText)
};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kHuge = 1e12;
constexpr double kMostTaxels =
    static_cast<double>(core::ArrayLayout::kMaximumSide) * core::ArrayLayout::kMaximumSide;
constexpr std::size_t kMostChips = 4096;
constexpr double kColdest_degC = -273.15;

/// A number a taxel; those that are dead have none.
ordered_json taxelsJson(const std::vector<float>& values) {
    ordered_json list = ordered_json::array();
    for (const float value : values)
        list.push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
    return list;
}

ordered_json settingsJson(const ChannelSettings& settings) {
    ordered_json json{{"gain", settings.conditioning.gain},
                      {"inverted", settings.conditioning.inverted},
                      {"tare", taxelsJson(settings.conditioning.tare)},
                      {"taxel_gains", taxelsJson(settings.conditioning.taxelGain)},
                      {"dead", settings.conditioning.dead},
                      {"threshold", settings.features.threshold_N},
                      {"automatic_threshold", settings.features.automaticThreshold},
                      {"weighted", settings.features.orientation == contact::OrientationMode::weighted},
                      {"active_only", settings.features.range == contact::MomentRange::active},
                      {"edge_ratio", settings.features.edgeRatio},
                      {"point_ratio", settings.features.pointRatio},
                      {"contact_threshold", settings.segmentation.threshold_N},
                      {"noise_height", settings.segmentation.noiseHeight},
                      {"noise_height_absolute", settings.segmentation.noiseHeight_N},
                      {"minimum_taxels", settings.segmentation.minimumTaxels},
                      {"load_unit", settings.loadUnit}};
    if (!settings.tareTemperatures_degC.empty())
        json["tare_temperatures_degc"] = taxelsJson(settings.tareTemperatures_degC);
    return json;
}

/// Empty when there are none.
std::vector<float> readNumbersOrNone(core::JsonReader& reader, const ordered_json& json, const char* key,
                                     std::size_t atLeast, std::size_t atMost, double lowest) {
    std::vector<float> values;
    const ordered_json* list = reader.find(json, key);
    if (list == nullptr || list->empty())
        return values;
    for (const ordered_json& value : reader.array(*list, atLeast, atMost))
        values.push_back(value.is_null() ? std::numeric_limits<float>::quiet_NaN()
                                         : static_cast<float>(reader.number(value, lowest, kHuge)));
    return values;
}

std::vector<float> readTaxels(core::JsonReader& reader, const ordered_json& json, const char* key,
                              std::size_t taxels, double lowest) {
    return readNumbersOrNone(reader, json, key, taxels, taxels, lowest);
}

ChannelSettings readSettings(core::JsonReader& reader, const ordered_json& json,
                             const core::TaxelLayout& layout, std::size_t chips) {
    const std::size_t taxels = layout.taxels();
    ChannelSettings settings;
    contact::ConditioningSettings& conditioning = settings.conditioning;
    contact::FeatureSettings& features = settings.features;
    contact::SegmentationSettings& segmentation = settings.segmentation;
    conditioning.gain = reader.number(json, "gain", -kHuge, kHuge, conditioning.gain);
    conditioning.inverted = reader.boolean(json, "inverted", false);
    conditioning.tare = readTaxels(reader, json, "tare", layout.values(), -kHuge);
    conditioning.taxelGain = readTaxels(reader, json, "taxel_gains", taxels, 0.0);
    if (const ordered_json* dead = reader.find(json, "dead"); dead != nullptr && !dead->empty()) {
        for (const ordered_json& value : reader.array(*dead, taxels, taxels))
            conditioning.dead.push_back(static_cast<std::uint8_t>(reader.integer(value, 0, 1)));
    }
    features.threshold_N = reader.number(json, "threshold", 0.0, kHuge, features.threshold_N);
    features.automaticThreshold = reader.boolean(json, "automatic_threshold", false);
    features.orientation = reader.boolean(json, "weighted", false) ? contact::OrientationMode::weighted
                                                                   : contact::OrientationMode::binarised;
    features.range = reader.boolean(json, "active_only", false) ? contact::MomentRange::active
                                                                : contact::MomentRange::image;
    features.edgeRatio = reader.number(json, "edge_ratio", 1.0, kHuge, features.edgeRatio);
    features.pointRatio = reader.number(json, "point_ratio", 1.0, kHuge, features.pointRatio);
    segmentation.threshold_N = reader.number(json, "contact_threshold", 0.0, kHuge, segmentation.threshold_N);
    segmentation.noiseHeight = reader.number(json, "noise_height", 0.0, 1.0, segmentation.noiseHeight);
    segmentation.noiseHeight_N =
        reader.number(json, "noise_height_absolute", 0.0, kHuge, segmentation.noiseHeight_N);
    segmentation.minimumTaxels =
        static_cast<int>(reader.number(json, "minimum_taxels", 1.0, kMostTaxels, segmentation.minimumTaxels));
    settings.loadUnit = reader.text(json, "load_unit", settings.loadUnit);
    settings.tareTemperatures_degC =
        readNumbersOrNone(reader, json, "tare_temperatures_degc", chips > 0 ? chips : 1,
                          chips > 0 ? chips : kMostChips, kColdest_degC);
    return settings;
}

/// null, which is what JSON has for infinity, leaves a number as it is.
void readNumbers(core::JsonReader& reader, const ordered_json& json, const char* key,
                 std::span<double> values) {
    const ordered_json& list = reader.array(reader.member(json, key), values.size(), values.size());
    for (std::size_t i = 0; i < values.size() && i < list.size(); ++i)
        if (!list[i].is_null())
            values[i] = reader.number(list[i], -kHuge, kHuge);
}

} // namespace

core::Unexpected notDescribed(const recording::StreamInfo& stream, const std::string& file,
                              const QString& why) {
    return core::failed(core::ErrorKind::badInput,
                        RecordedStreamText::tr("the stream \"%1\" is not described: %2")
                            .arg(QString::fromStdString(stream.name), why),
                        {}, {file});
}

core::Unexpected notDescribed(const recording::StreamInfo& stream, const std::string& file,
                              const core::Error& why) {
    return notDescribed(stream, file, QString::fromStdString(core::describe(why)));
}

recording::StreamInfo arrayStream(const std::string& name, const core::SourceDescription& description,
                                  const ChannelSettings& settings, const FrameLoads* loads,
                                  bool countsLosses) {
    ordered_json details = layoutJson(description.layout);
    details.update({{"simulated", description.simulated}, {"settings", settingsJson(settings)}});
    if (loads != nullptr)
        details["loads"] = loadsJson(loads->calibration());
    if (!countsLosses)
        details["counts_losses"] = false;
    return {.name = name,
            .kind = recording::StreamKind::array,
            .type = recording::ValueType::float32,
            .source = description.name,
            .shape = shapeOf(description.layout),
            .unit = description.unit,
            .columns = componentColumns(description.layout, description.unit),
            .nominalRate_Hz = description.nominalRate_Hz,
            .details = details.dump()};
}

recording::RecordingEvent settingsEvent(const std::string& stream, const ChannelSettings& settings) {
    const ordered_json text{{"stream", stream}, {"settings", settingsJson(settings)}};
    return {.kind = recording::kSettings, .text = text.dump()};
}

bool settingsChanged(const std::vector<recording::RecordingEvent>& events, const std::string& stream) {
    return std::ranges::any_of(events, [&](const recording::RecordingEvent& event) {
        if (event.kind != recording::kSettings)
            return false;
        const ordered_json text = ordered_json::parse(event.text, nullptr, /*allow_exceptions=*/false);
        const auto named = text.is_object() ? text.find("stream") : text.end();
        return named != text.end() && named->is_string() && named->get<std::string>() == stream;
    });
}

recording::StreamInfo featureStream(const std::string& name, const core::SourceDescription& description,
                                    const std::string& loadUnit) {
    const std::vector<recording::Column> columns =
        recording::featureColumns(loadUnit, description.layout.isVector());
    return {.name = name,
            .kind = recording::StreamKind::features,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {columns.size()},
            .columns = columns,
            .nominalRate_Hz = description.nominalRate_Hz};
}

namespace {

ordered_json padJson(const core::PadPlacement& pad) {
    const core::TouchTorques& torques = pad.torques;
    ordered_json object{{"link", pad.link},
                        {"position_m", pad.position_m},
                        {"roll_pitch_yaw_rad", pad.rollPitchYaw_rad},
                        {"joint", pad.joint},
                        {"centre_se_m", pad.centreSe_m},
                        {"window_nm", {torques.windowLow_Nm, torques.windowHigh_Nm}},
                        {"threshold_nm", torques.threshold_Nm},
                        {"noise_floor_nm", torques.noiseFloor_Nm}};
    if (!pad.jointStiffness_NmPerRad.empty())
        object["joint_stiffness_nm_per_rad"] = pad.jointStiffness_NmPerRad;
    return object;
}

/// The inverse. joints: of the arm.
core::PadPlacement padOf(core::JsonReader& reader, const ordered_json& object, std::size_t joints) {
    constexpr double kTiny = 1e-12;
    core::PadPlacement pad;
    pad.link = reader.text(object, "link", {});
    readNumbers(reader, object, "position_m", pad.position_m);
    readNumbers(reader, object, "roll_pitch_yaw_rad", pad.rollPitchYaw_rad);
    pad.joint = reader.text(object, "joint", {});
    if (object.contains("joint_stiffness_nm_per_rad")) {
        pad.jointStiffness_NmPerRad = core::JointVector::zeros(joints);
        readNumbers(reader, object, "joint_stiffness_nm_per_rad", pad.jointStiffness_NmPerRad);
    }
    pad.centreSe_m = reader.number(object, "centre_se_m", 0.0, kHuge, 0.0);
    core::TouchTorques& torques = pad.torques;
    std::array<double, 2> window_Nm{torques.windowLow_Nm, torques.windowHigh_Nm};
    readNumbers(reader, object, "window_nm", window_Nm);
    torques.windowLow_Nm = window_Nm[0];
    torques.windowHigh_Nm = window_Nm[1];
    torques.threshold_Nm = reader.number(object, "threshold_nm", kTiny, kHuge, torques.threshold_Nm);
    torques.noiseFloor_Nm = reader.number(object, "noise_floor_nm", kTiny, kHuge, torques.noiseFloor_Nm);
    return pad;
}

} // namespace

recording::StreamInfo armStream(const std::string& name, const core::ArmDescription& description,
                                const std::string& skinStream, const arm_model::SerialChain* chain) {
    recording::StreamInfo info = recording::jointStream(description.nominalRate_Hz, description.joints());
    info.name = name;
    info.source = description.name;
    ordered_json details{{"simulated", description.simulated},
                         {"skin_stream", skinStream},
                         {"upper_arm_m", description.upperArmLength_m},
                         {"forearm_m", description.forearmLength_m},
                         {"half_thickness_m", description.halfThickness_m},
                         {"elbow_stiffness_nm_per_rad", description.elbowStiffness_NmPerRad},
                         {"elbow_stiffness_se_nm_per_rad", description.elbowStiffnessSe_NmPerRad},
                         {"shoulder_stiffness_nm_per_rad", description.shoulderStiffness_NmPerRad},
                         {"skin_centre_distance_m", description.skin.centreDistance_m},
                         {"skin_centre_side_rad", description.skin.centreSide_rad},
                         {"skin_radius_m", description.skin.radius_m},
                         {"skin_centre_se_m", description.skin.centreSe_m},
                         {"lowest_rad", description.lowest_rad},
                         {"highest_rad", description.highest_rad},
                         {"fastest_rad_per_s", description.fastest_radPerS}};
    if (!description.guarded)
        details["guarded"] = false;
    if (description.pad)
        details["pad"] = padJson(*description.pad);
    if (chain != nullptr)
        details.update({{"urdf", chain->model().urdf},
                        {"base_link", chain->baseLink()},
                        {"tip_link", chain->tipLink()}});
    // A description may have bytes that are no UTF-8.
    info.details = details.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    return info;
}

recording::StreamInfo wrenchStream(const std::string& name, const core::ArmDescription& description,
                                   const arm_model::SerialChain* chain) {
    const ordered_json details{{"simulated", description.simulated},
                               {"frame", chain != nullptr ? chain->tipLink() : std::string()}};
    return {.name = name,
            .kind = recording::StreamKind::wrench,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {kWrenchValues},
            .columns = recording::wrenchColumns(),
            .details = details.dump(-1, ' ', false, ordered_json::error_handler_t::replace)};
}

std::array<double, kWrenchValues> wrenchValues(const core::WrenchSample& sample) {
    const auto& [x_N, y_N, z_N] = sample.force_N;
    const auto& [x_Nm, y_Nm, z_Nm] = sample.torque_Nm;
    return {x_N, y_N, z_N, x_Nm, y_Nm, z_Nm};
}

recording::StreamInfo numberStream(const std::string& name, const core::SourceDescription& description,
                                   std::vector<recording::Column> columns) {
    return {.name = name,
            .kind = recording::StreamKind::numbers,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {columns.size()},
            .columns = std::move(columns),
            .nominalRate_Hz = description.nominalRate_Hz,
            .details = ordered_json{{"simulated", description.simulated}}.dump()};
}

recording::StreamInfo touchStream(const std::string& name, const core::ArmDescription& description) {
    return {.name = name,
            .kind = recording::StreamKind::touches,
            .type = recording::ValueType::float64,
            .source = description.name,
            .shape = {kTouchValues},
            .columns = recording::touchColumns()};
}

recording::StreamInfo tactorStream(const std::string& name, const core::BraceletDescription& description,
                                   double rate_Hz) {
    recording::StreamInfo info{.name = name,
                               .kind = recording::StreamKind::tactors,
                               .type = recording::ValueType::float32,
                               .source = description.name,
                               .shape = {core::kTactors},
                               .nominalRate_Hz = rate_Hz};
    for (std::size_t i = 1; i <= core::kTactors; ++i)
        info.columns.push_back({std::string("t").append(core::NumberText(i).view()), ""});
    info.details = ordered_json{{"simulated", description.simulated}}.dump();
    return info;
}

void appendFeatures(const contact::TactileFeatures& features, bool vectors, std::vector<double>& values) {
    const std::array<double, kFeatureValues> all = featureValues(features);
    values.insert(values.end(), all.begin(), all.end());
    if (!vectors)
        return;
    if (const auto& shear = features.shear)
        values.insert(values.end(), {shear->x_N, shear->y_N, shear->momentZ_Nm, shear->friction});
    else
        values.insert(values.end(), kShearValues, kNothing);
}

std::array<double, kFeatureValues> featureValues(const contact::TactileFeatures& features) {
    const auto orNothing = [](const std::optional<double>& value) { return value.value_or(kNothing); };
    return {static_cast<double>(features.type), features.force_N,
            orNothing(features.copX_m),         orNothing(features.copY_m),
            orNothing(features.cocX_m),         orNothing(features.cocY_m),
            orNothing(features.dzmpX_m),        orNothing(features.dzmpY_m),
            orNothing(features.alphaZ_rad),     orNothing(features.lambda1_m2),
            orNothing(features.lambda2_m2),     static_cast<double>(features.active)};
}

std::array<double, kTouchValues> touchValues(const TouchRecord& touch) {
    std::array<double, kTouchValues> values{};
    values.fill(kNothing);
    values[0] = static_cast<double>(touch.number);
    values[1] = touch.start_s;
    if (touch.located) {
        values[2] = touch.contactDistance_m;
        values[3] = touch.side_rad;
        for (Eigen::Index i = 0; i < 3; ++i)
            values[4 + static_cast<std::size_t>(i)] = touch.p_Base_Contact_m[i];
    }
    if (touch.stiffness) {
        const stiffness::TouchStiffness& found = *touch.stiffness;
        values[7] = found.deltaTheta_rad;
        values[8] = found.deltaTorque_Nm;
        values[9] = found.total.value_NPerM.value_or(kNothing);
        values[10] = found.object.value_NPerM.value_or(kNothing);
        values[11] = found.object.lower95_NPerM.value_or(kNothing);
        values[12] = found.object.upper95_NPerM.value_or(kNothing);
        values[13] = found.materialKnown() ? stiffness::level(found.material) : kNothing;
    }
    return values;
}

core::Expected<RecordedArray> recordedArray(const recording::StreamInfo& stream, const std::string& file,
                                            std::size_t chips) {
    if (stream.kind != recording::StreamKind::array || stream.type != recording::ValueType::float32)
        return notDescribed(stream, file, RecordedStreamText::tr("it is not an array"));
    const auto document = core::JsonDocument::parse(stream.details, file);
    if (!document)
        return notDescribed(stream, file, document.error());
    core::JsonReader reader(*document);
    RecordedArray array;
    core::SourceDescription& description = array.description;
    description.name = stream.source;
    const auto layout = readLayout(reader, stream.shape);
    if (reader.error())
        return notDescribed(stream, file, *reader.error());
    if (!layout)
        return notDescribed(stream, file, RecordedStreamText::tr("it is not an array"));
    description.layout = *layout;
    description.unit = stream.unit;
    description.nominalRate_Hz = stream.nominalRate_Hz;
    description.simulated = reader.boolean(reader.root(), "simulated", false);
    description.recorded = true;
    array.settings =
        readSettings(reader, reader.member(reader.root(), "settings"), description.layout, chips);
    array.countsLosses = reader.boolean(reader.root(), "counts_losses", true);
    array.loads = readLoads(reader, reader.root(), description.layout, array.settings.loadUnit);
    if (reader.error())
        return notDescribed(stream, file, *reader.error());
    return array;
}

namespace {

core::Expected<std::shared_ptr<const arm_model::SerialChain>>
chainOf(const std::string& urdf, const std::string& base, const std::string& tip, const std::string& file) {
    TELETA_TRY(arm_model::ArmModel model, arm_model::parseUrdf(urdf, file));
    TELETA_TRY(auto chain, arm_model::SerialChain::create(
                               std::make_shared<const arm_model::ArmModel>(std::move(model)), base, tip));
    return std::make_shared<const arm_model::SerialChain>(std::move(chain));
}

} // namespace

core::Expected<RecordedArm> recordedArm(const recording::StreamInfo& stream, const std::string& file) {
    const auto joints = recording::jointsOf(stream);
    if (!joints)
        return notDescribed(stream, file, RecordedStreamText::tr("it is not an arm"));
    const auto document = core::JsonDocument::parse(stream.details, file);
    if (!document)
        return notDescribed(stream, file, document.error());
    core::JsonReader reader(*document);
    const ordered_json& root = reader.root();
    const auto number = [&](const char* key, double lower) {
        return reader.number(reader.member(root, key), lower, kHuge);
    };
    RecordedArm arm;
    core::ArmDescription& description = arm.description;
    description.name = stream.source;
    description.nominalRate_Hz = stream.nominalRate_Hz;
    description.simulated = reader.boolean(root, "simulated", false);
    description.recorded = true;
    description.guarded = reader.boolean(root, "guarded", true);
    description.upperArmLength_m = number("upper_arm_m", 0.0);
    description.forearmLength_m = number("forearm_m", 0.0);
    description.halfThickness_m = number("half_thickness_m", 0.0);
    description.elbowStiffness_NmPerRad = number("elbow_stiffness_nm_per_rad", 0.0);
    // Files of older versions lack it, and that of the skin's centre.
    description.elbowStiffnessSe_NmPerRad =
        reader.number(root, "elbow_stiffness_se_nm_per_rad", 0.0, kHuge, 0.0);
    readNumbers(reader, root, "shoulder_stiffness_nm_per_rad", description.shoulderStiffness_NmPerRad);
    description.skin.centreDistance_m = number("skin_centre_distance_m", -kHuge);
    description.skin.centreSide_rad = number("skin_centre_side_rad", -kHuge);
    arm.skinStream = reader.text(root, "skin_stream", {});
    if (root.contains("pad"))
        description.pad = padOf(reader, reader.member(root, "pad"), *joints);
    // An arm without a skin around its forearm has none of the lengths.
    const bool isBent = !arm.skinStream.empty() && !description.pad;
    description.skin.radius_m = number("skin_radius_m", isBent ? 1e-9 : 0.0);
    description.skin.centreSe_m = reader.number(root, "skin_centre_se_m", 0.0, kHuge, 0.0);
    description.lowest_rad = description.highest_rad = description.fastest_radPerS =
        core::JointVector::zeros(*joints);
    std::ranges::fill(description.lowest_rad, -std::numeric_limits<double>::infinity());
    std::ranges::fill(description.highest_rad, std::numeric_limits<double>::infinity());
    readNumbers(reader, root, "lowest_rad", description.lowest_rad);
    readNumbers(reader, root, "highest_rad", description.highest_rad);
    readNumbers(reader, root, "fastest_rad_per_s", description.fastest_radPerS);
    const std::string urdf = reader.text(root, "urdf", {});
    const std::string base = reader.text(root, "base_link", {});
    const std::string tip = reader.text(root, "tip_link", {});
    if (reader.error())
        return notDescribed(stream, file, *reader.error());
    if (urdf.empty() && description.pad)
        return notDescribed(stream, file, RecordedStreamText::tr("it has a pad and no links"));
    if (urdf.empty())
        return arm;
    auto chain = chainOf(urdf, base, tip, file);
    if (!chain)
        return notDescribed(stream, file, chain.error());
    if ((*chain)->joints() != *joints)
        return notDescribed(stream, file, RecordedStreamText::tr("its links have another number of joints"));
    arm.chain = std::move(*chain);
    return arm;
}

} // namespace teleta::pipeline
