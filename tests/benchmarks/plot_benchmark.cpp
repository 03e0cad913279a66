// SPDX-License-Identifier: GPL-3.0-or-later
// One redraw of a plot of 10 million samples, 1200 pixels wide, while it scrolls: our series with its
// pyramid, against QCustomPlot's own adaptive sampling of all samples, in the same process. The two must show
// the same extremes.
//   plot_benchmark [SAMPLES]
#include "widgets/base/theme.h"
#include "widgets/signal/signal_plot.h"

#include <QApplication>
#include <qcustomplot.h>
#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

using namespace teleta;

namespace {

constexpr double kPeriod_s = 1e-3;
constexpr int kRedraws = 20;

struct Times {
    double median_ms = 0.0, longest_ms = 0.0;
};

/// step: draws the picture of a number.
template <typename Step>
Times timed(Step step) {
    std::vector<double> times_ms;
    for (int i = 0; i < kRedraws; ++i) {
        QElapsedTimer timer;
        timer.start();
        step(i);
        times_ms.push_back(1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    std::ranges::sort(times_ms);
    return {times_ms[kRedraws / 2], times_ms.back()};
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    base::applyTheme(base::ThemeChoice::light);
    const int samples = argc > 1 ? std::atoi(argv[1]) : 10'000'000;
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.05);
    auto series = std::make_shared<signal::Series>();
    QVector<QCPGraphData> all(samples);
    QElapsedTimer timer;
    double append_ms = 0.0;
    for (int i = 0; i < samples; ++i)
        all[i] = QCPGraphData(kPeriod_s * i, std::sin(1e-5 * i) + noise(random));
    timer.start();
    for (const QCPGraphData& each : all)
        series->append(each.key, each.value);
    append_ms = 1e-6 * static_cast<double>(timer.nsecsElapsed());
    const double end_s = kPeriod_s * samples;

    signal::SignalPlot ours;
    ours.resize(1200, 600);
    ours.setCurves({{"noise", "N", 1, series, nullptr, false}});
    ours.show();
    QCustomPlot theirs;
    theirs.resize(1200, 600);
    QCPGraph* graph = theirs.addGraph();
    // The same strokes, so that the ways to choose what is drawn are compared.
    graph->setPen(QPen(Qt::blue, 1.0));
    graph->setAntialiased(false);
    theirs.setPlottingHint(QCP::phFastPolylines);
    graph->data()->set(all, true);
    graph->rescaleValueAxis();
    theirs.show();
    QCoreApplication::processEvents();

    std::printf("%d samples, 1200 x 600 pixels; appending: %.0f ns a sample\n", samples,
                1e6 * append_ms / samples);
    for (const double share : {1.0, 0.1, 0.001}) {
        const double span_s = share * end_s;
        // It scrolls by 33 ms of data a picture.
        const Times our = timed([&](int i) {
            const double to_s = end_s - 0.033 * (kRedraws - i);
            ours.setRange(to_s - span_s, to_s);
            ours.refresh();
            ours.plot()->replot(QCustomPlot::rpImmediateRefresh);
        });
        const Times their = timed([&](int i) {
            const double to_s = end_s - 0.033 * (kRedraws - i);
            theirs.xAxis->setRange(to_s - span_s, to_s);
            theirs.replot(QCustomPlot::rpImmediateRefresh);
        });
        std::printf("%5.1f %% in view: ours %.2f ms (longest %.2f), QCustomPlot's adaptive sampling %.2f ms "
                    "(longest %.2f), "
                    "ratio %.1f\n",
                    100.0 * share, our.median_ms, our.longest_ms, their.median_ms, their.longest_ms,
                    their.median_ms / our.median_ms);
    }
    // What ours draws of everything has the extremes of all samples.
    ours.showEverything();
    ours.refresh();
    bool found = false;
    const QCPRange drawn = ours.plot()->graph(0)->data()->valueRange(found);
    const auto [low, high] = std::ranges::minmax_element(all, {}, &QCPGraphData::value);
    const bool same = found && drawn.lower == low->value && drawn.upper == high->value;
    std::printf("the same extremes: %s\n", same ? "yes" : "no");
    return same ? 0 : 1;
}
