// SPDX-License-Identifier: GPL-3.0-or-later
// Saves pictures of the 3-D view for a person to look at: view3d_pictures FOLDER
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QDir>
#include <QTest>

#include <numbers>

using namespace teleta;
using view3d::Scene3dView;

namespace {

std::vector<Eigen::Vector3d> circle(int count, double radius_m, bool closed) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count + (closed ? 1 : 0); ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        points.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.03);
    }
    return points;
}

void save(Scene3dView& view, const QDir& folder, const QString& name) {
    QTest::qWait(50);
    view.grab().save(folder.filePath(name + QStringLiteral(".png")));
}

} // namespace

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("."));
    for (const bool dark : {false, true}) {
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        const QString theme = dark ? QStringLiteral("dark-") : QStringLiteral("light-");
        Scene3dView view;
        view.resize(720, 540);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) {
            return 1;
        }
        save(view, folder, theme + QStringLiteral("empty"));
        view.setProvenance(base::Provenance::simulated);
        const core::ArrayLayout small;
        auto snapshot = test::pressed(small, {{1, -0.008, 0.002, 1.0}, {2, 0.013, -0.003, 0.6}}, 1);
        view.setSnapshot(snapshot);
        snapshot = test::pressed(small, {{1, -0.012, 0.001, 1.2}, {2, 0.011, 0.002, 0.6}}, 2);
        snapshot.dead[40] = snapshot.dead[12] = 1;
        view.setSnapshot(snapshot);
        save(view, folder, theme + QStringLiteral("plate"));
        for (const auto& [preset, name] : {std::pair(view3d::CameraPreset::front, "front"),
                                           {view3d::CameraPreset::top, "top"},
                                           {view3d::CameraPreset::side, "side"}}) {
            view.look(preset);
            save(view, folder, theme + QLatin1String(name));
        }
        view.resetView();
        view.setSurface(view3d::Surface::cylinder);
        save(view, folder, theme + QStringLiteral("cylinder"));
        const core::ArrayLayout mat{.rows = 27, .columns = 64, .pitchX_m = 0.0034};
        view.setProvenance(base::Provenance::recorded);
        view.setSurface(view3d::Surface::plate);
        view.setSnapshot(test::pressed(mat,
                                       {{1, -0.05, 0.01, 2.0, 0.012},
                                        {2, 0.04, -0.02, 1.2, 0.015},
                                        {3, 0.07, 0.03, 0.7, 0.01},
                                        {4, -0.08, -0.03, 0.5, 0.008}},
                                       3));
        save(view, folder, theme + QStringLiteral("mat"));
        view.setSurface(view3d::Surface::cylinder);
        save(view, folder, theme + QStringLiteral("mat-cylinder"));
        view.clear();
        view.setProvenance(base::Provenance::live);
        view.setContour(circle(16, 0.04, false), circle(96, 0.04, true), {}, QStringLiteral("circle, 97 %"));
        save(view, folder, theme + QStringLiteral("contour"));
        std::vector<view3d::ArmLink> links(2);
        links[0].X_World_Link.rotate(Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()));
        links[0].X_World_Link.pretranslate(Eigen::Vector3d(-0.4, 0, 0.05));
        links[0].length_m = 0.25;
        links[0].radius_m = 0.02;
        links[1].X_World_Link = links[0].X_World_Link * Eigen::Translation3d(0.25, 0, 0) *
                                Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitY());
        links[1].length_m = 0.18;
        links[1].radius_m = 0.016;
        view.setArmLinks(links);
        Eigen::Isometry3d pose = links[1].X_World_Link;
        pose.translate(Eigen::Vector3d(0.14, 0, 0.018));
        view.setSensorPose(pose);
        view.setSurface(view3d::Surface::plate);
        view.setSnapshot(snapshot);
        save(view, folder, theme + QStringLiteral("arm"));
        view.resize(300, 220);
        save(view, folder, theme + QStringLiteral("small"));
    }
    return 0;
}
