// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/site/control_arbiter.h"
#include "devices/site/site_client.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/site/site_bar.h"

#include <QObject>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace teleta::console {

/// The site of the shown source on the Operate page: who controls it, and the requests of the operator.
/// Nobody asks for control but a person. Thread: GUI.
class SiteViews : public QObject {
    Q_OBJECT

public:
    using Successors = std::vector<std::pair<QString, QString>>; ///< consoles and who sits there

    static constexpr std::chrono::hours kKeyPeriod{24};

    SiteViews(chrome::MessageBar& messages, QWidget* parent);

    [[nodiscard]] site_view::SiteBar& bar() { return *m_bar; }
    /// Null: the shown source is of no site; the bar is hidden then.
    void setSite(const std::shared_ptr<site_link::SiteClient>& site);
    /// Of the site that is shown; empty: none is, or it is not known yet.
    [[nodiscard]] std::optional<site::ClockOffset> clock() const;
    /// How often the keys are looked at, for tests. Default: once a day.
    void setKeyPeriod(std::chrono::nanoseconds period);
    /// Shows what came since the last tick.
    void tick();

    /// Nobody controls the site, and this console does not only look.
    [[nodiscard]] bool mayRequest() const;
    [[nodiscard]] bool controls() const { return m_bar->state().reached && m_bar->state().controls; }
    /// Another console is in control, which may be asked to give it up; the site knows who is a supervisor.
    [[nodiscard]] bool mayTakeOver() const;
    /// Consoles to which control can be handed, with their persons; empty: this one has none to give.
    [[nodiscard]] Successors successors() const;
    void request() { ask(site::RequestKind::request); }
    void release() { ask(site::RequestKind::release); }
    void takeOver() { ask(site::RequestKind::takeOver); }
    void handOver(const QString& console) { ask(site::RequestKind::offer, console); }
    /// What was lost of the site's streams on the way, for the bar.
    void setLosses(std::vector<site_view::SiteBarState::Count> losses) { m_losses = std::move(losses); }

    /// Why a request was not done; empty: it was, or waits. console: that asked.
    [[nodiscard]] static QString answerText(const site_link::RequestOutcome& outcome, const QString& console);
    /// Why a command was not carried out, for a list; empty: it was.
    [[nodiscard]] static QString refusalText(site::CommandRefusal why);

signals:
    /// What mayRequest(), mayTakeOver(), controls() and successors() tell is another thing.
    void possibilitiesChanged();
    /// Something happened at the site, a sentence; time: of the clock here. For the recording.
    void happened(std::int64_t time_ns, const QString& text);

private:
    void tellPossibilities();
    void tellKeys(const std::vector<std::string>& warnings);
    void lookAtKeys(const site_link::SiteClient& site);
    void showState(const site_link::SiteClient& site, const site_link::SiteView& view);
    void tellEvents(site_link::SiteClient& site);
    void ask(site::RequestKind kind, const QString& target = {});
    void tellAnswer(const site_link::SiteView& view);
    void tellChanges(const site_view::SiteBarState& before, const site_view::SiteBarState& now);

    chrome::MessageBar& m_messages;
    site_view::SiteBar* m_bar;
    std::weak_ptr<site_link::SiteClient> m_site; ///< its devices keep it, see app::SiteRequest
    std::uint64_t m_answered = 0;                ///< the last request whose answer was told
    std::uint64_t m_boots = 0;
    std::vector<site_view::SiteBarState::Count> m_losses;
    std::tuple<bool, bool, bool, Successors> m_possible; ///< as it was told last
    std::set<std::string> m_keyWarnings;                 ///< as they were told
    std::chrono::nanoseconds m_keyPeriod = kKeyPeriod;
    std::int64_t m_nextKeys_ns = 0; ///< when the keys are looked at again
};

} // namespace teleta::console
