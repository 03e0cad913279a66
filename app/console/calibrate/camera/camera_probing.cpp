// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/camera/camera_probing.h"

#include "app/common/scene_file.h"
#include "backend/scene_run/camera/simulated_probing.h"

namespace teleta::console {

namespace {

constexpr const char* kScene = ":/scenes/vtacarm-calibration.toml";

} // namespace

CameraProbing::CameraProbing(QObject* parent)
    : QObject(parent) {
    connect(&m_thread, &ProbingThread::runningChanged, this, &CameraProbing::runningChanged);
}

void CameraProbing::start(std::uint64_t seed) {
    m_thread.start([this, seed](const ProbingThread::Run& run) { probe(run, seed); });
}

void CameraProbing::probe(const ProbingThread::Run& run, std::uint64_t seed) {
    const auto fail = [&](const core::Error& error) {
        m_thread.tell(run, [this, trouble = QString::fromStdString(core::describe(error))] {
            m_thread.ended();
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
    m_thread.tell(run, [this, settings = person.settings()] { emit begun(settings); });
    const double duration_s = person.plan().duration_s();
    while (!run.stop.stop_requested() && person.tube().time_s() < duration_s) {
        if (const auto taken = person.next())
            m_thread.tell(run, [this, pair = taken->pair] { emit this->taken(pair); });
        m_thread.tell(run, [this, share = person.tube().time_s() / duration_s] { emit progressed(share); });
    }
    m_thread.tell(run, [this] { m_thread.ended(); });
}

} // namespace teleta::console
