// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/link/shared_web_socket.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/link/link_text.h"
#include "devices/link/web_socket.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace teleta::link {

namespace {

/// More than that wait only when nobody reads.
constexpr std::size_t kMostShared = 1024;

using Message = std::shared_ptr<const std::vector<std::uint8_t>>;

} // namespace

struct SharedWebSocket::Reader {
    WakePipe ready; ///< awake while there is something to look at
    std::mutex mutex;
    std::deque<Message> messages;
    bool isOpen = false;
    std::optional<core::Error> end; ///< of the connection
    std::atomic<std::uint64_t> leftOut{0};
};

class SharedWebSocket::Connection {
public:
    explicit Connection(WebAddress address)
        : m_address(std::move(address)) {}
    ~Connection() {
        m_thread.request_stop();
        m_wake.wake();
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Once.
    void start(std::int64_t deadline_ns) {
        m_thread = std::jthread([this, deadline_ns](const std::stop_token& stop) { run(stop, deadline_ns); });
    }
    /// False: it has ended, and takes no reader any more.
    [[nodiscard]] bool add(const std::shared_ptr<Reader>& reader) {
        const std::scoped_lock lock(m_mutex);
        if (m_hasEnded)
            return false;
        reader->isOpen = m_isOpen;
        m_readers.push_back(reader);
        return true;
    }
    void remove(const std::shared_ptr<Reader>& reader) {
        const std::scoped_lock lock(m_mutex);
        std::erase(m_readers, reader);
    }

private:
    template <typename Change>
    void tell(Change change) {
        const std::scoped_lock lock(m_mutex);
        for (const auto& reader : m_readers) {
            {
                const std::scoped_lock own(reader->mutex);
                change(*reader);
            }
            reader->ready.wake();
        }
    }
    void end(core::Error error) {
        const std::scoped_lock lock(m_mutex);
        m_hasEnded = true;
        for (const auto& reader : m_readers) {
            {
                const std::scoped_lock own(reader->mutex);
                reader->end = error;
            }
            reader->ready.wake();
        }
    }

    void run(const std::stop_token& stop, std::int64_t deadline_ns) {
        auto socket = WebSocket::open(m_address, deadline_ns, &m_wake);
        if (!socket) {
            end(std::move(socket).error());
            return;
        }
        {
            const std::scoped_lock lock(m_mutex);
            m_isOpen = true;
        }
        tell([](Reader& reader) { reader.isOpen = true; });
        std::vector<std::uint8_t> buffer(WebSocket::kLongestMessage);
        std::uint64_t leftOut = 0;
        while (!stop.stop_requested()) {
            std::size_t count = 0;
            const Outcome outcome = socket->read(
                buffer, count, core::steadyNow_ns() + std::int64_t{m_address.shared_ms} * 1'000'000, &m_wake);
            const std::uint64_t more = socket->leftOut() - std::exchange(leftOut, socket->leftOut());
            if (more > 0)
                tell([more](Reader& reader) { reader.leftOut += more; });
            if (outcome == Outcome::woken)
                continue;
            if (outcome != Outcome::done) {
                end({core::ErrorKind::unavailable,
                     outcome == Outcome::gone ? socket->goneReason()
                                              : LinkText::tr("The server has sent nothing for %1 s.")
                                                    .arg(m_address.shared_ms / 1000)
                                                    .toStdString(),
                     {},
                     {}});
                return;
            }
            const auto message = std::make_shared<const std::vector<std::uint8_t>>(
                buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count));
            tell([&message](Reader& reader) {
                if (reader.messages.size() >= kMostShared)
                    reader.messages.pop_front();
                reader.messages.push_back(message);
            });
        }
    }

    WebAddress m_address;
    WakePipe m_wake;
    std::mutex m_mutex;
    std::vector<std::shared_ptr<Reader>> m_readers;
    bool m_isOpen = false;
    bool m_hasEnded = false;
    std::jthread m_thread; ///< ends before what it uses
};

SharedWebSocket::SharedWebSocket(std::shared_ptr<Connection> connection, std::shared_ptr<Reader> reader)
    : m_connection(std::move(connection))
    , m_reader(std::move(reader)) {
}
SharedWebSocket::SharedWebSocket(SharedWebSocket&& other) noexcept = default;

SharedWebSocket& SharedWebSocket::operator=(SharedWebSocket&& other) noexcept {
    std::swap(m_connection, other.m_connection);
    std::swap(m_reader, other.m_reader);
    std::swap(m_goneReason, other.m_goneReason);
    return *this;
}

SharedWebSocket::~SharedWebSocket() {
    if (m_connection)
        m_connection->remove(m_reader);
}

core::Expected<SharedWebSocket> SharedWebSocket::open(const WebAddress& address, std::int64_t deadline_ns,
                                                      const WakePipe* wake) {
    static std::mutex mutex;
    static std::map<std::pair<std::string, bool>, std::weak_ptr<Connection>> connections;
    auto reader = std::make_shared<Reader>();
    std::shared_ptr<Connection> connection;
    {
        const std::scoped_lock lock(mutex);
        auto& known = connections[{address.url, address.textsOnly}];
        connection = known.lock();
        if (!connection || !connection->add(reader)) {
            connection = std::make_shared<Connection>(address);
            known = connection;
            (void)connection->add(reader);
            connection->start(deadline_ns);
        }
    }
    SharedWebSocket shared(std::move(connection), reader);
    for (;;) {
        {
            const std::scoped_lock lock(reader->mutex);
            if (reader->isOpen)
                return shared;
            if (reader->end)
                return core::Unexpected(*reader->end);
            reader->ready.clear();
        }
        std::array<pollfd, 2> polled{pollfd{reader->ready.descriptor(), POLLIN, 0},
                                     pollfd{wake != nullptr ? wake->descriptor() : -1, POLLIN, 0}};
        const int ready = pollUntil(polled, deadline_ns);
        if (polled[1].revents != 0)
            return core::failed(core::ErrorKind::cancelled, LinkText::tr("connecting was cancelled"));
        if (ready <= 0)
            return core::failed(core::ErrorKind::unavailable,
                                LinkText::tr("cannot connect to %1: %2")
                                    .arg(QString::fromStdString(address.url), LinkText::tr("no answer")));
    }
}

Outcome SharedWebSocket::read(std::span<std::uint8_t> buffer, std::size_t& count, std::int64_t deadline_ns,
                              const WakePipe* wake) {
    count = 0;
    for (;;) {
        {
            const std::scoped_lock lock(m_reader->mutex);
            if (!m_reader->messages.empty()) {
                const Message message = std::move(m_reader->messages.front());
                m_reader->messages.pop_front();
                count = std::min(buffer.size(), message->size());
                std::copy_n(message->begin(), count, buffer.begin());
                return Outcome::done;
            }
            if (m_reader->end) {
                m_goneReason = m_reader->end->message;
                return Outcome::gone;
            }
            m_reader->ready.clear();
        }
        std::array<pollfd, 2> polled{pollfd{m_reader->ready.descriptor(), POLLIN, 0},
                                     pollfd{wake != nullptr ? wake->descriptor() : -1, POLLIN, 0}};
        const int ready = pollUntil(polled, deadline_ns);
        if (polled[1].revents != 0)
            return Outcome::woken;
        if (ready <= 0)
            return Outcome::timedOut;
    }
}

std::uint64_t SharedWebSocket::leftOut() const {
    return m_reader->leftOut;
}

} // namespace teleta::link
