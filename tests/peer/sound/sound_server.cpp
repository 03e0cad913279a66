// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/sound/sound_server.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace teleta::peer {

namespace {

/// Until the program succeeds, for at most 10 s.
bool soon(const QString& program, const QStringList& arguments) {
    for (int i = 0; i < 100; ++i) {
        if (test::runs(program, arguments))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

/// Until the text is among what the program prints, for at most 10 s.
bool prints(const QString& program, const QStringList& arguments, const QByteArray& text) {
    for (int i = 0; i < 100; ++i) {
        QProcess process;
        process.start(program, arguments);
        process.waitForFinished(5000);
        if (process.readAllStandardOutput().contains(text))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

} // namespace

bool SoundServer::start() {
    m_server.start(QStringLiteral("pipewire"), {});
    if (!soon(QStringLiteral("pw-cli"), {QStringLiteral("info"), QStringLiteral("0")}))
        return false;
    m_manager.start(QStringLiteral("wireplumber"), {});
    // The manager is there when it has named its client.
    return prints(QStringLiteral("pw-cli"), {QStringLiteral("ls"), QStringLiteral("Client")},
                  "WirePlumber") &&
           createSink();
}

void SoundServer::kill() {
    m_server.kill();
    m_manager.kill();
}

bool SoundServer::createSink(const QString& name) {
    return soon(QStringLiteral("pw-cli"),
                {QStringLiteral("create-node"), QStringLiteral("adapter"),
                 QStringLiteral("{ factory.name=support.null-audio-sink node.name=%1 media.class=Audio/Sink "
                                "object.linger=true audio.position=[AUX0 AUX1 AUX2 AUX3 AUX4 AUX5] "
                                "monitor.channel-volumes=false }")
                     .arg(name)}) &&
           prints(QStringLiteral("pw-link"), {QStringLiteral("-io")}, name.toLatin1() + ":monitor_AUX5");
}

bool SoundServer::destroySink(const QString& name) {
    return test::runs(QStringLiteral("pw-cli"), {QStringLiteral("destroy"), name});
}

bool JackServer::start() {
    m_server.start(QStringLiteral("jackd"),
                   {QStringLiteral("--no-realtime"), QStringLiteral("-S"), QStringLiteral("-d"),
                    QStringLiteral("dummy"), QStringLiteral("-r"), QStringLiteral("48000"),
                    QStringLiteral("-p"), QStringLiteral("128"), QStringLiteral("-C"), QStringLiteral("6"),
                    QStringLiteral("-P"), QStringLiteral("6")});
    return prints(QStringLiteral("jack_lsp"), {}, "system:playback_6");
}

void JackServer::hold(int milliseconds) {
    const auto process = static_cast<pid_t>(m_server.processId());
    ::kill(process, SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(process, SIGCONT);
}

} // namespace teleta::peer
