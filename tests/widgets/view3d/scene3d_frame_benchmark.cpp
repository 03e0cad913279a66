// SPDX-License-Identifier: GPL-3.0-or-later
// Time of a frame of the 3-D view with OpenGL, from new joints to the last pixel: an arm with a skin in
// motion, with the trail of its tip, the dial of a joint near its limit, and the force that the joints tell,
// against the same without these, and with a skin of 100 taxels off a grid, whose discs are drawn as cells;
// longest_ms is the slowest frame. Run it under Xvfb with
// LIBGL_ALWAYS_SOFTWARE=1. CPU is of all threads, the driver's among them.
#include "backend/core/steady_time.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/guest_render_window.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QTest>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

using namespace teleta;

namespace {

constexpr core::ArrayLayout kSkin{.rows = 20, .columns = 24, .pitchX_m = 0.0094};

constexpr core::ArrayLayout kRows{.rows = 10, .columns = 10, .pitchX_m = 0.018};

/// These, every other row moved by half a pitch.
core::TaxelLayout shiftedRows() {
    std::vector<core::TaxelPlace> places;
    for (int row = 0; row < kRows.rows; ++row)
        for (int column = 0; column < kRows.columns; ++column)
            places.push_back({kRows.x_m(column + 0.5 * (row % 2)), kRows.y_m(row)});
    return core::TaxelLayout(std::make_shared<const core::TaxelPlaces>(std::move(places)));
}

/// A step of 1/30 s: the arm turns, and is touched.
void step(view3d::Scene3dView& view, std::uint64_t frame, const core::TaxelLayout& skin) {
    const double time_s = static_cast<double>(frame) / 30.0;
    const double turn = 0.5 * std::sin(time_s);
    std::array<view3d::ArmLink, 2> links;
    links[0].X_World_Link.rotate(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()));
    links[0].length_m = 0.30;
    links[0].radius_m = 0.03;
    links[1].X_World_Link = links[0].X_World_Link * Eigen::Translation3d(0.30, 0, 0) *
                            Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ());
    links[1].length_m = 0.27;
    links[1].radius_m = 0.03;
    view.setArmLinks(links);
    view.setSensorPose(links[1].X_World_Link * Eigen::Translation3d(0.135, 0, 0));
    view.setTip(links[1].X_World_Link * Eigen::Vector3d(0.27, 0, 0), time_s);
    const view3d::JointDial elbow{QStringLiteral("elbow"),
                                  view3d::frameAround(links[1].X_World_Link.translation(),
                                                      Eigen::Vector3d::UnitZ(),
                                                      links[0].X_World_Link.linear().col(0)),
                                  2.5 + 0.01 * turn,
                                  -0.2,
                                  2.6,
                                  0.03};
    view.setJoints(std::array{elbow});
    view.setForce(
        view3d::DrawnForce{links[1].X_World_Link * Eigen::Vector3d(0.135, 0, 0.03), {0.0, 0.0, -1.0}});
    pipeline::TouchSnapshot snapshot =
        test::pressed(skin.isGrid() ? kSkin : kRows, {{1, 0.01 * turn, 0.0, 1.0, 0.02}}, frame);
    snapshot.layout = skin;
    view.setSnapshot(snapshot);
}

void frames(benchmark::State& state, const QStringList& hidden, const core::TaxelLayout& skin = kSkin) {
    view3d::Scene3dView view;
    auto* vtk = view.findChild<view3d::VtkWidget*>();
    vtk->setFixedSize(640, 480);
    view.setSurface(view3d::Surface::cylinder);
    view.setCylinder({.radius_m = 0.03, .length_m = 0.226});
    view.setHiddenLayers(hidden);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) {
        state.SkipWithError("no window");
        return;
    }
    std::uint64_t frame = 0;
    for (int i = 0; i < 200; ++i) // the trail is whole
        step(view, ++frame, skin);
    (void)vtk->picture(1.0, view3d::VtkWidget::PictureOverlay::without);
    auto* window = static_cast<view3d::GuestRenderWindow*>(vtk->renderWindow());
    window->SetMultiSamples(0);
    window->setQuality(view3d::FrameQuality::Level::plain);
    window->renderGuarded();
    double longest_ms = 0.0;
    for (auto _ : state) {
        const auto begun_ns = core::steadyNow_ns();
        step(view, ++frame, skin);
        window->renderGuarded();
        window->WaitForCompletion();
        longest_ms = std::max(longest_ms, 1e-6 * static_cast<double>(core::steadyNow_ns() - begun_ns));
    }
    state.counters["longest_ms"] = longest_ms;
}

void withMarks(benchmark::State& state) {
    frames(state, {});
}
void withoutMarks(benchmark::State& state) {
    frames(state, {"trail", "jointLimits", "moments"});
}

void offTheGrid(benchmark::State& state) {
    frames(state, {}, shiftedRows());
}

BENCHMARK(withoutMarks)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(withMarks)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(offTheGrid)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    base::applyTheme(base::ThemeChoice::dark);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
