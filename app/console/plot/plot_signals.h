// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/plot/plot_layout.h"
#include "app/console/plot/signal_sources.h"
#include "backend/signal/derivative.h"
#include "backend/signal/signal_csv.h"
#include "backend/signal/spectrum.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::console {

/// The signals that are plotted, with what is computed of them. One whose source is not open waits for it.
/// Thread: GUI; spectra and readings run on pool threads.
class PlotSignals : public QObject {
    Q_OBJECT

public:
    /// Samples of all plotted live signals together, and of one of them.
    static constexpr std::size_t kMostSamples = 64'000'000;

    explicit PlotSignals(SourceManager& sources, QObject* parent = nullptr);

    struct Shown {
        PlottedSignal what;
        int colour = 1;
        std::string unit{}; ///< of the signal itself
        QString meaning{};  ///< see SignalSources::Signal
        double start_unix_s = 0.0;
        bool isRecorded = false; ///< as a whole: it does not grow
        double rate_Hz = 0.0;
        bool isOfEvents = false;
        base::Provenance provenance = base::Provenance::live; ///< stays when its source is closed
        std::shared_ptr<const signal::Series> raw{};          ///< null: not there
        std::shared_ptr<signal::Derivative> slope{};          ///< of a derivative
        std::shared_ptr<const signal::Spectrum> spectrum{};
        QString note{};         ///< why nothing is drawn; empty: it is
        QString spectrumNote{}; ///< the same of its spectrum

        /// What is drawn: the signal or its derivative; null: nothing.
        [[nodiscard]] std::shared_ptr<const signal::Series> series() const;
        [[nodiscard]] QString name() const;
        [[nodiscard]] QString shownUnit() const;
    };
    [[nodiscard]] const std::vector<Shown>& shown() const { return m_shown; }
    [[nodiscard]] SignalSources& sources() { return m_sources; }

    /// Those that are plotted already stay as they are.
    void add(const std::vector<signal::SignalId>& signalIds);
    void addDerivative(int index);
    void setSpectrum(int index, bool shown);
    void remove(const std::vector<int>& indexes);
    [[nodiscard]] bool canUndo() const { return !m_removed.empty(); }
    /// Brings back what was removed last.
    void undoRemove();
    /// Ends the readings and removes the signals that are not there yet; undoRemove() reads them again.
    void cancelReading();
    /// Where the shown signals come from, without live ones: each once, what counts for most first.
    [[nodiscard]] std::vector<base::Provenance> provenances() const;
    /// Times are clock times instead of those since the start of each source.
    void setClockTime(bool clock);
    /// From the time of a signal's series to the time that is shown.
    [[nodiscard]] double shift_s(const Shown& signal) const { return m_clock ? signal.start_unix_s : 0.0; }
    /// Plots these and nothing else.
    void set(const std::vector<PlottedSignal>& plotted);
    [[nodiscard]] std::vector<PlottedSignal> plotted() const;

    /// Computes the spectra that are shown anew, of what lies between two times, unless they are being
    /// computed.
    void computeSpectra(double from_s, double to_s);
    /// Takes new samples; goes on with derivatives.
    void tick();
    /// For a file: copies of what is drawn, at the times that are shown.
    [[nodiscard]] std::vector<signal::CsvSignal> forCsv() const;
    /// Samples of plotted signals that gave way to newer ones.
    [[nodiscard]] std::uint64_t dropped() const;

signals:
    /// Other signals are plotted, or their state is another.
    void changed();
    /// A recording was read, so that a signal is there now.
    void recordingRead();

private:
    void append(const PlottedSignal& plotted);
    /// Connects what is shown with the sources that are there.
    void resolve();
    void keepSamples();
    [[nodiscard]] int freeColour() const;
    void onRead(const signal::SignalId& id, const std::shared_ptr<const signal::Series>& series);

    SignalSources m_sources;
    std::vector<Shown> m_shown;
    std::vector<std::pair<int, Shown>> m_removed; ///< the last time, with their places
    std::vector<signal::SignalId> m_reading;
    bool m_computing = false;
    bool m_clock = false;
};

} // namespace teleta::console
