// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace teleta::test {

/// Another program with which a test exchanges lines. It is killed with the object. Thread: one.
class PeerProcess {
public:
    static constexpr int kPatience_ms = 20'000;

    ~PeerProcess() { kill(); }

    /// merged: lines of the error stream count as well.
    void start(const QString& program, const QStringList& arguments, bool merged = false) {
        m_lines.clear();
        m_process.setProcessChannelMode(merged ? QProcess::MergedChannels : QProcess::SeparateChannels);
        m_process.start(program, arguments);
    }

    /// 0: it does not run.
    [[nodiscard]] qint64 processId() const { return m_process.processId(); }

    void kill() {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        m_process.waitForFinished(kPatience_ms);
    }

    void say(const std::string& line) {
        m_process.write((line + '\n').c_str());
        m_process.waitForBytesWritten(kPatience_ms);
    }

    /// The next line that contains this text; lines before it are kept in lines(). Empty when the program
    /// ends or is silent for too long.
    [[nodiscard]] std::optional<std::string> waitFor(const std::string& text) {
        QDeadlineTimer deadline(kPatience_ms);
        for (;;) {
            while (m_process.canReadLine()) {
                const std::string line = m_process.readLine().trimmed().toStdString();
                m_lines.push_back(line);
                if (line.find(text) != std::string::npos)
                    return line;
            }
            if (deadline.hasExpired() ||
                !m_process.waitForReadyRead(static_cast<int>(deadline.remainingTime())))
                return std::nullopt;
        }
    }

    /// A line that contains this text, of those that are there; others are kept in lines(). It does not wait.
    [[nodiscard]] std::optional<std::string> poll(const std::string& text) {
        (void)m_process.waitForReadyRead(0);
        while (m_process.canReadLine()) {
            const std::string line = m_process.readLine().trimmed().toStdString();
            m_lines.push_back(line);
            if (line.find(text) != std::string::npos)
                return line;
        }
        return std::nullopt;
    }

    /// Sends a line and waits until the program answers "done".
    [[nodiscard]] bool command(const std::string& line) {
        say(line);
        return waitFor("done").has_value();
    }

    /// All lines since the last call.
    [[nodiscard]] std::vector<std::string> takeLines() { return std::exchange(m_lines, {}); }

    [[nodiscard]] std::string errors() {
        return QString::fromUtf8(m_process.readAllStandardError()).toStdString();
    }

private:
    QProcess m_process;
    std::vector<std::string> m_lines;
};

/// Whether a program runs with these arguments and exits successfully.
[[nodiscard]] inline bool runs(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished(PeerProcess::kPatience_ms) &&
           process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
}

} // namespace teleta::test
