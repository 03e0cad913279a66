// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/sources/source_manager.h"
#include "widgets/chrome/message_bar.h"

#include <QCoreApplication>

#include <set>

namespace teleta::console {

/// Tells of each open source, once, what its user has to know: that it was lost, that its recording is
/// damaged or its settings changed, that chips are far from the temperature of their tare. Thread: GUI.
class SourceWatch {
    Q_DECLARE_TR_FUNCTIONS(teleta::console::SourceWatch)

public:
    explicit SourceWatch(chrome::MessageBar& messages)
        : m_messages(messages) {}

    /// item: open.
    void look(const SourceManager::Item& item);

private:
    void lookForFailures(const SourceManager::Item& item);
    /// What a recording contains that is not played.
    void lookForDamage(const SourceManager::Item& item);
    void lookAtTemperature(const SourceManager::Item& item);

    chrome::MessageBar& m_messages;
    std::set<pipeline::ChannelKey> m_reportedLost;
    std::set<pipeline::ChannelKey> m_reportedChanged;
    std::set<pipeline::ChannelKey> m_reportedDamaged;
    std::set<pipeline::ChannelKey> m_reportedWarm;
};

} // namespace teleta::console
