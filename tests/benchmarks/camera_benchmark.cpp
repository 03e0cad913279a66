// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a camera in a soft tube: each rung of the ladder against the paper's pipeline (resize to 512 x
// 288, dense inverse search of medium quality against the reference, maximum filter, threshold, contours), on
// the same rendered frames of 1640 x 1232 and on one core; the dots also on two cores. read_every_pixel adds
// up all pixels of these frames: the least that a method takes which looks at all of them. Counters: frames
// per second, mean distance from the true contact in mm, missed contacts, time of each stage in ms.
#include "backend/core/random_stream.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/finders/contact_ladder.h"
#include "tests/backend/simulation/camera/camera_scene.h"

#include <benchmark/benchmark.h>
#include <opencv2/core/utility.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace teleta;

struct Frame {
    cv::Mat1b image;
    Eigen::Vector3d truth_m;
    bool pressed = false; ///< to its depth: it is compared
    bool first = false;   ///< of a contact
};

struct Frames {
    std::unique_ptr<simulation::SimulatedTube> tube;
    cv::Mat1b reference;
    std::vector<Frame> frames;
};

const Frames& frames() {
    static const Frames made = [] {
        constexpr int kContacts = 12;
        constexpr int kSteps = 5;
        Frames result;
        result.tube = std::move(*simulation::SimulatedTube::make(test::cameraScene(), 1));
        result.tube->untouched(result.reference);
        core::RandomStream random(9, "benchmark");
        for (int i = 0; i < kContacts; ++i) {
            simulation::SkinPress press;
            press.centre = {2.0 * std::numbers::pi * random.uniform(), 0.005 + 0.09 * (i + 0.5) / kContacts};
            press.ballRadius_m = 0.008 + 0.006 * random.uniform();
            for (int step = 1; step <= kSteps; ++step) {
                press.depth_m = 0.0012 * step / kSteps;
                Frame frame;
                result.tube->pressed({press}, frame.image);
                frame.truth_m = {0.025 * std::cos(press.centre.angle_rad),
                                 0.025 * std::sin(press.centre.angle_rad), press.centre.z_m};
                frame.first = step == 1;
                frame.pressed = step == kSteps;
                result.frames.push_back(std::move(frame));
            }
        }
        return result;
    }();
    return made;
}

void findContacts(benchmark::State& state, const std::string& name, int cores) {
    cv::setNumThreads(cores);
    auto finder =
        vision::makeContactFinder(*vision::contactRung(name), frames().tube->camera(), {.cores = cores});
    if (!finder || !(*finder)->setReference(frames().reference)) {
        state.SkipWithError("the rung does not take the camera");
        return;
    }
    std::array<double, vision::kFinderStages> stages_ms{};
    double sum_m = 0.0;
    int compared = 0;
    int missed = 0;
    std::size_t i = 0;
    for (auto _ : state) {
        const Frame& frame = frames().frames[i];
        i = (i + 1) % frames().frames.size();
        if (frame.first)
            (*finder)->forget();
        const auto found = (*finder)->find(frame.image);
        benchmark::DoNotOptimize(found);
        for (std::size_t stage = 0; stage < stages_ms.size(); ++stage)
            stages_ms[stage] += static_cast<double>((*finder)->stageTimes_ns()[stage]) * 1e-6;
        if (!frame.pressed)
            continue;
        if (!found || found->empty()) {
            ++missed;
            continue;
        }
        sum_m += (found->front().p_Sensor_Centre_m - frame.truth_m).norm();
        ++compared;
    }
    state.counters["fps"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    constexpr std::array kStages{"prepare_ms", "displace_ms", "segment_ms", "locate_ms"};
    for (std::size_t stage = 0; stage < stages_ms.size(); ++stage)
        state.counters[kStages[stage]] = stages_ms[stage] / static_cast<double>(state.iterations());
    state.counters["error_mm"] = compared > 0 ? sum_m / compared * 1e3 : std::nan("");
    state.counters["missed_share"] =
        compared + missed > 0 ? static_cast<double>(missed) / (compared + missed) : 0.0;
}

/// Reading each pixel of the same pictures once: what any method that looks at the whole picture takes.
void readPictures(benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
        const cv::Mat1b& image = frames().frames[i].image;
        i = (i + 1) % frames().frames.size();
        std::uint64_t sum = 0;
        for (int v = 0; v < image.rows; ++v) {
            const std::uint8_t* row = image[v];
            std::uint32_t ofRow = 0;
            for (int u = 0; u < image.cols; ++u)
                ofRow += row[u];
            sum += ofRow;
        }
        benchmark::DoNotOptimize(sum);
    }
}

} // namespace

int main(int argc, char** argv) {
    benchmark::RegisterBenchmark("read_every_pixel", readPictures)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(static_cast<benchmark::IterationCount>(frames().frames.size()));
    const auto add = [](const std::string& label, const std::string& name, int cores) {
        // Complete rounds over all frames, so that every rung sees the same ones.
        benchmark::RegisterBenchmark(
            label.c_str(), [name, cores](benchmark::State& state) { findContacts(state, name, cores); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(static_cast<benchmark::IterationCount>(frames().frames.size()));
    };
    for (const vision::ContactRung& rung : vision::contactLadder())
        add("contacts/" + std::string(rung.name), std::string(rung.name), 1);
    add("contacts/dots_two_cores", "dots", 2);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
