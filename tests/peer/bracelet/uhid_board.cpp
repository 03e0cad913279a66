// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/peer/bracelet/uhid_board.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace teleta::peer {

namespace {

// Report descriptor of the README.
constexpr std::uint8_t kDescriptor[] = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26,
                                        0xFF, 0x00, 0x75, 0x08, 0x85, 0x01, 0x95, 0x0D, 0x09, 0x02,
                                        0x91, 0x02, 0x85, 0x02, 0x95, 0x07, 0x09, 0x03, 0x81, 0x02,
                                        0x85, 0x03, 0x95, 0x1C, 0x09, 0x04, 0xB1, 0x02, 0xC0};

std::int64_t now_ns() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

} // namespace

UhidBoard::UhidBoard(std::string serial, std::uint16_t productId)
    : m_serial(std::move(serial))
    , m_productId(productId) {
    if (::pipe2(m_wake.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        throw std::system_error(errno, std::generic_category(), "pipe");
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

UhidBoard::~UhidBoard() {
    m_thread.request_stop();
    [[maybe_unused]] const ssize_t woken = ::write(m_wake[1], "x", 1);
    m_thread.join();
    for (const int descriptor : m_wake)
        ::close(descriptor);
}

void UhidBoard::plugIn() {
    const std::scoped_lock lock(m_plugMutex);
    m_device.plugIn({"Bracelet of tactors", m_serial, m_productId, kDescriptor});
    m_pluggedIn = true;
}

void UhidBoard::unplug() {
    const std::scoped_lock lock(m_plugMutex);
    m_pluggedIn = false;
    m_device.unplug();
}

template <typename Send>
void UhidBoard::whilePluggedIn(const Send& send) {
    const std::scoped_lock lock(m_plugMutex);
    if (m_pluggedIn)
        send();
}

void UhidBoard::setAwake(bool awake) {
    m_awake = awake;
    [[maybe_unused]] const ssize_t woken = ::write(m_wake[1], "x", 1);
}

UhidBoard::State UhidBoard::state() const {
    const std::scoped_lock lock(m_mutex);
    return m_state;
}

void UhidBoard::forgetFrames() {
    const std::scoped_lock lock(m_mutex);
    m_state.frames.clear();
}

bool UhidBoard::forgetWhatWasWritten() {
    // The first one may have begun before.
    const int before = state().drains;
    if (!waitFor([&](const State& state) { return state.drains >= before + 2; }))
        return false;
    forgetFrames();
    return true;
}

void UhidBoard::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::int64_t wait_ms = 1000;
        {
            const std::scoped_lock lock(m_mutex);
            if (turns(m_state))
                wait_ms = std::clamp<std::int64_t>((m_timeoutAt_ns - now_ns()) / 1'000'000 + 1, 0, 1000);
        }
        pollfd files[2] = {{m_wake[0], POLLIN, 0}, {m_device.descriptor(), POLLIN, 0}};
        ::poll(files, m_awake ? 2 : 1, static_cast<int>(wait_ms));
        char dump[64];
        while (::read(m_wake[0], dump, sizeof dump) > 0) {
        }
        checkTimeout();
        if (m_awake)
            serve();
    }
}

void UhidBoard::serve() {
    uhid_event event{};
    while (m_awake && m_device.receive(event)) {
        switch (event.type) {
        case UHID_OPEN:
        case UHID_CLOSE: {
            const std::scoped_lock lock(m_mutex);
            m_state.opened = event.type == UHID_OPEN;
            ++(m_state.opened ? m_state.openings : m_state.closings);
            if (!m_state.opened && turns(m_state))
                ++m_state.closedWhileTurning;
            m_changed.notify_all();
            break;
        }
        case UHID_OUTPUT:
            takeFrame(event.u.output.data, event.u.output.size);
            break;
        case UHID_GET_REPORT:
            answerFeature(event.u.get_report.id, event.u.get_report.rnum);
            break;
        case UHID_SET_REPORT: {
            uhid_event reply{};
            reply.type = UHID_SET_REPORT_REPLY;
            reply.u.set_report_reply.id = event.u.set_report.id;
            reply.u.set_report_reply.err = EIO;
            whilePluggedIn([&] { m_device.send(reply); });
            break;
        }
        default:
            break;
        }
    }
    const std::scoped_lock lock(m_mutex);
    m_state.drains += m_awake ? 1 : 0;
    m_changed.notify_all();
}

void UhidBoard::takeFrame(const std::uint8_t* bytes, std::size_t size) {
    Frame frame{Bytes(bytes, bytes + size), now_ns()};
    if (size != 14 || bytes[0] != 1)
        return;
    bool timedOut = false;
    {
        const std::scoped_lock lock(m_mutex);
        for (int i = 0; i < 6; ++i) {
            const int low = 12 * i; // first bit of the intensity
            int value = 0;
            for (int bit = 0; bit < 12; ++bit)
                value |= (bytes[3 + (low + bit) / 8] >> ((low + bit) % 8) & 1) << bit;
            m_state.motors[static_cast<std::size_t>(i)] = value;
        }
        m_timeoutAt_ns = frame.time_ns + (bytes[12] + 256 * bytes[13]) * std::int64_t{1'000'000};
        m_state.frames.push_back(frame);
        timedOut = std::exchange(m_timedOut, false);
        m_changed.notify_all();
    }
    answer(frame, timedOut);
}

void UhidBoard::answer(const Frame& frame, bool timedOut) {
    const bool on =
        std::any_of(frame.bytes.begin() + 3, frame.bytes.begin() + 12, [](int b) { return b != 0; });
    const std::uint8_t report[8] = {
        2,    frame.bytes[1], frame.bytes[2], static_cast<std::uint8_t>((on ? 1 : 0) | (timedOut ? 2 : 0)),
        0x24, // 4900 mV
        0x13,
        0x37, // 31.1 degrees
        0x01};
    whilePluggedIn([&] { m_device.sendInput(report); });
}

void UhidBoard::answerFeature(std::uint32_t request, std::uint8_t report) {
    uhid_event event{};
    event.type = UHID_GET_REPORT_REPLY;
    uhid_get_report_reply_req& reply = event.u.get_report_reply;
    reply.id = request;
    if (report == 3) {
        const std::uint8_t head[6] = {3, 1, 0x2A, 0x00, 1, 9};
        const std::uint8_t tail[7] = {6, 0xFF, 0x0F, 0xF4, 0x01, 0x10, 0x27}; // 4095, 500 Hz, 10 s
        std::copy(std::begin(head), std::end(head), reply.data);
        std::copy(m_serial.begin(), m_serial.end(), reply.data + 6);
        std::copy(std::begin(tail), std::end(tail), reply.data + 22);
        reply.size = 29;
    } else {
        reply.err = EIO;
    }
    whilePluggedIn([&] { m_device.send(event); });
}

void UhidBoard::checkTimeout() {
    const std::scoped_lock lock(m_mutex);
    if (!turns(m_state) || now_ns() < m_timeoutAt_ns)
        return;
    m_state.motors = {};
    ++m_state.timeouts;
    m_state.timedOutAt_ns = now_ns();
    m_timedOut = true;
    m_changed.notify_all();
}

} // namespace teleta::peer
