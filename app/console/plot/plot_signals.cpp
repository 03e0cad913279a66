// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/plot_signals.h"

#include "widgets/base/background.h"
#include "widgets/base/colour_maps.h"
#include "widgets/signal/unit_text.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace teleta::console {

namespace {

/// Samples of which derivatives are taken in a tick, so that a long signal does not hold the window up.
constexpr std::size_t kSlopesOfATick = 200'000;

} // namespace

std::shared_ptr<const signal::Series> PlotSignals::Shown::series() const {
    return what.derivative && slope ? std::shared_ptr<const signal::Series>(slope, &slope->series()) : raw;
}

QString PlotSignals::Shown::name() const {
    const QString own = QString::fromStdString(what.id.column);
    const QString column = meaning.isEmpty() ? own : tr("%1 of %2", "a signal of a joint").arg(own, meaning);
    return (what.derivative ? tr("d/dt %1", "derivative of a signal").arg(column) : column) +
           QStringLiteral(", ") + QString::fromStdString(what.id.source);
}

QString PlotSignals::Shown::shownUnit() const {
    const QString own = QString::fromStdString(unit);
    return what.derivative ? signal::unitPerSecond(own) : own;
}

PlotSignals::PlotSignals(SourceManager& sources, QObject* parent)
    : QObject(parent)
    , m_sources(sources) {
    connect(&m_sources, &SignalSources::changed, this, &PlotSignals::resolve);
    connect(&m_sources, &SignalSources::readDone, this, &PlotSignals::onRead);
    connect(&m_sources, &SignalSources::readFailed, this,
            [this](const signal::SignalId& id, const QString& why) {
                std::erase(m_reading, id);
                for (Shown& each : m_shown)
                    if (each.what.id == id)
                        each.note = why;
                emit changed();
            });
}

int PlotSignals::freeColour() const {
    std::vector<int> uses(base::kIdentityColours);
    for (const Shown& each : m_shown)
        ++uses[static_cast<std::size_t>(each.colour - 1)];
    return 1 + static_cast<int>(std::ranges::min_element(uses) - uses.begin());
}

void PlotSignals::append(const PlottedSignal& plotted) {
    const bool isThere = std::ranges::any_of(m_shown, [&](const Shown& each) {
        return each.what.id == plotted.id && each.what.derivative == plotted.derivative;
    });
    if (!isThere)
        m_shown.push_back({plotted, freeColour()});
}

void PlotSignals::add(const std::vector<signal::SignalId>& signalIds) {
    for (const signal::SignalId& id : signalIds)
        append({.id = id});
    resolve();
}

void PlotSignals::addDerivative(int index) {
    append({.id = m_shown[static_cast<std::size_t>(index)].what.id, .derivative = true});
    resolve();
}

void PlotSignals::setSpectrum(int index, bool shown) {
    Shown& signal = m_shown[static_cast<std::size_t>(index)];
    signal.what.spectrum = shown;
    signal.spectrum = nullptr;
    signal.spectrumNote.clear();
    resolve();
}

void PlotSignals::remove(const std::vector<int>& indexes) {
    m_removed.clear();
    for (const int index : indexes)
        m_removed.emplace_back(index, m_shown[static_cast<std::size_t>(index)]);
    for (auto place = m_removed.rbegin(); place != m_removed.rend(); ++place)
        m_shown.erase(m_shown.begin() + place->first);
    keepSamples();
    emit changed();
}

void PlotSignals::undoRemove() {
    for (auto& [place, signal] : std::exchange(m_removed, {}))
        m_shown.insert(m_shown.begin() + std::min(place, static_cast<int>(m_shown.size())),
                       std::move(signal));
    resolve();
}

void PlotSignals::cancelReading() {
    m_sources.cancelReadings();
    std::vector<int> unread;
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        if (std::ranges::find(m_reading, m_shown[i].what.id) != m_reading.end())
            unread.push_back(static_cast<int>(i));
    m_reading.clear();
    if (!unread.empty())
        remove(unread);
    else
        emit changed(); // what was removed last can still be brought back
}

std::vector<base::Provenance> PlotSignals::provenances() const {
    std::set<base::Provenance, std::greater<>> all;
    for (const Shown& each : m_shown)
        if (each.provenance != base::Provenance::live)
            all.insert(each.provenance);
    return {all.begin(), all.end()};
}

void PlotSignals::setClockTime(bool clock) {
    if (std::exchange(m_clock, clock) == clock)
        return;
    for (Shown& each : m_shown)
        each.spectrum = nullptr; // of another stretch, until it is computed again
    emit changed();
}

void PlotSignals::set(const std::vector<PlottedSignal>& plotted) {
    m_removed.clear();
    m_shown.clear();
    for (const PlottedSignal& each : plotted)
        append(each);
    resolve();
}

std::vector<PlottedSignal> PlotSignals::plotted() const {
    std::vector<PlottedSignal> plotted;
    std::ranges::transform(m_shown, std::back_inserter(plotted), &Shown::what);
    return plotted;
}

void PlotSignals::resolve() {
    std::map<std::pair<std::string, std::string>, std::vector<signal::SignalId>> toRead;
    for (Shown& each : m_shown) {
        const auto found = m_sources.find(each.what.id);
        if (!found) {
            if (!each.raw)
                each.note = tr("its source is not open");
            continue;
        }
        each.unit = found->unit;
        each.meaning = found->meaning;
        each.start_unix_s = found->start_unix_s;
        each.isRecorded = found->isRecorded;
        each.rate_Hz = found->rate_Hz;
        each.isOfEvents = found->isOfEvents;
        each.provenance = found->provenance;
        if (found->isRecorded) {
            const auto same = std::ranges::find_if(
                m_shown, [&](const Shown& other) { return other.what.id == each.what.id && other.raw; });
            if (!each.raw && same != m_shown.end())
                each.raw = same->raw;
            const bool isRead = std::ranges::find(m_reading, each.what.id) != m_reading.end();
            if (!each.raw && !isRead) {
                m_reading.push_back(each.what.id);
                toRead[{each.what.id.source, each.what.id.stream}].push_back(each.what.id);
            }
            if (!each.raw)
                each.note = tr("is being read");
        } else if (each.raw != found->series) {
            // Opened for the first time, or again.
            each.raw = found->series;
            each.slope = nullptr;
        }
        if (each.raw)
            each.note.clear();
        if (each.what.derivative && each.raw && !each.slope)
            each.slope = std::make_shared<signal::Derivative>();
    }
    keepSamples();
    for (const auto& [stream, ids] : toRead)
        m_sources.read(ids);
    emit changed();
}

void PlotSignals::onRead(const signal::SignalId& id, const std::shared_ptr<const signal::Series>& series) {
    std::erase(m_reading, id);
    for (Shown& each : m_shown)
        if (each.what.id == id)
            each.raw = series;
    resolve();
    emit recordingRead();
}

void PlotSignals::keepSamples() {
    std::vector<signal::SignalId> kept;
    for (const Shown& each : m_shown)
        kept.push_back(each.what.id);
    for (const auto& [place, each] : m_removed)
        kept.push_back(each.what.id);
    const std::size_t each =
        std::min(signal::Series::kMost, kMostSamples / std::max<std::size_t>(1, kept.size()));
    m_sources.keep(kept, each);
    for (const Shown& shown : m_shown)
        if (shown.slope)
            shown.slope->setCapacity(each);
}

void PlotSignals::computeSpectra(double from_s, double to_s) {
    struct Wanted {
        PlottedSignal what;
        signal::Series series;
        double rate_Hz = 0.0;
        double shift_s = 0.0;
    };
    std::vector<Wanted> wanted;
    for (const Shown& each : m_shown)
        if (each.what.spectrum && each.series())
            wanted.push_back({each.what, *each.series(), each.rate_Hz, shift_s(each)});
    if (wanted.empty() || m_computing)
        return;
    m_computing = true;
    using Computed = std::vector<std::pair<PlottedSignal, core::Expected<signal::Spectrum>>>;
    base::runInBackground(
        this,
        [wanted = std::move(wanted), from_s, to_s] {
            Computed computed;
            for (const Wanted& each : wanted)
                computed.emplace_back(each.what, signal::spectrumOf(each.series, from_s - each.shift_s,
                                                                    to_s - each.shift_s, each.rate_Hz));
            return computed;
        },
        [this](Computed computed) {
            m_computing = false;
            for (auto& [what, spectrum] : computed) {
                const auto place = std::ranges::find(m_shown, what, &Shown::what);
                if (place == m_shown.end())
                    continue;
                place->spectrumNote =
                    spectrum ? QString() : QString::fromStdString(core::describe(spectrum.error()));
                place->spectrum =
                    spectrum ? std::make_shared<const signal::Spectrum>(std::move(*spectrum)) : nullptr;
            }
            emit changed();
        });
}

void PlotSignals::tick() {
    m_sources.tick();
    for (const Shown& each : m_shown)
        if (each.slope && each.raw)
            each.slope->follow(*each.raw, kSlopesOfATick);
}

std::vector<signal::CsvSignal> PlotSignals::forCsv() const {
    std::vector<signal::CsvSignal> columns;
    std::set<std::string> taken;
    for (const Shown& each : m_shown) {
        if (!each.series())
            continue;
        std::string name = signal::nameWithUnit(each.what.id.column, each.unit);
        if (each.what.derivative)
            name = "d_dt_" + name + "_per_s";
        // The same column of two sources.
        const std::string own =
            taken.contains(name) ? each.what.id.source + "_" + each.what.id.stream + "_" + name : name;
        std::string unique = own;
        for (int number = 2; !taken.insert(unique).second; ++number)
            unique = own + "_" + std::to_string(number);
        columns.push_back({unique, *each.series(), shift_s(each)});
    }
    return columns;
}

std::uint64_t PlotSignals::dropped() const {
    std::uint64_t sum = 0;
    for (const Shown& each : m_shown)
        sum += each.raw && !each.what.derivative ? each.raw->dropped() : 0;
    return sum;
}

} // namespace teleta::console
