// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_opener.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace teleta::console {

namespace {

template <typename Value>
bool isReady(const std::future<Value>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace

BraceletOpener::BraceletOpener(const core::StopSwitch& stop, playback::PlayerConfig player)
    : m_stop(stop)
    , m_player(std::move(player)) {
}

void BraceletOpener::close(BraceletChoice choice, std::shared_ptr<BraceletSession> session) {
    m_closings.push_back({choice, std::async(std::launch::async,
                                             [session = std::move(session)]() mutable { session.reset(); })});
}

/// Those that may be the same device: a file may describe the very board that is found over USB; a simulated
/// bracelet is nobody else's.
template <typename Ending>
std::vector<Ending> BraceletOpener::takeRivals(std::vector<Ending>& endings, BraceletChoice choice) {
    const auto rivals = std::stable_partition(endings.begin(), endings.end(), [choice](const Ending& ending) {
        return (ending.choice == BraceletChoice::simulated) != (choice == BraceletChoice::simulated);
    });
    std::vector<Ending> taken(std::make_move_iterator(rivals), std::make_move_iterator(endings.end()));
    endings.erase(rivals, endings.end());
    return taken;
}

void BraceletOpener::open(BraceletChoice choice, const std::string& deviceFile) {
    ++m_newest;
    if (choice == BraceletChoice::none)
        return;
    auto open = [choice, deviceFile, &stop = m_stop, player = m_player,
                 openings = takeRivals(m_openings, choice),
                 closings = takeRivals(m_closings, choice)]() mutable {
        openings.clear();
        closings.clear();
        return BraceletSession::open(choice, deviceFile, stop, player);
    };
    m_openings.push_back({choice, m_newest, std::async(std::launch::async, std::move(open))});
}

std::optional<BraceletOpener::Opened> BraceletOpener::take() {
    std::erase_if(m_closings, [](const Closing& closing) { return isReady(closing.done); });
    const auto ready =
        std::ranges::find_if(m_openings, [](const Opening& opening) { return isReady(opening.result); });
    if (ready == m_openings.end())
        return std::nullopt;
    const bool wanted = ready->number == m_newest;
    const BraceletChoice choice = ready->choice;
    Opened opened = ready->result.get();
    m_openings.erase(ready);
    if (wanted)
        return opened;
    if (opened)
        close(choice, std::move(*opened));
    return std::nullopt;
}

} // namespace teleta::console
