// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/pipeline/gel_channel.h"
#include "backend/pipeline/scene_camera_channel.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/pipeline/touch_pipeline.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace teleta::console {

/// The open sources of the console: asks the pipeline to open and close them, and says what became of it.
/// Which source the views show is decided here. Thread: GUI; no call waits.
class SourceManager : public QObject {
    Q_OBJECT

public:
    struct Item {
        pipeline::ChannelKey key = 0;
        app::SourceRequest request;
        QString name;
        std::shared_ptr<pipeline::Channel> channel = nullptr; ///< null while it is being opened
        std::uint64_t displayed = 0;                          ///< snapshots that were painted
        bool waits = false; ///< a playback that begins with the others of its recording
        /// Asked by what opens it.
        std::shared_ptr<std::atomic<bool>> cancelled = std::make_shared<std::atomic<bool>>(false);

        [[nodiscard]] bool isOpen() const { return channel != nullptr; }
        /// Null when it is no playback, or is being opened.
        [[nodiscard]] core::PlaybackControl* playback() const;

        // For the views of one kind of source; null when it is another one, or is being opened.
        /// An array, or the skin of an arm.
        [[nodiscard]] std::shared_ptr<pipeline::TouchChannel> array() const;
        [[nodiscard]] std::shared_ptr<pipeline::ArmChannel> arm() const;
        /// An arm with or without a skin.
        [[nodiscard]] std::shared_ptr<pipeline::JointChannel> joints() const;
        [[nodiscard]] std::shared_ptr<pipeline::CameraChannel> camera() const;
        [[nodiscard]] std::shared_ptr<pipeline::GelChannel> gel() const;
        [[nodiscard]] std::shared_ptr<pipeline::SceneCameraChannel> sceneCamera() const;
        /// That moves the array.
        [[nodiscard]] std::shared_ptr<servo::ServoLink> servo() const;
    };

    explicit SourceManager(core::StopSwitch& stop, QObject* parent = nullptr);
    /// Does not wait for what is still being opened.
    ~SourceManager() override;

    /// Opens a source beside those that are open and shows it once it is there; one that only looks at the
    /// scene does not take the place of another.
    pipeline::ChannelKey open(const app::SourceRequest& request);
    void close(pipeline::ChannelKey key);
    void closeAll();
    void activate(pipeline::ChannelKey key);

    [[nodiscard]] std::vector<Item>& items() { return m_items; }
    [[nodiscard]] Item* active();
    [[nodiscard]] Item* find(pipeline::ChannelKey key);

    /// Takes the pipeline's news; called by the GUI's timer.
    void poll();

signals:
    void opened(pipeline::ChannelKey key);
    void failed(const QString& name, const core::Error& error);
    void closed(pipeline::ChannelKey key);
    void activeChanged(pipeline::ChannelKey key);
    void itemsChanged();

private:
    /// Begins the playbacks of each recording whose sources are all open.
    void beginPlaybacks();
    void remove(pipeline::ChannelKey key);

    core::StopSwitch& m_stop;
    pipeline::TouchPipeline m_pipeline;
    std::vector<Item> m_items;
    pipeline::ChannelKey m_active = 0;
};

} // namespace teleta::console
