// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/scene_run/arm/simulated_player.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

namespace teleta::scene_run {

namespace {

playback::Program full(double duration_s) {
    return {[](double) { return core::Intensities{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }, duration_s};
}

/// A player and what it has written of the first tactor.
struct Played {
    Played() {
        auto opened = SimulatedPlayer::open(folder.path("."));
        EXPECT_TRUE(opened);
        player.emplace(std::move(*opened));
    }
    /// Ends the file. Rows: a time, and the intensity from then on.
    std::vector<std::pair<double, double>> finish() {
        EXPECT_TRUE(player->finish());
        std::vector<std::pair<double, double>> rows;
        auto csv = core::CsvReader::open(folder.path("bracelet.csv"));
        EXPECT_TRUE(csv);
        for (std::vector<double> row; csv->next(row).value_or(false);)
            rows.emplace_back(row[0], row[1]);
        return rows;
    }

    test::TemporaryFolder folder;
    std::optional<SimulatedPlayer> player;
};

double at(const std::vector<std::pair<double, double>>& rows, double time_s) {
    double intensity = 0.0;
    for (const auto& [from_s, value] : rows)
        if (from_s <= time_s)
            intensity = value;
    return intensity;
}

} // namespace

TEST(SimulatedPlayer, beginsWithTheNextFrameAndEndsWithTheProgram) {
    Played played;
    SimulatedPlayer& player = *played.player;
    player.advance(0.1, 0.1);
    player.play(full(0.05));
    EXPECT_FALSE(player.onset_s());
    player.advance(0.101, 0.101);
    EXPECT_FALSE(player.onset_s()); // the next frame is due at 105 ms
    player.advance(0.105, 0.105);
    ASSERT_TRUE(player.onset_s());
    EXPECT_NEAR(*player.onset_s(), 0.105, 1e-9);
    player.advance(0.15, 0.15);
    player.advance(0.3, 0.3);
    const auto rows = played.finish();
    EXPECT_EQ(at(rows, 0.104), 0.0);
    EXPECT_GT(at(rows, 0.106), 0.0);
    EXPECT_GT(at(rows, 0.154), 0.0);
    EXPECT_EQ(at(rows, 0.156), 0.0);
    EXPECT_NEAR(rows.back().first, 0.155, 1e-9) << "and nothing after it";
}

TEST(SimulatedPlayer, isOffATenthOfASecondAfterTheArmFellSilentAndStaysOff) {
    Played played;
    SimulatedPlayer& player = *played.player;
    player.play(full(10.0));
    for (int ms = 0; ms <= 600; ms += 5)
        player.advance(0.001 * ms, 0.2);
    player.advance(0.605, 0.605); // it is back: nothing goes on by itself
    const auto rows = played.finish();
    for (const double on_s : {0.1, 0.2, 0.299})
        EXPECT_GT(at(rows, on_s), 0.0) << on_s;
    for (const double off_s : {0.306, 0.5, 0.6, 0.7})
        EXPECT_EQ(at(rows, off_s), 0.0) << off_s;
}

} // namespace teleta::scene_run
