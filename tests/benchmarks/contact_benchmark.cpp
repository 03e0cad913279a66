// SPDX-License-Identifier: GPL-3.0-or-later
// Tactile features of a 6 x 14 frame against OpenCV's moments (twice) and PCACompute, and contacts by
// watershed on 6 x 14 and 64 x 64 frames against OpenCV's watershed with markers, on the same frames of
// shipped scenes, one thread. Before timing, the answers are checked to be equal. A table at the end compares
// the medians with the required ratios.
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/contact_tracker.h"
#include "backend/contact/feature_batch.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/contact/summit.h"
#include "backend/contact/tactile_features.h"
#include "backend/scene/scene_reader.h"
#include "backend/simulation/array/simulated_array.h"
#include "tests/benchmarks/compared_runs.h"
#include "tests/benchmarks/whole_body_skin.h"

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::atomic<std::uint64_t> allocations{0};

void* allocate(std::size_t size, std::size_t alignment) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    const std::size_t rounded = (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, rounded);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t size) {
    return allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

using namespace teleta;
using namespace teleta::test;

constexpr double kFeatureRatio = 20.0;
constexpr double kWatershedRatio = 5.0;
/// Largest difference from OpenCV, as a share of the force, the array's length or the eigenvalues.
constexpr double kFeatureTolerance = 1e-9;
/// Share of the taxels assigned to a region by both that are in the same one. OpenCV floods in order of the
/// difference between neighbours, not of the load, so a contact's rim may go to the neighbour's region.
constexpr double kLeastShare = 0.75;

[[noreturn]] void fail(const std::string& message) {
    throw std::runtime_error(message);
}

/// Frames of one array, as the pipeline hands them to features and contacts. Each has at least one contact.
struct FrameSet {
    core::ArrayLayout layout;
    std::vector<float> load_N;
    std::vector<std::uint8_t> dead;

    [[nodiscard]] std::span<const float> load(std::size_t frame) const {
        return std::span(load_N).subspan(frame * layout.taxels(), layout.taxels());
    }
    [[nodiscard]] std::span<const std::uint8_t> deadOf(std::size_t frame) const {
        return std::span(dead).subspan(frame * layout.taxels(), layout.taxels());
    }
};

/// kFrames frames with contact, evenly over the scene.
FrameSet framesOf(const scene::Scene& scene) {
    auto array = simulation::SimulatedArray::make(scene, 1);
    if (!array)
        fail("The scene " + scene.name + " is not valid.");
    FrameSet all{.layout = scene.array().sensor.layout, .load_N = {}, .dead = {}};
    const std::size_t taxels = all.layout.taxels();
    const contact::FrameConditioner conditioner(taxels, {});
    contact::FeatureExtractor features(all.layout);
    std::vector<float> raw(taxels), load_N(taxels);
    std::vector<std::uint8_t> dead(taxels);
    std::size_t count = 0;
    for (double time_s = 0.0; time_s < scene.duration_s; time_s += 1.0 / scene.rate_Hz) {
        (*array)->next(raw, false);
        conditioner.apply(raw, load_N, dead);
        if (features.compute(load_N, dead).active < 2)
            continue;
        all.load_N.insert(all.load_N.end(), load_N.begin(), load_N.end());
        all.dead.insert(all.dead.end(), dead.begin(), dead.end());
        ++count;
    }
    if (count < kFrames)
        fail("The scene " + scene.name + " has too few frames with contact.");
    FrameSet chosen{.layout = all.layout, .load_N = {}, .dead = {}};
    for (std::size_t i = 0; i < kFrames; ++i) {
        const std::size_t frame = i * count / kFrames;
        chosen.load_N.insert(chosen.load_N.end(), all.load(frame).begin(), all.load(frame).end());
        chosen.dead.insert(chosen.dead.end(), all.deadOf(frame).begin(), all.deadOf(frame).end());
    }
    return chosen;
}

scene::Scene shippedScene(const std::string& file) {
    auto scene = scene::readScene(std::string(TELETA_SOURCE_DIR "/resources/scenes/") + file);
    if (!scene)
        fail("The scene " + file + " cannot be read.");
    return *scene;
}

cv::Mat greyImage(const FrameSet& frames, std::size_t frame) {
    cv::Mat image(frames.layout.rows, frames.layout.columns, CV_32F);
    std::copy(frames.load(frame).begin(), frames.load(frame).end(), image.ptr<float>());
    return image;
}

cv::Mat activeMask(const cv::Mat& grey) {
    cv::Mat mask;
    cv::compare(grey, contact::FeatureSettings{}.threshold_N, mask, cv::CMP_GE);
    return mask;
}

/// Coordinates of the active taxels, one a row.
cv::Mat activePoints(const cv::Mat& mask) {
    cv::Mat points;
    cv::findNonZero(mask, points);
    points.reshape(1).convertTo(points, CV_64F);
    return points;
}

struct OpenCvFeatures {
    double force_N, copX_m, copY_m, cocX_m, cocY_m, lambda1_m2, lambda2_m2, alphaZ_rad;
};

/// The same features by OpenCV. The frame is usable, at least two taxels are active.
OpenCvFeatures openCvFeatures(const core::ArrayLayout& layout, const cv::Mat& grey, const cv::Mat& mask,
                              const cv::Mat& points) {
    const cv::Moments load = cv::moments(grey);
    const cv::Moments binary = cv::moments(mask, true);
    cv::Mat mean, vectors, values;
    cv::PCACompute(points, mean, vectors, values);
    // OpenCV divides by n.
    const double scale = layout.pitchX_m * layout.pitchX_m * binary.m00 / (binary.m00 - 1.0);
    return {load.m00,
            layout.x_m(load.m10 / load.m00),
            layout.y_m(load.m01 / load.m00),
            layout.x_m(binary.m10 / binary.m00),
            layout.y_m(binary.m01 / binary.m00),
            scale * values.at<double>(0),
            scale * values.at<double>(1),
            std::atan2(vectors.at<double>(0, 1), vectors.at<double>(0, 0))};
}

/// Largest difference over the features, each as a share of its range.
double differenceOf(const contact::TactileFeatures& ours, const OpenCvFeatures& theirs,
                    const core::ArrayLayout& layout) {
    const double length_m = layout.columns * layout.pitchX_m;
    double worst = std::abs(ours.force_N - theirs.force_N) / theirs.force_N;
    const auto add = [&](double difference) { worst = std::max(worst, std::abs(difference)); };
    add((ours.copX_m.value() - theirs.copX_m) / length_m);
    add((ours.copY_m.value() - theirs.copY_m) / length_m);
    add((ours.cocX_m.value() - theirs.cocX_m) / length_m);
    add((ours.cocY_m.value() - theirs.cocY_m) / length_m);
    add((ours.lambda1_m2.value() - theirs.lambda1_m2) / theirs.lambda1_m2);
    add((ours.lambda2_m2.value() - theirs.lambda2_m2) / theirs.lambda1_m2);
    if (ours.alphaZ_rad) {
        // The closer the eigenvalues, the less certain is the axis of a nearly round contact.
        const double certainty = (theirs.lambda1_m2 - theirs.lambda2_m2) / theirs.lambda1_m2;
        add(certainty * std::remainder(*ours.alphaZ_rad - theirs.alphaZ_rad, std::numbers::pi));
    }
    return worst;
}

/// Frames as OpenCV takes them, prepared for its features.
struct MomentImages {
    std::vector<cv::Mat> grey, mask, points;

    explicit MomentImages(const FrameSet& frames) {
        for (std::size_t i = 0; i < kFrames; ++i) {
            grey.push_back(greyImage(frames, i));
            mask.push_back(activeMask(grey.back()));
            points.push_back(activePoints(mask.back()));
        }
    }
};

void checkFeatures(const FrameSet& frames, const MomentImages& images) {
    contact::FeatureExtractor features(frames.layout);
    double worst = 0.0;
    for (std::size_t i = 0; i < kFrames; ++i) {
        const auto ours = features.compute(frames.load(i), frames.deadOf(i));
        if (ours.active != images.points[i].rows)
            fail("Frame " + std::to_string(i) + ": OpenCV has another number of active taxels.");
        worst = std::max(worst, differenceOf(ours,
                                             openCvFeatures(frames.layout, images.grey[i], images.mask[i],
                                                            images.points[i]),
                                             frames.layout));
    }
    std::printf("features: largest difference from OpenCV %.1e of the range\n", worst);
    if (!(worst <= kFeatureTolerance))
        fail("The features are not those of OpenCV.");
}

/// Allocations of one call, after a first pass over the frames.
template <typename Compute>
double allocationsPerFrame(const Compute& compute) {
    const std::uint64_t unused = allocations.load();
    ::operator delete(::operator new(1));
    if (allocations.load() != unused + 1)
        fail("Allocations are not counted.");
    for (std::size_t i = 0; i < kFrames; ++i)
        compute(i);
    const std::uint64_t before = allocations.load();
    for (std::size_t i = 0; i < kFrames; ++i)
        compute(i);
    return static_cast<double>(allocations.load() - before) / kFrames;
}

/// How OpenCV's watershed is called. It assigns neither the outermost pixels of an image nor those between
/// two regions.
struct Feeding {
    const char* name;
    bool border = false;         ///< one more taxel on each side, so that all taxels can get a region
    bool inactiveMarked = false; ///< a region of its own, not flooded; contacts lose their rims to it
};

constexpr Feeding kAsItIs{"as it is"};
constexpr Feeding kBordered{"with a border", true, false};
constexpr Feeding kInactiveMarked{"inactive taxels marked", false, true};

/// The load as the 8-bit colour image that OpenCV's watershed takes.
cv::Mat colourImage(const cv::Mat& grey, const Feeding& feeding) {
    double peak = 0.0;
    cv::minMaxLoc(grey, nullptr, &peak);
    cv::Mat bytes, colours;
    grey.convertTo(bytes, CV_8U, 255.0 / peak);
    if (feeding.border)
        cv::copyMakeBorder(bytes, bytes, 1, 1, 1, 1, cv::BORDER_REPLICATE);
    cv::cvtColor(bytes, colours, cv::COLOR_GRAY2BGR);
    return colours;
}

/// The summit of each contact, marked with its region.
cv::Mat summitMarkers(std::span<const contact::Contact> contacts, std::span<const std::int32_t> labels,
                      std::span<const float> load_N, const cv::Mat& mask, const Feeding& feeding) {
    cv::Mat markers = cv::Mat::zeros(mask.size(), CV_32S);
    if (feeding.inactiveMarked)
        markers.setTo(static_cast<int>(contacts.size()) + 1, mask == 0);
    auto* const marker = markers.ptr<std::int32_t>();
    for (const contact::Contact& contact : contacts) {
        std::size_t summit = 0;
        while (labels[summit] != contact.region || static_cast<double>(load_N[summit]) != contact.peak_N)
            ++summit;
        marker[summit] = contact.region;
    }
    if (feeding.border)
        cv::copyMakeBorder(markers, markers, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    return markers;
}

/// Contacts by OpenCV alone: local maxima over the threshold, labelled, are the markers.
cv::Mat openCvContacts(const cv::Mat& grey) {
    const cv::Mat colours = colourImage(grey, kBordered);
    const cv::Mat mask = activeMask(grey);
    cv::Mat neighbours, maxima, markers;
    cv::dilate(grey, neighbours, cv::Mat());
    cv::compare(grey, neighbours, maxima, cv::CMP_EQ);
    cv::bitwise_and(maxima, mask, maxima);
    cv::copyMakeBorder(maxima, maxima, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::connectedComponents(maxima, markers, 8, CV_32S);
    cv::watershed(colours, markers);
    return markers;
}

struct WatershedImages {
    std::vector<cv::Mat> colours, markers;
    std::vector<cv::Mat> regions; ///< work copies of the markers, overwritten by the watershed

    WatershedImages(const FrameSet& frames, const Feeding& feeding) {
        contact::ContactSegmenter segmenter(frames.layout);
        for (std::size_t i = 0; i < kFrames; ++i) {
            const cv::Mat grey = greyImage(frames, i);
            const auto contacts = segmenter.segment(frames.load(i), frames.deadOf(i));
            if (contacts.empty())
                fail("Frame " + std::to_string(i) + " has no contact.");
            colours.push_back(colourImage(grey, feeding));
            markers.push_back(
                summitMarkers(contacts, segmenter.labels(), frames.load(i), activeMask(grey), feeding));
            regions.push_back(markers.back().clone());
        }
    }
    void restoreMarkers() {
        for (std::size_t i = 0; i < kFrames; ++i)
            markers[i].copyTo(regions[i]);
    }
};

/// Compares the regions. With the inactive taxels marked most of a small contact is rim, so only the shares
/// are printed.
void checkContacts(const FrameSet& frames, WatershedImages& images, const Feeding& feeding) {
    contact::ContactSegmenter segmenter(frames.layout);
    const int border = feeding.border ? 1 : 0;
    double same = 0.0, other = 0.0, line = 0.0;
    images.restoreMarkers();
    for (std::size_t i = 0; i < kFrames; ++i) {
        (void)segmenter.segment(frames.load(i), frames.deadOf(i));
        cv::watershed(images.colours[i], images.regions[i]);
        for (int row = 0; row < frames.layout.rows; ++row) {
            for (int column = 0; column < frames.layout.columns; ++column) {
                const std::int32_t ours =
                    segmenter.labels()[static_cast<std::size_t>(row * frames.layout.columns + column)];
                const auto theirs = images.regions[i].at<std::int32_t>(row + border, column + border);
                if (ours > 0)
                    (theirs < 0 ? line : theirs == ours ? same : other) += 1.0;
            }
        }
    }
    const double share = same / (same + other);
    std::printf(
        "  %s: OpenCV has %.1f %% of the taxels of our contacts in the same region, %.1f %% in no region\n",
        feeding.name, 100.0 * same / (same + other + line), 100.0 * line / (same + other + line));
    if (!feeding.inactiveMarked && !(share >= kLeastShare))
        fail("The regions are not those of OpenCV.");
}

/// Active taxels and contacts of the frames.
void describe(const char* name, const FrameSet& frames) {
    contact::FeatureExtractor features(frames.layout);
    contact::ContactSegmenter segmenter(frames.layout);
    int least = static_cast<int>(frames.layout.taxels());
    int most = 0;
    double active = 0.0, contacts = 0.0;
    for (std::size_t i = 0; i < kFrames; ++i) {
        const int count = features.compute(frames.load(i), frames.deadOf(i)).active;
        least = std::min(least, count);
        most = std::max(most, count);
        active += count;
        contacts += static_cast<double>(segmenter.segment(frames.load(i), frames.deadOf(i)).size());
    }
    std::printf("%s: %zu frames, active taxels %.1f (%d..%d) of %zu, contacts %.2f a frame\n", name, kFrames,
                active / kFrames, least, most, frames.layout.taxels(), contacts / kFrames);
}

void compareFeatures(std::vector<Comparison>& comparisons) {
    static const FrameSet frames = framesOf(shippedScene("tactile-indenter.toml"));
    static const MomentImages images(frames);
    static contact::FeatureExtractor features(frames.layout);
    describe("features 6 x 14", frames);
    checkFeatures(frames, images);

    const auto ours = [](std::size_t i) {
        benchmark::DoNotOptimize(features.compute(frames.load(i), frames.deadOf(i)));
    };
    std::printf("features: %g allocations a frame\n", allocationsPerFrame(ours));
    registerRun("features/ours", ours);
    registerRun("features/openCv", [](std::size_t i) {
        benchmark::DoNotOptimize(
            openCvFeatures(frames.layout, images.grey[i], images.mask[i], images.points[i]));
    });
    registerRun("features/openCvFromFrame", [](std::size_t i) {
        const cv::Mat mask = activeMask(images.grey[i]);
        benchmark::DoNotOptimize(openCvFeatures(frames.layout, images.grey[i], mask, activePoints(mask)));
    });
    // All frames of a pass at once, the work of the first one.
    static contact::FeatureBatch batch(frames.layout, {});
    static std::vector<contact::ContactType> types(kFrames);
    static std::vector<double> numbers(11 * kFrames);
    static std::vector<std::int64_t> active(kFrames);
    const auto column = [](std::size_t i) { return std::span(numbers).subspan(i * kFrames, kFrames); };
    static const contact::FeatureArrays arrays{types,     column(0),  column(1), column(2), column(3),
                                               column(4), column(5),  column(6), column(7), column(8),
                                               column(9), column(10), active};
    registerRun("features/atOnce", [](std::size_t i) {
        if (i == 0) {
            batch.compute(frames.load_N, arrays);
            benchmark::ClobberMemory();
        }
    });
    static const contact::FrameConditioner conditioner(frames.layout.taxels(), {});
    registerRun("features/oneByOne", [](std::size_t i) {
        static std::vector<float> load_N(frames.layout.taxels());
        static std::vector<std::uint8_t> dead(frames.layout.taxels());
        const bool anyDead = conditioner.apply(frames.load(i), load_N, dead) > 0;
        arrays.set(i, features.compute(load_N, anyDead ? dead : std::span<const std::uint8_t>()));
    });
    comparisons.push_back({"features 6 x 14: frames at once, over one by one as tables", "features/atOnce",
                           "features/oneByOne", 2.0});
    comparisons.push_back(
        {"features 6 x 14: moments twice, PCACompute", "features/ours", "features/openCv", kFeatureRatio});
    comparisons.push_back({"features 6 x 14: the same with binary image, coordinates", "features/ours",
                           "features/openCvFromFrame", kFeatureRatio});
}

/// Everything that the runs of one array need.
struct WatershedRuns {
    FrameSet frames;
    contact::ContactSegmenter segmenter;
    WatershedImages asItIs, bordered, inactiveMarked;
    std::vector<cv::Mat> grey;

    explicit WatershedRuns(FrameSet set)
        : frames(std::move(set))
        , segmenter(frames.layout)
        , asItIs(frames, kAsItIs)
        , bordered(frames, kBordered)
        , inactiveMarked(frames, kInactiveMarked) {
        for (std::size_t i = 0; i < kFrames; ++i)
            grey.push_back(greyImage(frames, i));
    }
};

void compareContacts(const std::string& size, WatershedRuns& runs, std::vector<Comparison>& comparisons) {
    const std::string name = "contacts " + size;
    describe(name.c_str(), runs.frames);
    checkContacts(runs.frames, runs.asItIs, kAsItIs);
    checkContacts(runs.frames, runs.bordered, kBordered);
    checkContacts(runs.frames, runs.inactiveMarked, kInactiveMarked);

    const auto ours = [&runs](std::size_t i) {
        benchmark::DoNotOptimize(runs.segmenter.segment(runs.frames.load(i), runs.frames.deadOf(i)).data());
    };
    std::printf("%s: %g allocations a frame\n", name.c_str(), allocationsPerFrame(ours));
    registerRun(name + "/ours", ours);
    const auto withSummits = [&runs](std::size_t i) {
        const FrameSet& frames = runs.frames;
        for (const contact::Contact& contact : runs.segmenter.segment(frames.load(i), frames.deadOf(i)))
            benchmark::DoNotOptimize(contact::summitOf(frames.load(i), frames.layout, runs.segmenter, contact,
                                                       frames.deadOf(i), 0.03));
    };
    std::printf("%s with their summits: %g allocations a frame\n", name.c_str(),
                allocationsPerFrame(withSummits));
    registerRun(name + "/oursWithSummits", withSummits);
    comparisons.push_back({name + ": the summits as well, over the contacts alone", name + "/ours",
                           name + "/oursWithSummits", 1.0});
    const auto registerWatershed = [&](const std::string& run, WatershedImages& images,
                                       const std::string& what) {
        registerRun(
            name + run, [&images] { images.restoreMarkers(); },
            [&images](std::size_t i) { cv::watershed(images.colours[i], images.regions[i]); });
        comparisons.push_back({name + what, name + "/ours", name + run, kWatershedRatio});
    };
    registerWatershed("/openCv", runs.asItIs, ": watershed, outermost taxels left out");
    registerWatershed("/openCvBordered", runs.bordered, ": watershed, all taxels");
    registerRun(name + "/openCvFromFrame",
                [&runs](std::size_t i) { benchmark::DoNotOptimize(openCvContacts(runs.grey[i]).data); });
    comparisons.push_back({name + ": the same with finding the markers", name + "/ours",
                           name + "/openCvFromFrame", kWatershedRatio});
    registerWatershed("/openCvInactiveMarked", runs.inactiveMarked,
                      ": watershed, inactive marked (rims lost)");
}

void compareSkin(const std::string& name, std::size_t touched, WholeBodySkin& skin,
                 std::vector<Comparison>& comparisons) {
    std::size_t contacts = 0;
    for (std::size_t i = 0; i < kFrames; ++i)
        contacts += skin.process(i);
    std::printf("%s: %.2f contacts a frame\n", name.c_str(), static_cast<double>(contacts) / kFrames);
    if (contacts != touched * kFrames)
        fail(name + ": expected " + std::to_string(touched) + " contacts in each frame.");
    registerRun(name + "/ours", [&skin](std::size_t i) {
        benchmark::DoNotOptimize(skin.process(i));
        benchmark::DoNotOptimize(skin.sum_m.data());
    });
    registerRun(name + "/openCvFromFrame", [&skin](std::size_t i) {
        for (std::size_t patch = 0; patch < WholeBodySkin::kPatches; ++patch)
            benchmark::DoNotOptimize(openCvContacts(skin.grey[i * WholeBodySkin::kPatches + patch]).data);
    });
    comparisons.push_back({name + ": watershed with finding the markers", name + "/ours",
                           name + "/openCvFromFrame", kWatershedRatio});
}

} // namespace

int main(int argc, char** argv) {
    // Many short repetitions, mixed over all runs, so that a disturbance of the machine affects all alike.
    std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=31", "--benchmark_min_time=0.01",
                                       "--benchmark_enable_random_interleaving=true"};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data()))
        return 2;

    cv::setNumThreads(1);
    std::vector<Comparison> comparisons;
    try {
        compareFeatures(comparisons);
        static WatershedRuns small(framesOf(shippedScene("tactile-two-contacts.toml")));
        compareContacts("6 x 14", small, comparisons);
        scene::Scene mat = shippedScene("tactile-mat.toml");
        mat.array().sensor.layout.columns = 64;
        // Noise adds summits, which make work.
        mat.effects.push_back({"", scene::NoiseSpec{.sd_N = 0.03}});
        static WatershedRuns large(framesOf(mat));
        compareContacts("64 x 64", large, comparisons);
        static WholeBodySkin quiet(0, kFrames), fewContacts(4, kFrames),
            everywhere(WholeBodySkin::kPatches, kFrames);
        compareSkin("skin of 40 patches, quiet", 0, quiet, comparisons);
        compareSkin("skin of 40 patches, 4 contacts", 4, fewContacts, comparisons);
        compareSkin("skin of 40 patches, all touched", WholeBodySkin::kPatches, everywhere, comparisons);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "contact_benchmark: %s\n", error.what());
        return 1;
    }

    KeepingReporter results;
    benchmark::RunSpecifiedBenchmarks(&results);
    printTable(results, comparisons);
    return 0;
}
