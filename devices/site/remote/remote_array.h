// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/chip_thermometers.h"
#include "backend/core/device/device.h"
#include "backend/core/device/loss_counting.h"
#include "backend/core/device/source_outlet.h"
#include "backend/core/error.h"
#include "backend/core/threads/device_thread.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/wait_set.h"
#include "devices/site/remote/remote_stream.h"
#include "devices/site/site_client.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace teleta::site_link {

/// A tactile array at a site as a source of frames. Times are those of the reads at the site, by the clock
/// here.
///   connecting -> live <-> stale; stop(): closed
/// Thread: as core::TactileSource.
class RemoteArray : public core::TactileSource, public core::ChipThermometers, public core::LossCounting {
public:
    /// name: of the array, or of the arm that wears it. description: as the site describes it. chips: that
    /// tell the site how warm they are; 0: none. countsLosses: whether the site can know what the sensor
    /// lost, which counts from the first frame here on; what is lost on the way is counted always. Error:
    /// unavailable, its topics cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<RemoteArray>>
    open(std::shared_ptr<SiteClient> site, const std::string& name, core::SourceDescription description,
         std::size_t chips = 0, bool countsLosses = true);

    [[nodiscard]] const core::SourceDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override { m_thread.start(consumer); }
    void stop() override { m_thread.stop(); }
    [[nodiscard]] core::BoundedQueue<core::SampleBlock>& blocks() override { return m_outlet.blocks(); }
    [[nodiscard]] core::DeviceStatus status() const override { return m_outlet.status(); }
    [[nodiscard]] std::size_t chips() const override { return m_chips; }
    [[nodiscard]] core::BoundedQueue<core::TemperatureSample>& temperatures() override {
        return m_temperatures;
    }
    [[nodiscard]] bool countsLosses() const override { return m_countsLosses; }
    [[nodiscard]] std::uint64_t lostAtSite() const override { return m_lostAtSite; }

private:
    friend core::DeviceThread<RemoteArray>;
    RemoteArray(std::shared_ptr<SiteClient> site, core::SourceDescription description,
                dds::Reader<ros::TactileBlock> reader, std::size_t chips,
                std::optional<dds::Reader<ros::TactileBlock>> temperatureReader, bool countsLosses);

    void open(core::Wakeup& consumer);
    void run(const std::stop_token& stop);
    void wake() { m_waitSet.wake(); }
    void take(const ros::TactileBlock& block);
    void takeTemperatures(const ros::TactileBlock& block);

    std::shared_ptr<SiteClient> m_site;
    core::SourceDescription m_description;
    dds::Reader<ros::TactileBlock> m_reader;
    std::size_t m_chips;
    bool m_countsLosses;
    std::atomic<std::uint64_t> m_lostAtSite{0};
    std::optional<dds::Reader<ros::TactileBlock>> m_temperatureReader; ///< nothing: there are no chips
    dds::WaitSet m_waitSet;
    core::SourceOutlet m_outlet;
    core::BoundedQueue<core::TemperatureSample> m_temperatures;
    RemoteStream m_stream;
    RemoteStream m_temperatureStream;
    core::DeviceThread<RemoteArray> m_thread{*this};
};

} // namespace teleta::site_link
