// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/gel/gel_field.h"
#include "backend/vision/gel/gel_follower.h"
#include "tests/backend/vision/gel/simulated_motion.h"

#include <algorithm>

namespace teleta::vision {

using simulation::GelContact;
using simulation::GelRenderer;
using simulation::SimulatedGel;

namespace {

constexpr std::size_t kRest = MarkerGel::kReferencePictures;

/// A gel whose pictures go through a follower, 25 a second.
class Stream {
public:
    explicit Stream(const SimulatedGel& gel)
        : follower(test::fileOf(gel))
        , m_renderer(gel) {}

    /// Lengths of the contact in pixels, which the closed forms do not mind.
    void show(const std::optional<GelContact>& contact = {}, int pictures = 1) {
        for (int i = 0; i < pictures; ++i) {
            std::vector<Eigen::Vector2d> places = m_renderer.rest_px();
            for (Eigen::Vector2d& place : places)
                place += contact ? contact->displacement_m(place) : Eigen::Vector2d(Eigen::Vector2d::Zero());
            cv::Mat1b picture;
            m_renderer.draw(places, picture);
            next(picture);
        }
    }
    void next(const cv::Mat1b& picture) { follower.next(picture, m_time_s += 0.04); }

    GelFollower follower;

private:
    GelRenderer m_renderer;
    double m_time_s = 0.0;
};

const GelContact kDragged{
    .centre_m = {160.0, 120.0}, .radius_m = 70.0, .slip_m = {8.0, 0.0}, .stick = 0.70710678};

cv::Mat1b even(int level) {
    return cv::Mat1b(240, 320, static_cast<std::uint8_t>(level));
}

} // namespace

TEST(GelFollower, takesTheRestFromTheFirstPicturesAndFollowsFromThere) {
    Stream stream(SimulatedGel{});
    stream.show({}, kRest - 1);
    EXPECT_FALSE(stream.follower.hasReference());
    EXPECT_EQ(stream.follower.missing(), 1U);
    EXPECT_FALSE(stream.follower.usable());
    stream.show();
    ASSERT_TRUE(stream.follower.hasReference());
    EXPECT_EQ(stream.follower.missing(), 0U);
    EXPECT_EQ(stream.follower.reference().size(), kRest);
    EXPECT_TRUE(stream.follower.usable());
    EXPECT_TRUE(stream.follower.contacts().empty());
    stream.show(kDragged);
    ASSERT_EQ(stream.follower.contacts().size(), 1U);
    EXPECT_GT(stream.follower.contacts().front().shearProxy_m.x(), 1e-4);
    EXPECT_TRUE(stream.follower.problem().empty());
}

TEST(GelFollower, goesOnWithTheFormerRestUntilTheNewOneIsThere) {
    Stream stream(SimulatedGel{});
    stream.show({}, kRest);
    stream.show(kDragged);
    ASSERT_EQ(stream.follower.contacts().size(), 1U);
    stream.follower.renewReference();
    stream.show(kDragged, kRest - 1);
    EXPECT_EQ(stream.follower.contacts().size(), 1U);
    EXPECT_EQ(stream.follower.references(), 1U);
    stream.show(kDragged);
    EXPECT_EQ(stream.follower.references(), 2U);
    // What was dragged is at rest now; back is a contact the other way.
    EXPECT_TRUE(stream.follower.contacts().empty());
    stream.show();
    ASSERT_EQ(stream.follower.contacts().size(), 1U);
    EXPECT_LT(stream.follower.contacts().front().shearProxy_m.x(), -1e-4);
    EXPECT_EQ(stream.follower.contacts().front().id, 2);
}

TEST(GelFollower, saysWhyThereIsNoRestAndTriesAgain) {
    Stream stream(SimulatedGel{});
    for (std::size_t i = 0; i < kRest; ++i)
        stream.next(even(0));
    EXPECT_FALSE(stream.follower.hasReference());
    EXPECT_NE(stream.follower.problem().find("black"), std::string::npos) << stream.follower.problem();
    stream.show({}, kRest);
    EXPECT_TRUE(stream.follower.hasReference());
    EXPECT_TRUE(stream.follower.problem().empty()) << stream.follower.problem();
}

TEST(GelFollower, aPictureThatCannotBeUsedHasNoContactAndThoseAfterItDo) {
    Stream stream(SimulatedGel{});
    stream.show({}, kRest);
    stream.show(kDragged);
    stream.next(even(120));
    EXPECT_FALSE(stream.follower.usable());
    EXPECT_TRUE(stream.follower.faults().dead);
    EXPECT_TRUE(stream.follower.contacts().empty());
    EXPECT_FALSE(stream.follower.problem().empty());
    stream.next(cv::Mat1b());
    EXPECT_FALSE(stream.follower.usable());
    EXPECT_FALSE(stream.follower.problem().empty());
    stream.next(cv::Mat1b(100, 100, std::uint8_t{7}));
    EXPECT_FALSE(stream.follower.usable());
    EXPECT_NE(stream.follower.problem().find("100 x 100"), std::string::npos) << stream.follower.problem();
    stream.show(kDragged, 3);
    EXPECT_TRUE(stream.follower.usable());
    EXPECT_EQ(stream.follower.gel().found(), 80U);
    EXPECT_EQ(stream.follower.contacts().size(), 1U);
}

TEST(GelFollower, tellsAGelThatHasLostAThirdOfItsMarkers) {
    const SimulatedGel whole;
    Stream stream(whole);
    stream.show({}, kRest);
    cv::Mat1b picture;
    GelRenderer renderer(whole);
    renderer.draw(renderer.rest_px(), picture);
    picture.colRange(0, 150).setTo(130);
    for (int i = 0; i < 24; ++i)
        stream.next(picture);
    EXPECT_FALSE(stream.follower.faults().torn);
    for (int i = 0; i < 4; ++i)
        stream.next(picture);
    EXPECT_TRUE(stream.follower.faults().torn);
    EXPECT_NE(stream.follower.problem().find("30 %"), std::string::npos);
}

TEST(GelFollower, aGivenRestIsThatOfTheFirstPictures) {
    Stream first(SimulatedGel{});
    first.show({}, kRest);
    Stream second(SimulatedGel{.seed = 2});
    ASSERT_TRUE(second.follower.setReference(first.follower.reference()));
    second.show(kDragged);
    ASSERT_EQ(second.follower.contacts().size(), 1U);
    EXPECT_EQ(second.follower.gel().noise_px(), first.follower.gel().noise_px());
    for (std::size_t i = 0; i < 80; ++i)
        EXPECT_EQ(second.follower.gel().markers()[i].rest_px, first.follower.gel().markers()[i].rest_px);
    const std::vector<cv::Mat1b> black{even(0)};
    EXPECT_FALSE(second.follower.setReference(black));
    EXPECT_TRUE(second.follower.hasReference());
}

TEST(GelFollower, followsBrightMarkers) {
    Stream stream(SimulatedGel{.ground = 60.0, .contrast = -90.0});
    stream.show({}, kRest);
    stream.show(kDragged);
    EXPECT_EQ(stream.follower.contacts().size(), 1U);
}

} // namespace teleta::vision
