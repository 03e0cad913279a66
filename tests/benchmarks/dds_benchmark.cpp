// SPDX-License-Identifier: GPL-3.0-or-later
// Joint states of an arm of seven joints, 1000 a second, to another process on this computer and back, and
// pictures of 640 x 480 in colour, 30 a second, one way. Through our readers and writers, plain and with
// keys; beside them the same number of bytes through bare UDP sockets in the same run.
//   dds_benchmark [SECONDS]      default: 20
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "backend/ros/messages.h"
#include "backend/ros/qos_profile.h"
#include "backend/site_keys/site_keys.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <netinet/in.h>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

using namespace teleta;

constexpr int kDomain = 200;
constexpr std::size_t kJoints = 7;
constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr std::int64_t kPicturePeriod_ns = 33'333'333;
constexpr std::size_t kPictureBytes = 640 * 480 * 3;
/// A message of seven joints with names and header, as it is on the wire.
constexpr std::size_t kDatagram = 392;
constexpr const char* kOut = "rt/teleta/lab/console/console1/benchmark";
constexpr const char* kBack = "rt/teleta/lab/benchmark";
constexpr const char* kPictures = "rt/teleta/lab/image/benchmark";
/// At 1 kHz a thread that sleeps for some ms must not lose samples.
constexpr int kDepth = 64;

double cpu_s(const rusage& used) {
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double ownCpu_s() {
    rusage used{};
    (void)getrusage(RUSAGE_SELF, &used);
    return cpu_s(used);
}

struct Result {
    std::vector<double> delays_s;
    std::size_t sent = 0;
    double time_s = 0.0;
    double cpuHere_s = 0.0;
    double cpuThere_s = 0.0;
};

void print(const char* what, Result result) {
    std::ranges::sort(result.delays_s);
    if (result.delays_s.empty()) {
        std::printf("%-28s nothing came\n", what);
        return;
    }
    std::printf(
        "%-28s median %6.3f ms  99 %% %6.3f ms  most %7.3f ms  lost %zu of %zu  of a core %4.1f %% and "
        "%4.1f %%\n",
        what, 1e3 * core::quantileOf(result.delays_s, 0.5), 1e3 * core::quantileOf(result.delays_s, 0.99),
        1e3 * result.delays_s.back(), result.sent - std::min(result.sent, result.delays_s.size()),
        result.sent, 100.0 * result.cpuHere_s / result.time_s, 100.0 * result.cpuThere_s / result.time_s);
}

/// Calls it at each period, with the number of the call, until the time is over.
template <typename Send>
void pace(double time_s, std::int64_t period_ns, const Send& send) {
    const std::int64_t start_ns = core::steadyNow_ns();
    const auto count = static_cast<std::size_t>(1e9 * time_s / static_cast<double>(period_ns));
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t due_ns = start_ns + static_cast<std::int64_t>(i) * period_ns;
        const std::int64_t wait_ns = due_ns - core::steadyNow_ns();
        if (wait_ns > 0)
            std::this_thread::sleep_for(std::chrono::nanoseconds(wait_ns));
        send(i);
    }
}

/// A process of its own that runs it until its end of the pipe is closed.
class OtherProcess {
public:
    template <typename Run>
    explicit OtherProcess(const Run& run) {
        if (pipe(m_pipe.data()) != 0)
            std::exit(1);
        m_id = fork();
        if (m_id == 0) {
            close(m_pipe[1]);
            std::atomic<bool> ended = false;
            std::thread watch([&] {
                char byte = 0;
                (void)!read(m_pipe[0], &byte, 1);
                ended = true;
            });
            (void)core::makeThreadUrgent();
            run(ended);
            watch.join();
            _exit(0);
        }
        close(m_pipe[0]);
    }
    /// The processor time that it used.
    double end() {
        close(m_pipe[1]);
        rusage used{};
        (void)wait4(m_id, nullptr, 0, &used);
        return cpu_s(used);
    }

private:
    std::array<int, 2> m_pipe{};
    pid_t m_id = 0;
};

struct Keys {
    std::string site;
    std::string console;
};

std::shared_ptr<const dds::Participant> join(const std::string& keys, int domain) {
    const dds::DomainConfig config{domain, "lo", {"127.0.0.1"}};
    auto joined =
        dds::Participant::open(config, {}, keys.empty() ? std::nullopt : std::optional(dds::Security{keys}));
    if (!joined) {
        std::fprintf(stderr, "dds_benchmark: %s\n", core::describe(joined.error()).c_str());
        _exit(1);
    }
    return *joined;
}

template <typename T>
T opened(core::Expected<T> end) {
    if (!end) {
        std::fprintf(stderr, "dds_benchmark: %s\n", core::describe(end.error()).c_str());
        _exit(1);
    }
    return std::move(*end);
}

/// One of seven joints that carries its number in its stamp.
struct SevenJoints {
    SevenJoints() {
        for (std::size_t i = 0; i < kJoints; ++i) {
            names[i] = "joint_" + std::to_string(i + 1);
            pointers[i] = names[i].data();
        }
        message.header.frame_id = none.data();
        ros::lend(message.name, std::span(pointers));
        ros::lend(message.position, std::span(values));
        ros::lend(message.velocity, std::span(values));
        ros::lend(message.effort, std::span(values));
    }
    std::array<std::string, kJoints> names;
    std::array<char*, kJoints> pointers{};
    std::array<double, kJoints> values{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
    std::array<char, 1> none{};
    ros::JointState message{};
};

Result jointsThereAndBack(double time_s, const Keys& keys, int domain) {
    OtherProcess other([&](const std::atomic<bool>& ended) {
        const auto participant = join(keys.site, domain);
        auto reader = opened(
            dds::Reader<ros::JointState>::open(participant, kOut, ros::kSensorReader.withDepth(kDepth)));
        auto writer = opened(dds::Writer<ros::JointState>::open(participant, kBack, ros::kSensorWriter));
        dds::WaitSet wait(participant);
        wait.attach(reader);
        while (!ended) {
            wait.wait(100'000'000);
            (void)reader.take(
                [&](const ros::JointState& message, const dds::SampleInfo&) { (void)writer.write(message); });
        }
    });
    const auto participant = join(keys.console, domain);
    auto writer = opened(dds::Writer<ros::JointState>::open(participant, kOut, ros::kSensorWriter));
    auto reader =
        opened(dds::Reader<ros::JointState>::open(participant, kBack, ros::kSensorReader.withDepth(kDepth)));
    while (writer.matched() == 0 || reader.matched() == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));

    const auto count = static_cast<std::size_t>(1e9 * time_s / static_cast<double>(kPeriod_ns));
    std::vector<std::atomic<std::int64_t>> sent_ns(count);
    Result result;
    std::atomic<bool> ended = false;
    const double before_s = ownCpu_s();
    const std::int64_t begin_ns = core::steadyNow_ns();
    std::thread receiver([&] {
        (void)core::makeThreadUrgent();
        dds::WaitSet wait(participant);
        wait.attach(reader);
        while (!ended) {
            wait.wait(100'000'000);
            (void)reader.take([&](const ros::JointState& message, const dds::SampleInfo&) {
                const std::int64_t now_ns = core::steadyNow_ns();
                const auto number = static_cast<std::size_t>(message.header.stamp.sec);
                if (number < count)
                    result.delays_s.push_back(1e-9 * static_cast<double>(now_ns - sent_ns[number]));
            });
        }
    });
    (void)core::makeThreadUrgent();
    SevenJoints joints;
    pace(time_s, kPeriod_ns, [&](std::size_t number) {
        joints.message.header.stamp.sec = static_cast<std::int32_t>(number);
        sent_ns[number] = core::steadyNow_ns();
        (void)writer.write(joints.message);
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ended = true;
    receiver.join();
    result.sent = count;
    result.time_s = 1e-9 * static_cast<double>(core::steadyNow_ns() - begin_ns);
    result.cpuHere_s = ownCpu_s() - before_s;
    result.cpuThere_s = other.end();
    return result;
}

Result picturesThere(double time_s, const Keys& keys, int domain) {
    OtherProcess other([&](const std::atomic<bool>& ended) {
        const auto participant = join(keys.site, domain);
        auto writer =
            opened(dds::Writer<ros::Image>::open(participant, kPictures, ros::kSensorWriter.withDepth(1)));
        while (writer.matched() == 0 && !ended)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        std::vector<std::uint8_t> bytes(kPictureBytes, 128);
        std::array<char, 1> none{};
        std::array<char, 5> encoding{'r', 'g', 'b', '8', 0};
        ros::Image image{};
        image.header.frame_id = none.data();
        image.encoding = encoding.data();
        image.width = 640;
        image.height = 480;
        image.step = 3 * 640;
        ros::lend(image.data, std::span(bytes));
        pace(time_s, kPicturePeriod_ns, [&](std::size_t) {
            const std::int64_t now_ns = core::steadyNow_ns(); // of the whole computer
            image.header.stamp.sec = static_cast<std::int32_t>(now_ns / 1'000'000'000);
            image.header.stamp.nanosec = static_cast<std::uint32_t>(now_ns % 1'000'000'000);
            (void)writer.write(image);
        });
        while (!ended)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
    });
    const auto participant = join(keys.console, domain);
    auto reader = opened(dds::Reader<ros::Image>::open(participant, kPictures, ros::kSensorReader));
    dds::WaitSet wait(participant);
    wait.attach(reader);
    (void)core::makeThreadUrgent();
    Result result;
    result.sent = static_cast<std::size_t>(1e9 * time_s / static_cast<double>(kPicturePeriod_ns));
    const double before_s = ownCpu_s();
    const std::int64_t begin_ns = core::steadyNow_ns();
    while (result.delays_s.size() < result.sent &&
           core::steadyNow_ns() - begin_ns < static_cast<std::int64_t>(1e9 * (time_s + 5.0))) {
        wait.wait(100'000'000);
        (void)reader.take([&](const ros::Image& image, const dds::SampleInfo&) {
            const std::int64_t sent_ns =
                std::int64_t{image.header.stamp.sec} * 1'000'000'000 + image.header.stamp.nanosec;
            result.delays_s.push_back(1e-9 * static_cast<double>(core::steadyNow_ns() - sent_ns));
        });
    }
    result.time_s = 1e-9 * static_cast<double>(core::steadyNow_ns() - begin_ns);
    result.cpuHere_s = ownCpu_s() - before_s;
    result.cpuThere_s = other.end();
    return result;
}

int boundSocket(sockaddr_in& address) {
    const int bound = socket(AF_INET, SOCK_DGRAM, 0);
    address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    if (bound < 0 || bind(bound, reinterpret_cast<sockaddr*>(&address), length) != 0 ||
        getsockname(bound, reinterpret_cast<sockaddr*>(&address), &length) != 0)
        std::exit(1);
    timeval longest{0, 100'000};
    (void)setsockopt(bound, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
    return bound;
}

/// The least that a packet of this size takes.
Result datagramsThereAndBack(double time_s) {
    sockaddr_in here{};
    sockaddr_in there{};
    const int ours = boundSocket(here);
    const int theirs = boundSocket(there);
    OtherProcess other([&](const std::atomic<bool>& ended) {
        std::array<char, kDatagram> bytes{};
        while (!ended) {
            const ssize_t came = recv(theirs, bytes.data(), bytes.size(), 0);
            if (came > 0)
                (void)sendto(theirs, bytes.data(), static_cast<std::size_t>(came), 0,
                             reinterpret_cast<const sockaddr*>(&here), sizeof here);
        }
    });
    Result result;
    std::atomic<bool> ended = false;
    const double before_s = ownCpu_s();
    const std::int64_t begin_ns = core::steadyNow_ns();
    std::thread receiver([&] {
        (void)core::makeThreadUrgent();
        std::array<char, kDatagram> bytes{};
        while (!ended) {
            if (recv(ours, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
                continue;
            std::int64_t sent_ns = 0;
            std::copy_n(bytes.data(), sizeof sent_ns, reinterpret_cast<char*>(&sent_ns));
            result.delays_s.push_back(1e-9 * static_cast<double>(core::steadyNow_ns() - sent_ns));
        }
    });
    (void)core::makeThreadUrgent();
    std::array<char, kDatagram> bytes{};
    pace(time_s, kPeriod_ns, [&](std::size_t) {
        const std::int64_t now_ns = core::steadyNow_ns();
        std::copy_n(reinterpret_cast<const char*>(&now_ns), sizeof now_ns, bytes.data());
        (void)sendto(ours, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&there),
                     sizeof there);
        ++result.sent;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    ended = true;
    receiver.join();
    result.time_s = 1e-9 * static_cast<double>(core::steadyNow_ns() - begin_ns);
    result.cpuHere_s = ownCpu_s() - before_s;
    result.cpuThere_s = other.end();
    close(ours);
    close(theirs);
    return result;
}

/// Each in a process of its own: the middleware keeps the keys of a domain until its program ends.
void alone(const std::function<void()>& run) {
    std::fflush(stdout);
    const pid_t id = fork();
    if (id == 0) {
        run();
        std::fflush(stdout);
        _exit(0);
    }
    (void)waitpid(id, nullptr, 0);
}

} // namespace

int main(int count, char** arguments) {
    const double time_s = count > 1 ? std::atof(arguments[1]) : 20.0;
    if (!(time_s > 0.0)) {
        std::fprintf(stderr, "Usage: dds_benchmark [SECONDS]\n");
        return 2;
    }
    const QCoreApplication application(count, arguments);
    const QTemporaryDir folder;
    const auto commands = site_keys::commandsFor({.folder = folder.filePath("keys").toStdString(),
                                                  .site = "lab",
                                                  .consoles = {"console1"},
                                                  .viewers = {}},
                                                 std::time(nullptr));
    if (!commands || std::system(("{ " + *commands + "\n} >/dev/null 2>&1").c_str()) != 0) {
        std::fprintf(stderr, "dds_benchmark: the keys could not be made (is openssl installed?)\n");
        return 1;
    }
    const Keys none;
    const Keys keys{folder.filePath("keys/site").toStdString(),
                    folder.filePath("keys/console1").toStdString()};
    alone([&] { print("392 bytes, UDP", datagramsThereAndBack(time_s)); });
    alone([&] { print("7 joints, DDS", jointsThereAndBack(time_s, none, kDomain)); });
    alone([&] { print("7 joints, DDS with keys", jointsThereAndBack(time_s, keys, kDomain + 1)); });
    alone([&] { print("picture of 0.92 MB, DDS", picturesThere(time_s, none, kDomain + 2)); });
    alone([&] { print("picture of 0.92 MB, with keys", picturesThere(time_s, keys, kDomain + 3)); });
    return 0;
}
