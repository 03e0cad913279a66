// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/site/control_arbiter.h"
#include "devices/site/site_client.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/site/site_bar.h"

#include <QObject>

#include <cstdint>
#include <memory>

namespace teleta::console {

/// The site of the shown source on the Operate page: who controls it, and the requests of the operator.
/// Nobody asks for control but a person. Thread: GUI.
class SiteViews : public QObject {
    Q_OBJECT

public:
    SiteViews(chrome::MessageBar& messages, QWidget* parent);

    [[nodiscard]] site_view::SiteBar& bar() { return *m_bar; }
    /// Null: the shown source is of no site; the bar is hidden then.
    void setSite(const std::shared_ptr<site_link::SiteClient>& site);
    /// Of the site that is shown; empty: none is, or it is not known yet.
    [[nodiscard]] std::optional<site::ClockOffset> clock() const;
    /// Shows what came since the last tick.
    void tick();

    /// Nobody controls the site, and this console does not only look.
    [[nodiscard]] bool mayRequest() const;
    [[nodiscard]] bool controls() const { return m_bar->state().reached && m_bar->state().controls; }
    void request() { ask(site::RequestKind::request); }
    void release() { ask(site::RequestKind::release); }

    /// Why a request was not done; empty: it was, or waits.
    [[nodiscard]] static QString answerText(site::RequestAnswer answer);
    /// Why a command was not carried out, for a list; empty: it was.
    [[nodiscard]] static QString refusalText(site::CommandRefusal why);

private:
    void ask(site::RequestKind kind, const QString& target = {});
    void tellAnswer(const site_link::SiteView& view);
    void tellChanges(const site_view::SiteBarState& before, const site_view::SiteBarState& now);

    chrome::MessageBar& m_messages;
    site_view::SiteBar* m_bar;
    std::weak_ptr<site_link::SiteClient> m_site; ///< its devices keep it, see app::SiteRequest
    std::uint64_t m_answered = 0;                ///< the last request whose answer was told
    std::uint64_t m_boots = 0;
    std::weak_ptr<site_link::SiteClient> m_warned; ///< whose keys were spoken of
};

} // namespace teleta::console
