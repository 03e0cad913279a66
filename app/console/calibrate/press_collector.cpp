// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/press_collector.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace teleta::console {

namespace {

constexpr std::size_t kBlocks = 512;
/// Longest time between frames of one press.
constexpr double kGap_s = 0.2;

} // namespace

PressCollector::PressCollector(std::shared_ptr<pipeline::TouchChannel> channel)
    : m_channel(std::move(channel))
    , m_tap(std::make_shared<core::StreamTap>(kBlocks))
    , m_taxels(m_channel->description().layout.taxels())
    , m_frame(m_taxels)
    , m_load(m_taxels)
    , m_dead(m_taxels) {
    takeSettings();
    m_channel->collect(m_tap);
}

PressCollector::~PressCollector() {
    m_tap->close();
    m_channel->collect(nullptr);
}

void PressCollector::takeSettings() {
    m_revision = m_channel->settingsRevision();
    const pipeline::ChannelSettings settings = m_channel->settings();
    m_threshold_N = settings.features.threshold_N;
    m_conditioning = settings.conditioning;
    m_conditioning.taxelGain.clear(); // wrong gains must not decide which frames belong to a press
    m_conditioner.emplace(m_taxels, m_conditioning);
}

void PressCollector::update() {
    if (m_channel->settingsRevision() != m_revision) {
        takeSettings();
        m_frames.clear();
        m_last_s.reset();
        m_collected_s = 0.0;
        m_waiting = true;
    }
    while (!isComplete() && m_tap->pop(m_block))
        take(m_block);
}

bool PressCollector::isComplete() const {
    return m_collected_s >= kWanted_s || m_frames.size() >= kMostFrames * m_taxels;
}

void PressCollector::take(const core::TappedFrames& block) {
    if (block.values.size() != block.frames() * m_taxels * sizeof(float))
        return;
    if (block.discontinuity)
        m_last_s.reset();
    for (std::size_t i = 0; i < block.frames() && !isComplete(); ++i) {
        std::memcpy(m_frame.data(), block.values.data() + i * m_taxels * sizeof(float),
                    m_taxels * sizeof(float));
        const std::size_t dead = m_conditioner->apply(m_frame, m_load, m_dead);
        const auto threshold = static_cast<float>(m_threshold_N);
        const auto loaded = static_cast<std::size_t>(
            std::ranges::count_if(m_load, [threshold](float load) { return load >= threshold; }));
        m_waiting = 2 * loaded <= m_taxels - dead;
        const double time_s = block.sourceTime_s[i];
        if (m_waiting) {
            m_last_s.reset();
            continue;
        }
        if (m_last_s && time_s > *m_last_s)
            m_collected_s += std::min(time_s - *m_last_s, kGap_s);
        m_last_s = time_s;
        m_frames.insert(m_frames.end(), m_frame.begin(), m_frame.end());
    }
}

} // namespace teleta::console
