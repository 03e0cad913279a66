// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/source_manager.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace teleta::console {

using pipeline::ChannelEvent;
using pipeline::ChannelKey;

SourceManager::SourceManager(core::StopSwitch& stop, QObject* parent)
    : QObject(parent)
    , m_stop(stop) {
}

SourceManager::~SourceManager() {
    for (const Item& item : m_items)
        item.cancelled->store(true);
}

core::PlaybackControl* SourceManager::Item::playback() const {
    return channel ? channel->playback() : nullptr;
}

std::shared_ptr<pipeline::TouchChannel> SourceManager::Item::array() const {
    const auto ofArm = arm();
    return ofArm ? ofArm->skin() : std::dynamic_pointer_cast<pipeline::TouchChannel>(channel);
}

std::shared_ptr<pipeline::ArmChannel> SourceManager::Item::arm() const {
    return std::dynamic_pointer_cast<pipeline::ArmChannel>(channel);
}

std::shared_ptr<pipeline::JointChannel> SourceManager::Item::joints() const {
    return std::dynamic_pointer_cast<pipeline::JointChannel>(channel);
}

std::shared_ptr<pipeline::CameraChannel> SourceManager::Item::camera() const {
    return std::dynamic_pointer_cast<pipeline::CameraChannel>(channel);
}

std::shared_ptr<pipeline::GelChannel> SourceManager::Item::gel() const {
    return std::dynamic_pointer_cast<pipeline::GelChannel>(channel);
}

std::shared_ptr<pipeline::SceneCameraChannel> SourceManager::Item::sceneCamera() const {
    return std::dynamic_pointer_cast<pipeline::SceneCameraChannel>(channel);
}

std::shared_ptr<servo::ServoLink> SourceManager::Item::servo() const {
    const auto shown = array();
    return shown ? shown->servo() : nullptr;
}

ChannelKey SourceManager::open(const app::SourceRequest& request) {
    Item item;
    item.request = request;
    item.name = displayName(request);
    item.key = m_pipeline.open(
        app::makeSourceFactory(request, m_stop, [cancelled = item.cancelled] { return cancelled->load(); }));
    const ChannelKey key = item.key;
    m_items.push_back(std::move(item));
    emit itemsChanged();
    return key;
}

void SourceManager::close(ChannelKey key) {
    if (find(key) == nullptr)
        return;
    find(key)->cancelled->store(true);
    m_pipeline.close(key);
    remove(key);
}

void SourceManager::closeAll() {
    while (!m_items.empty())
        close(m_items.back().key);
}

void SourceManager::activate(ChannelKey key) {
    const Item* item = find(key);
    if (item == nullptr || !item->isOpen() || key == m_active)
        return;
    m_active = key;
    emit activeChanged(key);
}

SourceManager::Item* SourceManager::active() {
    return find(m_active);
}

SourceManager::Item* SourceManager::find(ChannelKey key) {
    const auto found =
        std::find_if(m_items.begin(), m_items.end(), [key](const Item& item) { return item.key == key; });
    return found == m_items.end() ? nullptr : &*found;
}

void SourceManager::poll() {
    for (ChannelEvent& event : m_pipeline.takeEvents()) {
        Item* item = find(event.key);
        switch (event.kind) {
        case ChannelEvent::Kind::opened:
            // Closed again while it was being opened: its close request is on the way.
            if (item == nullptr)
                break;
            item->channel = std::move(event.channel);
            item->waits = std::holds_alternative<app::RecordingRequest>(item->request);
            emit opened(event.key);
            emit itemsChanged();
            // A camera that looks at the scene is shown with whatever is there.
            if (!item->sceneCamera() || active() == nullptr)
                activate(event.key);
            break;
        case ChannelEvent::Kind::failed: {
            // Closed while it was being opened: nobody waits for it.
            if (item == nullptr)
                break;
            const QString name = fileName(item->request);
            remove(event.key);
            emit failed(name, event.error);
            break;
        }
        case ChannelEvent::Kind::closed:
            break;
        }
    }
    beginPlaybacks();
}

void SourceManager::beginPlaybacks() {
    const auto isOf = [](const Item& item, const std::string& path) {
        const auto* playback = std::get_if<app::RecordingRequest>(&item.request);
        return playback != nullptr && playback->path == path;
    };
    for (const Item& waiting : m_items) {
        if (!waiting.waits)
            continue;
        const std::string path = std::get<app::RecordingRequest>(waiting.request).path;
        if (std::ranges::any_of(m_items,
                                [&](const Item& item) { return isOf(item, path) && !item.isOpen(); }))
            continue;
        // What was asked of them meanwhile holds for all: where, how fast, again and again. The first one was
        // opened first, so it has heard all of it.
        const auto leader = std::ranges::find_if(m_items, [&](const Item& item) { return isOf(item, path); });
        const core::PlaybackPosition there = leader->playback()->position();
        for (Item& item : m_items) {
            if (!isOf(item, path) || !std::exchange(item.waits, false))
                continue;
            item.playback()->setSpeed(there.speed);
            item.playback()->setLoop(there.loop);
            if (there.target_s > 0.0)
                item.playback()->seek(there.target_s);
            item.playback()->play();
        }
    }
}

void SourceManager::remove(ChannelKey key) {
    const auto removed = std::erase_if(m_items, [key](const Item& item) { return item.key == key; });
    if (removed == 0)
        return;
    const bool wasActive = key == m_active;
    if (wasActive)
        m_active = 0;
    emit closed(key);
    emit itemsChanged();
    if (!wasActive)
        return;
    const auto next =
        std::find_if(m_items.begin(), m_items.end(), [](const Item& item) { return item.isOpen(); });
    if (next != m_items.end())
        activate(next->key);
    else
        emit activeChanged(0);
}

} // namespace teleta::console
