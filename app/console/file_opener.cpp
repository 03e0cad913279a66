// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/file_opener.h"

#include "app/common/scene_file.h"
#include "app/console/operate/recording/recording_files.h"
#include "app/console/sources/source_manager.h"
#include "app/console/study/study_page.h"
#include "app/sources/site_request.h"
#include "app/sources/source_list.h"
#include "widgets/base/background.h"

#include <QFileInfo>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::console {

FileOpener::FileOpener(SourceManager& sources, RecordingFiles& recordings, StudyPage& study,
                       const core::StopSwitch& stop, std::uint64_t seed, QObject* parent)
    : QObject(parent)
    , m_sources(sources)
    , m_recordings(recordings)
    , m_study(study)
    , m_stop(stop)
    , m_seed(seed) {
    connect(&m_recordings, &RecordingFiles::opened, this,
            [this](const QString& path) { m_awaited.removeOne(path); });
    connect(&m_recordings, &RecordingFiles::imported, this,
            [this](const QString& file, const QString& recording) {
                m_awaited.removeOne(file);
                m_awaited.append(recording);
            });
    connect(&m_recordings, &RecordingFiles::cancelled, this,
            [this](const QString& file) { m_awaited.removeOne(file); });
    // It tells the name alone.
    connect(&m_recordings, &RecordingFiles::failed, this, [this](const QString& name) {
        const auto awaited = std::find_if(m_awaited.begin(), m_awaited.end(), [&](const QString& path) {
            return QFileInfo(path).fileName() == name;
        });
        if (awaited != m_awaited.end())
            m_awaited.erase(awaited);
    });
    connect(&m_sources, &SourceManager::itemsChanged, this, &FileOpener::onItems);
}

/// Frames in CSV are opened without a word of it but the source.
void FileOpener::onItems() {
    for (const SourceManager::Item& item : m_sources.items())
        if (const auto* recording = std::get_if<app::CsvRequest>(&item.request))
            m_awaited.removeAll(QString::fromStdString(recording->path));
}

/// In the background; counted until done has been called.
template <typename Work, typename Done>
void FileOpener::read(Work work, Done done) {
    ++m_reading;
    base::runInBackground(this, std::move(work), [this, done = std::move(done)](const auto& result) {
        done(result);
        --m_reading;
    });
}

void FileOpener::openFile(const QString& path) {
    if (app::isPlayable(path)) {
        openRecording(path);
        return;
    }
    using Open = void (FileOpener::*)(const QString&);
    read(
        [path]() -> Open {
            const std::string file = path.toStdString();
            return app::isSourceList(file) ? &FileOpener::openList
                   : app::isArmFile(file)  ? &FileOpener::openArm
                   : app::isSiteFile(file) ? &FileOpener::openSite
                                           : &FileOpener::openScene;
        },
        [this, path](Open open) { (this->*open)(path); });
}

void FileOpener::openRecording(const QString& path) {
    if (app::isRecordingName(path) || app::isImported(path))
        m_awaited.append(path);
    m_recordings.open(path);
}

void FileOpener::reopenRecording(const QString& path) {
    if (app::isRecordingName(path) || app::isImported(path))
        openRecording(path);
    else
        m_recordings.reopen(path);
}

void FileOpener::openAs(const RecordingArguments& recording) {
    m_awaited.append(recording.path);
    m_recordings.openAs(recording);
}

void FileOpener::openList(const QString& path) {
    read([path] { return app::readSourceList(path.toStdString()); },
         [this, path](const core::Expected<std::vector<app::SourceRequest>>& list) {
             if (!list) {
                 emit failed(QFileInfo(path).fileName(), list.error());
                 return;
             }
             emit listOpened(path);
             for (const app::SourceRequest& request : *list)
                 m_lists.insert(m_sources.open(request), path);
         });
}

void FileOpener::openArm(const QString& path) {
    m_sources.open(app::ArmRequest{path.toStdString()});
    emit armOpened(path);
}

void FileOpener::openSite(const QString& path) {
    for (const SourceManager::Item& item : m_sources.items()) {
        const auto* open = std::get_if<app::SiteRequest>(&item.request);
        if (open == nullptr || QFileInfo(QString::fromStdString(open->path)) != QFileInfo(path))
            continue;
        m_sources.activate(item.key);
        return;
    }
    if (m_awaitedSites.contains(path))
        return;
    m_awaitedSites.append(path);
    emit siteAwaited(QFileInfo(path).fileName());
    const auto connectTo = [path, &stop = m_stop, cancelled = m_cancelled] {
        return app::siteDevicesOf(path.toStdString(), stop, [cancelled] { return cancelled->load(); });
    };
    read(connectTo, [this, path](const core::Expected<app::SiteDevices>& found) {
        m_awaitedSites.removeOne(path);
        if (!found) {
            emit failed(QFileInfo(path).fileName(), found.error());
            return;
        }
        emit siteOpened(path);
        for (const app::SiteRequest& device : found->devices)
            m_sources.open(device);
    });
}

void FileOpener::openScene(const QString& path) {
    openScenes({path}, {}, false);
}

void FileOpener::openStudy(const QString& study, bool rehearse) {
    if (rehearse)
        m_study.watchRehearsal(study);
    else if (!study.isEmpty())
        m_study.open(study);
}

void FileOpener::openScenes(const QStringList& scenes, const QString& study, bool rehearse) {
    const auto studiesIn = [scenes] {
        std::vector<std::optional<study::StudyScene>> studies;
        for (const QString& scene : scenes) {
            core::Expected<app::AnyScene> any = app::readAnyScene(scene.toStdString());
            studies.emplace_back();
            if (any && std::holds_alternative<study::StudyScene>(*any))
                studies.back() = std::get<study::StudyScene>(std::move(*any));
        }
        return studies;
    };
    read(studiesIn,
         [this, scenes, study, rehearse](const std::vector<std::optional<study::StudyScene>>& studies) {
             bool isOpen = false;
             for (qsizetype i = 0; i < scenes.size(); ++i) {
                 const std::optional<study::StudyScene>& scene = studies[static_cast<std::size_t>(i)];
                 if (!scene) {
                     m_sources.open(app::SceneRequest{scenes[i].toStdString(), m_seed});
                     if (QFileInfo(scenes[i]).isFile() && !scenes[i].startsWith(QLatin1Char(':')))
                         emit sceneOpened(scenes[i]);
                     continue;
                 }
                 emit studyShown();
                 m_study.watchScene(*scene, m_seed, study);
                 isOpen = true;
             }
             if (!isOpen)
                 openStudy(study, rehearse);
         });
}

} // namespace teleta::console
