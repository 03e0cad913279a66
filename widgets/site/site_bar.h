// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

#include <cstdint>
#include <optional>

class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace teleta::site_view {

/// What the bar shows of a site.
struct SiteBarState {
    enum class Mode { free, held, moving, offered, stopped, fault };

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
    bool stopsItself = false;           ///< this console is one of them
    QStringList others;                 ///< consoles to which control can be handed
    std::optional<double> loop_s;       ///< from here to the site and back
    std::optional<double> clockBound_s; ///< of the clock's offset
    std::uint64_t statesLost = 0;
    std::uint64_t refused = 0;
    QString lastRefusal; ///< why, translated; empty: nothing was refused

    [[nodiscard]] bool operator==(const SiteBarState&) const = default;
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
    void declined();
    void faultCleared();
    void stopWithdrawn(const QString& holder);

private:
    QPushButton* makeButton(const char* name, void (SiteBar::*wanted)());
    void refresh();
    void restyle();
    void fillMenus();
    [[nodiscard]] QString details() const;

    SiteBarState m_state;
    QLabel* m_headline;
    QProgressBar* m_lease;
    QLabel* m_details;
    QPushButton* m_request;
    QPushButton* m_accept;
    QPushButton* m_decline;
    QPushButton* m_takeOver;
    QPushButton* m_clearFault;
    QToolButton* m_handOver;
    QToolButton* m_withdraw;
    QPushButton* m_release;
};

} // namespace teleta::site_view
