// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/foreign_formats.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/model/bake.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace teleta::pattern;
using nlohmann::json;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

const std::string kData = std::string(TELETA_SOURCE_DIR) + "/tests/data/patterns/";

/// Largest difference of the intensities, where b may be a millisecond early or late.
double difference(const Pattern& a, const Pattern& b, double step_s) {
    double largest = 0.0;
    for (double t_s = 0.5 * step_s; t_s < a.duration_s; t_s += step_s) {
        for (std::size_t i = 0; i < 6; ++i) {
            double nearest = 1.0;
            for (const double late_s : {-0.001, 0.0, 0.001})
                nearest = std::min(nearest, std::abs(evaluate(a, t_s)[i] - evaluate(b, t_s + late_s)[i]));
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

Pattern patternOf(PatternImport import) {
    return std::move(import.pattern);
}

Expected<Pattern> readHjif(const std::string& text) {
    return patternFromHjif(text, "p.hjif").map(patternOf);
}

Expected<Pattern> readTact(const std::string& text) {
    return patternFromTact(text, "p.tact").map(patternOf);
}

/// A text with one part replaced, which must be there.
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

void expectRefused(const Expected<Pattern>& pattern, const std::string& part) {
    ASSERT_FALSE(pattern) << part;
    EXPECT_EQ(pattern.error().kind, ErrorKind::badInput);
    EXPECT_GT(pattern.error().where.line, 0) << describe(pattern.error());
    EXPECT_NE(describe(pattern.error()).find(part), std::string::npos) << describe(pattern.error());
}

} // namespace

TEST(Hjif, readsTheHandWrittenFile) {
    const Expected<Pattern> pattern = loadPattern(kData + "two_tactors.hjif");
    ASSERT_TRUE(pattern) << describe(pattern.error());
    EXPECT_EQ(pattern->id, "two_tactors");
    EXPECT_EQ(pattern->name, "Two tactors");
    EXPECT_EQ(pattern->notes, "by hand");
    EXPECT_EQ(pattern->duration_s, 2.0);
    EXPECT_EQ(pattern->tracks[0], (Track{{0.0, 1.0}, {2.0, 0.5}}));
    EXPECT_EQ(pattern->tracks[3], (Track{{0.5, 0.5}, {0.75, 0.5}, {0.75, 0.0}, {1.0, 0.0}, {2.0, 1.0}}));
    for (const std::size_t i : {1, 2, 4, 5})
        EXPECT_TRUE(pattern->tracks[i].empty());
}

TEST(Hjif, writesTheHandWrittenFileAgain) {
    const Expected<Pattern> pattern = loadPattern(kData + "two_tactors.hjif");
    ASSERT_TRUE(pattern);
    const Expected<std::string> text = patternToHjif(*pattern, "2026-01-31");
    ASSERT_TRUE(text);
    EXPECT_EQ(json::parse(*text), json::parse(readAll(kData + "two_tactors.hjif")));
    EXPECT_EQ(text->find("effect_semantic"), std::string::npos);
    EXPECT_EQ(text->find("curve_type"), std::string::npos);
}

TEST(Hjif, hasWholeNumbersForTimesAndFrequenciesAndRisingPositions) {
    for (const Pattern& pattern : builtInPatterns()) {
        const Expected<std::string> text = patternToHjif(pattern, "2026-01-31");
        ASSERT_TRUE(text);
        for (const json& channel : json::parse(*text)["perceptions"][0]["channels"]) {
            if (channel["bands"].empty())
                continue;
            ASSERT_FALSE(channel["bands"][0]["effects"].empty()) << pattern.id;
            for (const json& effect : channel["bands"][0]["effects"]) {
                EXPECT_TRUE(effect["position"].is_number_integer());
                long before = -1;
                for (const json& keyframe : effect["keyframes"]) {
                    EXPECT_TRUE(keyframe["relative_position"].is_number_integer());
                    EXPECT_TRUE(keyframe["frequency_modulation"].is_number_integer());
                    EXPECT_GT(keyframe["relative_position"].get<long>(), before) << pattern.id;
                    before = keyframe["relative_position"].get<long>();
                }
            }
        }
        const Expected<Pattern> again = readHjif(*text);
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_LT(difference(pattern, *again, 0.0113), 0.005) << pattern.id;
        EXPECT_NEAR(again->duration_s, pattern.duration_s, 0.0005) << pattern.id;
    }
}

TEST(Hjif, silenceAtTheEndComesBack) {
    Pattern pattern;
    pattern.duration_s = 3.0;
    pattern.tracks[4] = {{0.5, 1.0}, {1.0, 1.0}};
    const Expected<std::string> text = patternToHjif(pattern, "2026-01-31");
    ASSERT_TRUE(text);
    const json silence = json::parse(*text)["perceptions"][0]["channels"][0]["bands"][0]["effects"][0];
    EXPECT_EQ(silence["position"], 1000);
    ASSERT_EQ(silence["keyframes"].size(), 2U);
    EXPECT_EQ(silence["keyframes"][1]["relative_position"], 2000);
    EXPECT_EQ(silence["keyframes"][0]["amplitude_modulation"], 0.0);
    EXPECT_EQ(silence["keyframes"][1]["amplitude_modulation"], 0.0);
    const Expected<Pattern> again = readHjif(*text);
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->duration_s, 3.0);
    EXPECT_EQ(again->tracks, pattern.tracks);
    pattern.duration_s = 1.5;
    pattern.tracks[4].clear();
    const Expected<std::string> empty = patternToHjif(pattern, "2026-01-31");
    ASSERT_TRUE(empty);
    EXPECT_EQ(readHjif(*empty)->duration_s, 1.5) << "of nothing but silence";
}

// Masks of ISO/IEC 23090-31: right forearm 0x1000, left forearm 0x2000, left wrist 0x8000.
TEST(Hjif, theArmIsInTheMaskOfTheBody) {
    const std::string right = readAll(kData + "two_tactors.hjif");
    EXPECT_EQ(readHjif(right)->arm, Arm::right);
    std::string left = right;
    for (std::size_t at = left.find(": 4096"); at != std::string::npos; at = left.find(": 4096"))
        left.replace(at, 6, ": 8192");
    const Expected<Pattern> pattern = readHjif(left);
    ASSERT_TRUE(pattern) << describe(pattern.error());
    EXPECT_EQ(pattern->arm, Arm::left);
    const Expected<std::string> again = patternToHjif(*pattern, "2026-01-31");
    ASSERT_TRUE(again);
    EXPECT_EQ(json::parse(*again), json::parse(left));
    EXPECT_EQ(readHjif(changed(right, ": 4096", ": 32768"))->arm, Arm::right)
        << "the mask of the device, not of a channel";
}

TEST(Hjif, stepsWithinAStretchMoveAMillisecondAtMost) {
    Pattern pattern;
    pattern.duration_s = 1.0;
    pattern.tracks[0] = {{0.0, 0.5}, {0.3, 0.5}, {0.3, 1.0}, {1.0, 1.0}};
    const Expected<std::string> text = patternToHjif(pattern, "2026-01-31");
    ASSERT_TRUE(text);
    const Expected<Pattern> again = readHjif(*text);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->tracks[0], (Track{{0.0, 0.5}, {0.299, 0.5}, {0.3, 1.0}, {1.0, 1.0}}));
}

TEST(Hjif, refusesWhatAPatternCannotHoldWithThePlace) {
    const std::string good = readAll(kData + "two_tactors.hjif");
    const auto read = readHjif;
    expectRefused(read(changed(good, "\"VectorialWave\"", "\"Wave\"")), "band_type");
    expectRefused(read(changed(good, "\"Basis\"", "\"Reference\"")), "id");
    expectRefused(read(changed(good, "\"Basis\"", "\"Sound\"")), "effect_type");
    expectRefused(read(changed(good, "\"amplitude_modulation\": 1.0", "\"amplitude_modulation\": 1.5")),
                  "keyframes/0/amplitude_modulation");
    expectRefused(read(changed(good, "\"relative_position\": 2000", "\"relative_position\": 1.5")),
                  "relative_position");
    expectRefused(read(changed(good, "\"position\": 500", "\"position\": -1")), "position");
    expectRefused(read(changed(good, "\"timescale\": 1000", "\"timescale\": 0")), "timescale");
    expectRefused(read(changed(good, "\"perceptions\"", "\"perception\"")), "perceptions");
    expectRefused(read(good.substr(0, good.size() / 2)), "JSON");
}

TEST(Hjif, otherTimescalesAndGainsCount) {
    std::string text = readAll(kData + "two_tactors.hjif");
    text = changed(text, "\"timescale\": 1000", "\"timescale\": 500");
    text = changed(text, "\"gain\": 1.0", "\"gain\": 0.5");
    const Expected<Pattern> pattern = readHjif(text);
    ASSERT_TRUE(pattern);
    EXPECT_EQ(pattern->tracks[0], (Track{{0.0, 0.5}, {4.0, 0.25}}));
    EXPECT_EQ(pattern->duration_s, 4.0);
}

TEST(Haptic, readsAZipThatAnotherProgramMade) {
    const Expected<Pattern> pattern = loadPattern(kData + "six.haptic.zip");
    ASSERT_TRUE(pattern) << describe(pattern.error());
    EXPECT_EQ(pattern->id, "six");
    EXPECT_EQ(pattern->name, "Steps");
    EXPECT_EQ(pattern->duration_s, 1.5);
    EXPECT_EQ(pattern->tracks[1], (Track{{0.25, 0.75}, {1.0, 0.75}}));
    EXPECT_EQ(pattern->tracks[4], (Track{{0.0, 0.0}, {1.5, 1.0}}));
    EXPECT_TRUE(pattern->tracks[0].empty());
}

TEST(Haptic, writesEnvelopesAsTheHandWrittenOnes) {
    const Expected<Pattern> pattern = loadPattern(kData + "six.haptic.zip");
    ASSERT_TRUE(pattern);
    const Expected<std::vector<ZipEntry>> original = readZip(readAll(kData + "six.haptic.zip"), "");
    const Expected<std::vector<ZipEntry>> written = patternToHaptics(*pattern);
    ASSERT_TRUE(original && written);
    ASSERT_EQ(written->size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ((*written)[i].name, (*original)[i].name);
        const json ours = json::parse((*written)[i].content);
        const json theirs = json::parse((*original)[i].content);
        EXPECT_EQ(ours["version"], theirs["version"]);
        EXPECT_EQ(ours["signals"]["continuous"]["envelopes"]["amplitude"],
                  theirs["signals"]["continuous"]["envelopes"]["amplitude"]);
    }
}

TEST(Haptic, emphasisBecomesABurst) {
    const Expected<Pattern> pattern = loadPattern(kData + "emphasis.haptic");
    ASSERT_TRUE(pattern) << describe(pattern.error());
    EXPECT_DOUBLE_EQ(evaluate(*pattern, 0.51)[0], 0.9);
    EXPECT_NEAR(evaluate(*pattern, 0.25)[0], 0.375, 1e-12);
    EXPECT_NEAR(evaluate(*pattern, 1.0)[0], 0.25, 1e-12);
}

TEST(Haptic, zipsComeBackAndAreTheSameEveryTime) {
    const TemporaryFolder folder;
    for (const Pattern& pattern : builtInPatterns()) {
        const std::string path = folder.path(pattern.id + ".haptic.zip");
        ASSERT_TRUE(savePattern(pattern, path));
        const std::string bytes = readAll(path);
        ASSERT_TRUE(savePattern(pattern, path));
        EXPECT_EQ(readAll(path), bytes);
        const Expected<Pattern> again = loadPattern(path);
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_EQ(again->duration_s, pattern.duration_s);
        EXPECT_LT(difference(pattern, *again, 0.0113), kBakeTolerance) << pattern.id;
    }
}

TEST(Haptic, refusesBadFilesWithThePlace) {
    const std::string good = readAll(kData + "emphasis.haptic");
    const auto read = [](const std::string& text) {
        return patternFromHaptic(text, "p.haptic").map(patternOf);
    };
    expectRefused(read(changed(good, "\"major\": 1", "\"major\": 2")), "version/major");
    expectRefused(read(changed(good, "\"amplitude\": 0.25", "\"amplitude\": -0.25")),
                  "amplitude/0/amplitude");
    expectRefused(read(changed(good, "\"time\": 1.5", "\"time\": 0.25")), "amplitude/2/time");
    expectRefused(read(changed(good, "\"amplitude\": 0.9", "\"amplitude\": 0.1")), "emphasis/amplitude");
    expectRefused(read(changed(good, "\"signals\"", "\"signal\"")), "signals");
    EXPECT_FALSE(patternFromHaptics({{"tactor7.haptic", good}}, "p.zip"));
    EXPECT_FALSE(patternFromHaptics({{"readme.txt", good}}, "p.zip"));
    EXPECT_FALSE(patternFromHaptics({{"a1.haptic", good}, {"b1.haptic", good}}, "p.zip"));
    const Expected<PatternImport> inside = patternFromHaptics({{"tactor2.haptic", "{"}}, "p.zip");
    ASSERT_FALSE(inside);
    EXPECT_EQ(inside.error().where.file, "p.zip/tactor2.haptic");
}

TEST(Haptic, oneFileHoldsOneTactorOnly) {
    const TemporaryFolder folder;
    EXPECT_TRUE(savePattern(*findBuiltIn("shape.F.dynamic"), folder.path("a.haptic")));
    EXPECT_EQ(savePattern(*findBuiltIn("shape.E.dynamic"), folder.path("b.haptic")).error().kind,
              ErrorKind::refused);
    EXPECT_EQ(savePattern(*findBuiltIn("shape.E.dynamic"), folder.path("b.ahap")).error().kind,
              ErrorKind::refused);
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(Zip, refusesDamageAndHugeContent) {
    const std::string good = readAll(kData + "six.haptic.zip");
    EXPECT_FALSE(readZip("", "z"));
    EXPECT_FALSE(readZip("PK", "z"));
    EXPECT_FALSE(readZip(good.substr(0, good.size() - 30), "z"));
    std::string flipped = good;
    flipped[100] = static_cast<char>(flipped[100] ^ 0x10);
    EXPECT_FALSE(readZip(flipped, "z"));
    const Expected<std::string> bomb = writeZip({{"tactor1.haptic", std::string(kMostZipBytes + 1, ' ')}});
    ASSERT_TRUE(bomb);
    EXPECT_LT(bomb->size(), 1'000'000U);
    EXPECT_FALSE(readZip(*bomb, "z"));
    const Expected<std::string> many = writeZip(std::vector<ZipEntry>(1, {"a", ""}));
    ASSERT_TRUE(many);
    EXPECT_EQ(readZip(*many, "z")->size(), 1U);
}

TEST(Ahap, intensityIsTheSquareRootInCurvesOf16PointsAndEventsOf30Seconds) {
    Pattern pattern;
    pattern.duration_s = 70.0;
    pattern.tracks[2] = {{5.0, 0.0}, {70.0, 1.0}};
    const Expected<std::string> text = tactorToAhap(pattern, 2);
    ASSERT_TRUE(text);
    const json root = json::parse(*text);
    EXPECT_EQ(root["Version"], 1.0);
    double covered_s = 0.0;
    double end_s = 5.0;
    std::size_t points = 0;
    for (const json& part : root["Pattern"]) {
        if (part.contains("Event")) {
            EXPECT_EQ(part["Event"]["EventType"], "HapticContinuous");
            EXPECT_LE(part["Event"]["EventDuration"].get<double>(), 30.0);
            covered_s += part["Event"]["EventDuration"].get<double>();
            continue;
        }
        const json& curve = part["ParameterCurve"];
        EXPECT_EQ(curve["ParameterID"], "HapticIntensityControl");
        EXPECT_NEAR(curve["Time"].get<double>(), end_s, 1e-9);
        const json& control = curve["ParameterCurveControlPoints"];
        EXPECT_LE(control.size(), 16U);
        EXPECT_EQ(control[0]["Time"], 0.0);
        for (const json& point : control) {
            const double t_s = curve["Time"].get<double>() + point["Time"].get<double>();
            EXPECT_NEAR(point["ParameterValue"].get<double>(), std::sqrt((t_s - 5.0) / 65.0), 1e-4);
            end_s = t_s;
        }
        points += control.size();
    }
    EXPECT_NEAR(covered_s, 65.0, 1e-9);
    EXPECT_NEAR(end_s, 70.0, 1e-9);
    EXPECT_GT(points, 16U);
}

TEST(Ahap, silentTactorsHaveNoEvents) {
    const Expected<std::vector<ZipEntry>> files = patternToAhaps(*findBuiltIn("shape.E.static"));
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 6U);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(json::parse((*files)[i].content)["Pattern"].empty(), i != 0 && i != 3) << i;
}

TEST(Tact, readsTheHandWrittenFiles) {
    const Expected<Pattern> dots = loadPattern(kData + "dots.tact");
    ASSERT_TRUE(dots) << describe(dots.error());
    EXPECT_EQ(dots->name, "Dots");
    EXPECT_EQ(dots->duration_s, 2.0);
    EXPECT_EQ(evaluate(*dots, 0.099), (teleta::core::Intensities{}));
    EXPECT_EQ(evaluate(*dots, 0.2), (teleta::core::Intensities{0.5, 0, 0, 1.0, 0, 0}));
    EXPECT_EQ(evaluate(*dots, 0.4), (teleta::core::Intensities{0.25, 0, 0, 0, 0, 0}));
    EXPECT_EQ(evaluate(*dots, 0.8), (teleta::core::Intensities{}));
    EXPECT_EQ(evaluate(*dots, 1.05), (teleta::core::Intensities{0, 0, 0, 0, 0, 0.7501}));
    const Expected<Pattern> fades = loadPattern(kData + "fades.tact");
    ASSERT_TRUE(fades) << describe(fades.error());
    EXPECT_NEAR(evaluate(*fades, 0.15)[0], 0.2, 1e-12);
    EXPECT_NEAR(evaluate(*fades, 0.4)[0], 0.4, 1e-12);
    EXPECT_NEAR(evaluate(*fades, 0.65)[1], 0.5, 1e-12);
    EXPECT_NEAR(evaluate(*fades, 0.72)[1], 0.8, 1e-12); // falling from 1 at 0.7, over the dot of 0.5
    EXPECT_NEAR(evaluate(*fades, 0.9)[1], 0.5, 1e-12);
}

TEST(Tact, writesTheDotsOfTheHandWrittenFileAgain) {
    const Expected<Pattern> dots = loadPattern(kData + "dots.tact");
    ASSERT_TRUE(dots);
    const Expected<std::string> text = patternToTact(*dots);
    ASSERT_TRUE(text);
    const json effect = json::parse(*text)["project"]["tracks"][0]["effects"][0];
    const json theirs = json::parse(readAll(kData + "dots.tact"))["project"]["tracks"][0]["effects"][0];
    json expected = theirs["modes"]["ForearmL"]["dotMode"]["feedback"];
    for (json& feedback : expected) { // the effect of the file begins at 100 ms
        feedback["startTime"] = feedback["startTime"].get<int>() + 100;
        feedback["endTime"] = feedback["endTime"].get<int>() + 100;
    }
    EXPECT_EQ(effect["modes"]["ForearmL"]["dotMode"]["feedback"], expected);
    EXPECT_EQ(effect["offsetTime"], 2000);
}

TEST(Tact, theArmIsTheDeviceThatPlays) {
    const std::string left = readAll(kData + "dots.tact");
    const Expected<Pattern> dots = readTact(left);
    ASSERT_TRUE(dots);
    EXPECT_EQ(dots->arm, Arm::left);
    std::string other = left;
    for (std::size_t at = other.find("ForearmL"); at != std::string::npos; at = other.find("ForearmL"))
        other.replace(at, 8, "ForearmR");
    const Expected<Pattern> right = readTact(other);
    ASSERT_TRUE(right) << describe(right.error());
    EXPECT_EQ(right->arm, Arm::right);
    EXPECT_EQ(right->tracks, dots->tracks);
    const Expected<std::string> text = patternToTact(*right);
    ASSERT_TRUE(text);
    const json modes = json::parse(*text)["project"]["tracks"][0]["effects"][0]["modes"];
    EXPECT_FALSE(modes["ForearmR"]["dotMode"]["feedback"].empty());
    EXPECT_TRUE(modes["ForearmL"]["dotMode"]["feedback"].empty());
    const Expected<Pattern> again = readTact(*text);
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->arm, Arm::right);
}

// The files of other programs: layout Tactosy2 with two rows of three motors on each arm, and a path mode.
TEST(Tact, hasTheLayoutAndTheModesOfOtherPrograms) {
    const json project = json::parse(*patternToTact(*findBuiltIn("shape.E.static")))["project"];
    EXPECT_EQ(project["layout"]["type"], "Tactosy2");
    for (const char* arm : {"ForearmL", "ForearmR"}) {
        const json places = project["layout"]["layouts"][arm];
        ASSERT_EQ(places.size(), 6U);
        EXPECT_EQ(places[1]["x"], 0.5);
        EXPECT_EQ(places[2]["y"], 0.0);
        EXPECT_EQ(places[3]["x"], 0.0);
        EXPECT_EQ(places[5]["y"], 1.0);
        const json path = project["tracks"][0]["effects"][0]["modes"][arm]["pathMode"]["feedback"];
        ASSERT_EQ(path.size(), 1U);
        EXPECT_EQ(path[0]["movingPattern"], "CONST_SPEED");
        EXPECT_TRUE(path[0]["pointList"].empty());
    }
}

TEST(Tact, slopesBecomePiecesOf20Milliseconds) {
    for (const Pattern& pattern : builtInPatterns()) {
        const Expected<std::string> text = patternToTact(pattern);
        ASSERT_TRUE(text);
        const Expected<Pattern> again = readTact(*text);
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_EQ(again->duration_s, pattern.duration_s) << pattern.id;
        // Half a piece of the steepest slope, 1 in 0.3 s, and the rounding.
        EXPECT_LT(difference(pattern, *again, 0.0113), 0.010 / 0.3 + 1e-3) << pattern.id;
    }
}

TEST(Tact, refusesWhatAPatternCannotHoldWithThePlace) {
    const std::string good = readAll(kData + "dots.tact");
    const auto read = readTact;
    expectRefused(read(changed(good, "\"DOT_MODE\"", "\"LINE_MODE\"")), "mode");
    expectRefused(read(changed(good, "\"intensity\": 0.5", "\"intensity\": 1.5")), "pointList/0/intensity");
    expectRefused(read(changed(good, "\"NONE\"", "\"FADE\"")), "playbackType");
    expectRefused(read(changed(good, "\"endTime\": 400", "\"endTime\": 4")), "endTime");
    expectRefused(read(changed(good, "\"startTime\": 0", "\"startTime\": -1")), "startTime");
    expectRefused(read("{\"project\": []}"), "project");
    expectRefused(read("[]"), "project");
}
