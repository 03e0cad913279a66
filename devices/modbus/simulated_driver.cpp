// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/simulated_driver.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <memory>
#include <modbus/modbus.h>
#include <netinet/in.h>
#include <poll.h>
#include <stop_token>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::modbus {

namespace {

struct DriverText {
    Q_DECLARE_TR_FUNCTIONS(DriverText)
};

constexpr int kTableSize = 65536;
constexpr int kFunctionOffset = 7; ///< of the function code in a message over TCP
constexpr auto kLook = std::chrono::milliseconds(2);

struct FreeContext {
    void operator()(modbus_t* context) const { modbus_free(context); }
};
struct FreeMapping {
    void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
};

core::Unexpected noServer() {
    return core::failed(
        core::ErrorKind::unavailable,
        DriverText::tr("the simulated motor driver cannot open a port: %1").arg(modbus_strerror(errno)));
}

class Server : public SimulatedDriver {
public:
    Server(RegisterMap map, std::chrono::milliseconds watchdog)
        : m_map(std::move(map))
        , m_motors(*m_map.tactors)
        , m_off(tactorWords(m_motors, {}))
        , m_watchdog_ns(std::chrono::nanoseconds(watchdog).count()) {}
    ~Server() override {
        m_thread = {};
        for (const int socket : m_clients)
            close(socket);
        if (m_listener >= 0)
            close(m_listener);
    }

    [[nodiscard]] core::Expected<void> open() {
        m_context.reset(modbus_new_tcp("127.0.0.1", 0));
        m_mapping.reset(modbus_mapping_new(0, 0, kTableSize, kTableSize));
        if (!m_context || !m_mapping)
            return noServer();
        modbus_set_slave(m_context.get(), m_map.server);
        constexpr int kWaiting = 8;
        m_listener = modbus_tcp_listen(m_context.get(), kWaiting);
        sockaddr_in address{};
        socklen_t length = sizeof address;
        if (m_listener < 0 || getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &length) != 0)
            return noServer();
        m_port = ntohs(address.sin_port);
        // A request whose end does not come must not hold up the watchdog.
        constexpr std::uint32_t kLongestRequest_us = 5'000;
        modbus_set_byte_timeout(m_context.get(), 0, kLongestRequest_us);
        modbus_set_indication_timeout(m_context.get(), 0, kLongestRequest_us);
        turnOff();
        m_alive_ns = core::steadyNow_ns();
        m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
        return {};
    }

    [[nodiscard]] std::uint16_t port() const override { return m_port; }
    [[nodiscard]] std::uint64_t timeouts() const override {
        return m_timeouts.load(std::memory_order_relaxed);
    }

private:
    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::vector<pollfd> waits{{m_listener, POLLIN, 0}};
            for (const int socket : m_clients)
                waits.push_back({socket, POLLIN, 0});
            if (poll(waits.data(), waits.size(), static_cast<int>(kLook.count())) > 0) {
                // In front of the answers: those of the first ones may take the others' time.
                for (std::size_t k = 1; k < waits.size(); ++k)
                    if (waits[k].revents != 0 && !serve(waits[k].fd))
                        leave(waits[k].fd);
                if (waits.front().revents != 0)
                    welcome();
            }
            watch();
        }
    }

    void welcome() {
        const int socket = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket >= 0)
            m_clients.push_back(socket);
    }

    void leave(int socket) {
        close(socket);
        std::erase(m_clients, socket);
    }

    /// Answers one request. False: the connection is over.
    [[nodiscard]] bool serve(int socket) {
        modbus_set_socket(m_context.get(), socket);
        std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
        const int length = modbus_receive(m_context.get(), request.data());
        if (length < 0)
            return false;
        if (length == 0)
            return true; // for another server
        const auto function = request.at(kFunctionOffset);
        const std::uint16_t before =
            m_map.watchdogAddress ? m_mapping->tab_registers[*m_map.watchdogAddress] : std::uint16_t{0};
        if (modbus_reply(m_context.get(), request.data(), length, m_mapping.get()) < 0)
            return false;
        const bool wrote =
            function == MODBUS_FC_WRITE_SINGLE_REGISTER || function == MODBUS_FC_WRITE_MULTIPLE_REGISTERS;
        const bool alive =
            m_map.watchdogAddress ? m_mapping->tab_registers[*m_map.watchdogAddress] != before : wrote;
        if (alive) {
            m_alive_ns = core::steadyNow_ns();
            setTimedOut(false);
        }
        return true;
    }

    void watch() {
        if (core::steadyNow_ns() - m_alive_ns < m_watchdog_ns)
            return;
        if (isOn()) {
            turnOff();
            setTimedOut(true);
            m_timeouts.fetch_add(1, std::memory_order_relaxed);
        }
    }

    [[nodiscard]] bool isOn() const {
        return !std::equal(m_off.begin(), m_off.end(), m_mapping->tab_registers + m_motors.address);
    }
    void turnOff() { std::ranges::copy(m_off, m_mapping->tab_registers + m_motors.address); }

    void setTimedOut(bool timedOut) {
        if (!m_map.status || !m_map.status->timedOutBit)
            return;
        const InputRegister& status = m_map.status->input;
        std::uint16_t* table = status.table == RegisterTable::holding ? m_mapping->tab_registers
                                                                      : m_mapping->tab_input_registers;
        const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(*m_map.status->timedOutBit));
        auto& word = table[status.address];
        word = static_cast<std::uint16_t>(timedOut ? word | bit : word & ~bit);
    }

    RegisterMap m_map;
    const TactorRegisters& m_motors;
    std::vector<std::uint16_t> m_off;
    std::int64_t m_watchdog_ns;
    std::unique_ptr<modbus_t, FreeContext> m_context;
    std::unique_ptr<modbus_mapping_t, FreeMapping> m_mapping;
    int m_listener = -1;
    std::uint16_t m_port = 0;
    std::vector<int> m_clients;  ///< of the thread
    std::int64_t m_alive_ns = 0; ///< of the thread
    std::atomic<std::uint64_t> m_timeouts{0};
    std::jthread m_thread; ///< last, so that it ends first
};

} // namespace

core::Expected<std::unique_ptr<SimulatedDriver>> SimulatedDriver::start(const RegisterMap& map,
                                                                        std::chrono::milliseconds watchdog) {
    if (!map.tactors)
        return core::failed(core::ErrorKind::badInput, DriverText::tr("the device has no motors"));
    auto server = std::make_unique<Server>(map, watchdog);
    TELETA_CHECK(server->open());
    return std::unique_ptr<SimulatedDriver>(std::move(server));
}

} // namespace teleta::modbus
