// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera_probing.h"

#include "app/common/scene_file.h"
#include "backend/scene_run/simulated_probing.h"

#include <utility>

namespace teleta::console {

namespace {

constexpr const char* kScene = ":/scenes/vtacarm-calibration.toml";

} // namespace

CameraProbing::CameraProbing(QObject* parent)
    : QObject(parent) {
    m_pool.setMaxThreadCount(1);
}

CameraProbing::~CameraProbing() {
    m_stop.request_stop();
    m_pool.waitForDone();
}

void CameraProbing::start(std::uint64_t seed) {
    m_stop.request_stop();
    m_stop = {};
    ++m_number;
    setRunning(true);
    m_pool.start([this, number = m_number, seed, stop = m_stop.get_token()] { run(number, seed, stop); });
}

void CameraProbing::cancel() {
    m_stop.request_stop();
    ++m_number; // what it still has to tell is of no interest
    setRunning(false);
}

void CameraProbing::setRunning(bool running) {
    if (running == m_running)
        return;
    m_running = running;
    emit runningChanged(running);
}

template <typename What>
void CameraProbing::tell(std::uint64_t number, What what) {
    QMetaObject::invokeMethod(
        this,
        [this, number, what = std::move(what)] {
            if (number == m_number)
                what();
        },
        Qt::QueuedConnection);
}

void CameraProbing::run(std::uint64_t number, std::uint64_t seed, const std::stop_token& stop) {
    const auto fail = [&](const core::Error& error) {
        tell(number, [this, trouble = QString::fromStdString(core::describe(error))] {
            setRunning(false);
            emit failed(trouble);
        });
    };
    const auto scene = app::readScene(kScene);
    if (!scene)
        return fail(scene.error());
    auto probing = scene_run::SimulatedProbing::make(*scene, seed);
    if (!probing)
        return fail(probing.error());
    scene_run::SimulatedProbing& person = **probing;
    tell(number, [this, settings = person.settings()] { emit begun(settings); });
    const double duration_s = person.plan().duration_s();
    while (!stop.stop_requested() && person.tube().time_s() < duration_s) {
        if (const auto taken = person.next())
            tell(number, [this, pair = taken->pair] { emit this->taken(pair); });
        tell(number, [this, share = person.tube().time_s() / duration_s] { emit progressed(share); });
    }
    tell(number, [this] { setRunning(false); });
}

} // namespace teleta::console
