// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/operate_page.h"

#include "app/console/sources/source_provenance.h"
#include "app/console/start/start_page.h"
#include "app/sources/site_request.h"
#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/touch/skin_contact.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/chrome/empty_state.h"
#include "widgets/chrome/playback_bar.h"
#include "widgets/servo/servo_panel.h"
#include "widgets/tactile/channel_settings_panel.h"
#include "widgets/tactile/heatmap_view.h"
#include "widgets/tactile/tare_question.h"
#include "widgets/view3d/scene3d_view.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>
#include <variant>

namespace teleta::console {

namespace {

/// What the status bar says of a device, but for what only its page knows.
chrome::DeviceReading readingOf(const core::DeviceStatus& status, const SourceManager::Item& item,
                                double nominalRate_Hz) {
    const std::int64_t now_ns = core::steadyNow_ns();
    chrome::DeviceReading reading;
    reading.provenance = provenanceOf(item);
    // A recording may be played as slowly as one likes: its frames are old by nature, not stale.
    reading.state = item.channel->summary().recorded
                        ? status.state
                        : core::observedState(status.state, status.lastData_ns, now_ns,
                                              core::staleAfter_ns(nominalRate_Hz));
    reading.age_s = status.lastData_ns > 0 ? static_cast<double>(now_ns - status.lastData_ns) * 1e-9 : 0.0;
    reading.rate_Hz = status.rate_Hz;
    reading.lost = status.framesLost;
    if (const auto array = item.array())
        reading.countsLosses = array->countsLosses();
    reading.details = QString::fromStdString(status.message);
    return reading;
}

} // namespace

OperatePage::OperatePage(SourceManager& sources, BraceletService& bracelet, core::StopSwitch& stop,
                         QWidget* parent)
    : QWidget(parent)
    , m_sources(sources)
    , m_bracelet(bracelet)
    , m_stop(stop)
    , m_messages(new chrome::MessageBar(this))
    , m_watch(*m_messages)
    , m_chooser(new chrome::SourceChooser(this))
    , m_playback(new chrome::PlaybackBar(this))
    , m_stack(new QStackedWidget(this))
    , m_start(new StartPage(this))
    , m_opening(new chrome::EmptyState(base::Icon::operate, this))
    , m_docks(new OperateDocks(this))
    , m_heatmap(new tactile::HeatmapView(this))
    , m_charts(new charts::StripChartView(this))
    , m_scene(new view3d::Scene3dView(this))
    , m_settings(new tactile::ChannelSettingsPanel(this))
    , m_arm(new ArmViews(stop, m_bracelet, *m_scene, this))
    , m_servo(new ServoViews(*m_scene, this))
    , m_camera(new CameraViews(*m_scene, this))
    , m_gel(new GelViews(*m_scene, this))
    , m_looking(new SceneViews(this))
    , m_marks(new MarkViews(*m_charts, this))
    , m_site(new SiteViews(*m_messages, this)) {
    auto* top = new QHBoxLayout;
    top->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this), base::grid(this, 0.5));
    top->addWidget(m_chooser);
    top->addWidget(m_playback, 1);
    top->addStretch(0);

    m_docks->add(OperateDocks::heatmap, m_heatmap);
    m_docks->add(OperateDocks::reconstruction, m_scene);
    m_docks->add(OperateDocks::charts, m_charts);
    m_docks->addScrolling(OperateDocks::processing, m_settings);
    m_arm->addTo(*m_docks);
    m_servo->addTo(*m_docks);
    m_camera->addTo(*m_docks);
    m_gel->addTo(*m_docks);
    m_looking->addTo(*m_docks);
    m_docks->add(OperateDocks::marks, &m_marks->list());
    m_docks->begin();

    auto* cancel = m_opening->addAction(QString(), QString());
    cancel->setObjectName(QStringLiteral("cancelOpening"));
    m_stack->addWidget(m_start);
    m_stack->addWidget(m_opening);
    m_stack->addWidget(m_docks);
    // What is not seen needs no room.
    const auto giveRoom = [this] {
        for (QWidget* page : {static_cast<QWidget*>(m_start), static_cast<QWidget*>(m_opening),
                              static_cast<QWidget*>(m_docks)}) {
            const auto policy =
                page == m_stack->currentWidget() ? QSizePolicy::Preferred : QSizePolicy::Ignored;
            page->setSizePolicy(policy, policy);
        }
    };
    connect(m_stack, &QStackedWidget::currentChanged, this, giveRoom);
    giveRoom();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addLayout(top);
    layout->addWidget(&m_site->bar());
    layout->addWidget(m_stack, 1);

    connect(cancel, &QPushButton::clicked, this, [this] {
        if (!m_sources.items().empty())
            emit closeRequested(m_sources.items().back().key);
    });
    connect(m_start, &StartPage::cardRequested, this, &OperatePage::openCard);
    connect(m_start, &StartPage::demoRequested, this, &OperatePage::demoRequested);
    connect(m_start, &StartPage::handbookRequested, this, &OperatePage::firstStepsRequested);
    connect(m_start, &StartPage::openRecordingRequested, this, &OperatePage::openRecordingRequested);
    connect(m_start, &StartPage::openListRequested, this, &OperatePage::openListRequested);

    connect(&m_sources, &SourceManager::activeChanged, this, &OperatePage::onActiveChanged);
    connect(&m_sources, &SourceManager::itemsChanged, this, &OperatePage::onSourcesChanged);
    connect(m_chooser, &chrome::SourceChooser::sourceChosen, &m_sources, &SourceManager::activate);
    connect(m_chooser, &chrome::SourceChooser::closeRequested, this, &OperatePage::closeRequested);
    connect(m_settings, &tactile::ChannelSettingsPanel::settingsChanged, this,
            [this](const pipeline::ChannelSettings& settings) {
                if (const auto array = shownArray())
                    array->post(settings);
            });
    connect(m_settings, &tactile::ChannelSettingsPanel::tareRequested, this, [this] {
        if (const auto array = shownArray())
            tactile::askToTare(
                this, tactile::loadedTaxels(array->snapshot(), array->settings().features.threshold_N),
                [array] { array->requestTare(); });
    });
    connect(m_settings, &tactile::ChannelSettingsPanel::clearTareRequested, this, [this] {
        if (const auto array = shownArray())
            array->clearTare();
    });
    const auto report = [this](const QString& text) {
        m_messages->post(
            {chrome::Message::Severity::error, text, tr("Choose another folder or file name."), {}});
    };
    connect(m_heatmap, &tactile::HeatmapView::exportFailed, this, report);
    connect(m_charts, &charts::StripChartView::exportFailed, this, report);
    connect(m_scene, &view3d::Scene3dView::failed, this, report);
    connect(m_arm, &ArmViews::exportFailed, this, report);
    connect(m_arm, &ArmViews::meshesFailed, this, [this](const QString& text) {
        m_messages->post({chrome::Message::Severity::warning,
                          text,
                          tr("Check mesh_path in the file with which you opened the arm or its site."),
                          {}});
    });
    connect(m_arm, &ArmViews::jointsUnknown, this, [this](const QString& text) {
        m_messages->post({chrome::Message::Severity::information,
                          text,
                          tr("They are left out. Compare [joint_names] in the arm's file."),
                          {}});
    });
    connect(m_camera, &CameraViews::exportFailed, this, report);
    connect(m_gel, &GelViews::exportFailed, this, report);
    connect(m_looking, &SceneViews::exportFailed, this, report);
    connect(m_servo, &ServoViews::failed, this, report);
    connect(&m_servo->panel(), &servo::ServoPanel::runRequested, this, &OperatePage::setProgramRunning);
    connect(&m_servo->panel(), &servo::ServoPanel::restartRequested, this, &OperatePage::restartProgram);
    connect(&m_arm->feedbackPanel(), &FeedbackPanel::failed, this, report);
    connect(&m_bracelet, &BraceletService::failed, this, &OperatePage::onBraceletFailed);
    connectPlayback();
    base::keepTranslated(this, &OperatePage::retranslate);
    onSourcesChanged();
    onActiveChanged();
}

/// What a source that is not shown tells is of no use but for what happened to it.
void OperatePage::passOver(SourceManager::Item& item) {
    m_arm->keep(item.arm());
    m_camera->keep(item.camera());
    m_gel->keep(item.gel());
    m_arm->keepJoints(item.joints());
    const auto kept = m_keptCharts.find(item.key);
    if (const auto array = item.array(); array && kept != m_keptCharts.end()) {
        pipeline::FeatureSample sample;
        while (array->popSample(sample))
            kept->second.append(sample);
    }
    item.channel->drain();
}

void OperatePage::setCompact(bool low, bool small) {
    m_arm->setCompact(low || small, small);
    m_docks->setSmall(small);
}

void OperatePage::tick() {
    const std::int64_t now_ns = core::steadyNow_ns();
    for (SourceManager::Item& item : m_sources.items()) {
        if (!item.isOpen())
            continue;
        m_watch.look(item);
        if (item.sceneCamera())
            tickSceneCamera(item, now_ns);
        if (&item != m_sources.active())
            passOver(item);
        else if (const auto array = item.array())
            tickArray(*array, item, now_ns);
    }
    m_marks->tick();
    const SourceManager::Item* shown = m_sources.active();
    const auto* remote = shown != nullptr ? std::get_if<app::SiteRequest>(&shown->request) : nullptr;
    const auto site = remote != nullptr ? remote->site.lock() : nullptr;
    m_site->setSite(site);
    m_site->setLosses(lossesOf(site.get()));
    m_site->tick();
    m_bracelet.setSiteClock(m_site->clock());
    m_charts->refresh();
    m_bracelet.tick();
    m_arm->tick();
    m_servo->panel().setStopEngaged(m_stop.engaged());
    m_servo->tick();
    SourceManager::Item* active = m_sources.active();
    if (m_camera->tick() && active != nullptr) {
        ++active->displayed;
        m_latency_s = m_camera->latency_s();
    }
    if (m_gel->tick() && active != nullptr) {
        ++active->displayed;
        m_latency_s = m_gel->latency_s();
    }
    if (active != nullptr && active->joints() && !active->arm()) {
        active->displayed = active->joints()->samplesProcessed() - active->joints()->samplesNotShown();
        m_latency_s = m_arm->latency_s();
    }
    if (core::PlaybackControl* control = playback())
        m_playback->setPosition(control->position());
}

std::vector<site_view::SiteBarState::Count> OperatePage::lossesOf(const site_link::SiteClient* site) const {
    std::vector<site_view::SiteBarState::Count> losses;
    for (const SourceManager::Item& item : m_sources.items()) {
        const auto* remote = std::get_if<app::SiteRequest>(&item.request);
        if (site == nullptr || remote == nullptr || !item.isOpen() || remote->site.lock().get() != site)
            continue;
        const QString name = QString::fromStdString(remote->device);
        const auto joints = item.joints();
        if (joints)
            losses.emplace_back(tr("%1: joints", "a source").arg(name), joints->jointStatus().framesLost);
        const auto array = item.array();
        const std::uint64_t atSite = array ? array->lostAtSite() : 0;
        if (!joints || item.arm())
            losses.emplace_back(name, item.channel->status().framesLost - atSite);
    }
    return losses;
}

void OperatePage::tickSceneCamera(SourceManager::Item& item, std::int64_t now_ns) {
    const chrome::DeviceReading reading =
        readingOf(item.channel->status(), item, item.channel->summary().nominalRate_Hz);
    if (m_looking->tick(item, reading, now_ns) && &item == m_sources.active())
        m_latency_s = m_looking->latency_s(item.key);
}

void OperatePage::tickArray(pipeline::TouchChannel& array, SourceManager::Item& item, std::int64_t now_ns) {
    pipeline::FeatureSample sample;
    while (array.popSample(sample)) {
        m_charts->append(sample);
        m_marks->take(sample);
    }
    const core::DeviceState state = readingOf(array.status(), item, array.summary().nominalRate_Hz).state;
    m_heatmap->setOld(state == core::DeviceState::stale || state == core::DeviceState::lost);
    if (!array.update())
        return;
    showFrame(array.snapshot());
    m_heatmap->setLoads(array.newestLoads());
    ++item.displayed;
    m_latency_s = static_cast<double>(now_ns - array.snapshot().time_ns) * 1e-9;
    if (m_settingsRevision != array.settingsRevision()) {
        m_settingsRevision = array.settingsRevision();
        m_settings->setSettings(array.settings(), array.description().layout);
    }
}

void OperatePage::showFrame(pipeline::TouchSnapshot frame) {
    const SourceManager::Item* shown = m_sources.active();
    if (const auto arm = shown != nullptr ? shown->arm() : nullptr)
        pipeline::joinAtSeam(frame, 2.0 * std::numbers::pi * arm->description().skin.radius_m);
    m_heatmap->setSnapshot(frame);
    m_scene->setSnapshot(frame);
}

std::vector<chrome::DeviceReading> OperatePage::readings() const {
    std::vector<chrome::DeviceReading> readings;
    std::vector<chrome::DeviceReading> joints;
    const auto arms =
        std::ranges::count_if(m_sources.items(), [](const auto& item) { return item.arm() != nullptr; });
    for (const SourceManager::Item& item : m_sources.items()) {
        chrome::DeviceReading reading;
        reading.state = core::DeviceState::connecting;
        if (item.isOpen())
            reading = readingOf(item.channel->status(), item, item.channel->summary().nominalRate_Hz);
        reading.name = item.name;
        reading.active = &item == m_sources.active();
        reading.displayed = item.displayed;
        if (item.isOpen() && reading.active)
            reading.latency_s = m_latency_s;
        readings.push_back(std::move(reading));
        if (const auto arm = item.arm()) {
            reading = readingOf(arm->jointStatus(), item, arm->description().nominalRate_Hz);
            // Of several arms each has its own.
            reading.name = arms > 1 ? tr("%1: joints", "a source").arg(item.name) : tr("joints");
            reading.displayed = arm->samplesProcessed() - arm->samplesNotShown();
            joints.push_back(std::move(reading));
        }
    }
    std::ranges::move(joints, std::back_inserter(readings));
    if (auto bracelet = m_bracelet.reading()) {
        if (const SourceManager::Item* arm = unfeltArm())
            bracelet->remark = tr("not for %1", "the bracelet plays no touches of an arm").arg(arm->name);
        readings.push_back(std::move(*bracelet));
    }
    return readings;
}

const SourceManager::Item* OperatePage::unfeltArm() const {
    if (m_bracelet.choice() == BraceletChoice::none ||
        m_arm->feedbackPanel().mode() == pipeline::FeedbackMode::off)
        return nullptr;
    const SourceManager::Item* shown = m_sources.active();
    const auto unfelt = std::ranges::find_if(m_sources.items(), [shown](const SourceManager::Item& item) {
        return &item != shown && item.arm() != nullptr && !item.channel->summary().recorded;
    });
    return unfelt != m_sources.items().end() ? &*unfelt : nullptr;
}

void OperatePage::tellUnfelt() {
    const SourceManager::Item* shown = m_sources.active();
    const SourceManager::Item* arm = unfeltArm();
    if (arm == nullptr || shown == nullptr)
        return;
    m_messages->post({.text = tr("The bracelet does not play the touches of %1.", "an arm").arg(arm->name),
                      .advice = tr("It plays those of the arm that is shown."),
                      .details = {},
                      .actions = {{tr("Show %1", "an arm").arg(arm->name),
                                   [this, key = arm->key] { m_sources.activate(key); }}}});
}

std::shared_ptr<pipeline::TouchChannel> OperatePage::shownArray() const {
    const SourceManager::Item* item = m_sources.active();
    return item != nullptr ? item->array() : nullptr;
}

void OperatePage::onActiveChanged() {
    m_latency_s.reset();
    SourceManager::Item* item = m_sources.active();
    const pipeline::ChannelKey key = item != nullptr ? item->key : 0;
    const bool isOther = key != m_shown;
    changeCharts(key);
    m_marks->setSource(key, playback());
    const base::Provenance provenance = item != nullptr ? provenanceOf(*item) : base::Provenance::live;
    const auto array = shownArray();
    showArray(array.get(), provenance);
    const std::shared_ptr<pipeline::CameraChannel> camera = item != nullptr ? item->camera() : nullptr;
    if (camera != m_camera->camera())
        m_camera->setCamera(camera, provenance);
    const std::shared_ptr<pipeline::GelChannel> gel = item != nullptr ? item->gel() : nullptr;
    if (gel != m_gel->gel())
        m_gel->setGel(gel, provenance);
    // They draw into one scene: the one that goes leaves first.
    const std::shared_ptr<servo::ServoLink> servo = item != nullptr ? item->servo() : nullptr;
    const std::shared_ptr<pipeline::JointChannel> joints = item != nullptr ? item->joints() : nullptr;
    if (!joints && m_arm->joints())
        m_arm->setArm(nullptr, provenance);
    if (servo != m_servo->servo())
        m_servo->setServo(servo, servo ? item->name : QString(), provenance);
    if (joints != m_arm->joints())
        m_arm->setArm(joints, provenance);
    const bool looks = item != nullptr && item->sceneCamera() != nullptr;
    m_docks->setKind(camera         ? OperateDocks::Kind::camera
                     : looks        ? OperateDocks::Kind::scene
                     : gel          ? OperateDocks::Kind::gel
                     : m_arm->arm() ? OperateDocks::Kind::arm
                     : joints       ? OperateDocks::Kind::joints
                     : servo        ? OperateDocks::Kind::servo
                                    : OperateDocks::Kind::array);
    m_settings->setEnabled(array != nullptr);
    if (isOther) {
        m_scene->frame();
        tellUnfelt();
    }
    onSourcesChanged();
}

void OperatePage::changeCharts(pipeline::ChannelKey shown) {
    if (shown == m_shown)
        return;
    m_keptCharts.insert_or_assign(std::exchange(m_shown, shown), m_charts->takeHistory());
    std::erase_if(m_keptCharts, [this](const auto& kept) { return m_sources.find(kept.first) == nullptr; });
    if (auto kept = m_keptCharts.extract(shown))
        m_charts->setHistory(std::move(kept.mapped()));
}

void OperatePage::showArray(pipeline::TouchChannel* array, base::Provenance provenance) {
    m_scene->setProvenance(provenance);
    if (array == nullptr) {
        m_heatmap->clear();
        m_scene->clear();
        return;
    }
    m_heatmap->setProvenance(provenance);
    m_heatmap->setOld(false);
    m_charts->setProvenance(provenance);
    const pipeline::ChannelSettings settings = array->settings();
    m_charts->setLoadUnit(QString::fromStdString(settings.loadUnit));
    m_charts->setVectors(array->description().layout.isVector());
    m_settings->setSettings(settings, array->description().layout);
    m_settingsRevision = array->settingsRevision();
    m_heatmap->setLoads(array->newestLoads());
    if (array->generation() > 0) {
        showFrame(array->snapshot());
    }
}

void OperatePage::onSourcesChanged() {
    std::vector<chrome::SourceChooser::Source> sources;
    for (const SourceManager::Item& item : m_sources.items()) {
        sources.push_back({item.key, item.name, provenanceOf(item), !item.isOpen()});
    }
    const SourceManager::Item* active = m_sources.active();
    m_chooser->setSources(sources, active != nullptr ? active->key : 0);
    core::PlaybackControl* control = playback();
    m_playback->setMarks(control != nullptr ? control->marks() : std::vector<core::PlaybackMark>());
    m_playback->setVisible(control != nullptr);
    m_looking->setSources(m_sources.items());
    // The docks come with the source that they show: until then nobody knows which they are.
    showOpening();
    m_stack->setCurrentWidget(m_sources.items().empty() ? static_cast<QWidget*>(m_start)
                              : active == nullptr       ? static_cast<QWidget*>(m_opening)
                                                        : m_docks);
}

void OperatePage::showOpening() {
    const QString name = m_sources.items().empty() ? QString() : m_sources.items().back().name;
    m_opening->setTexts(tr("Opening %1\u2026", "a source").arg(name),
                        tr("Its views come up as soon as it answers."));
    m_opening->setAction("cancelOpening", tr("&Cancel"), tr("Closes it again"));
}

template <typename Call>
void OperatePage::withOthers(const Call& call) {
    SourceManager::Item* shown = m_sources.active();
    const auto* playback = shown != nullptr ? std::get_if<app::RecordingRequest>(&shown->request) : nullptr;
    if (playback == nullptr)
        return;
    for (SourceManager::Item& item : m_sources.items()) {
        const auto* other = std::get_if<app::RecordingRequest>(&item.request);
        if (other == nullptr || &item == shown || other->path != playback->path)
            continue;
        if (core::PlaybackControl* control = item.playback())
            call(*control);
    }
}

void OperatePage::connectPlayback() {
    const auto forward = [this](auto call) {
        return [this, call](auto... arguments) {
            if (core::PlaybackControl* control = playback()) {
                (control->*call)(arguments...);
                withOthers([&](core::PlaybackControl& other) { (other.*call)(arguments...); });
            }
        };
    };
    connect(m_playback, &chrome::PlaybackBar::playRequested, this, &OperatePage::startPlayback);
    connect(m_playback, &chrome::PlaybackBar::pauseRequested, this, forward(&core::PlaybackControl::pause));
    connect(m_playback, &chrome::PlaybackBar::stepRequested, this, &OperatePage::stepPlayback);
    connect(m_playback, &chrome::PlaybackBar::seekRequested, this, forward(&core::PlaybackControl::seek));
    connect(m_marks, &MarkViews::seekRequested, m_playback, &chrome::PlaybackBar::seekRequested);
    connect(m_playback, &chrome::PlaybackBar::speedRequested, this,
            forward(&core::PlaybackControl::setSpeed));
    connect(m_playback, &chrome::PlaybackBar::loopRequested, this, forward(&core::PlaybackControl::setLoop));
}

bool OperatePage::hasProgram() const {
    const SourceManager::Item* item = m_sources.active();
    return item != nullptr && item->isOpen() && item->channel->hasProgram();
}

void OperatePage::setProgramRunning(bool running) {
    if (m_arm->joints())
        m_arm->setProgramRunning(running);
    else if (SourceManager::Item* item = m_sources.active(); item != nullptr)
        item->channel->setProgramRunning(running);
}

void OperatePage::restartProgram() {
    if (m_arm->joints())
        m_arm->restartProgram();
    else if (SourceManager::Item* item = m_sources.active(); item != nullptr)
        item->channel->restartProgram();
}

void OperatePage::onStopReleased() {
    if (hasProgram() && m_sources.active()->channel->isSceneHeld() && !m_servo->servo())
        messages().post({.text = tr("The scene is held."),
                         .advice = tr("Nothing goes on by itself after STOP."),
                         .details = {},
                         .actions = {{tr("Run"), [this] { setProgramRunning(true); }}}});
}

void OperatePage::startPlayback() {
    core::PlaybackControl* control = playback();
    if (control == nullptr)
        return;
    // What is played together begins together; single steps of one source moved no other.
    const core::PlaybackPosition position = control->position();
    const bool atEnd = position.time_s >= position.duration_s;
    if (atEnd)
        control->seek(0.0);
    control->play();
    withOthers([&](core::PlaybackControl& other) {
        other.seek(atEnd ? 0.0 : position.time_s);
        other.play();
    });
}

void OperatePage::stepPlayback(int frames) {
    if (core::PlaybackControl* control = playback()) {
        control->step(frames);
        withOthers([](core::PlaybackControl& other) { other.pause(); });
    }
}

core::PlaybackControl* OperatePage::playback() {
    SourceManager::Item* item = m_sources.active();
    return item != nullptr ? item->playback() : nullptr;
}

void OperatePage::onBraceletFailed(const core::Error& error) {
    m_messages->post({chrome::Message::Severity::error, tr("The bracelet could not be opened."),
                      QString::fromStdString(core::describe(error)), QString()});
}

void OperatePage::setDemos(const std::vector<chrome::SourceChooser::Demo>& demos,
                           const std::vector<chrome::SourceChooser::Demo>& cards) {
    m_chooser->setDemos(demos);
    m_start->setCards(cards);
}

/// A scene is opened here, the others are of other pages.
void OperatePage::openCard(const QString& place) {
    if (place.endsWith(QLatin1String(".toml")))
        emit sceneRequested(place);
    else
        emit cardRequested(place);
}

void OperatePage::retranslate() {
    m_arm->retranslate();
    m_docks->retranslate();
    m_start->retranslate();
    showOpening();
}

} // namespace teleta::console
