// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/scene_camera.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace teleta::view3d {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

/// A stick that hangs from 1 m and points down or aside, as the forearm of an arm.
Corners stick(double angle_rad) {
    const Eigen::Vector3d top(0.0, 0.0, 1.0);
    return {
        {0.0, 0.0, 0.0}, top, top + 0.6 * Eigen::Vector3d(std::sin(angle_rad), 0.0, -std::cos(angle_rad))};
}

/// The farthest corner from the middle of the picture; 1 is its rim.
double farthest(vtkRenderer* renderer, const Corners& corners) {
    vtkMatrix4x4* matrix = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0);
    double most = 0.0;
    for (const Eigen::Vector3d& corner : corners) {
        const double world[4] = {corner.x(), corner.y(), corner.z(), 1.0};
        double view[4];
        matrix->MultiplyPoint(world, view);
        most = std::max({most, std::abs(view[0] / view[3]), std::abs(view[1] / view[3])});
    }
    return most;
}

} // namespace

TEST(SceneCamera, aSubjectFillsThePictureInsteadOfAll) {
    const vtkNew<vtkRenderer> renderer;
    SceneCamera camera(renderer);
    camera.setScene(stick(0.5), true);
    const double all_m = camera.visibleHeight_m();
    const Eigen::AlignedBox3d handBox(Eigen::Vector3d(0.1, 0.1, 0.4), Eigen::Vector3d(0.2, 0.2, 0.5));
    const Corners hand = cornersOf(handBox);
    camera.setSubject(handBox);
    const double near_m = camera.visibleHeight_m();
    EXPECT_LT(near_m, 0.5 * all_m);
    EXPECT_GT(farthest(renderer, hand), 0.6);
    EXPECT_LT(farthest(renderer, hand), 0.9);
    // It stays in the picture as it moves, and so does the rest behind it.
    const Eigen::AlignedBox3d movedBox(Eigen::Vector3d(0.1, 0.1, 0.6), Eigen::Vector3d(0.2, 0.2, 0.7));
    const Corners moved = cornersOf(movedBox);
    camera.setSubject(movedBox);
    EXPECT_LE(farthest(renderer, moved), 0.98);
    double range_m[2];
    renderer->GetActiveCamera()->GetClippingRange(range_m);
    EXPECT_GT(range_m[1], (Eigen::Vector3d(0.15, 0.15, 0.55)).norm()); // the base of the stick is behind it
    camera.zoom(3.0);
    camera.look(CameraPreset::isometric);
    EXPECT_GT(farthest(renderer, moved), 0.6);
    camera.setSubject(Eigen::AlignedBox3d());
    EXPECT_NEAR(camera.visibleHeight_m(), all_m, 1e-9);
}

TEST(SceneCamera, whatMovesStaysInThePicture) {
    for (const bool parallel : {false, true}) {
        const vtkNew<vtkRenderer> renderer;
        SceneCamera camera(renderer);
        camera.setParallel(parallel);
        camera.setScene(stick(0.0), true);
        EXPECT_LT(farthest(renderer, stick(0.0)), 0.9);
        const double before_m = camera.visibleHeight_m();
        for (double angle_rad = 0.0; angle_rad < 6.2; angle_rad += 0.05) {
            camera.setScene(stick(angle_rad), false);
            EXPECT_LE(farthest(renderer, stick(angle_rad)), 0.98) << angle_rad << parallel;
        }
        const double after_m = camera.visibleHeight_m();
        EXPECT_GT(after_m, before_m);
        // It does not come back, and does not go on.
        for (double angle_rad = 0.0; angle_rad < 6.2; angle_rad += 0.05)
            camera.setScene(stick(angle_rad), false);
        EXPECT_EQ(camera.visibleHeight_m(), after_m);
        camera.setScene(stick(0.0), true);
        EXPECT_NEAR(camera.visibleHeight_m(), before_m, 1e-9);
    }
}

TEST(SceneCamera, thePersonsOwnViewIsLeftAlone) {
    const vtkNew<vtkRenderer> renderer;
    SceneCamera camera(renderer);
    camera.setScene(stick(0.0), true);
    camera.zoom(3.0);
    const double height_m = camera.visibleHeight_m();
    camera.setScene(stick(2.0), false);
    camera.setScene(stick(3.0), true);
    EXPECT_EQ(camera.visibleHeight_m(), height_m);
}

TEST(SceneCamera, onTheHandThePictureOfWhatItCarriesStaysTheSame) {
    const vtkNew<vtkRenderer> renderer;
    SceneCamera camera(renderer);
    camera.setScene(stick(0.0), true);
    const double before_m = camera.visibleHeight_m();
    const Corners carried = {{0.02, 0.0, 0.0}, {0.0, 0.01, 0.0}, {-0.02, -0.01, 0.005}};
    const auto pictureAt = [&](const Eigen::Isometry3d& hand) {
        camera.standOnHand(hand, 0.025);
        vtkMatrix4x4* matrix =
            renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0);
        std::vector<double> picture;
        for (const Eigen::Vector3d& corner : carried) {
            const Eigen::Vector3d p = hand * corner;
            const double world[4] = {p.x(), p.y(), p.z(), 1.0};
            double view[4];
            matrix->MultiplyPoint(world, view);
            picture.insert(picture.end(), {view[0] / view[3], view[1] / view[3]});
        }
        return picture;
    };
    const auto expectSame = [](const std::vector<double>& a, const std::vector<double>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_NEAR(a[i], b[i], 1e-9) << i;
    };
    // Pressed down onto a table: up in the picture is up, and what it carries is seen from its back.
    Eigen::Isometry3d hand(Eigen::AngleAxisd(3.14159265358979323846, Eigen::Vector3d::UnitX()));
    hand.translation() = Eigen::Vector3d(0.3, -0.2, 0.4);
    const auto first = pictureAt(hand);
    EXPECT_GT(camera.up().z(), 0.5);
    EXPECT_GT(Eigen::Vector3d(renderer->GetActiveCamera()->GetPosition()).z(), 0.4);
    EXPECT_LT(farthest(renderer, {hand * carried[0], hand * carried[1], hand * carried[2]}), 0.6);
    const Eigen::Isometry3d elsewhere = Eigen::Translation3d(-0.5, 0.7, 0.1) *
                                        Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.8, 0.2).normalized()) *
                                        hand;
    expectSame(pictureAt(elsewhere), first);
    // As the person turned it, too; the contact that is followed elsewhere does not pull it away.
    camera.turn(0.4, -0.1);
    camera.follow(Eigen::Vector3d::Zero(), 1.0);
    expectSame(pictureAt(hand), pictureAt(elsewhere));

    Eigen::Isometry3d unknown = hand;
    unknown.translation().x() = NAN;
    const Eigen::Vector3d place(renderer->GetActiveCamera()->GetPosition());
    camera.standOnHand(unknown, 0.025);
    EXPECT_EQ(Eigen::Vector3d(renderer->GetActiveCamera()->GetPosition()), place);
    camera.look(CameraPreset::isometric);
    EXPECT_FALSE(camera.isOnHand());
    EXPECT_NEAR(camera.visibleHeight_m(), before_m, 1e-9);
}

} // namespace teleta::view3d
