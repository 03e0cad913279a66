// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console_options.h"
#include "backend/core/error.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/touch_pipeline.h"

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>

#include <atomic>
#include <cstdint>
#include <memory>

namespace teleta::console {

class RecordingFiles;
class SourceManager;
class StudyPage;

/// Opens what files name, from the command line, a menu or a drop: recordings, source lists, arms, sites,
/// scenes and the studies of scenes. Files are read on pool threads. Thread: GUI.
class FileOpener : public QObject {
    Q_OBJECT

public:
    /// All of them outlive this. seed: of the scenes.
    FileOpener(SourceManager& sources, RecordingFiles& recordings, StudyPage& study,
               const core::StopSwitch& stop, std::uint64_t seed, QObject* parent);
    ~FileOpener() override { *m_cancelled = true; }

    /// A recording by its name; of the other files a source list, an arm, a site or a scene by what is in
    /// it.
    void openFile(const QString& path);
    void openRecording(const QString& path);
    /// Opens without asking; what the command line omits is guessed.
    void openAs(const RecordingArguments& recording);
    /// Source list that a source was opened from; empty: none.
    [[nodiscard]] QString listOf(pipeline::ChannelKey source) const { return m_lists.value(source); }
    /// As it was opened the last time; asks only when that is not known.
    void reopenRecording(const QString& path);
    void openList(const QString& path);
    /// An arm over ROS 2.
    void openArm(const QString& path);
    /// All devices of a site.
    void openSite(const QString& path);
    void openScene(const QString& path);
    /// A scene of a study goes to its page, in a folder of its own or the one that is named, and is a
    /// rehearsal already; all others are sources, beside which the study is opened as it would be without
    /// them.
    void openScenes(const QStringList& scenes, const QString& study, bool rehearse);
    /// study: empty: a new one, and only for a rehearsal.
    void openStudy(const QString& study, bool rehearse);

    /// Some of what is to be opened is not among the sources yet. A recording of which a person is asked how
    /// it is to be read does not count.
    [[nodiscard]] bool isReading() const { return m_reading > 0 || !m_awaited.isEmpty(); }

signals:
    /// A scene in a file was opened as a source.
    void sceneOpened(const QString& path);
    void armOpened(const QString& path);
    /// It may take some seconds until the site answers.
    void siteAwaited(const QString& name);
    void siteOpened(const QString& path);
    /// A source list was read.
    void listOpened(const QString& path);
    void failed(const QString& name, const teleta::core::Error& error);
    /// The page with the study is to be shown.
    void studyShown();

private:
    template <typename Work, typename Done>
    void read(Work work, Done done);
    void onItems();

    SourceManager& m_sources;
    RecordingFiles& m_recordings;
    StudyPage& m_study;
    const core::StopSwitch& m_stop;
    std::uint64_t m_seed;
    /// Asked while a site is looked for.
    std::shared_ptr<std::atomic<bool>> m_cancelled = std::make_shared<std::atomic<bool>>(false);
    int m_reading = 0;
    QStringList m_awaited;                        ///< recordings that are being read
    QStringList m_awaitedSites;                   ///< of which an answer is awaited
    QHash<pipeline::ChannelKey, QString> m_lists; ///< by what was opened from them
};

} // namespace teleta::console
