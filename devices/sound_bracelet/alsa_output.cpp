// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/alsa_output.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"

#include <QCoreApplication>

#include <chrono>
#include <utility>

namespace teleta::sound {

core::Expected<std::unique_ptr<AlsaOutput>> AlsaOutput::open(const SoundBraceletFile& file,
                                                             ToneEngine& engine) {
    TELETA_TRY(AlsaStream stream, AlsaStream::open(file));
    std::unique_ptr<AlsaOutput> output(new AlsaOutput(file, engine, std::move(stream)));
    const std::int64_t end_ns = core::steadyNow_ns() + kLongestOpening_ns;
    // The first periods only fill the card.
    const auto plays = [&] { return engine.cost().callbacks > output->m_stream.periods(); };
    while (!plays() && engine.fault() == SoundFault::none && core::steadyNow_ns() < end_ns)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (const SoundFault fault = engine.fault(); fault != SoundFault::none)
        return core::failed(core::ErrorKind::unavailable, QString::fromStdString(describe(fault)));
    if (!plays())
        return core::failed(
            core::ErrorKind::unavailable,
            QCoreApplication::translate("SoundBracelet", "The sound card requests no samples."));
    return output;
}

AlsaOutput::AlsaOutput(const SoundBraceletFile& file, ToneEngine& engine, AlsaStream stream)
    : m_engine(engine)
    , m_stream(std::move(stream))
    , m_where("ALSA, " + file.address.name)
    , m_statedLatency_s(file.period_s() * (m_stream.periods() + 1.0))
    , m_samples(core::kTactors * file.period_frames) {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        m_tactors[i] = std::span(m_samples).subspan(i * file.period_frames, file.period_frames);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void AlsaOutput::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    while (!stop.stop_requested() && m_engine.fault() == SoundFault::none) {
        m_engine.render(m_tactors, core::steadyNow_ns());
        switch (m_stream.write(m_tactors)) {
        case AlsaStream::Written::period:
            break;
        case AlsaStream::Written::late:
            m_engine.missPeriod();
            break;
        case AlsaStream::Written::gone:
            m_engine.fail(SoundFault::deviceGone);
            break;
        }
    }
    // What the card still holds is not played any more.
    m_stream.drop();
}

} // namespace teleta::sound
