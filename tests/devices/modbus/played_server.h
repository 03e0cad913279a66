// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/modbus/register_link.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace teleta::test {

/// A Modbus server that a test plays: registers, the answers to the next requests, and what was written.
/// Thread: any.
class PlayedServer {
public:
    struct Write {
        std::uint16_t address = 0;
        std::vector<std::uint16_t> words;
        bool answered = true;
        bool operator==(const Write&) const = default;
    };

    void set(std::uint16_t address, std::uint16_t word) {
        const std::scoped_lock lock(m_mutex);
        m_words[address] = word;
    }
    /// The next requests are answered like this, one each; then all is well again.
    void answerNext(std::initializer_list<modbus::Answer> answers) {
        const std::scoped_lock lock(m_mutex);
        m_answers.insert(m_answers.end(), answers);
    }
    void setReachable(bool reachable) {
        const std::scoped_lock lock(m_mutex);
        m_reachable = reachable;
    }
    /// Called in every request, for a clock that moves meanwhile.
    void onRequest(std::function<void()> action) {
        const std::scoped_lock lock(m_mutex);
        m_onRequest = std::move(action);
    }
    [[nodiscard]] int connections() const {
        const std::scoped_lock lock(m_mutex);
        return m_connections;
    }
    std::vector<Write> takeWrites() {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_writes, {});
    }
    [[nodiscard]] int reads() const {
        const std::scoped_lock lock(m_mutex);
        return m_reads;
    }

    /// The server must outlive the links.
    [[nodiscard]] modbus::LinkOpener opener() {
        return [this]() -> core::Expected<std::unique_ptr<modbus::RegisterLink>> {
            const std::scoped_lock lock(m_mutex);
            if (!m_reachable)
                return core::Unexpected(core::Error{core::ErrorKind::unavailable, "nobody listens", {}, {}});
            ++m_connections;
            return std::make_unique<Link>(*this);
        };
    }

private:
    class Link : public modbus::RegisterLink {
    public:
        explicit Link(PlayedServer& server)
            : m_server(server) {}
        [[nodiscard]] modbus::Answer write(std::uint16_t address,
                                           std::span<const std::uint16_t> words) override {
            const std::scoped_lock lock(m_server.m_mutex);
            const modbus::Answer answer = m_server.nextAnswer();
            if (answer.done())
                m_server.m_writes.push_back({address, {words.begin(), words.end()}});
            return answer;
        }
        void writeUnanswered(std::uint16_t address, std::span<const std::uint16_t> words) override {
            const std::scoped_lock lock(m_server.m_mutex);
            m_server.m_writes.push_back({address, {words.begin(), words.end()}, false});
        }
        [[nodiscard]] modbus::Answer read(modbus::RegisterTable /*table*/, std::uint16_t address,
                                          std::span<std::uint16_t> words) override {
            const std::scoped_lock lock(m_server.m_mutex);
            ++m_server.m_reads;
            const modbus::Answer answer = m_server.nextAnswer();
            if (!answer.done())
                return answer;
            for (std::uint16_t& word : words)
                word = m_server.m_words[address++];
            return {};
        }
        [[nodiscard]] std::uint64_t lateAnswers() const override { return 0; }

    private:
        PlayedServer& m_server;
    };

    modbus::Answer nextAnswer() {
        if (m_onRequest)
            m_onRequest();
        if (m_answers.empty())
            return {};
        const modbus::Answer answer = m_answers.front();
        m_answers.pop_front();
        return answer;
    }

    mutable std::mutex m_mutex;
    std::map<std::uint16_t, std::uint16_t> m_words;
    std::deque<modbus::Answer> m_answers;
    std::vector<Write> m_writes;
    std::function<void()> m_onRequest;
    bool m_reachable = true;
    int m_connections = 0;
    int m_reads = 0;
};

} // namespace teleta::test
