// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_service.h"

#include "app/common/scene_file.h"
#include "app/console/bracelet/bracelet_service.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/event_words.h"
#include "devices/site/site_client.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalBlocker>

#include <algorithm>
#include <chrono>
#include <utility>

namespace teleta::console {

namespace {

using recording::Recorder;
using recording::RecorderStatus;

template <typename Value>
bool isReady(const std::future<Value>& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// As part of a file's name.
QString plainName(const QString& name) {
    QString plain = name;
    for (QChar& letter : plain)
        if (!letter.isLetterOrNumber() && letter != QLatin1Char('-') && letter != QLatin1Char('_'))
            letter = QLatin1Char('-');
    while (plain.contains(QLatin1String("--")))
        plain.replace(QLatin1String("--"), QLatin1String("-"));
    while (plain.endsWith(QLatin1Char('-')))
        plain.chop(1);
    while (plain.startsWith(QLatin1Char('-')))
        plain.remove(0, 1);
    return plain.isEmpty() ? QStringLiteral("source") : plain.left(60);
}

/// The scene that is recorded, when there is just one.
std::string sceneFileOf(const std::vector<SourceManager::Item>& items) {
    std::string file;
    for (const SourceManager::Item& item : items) {
        const auto* scene = std::get_if<app::SceneRequest>(&item.request);
        if (scene != nullptr && !file.empty())
            return {};
        if (scene != nullptr)
            file = scene->path;
    }
    return file;
}

} // namespace

RecordingService::RecordingService(SourceManager& sources, BraceletService& bracelet,
                                   const core::StopSwitch& stop, QObject* parent)
    : QObject(parent)
    , m_sources(sources)
    , m_bracelet(bracelet)
    , m_stop(stop) {
    connect(&m_sources, &SourceManager::opened, this, [this](pipeline::ChannelKey key) {
        SourceManager::Item* item = m_sources.find(key);
        if (isRecording() && item != nullptr)
            join(*item);
    });
    connect(&m_sources, &SourceManager::closed, this, &RecordingService::leave);
}

RecordingService::~RecordingService() {
    if (m_starting.valid()) {
        if (const Started started = m_starting.get())
            (void)(*started)->stop();
    }
    if (m_stopping.valid())
        m_stopping.wait();
    if (m_recorder)
        (void)m_recorder->stop();
}

QString RecordingService::suggestedName() const {
    const auto* shown = m_sources.active();
    const QString time = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"));
    return time + (shown != nullptr ? QLatin1Char('-') + plainName(shown->name) : QString()) +
           QStringLiteral(".teleta");
}

RecordingService::Started RecordingService::startRecorder(const QString& path, recording::RecordingHead head,
                                                          const std::string& sceneFile) {
    const QFileInfo file(path);
    if (!QDir().mkpath(file.path()))
        return core::failed(core::ErrorKind::ioFailed, tr("the folder cannot be made"),
                            tr("a folder that can be written to"), {file.path().toStdString()});
    if (!sceneFile.empty())
        head.sceneText = app::readSceneText(sceneFile);
    constexpr int kMostNumbers = 1000;
    for (int number = 1;; ++number) {
        const QString numbered = number == 1
                                     ? path
                                     : file.dir().filePath(QStringLiteral("%1-%2.%3")
                                                               .arg(file.completeBaseName(),
                                                                    QString::number(number), file.suffix()));
        auto recorder = Recorder::start(numbered.toStdString(), head);
        if (recorder)
            return std::shared_ptr<Recorder>(std::move(*recorder));
        if (recorder.error().kind != core::ErrorKind::refused || number >= kMostNumbers)
            return core::Unexpected(recorder.error());
    }
}

void RecordingService::start(const QString& path) {
    if (m_state != State::idle)
        return;
    m_path = path;
    m_stopWanted = false;
    m_status = {};
    m_marks.clear();
    recording::RecordingHead head;
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    head.start_ns = core::steadyNow_ns();
    m_start_ns = head.start_ns;
    QJsonArray sources;
    for (const SourceManager::Item& item : m_sources.items()) {
        QJsonObject source{{"name", item.name}};
        if (const auto* scene = std::get_if<app::SceneRequest>(&item.request)) {
            source["scene"] = QString::fromStdString(scene->path);
            source["seed"] = static_cast<qint64>(scene->seed);
        }
        sources.append(source);
    }
    QJsonObject configuration{{"sources", sources}};
    if (const auto& session = m_bracelet.session())
        configuration["bracelet"] = QString::fromStdString(session->source().description().name);
    head.configuration = QJsonDocument(configuration).toJson(QJsonDocument::Compact).toStdString();
    const std::string sceneFile = sceneFileOf(m_sources.items());
    head.scene = QFileInfo(QString::fromStdString(sceneFile)).completeBaseName().toStdString();
    m_starting =
        std::async(std::launch::async, &RecordingService::startRecorder, path, std::move(head), sceneFile);
    enter(State::starting);
}

void RecordingService::begin(std::shared_ptr<Recorder> recorder) {
    m_recorder = std::move(recorder);
    m_path = QString::fromStdString(m_recorder->path());
    m_joined.clear();
    m_states.clear();
    m_prefixes.clear();
    m_braceletSession.reset();
    m_wasStopped = m_stop.engaged();
    m_marks.begin(m_recorder, m_start_ns);
    enter(State::recording);
    for (SourceManager::Item& item : m_sources.items())
        if (item.isOpen())
            join(item);
    watch();
}

void RecordingService::stop() {
    if (m_state == State::starting)
        m_stopWanted = true;
    if (m_state == State::recording) {
        // What happened since the last tick is told too.
        watch();
        close();
    }
}

void RecordingService::add(recording::RecordingEvent event) {
    if (isRecording())
        m_recorder->add(std::move(event));
}

void RecordingService::completeNow() {
    const QSignalBlocker own(this);
    const QSignalBlocker marks(m_marks);
    if (m_starting.valid()) {
        if (const Started started = m_starting.get())
            (void)(*started)->stop();
        m_state = State::idle;
    }
    stop();
    if (m_stopping.valid())
        m_stopping.wait();
}

void RecordingService::close() {
    for (SourceManager::Item& item : m_sources.items()) {
        if (item.channel)
            item.channel->record(nullptr, {});
    }
    if (const auto session = m_braceletSession.lock())
        session->record(nullptr);
    m_braceletSession.reset();
    for (const auto& known : m_sites) {
        if (const auto site = known.lock())
            site->recordClock(nullptr);
    }
    m_sites.clear();
    m_marks.end();
    m_stopping = std::async(std::launch::async, [recorder = m_recorder] { return recorder->stop(); });
    enter(State::stopping);
}

void RecordingService::enter(State state) {
    m_state = state;
    emit stateChanged();
}

void RecordingService::tick() {
    m_marks.tick();
    if (isReady(m_starting)) {
        Started started = m_starting.get();
        if (!started) {
            m_marks.release();
            enter(State::idle);
            emit failed(started.error(), false);
            return;
        }
        begin(std::move(*started));
        if (m_stopWanted)
            close();
    }
    if (!m_recorder)
        return;
    m_status = m_recorder->status();
    if (isRecording()) {
        // A write that failed has ended it.
        if (m_status.state == RecorderStatus::State::failed)
            close();
        else
            watch();
    }
    if (!isReady(m_stopping))
        return;
    const core::Expected<void> done = m_stopping.get();
    m_status = m_recorder->status();
    m_recorder.reset();
    enter(State::idle);
    m_marks.release();
    if (done)
        emit finished(m_path);
    else
        emit failed(done.error(), true);
}

void RecordingService::watch() {
    joinBracelet();
    if (const bool stopped = m_stop.engaged(); stopped != m_wasStopped) {
        m_wasStopped = stopped;
        tell(stopped ? recording::kStopEngaged : recording::kStopReleased, {});
    }
    for (const SourceManager::Item& item : m_sources.items()) {
        const auto joined = m_joined.find(item.key);
        if (!item.isOpen() || joined == m_joined.end())
            continue;
        if (auto event = item.channel->takeSettingsEvent())
            m_recorder->add(std::move(*event));
        const core::DeviceState state = item.channel->status().state;
        const char* word = recording::stateWord(state);
        if (*word == '\0' || m_states[item.key] == state)
            continue;
        m_states[item.key] = state;
        tell(word, joined->second);
    }
}

void RecordingService::tell(const std::string& kind, const std::string& text) {
    m_recorder->add({.time_ns = core::steadyNow_ns(), .kind = kind, .text = text});
}

std::string RecordingService::prefixFor(const QString& name) {
    const std::string wanted = plainName(name).toStdString();
    std::string prefix = wanted;
    for (int number = 2; std::ranges::find(m_prefixes, prefix) != m_prefixes.end(); ++number)
        prefix = wanted + "-" + std::to_string(number);
    m_prefixes.push_back(prefix);
    return prefix;
}

void RecordingService::join(SourceManager::Item& item) {
    const std::string prefix = prefixFor(item.name);
    m_joined[item.key] = prefix;
    tell(recording::kSourceJoined, prefix);
    item.channel->record(m_recorder, prefix);
    joinSite(item);
}

void RecordingService::joinSite(const SourceManager::Item& item) {
    const auto* remote = std::get_if<app::SiteRequest>(&item.request);
    const auto site = remote != nullptr ? remote->site.lock() : nullptr;
    if (!site || std::ranges::any_of(m_sites, [&](const auto& known) { return known.lock() == site; }))
        return;
    m_sites.push_back(site);
    recording::StreamInfo stream = site->clockStream();
    stream.name = prefixFor(QString::fromStdString(stream.name));
    site->recordClock(m_recorder->addStream(std::move(stream)));
}

void RecordingService::joinBracelet() {
    const std::shared_ptr<BraceletSession>& session = m_bracelet.session();
    if (session == m_braceletSession.lock())
        return;
    m_braceletSession = session;
    if (session)
        session->record(m_recorder->addStream(pipeline::tactorStream(
            "bracelet", session->source().description(), session->player().rate_Hz())));
}

void RecordingService::leave(pipeline::ChannelKey key) {
    const auto joined = m_joined.find(key);
    if (joined == m_joined.end())
        return;
    if (isRecording())
        tell(recording::kSourceLeft, joined->second);
    m_joined.erase(joined);
}

} // namespace teleta::console
