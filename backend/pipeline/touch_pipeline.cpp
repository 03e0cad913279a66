// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch_pipeline.h"

#include "backend/core/threads/urgent_thread.h"

#include <chrono>
#include <utility>

namespace teleta::pipeline {

using namespace std::chrono_literals;

TouchPipeline::TouchPipeline()
    : m_computeThread([this](const std::stop_token& stop) { compute(stop); })
    , m_controlThread([this](const std::stop_token& stop) { control(stop); }) {
}

TouchPipeline::~TouchPipeline() {
    m_controlThread.request_stop();
    m_controlThread.join();
    m_computeThread.request_stop();
    m_data.notify();
    m_computeThread.join();
    for (const auto& [key, channel] : m_channels)
        channel->stop();
}

ChannelKey TouchPipeline::open(SourceFactory factory) {
    request({++m_lastKey, std::move(factory)});
    return m_lastKey;
}

void TouchPipeline::request(Request request) {
    {
        const std::scoped_lock lock(m_requestMutex);
        m_requests.push_back(std::move(request));
    }
    m_requestCondition.notify_one();
}

std::vector<ChannelEvent> TouchPipeline::takeEvents() {
    const std::scoped_lock lock(m_eventMutex);
    return std::exchange(m_events, {});
}

void TouchPipeline::control(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        Request request;
        {
            std::unique_lock lock(m_requestMutex);
            if (!m_requestCondition.wait(lock, stop, [this] { return !m_requests.empty(); }))
                return;
            request = std::move(m_requests.front());
            m_requests.erase(m_requests.begin());
        }
        carryOut(request);
    }
}

void TouchPipeline::carryOut(Request& request) {
    ChannelEvent event;
    event.key = request.key;
    if (request.factory) {
        auto opened = request.factory();
        if (opened) {
            event.channel = std::move(*opened);
            {
                const std::scoped_lock lock(m_channelMutex);
                m_channels.emplace(request.key, event.channel);
                ++m_channelRevision;
            }
            event.channel->start(m_data);
        } else {
            event.kind = ChannelEvent::Kind::failed;
            event.error = std::move(opened.error());
        }
    } else {
        event.kind = ChannelEvent::Kind::closed;
        Channels::node_type closed;
        {
            const std::scoped_lock lock(m_channelMutex);
            closed = m_channels.extract(request.key);
            if (closed.empty())
                return;
            ++m_channelRevision;
        }
        closed.mapped()->stop();
        m_data.notify();
    }
    const std::scoped_lock lock(m_eventMutex);
    m_events.push_back(std::move(event));
}

void TouchPipeline::compute(const std::stop_token& stop) {
    // Between devices and a bracelet whose threads are urgent.
    (void)core::raiseThread();
    // The time-out lets new settings take effect while a paused source delivers nothing.
    constexpr auto kIdlePeriod = 50ms;
    Channels channels;
    std::uint64_t revision = 0;
    while (!stop.stop_requested()) {
        m_data.waitFor(kIdlePeriod);
        {
            const std::scoped_lock lock(m_channelMutex);
            if (revision != m_channelRevision) {
                channels = m_channels;
                revision = m_channelRevision;
            }
        }
        for (const auto& [key, channel] : channels)
            channel->process();
    }
}

} // namespace teleta::pipeline
