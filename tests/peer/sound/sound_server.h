// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/peer_process.h"

#include <QString>

namespace teleta::peer {

/// PipeWire with WirePlumber and a sink of six outputs, "tactors", that nobody hears: what is played on it
/// comes back at its monitor. Runs in a session of with_sound_session.sh. Thread: one.
class SoundServer {
public:
    /// False: it did not start.
    [[nodiscard]] bool start();
    /// Without a chance to close anything.
    void kill();

    [[nodiscard]] bool createSink(const QString& name = QStringLiteral("tactors"));
    /// As if the card were unplugged.
    [[nodiscard]] bool destroySink(const QString& name = QStringLiteral("tactors"));

private:
    test::PeerProcess m_server;
    test::PeerProcess m_manager;
};

/// JACK's own server with a driver without a card, at 48 kHz and a period of 128 samples: without real time
/// it misses periods on a busy machine, which is what it is for. Thread: one.
class JackServer {
public:
    [[nodiscard]] bool start();
    void kill() { m_server.kill(); }
    /// It does not run for so long.
    void hold(int milliseconds);

private:
    test::PeerProcess m_server;
};

} // namespace teleta::peer
