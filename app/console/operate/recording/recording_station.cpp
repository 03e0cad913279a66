// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_station.h"

#include "app/common/scene_file.h"
#include "app/console/bracelet/bracelet_station.h"
#include "backend/core/elapsed.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/recorded/recorded_camera.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/mark_changes.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <chrono>
#include <iterator>
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

const char* nameOf(pipeline::CameraEvent::Kind kind) {
    using Kind = pipeline::CameraEvent::Kind;
    switch (kind) {
    case Kind::begins:
        return "contact_begins";
    case Kind::bumps:
        return "bump";
    case Kind::ends:
        return "contact_ends";
    case Kind::follows:
        return "follows";
    case Kind::reference:
        return "reference";
    case Kind::restart:
        return "restart";
    }
    return "";
}

/// What of a source's state is worth an event; empty: nothing.
const char* nameOf(core::DeviceState state) {
    switch (state) {
    case core::DeviceState::live:
        return "source_live";
    case core::DeviceState::lost:
        return "source_lost";
    case core::DeviceState::paused:
        return "source_paused";
    case core::DeviceState::finished:
        return "source_finished";
    default:
        return "";
    }
}

/// Of the stream of an array.
std::string framesName(const std::string& prefix) {
    return prefix + "-frames";
}

core::DeviceState stateOf(const SourceManager::Item& item) {
    return item.camera ? item.camera->status().state : item.channel->status().state;
}

/// The scene that is recorded, when there is just one.
std::string sceneFileOf(const std::vector<SourceManager::Item>& items) {
    std::string file;
    for (const SourceManager::Item& item : items) {
        const auto* scene = std::get_if<SceneRequest>(&item.request);
        if (scene != nullptr && !file.empty())
            return {};
        if (scene != nullptr)
            file = scene->path;
    }
    return file;
}

} // namespace

/// Something that is done to a mark, and undone.
class MarkCommand : public QUndoCommand {
public:
    enum class What { add, remove, rename };
    MarkCommand(RecordingStation& station, What what, RecordingMark mark, QString text = {})
        : m_station(station)
        , m_what(what)
        , m_mark(std::move(mark))
        , m_text(std::move(text)) {
        setText(what == What::add      ? RecordingStation::tr("mark")
                : what == What::remove ? RecordingStation::tr("removal of a mark")
                                       : RecordingStation::tr("text of a mark"));
    }

    void redo() override {
        if (m_what == What::rename)
            m_station.setMarkText(m_mark.number, m_text);
        else
            setThere(m_what == What::add);
    }
    void undo() override {
        if (m_what == What::rename)
            m_station.setMarkText(m_mark.number, m_mark.text);
        else
            setThere(m_what != What::add);
    }

private:
    void setThere(bool there) {
        if (there)
            m_station.addMark(m_mark);
        else
            m_station.dropMark(m_mark.number);
    }

    RecordingStation& m_station;
    What m_what;
    RecordingMark m_mark;
    QString m_text;
};

RecordingStation::RecordingStation(SourceManager& sources, BraceletStation& bracelet,
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
    connect(&m_sources, &SourceManager::closed, this, &RecordingStation::leave);
}

RecordingStation::~RecordingStation() {
    if (m_starting.valid()) {
        if (const Started started = m_starting.get())
            (void)(*started)->stop();
    }
    if (m_stopping.valid())
        m_stopping.wait();
    if (m_recorder)
        (void)m_recorder->stop();
    if (m_keeping.valid()) {
        Kept kept = m_keeping.get();
        giveBack(kept);
    }
    (void)keepInFiles(m_markChanges);
}

QString RecordingStation::suggestedName() const {
    const auto* shown = m_sources.active();
    const QString time = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd'T'HHmmss'Z'"));
    return time + (shown != nullptr ? QLatin1Char('-') + plainName(shown->name) : QString()) +
           QStringLiteral(".teleta");
}

RecordingStation::Started RecordingStation::startRecorder(const QString& path, recording::RecordingHead head,
                                                          const std::string& sceneFile) {
    const QFileInfo file(path);
    if (!QDir().mkpath(file.path()))
        return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                            tr("the folder cannot be made").toStdString(),
                                            tr("a folder that can be written to").toStdString(),
                                            {file.path().toStdString()}});
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

void RecordingStation::start(const QString& path) {
    if (m_state != State::idle)
        return;
    m_path = path;
    m_stopWanted = false;
    m_status = {};
    m_marks.clear();
    m_undo.clear();
    emit marksChanged();
    recording::RecordingHead head;
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    head.start_ns = core::steadyNow_ns();
    m_start_ns = head.start_ns;
    QJsonArray sources;
    for (const SourceManager::Item& item : m_sources.items()) {
        QJsonObject source{{"name", item.name}};
        if (const auto* scene = std::get_if<SceneRequest>(&item.request)) {
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
        std::async(std::launch::async, &RecordingStation::startRecorder, path, std::move(head), sceneFile);
    enter(State::starting);
}

void RecordingStation::begin(std::shared_ptr<Recorder> recorder) {
    m_recorder = std::move(recorder);
    m_path = QString::fromStdString(m_recorder->path());
    m_joined.clear();
    m_states.clear();
    m_settings.clear();
    m_prefixes.clear();
    m_braceletSession.reset();
    m_wasStopped = m_stop.engaged();
    enter(State::recording);
    for (SourceManager::Item& item : m_sources.items())
        if (item.isOpen())
            join(item);
    watch();
}

void RecordingStation::stop() {
    if (m_state == State::starting)
        m_stopWanted = true;
    if (m_state == State::recording) {
        // What happened since the last tick is told too.
        watch();
        close();
    }
}

void RecordingStation::close() {
    for (SourceManager::Item& item : m_sources.items()) {
        if (item.channel)
            item.channel->record(nullptr);
        if (item.arm)
            item.arm->record(nullptr);
        if (item.camera)
            item.camera->record(nullptr);
    }
    if (const auto session = m_braceletSession.lock())
        session->record(nullptr);
    m_braceletSession.reset();
    // What was done while it was recorded is not undone by mistake long after its end.
    m_undo.clear();
    m_stopping = std::async(std::launch::async, [recorder = m_recorder] { return recorder->stop(); });
    enter(State::stopping);
}

void RecordingStation::enter(State state) {
    m_state = state;
    emit stateChanged();
}

void RecordingStation::tick() {
    if (isReady(m_keeping)) {
        Kept kept = m_keeping.get();
        const bool areNew = !m_markChanges.empty();
        const bool isKept = kept.left.empty();
        giveBack(kept);
        if (areNew)
            keepInFile();
        if (!isKept)
            emit marksNotKept(kept.why);
    }
    if (isReady(m_starting)) {
        Started started = m_starting.get();
        if (!started) {
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
    keepInFile();
    if (done)
        emit finished(m_path);
    else
        emit failed(done.error(), true);
}

void RecordingStation::watch() {
    joinBracelet();
    if (const bool stopped = m_stop.engaged(); stopped != m_wasStopped) {
        m_wasStopped = stopped;
        tell(stopped ? "stop_engaged" : "stop_released", {});
    }
    for (const SourceManager::Item& item : m_sources.items()) {
        const auto joined = m_joined.find(item.key);
        if (!item.isOpen() || joined == m_joined.end())
            continue;
        watchSettings(item, joined->second);
        const core::DeviceState state = stateOf(item);
        const char* name = nameOf(state);
        if (*name == '\0' || m_states[item.key] == state)
            continue;
        m_states[item.key] = state;
        tell(name, joined->second);
    }
}

void RecordingStation::watchSettings(const SourceManager::Item& item, const std::string& prefix) {
    const auto told = m_settings.find(item.key);
    if (!item.channel || told == m_settings.end())
        return;
    // Before the settings: newer ones are told again.
    const std::uint64_t revision = item.channel->settingsRevision();
    if (std::exchange(told->second.revision, revision) == revision)
        return;
    recording::RecordingEvent event = pipeline::settingsEvent(framesName(prefix), item.channel->settings());
    if (std::exchange(told->second.text, event.text) == event.text)
        return;
    event.time_ns = core::steadyNow_ns();
    m_recorder->add(std::move(event));
}

void RecordingStation::tell(const std::string& kind, const std::string& text) {
    m_recorder->add({.time_ns = core::steadyNow_ns(), .kind = kind, .text = text});
}

std::string RecordingStation::prefixFor(const QString& name) {
    const std::string wanted = plainName(name).toStdString();
    std::string prefix = wanted;
    for (int number = 2; std::ranges::find(m_prefixes, prefix) != m_prefixes.end(); ++number)
        prefix = wanted + "-" + std::to_string(number);
    m_prefixes.push_back(prefix);
    return prefix;
}

void RecordingStation::join(SourceManager::Item& item) {
    const std::string prefix = prefixFor(item.name);
    m_joined[item.key] = prefix;
    tell("source_joined", prefix);
    if (item.camera)
        joinCamera(item, prefix);
    else
        joinArray(item, prefix);
}

void RecordingStation::joinArray(SourceManager::Item& item, const std::string& prefix) {
    const std::string frames = framesName(prefix);
    const std::uint64_t revision = item.channel->settingsRevision();
    const pipeline::ChannelSettings settings = item.channel->settings();
    m_settings[item.key] = {revision, pipeline::settingsEvent(frames, settings).text};
    core::SourceDescription description = item.channel->description();
    auto taps = std::make_shared<pipeline::TouchTaps>();
    taps->frames = m_recorder->addStream(pipeline::arrayStream(frames, description, settings));
    taps->features = m_recorder->addStream(pipeline::featureStream(prefix + "-features", description));
    item.channel->record(std::move(taps));
    if (!item.arm)
        return;
    auto armTaps = std::make_shared<pipeline::ArmTaps>();
    armTaps->joints =
        m_recorder->addStream(pipeline::armStream(prefix + "-joints", item.arm->description(), frames));
    armTaps->touches =
        m_recorder->addStream(pipeline::touchStream(prefix + "-touches", item.arm->description()));
    item.arm->record(std::move(armTaps));
}

void RecordingStation::joinCamera(SourceManager::Item& item, const std::string& prefix) {
    const core::CameraDescription& description = item.camera->description();
    const std::string reference = prefix + "-reference";
    auto taps = std::make_shared<pipeline::CameraTaps>();
    taps->reference = m_recorder->addStream(pipeline::referenceStream(reference, description));
    taps->pictures =
        m_recorder->addStream(pipeline::cameraStream(prefix + "-camera", description, item.camera->camera(),
                                                     item.camera->settings().tracker.bump, reference));
    taps->contacts = m_recorder->addStream(pipeline::contactStream(prefix + "-contacts", description));
    taps->event = [recorder = std::weak_ptr<Recorder>(m_recorder), prefix](const pipeline::CameraEvent& event,
                                                                           std::int64_t time_ns) {
        if (const auto kept = recorder.lock())
            kept->add({.time_ns = time_ns,
                       .kind = nameOf(event.kind),
                       .text = prefix,
                       .value = static_cast<double>(event.contact)});
    };
    item.camera->record(std::move(taps));
}

void RecordingStation::joinBracelet() {
    const std::shared_ptr<BraceletSession>& session = m_bracelet.session();
    if (session == m_braceletSession.lock())
        return;
    m_braceletSession = session;
    if (session)
        session->record(m_recorder->addStream(pipeline::tactorStream(
            "bracelet", session->source().description(), session->player().rate_Hz())));
}

void RecordingStation::leave(pipeline::ChannelKey key) {
    const auto joined = m_joined.find(key);
    if (joined == m_joined.end())
        return;
    if (isRecording())
        tell("source_left", joined->second);
    m_joined.erase(joined);
}

void RecordingStation::mark() {
    mark(core::steadyNow_ns());
}

void RecordingStation::mark(std::int64_t time_ns) {
    if (!isRecording())
        return;
    const std::int64_t inside_ns = std::clamp(time_ns, m_start_ns, core::steadyNow_ns());
    m_undo.push(new MarkCommand(*this, MarkCommand::What::add,
                                {0, inside_ns, core::elapsed_s(m_start_ns, inside_ns), {}}));
}

void RecordingStation::renameMark(std::uint64_t number, const QString& text) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found != m_marks.end() && found->text != text)
        m_undo.push(new MarkCommand(*this, MarkCommand::What::rename, *found, text));
}

void RecordingStation::removeMark(std::uint64_t number) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found != m_marks.end())
        m_undo.push(new MarkCommand(*this, MarkCommand::What::remove, *found));
}

void RecordingStation::keep(recording::MarkChange change) {
    if (!isRecording()) {
        const std::string path = m_path.toStdString();
        if (m_markChanges.empty() || m_markChanges.back().path != path)
            m_markChanges.push_back({path, {}});
        m_markChanges.back().changes.push_back(std::move(change));
        keepInFile();
    } else if (change.restored_ns) {
        m_recorder->restoreMark(change.number, std::move(*change.note), *change.restored_ns);
    } else if (change.note) {
        m_recorder->renameMark(change.number, std::move(*change.note));
    } else {
        m_recorder->removeMark(change.number);
    }
}

void RecordingStation::keepInFile() {
    // One after the other: those that come meanwhile wait.
    if (m_markChanges.empty() || m_state != State::idle || m_keeping.valid())
        return;
    m_keeping =
        std::async(std::launch::async, &RecordingStation::keepInFiles, std::exchange(m_markChanges, {}));
}

void RecordingStation::giveBack(Kept& kept) {
    m_markChanges.insert(m_markChanges.begin(), std::make_move_iterator(kept.left.begin()),
                         std::make_move_iterator(kept.left.end()));
    kept.left.clear();
}

RecordingStation::Kept RecordingStation::keepInFiles(const std::vector<FileChanges>& all) {
    Kept kept;
    for (const FileChanges& file : all) {
        // None before those that came earlier.
        const bool waits = std::ranges::find(kept.left, file.path, &FileChanges::path) != kept.left.end();
        const core::Expected<void> done =
            waits ? core::Expected<void>() : recording::changeMarks(file.path, file.changes);
        if (!done && kept.left.empty())
            kept.why = done.error();
        if (!done || waits)
            kept.left.push_back(file);
    }
    return kept;
}

void RecordingStation::addMark(RecordingMark& mark) {
    // One that comes back keeps its number: older commands know it by that.
    if (mark.number == 0)
        mark.number = m_recorder->mark(mark.text.toStdString(), mark.time_ns);
    else
        keep({mark.number, mark.text.toStdString(), mark.time_ns});
    const auto place = std::ranges::upper_bound(m_marks, mark.time_ns, {}, &RecordingMark::time_ns);
    m_marks.insert(place, mark);
    emit marksChanged();
}

void RecordingStation::dropMark(std::uint64_t number) {
    keep({number, std::nullopt});
    std::erase_if(m_marks, [&](const RecordingMark& mark) { return mark.number == number; });
    emit marksChanged();
}

void RecordingStation::setMarkText(std::uint64_t number, const QString& text) {
    const auto found = std::ranges::find(m_marks, number, &RecordingMark::number);
    if (found == m_marks.end())
        return;
    keep({number, text.toStdString()});
    found->text = text;
    emit marksChanged();
}

} // namespace teleta::console
