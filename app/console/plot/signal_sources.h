// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/source_manager.h"
#include "backend/signal/live_source.h"
#include "backend/signal/recorded_signals.h"
#include "widgets/base/controls/badge.h"
#include "widgets/signal/signal_tree.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace teleta::arm_model {
class SerialChain;
}

namespace teleta::console {

/// Where signals come from: every open source, whose streams are followed from its opening on, and whole
/// recordings, whose signals are read on a pool thread when they are asked for. Thread: GUI.
class SignalSources : public QObject {
    Q_OBJECT

public:
    explicit SignalSources(SourceManager& sources, QObject* parent = nullptr);
    /// Ends a reading at its next block; waits for nothing.
    ~SignalSources() override;

    /// What is known of a signal.
    struct Signal {
        std::shared_ptr<const signal::Series> series; ///< null: it must be read()
        std::optional<double> newest;                 ///< of one that runs
        std::string unit;
        QString meaning;           ///< the joint that it is of; empty: it is of none, or not known
        double start_unix_s = 0.0; ///< clock time at the zero of the series, UTC
        double rate_Hz = 0.0;
        bool isOfEvents = false;
        bool isRecorded = false; ///< as a whole, not played
        base::Provenance provenance = base::Provenance::live;
    };
    /// Empty: there is no such signal now.
    [[nodiscard]] std::optional<Signal> find(const signal::SignalId& id) const;
    [[nodiscard]] std::vector<signal::SourceEntry> entries() const;
    [[nodiscard]] bool empty() const { return m_live.empty() && m_recordings.empty(); }
    /// Frames of all sources that came faster than they were taken.
    [[nodiscard]] std::uint64_t lost() const;

    /// Lists the signals of a recording.
    void addRecording(const QString& path);
    /// Reads signals of one stream of a recording, whole.
    void read(const std::vector<signal::SignalId>& signalIds);
    /// Of the readings that run; empty: none does.
    [[nodiscard]] std::optional<double> progress() const;
    /// Ends the readings that run, at their next block; nothing more is told of them.
    void cancelReadings();

    /// Keeps so many samples of these live signals, and of all others what their streams grant.
    void keep(const std::vector<signal::SignalId>& signalIds, std::size_t samples);
    /// Takes what has come.
    void tick();

signals:
    /// There are other sources or streams than before.
    void changed();
    void readDone(const signal::SignalId& id, const std::shared_ptr<const signal::Series>& series);
    void readFailed(const signal::SignalId& id, const QString& why);
    /// damaged: some blocks of a recording could not be read.
    void damaged(const QString& recording, int blocks);
    void failed(const QString& recording, const QString& why);

private:
    struct Live {
        pipeline::ChannelKey key = 0;
        std::shared_ptr<signal::LiveSource> source;
    };
    /// What tells the names of the joints of a stream.
    struct Arm {
        std::shared_ptr<const arm_model::SerialChain> chain; ///< null: it is not described
        bool isOwn = false; ///< one that needs no description, if it has the usual four joints
    };
    /// What is told of a recording before its signals are read.
    struct Listed {
        std::vector<recording::StreamInfo> streams;
        std::vector<Arm> arms; ///< one a stream
        double start_unix_s = 0.0;
    };
    struct Recorded {
        std::string name;
        std::string path;
        Listed listed;
        std::set<std::string> simulated; ///< sources of the streams
    };
    struct Reading {
        std::atomic<bool> cancelled{false};
        std::atomic<double> share{0.0};
    };

    void watch(pipeline::ChannelKey key);
    [[nodiscard]] static core::Expected<Listed> list(const std::string& path);
    [[nodiscard]] Arm armOf(const Live& live) const;
    /// For each column of a stream of joints; empty: they are not known, or it is another stream.
    [[nodiscard]] static std::vector<QString> jointsOf(const recording::StreamInfo& stream, const Arm& arm);

    SourceManager& m_sources;
    std::int64_t m_origin_ns = 0; ///< zero of the live series: when the first of the open ones was opened
    double m_origin_unix_s = 0.0; ///< the same as clock time
    std::vector<Live> m_live;
    std::vector<Recorded> m_recordings;
    std::vector<std::string> m_adding; ///< paths of recordings that are being listed
    std::vector<std::shared_ptr<Reading>> m_readings;
};

} // namespace teleta::console
