// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "tests/backend/motors/measured_motor.h"
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/touch/sample_arm.h"
#include "tests/widgets/touch/sample_records.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/felt_panel.h"
#include "widgets/calibrate/motors_view.h"
#include "widgets/charts/joint_chart_view.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/pattern/law_list.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/timeline/timeline_view.h"
#include "widgets/tactile/heatmap_view.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/pattern_map_table.h"
#include "widgets/touch/stiffness_gauge.h"
#include "widgets/touch/touch_table.h"

#include <QApplication>
#include <QDir>
#include <QPainter>
#include <QPushButton>
#include <QTextStream>

#include <cmath>
#include <functional>
#include <memory>

using namespace teleta;

namespace {

struct Exhibit {
    QString name;
    QSize size;
    std::function<std::unique_ptr<QWidget>()> make;
};

std::unique_ptr<QWidget> heatmap(const pipeline::TouchSnapshot& snapshot, base::Provenance provenance,
                                 bool values) {
    auto view = std::make_unique<tactile::HeatmapView>();
    view->setProvenance(provenance);
    view->setSnapshot(snapshot);
    view->overlayAction(tactile::HeatmapView::Overlay::values)->setChecked(values);
    return view;
}

pipeline::TouchSnapshot smallArray() {
    const core::ArrayLayout layout{6, 14, 0.0034};
    std::vector<std::uint8_t> dead(layout.taxels(), 0);
    dead[3] = dead[40] = 1;
    return test::snapshotOf(
        layout, test::hills(layout, {{-0.012, 0.001, 1.6, 0.006, 0.0025, 0.6}, {0.015, -0.003, 0.9}}), dead);
}

pipeline::TouchSnapshot largeArray() {
    const core::ArrayLayout layout{27, 64, 0.0025};
    std::vector<std::uint8_t> dead(layout.taxels(), 0);
    for (const std::size_t i : {700U, 701U, 1300U})
        dead[i] = 1;
    return test::snapshotOf(layout,
                            test::hills(layout, {{-0.05, 0.01, 3.0, 0.02, 0.006, -0.4},
                                                 {0.02, -0.01, 1.5, 0.008, 0.008},
                                                 {0.04, 0.018, 2.1, 0.005, 0.01},
                                                 {0.065, -0.02, 0.9}}),
                            dead);
}

std::unique_ptr<charts::StripChartView> charts(bool all) {
    auto view = std::make_unique<charts::StripChartView>();
    view->setLoadUnit(QStringLiteral("N"));
    for (const charts::Strip strip : charts::kAllStrips)
        if (all)
            view->stripAction(strip)->setChecked(true);
    for (int i = 0; i < 3000; ++i) {
        const double time_s = 0.005 * i;
        if (time_s > 9.0 && time_s < 9.4)
            continue; // lost
        pipeline::FeatureSample sample = test::rollingSample(time_s, time_s < 11.0 || time_s > 12.0);
        sample.discontinuity = i == 1500;
        view->append(sample);
    }
    view->addMark(8.0, QStringLiteral("bump"));
    view->refresh();
    return view;
}

std::unique_ptr<QWidget> pausedCharts() {
    auto view = charts(false);
    view->setProvenance(base::Provenance::simulated);
    view->setPaused(true);
    view->scrollBy(-2.0);
    view->setCursorTime(-3.0);
    return view;
}

std::unique_ptr<QWidget> gauge(const std::optional<stiffness::TouchStiffness>& touch) {
    auto view = std::make_unique<touch::StiffnessGauge>();
    view->setProvenance(base::Provenance::simulated);
    view->setTouch(touch);
    return view;
}

std::unique_ptr<QWidget> refusedGauge() {
    auto view = std::make_unique<touch::StiffnessGauge>();
    view->setRefusal(stiffness::Refusal::windowNotReached);
    return view;
}

std::unique_ptr<QWidget> touches(bool some) {
    auto view = std::make_unique<touch::TouchTable>();
    view->setProvenance(base::Provenance::simulated);
    if (!some)
        return view;
    view->append(test::recordOf(1, test::estimateOf(282.0, 270.0, 295.0)));
    view->append(test::recordOf(2, test::estimateOf(1325.9, 1290.0, 1360.0)));
    view->append(test::recordOf(3, test::estimateOf(7223.9, 6100.0, 9300.0)));
    view->append(test::recordOf(4, test::boundOf(21000.0)));
    pipeline::TouchRecord light = test::recordOf(5, std::nullopt);
    light.refusal = stiffness::Refusal::windowNotReached;
    view->append(light);
    pipeline::TouchRecord unfelt = test::recordOf(6, std::nullopt);
    unfelt.located = false;
    unfelt.force.reset();
    view->append(unfelt);
    view->select(3);
    return view;
}

std::unique_ptr<QWidget> jog(std::optional<core::ArmDrive> drive) {
    auto view = std::make_unique<touch::JogPanel>();
    if (!drive)
        return view;
    view->setArm(test::sampleArm());
    core::JointSample sample;
    sample.angle_rad = {0.21, -0.62, 1.996, 1.2};
    view->setSample(sample);
    view->setDrive(*drive);
    view->setStopEngaged(*drive == core::ArmDrive::stopped);
    return view;
}

std::unique_ptr<QWidget> joints(bool angles) {
    auto view = std::make_unique<charts::JointChartView>();
    view->setProvenance(base::Provenance::simulated);
    view->findChild<QAction*>("angles")->setChecked(angles);
    std::vector<core::JointSample> samples;
    for (int i = 0; i < 10000; ++i) {
        const double time_s = 0.001 * i;
        const double phase_s = std::fmod(time_s, 2.5);
        const double press = phase_s < 1.0   ? 0.0
                             : phase_s < 1.6 ? (phase_s - 1.0) / 0.6
                             : phase_s < 2.0 ? 1.0
                                             : 0.0;
        core::JointSample sample;
        sample.time_ns = i * 1'000'000LL;
        sample.sourceTime_s = time_s;
        const double noise = 0.0006 * std::sin(1234.5 * i);
        sample.torque_Nm = {noise, 0.012 * press + noise, -0.006 * press - noise, 0.062 * press + noise};
        sample.angle_rad = {0.2, -0.3 + 0.01 * press, 0.1, 1.1 + 0.05 * std::sin(time_s)};
        samples.push_back(sample);
    }
    view->append(samples);
    for (int touch = 0; touch < 4; ++touch) {
        pipeline::TouchRecord record;
        record.number = static_cast<std::uint64_t>(touch + 1);
        record.start_s = 2.5 * touch + 1.02;
        record.ready_s = 2.5 * touch + 1.5;
        view->addTouch(record);
    }
    view->refresh();
    return view;
}

std::unique_ptr<QWidget> patternMap() {
    auto view = std::make_unique<touch::PatternMapTable>();
    std::vector<touch::PatternChoice> choices;
    for (const QString& task : {QStringLiteral("stiffness"), QStringLiteral("shape")})
        for (const char letter : {'A', 'B', 'C', 'D', 'E', 'F'})
            choices.push_back({(task + u'.' + QLatin1Char(letter) + QStringLiteral(".dynamic")).toStdString(),
                               task + u' ' + QLatin1Char(letter), task, QStringLiteral("dynamic")});
    view->setChoices(choices);
    view->setRecognisedStiffness(3);
    return view;
}

/// Breakpoints with every curve, objects with a broken law, a stroke.
std::unique_ptr<QWidget> patternEditor() {
    auto view = std::make_unique<pattern::PatternEditor>();
    pattern::Pattern pattern = *pattern::findBuiltIn("stiffness.C.dynamic");
    pattern.id = "mine.example";
    pattern.name = "Rubber, then a stroke";
    pattern.duration_s = 4.0;
    pattern.tracks[1] = {{0.2, 0.0, pattern::Easing::easeInOut},
                         {0.7, 0.9, pattern::Easing::easeInOut},
                         {1.2, 0.0, pattern::Easing::hold},
                         {1.5, 0.6},
                         {1.9, 0.6}};
    pattern.objects.push_back({"", pattern::Ring{.start_s = 2.0, .duration_s = 1.0, .burst_s = {}}, {}});
    pattern::Stroke stroke{.start_s = 3.1, .points = {}};
    for (int i = 0; i <= 20; ++i)
        stroke.points.push_back({0.04 * i, 0.25 * i, 0.5 + 0.5 * std::sin(0.4 * i)});
    pattern.objects.push_back({"", stroke, {}});
    view->document()->setPattern(pattern);
    view->document()->select({{}, 0});
    view->setPlayhead(0.9);
    view->findChild<pattern::LawList*>()->check();
    return view;
}

/// Four of six motors are measured, one of them fails.
std::unique_ptr<QWidget> motorsView(bool asking) {
    auto view = std::make_unique<calibrate::MotorsView>();
    motors::MotorCalibration assumed;
    assumed.bracelet = "simulated";
    view->setCalibration(assumed);
    view->setFacts({.name = QStringLiteral("Simulated bracelet"),
                    .serial = QStringLiteral("simulated"),
                    .ready = true,
                    .simulated = true,
                    .hasSensor = true,
                    .speeds_Hz = core::Intensities{}});
    const simulated::SimulatedMotors kinds = simulated::unequalMotors();
    for (const std::size_t motor : {0U, 1U, 3U, 2U}) {
        const motors::MotorRecording recording = test::measured(kinds[motor], 1.5, motor + 1);
        view->takeFit(motor, recording, motors::fitMotor(recording));
    }
    if (asking) {
        view->findChild<QPushButton*>("feel")->click();
        view->findChild<QPushButton*>("play")->click();
    }
    return view;
}

std::vector<Exhibit> exhibits() {
    return {
        {QStringLiteral("motors"), QSize(1440, 820), [] { return motorsView(false); }},
        {QStringLiteral("motors_asking"), QSize(1200, 760), [] { return motorsView(true); }},
        {QStringLiteral("pattern_editor"), QSize(1440, 860), patternEditor},
        {QStringLiteral("gauge"), QSize(400, 220),
         [] { return gauge(test::estimateOf(1325.9, 1290.0, 1360.0)); }},
        {QStringLiteral("gauge_bound"), QSize(400, 220), [] { return gauge(test::boundOf(21000.0)); }},
        {QStringLiteral("gauge_wide"), QSize(560, 320),
         [] { return gauge(test::estimateOf(7223.9, 5100.0, 12300.0)); }},
        {QStringLiteral("gauge_small"), QSize(290, 190),
         [] { return gauge(test::estimateOf(9000.0, 5000.0, std::nullopt)); }},
        {QStringLiteral("gauge_empty"), QSize(400, 220), [] { return gauge(std::nullopt); }},
        {QStringLiteral("gauge_refused"), QSize(400, 220), refusedGauge},
        {QStringLiteral("jog"), QSize(520, 330), [] { return jog(core::ArmDrive::program); }},
        {QStringLiteral("jog_stopped"), QSize(400, 330), [] { return jog(core::ArmDrive::stopped); }},
        {QStringLiteral("jog_none"), QSize(400, 330), [] { return jog(std::nullopt); }},
        {QStringLiteral("joints"), QSize(820, 260), [] { return joints(false); }},
        {QStringLiteral("joints_angles"), QSize(820, 420), [] { return joints(true); }},
        {QStringLiteral("joints_empty"), QSize(560, 260),
         [] { return std::make_unique<charts::JointChartView>(); }},
        {QStringLiteral("pattern_map"), QSize(560, 480), patternMap},
        {QStringLiteral("touches"), QSize(1120, 240), [] { return touches(true); }},
        {QStringLiteral("touches_empty"), QSize(700, 160), [] { return touches(false); }},
        {QStringLiteral("charts"), QSize(820, 560), [] { return charts(false); }},
        {QStringLiteral("charts_all"), QSize(820, 760), [] { return charts(true); }},
        {QStringLiteral("charts_paused"), QSize(560, 440), pausedCharts},
        {QStringLiteral("heatmap_small"), QSize(760, 460),
         [] { return heatmap(smallArray(), base::Provenance::simulated, true); }},
        {QStringLiteral("heatmap_small_narrow"), QSize(420, 260),
         [] { return heatmap(smallArray(), base::Provenance::recorded, false); }},
        {QStringLiteral("heatmap_large"), QSize(900, 520),
         [] { return heatmap(largeArray(), base::Provenance::live, false); }},
        {QStringLiteral("heatmap_large_small"), QSize(460, 300),
         [] { return heatmap(largeArray(), base::Provenance::simulated, false); }},
    };
}

} // namespace

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        QTextStream(stderr) << "usage: widget_gallery FOLDER [NAME..]\n";
        return 2;
    }
    const QDir folder(arguments.at(1));
    if (!folder.mkpath(QStringLiteral(".")))
        return 1;
    for (const bool dark : {false, true}) {
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        for (const Exhibit& exhibit : exhibits()) {
            if (arguments.size() > 2 && !arguments.mid(2).contains(exhibit.name))
                continue;
            const std::unique_ptr<QWidget> widget = exhibit.make();
            widget->resize(exhibit.size);
            widget->show();
            QApplication::processEvents();
            const QString file =
                exhibit.name + (dark ? QStringLiteral("_dark.png") : QStringLiteral("_light.png"));
            if (!widget->grab().save(folder.filePath(file)))
                return 1;
        }
    }
    return 0;
}
