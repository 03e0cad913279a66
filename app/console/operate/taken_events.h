// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>

namespace teleta::console {

/// Takes the events that wait in a channel to the front of others, of which the oldest leave where there are
/// more than `most`. Thread: GUI.
template <typename Channel, typename Event>
void takeEvents(Channel& channel, std::deque<Event>& events, std::size_t most) {
    Event event;
    while (channel.popEvent(event))
        events.push_front(event);
    if (events.size() > most)
        events.resize(most);
}

} // namespace teleta::console
