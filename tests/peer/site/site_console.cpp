// SPDX-License-Identifier: GPL-3.0-or-later
// A console at a site with one arm, in a process of its own.
//   site_console FILE
// Lines that it takes: request, release, offer NAME, accept, press RATE, let_go, mouse RATE (a 3D mouse whose
// cap is pushed to the end, with its button held), unplug (the mouse), freeze, stop, withdraw (its own STOP),
// count (from here on), tell, end. To "tell" it answers with a line of JSON.
#include "backend/core/steady_time.h"
#include "devices/site/remote/remote_array.h"
#include "devices/site/site_streams.h"
#include "tests/devices/mouse3d/played_mouse.h"
#include "tests/peer/site/site_process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

using namespace teleta;

namespace {

/// What came of a stream since the last count.
struct Counted {
    std::uint64_t samples = 0;
    std::uint64_t lost = 0;
    double first_s = 0.0; ///< of the stream's own time
    double last_s = 0.0;

    void add(double time_s) {
        first_s = samples == 0 ? time_s : first_s;
        last_s = time_s;
        ++samples;
    }
    [[nodiscard]] nlohmann::json json() const {
        return {{"samples", samples}, {"lost", lost}, {"span_s", last_s - first_s}};
    }
};

class Console {
public:
    explicit Console(const std::string& file)
        : m_console(file)
        , m_array(openArray())
        , m_states(*dds::Reader<ros::SiteState>::open(
              m_console.client().participant(), m_console.client().topics().state(), site_link::kState)) {
        m_array->start(m_wakeup);
        m_reader.start(m_wakeup);
    }
    ~Console() { m_array->stop(); }

    void look() {
        for (const core::JointSample& sample : m_console.takeSamples())
            m_joints.add(sample.sourceTime_s);
        for (core::SampleBlock block; m_array->blocks().pop(block);) {
            for (const double time_s : block.sourceTime_s)
                m_frames.add(time_s);
        }
        (void)m_states.take([this](const ros::SiteState& state, const dds::SampleInfo&) {
            m_told.add(static_cast<double>(state.site_ns) * 1e-9);
        });
    }

    bool obey(const std::string& line) {
        std::istringstream words(line);
        std::string what;
        std::string about;
        words >> what >> about;
        using site::RequestKind;
        if (what == "request")
            m_console.request(RequestKind::request);
        else if (what == "release")
            m_console.request(RequestKind::release);
        else if (what == "offer")
            m_console.request(RequestKind::offer, about);
        else if (what == "accept")
            m_console.request(RequestKind::accept);
        else if (what == "press")
            m_console.press(std::stod(about));
        else if (what == "let_go")
            m_console.letGo();
        else if (what == "mouse")
            pushMouse(std::stod(about));
        else if (what == "unplug")
            m_mouse.plug(false);
        else if (what == "freeze")
            m_console.freeze();
        else if (what == "stop")
            m_console.stop().engage();
        else if (what == "withdraw")
            m_console.stop().release();
        else if (what == "count")
            count();
        else if (what == "tell")
            std::cout << tell() << std::endl;
        return what != "end";
    }

private:
    [[nodiscard]] std::unique_ptr<site_link::RemoteArray> openArray() {
        for (const recording::StreamInfo& stream : m_console.client().streams()) {
            if (stream.kind == recording::StreamKind::array)
                return *site_link::RemoteArray::open(m_console.sharedClient(), site_link::deviceOf(stream),
                                                     pipeline::recordedArray(stream, "lab")->description);
        }
        return nullptr;
    }
    /// The reports of a cap that is held come without pause, as from a real one.
    void pushMouse(double rate_radPerS) {
        m_pushing = {};
        m_mouse.plug(true);
        m_mouse.send({test::kReleased, test::kPressed});
        m_pushing = std::jthread([this](const std::stop_token& stop) {
            for (; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(8)))
                m_mouse.send({test::kRight});
        });
        m_console.pressBy([this, rate_radPerS] {
            const mouse3d::SixAxes motion = m_reader.motion();
            return rate_radPerS *
                   std::ranges::max(motion.translation, {}, [](double axis) { return std::abs(axis); });
        });
    }
    void count() {
        m_joints = m_frames = m_told = {};
        m_jointsLost = m_console.armStatus().framesLost;
        m_framesLost = framesLost();
    }
    /// On the way.
    [[nodiscard]] std::uint64_t framesLost() const {
        const std::uint64_t atSite = m_array->lostAtSite();
        return m_array->status().framesLost - atSite;
    }
    [[nodiscard]] nlohmann::json tell() {
        const site_link::SiteView view = m_console.view();
        m_joints.lost = m_console.armStatus().framesLost - m_jointsLost;
        m_frames.lost = framesLost() - m_framesLost;
        return {{"reached", view.reached},          {"mode", static_cast<int>(view.mode)},
                {"controller", view.controller},    {"offered_to", view.offeredTo},
                {"controls", m_console.controls()}, {"epoch", view.epoch},
                {"stop_holders", view.stopHolders}, {"accepted", view.accepted},
                {"refused", view.refused},          {"angle", m_console.newestAngle()},
                {"joints", m_joints.json()},        {"frames", m_frames.json()},
                {"states", m_told.json()}};
    }

    test::PlayedMouse m_mouse{false};
    mouse3d::Mouse3d m_reader{{.longestRetry_ns = 250'000'000}, m_mouse.opener()};
    std::jthread m_pushing;
    test::TestConsole m_console;
    core::Wakeup m_wakeup;
    std::unique_ptr<site_link::RemoteArray> m_array;
    dds::Reader<ros::SiteState> m_states;
    Counted m_joints;
    Counted m_frames;
    Counted m_told;
    std::uint64_t m_jointsLost = 0;
    std::uint64_t m_framesLost = 0;
};

} // namespace

int main(int count, char** arguments) {
    if (count != 2)
        return 2;
    Console console(arguments[1]);
    std::cout << "ready" << std::endl;
    std::mutex mutex;
    std::deque<std::string> lines;
    std::jthread reader([&] {
        for (std::string line; std::getline(std::cin, line);) {
            const std::scoped_lock lock(mutex);
            lines.push_back(line);
        }
        const std::scoped_lock lock(mutex);
        lines.emplace_back("end");
    });
    for (bool goesOn = true; goesOn; std::this_thread::sleep_for(std::chrono::milliseconds(5))) {
        console.look();
        const std::scoped_lock lock(mutex);
        for (; goesOn && !lines.empty(); lines.pop_front())
            goesOn = console.obey(lines.front());
    }
    std::_Exit(0); // the reader waits for a line
}
