// SPDX-License-Identifier: GPL-3.0-or-later
// What files of other programs play on a bracelet, and what is said to be lost.
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace teleta::pattern;
using nlohmann::json;
using teleta::core::Expected;
using teleta::core::Intensities;
using teleta::test::TemporaryFolder;

namespace {

std::size_t lost(const Expected<PatternImport>& import, LossKind kind) {
    for (const Loss& loss : import->losses) {
        if (loss.kind == kind)
            return loss.count;
    }
    return 0;
}

json event(double time_s, double duration_s, double intensity, double sharpness) {
    json event{{"Time", time_s},
               {"EventType", duration_s > 0.0 ? "HapticContinuous" : "HapticTransient"},
               {"EventParameters",
                {{{"ParameterID", "HapticIntensity"}, {"ParameterValue", intensity}},
                 {{"ParameterID", "HapticSharpness"}, {"ParameterValue", sharpness}}}}};
    if (duration_s > 0.0)
        event["EventDuration"] = duration_s;
    return {{"Event", event}};
}

json curve(const char* id, double time_s, const std::vector<std::pair<double, double>>& points) {
    json all = json::array();
    for (const auto& [at_s, value] : points)
        all.push_back({{"Time", at_s}, {"ParameterValue", value}});
    return {
        {"ParameterCurve", {{"ParameterID", id}, {"Time", time_s}, {"ParameterCurveControlPoints", all}}}};
}

Expected<PatternImport> readAhap(const json& parts, const ImportOptions& options = {}) {
    return patternFromAhap(json{{"Version", 1.0}, {"Pattern", parts}}.dump(), "p.ahap", options);
}

json effect(const char* type, long position, const json& keyframes) {
    return {{"effect_type", type}, {"position", position}, {"keyframes", keyframes}};
}

json keyframe(long at, double amplitude) {
    return {{"relative_position", at}, {"amplitude_modulation", amplitude}};
}

Expected<PatternImport> readHjif(const json& channels, const json& library = json::array(),
                                 const ImportOptions& options = {}) {
    const json root{
        {"version", "2023"},
        {"timescale", 1000},
        {"perceptions",
         {{{"perception_modality", "Vibrotactile"}, {"effect_library", library}, {"channels", channels}}}}};
    return patternFromHjif(root.dump(), "p.hjif", options);
}

json channel(const char* bandType, const json& effects) {
    const json band{{"band_type", bandType}, {"effects", effects}};
    return {{"gain", 1.0}, {"bands", json::array({band})}};
}

json tact(const json& modes) {
    return {{"project",
             {{"name", "n"},
              {"tracks", {{{"enable", true}, {"effects", {{{"startTime", 100}, {"modes", modes}}}}}}}}}};
}

json pathDevice(const json& points, const char* playback = "NONE") {
    return {{"mode", "PATH_MODE"},
            {"dotMode", {{"feedback", json::array()}}},
            {"pathMode",
             {{"feedback",
               {{{"movingPattern", "CONST_SPEED"}, {"playbackType", playback}, {"pointList", points}}}}}}};
}

json pathPoint(int time_ms, double x, double y, double intensity) {
    return {{"time", time_ms}, {"x", x}, {"y", y}, {"intensity", intensity}};
}

json dotDevice(int tactor) {
    return {{"mode", "DOT_MODE"},
            {"dotMode",
             {{"feedback",
               {{{"startTime", 0},
                 {"endTime", 200},
                 {"playbackType", "NONE"},
                 {"pointList", {{{"index", tactor}, {"intensity", 0.5}}}}}}}}}};
}

} // namespace

// The amplitude is the square of the event's intensity times the curve.
TEST(AhapImport, amplitudeIsTheSquareOfTheIntensityTimesTheCurve) {
    const auto import = readAhap(
        {event(0.5, 2.0, 0.8, 0.5), curve("HapticIntensityControl", 1.0, {{0.0, 1.0}, {1.0, 0.25}})});
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_NEAR(import->pattern.duration_s, 2.5, 1e-12);
    for (double t_s = 0.51; t_s < 2.49; t_s += 0.0173) {
        const double control = t_s < 1.0 ? 1.0 : t_s < 2.0 ? 1.0 - 0.75 * (t_s - 1.0) : 0.25;
        const double expected = std::pow(0.8 * control, 2.0);
        for (const double intensity : evaluate(import->pattern, t_s))
            EXPECT_NEAR(intensity, expected, kBakeTolerance) << t_s;
    }
    EXPECT_EQ(evaluate(import->pattern, 0.49), Intensities{});
}

TEST(AhapImport, dynamicParametersHoldUntilTheNextControl) {
    const json half{
        {"Parameter", {{"ParameterID", "HapticIntensityControl"}, {"Time", 0.5}, {"ParameterValue", 0.5}}}};
    const auto import = readAhap(
        {event(0.0, 2.0, 1.0, 0.5), half, curve("HapticIntensityControl", 1.0, {{0.0, 1.0}, {0.5, 1.0}})});
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_NEAR(evaluate(import->pattern, 0.25)[0], 1.0, 1e-12);
    EXPECT_NEAR(evaluate(import->pattern, 0.75)[0], 0.25, 1e-12);
    EXPECT_NEAR(evaluate(import->pattern, 1.75)[0], 1.0, 1e-12);
}

TEST(AhapImport, everythingThatIsNotHeldIsCounted) {
    json attack = event(1.0, 1.0, 1.0, 0.2);
    attack["Event"]["EventParameters"].push_back({{"ParameterID", "AttackTime"}, {"ParameterValue", 0.3}});
    const json sound{{"Event", {{"Time", 0.0}, {"EventType", "AudioCustom"}}}};
    const auto import = readAhap({event(0.25, 0.0, 0.5, 1.0),
                                  event(3.0, 0.0, 0.5, 1.0),
                                  attack,
                                  sound,
                                  curve("HapticSharpnessControl", 0.0, {{0.0, 1.0}, {1.0, 0.5}}),
                                  {{"Unknown", json::object()}}});
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::burst), 2U);
    EXPECT_EQ(lost(import, LossKind::frequency), 5U) << "three events and two points of a curve";
    EXPECT_EQ(lost(import, LossKind::envelope), 1U);
    EXPECT_EQ(lost(import, LossKind::audio), 1U);
    EXPECT_EQ(lost(import, LossKind::parameter), 1U);
    EXPECT_EQ(lost(import, LossKind::oneSignal), 6U);
    EXPECT_NEAR(evaluate(import->pattern, 0.25 + 0.5 * kBurst_s)[5], 0.25, 1e-12);
    EXPECT_NEAR(import->pattern.duration_s, 3.0 + kBurst_s, 1e-12);
    for (const Loss& loss : import->losses) {
        EXPECT_FALSE(describe(loss).empty());
        if (loss.kind == LossKind::burst) {
            EXPECT_EQ(loss.first_s, 0.25);
        }
    }
}

TEST(AhapImport, playsOnTheChosenTactors) {
    const auto import = readAhap(json::array({event(0.0, 1.0, 1.0, 0.5)}), {.arm = {}, .tactors = {1, 4}});
    ASSERT_TRUE(import);
    EXPECT_EQ(evaluate(import->pattern, 0.5), (Intensities{0, 1, 0, 0, 1, 0}));
    EXPECT_TRUE(import->oneSignal);
}

TEST(AhapImport, whatTheProgramWroteComesBackToItsTactorWithoutLosses) {
    const TemporaryFolder folder;
    for (const Pattern& pattern : builtInPatterns()) {
        const std::string path = folder.path(pattern.id + ".ahap.zip");
        ASSERT_TRUE(savePattern(pattern, path));
        const auto import = importPattern(path);
        ASSERT_TRUE(import) << describe(import.error());
        EXPECT_TRUE(import->losses.empty()) << describe(import->losses.front());
        for (double t_s = 0.0057; t_s < pattern.duration_s; t_s += 0.0113) {
            const Intensities expected = evaluate(pattern, t_s);
            const Intensities read = evaluate(import->pattern, t_s);
            // The square of a root that is off by 1e-3 is off by 2e-3 and the tolerance of its own lines.
            for (std::size_t i = 0; i < 6; ++i)
                EXPECT_NEAR(read[i], expected[i], 3.1 * kBakeTolerance) << pattern.id << ' ' << t_s;
        }
    }
    Pattern third;
    third.duration_s = 1.0;
    third.tracks[2] = {{0.0, 0.5}, {1.0, 0.5}};
    for (const char* name : {"a.ahap", "a.haptic"}) {
        ASSERT_TRUE(savePattern(third, folder.path(name)));
        const auto import = importPattern(folder.path(name));
        ASSERT_TRUE(import) << describe(import.error());
        EXPECT_TRUE(import->losses.empty()) << describe(import->losses.front());
        EXPECT_NEAR(evaluate(import->pattern, 0.5)[2], 0.5, 1e-5) << name;
        EXPECT_EQ(evaluate(import->pattern, 0.5)[0], 0.0) << name;
    }
}

TEST(AhapImport, refusesBadFilesWithThePlace) {
    const auto expectRefused = [](const json& parts, const char* part) {
        const auto import = readAhap(parts);
        ASSERT_FALSE(import) << part;
        EXPECT_GT(import.error().where.line, 0);
        EXPECT_NE(describe(import.error()).find(part), std::string::npos) << describe(import.error());
    };
    json noDuration = event(0.0, 1.0, 1.0, 0.5);
    noDuration["Event"].erase("EventDuration");
    expectRefused(json::array({noDuration}), "EventDuration");
    expectRefused(json::array({curve("HapticIntensityControl", 0.0, {{1.0, 0.0}, {0.5, 0.0}})}), "Time");
    expectRefused(json::array({event(-1.0, 1.0, 1.0, 0.5)}), "Time");
    expectRefused(json::array({{{"Event", {{"Time", 0.0}, {"EventType", "Smell"}}}}}), "EventType");
    expectRefused(json::array({1.0}), "Pattern");
}

TEST(HjifImport, transientsBecomeBurstsAndReferencesAreFollowed) {
    json referred = effect("Reference", 500, json::array());
    referred.erase("keyframes");
    referred["id"] = 7;
    json library = effect("Basis", 0, {keyframe(0, 0.25), keyframe(100, 0.25)});
    library["id"] = 7;
    json both =
        channel("Transient", json::array({effect("Basis", 0, {keyframe(200, -0.5), keyframe(100, 0.75)})}));
    both["bands"].push_back({{"band_type", "VectorialWave"}, {"effects", json::array({referred})}});
    const json channels = json::array({both});
    const auto import = readHjif(channels, json::array({library}));
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::burst), 2U);
    EXPECT_EQ(lost(import, LossKind::oneSignal), 6U);
    EXPECT_EQ(evaluate(import->pattern, 0.12)[3], 0.75);
    EXPECT_EQ(evaluate(import->pattern, 0.22)[3], 0.5);
    EXPECT_EQ(evaluate(import->pattern, 0.22 + kBurst_s)[3], 0.0);
    EXPECT_EQ(evaluate(import->pattern, 0.55)[3], 0.25);
    EXPECT_EQ(import->pattern.duration_s, 0.6);
}

// What the MPEG reference encoder writes for its "DoubleTick" at 2 kbit/s, with 2000 ticks a second.
TEST(HjifImport, placesBeforeTheirEffectThatTheReferenceEncoderWrapsCountFromItsBegin) {
    const auto import = readHjif(json::array(
        {channel("VectorialWave", json::array({effect("Basis", 458,
                                                      {keyframe(65534, 0.75), keyframe(0, 0.0),
                                                       keyframe(48, 0.0), keyframe(50, 0.5)})}))}));
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::early), 1U);
    EXPECT_EQ(evaluate(import->pattern, 0.458 + 0.049)[0], 0.25);
    EXPECT_EQ(import->pattern.duration_s, 0.508);
    const auto two = readHjif(json::array(
        {channel("VectorialWave", json::array({effect("Basis", 458,
                                                      {keyframe(65530, 0.75), keyframe(65534, 0.75),
                                                       keyframe(0, 0.0), keyframe(50, 0.5)})}))}));
    ASSERT_TRUE(two) << describe(two.error());
    EXPECT_EQ(lost(two, LossKind::early), 2U);
    EXPECT_EQ(two->pattern.duration_s, 0.508);
    EXPECT_FALSE(readHjif(json::array({channel(
        "VectorialWave", json::array({effect("Basis", 0, {keyframe(20'000, 0.75), keyframe(0, 0.0)})}))})))
        << "the times decrease";
}

TEST(HjifImport, aTransientAtTheEndOfTheLongestPatternIsWhole) {
    const long end = std::lround(1000.0 * Pattern::kLongest_s);
    const auto import = readHjif(json::array(
        {channel("Transient", json::array({effect("Basis", 0, json::array({keyframe(end, 0.5)}))}))}));
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::burst), 1U);
    EXPECT_EQ(evaluate(import->pattern, Pattern::kLongest_s - 0.5 * kBurst_s)[0], 0.5);
    EXPECT_EQ(import->pattern.duration_s, Pattern::kLongest_s);
}

// The size of a line from 1 to -1 is |1 - 2t|.
TEST(HjifImport, curvesPlayTheirSizeAndCodedWavesAreLost) {
    json curves =
        channel("Curve", json::array({effect("Basis", 0, {keyframe(0, 1.0), keyframe(1000, -1.0)})}));
    curves["bands"].push_back(
        {{"band_type", "WaveletWave"}, {"effects", json::array({effect("Basis", 0, json::array())})}});
    const auto import = readHjif(json::array({curves}));
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::curve), 1U);
    EXPECT_EQ(lost(import, LossKind::waveform), 1U);
    for (const double t_s : {0.125, 0.25, 0.5, 0.75, 0.9})
        EXPECT_NEAR(evaluate(import->pattern, t_s)[0], std::abs(1.0 - 2.0 * t_s), 1e-12);
    const auto nothing =
        readHjif(json::array({channel("WaveletWave", json::array({effect("Basis", 0, json::array())}))}));
    ASSERT_FALSE(nothing) << "nothing is left to play";
}

TEST(HjifImport, channelsBeyondTheTactorsAndOtherModalitiesAreCounted) {
    json channels = json::array();
    for (int i = 0; i < 8; ++i)
        channels.push_back(channel("VectorialWave",
                                   json::array({effect("Basis", 0, {keyframe(0, 0.5), keyframe(10, 0.5)})})));
    const auto import = readHjif(channels);
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::channel), 2U);
    EXPECT_EQ(lost(import, LossKind::place), 8U);
    EXPECT_EQ(evaluate(import->pattern, 0.005), (Intensities{0.5, 0.5, 0.5, 0.5, 0.5, 0.5}));
    const json root{{"version", "2023"},
                    {"perceptions", {{{"perception_modality", "Temperature"}, {"channels", json::array()}}}}};
    const auto warm = patternFromHjif(root.dump(), "p.hjif");
    ASSERT_TRUE(warm) << describe(warm.error());
    EXPECT_EQ(lost(warm, LossKind::modality), 1U);
}

/// As 5G-MAG/rt-v3c-content has it at 183d4c3 (S41C2RAR05_footprod.hjif): one square pulse on a channel
/// "Left" of no stated sense.
TEST(HjifImport, aPulseOfAPlayerForTelephonesIsRead) {
    json pulse = effect("Basis", 533, {keyframe(0, 1.0), keyframe(100, 1.0)});
    pulse["phase"] = 0.0;
    pulse["base_signal"] = "Square";
    json left = channel("VectorialWave", json::array({pulse}));
    left["description"] = "Left";
    left["mixing_coefficient"] = 1.0;
    left["body_part_mask"] = 0;
    const json root{
        {"version", "2023"},
        {"timescale", 1000},
        {"avatars", json::array()},
        {"perceptions",
         {{{"perception_modality", "Other"}, {"effect_library", json::array()}, {"channels", {left}}}}},
        {"syncs", json::array()}};
    const auto import = patternFromHjif(root.dump(), "p.hjif");
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::modality), 0U);
    EXPECT_EQ(lost(import, LossKind::frequency), 0U) << "it has none";
    EXPECT_EQ(lost(import, LossKind::shape), 1U) << "it is square";
    EXPECT_NEAR(import->pattern.duration_s, 0.633, 1e-9);
    EXPECT_EQ(evaluate(import->pattern, 0.3), (Intensities{}));
    EXPECT_EQ(evaluate(import->pattern, 0.58), (Intensities{1.0, 1.0, 1.0, 1.0, 1.0, 1.0}));
}

/// A wave of each kind of ISO/IEC 23090-31, the first of the effects in the library and played twice.
TEST(HjifImport, theShapesAndPhasesOfWavesAreTold) {
    json square = effect("Basis", 0, {keyframe(0, 0.5), keyframe(45, 0.5)});
    square["id"] = 0;
    square["base_signal"] = "Square";
    json waves = json::array();
    for (const long at : {200, 100}) {
        json again = effect("Reference", at, json::array());
        again["id"] = 0;
        waves.push_back(again);
    }
    long at = 300;
    for (const char* const name : {"Sine", "Triangle", "SawToothUp", "SawToothDown"}) {
        json wave = effect("Basis", at, {keyframe(0, 0.5), keyframe(45, 0.5)});
        wave["base_signal"] = name;
        wave["phase"] = 0.0;
        waves.push_back(wave);
        at += 100;
    }
    json late = effect("Basis", at, {keyframe(0, 0.5), keyframe(45, 0.5)});
    late["phase"] = 1.57;
    waves.push_back(late);
    const auto import = readHjif(json::array({channel("VectorialWave", waves)}), json::array({square}));
    ASSERT_TRUE(import) << describe(import.error());
    const auto told = std::ranges::find(import->losses, LossKind::shape, &Loss::kind);
    ASSERT_NE(told, import->losses.end());
    EXPECT_EQ(told->count, 6U) << "all but the sine";
    EXPECT_EQ(told->first_s, 0.1);
    EXPECT_EQ(evaluate(import->pattern, 0.12)[0], 0.5);
    json number = effect("Basis", 0, {keyframe(0, 0.5), keyframe(45, 0.5)});
    number["base_signal"] = 1;
    EXPECT_FALSE(readHjif(json::array({channel("VectorialWave", json::array({number}))})));
}

/// As the reference encoder writes IVS files (010_Bounce100 at 27f9bab): the amplitude at the end is 0 but
/// for the last step of its coding, below it, and a keyframe has no frequency.
TEST(HjifImport, aDecayThatIsCodedBelowZeroEndsCloseToIt) {
    json first = keyframe(0, 1.0);
    first["frequency_modulation"] = 500;
    json last = keyframe(120, -0.003921568393707275);
    last["frequency_modulation"] = 500;
    const auto import = readHjif(json::array(
        {channel("VectorialWave", json::array({effect("Basis", 0, {first, keyframe(20, 1.0), last})}))}));
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::frequency), 2U);
    EXPECT_NEAR(evaluate(import->pattern, 0.01)[0], 1.0, 1e-9);
    EXPECT_NEAR(evaluate(import->pattern, 0.07)[0], 0.5, 0.003);
    EXPECT_NEAR(evaluate(import->pattern, 0.12)[0], 0.0, 0.004);
}

TEST(HjifImport, compositionsEndSomewhere) {
    json composed = effect("Composite", 0, json::array());
    composed["id"] = 1;
    json itself = effect("Reference", 0, json::array());
    itself["id"] = 1;
    composed["composition"] = {itself, itself};
    const auto import =
        readHjif(json::array({channel("VectorialWave", json::array({itself}))}), json::array({composed}));
    ASSERT_FALSE(import);
    EXPECT_GT(import.error().where.line, 0);
}

TEST(HjifImport, whatTheProgramWroteHasNoLosses) {
    for (const Pattern& pattern : builtInPatterns()) {
        const auto import = patternFromHjif(*patternToHjif(pattern, "2026-01-31"), "p.hjif");
        ASSERT_TRUE(import) << describe(import.error());
        EXPECT_TRUE(import->losses.empty()) << describe(import->losses.front());
    }
}

// Along a row from motor 1 to motor 2 the energy moves: sqrt(1 - b) and sqrt(b).
TEST(TactImport, motorsShareTheEnergyOfAPath) {
    const json file =
        tact({{"ForearmL", pathDevice({pathPoint(0, 0.0, 0.0, 0.8), pathPoint(500, 0.5, 0.0, 0.8)})}});
    const auto import = patternFromTact(file.dump(), "p.tact");
    ASSERT_TRUE(import) << describe(import.error());
    EXPECT_EQ(lost(import, LossKind::path), 1U);
    for (double b = 0.05; b < 0.96; b += 0.1) {
        const Intensities at = evaluate(import->pattern, 0.1 + 0.5 * b);
        EXPECT_NEAR(at[0], 0.8 * std::sqrt(1.0 - b), 2e-3) << b;
        EXPECT_NEAR(at[1], 0.8 * std::sqrt(b), 2e-3) << b;
        EXPECT_EQ(at[3], 0.0);
    }
    const json middle =
        tact({{"ForearmL",
               pathDevice({pathPoint(0, 0.25, 0.5, 1.0), pathPoint(500, 0.25, 0.5, 1.0)}, "FADE_OUT")}});
    const auto held = patternFromTact(middle.dump(), "p.tact");
    ASSERT_TRUE(held);
    for (const std::size_t motor : {0, 1, 3, 4})
        EXPECT_NEAR(evaluate(held->pattern, 0.35)[motor], 0.5 * 0.5, 1e-9)
            << "a quarter of the energy, half faded";
}

TEST(TactImport, theOtherArmAndOtherDevicesAreCounted) {
    const json file = tact({{"ForearmL", dotDevice(0)}, {"ForearmR", dotDevice(3)}, {"Head", dotDevice(1)}});
    const auto left = patternFromTact(file.dump(), "p.tact");
    ASSERT_TRUE(left) << describe(left.error());
    EXPECT_TRUE(left->bothArms);
    EXPECT_EQ(left->pattern.arm, Arm::left);
    EXPECT_EQ(lost(left, LossKind::otherArm), 1U);
    EXPECT_EQ(lost(left, LossKind::otherDevice), 1U);
    EXPECT_EQ(evaluate(left->pattern, 0.2)[0], 0.5);
    const auto right = patternFromTact(file.dump(), "p.tact", {.arm = Arm::right, .tactors = {}});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->pattern.arm, Arm::right);
    EXPECT_EQ(evaluate(right->pattern, 0.2), (Intensities{0, 0, 0, 0.5, 0, 0}));
}

TEST(HapticImport, oneBreakpointAndABurstAtTheEnd) {
    const auto read = [](const json& amplitude, const json& frequency) {
        const json root{
            {"version", {{"major", 1}}},
            {"signals",
             {{"continuous", {{"envelopes", {{"amplitude", amplitude}, {"frequency", frequency}}}}}}}};
        return patternFromHaptic(root.dump(), "p.haptic");
    };
    const auto point = read(json::array({{{"time", 0.0}, {"amplitude", 0.5}}}), json::array());
    ASSERT_TRUE(point) << describe(point.error());
    EXPECT_EQ(lost(point, LossKind::point), 1U);
    EXPECT_EQ(point->pattern.duration_s, 0.0);
    const auto burst =
        read({{{"time", 0.0}, {"amplitude", 0.5}},
              {{"time", 1.0}, {"amplitude", 0.5}, {"emphasis", {{"amplitude", 1.0}, {"frequency", 0.5}}}}},
             {{{"time", 0.0}, {"frequency", 0.1}}, {{"time", 1.0}, {"frequency", 0.9}}});
    ASSERT_TRUE(burst) << describe(burst.error());
    EXPECT_EQ(lost(burst, LossKind::burst), 1U);
    EXPECT_EQ(lost(burst, LossKind::longer), 1U);
    EXPECT_EQ(lost(burst, LossKind::frequency), 3U) << "two points of the envelope and the emphasis";
    EXPECT_EQ(burst->pattern.duration_s, 1.0 + kBurst_s);
    EXPECT_EQ(evaluate(burst->pattern, 1.0 + 0.5 * kBurst_s)[0], 1.0);
}

// A slope of 1 in 0.5 s is off by half a piece of 20 ms: 0.02.
TEST(ExportLosses, namesTheErrorOfStepsAndTheObjects) {
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks[0] = {{0.0, 0.0}, {0.5, 1.0}, {0.50025, 1.0}, {0.50025, 0.0}};
    pattern.objects.push_back({"r", Ramp{0.6, 0.2, {1}, 0.5, 0.5, Easing::linear}, {}});
    const auto losses = exportLosses(pattern, PatternFormat::tact);
    ASSERT_TRUE(losses);
    const auto of = [&losses](LossKind kind) {
        return *std::find_if(losses->begin(), losses->end(),
                             [kind](const Loss& l) { return l.kind == kind; });
    };
    EXPECT_EQ(of(LossKind::steps).detail, "0.020");
    EXPECT_EQ(of(LossKind::objects).count, 1U);
    EXPECT_EQ(of(LossKind::rounding).first_s, 0.50025);
    EXPECT_TRUE(exportLosses(pattern, PatternFormat::own)->empty());
    EXPECT_TRUE(exportLosses(pattern, PatternFormat::wav)->empty());
}
