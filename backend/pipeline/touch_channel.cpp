// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch_channel.h"

#include "backend/core/device/loss_counting.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recorder.h"
#include "backend/recording/stream_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace teleta::pipeline {

namespace {

contact::AnalysisSettings analysisOf(const ChannelSettings& settings) {
    return {settings.conditioning, settings.features, settings.segmentation};
}

core::ChipThermometers* thermometersOf(core::TactileSource& source) {
    auto* thermometers = dynamic_cast<core::ChipThermometers*>(&source);
    return thermometers != nullptr && thermometers->chips() > 0 ? thermometers : nullptr;
}

} // namespace

TouchChannel::TouchChannel(std::unique_ptr<core::TactileSource> source, ChannelSettings settings,
                           std::shared_ptr<servo::ServoLink> servo)
    : m_source(std::move(source))
    , m_servo(std::move(servo))
    , m_thermometers(thermometersOf(*m_source))
    , m_settings(std::move(settings))
    , m_analysis(m_source->description().layout, analysisOf(m_settings))
    , m_samples(kHistorySamples) {
    const core::TaxelLayout& layout = m_source->description().layout;
    m_current.layout = layout;
    m_current.loadUnit = m_settings.loadUnit;
    m_current.load_N.resize(layout.taxels());
    m_current.dead.resize(layout.taxels());
    m_current.labels.resize(layout.taxels());
    m_settingsInUse.set(m_settings);
    // What comes first need not be near the tare: a playback begins anywhere.
    if (!m_settings.conditioning.tare.empty())
        m_drift.restart(m_settings.tareTemperatures_degC);
}

TouchChannel::~TouchChannel() {
    m_source->stop();
}

ChannelSummary TouchChannel::summary() const {
    const core::SourceDescription& description = m_source->description();
    return {description.name, description.nominalRate_Hz, description.simulated, description.recorded};
}

bool TouchChannel::countsLosses() const {
    const auto* counting = dynamic_cast<const core::LossCounting*>(m_source.get());
    return counting == nullptr || counting->countsLosses();
}

std::uint64_t TouchChannel::lostAtSite() const {
    const auto* counting = dynamic_cast<const core::LossCounting*>(m_source.get());
    return counting != nullptr ? counting->lostAtSite() : 0;
}

void TouchChannel::drain() {
    FeatureSample sample;
    while (popSample(sample)) {
    }
    (void)update();
}

void TouchChannel::post(ChannelSettings settings) {
    m_changes.post(std::move(settings));
}

void TouchChannel::requestTare(double duration_s) {
    m_tareRequests.post({.clear = false, .duration_s = duration_s});
}

void TouchChannel::clearTare() {
    m_tareRequests.post({.clear = true});
}

void TouchChannel::setTaxelGain(std::vector<float> gain) {
    m_gainChanges.post(std::move(gain));
}

std::size_t TouchChannel::process(const std::function<void(const TouchSnapshot&)>& onFrame) {
    const bool changed = takeCommands();
    std::array<std::shared_ptr<const TouchTaps>, 1 + kWatchers> taps{m_taps.get()};
    std::ranges::transform(m_watched, taps.begin() + 1, [](const auto& watched) { return watched.get(); });
    const bool isTapped = std::ranges::any_of(taps, [](const auto& each) { return each != nullptr; });
    const std::shared_ptr<core::StreamTap> collector = m_collector.get();
    std::size_t frames = 0;
    // What comes meanwhile waits for the next time: a source that is as fast as its reader would never let
    // go.
    core::BoundedQueue<core::SampleBlock>& blocks = m_source->blocks();
    for (std::size_t waiting = blocks.size(); waiting > 0 && blocks.pop(m_block); --waiting) {
        m_lostBefore = m_block.firstFrame > m_nextFrame ? m_block.firstFrame - m_nextFrame : 0;
        m_nextFrame = m_block.firstFrame + m_block.frames();
        if (m_block.channels != m_current.layout.values()) {
            m_block = {};
            continue;
        }
        if (m_block.discontinuity) {
            m_analysis.reset();
        }
        m_recordedFeatures.clear();
        m_recordedLoads.clear();
        for (std::size_t index = 0; index < m_block.frames(); ++index) {
            processFrame(m_block, index);
            if (m_loads)
                findLoads(m_block, index);
            if (isTapped)
                appendFeatures(m_current.features, m_current.layout.isVector(), m_recordedFeatures);
            if (onFrame)
                onFrame(m_current);
        }
        for (const auto& each : taps)
            if (each)
                tap(*each);
        if (collector)
            collector->append(std::span<const std::int64_t>(m_block.time_ns),
                              std::span<const double>(m_block.sourceTime_s),
                              std::span<const float>(m_block.values), m_block.discontinuity);
        frames += m_block.frames();
    }
    takeTemperatures(taps);
    if (frames > 0) {
        publish();
    } else if (changed && m_block.frames() > 0) {
        // A paused source delivers nothing: its last frame shows what the new settings do.
        analyse(m_block, m_block.frames() - 1);
        if (m_loads)
            findLoads(m_block, m_block.frames() - 1);
        publish();
    }
    return frames;
}

void TouchChannel::record(const std::shared_ptr<recording::Recorder>& recorder, const std::string& name) {
    m_told = {};
    if (!recorder) {
        m_taps.set(nullptr);
        return;
    }
    const std::string frames = framesStreamName(name);
    // Before the settings: newer ones are told again.
    const std::uint64_t revision = settingsRevision();
    const ChannelSettings inUse = settings();
    m_told = {frames, revision, settingsEvent(frames, inUse).text};
    m_taps.set(tapsInto(*recorder, name, inUse));
}

void TouchChannel::watch(Watcher who, const std::shared_ptr<recording::StreamSink>& sink,
                         const std::string& name) {
    m_watched[static_cast<std::size_t>(who)].set(sink ? tapsInto(*sink, name, settings()) : nullptr);
}

std::shared_ptr<const TouchTaps> TouchChannel::tapsInto(recording::StreamSink& sink, const std::string& name,
                                                        const ChannelSettings& inUse) const {
    auto taps = std::make_shared<TouchTaps>();
    taps->frames = sink.addStream(arrayStream(framesStreamName(name), description(), inUse,
                                              m_loads ? &*m_loads : nullptr, countsLosses()));
    taps->features = sink.addStream(featureStream(name + "-features", description(), inUse.loadUnit));
    if (m_thermometers != nullptr)
        taps->temperatures = sink.addStream(numberStream(
            name + "-temperatures", description(), recording::temperatureColumns(m_thermometers->chips())));
    if (m_loads)
        taps->loads = sink.addStream(numberStream(name + "-loads", description(), m_loads->columns()));
    return taps;
}

std::optional<recording::RecordingEvent> TouchChannel::takeSettingsEvent() {
    const std::uint64_t revision = settingsRevision();
    if (m_told.stream.empty() || std::exchange(m_told.revision, revision) == revision)
        return std::nullopt;
    recording::RecordingEvent event = settingsEvent(m_told.stream, settings());
    if (std::exchange(m_told.text, event.text) == event.text)
        return std::nullopt;
    event.time_ns = core::steadyNow_ns();
    return event;
}

void TouchChannel::findLoads(const core::SampleBlock& block, std::size_t index) {
    std::vector<double> features;
    appendFeatures(m_current.features, m_current.layout.isVector(), features);
    LoadReading reading{block.time_ns[index], m_loads->names(),
                        m_loads->at(block.frame(index), m_settings.conditioning.tare, features)};
    const std::vector<double> values = loadValues(reading.at);
    m_recordedLoads.insert(m_recordedLoads.end(), values.begin(), values.end());
    if (index + 1 == block.frames())
        m_newestLoads.set(std::move(reading));
}

void TouchChannel::takeTemperatures(std::span<const std::shared_ptr<const TouchTaps>> taps) {
    if (m_thermometers == nullptr)
        return;
    core::BoundedQueue<core::TemperatureSample>& samples = m_thermometers->temperatures();
    core::TemperatureSample sample;
    std::vector<double> values;
    for (std::size_t waiting = samples.size(); waiting > 0 && samples.pop(sample); --waiting) {
        values.assign(sample.values_degC.begin(), sample.values_degC.end());
        for (const auto& each : taps)
            if (each && each->temperatures)
                each->temperatures->append(sample.time_ns, sample.sourceTime_s,
                                           std::span<const double>(values), sample.discontinuity);
        m_drift.take(sample.values_degC);
    }
    const bool isTared = !m_settings.conditioning.tare.empty();
    if (isTared && m_settings.tareTemperatures_degC.empty() && !m_drift.atTare().empty()) {
        m_settings.tareTemperatures_degC = m_drift.atTare();
        m_settingsInUse.set(m_settings);
        m_revision.fetch_add(1, std::memory_order_acq_rel); // a recording has the tare without them
    }
    const bool isTold = m_drift.isTold() && isTared;
    m_driftTold.set(isTold ? m_drift.largest() : std::nullopt);
}

void TouchChannel::tap(const TouchTaps& taps) {
    const std::span<const std::int64_t> time_ns(m_block.time_ns);
    const std::span<const double> sourceTime_s(m_block.sourceTime_s);
    taps.frames->lose(m_lostBefore);
    taps.frames->append(time_ns, sourceTime_s, std::span<const float>(m_block.values), m_block.discontinuity);
    taps.features->append(time_ns, sourceTime_s, std::span<const double>(m_recordedFeatures),
                          m_block.discontinuity);
    if (taps.loads)
        taps.loads->append(time_ns, sourceTime_s, std::span<const double>(m_recordedLoads),
                           m_block.discontinuity);
}

bool TouchChannel::takeCommands() {
    const std::uint64_t before = m_revision.load(std::memory_order_relaxed);
    if (auto change = m_changes.take()) {
        change->conditioning.tare = m_settings.conditioning.tare;
        change->conditioning.taxelGain = m_settings.conditioning.taxelGain;
        change->tareTemperatures_degC = m_settings.tareTemperatures_degC;
        applySettings(std::move(*change));
    }
    if (auto gain = m_gainChanges.take()) {
        ChannelSettings changed = m_settings;
        changed.conditioning.taxelGain = std::move(*gain);
        applySettings(std::move(changed));
    }
    if (const auto request = m_tareRequests.take()) {
        m_tareRun.reset();
        if (!request->clear) {
            m_tareRun = std::make_unique<TareRun>();
            m_tareRun->duration_s = request->duration_s;
            m_tareRun->sum.resize(m_current.layout.values());
            m_tareRun->count.resize(m_current.layout.values());
        } else {
            ChannelSettings cleared = m_settings;
            cleared.conditioning.tare.clear();
            cleared.tareTemperatures_degC.clear();
            applySettings(std::move(cleared));
        }
    }
    return m_revision.load(std::memory_order_relaxed) != before;
}

void TouchChannel::applySettings(ChannelSettings settings) {
    m_settings = std::move(settings);
    m_analysis.setSettings(analysisOf(m_settings));
    m_current.loadUnit = m_settings.loadUnit;
    m_settingsInUse.set(m_settings);
    m_revision.fetch_add(1, std::memory_order_acq_rel);
}

void TouchChannel::processFrame(const core::SampleBlock& block, std::size_t index) {
    if (m_tareRun)
        accumulateTare(block, index);
    analyse(block, index);
    m_current.framesProcessed = m_framesProcessed.fetch_add(1, std::memory_order_relaxed) + 1;
    m_samples.push({.time_ns = m_current.time_ns,
                    .sourceTime_s = m_current.sourceTime_s,
                    .discontinuity = block.discontinuity && index == 0,
                    .features = m_current.features});
}

void TouchChannel::analyse(const core::SampleBlock& block, std::size_t index) {
    m_current.frame = block.firstFrame + index;
    m_current.time_ns = block.time_ns[index];
    m_current.sourceTime_s = block.sourceTime_s[index];
    m_analysis.analyse(block.frame(index), m_current.sourceTime_s, m_current);
    m_current.threshold_N = m_current.features.threshold_N;
}

void TouchChannel::accumulateTare(const core::SampleBlock& block, std::size_t index) {
    TareRun& run = *m_tareRun;
    if (run.frames == 0 || block.sourceTime_s[index] < run.start_s)
        run.start_s = block.sourceTime_s[index];
    const auto frame = block.frame(index);
    for (std::size_t taxel = 0; taxel < frame.size(); ++taxel) {
        if (!std::isfinite(frame[taxel]))
            continue;
        run.sum[taxel] += static_cast<double>(frame[taxel]);
        ++run.count[taxel];
    }
    ++run.frames;
    // Stream times are decimal fractions: a difference that should be the duration may fall short by
    // rounding.
    constexpr double kTimeRounding_s = 1e-9;
    if (block.sourceTime_s[index] - run.start_s < run.duration_s - kTimeRounding_s)
        return;

    ChannelSettings tared = m_settings;
    tared.conditioning.tare.resize(frame.size());
    for (std::size_t taxel = 0; taxel < frame.size(); ++taxel)
        tared.conditioning.tare[taxel] = run.count[taxel] > 0
                                             ? static_cast<float>(run.sum[taxel] / run.count[taxel])
                                             : std::numeric_limits<float>::quiet_NaN();
    m_tareRun.reset();
    tared.tareTemperatures_degC.clear(); // the next ones that come
    m_drift.restart();
    applySettings(std::move(tared));
}

void TouchChannel::publish() {
    const auto labels = m_analysis.labels();
    m_current.labels.assign(labels.begin(), labels.end());
    m_snapshots.back() = m_current;
    m_snapshots.publish();
}

} // namespace teleta::pipeline
