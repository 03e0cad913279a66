// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/contacts/camera_tracker.h"
#include "backend/vision/finders/contact_ladder.h"
#include "tests/backend/simulation/camera/camera_scene.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

namespace teleta::vision {
namespace {

constexpr double kPeriod_s = 0.025;

CylinderCamera cameraOf(int width_px, int height_px) {
    CameraParameters parameters;
    parameters.width_px = width_px;
    parameters.height_px = height_px;
    parameters.fx_px = parameters.fy_px = 0.36 * width_px;
    parameters.cx_px = 0.5 * (width_px - 1);
    parameters.cy_px = 0.5 * (height_px - 1);
    parameters.p_Sensor_Camera_m = {0.0, 0.0, -0.02};
    parameters.mirrored = true;
    return {*CameraModel::create(parameters), {}};
}

/// Finds nothing and counts its references.
class CountingFinder : public ContactFinder {
public:
    [[nodiscard]] std::vector<Arrow> arrows(std::size_t) const override { return {}; }

    int m_references = 0;

private:
    core::Expected<void> takeReference(const cv::Mat1b&) override {
        ++m_references;
        return {};
    }
    core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b&) override {
        return std::vector<CameraContact>();
    }
};

/// Throws as OpenCV does for images that it cannot process.
class ThrowingFinder : public ContactFinder {
public:
    [[nodiscard]] std::vector<Arrow> arrows(std::size_t) const override { return {}; }

    bool m_throwsAtReference = false;

private:
    core::Expected<void> takeReference(const cv::Mat1b& frame) override {
        if (m_throwsAtReference)
            (void)frame(cv::Rect(0, 0, frame.cols + 1, 1));
        return {};
    }
    core::Expected<std::vector<CameraContact>> findIn(const cv::Mat1b& frame) override {
        (void)frame(cv::Rect(0, 0, frame.cols + 1, 1));
        return std::vector<CameraContact>();
    }
};

class HardFrames : public testing::Test {
protected:
    void SetUp() override {
        auto tube = simulation::SimulatedTube::make(test::smallCameraScene(), 1);
        ASSERT_TRUE(tube);
        m_tube = std::move(*tube);
        m_tube->untouched(m_rest);
        auto finder = makeContactFinder(contactLadder().front(), m_tube->camera());
        ASSERT_TRUE(finder);
        m_tracker.emplace(std::move(*finder), CameraTracker::Settings());
    }
    cv::Mat1b press(double depth_m) {
        cv::Mat1b frame;
        m_tube->pressed({{.centre = {1.0, 0.04}, .ballRadius_m = 0.01, .depth_m = depth_m}}, frame);
        return frame;
    }

    std::unique_ptr<simulation::SimulatedTube> m_tube;
    cv::Mat1b m_rest;
    std::optional<CameraTracker> m_tracker;
};

} // namespace

TEST(ContactLadder, refusesImagesThatAreTooSmallOnEveryRung) {
    for (const ContactRung& rung : contactLadder()) {
        const auto finder = makeContactFinder(rung, cameraOf(10, 10));
        if (!rung.paper) { // which makes every image 512 x 288
            ASSERT_FALSE(finder) << rung.name;
            EXPECT_EQ(finder.error().kind, core::ErrorKind::refused);
        } else if (finder) {
            EXPECT_FALSE((*finder)->setReference(cv::Mat1b(10, 10, std::uint8_t{100})));
        }
    }
}

TEST(ContactLadder, refusesAReferenceWithoutTextureAndFramesOfAnotherSizeOrWithoutReference) {
    for (const char* name : {"dots", "fast-2"}) {
        const auto finder = makeContactFinder(*contactRung(name), cameraOf(820, 616));
        ASSERT_TRUE(finder) << name;
        const cv::Mat1b grey(616, 820, std::uint8_t{128});
        EXPECT_FALSE((*finder)->find(grey)) << name;
        EXPECT_FALSE((*finder)->setReference(grey)) << name;
        EXPECT_FALSE((*finder)->setReference(cv::Mat1b(10, 10, std::uint8_t{1}))) << name;
        EXPECT_FALSE((*finder)->find(grey)) << name;
    }
}

TEST(ContactLadder, hasNamesThatAreUniqueAndKnowsNoOther) {
    for (const ContactRung& rung : contactLadder())
        EXPECT_EQ(contactRung(rung.name), &rung);
    EXPECT_EQ(contactRung("none"), nullptr);
}

TEST(CameraTracker, tellsWhatOpenCvThrowsAsAnUnusableFrame) {
    const cv::Mat1b frame(4, 4, std::uint8_t{1});
    auto throwing = std::make_unique<ThrowingFinder>();
    throwing->m_throwsAtReference = true;
    CameraTracker without(std::move(throwing), {});
    const auto refused = without.next(frame, 0.0);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, core::ErrorKind::refused);
    CameraTracker tracker(std::make_unique<ThrowingFinder>(), {});
    ASSERT_TRUE(tracker.next(frame, 0.0));
    EXPECT_TRUE(tracker.next(frame, kPeriod_s));
    EXPECT_EQ(tracker.unusableFrames(), 1U);
    EXPECT_FALSE(tracker.whyUnusable().empty());
}

TEST(ContactLadder, endsItsWorkOnTheLensWhenItIsToldTo) {
    std::stop_source stop;
    stop.request_stop();
    for (const ContactRung& rung : contactLadder()) {
        // 16 million pixels, which take long.
        const auto finder = makeContactFinder(rung, cameraOf(4000, 4000), {}, stop.get_token());
        if (rung.method != FlowMethod::dots) {
            ASSERT_FALSE(finder) << rung.name;
            EXPECT_EQ(finder.error().kind, core::ErrorKind::cancelled) << rung.name;
            continue;
        }
        ASSERT_TRUE(finder);
        const auto taken = (*finder)->setReference(cv::Mat1b(4000, 4000, std::uint8_t{1}));
        ASSERT_FALSE(taken);
        EXPECT_EQ(taken.error().kind, core::ErrorKind::cancelled);
    }
}

TEST(ChangedPart, isAllThatAnAnswerDependsOnWhateverWasSeenBefore) {
    const auto tube = simulation::SimulatedTube::make(test::smallCameraScene(false), 1); // without noise
    ASSERT_TRUE(tube);
    const auto find = [&](ContactFinder& finder, double depth_m, double z_m, double radius_m) {
        cv::Mat1b frame;
        (*tube)->pressed({{.centre = {1.0, z_m}, .ballRadius_m = radius_m, .depth_m = depth_m}}, frame);
        auto found = finder.find(frame);
        EXPECT_TRUE(found);
        return found ? *found : std::vector<CameraContact>();
    };
    cv::Mat1b rest;
    (*tube)->untouched(rest);
    const auto make = [&] {
        auto finder = makeContactFinder(*contactRung("fast-2-changed"), (*tube)->camera());
        EXPECT_TRUE(finder && (*finder)->setReference(rest));
        return std::move(*finder);
    };
    const auto used = make();
    const auto fresh = make();
    (void)find(*used, 0.001, 0.09, 0.006); // a small part of the image at the far end
    used->forget();
    fresh->forget();
    const auto after = find(*used, 0.0012, 0.03, 0.012);
    const auto alone = find(*fresh, 0.0012, 0.03, 0.012);
    ASSERT_EQ(after.size(), alone.size());
    ASSERT_FALSE(alone.empty());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(after[i].p_Sensor_Centre_m, alone[i].p_Sensor_Centre_m);
        EXPECT_EQ(after[i].depth_m, alone[i].depth_m);
        EXPECT_EQ(after[i].area_px, alone[i].area_px);
    }
}

TEST_F(HardFrames, ofAContactThatComesAndGoesAreAnsweredByEveryRung) {
    const cv::Mat1b pressed = press(0.0012);
    for (const ContactRung& rung : contactLadder()) {
        auto finder = makeContactFinder(rung, m_tube->camera());
        ASSERT_TRUE(finder) << rung.name;
        ASSERT_TRUE((*finder)->setReference(m_rest)) << rung.name;
        EXPECT_TRUE((*finder)->find(pressed)) << rung.name;
        EXPECT_TRUE((*finder)->find(pressed)) << rung.name; // from the flow before, for those that do
        const auto gone = (*finder)->find(m_rest);
        ASSERT_TRUE(gone) << rung.name;
        if (rung.method == FlowMethod::dots || rung.changedOnly) {
            EXPECT_TRUE(gone->empty()) << rung.name;
        }
    }
}

TEST_F(HardFrames, thatCannotBeDecodedAreCountedAndEndNoContact) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    int id = 0;
    for (int i = 1; i <= 4; ++i) {
        const auto contacts = m_tracker->next(press(0.0003 * i), i * kPeriod_s);
        ASSERT_TRUE(contacts);
        if (i == 1)
            continue; // so light a touch falls between the dots
        ASSERT_EQ(contacts->size(), 1U);
        id = contacts->front().contact.id;
    }
    const auto nothing = m_tracker->next(cv::Mat1b(), 5 * kPeriod_s);
    ASSERT_TRUE(nothing && nothing->size() == 1);
    EXPECT_EQ(nothing->front().contact.id, id);
    EXPECT_FALSE(nothing->front().seen);
    EXPECT_EQ(nothing->front().event, ContactEvent::none);
    EXPECT_EQ(m_tracker->unusableFrames(), 1U);
    EXPECT_FALSE(m_tracker->whyUnusable().empty());
    const auto again = m_tracker->next(press(0.0012), 6 * kPeriod_s);
    ASSERT_TRUE(again && again->size() == 1);
    EXPECT_EQ(again->front().contact.id, id);
}

TEST_F(HardFrames, thatStayUndecodableEndEachContactOnce) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    for (int i = 1; i <= 4; ++i)
        ASSERT_TRUE(m_tracker->next(press(0.0003 * i), i * kPeriod_s));
    int ends = 0;
    for (int i = 5; i < 40; ++i) {
        const auto contacts = m_tracker->next(cv::Mat1b(), i * kPeriod_s);
        ASSERT_TRUE(contacts);
        for (const FollowedContact& followed : *contacts)
            ends += followed.event == ContactEvent::ends ? 1 : 0;
    }
    EXPECT_EQ(ends, 1);
}

TEST_F(HardFrames, thatShowNoSkinAreUnusableAndTheTrackerRecovers) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    ASSERT_TRUE(m_tracker->next(cv::Mat1b(m_rest.size(), std::uint8_t{0}), kPeriod_s));
    ASSERT_TRUE(m_tracker->next(cv::Mat1b(m_rest.size(), std::uint8_t{255}), 2 * kPeriod_s));
    EXPECT_EQ(m_tracker->unusableFrames(), 2U);
    const auto contacts = m_tracker->next(m_rest, 3 * kPeriod_s);
    ASSERT_TRUE(contacts);
    EXPECT_TRUE(contacts->empty());
    EXPECT_EQ(m_tracker->unusableFrames(), 2U);
}

TEST(HardPictures, ofFewPixelsShowNoContactWhereNothingTouchesAndStillOneThatDoes) {
    // Rings of dots 4 mm apart are 2.2 px apart at the far end of the tube with half of the pixels across,
    // and 1.3 px with 0.3 of them.
    for (const double share : {0.5, 0.4, 0.3}) {
        const auto tube = simulation::SimulatedTube::make(test::smallCameraScene(true, share), 1);
        ASSERT_TRUE(tube) << share;
        cv::Mat1b frame;
        (*tube)->untouched(frame);
        const auto finder = makeContactFinder(*contactRung("dots"), (*tube)->camera());
        ASSERT_TRUE(finder && (*finder)->setReference(frame)) << share;
        for (int i = 0; i < (teleta::test::kSanitized ? 4 : 40); ++i) {
            (*tube)->untouched(frame); // with other noise
            const auto contacts = (*finder)->find(frame);
            ASSERT_TRUE(contacts) << share;
            EXPECT_TRUE(contacts->empty()) << share << ", at " << contacts->front().p_Sensor_Centre_m.z();
        }
        (*tube)->pressed({{.centre = {1.0, 0.04}, .ballRadius_m = 0.01, .depth_m = 0.0012}}, frame);
        const auto contacts = (*finder)->find(frame);
        ASSERT_TRUE(contacts && contacts->size() == 1) << share;
        const Eigen::Vector3d truth_m(0.025 * std::cos(1.0), 0.025 * std::sin(1.0), 0.04);
        EXPECT_LT((contacts->front().p_Sensor_Centre_m - truth_m).norm(), 0.001) << share;
    }
}

TEST_F(HardFrames, thatFlickerShowNoContact) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    int frame = 0;
    for (const double brightness : {0.7, 1.2, 0.85, 1.1}) {
        cv::Mat1b lit;
        m_rest.convertTo(lit, CV_8U, brightness);
        const auto contacts = m_tracker->next(lit, ++frame * kPeriod_s);
        ASSERT_TRUE(contacts);
        EXPECT_TRUE(contacts->empty()) << brightness;
    }
}

TEST_F(HardFrames, thatJumpFurtherThanCanBeFollowedShowAContactAtThatPlaceOrNone) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    const auto contacts = m_tracker->next(press(0.003), kPeriod_s); // 3 mm at once
    ASSERT_TRUE(contacts);
    const Eigen::Vector3d truth_m(0.025 * std::cos(1.0), 0.025 * std::sin(1.0), 0.04);
    for (const FollowedContact& followed : *contacts)
        EXPECT_LT((followed.contact.p_Sensor_Centre_m - truth_m).norm(), 0.01);
    EXPECT_FALSE(contacts->empty());
    // Nothing remains of it when it is gone.
    for (int i = 2; i < 6; ++i)
        (void)m_tracker->next(m_rest, i * kPeriod_s);
    const auto after = m_tracker->next(m_rest, 6 * kPeriod_s);
    ASSERT_TRUE(after);
    EXPECT_TRUE(after->empty());
}

TEST_F(HardFrames, thatComeAfterALongGapShowNewContacts) {
    ASSERT_TRUE(m_tracker->next(m_rest, 0.0));
    for (int i = 1; i <= 4; ++i)
        ASSERT_TRUE(m_tracker->next(press(0.0003 * i), i * kPeriod_s));
    const auto before = m_tracker->next(press(0.0012), 5 * kPeriod_s);
    const auto after = m_tracker->next(press(0.0012), 10.0);
    ASSERT_TRUE(before && after && before->size() == 1);
    ASSERT_EQ(after->size(), 2U);
    EXPECT_EQ(after->front().contact.id, before->front().contact.id);
    EXPECT_EQ(after->front().event, ContactEvent::ends) << "nobody knows what became of it";
    EXPECT_EQ(after->back().event, ContactEvent::begins);
    const auto later = m_tracker->next(press(0.0012), 10.0 + kPeriod_s);
    ASSERT_TRUE(later && later->size() == 1);
    EXPECT_EQ(later->front().contact.id, after->back().contact.id);
}

TEST(CameraTracker, givesTheReferenceOnlyToAFinderThatHasNotTakenItYet) {
    const auto finder = [] { return std::make_unique<CountingFinder>(); };
    CameraTracker tracker(finder(), {});
    EXPECT_TRUE(tracker.reference().empty());
    ASSERT_TRUE(tracker.next(cv::Mat1b(4, 4, std::uint8_t{1}), 0.0));
    const cv::Mat1b reference = tracker.reference();
    ASSERT_FALSE(reference.empty());
    auto prepared = finder();
    ASSERT_TRUE(prepared->setReference(reference));
    const int& references = prepared->m_references;
    ASSERT_TRUE(tracker.changeFinder(std::move(prepared), reference));
    EXPECT_EQ(references, 1);
    // The previous reference is no longer valid.
    tracker.renewReference();
    EXPECT_TRUE(tracker.reference().empty());
    ASSERT_TRUE(tracker.next(cv::Mat1b(4, 4, std::uint8_t{2}), 0.1));
    auto late = finder();
    ASSERT_TRUE(late->setReference(reference));
    const int& lateReferences = late->m_references;
    ASSERT_TRUE(tracker.changeFinder(std::move(late), reference));
    EXPECT_EQ(lateReferences, 2);
}

TEST_F(HardFrames, asReferenceAreRefusedUntilAGoodOneComes) {
    EXPECT_FALSE(m_tracker->next(cv::Mat1b(), 0.0));
    EXPECT_FALSE(m_tracker->next(cv::Mat1b(m_rest.size(), std::uint8_t{77}), kPeriod_s));
    EXPECT_FALSE(m_tracker->hasReference());
    EXPECT_TRUE(m_tracker->next(m_rest, 2 * kPeriod_s));
    EXPECT_TRUE(m_tracker->hasReference());
}

} // namespace teleta::vision
