// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/latency/click_listener.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::sound {

namespace {

struct ListenerText {
    Q_DECLARE_TR_FUNCTIONS(ClickListener)
};

constexpr const char* kListenerName = "TeleTA listener";

} // namespace

core::Expected<std::vector<std::string>> ClickListener::inputs(const SoundBraceletFile& file) {
    TELETA_TRY(const auto listener, connectTo(file));
    return listener->inputs();
}

core::Expected<std::unique_ptr<ClickListener>> ClickListener::open(const SoundBraceletFile& file,
                                                                   const std::string& port) {
    TELETA_TRY(auto listener, connectTo(file));
    TELETA_CHECK(listener->start(file, port));
    return listener;
}

core::Expected<std::unique_ptr<ClickListener>> ClickListener::connectTo(const SoundBraceletFile& file) {
    if (file.address.api == SoundApi::alsa)
        return core::refused(ListenerText::tr("Inputs of ALSA cannot be listened to."),
                             ListenerText::tr("device = \"pipewire\" or \"jack\" in the device file"));
    std::optional<core::Error> failure;
    for (const std::string& path :
         file.address.api == SoundApi::pipeWire ? pipeWireLibraries() : jackLibraries()) {
        auto jack = loadJack(path);
        if (!jack) {
            if (!failure)
                failure = jack.error();
            continue;
        }
        JackClient* client = jack->clientOpen(kListenerName, kJackNoStartServer, nullptr);
        if (client == nullptr)
            continue;
        return std::unique_ptr<ClickListener>(new ClickListener(std::move(*jack), client));
    }
    if (failure)
        return core::Unexpected(*failure);
    return core::failed(core::ErrorKind::unavailable, ListenerText::tr("The sound server does not answer."));
}

ClickListener::ClickListener(JackLibrary jack, JackClient* client)
    : m_jack(std::move(jack))
    , m_client(client) {
}

ClickListener::~ClickListener() {
    m_jack.clientClose(m_client);
}

std::vector<std::string> ClickListener::inputs() const {
    std::vector<std::string> names =
        m_jack.names(m_jack.ports(m_client, nullptr, kJackAudio, kJackPortIsOutput));
    // What the bracelet plays before it reaches the card.
    std::erase_if(names, [](const std::string& name) { return name.starts_with(kBraceletClient); });
    return names;
}

core::Expected<void> ClickListener::start(const SoundBraceletFile& file, const std::string& port) {
    const std::vector<std::string> known = inputs();
    if (std::ranges::find(known, port) == known.end()) {
        QStringList names;
        for (const std::string& input : known)
            names << QString::fromStdString(input);
        return core::failed(
            core::ErrorKind::unavailable,
            ListenerText::tr("There is no sound input \"%1\".").arg(QString::fromStdString(port)),
            names.isEmpty() ? ListenerText::tr("an input; there is none")
                            : ListenerText::tr("one of: %1").arg(names.join(QStringLiteral(", "))));
    }
    m_rate_Hz = m_jack.sampleRate(m_client);
    JackLatencyRange range;
    if (JackPort* const source = m_jack.portByName(m_client, port.c_str()); source != nullptr)
        m_jack.latencyRange(source, kJackCaptureLatency, &range);
    m_capture_frames.store(range.most_frames);
    m_port = m_jack.portRegister(m_client, "click", kJackAudio, kJackPortIsInput | kJackPortIsTerminal, 0);
    if (m_port == nullptr)
        return core::failed(core::ErrorKind::unavailable,
                            ListenerText::tr("The sound server refused to create an input."));
    m_jack.setProcess(m_client, process, this);
    // PipeWire would change the period for another program.
    (void)m_jack.setBufferSize(m_client, file.period_frames);
    if (m_jack.activate(m_client) != 0 ||
        m_jack.connect(m_client, port.c_str(), m_jack.portName(m_port)) != 0)
        return core::failed(
            core::ErrorKind::unavailable,
            ListenerText::tr("The input \"%1\" cannot be connected.").arg(QString::fromStdString(port)));
    return {};
}

void ClickListener::arm(float threshold) {
    m_threshold.store(threshold, std::memory_order_relaxed);
    m_heard_ns.store(0, std::memory_order_relaxed);
    m_armed.store(true, std::memory_order_release);
}

int ClickListener::process(std::uint32_t frames, void* self) {
    auto& listener = *static_cast<ClickListener*>(self);
    const std::int64_t now_ns = core::steadyNow_ns();
    const auto* const samples =
        static_cast<const float*>(listener.m_jack.portBuffer(listener.m_port, frames));
    // While a port is connected, or its server ends, it may have none.
    if (samples == nullptr)
        return 0;
    const bool armed = listener.m_armed.load(std::memory_order_acquire);
    const float threshold = listener.m_threshold.load(std::memory_order_relaxed);
    float peak = 0.0F;
    for (std::uint32_t i = 0; i < frames; ++i) {
        const float size = std::abs(samples[i]);
        peak = std::max(peak, size);
        if (!armed || !(size > threshold) || listener.m_heard_ns.load(std::memory_order_relaxed) != 0)
            continue;
        const double place = static_cast<double>(i) - listener.m_capture_frames.load();
        listener.m_heard_ns.store(now_ns + std::llround(1e9 * place / listener.m_rate_Hz),
                                  std::memory_order_release);
        listener.m_armed.store(false, std::memory_order_relaxed);
    }
    if (peak > listener.m_peak.load(std::memory_order_relaxed))
        listener.m_peak.store(peak, std::memory_order_release);
    return 0;
}

} // namespace teleta::sound
