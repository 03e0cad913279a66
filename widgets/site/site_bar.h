// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace teleta::site_view {

/// What the bar shows of a site.
struct SiteBarState {
    enum class Mode { free, held, moving, offered, stopped, fault };
    using Count = std::pair<QString, std::uint64_t>; ///< of what is named

    QString site;
    bool viewer = false; ///< this console only looks
    bool reached = false;
    double silent_s = 0.0; ///< how long it has not answered
    Mode mode = Mode::free;
    QString controller;       ///< empty: nobody
    bool controls = false;    ///< this console is in control
    QString offeredTo;        ///< with offered: who gets control
    bool offeredHere = false; ///< this console does
    double offerLeft_s = 0.0;
    double leaseShare = 0.0; ///< 0..1 of the control lease
    QStringList stopHolders;
    bool stopsItself = false;            ///< this console is one of them
    QStringList others;                  ///< consoles to which control can be handed
    QStringList viewers;                 ///< consoles that only look
    QMap<QString, QString> persons;      ///< who sits at a console, where it tells
    std::optional<double> loop_s;        ///< from here to the site and back, the last one
    std::optional<double> medianLoop_s;  ///< of the last ones
    std::optional<double> slowLoop_s;    ///< 99 % of the last ones were not slower
    std::optional<double> clockOffset_s; ///< the site's clock less the one here
    std::optional<double> clockBound_s;  ///< of the clock's offset
    std::uint64_t statesLost = 0;
    std::vector<Count> losses; ///< samples and frames lost on the way, of each stream
    std::uint64_t refused = 0;
    QString lastRefusal;          ///< why, translated; empty: nothing was refused
    std::vector<Count> refusedBy; ///< by reason, translated

    [[nodiscard]] bool operator==(const SiteBarState&) const = default;
    /// The person at a console, or else the console.
    [[nodiscard]] QString who(const QString& console) const { return persons.value(console, console); }
};

/// Who controls a site, and the buttons with which control is asked for, given up and handed over. It shows a
/// state and emits requests; the site decides. Thread: GUI.
class SiteBar : public QWidget {
    Q_OBJECT

public:
    explicit SiteBar(QWidget* parent = nullptr);

    void setState(const SiteBarState& state);
    [[nodiscard]] const SiteBarState& state() const { return m_state; }
    /// "lab: you control"
    [[nodiscard]] QString headline() const;

signals:
    void controlRequested();
    void releaseRequested();
    void handOverRequested(const QString& console);
    void takeOverRequested();
    void accepted();
    /// reason: what the person typed, may be empty.
    void declined(const QString& reason);
    void faultCleared();
    void stopWithdrawn(const QString& holder);

private:
    QPushButton* makeButton(const char* name, void (SiteBar::*wanted)());
    void refresh();
    void restyle();
    void fillMenus();
    void decline();
    [[nodiscard]] QString details() const;
    [[nodiscard]] QStringList moreDetails() const;
    [[nodiscard]] QString withPerson(const QString& console) const;

    SiteBarState m_state;
    QLabel* m_headline;
    QProgressBar* m_lease;
    QLabel* m_details;
    QPushButton* m_request;
    QPushButton* m_accept;
    QPushButton* m_decline;
    QLineEdit* m_reason;
    QPushButton* m_takeOver;
    QPushButton* m_clearFault;
    QToolButton* m_handOver;
    QToolButton* m_withdraw;
    QPushButton* m_release;
};

} // namespace teleta::site_view
