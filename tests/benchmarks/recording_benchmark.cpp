// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of recording frames of 84 taxels, compared with writing CSV by core::CsvWriter.
//   csvRow         a frame as a row of CSV, on the data thread, including the buffer of the file
//   tapAppend      a frame into a StreamTap, on the data thread, while a recorder writes the file
//   csvFile        20 000 frames until the CSV file is complete on the disk
//   recordingFile  20 000 frames until the recording is complete on the disk
#include "backend/core/data/csv_writer.h"
#include "backend/core/steady_time.h"
#include "backend/recording/recorder.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace teleta;

constexpr std::size_t kTaxels = 84;
constexpr std::int64_t kFrames = 20'000;
constexpr std::int64_t kPeriod_ns = 5'000'000;

/// Loads with noise as from a sensor, so that all digits are needed.
std::vector<std::vector<float>> frames() {
    std::vector<std::vector<float>> made(256, std::vector<float>(kTaxels));
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (std::size_t k = 0; k < kTaxels; ++k)
            made[i][k] = static_cast<float>(std::sin(0.37 * static_cast<double>(i * kTaxels + k)));
    }
    return made;
}

core::Expected<core::CsvWriter> csvFileAt(const std::string& path) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i <= kTaxels; ++i)
        names.push_back(std::to_string(i));
    const std::vector<std::string_view> columns(names.begin(), names.end());
    return core::CsvWriter::create(path, columns);
}

void writeRow(core::CsvWriter& csv, double time_s, const std::vector<float>& values) {
    csv.number(time_s);
    for (const float value : values)
        csv.number(value);
    csv.endRow();
}

recording::StreamInfo arrayStream() {
    recording::StreamInfo info;
    info.name = std::string("frames");
    info.shape = {6, 14};
    info.unit = std::string(1, 'N');
    return info;
}

std::unique_ptr<recording::Recorder> recorderAt(const std::string& path, std::size_t queueBlocks) {
    recording::RecorderOptions options;
    options.simulatedTime = true;
    options.queueBlocks = queueBlocks;
    auto recorder = recording::Recorder::start(path, {}, options);
    return recorder ? std::move(*recorder) : nullptr;
}

void csvRow(benchmark::State& state) {
    const QTemporaryDir folder;
    auto csv = csvFileAt(folder.filePath(QStringLiteral("frames.csv")).toStdString());
    const auto values = frames();
    std::size_t i = 0;
    for (auto _ : state) {
        writeRow(*csv, static_cast<double>(i) * 0.005, values[i % values.size()]);
        ++i;
    }
}

void tapAppend(benchmark::State& state) {
    const QTemporaryDir folder;
    // Large enough for everything between two polls of the writer, so that no frame is dropped.
    const auto recorder = recorderAt(folder.filePath(QStringLiteral("run.teleta")).toStdString(), 1U << 19U);
    if (!recorder) {
        state.SkipWithError("no recording");
        return;
    }
    const auto tap = recorder->addStream(arrayStream());
    const auto values = frames();
    std::int64_t i = 0;
    for (auto _ : state) {
        const auto& frame = values[static_cast<std::size_t>(i) % values.size()];
        tap->append(i * kPeriod_ns, static_cast<double>(i) * 0.005, std::span<const float>(frame));
        ++i;
    }
    (void)recorder->stop();
    state.counters["dropped"] = static_cast<double>(recorder->status().dropped);
}

void csvFile(benchmark::State& state) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("frames.csv")).toStdString();
    const auto values = frames();
    for (auto _ : state) {
        auto csv = csvFileAt(path);
        for (std::int64_t i = 0; i < kFrames; ++i)
            writeRow(*csv, static_cast<double>(i) * 0.005,
                     values[static_cast<std::size_t>(i) % values.size()]);
        (void)csv->finish();
    }
    state.counters["frames/s"] = benchmark::Counter(
        static_cast<double>(kFrames) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["bytes/frame"] = static_cast<double>(std::filesystem::file_size(path)) / kFrames;
}

void recordingFile(benchmark::State& state) {
    const QTemporaryDir folder;
    const auto values = frames();
    int file = 0;
    std::string path;
    for (auto _ : state) {
        path = folder.filePath(QStringLiteral("run%1.teleta").arg(file++)).toStdString();
        const auto recorder = recorderAt(path, 4096);
        const auto tap = recorder->addStream(arrayStream());
        for (std::int64_t i = 0; i < kFrames; ++i) {
            const std::int64_t time_ns = i * kPeriod_ns;
            const double time_s = static_cast<double>(i) * 0.005;
            const auto& frame = values[static_cast<std::size_t>(i) % values.size()];
            while (
                !tap->tryAppend(std::span(&time_ns, 1), std::span(&time_s, 1), std::span<const float>(frame)))
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        (void)recorder->stop();
    }
    state.counters["frames/s"] = benchmark::Counter(
        static_cast<double>(kFrames) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.counters["bytes/frame"] = static_cast<double>(std::filesystem::file_size(path)) / kFrames;
}

BENCHMARK(csvRow);
BENCHMARK(tapAppend)->Iterations(200'000);
BENCHMARK(csvFile)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(recordingFile)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
