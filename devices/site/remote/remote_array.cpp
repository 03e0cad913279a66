// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/remote/remote_array.h"

#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/core/threads/urgent_thread.h"
#include "devices/site/boot_name.h"
#include "devices/site/remote/remote_text.h"

#include <cstdint>
#include <utility>

namespace teleta::site_link {

namespace {

constexpr std::size_t kQueueBlocks = 256;
constexpr std::size_t kQueueTemperatures = 4096;

} // namespace

core::Expected<std::unique_ptr<RemoteArray>> RemoteArray::open(std::shared_ptr<SiteClient> site,
                                                               const std::string& name,
                                                               core::SourceDescription description,
                                                               std::size_t chips, bool countsLosses) {
    TELETA_TRY(auto reader,
               dds::Reader<ros::TactileBlock>::open(site->participant(), site->topics().tactile(name),
                                                    kStreamed.withDepth(kReaderDepth)));
    std::optional<dds::Reader<ros::TactileBlock>> temperatures;
    if (chips > 0) {
        TELETA_TRY(auto opened, dds::Reader<ros::TactileBlock>::open(site->participant(),
                                                                     site->topics().temperatures(name),
                                                                     kStreamed.withDepth(kReaderDepth)));
        temperatures.emplace(std::move(opened));
    }
    return std::unique_ptr<RemoteArray>(new RemoteArray(std::move(site), std::move(description),
                                                        std::move(reader), chips, std::move(temperatures),
                                                        countsLosses));
}

RemoteArray::RemoteArray(std::shared_ptr<SiteClient> site, core::SourceDescription description,
                         dds::Reader<ros::TactileBlock> reader, std::size_t chips,
                         std::optional<dds::Reader<ros::TactileBlock>> temperatureReader, bool countsLosses)
    : m_site(std::move(site))
    , m_description(std::move(description))
    , m_reader(std::move(reader))
    , m_chips(chips)
    , m_countsLosses(countsLosses)
    , m_temperatureReader(std::move(temperatureReader))
    , m_waitSet(m_site->participant())
    , m_outlet(kQueueBlocks)
    , m_temperatures(chips > 0 ? kQueueTemperatures : 1) {
    m_waitSet.attach(m_reader);
    if (m_temperatureReader)
        m_waitSet.attach(*m_temperatureReader);
}

void RemoteArray::open(core::Wakeup& consumer) {
    m_outlet.open(consumer, core::steadyNow_ns());
}

void RemoteArray::run(const std::stop_token& stop) {
    (void)core::makeThreadUrgent();
    const std::int64_t staleAfter_ns = core::staleAfter_ns(m_description.nominalRate_Hz);
    while (!stop.stop_requested()) {
        m_waitSet.wait(RemoteStream::kLook_ns);
        // Before the frames, with which the consumer is notified.
        if (m_temperatureReader)
            (void)m_temperatureReader->take(
                [this](const ros::TactileBlock& block, const dds::SampleInfo&) { takeTemperatures(block); });
        (void)m_reader.take([this](const ros::TactileBlock& block, const dds::SampleInfo&) { take(block); });
        RemoteStream::watchSilence(m_outlet, m_outlet.lastData_ns(), staleAfter_ns,
                                   [this] { return silenceText(*m_site); });
    }
    m_outlet.setState(core::DeviceState::closed, core::steadyNow_ns());
}

void RemoteArray::take(const ros::TactileBlock& block) {
    const std::int64_t arrived_ns = core::steadyNow_ns();
    const std::size_t channels = m_description.layout.values();
    const auto times = ros::view(block.read_site_ns);
    const auto source = ros::view(block.source_s);
    const auto values = ros::view(block.values);
    // A block whose lengths contradict each other says nothing.
    if (source.size() != times.size() || values.size() != times.size() * channels)
        return;
    const RemoteStream::Step step =
        m_stream.take(bootNameOf(block.site_boot), block.first, times.size(), block.lost);
    if (!step.use)
        return;
    if (step.lost > 0)
        m_outlet.lose(step.lost);
    m_lostAtSite += step.atSite; // after the status: whoever looks here first finds no more than that has
    core::SampleBlock taken;
    taken.channels = channels;
    for (const std::int64_t time_ns : times)
        taken.time_ns.push_back(m_stream.inOrder(m_site->readTime_ns(time_ns, arrived_ns)));
    taken.sourceTime_s.assign(source.begin(), source.end());
    taken.values.assign(values.begin(), values.end());
    taken.discontinuity = step.discontinuity || block.discontinuity != 0;
    m_outlet.deliver(std::move(taken), core::DeviceState::live, arrived_ns);
}

void RemoteArray::takeTemperatures(const ros::TactileBlock& block) {
    const std::int64_t arrived_ns = core::steadyNow_ns();
    const auto times = ros::view(block.read_site_ns);
    const auto source = ros::view(block.source_s);
    const auto values = ros::view(block.values);
    if (source.size() != times.size() || values.size() != times.size() * m_chips)
        return;
    const RemoteStream::Step step =
        m_temperatureStream.take(bootNameOf(block.site_boot), block.first, times.size());
    if (!step.use)
        return;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto one = values.subspan(i * m_chips, m_chips);
        m_temperatures.push(
            {.time_ns = m_temperatureStream.inOrder(m_site->readTime_ns(times[i], arrived_ns)),
             .sourceTime_s = source[i],
             .values_degC = {one.begin(), one.end()},
             .discontinuity = i == 0 && (step.discontinuity || step.lost > 0 || block.discontinuity != 0)});
    }
}

} // namespace teleta::site_link
