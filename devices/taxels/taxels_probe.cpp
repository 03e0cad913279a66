// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxels_probe.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/link/byte_link.h"
#include "devices/taxels/magnetometers_file.h"
#include "devices/taxels/taxels_link.h"
#include "devices/taxels/taxels_text.h"

#include <QString>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace teleta::taxels {

namespace {

using link::ByteLink;
using Outcome = ByteLink::Outcome;
using Rest = FrameDecoder::Rest;

constexpr double kLook_s = 0.05;
constexpr std::size_t kBytesForChips = 4096; ///< three frames of the largest board
constexpr double kRest_s = 3.0;              ///< for the next frame, besides its period

std::int64_t in(double time_s) {
    return core::steadyNow_ns() + static_cast<std::int64_t>(time_s * 1e9);
}

/// Feeds a decoder with what a sensor sends.
class Listener {
public:
    Listener(const TaxelsFile& file, ByteLink link)
        : m_file(file)
        , m_link(std::move(link))
        , m_decoder(makeDecoder(file.format, m_link)) {}
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;
    ~Listener() { m_link.tell(m_file.goodbye, nullptr); }

    /// Waits a moment for bytes; false: no more will come.
    bool listen(std::int64_t deadline_ns) {
        std::size_t count = 0;
        const Outcome outcome = m_link.read(m_buffer, count, std::min(deadline_ns, in(kLook_s)), nullptr);
        m_read = std::span(m_buffer).first(count);
        m_decoder->feed(m_read);
        if (outcome == Outcome::done)
            m_read_ns = core::steadyNow_ns();
        const bool isSilent = core::steadyNow_ns() >= m_read_ns + m_file.times.lineSilence_ms * kMs_ns;
        m_rest = outcome == Outcome::gone ? restOf(m_link) : isSilent ? Rest::willNotCome : Rest::mayCome;
        return outcome != Outcome::gone;
    }
    bool next(DecodedFrame& frame) { return m_decoder->next(frame, m_rest); }

    [[nodiscard]] std::span<const std::uint8_t> read() const { return m_read; }
    [[nodiscard]] const FrameDecoder& decoder() const { return *m_decoder; }
    [[nodiscard]] bool isFile() const { return m_link.isFile(); }
    [[nodiscard]] std::uint64_t binaryMessages() const { return m_link.leftOut(); }

private:
    const TaxelsFile& m_file;
    ByteLink m_link;
    std::unique_ptr<FrameDecoder> m_decoder;
    std::vector<std::uint8_t> m_buffer = std::vector<std::uint8_t>(ByteLink::kLongestDatagram);
    std::span<const std::uint8_t> m_read;
    Rest m_rest = Rest::mayCome;
    std::int64_t m_read_ns = core::steadyNow_ns();
};

} // namespace

namespace {

/// Error: the bytes are frames of another number of chips.
core::Expected<void> checkChips(const TaxelsFile& file, std::span<const std::uint8_t> bytes) {
    const auto chips = file.temperatures > 0 ? chipsOf(bytes) : std::nullopt;
    if (!chips || *chips == static_cast<int>(file.temperatures))
        return {};
    return core::failed(
        core::ErrorKind::unavailable, TaxelsText::tr("the board sends frames of %1 chips").arg(*chips),
        TaxelsText::tr("frames of %1 chips, as the file has positions").arg(file.temperatures));
}

} // namespace

core::Expected<TaxelsProbe> probeTaxels(const TaxelsFile& file, const ProbeLimits& limits,
                                        const std::function<bool()>& cancelled) {
    TELETA_TRY(auto link, openLink(file, nullptr));
    Listener sensor(file, std::move(link));
    TaxelsProbe probe;
    std::int64_t first_ns = 0;
    std::int64_t last_ns = 0;
    std::int64_t end_ns = in(limits.wait_s);
    DecodedFrame frame;
    bool goesOn = true;
    while (goesOn && core::steadyNow_ns() < end_ns && !(cancelled && cancelled())) {
        goesOn = sensor.listen(end_ns);
        const std::span<const std::uint8_t> read = sensor.read();
        const std::size_t room = limits.bytes - std::min(limits.bytes, probe.bytes.size());
        const auto kept = read.first(std::min(read.size(), room));
        probe.bytes.insert(probe.bytes.end(), kept.begin(), kept.end());
        while (sensor.next(frame)) {
            last_ns = core::steadyNow_ns();
            if (probe.frames.empty()) {
                first_ns = last_ns;
                end_ns = in(limits.measure_s);
                probe.first.resize(file.grid.layout().values());
                file.grid.place(frame.values, probe.first);
                probe.others.assign(frame.values.begin() + static_cast<std::ptrdiff_t>(file.grid.values()),
                                    frame.values.end());
            }
            if (file.temperatures > 0)
                probe.drift.take(std::span(frame.values).last(file.temperatures));
            probe.frames.push_back({sensor.decoder().frameBegin(), sensor.decoder().frameSize()});
        }
        goesOn = goesOn && !(sensor.isFile() && probe.bytes.size() >= limits.bytes);
    }
    probe.counters = sensor.decoder().counters();
    probe.binaryMessages = sensor.binaryMessages();
    if (!sensor.isFile() && probe.frames.size() > 1 && last_ns > first_ns)
        probe.rate_Hz =
            1e9 * static_cast<double>(probe.frames.size() - 1) / static_cast<double>(last_ns - first_ns);
    return probe;
}

core::Expected<RestReading> measureRest(const TaxelsFile& file, const std::function<bool()>& cancelled) {
    TELETA_TRY(auto link, openLink(file, nullptr));
    Listener sensor(file, std::move(link));
    const std::size_t taxels = file.grid.layout().values();
    const auto wanted = static_cast<std::size_t>(file.restFrames);
    std::vector<std::vector<float>> readings(taxels + file.temperatures);
    std::vector<float> loads(taxels);
    std::size_t frames = 0;
    std::vector<std::uint8_t> bytes; // the first ones, which may tell why there is no frame
    const double wait_s = kRest_s + (file.rate_Hz > 0.0 ? 1.0 / file.rate_Hz : 0.0);
    std::int64_t end_ns = in(wait_s);
    DecodedFrame frame;
    for (bool goesOn = true; goesOn && frames < wanted && core::steadyNow_ns() < end_ns;) {
        if (cancelled && cancelled())
            return core::failed(core::ErrorKind::cancelled, TaxelsText::tr("opening was cancelled"));
        goesOn = sensor.listen(end_ns);
        if (frames == 0 && bytes.size() < kBytesForChips) {
            bytes.insert(bytes.end(), sensor.read().begin(), sensor.read().end());
            if (bytes.size() >= kBytesForChips)
                TELETA_CHECK(checkChips(file, bytes));
        }
        while (frames < wanted && sensor.next(frame)) {
            file.grid.place(frame.values, loads);
            for (std::size_t i = 0; i < taxels; ++i)
                readings[i].push_back(loads[i]);
            const auto warm = std::span(frame.values).last(file.temperatures);
            for (std::size_t chip = 0; chip < warm.size(); ++chip)
                readings[taxels + chip].push_back(warm[chip]);
            ++frames;
            end_ns = in(wait_s);
        }
    }
    if (frames == 0)
        TELETA_CHECK(checkChips(file, bytes));
    if (frames < wanted)
        return core::failed(
            core::ErrorKind::unavailable,
            TaxelsText::tr("only %1 of %2 frames arrived while the tare was measured")
                .arg(frames)
                .arg(wanted),
            TaxelsText::tr("frames as the file describes; check with teleta devices --probe FILE"));
    RestReading rest;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const auto middle = readings[i].begin() + static_cast<std::ptrdiff_t>(frames / 2);
        std::ranges::nth_element(readings[i], middle);
        (i < taxels ? rest.values : rest.temperatures_degC).push_back(*middle);
    }
    return rest;
}

} // namespace teleta::taxels
