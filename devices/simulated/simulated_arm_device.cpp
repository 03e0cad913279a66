// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_arm_device.h"

#include <utility>

namespace teleta::simulated {

namespace {

class SimulatedArmSkin : public core::TactileSource {
public:
    explicit SimulatedArmSkin(std::shared_ptr<SimulatedArmWorker> worker)
        : m_worker(std::move(worker)) {}

    [[nodiscard]] const core::SourceDescription& description() const override {
        return m_worker->skinDescription();
    }
    void start(core::Wakeup&) override {}
    void stop() override {}
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override {
        return m_worker->skin().blocks();
    }
    [[nodiscard]] core::DeviceStatus status() const override { return m_worker->skin().status(); }

private:
    std::shared_ptr<SimulatedArmWorker> m_worker;
};

} // namespace

SimulatedArmDevice::SimulatedArmDevice(std::unique_ptr<core::ArmGenerator> generator,
                                       const core::StopSwitch& stopSwitch, SimulatedArmConfig config)
    : m_worker(std::make_shared<SimulatedArmWorker>(std::move(generator), stopSwitch, std::move(config))) {
}

std::unique_ptr<core::TactileSource> SimulatedArmDevice::makeSkin() {
    return std::make_unique<SimulatedArmSkin>(m_worker);
}

} // namespace teleta::simulated
