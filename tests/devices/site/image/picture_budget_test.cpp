// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/image/jpeg_picture.h"
#include "devices/site/image/picture_budget.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

namespace teleta::site_link {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

struct Sent {
    std::int64_t time_ns = 0;
    double bits = 0.0;
    int quality = 0;
};

/// A camera of so many pictures a second for so long; sizes: bytes of a picture coded with a quality.
std::vector<Sent> run(const PictureSettings& settings, int rate_Hz, int time_s,
                      const std::function<std::size_t(int quality)>& size) {
    PictureBudget budget(settings);
    std::vector<Sent> sent;
    for (int i = 1; i <= rate_Hz * time_s; ++i) {
        const std::int64_t now_ns = i * kSecond_ns / rate_Hz;
        budget.arrived(now_ns);
        if (!budget.mayWrite(now_ns))
            continue;
        const int quality = budget.quality();
        const std::size_t bytes = size(quality);
        sent.push_back({now_ns, PictureBudget::bitsOf(bytes), quality});
        budget.written(bytes, now_ns);
    }
    return sent;
}

/// The most bits above most_kbitPerS T, of any stretch of time T that begins and ends with a picture.
double excess_bits(const std::vector<Sent>& sent, double most_kbitPerS) {
    double most = 0.0;
    for (std::size_t first = 0; first < sent.size(); ++first) {
        double bits = 0.0;
        for (std::size_t last = first; last < sent.size(); ++last) {
            bits += sent[last].bits;
            const double time_s = static_cast<double>(sent[last].time_ns - sent[first].time_ns) * 1e-9;
            most = std::max(most, bits - 1e3 * most_kbitPerS * time_s);
        }
    }
    return most;
}

double largest_bits(const std::vector<Sent>& sent) {
    return std::ranges::max_element(sent, {}, &Sent::bits)->bits;
}

TEST(PictureBudget, countsWhatIsPutAroundEachFragment) {
    // Two fragments of 1200 bytes, 150 bytes around each.
    EXPECT_DOUBLE_EQ(PictureBudget::bitsOf(2000), 8.0 * (2000 + 2 * 150));
    EXPECT_DOUBLE_EQ(PictureBudget::bitsOf(0), 8.0 * 150);
}

TEST(PictureBudget, leavesPicturesThatFitAsTheyAre) {
    const auto sent = run({70, 3000.0}, 30, 4, [](int) { return 4'000; });
    EXPECT_EQ(sent.size(), 120U);
    EXPECT_TRUE(std::ranges::all_of(sent, [](const Sent& one) { return one.quality == 70; }));
}

TEST(PictureBudget, theQualityFallsBeforeTheRate) {
    // 70 kB with quality 70, with quality 10 as small as such pictures get: 12 kB.
    const auto size = [](int quality) { return static_cast<std::size_t>(2'000 + 1'000 * quality); };
    const auto sent = run({70, 4000.0}, 30, 10, size);
    EXPECT_LE(excess_bits(sent, 4000.0), 1.0001 * largest_bits(sent));
    // After two seconds nearly each picture goes, with a quality for which 30 fit: 16.7 kB less overheads.
    const auto later = [](const Sent& one) { return one.time_ns > 2 * kSecond_ns; };
    EXPECT_GT(std::ranges::count_if(sent, later), 220);
    for (const Sent& one : sent) {
        if (later(one)) {
            EXPECT_LE(one.quality, 13) << one.time_ns;
        }
    }
}

TEST(PictureBudget, theRateFallsWhereTheQualityCannot) {
    const auto sent = run({70, 1000.0}, 30, 20, [](int) { return 60'000; });
    EXPECT_LE(excess_bits(sent, 1000.0), 1.0001 * largest_bits(sent));
    EXPECT_EQ(sent.back().quality, PictureSettings::kLowestQuality);
    // One takes 8 (60000 + 51 x 150) / 1e6 = 0.541 s; the camera gives the next one 17 pictures later.
    EXPECT_EQ(sent.size(), 36U);
}

TEST(PictureBudget, theQualityComesBack) {
    bool isLarge = true;
    std::size_t count = 0;
    const auto size = [&](int quality) {
        isLarge = ++count < 100;
        return static_cast<std::size_t>(isLarge ? 1'000 * quality : 40 * quality);
    };
    const auto sent = run({80, 3000.0}, 30, 30, size);
    EXPECT_LT(sent[90].quality, 20);
    EXPECT_EQ(sent.back().quality, 80);
}

TEST(PictureBudget, holdsForRealPictures) {
    // Noise over a gradient, the hardest to code, 640 x 480, that changes in each picture.
    cv::RNG random(7);
    const PictureSettings settings{70, 2000.0};
    const auto size = [&random](int quality) {
        cv::Mat picture(480, 640, CV_8UC3);
        random.fill(picture, cv::RNG::UNIFORM, 0, 256);
        cv::GaussianBlur(picture, picture, {9, 9}, 3.0);
        const auto bytes = toJpeg(
            core::ColourImage{{std::shared_ptr<void>(), picture.data}, picture.cols, picture.rows}, quality);
        EXPECT_TRUE(bytes);
        return bytes ? bytes->size() : 0;
    };
    const auto sent = run(settings, 30, 4, size);
    EXPECT_LE(excess_bits(sent, settings.most_kbitPerS), 1.0001 * largest_bits(sent));
    double bits = 0.0;
    for (const Sent& one : sent)
        bits += one.time_ns > kSecond_ns ? one.bits : 0.0;
    ::testing::Test::RecordProperty("kbit_per_s", static_cast<int>(bits / 3e3));
    ::testing::Test::RecordProperty("pictures", static_cast<int>(sent.size()));
    EXPECT_GT(bits / 3e3, 0.5 * settings.most_kbitPerS);
}

TEST(PictureBudget, aCameraThatPausesOrSendsTwiceAtOneTimeIsNoTrouble) {
    PictureBudget budget({70, 3000.0});
    budget.arrived(kSecond_ns);
    budget.arrived(kSecond_ns);
    budget.written(100'000, kSecond_ns);
    EXPECT_EQ(budget.quality(), 70);
    EXPECT_FALSE(budget.mayWrite(kSecond_ns));
    budget.arrived(100 * kSecond_ns);
    EXPECT_TRUE(budget.mayWrite(100 * kSecond_ns));
}

} // namespace
} // namespace teleta::site_link
