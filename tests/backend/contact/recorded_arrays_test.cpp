// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/tactile_features.h"
#include "backend/core/data/frame_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

using namespace teleta;
using namespace teleta::contact;

namespace {

/// A recording of one person on one of two pressure arrays (PoPu data set, see tests/data/README.md).
struct Recording {
    std::string tare;
    std::string file;
    core::ArrayLayout layout;
    bool inverted = false;
    double threshold = 0.0; ///< raw units, above the idle noise
};

std::ostream& operator<<(std::ostream& out, const Recording& recording) {
    return out << recording.file;
}

const std::string kAll = TELETA_SOURCE_DIR "/../shared/data/popu/";
const std::string kExcerpts = TELETA_SOURCE_DIR "/tests/data/popu/";

Recording sensomatt(const std::string& name) {
    return {kAll + "sensomatt_empty1.csv", kAll + "sensomatt_" + name + ".csv", {12, 6, 0.01}, true, 5.0};
}

Recording tactilus(const std::string& folder, const std::string& name) {
    return {folder + "tactilus_empty1.csv", folder + "tactilus_" + name + ".csv", {64, 27, 0.01}, false, 5.0};
}

class RecordedArrays : public testing::TestWithParam<Recording> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(GetParam().file))
            GTEST_SKIP() << "skipped: the recordings are not here";
        const auto tare = core::readTare(GetParam().tare, layout());
        ASSERT_TRUE(tare) << describe(tare.error());
        m_tare = *tare;
        auto file = core::FrameFile::open(GetParam().file, layout());
        ASSERT_TRUE(file) << describe(file.error());
        std::vector<float> raw(layout().taxels());
        double time_s = 0.0;
        for (;;) {
            const auto more = file->next(time_s, raw);
            ASSERT_TRUE(more) << describe(more.error());
            if (!*more)
                break;
            m_times_s.push_back(time_s);
            m_raw.push_back(raw);
        }
        ASSERT_GE(m_raw.size(), 10U);
    }

    [[nodiscard]] static core::ArrayLayout layout() { return GetParam().layout; }

    [[nodiscard]] FrameConditioner conditioner() const {
        return {layout().taxels(), {.tare = m_tare, .inverted = GetParam().inverted, .dead = {}}};
    }

    std::vector<float> m_tare;
    std::vector<double> m_times_s;
    std::vector<std::vector<float>> m_raw;
};

} // namespace

TEST_P(RecordedArrays, featuresAreThePlainSumsOfTheRecording) {
    const FrameConditioner conditioner = this->conditioner();
    FeatureExtractor extractor(layout(), {.threshold_N = GetParam().threshold});
    std::vector<float> load(layout().taxels());
    std::vector<std::uint8_t> dead(layout().taxels());
    for (const std::vector<float>& raw : m_raw) {
        ASSERT_EQ(conditioner.apply(raw, load, dead), 0U);
        const TactileFeatures features = extractor.compute(load, dead);
        double force = 0.0;
        double momentX = 0.0;
        double momentY = 0.0;
        int active = 0;
        double activeX = 0.0;
        double activeY = 0.0;
        for (int row = 0; row < layout().rows; ++row) {
            for (int column = 0; column < layout().columns; ++column) {
                const auto i = static_cast<std::size_t>(row * layout().columns + column);
                const double difference = static_cast<double>(raw[i]) - static_cast<double>(m_tare[i]);
                const double plain = std::max(0.0, GetParam().inverted ? -difference : difference);
                force += plain;
                momentX += plain * (column - 0.5 * (layout().columns - 1)) * 0.01;
                momentY += plain * (row - 0.5 * (layout().rows - 1)) * 0.01;
                if (static_cast<float>(plain) >= static_cast<float>(GetParam().threshold)) {
                    ++active;
                    activeX += (column - 0.5 * (layout().columns - 1)) * 0.01;
                    activeY += (row - 0.5 * (layout().rows - 1)) * 0.01;
                }
            }
        }
        // Loads are held in single precision: 24 bits.
        ASSERT_NEAR(features.force_N, force, 1e-6 * force);
        ASSERT_EQ(features.active, active);
        ASSERT_EQ(features.dead, 0);
        if (active == 0) {
            ASSERT_FALSE(features.copX_m);
            continue;
        }
        ASSERT_NEAR(*features.copX_m, momentX / force, 1e-6);
        ASSERT_NEAR(*features.copY_m, momentY / force, 1e-6);
        ASSERT_NEAR(*features.cocX_m, activeX / active, 1e-12);
        ASSERT_NEAR(*features.cocY_m, activeY / active, 1e-12);
        if (active > 1) {
            ASSERT_GE(*features.lambda1_m2, *features.lambda2_m2);
            ASSERT_GE(*features.lambda2_m2, 0.0);
        }
    }
}

TEST_P(RecordedArrays, forcesOfTheContactsAddUpToTheLoadOverTheThreshold) {
    const FrameConditioner conditioner = this->conditioner();
    ContactSegmenter segmenter(layout(), {.threshold_N = GetParam().threshold});
    std::vector<float> load(layout().taxels());
    std::vector<std::uint8_t> dead(layout().taxels());
    for (const std::vector<float>& raw : m_raw) {
        conditioner.apply(raw, load, dead);
        double expected = 0.0;
        for (const float value : load)
            expected += value >= static_cast<float>(GetParam().threshold) ? static_cast<double>(value) : 0.0;
        const std::span<Contact> contacts = segmenter.segment(load, dead);
        double force = 0.0;
        for (const Contact& contact : contacts)
            force += contact.force_N;
        ASSERT_NEAR(force, expected, 1e-12 * expected);
        ASSERT_EQ(contacts.empty(), expected == 0.0);
    }
}

// A contact that moves by less than half a taxel, with no other contact of the two frames within its gate,
// must be the same one.
TEST_P(RecordedArrays, contactsThatStayInTheirPlaceKeepTheirIdentities) {
    const FrameConditioner conditioner = this->conditioner();
    ContactSegmenter segmenter(layout(), {.threshold_N = GetParam().threshold});
    ContactTracker tracker;
    const double gate_m = TrackingSettings{}.gate_m;
    std::vector<float> load(layout().taxels());
    std::vector<std::uint8_t> dead(layout().taxels());
    std::vector<Contact> before;
    std::size_t contactsSeen = 0;
    std::size_t stayed = 0;
    for (std::size_t frame = 0; frame < m_raw.size(); ++frame) {
        conditioner.apply(m_raw[frame], load, dead);
        const std::span<Contact> contacts = segmenter.segment(load, dead);
        tracker.assign(contacts, m_times_s[frame]);
        std::vector<int> ids;
        for (const Contact& contact : contacts)
            ids.push_back(contact.id);
        std::ranges::sort(ids);
        ASSERT_TRUE(std::ranges::adjacent_find(ids) == ids.end());
        for (const Contact& old : before) {
            const auto distance_m = [&](const Contact& other) {
                return std::hypot(other.x_m - old.x_m, other.y_m - old.y_m);
            };
            const auto near = [&](const Contact& other) { return distance_m(other) < 2.0 * gate_m; };
            const auto now = std::ranges::find_if(contacts, near);
            if (std::ranges::count_if(before, near) == 1 && std::ranges::count_if(contacts, near) == 1 &&
                distance_m(*now) < 0.005) {
                ASSERT_EQ(now->id, old.id) << "frame " << frame;
                ++stayed;
            }
        }
        before.assign(contacts.begin(), contacts.end());
        contactsSeen += contacts.size();
    }
    EXPECT_EQ(stayed > 0, contactsSeen > 0);
}

INSTANTIATE_TEST_SUITE_P(Excerpt, RecordedArrays, testing::Values(tactilus(kExcerpts, "sequence_excerpt")));
INSTANTIATE_TEST_SUITE_P(Postures, RecordedArrays,
                         testing::Values(sensomatt("left1"), sensomatt("prone2"), sensomatt("right3"),
                                         sensomatt("supine1"), tactilus(kAll, "left1"),
                                         tactilus(kAll, "prone2"), tactilus(kAll, "right3"),
                                         tactilus(kAll, "supine1")));
INSTANTIATE_TEST_SUITE_P(Sequences, RecordedArrays,
                         testing::Values(sensomatt("sequence"), tactilus(kAll, "sequence")));

namespace {

class PersonLyingStill : public RecordedArrays {};

} // namespace

TEST_P(PersonLyingStill, theTwoHeaviestContactsKeepTheirIdentities) {
    const FrameConditioner conditioner = this->conditioner();
    ContactSegmenter segmenter(layout(), {.threshold_N = GetParam().threshold, .minimumTaxels = 2});
    // Three taxels; a large contact whose edge flickers jumps by more than the gate for an array of 3.4 mm.
    ContactTracker tracker({.gate_m = 0.03});
    std::vector<float> load(layout().taxels());
    std::vector<std::uint8_t> dead(layout().taxels());
    for (std::size_t frame = 0; frame < m_raw.size(); ++frame) {
        conditioner.apply(m_raw[frame], load, dead);
        const std::span<Contact> contacts = segmenter.segment(load, dead);
        tracker.assign(contacts, m_times_s[frame]);
        ASSERT_GE(contacts.size(), 2U);
        std::vector<int> ids{contacts[0].id, contacts[1].id};
        std::ranges::sort(ids);
        EXPECT_EQ(ids, (std::vector<int>{1, 2})) << "frame " << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Postures, PersonLyingStill,
                         testing::Values(tactilus(kAll, "left1"), tactilus(kAll, "prone2"),
                                         tactilus(kAll, "right3")));
