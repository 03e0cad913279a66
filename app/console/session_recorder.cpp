// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/session_recorder.h"

#include <utility>

namespace teleta::console {

SessionRecorder::SessionRecorder(RecordingService& service, QObject* parent)
    : QObject(parent)
    , m_service(service) {
    connect(&m_service, &RecordingService::stateChanged, this, [this] {
        if (m_service.state() == RecordingService::State::idle)
            m_isOurs = false;
    });
}

void SessionRecorder::start(const QString& path) {
    m_isOurs = m_service.state() == RecordingService::State::idle;
    if (m_isOurs)
        m_service.start(path);
}

void SessionRecorder::stop() {
    if (std::exchange(m_isOurs, false))
        m_service.stop();
}

void SessionRecorder::add(recording::RecordingEvent event) {
    m_service.add(std::move(event));
}

QString SessionRecorder::file() const {
    // Its name is not certain before it exists.
    return m_service.isRecording() ? m_service.path() : QString();
}

std::optional<std::int64_t> SessionRecorder::start_ns() const {
    return file().isEmpty() ? std::nullopt : std::optional(m_service.start_ns());
}

} // namespace teleta::console
