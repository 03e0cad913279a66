// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_opener.h"
#include "app/console/bracelet/bracelet_session.h"
#include "app/console/bracelet/limits_keeper.h"
#include "app/console/bracelet/touch_to_skin.h"
#include "backend/core/device/device_state.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/pattern/model/pattern_map.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "widgets/chrome/device_strip.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

namespace teleta::console {

/// The bracelet of the console, which all pages share: which one is connected, who may drive it, what is felt
/// of a touch. Other classes open it (BraceletOpener), keep its wearer's limits (LimitsKeeper) and time it
/// (TouchToSkin). Thread: GUI; no call waits, except the destructor for a device that is being opened or
/// closed.
class BraceletService : public QObject {
    Q_OBJECT

public:
    /// player: configuration of every bracelet except limits and ranges. staleAfter_ns: longest age of its
    /// newest report; an idle bracelet reports ten times a second.
    explicit BraceletService(core::StopSwitch& stop, QObject* parent = nullptr,
                             playback::PlayerConfig player = {},
                             std::int64_t staleAfter_ns = core::staleAfter_ns(10.0));
    ~BraceletService() override;

    /// Replaces the bracelet. deviceFile: describes the device. When it cannot be opened, failed() is emitted
    /// and the one that worked before is opened again.
    void choose(BraceletChoice choice, const QString& deviceFile = {});
    [[nodiscard]] BraceletChoice choice() const { return m_choice; }
    [[nodiscard]] const QString& deviceFile() const { return m_deviceFile; }
    /// Null while none is connected, or one is being opened. It ends when its last owner releases it, which
    /// may wait.
    [[nodiscard]] const std::shared_ptr<BraceletSession>& session() const { return m_session; }

    /// Calibration of the motors; assumed values without a bracelet.
    [[nodiscard]] const motors::MotorCalibration& calibration() const { return m_calibration; }
    /// Takes effect with the next frame; while reserved, when the reservation ends. Writes no file.
    void setCalibration(const motors::MotorCalibration& calibration);

    /// Upper limit of each motor, 0 .. 1, whoever drives the bracelet; full without a bracelet.
    [[nodiscard]] const core::Intensities& strongest() const { return m_limits.strongest; }
    /// Takes effect with the next frame, even while reserved, and is soon saved in a file for this
    /// bracelet. Without a bracelet: ignored.
    void setStrongest(const core::Intensities& strongest);

    /// For the arm whose touches are felt. Without a bracelet it still reports what would be played.
    [[nodiscard]] const std::shared_ptr<pipeline::TactileFeedback>& feedback() const { return m_feedback; }
    void setMap(const pattern::PatternMap& map);
    /// Where the patterns of the map come from (the built-in ones until then); looks all of them up again.
    void setLibrary(pipeline::TactileFeedback::Library library);
    void setMode(pipeline::FeedbackMode mode);

    /// Plays a program from a time on, once or in a loop. Returns the number that identifies it; 0:
    /// there is nothing to play it on.
    std::uint64_t play(playback::Program program, bool loop, double from_s = 0.0);
    /// Replaces the program with that number without a break, see Player::change.
    void change(std::uint64_t number, playback::Program program, double shift_s);
    void setLoop(bool loop);
    /// Ends what is played for a touch, for instance when the arm's data stop; nothing else.
    void endFeedback();
    /// endFeedback(), and forgets what was recognised last.
    void forgetFeedback();
    /// Whether feedback for a touch plays now.
    [[nodiscard]] bool isFeedbackPlaying() const;
    /// Moves to another time in what is played.
    void seek(double time_s);
    void stopPlaying();
    /// Time in the pattern that plays; empty while none does.
    [[nodiscard]] std::optional<double> playingPosition_s() const;
    /// Whether the program with that number still plays.
    [[nodiscard]] bool isPlaying(std::uint64_t number) const;
    /// Whether anything plays or is held.
    [[nodiscard]] bool isDriven() const;
    /// Waits, for a second at most, until the newest frame turned all motors off. For the end of the program:
    /// STOP must be engaged.
    void waitUntilOff() const;
    /// Drives one tactor while its button is held; empty: none.
    void hold(std::optional<std::size_t> tactor);

    /// Reserves session() for one user: nothing else is played or held meanwhile.
    void reserve(bool reserved);
    [[nodiscard]] bool isReserved() const { return m_reserved; }

    /// Collects what happened since the last tick.
    void tick();
    /// Intensities now, after the safety limits.
    [[nodiscard]] core::Intensities given() const;
    /// Connected, and not stopped.
    [[nodiscard]] bool isReady() const;
    /// Ready, reporting and not too hot: what is played is felt.
    [[nodiscard]] bool isAnswering() const;
    /// The board reports that it is too hot; nothing plays until it has cooled down.
    [[nodiscard]] bool isTooHot() const;
    /// Ready and not reserved: play requests are carried out.
    [[nodiscard]] bool isFree() const { return isReady() && !m_reserved; }
    [[nodiscard]] bool isStopped() const { return m_stop.engaged(); }
    /// Ready, and its reports are recent.
    [[nodiscard]] bool isLive() const;
    /// State of the connected bracelet, stale reports included.
    [[nodiscard]] core::DeviceState state() const;
    /// A line about its state; empty when there is nothing to report.
    [[nodiscard]] QString note() const;
    [[nodiscard]] bool isSimulated() const;
    /// Connected, and its tactors are on a sound card.
    [[nodiscard]] bool isOnSoundCard() const;
    /// For the status bar; empty without a bracelet.
    [[nodiscard]] std::optional<chrome::DeviceReading> reading() const;
    [[nodiscard]] std::optional<TouchToSkin::Latency> touchToSkin() const { return m_touchToSkin.latency(); }
    [[nodiscard]] std::optional<double> newestTouchToSkin_s() const { return m_touchToSkin.newest_s(); }
    /// Of all touches, see TouchToSkin::receipts().
    [[nodiscard]] const std::deque<TouchReceipt>& receipts() const { return m_touchToSkin.receipts(); }
    /// The clock of the site whose arm is shown; empty: an arm here, or its clock is not known yet.
    void setSiteClock(const std::optional<site::ClockOffset>& clock) { m_siteClock = clock; }
    /// The newest recognition while a map was set.
    [[nodiscard]] const TouchReceipt* lastEvent() const { return m_touchToSkin.last(); }

signals:
    void chosen(BraceletChoice choice);
    /// The bracelet that was chosen could not be opened.
    void failed(const core::Error& error);
    /// Another bracelet is connected, or none is any more.
    void sessionChanged();
    void calibrationChanged(const teleta::motors::MotorCalibration& calibration);
    /// The file with the motors' profile cannot be used.
    void calibrationFailed(const core::Error& error);
    void strongestChanged(const teleta::core::Intensities& strongest);
    /// The saved limits could not be read or written.
    void strongestFailed(const core::Error& error);
    /// Something new was recognised, or its onset became known.
    void felt(const TouchReceipt& receipt);

private:
    void open(BraceletChoice choice, const QString& deviceFile);
    void letGo();
    void takeOpened();
    void applyCalibration();
    void repeatHold();

    core::StopSwitch& m_stop;
    BraceletOpener m_opener;
    std::int64_t m_staleAfter_ns;
    /// The one that worked before the one that is being opened.
    std::optional<std::pair<BraceletChoice, QString>> m_working;
    BraceletChoice m_choice = BraceletChoice::none;
    QString m_deviceFile;
    motors::MotorCalibration m_calibration;
    motors::WearerLimits m_limits;
    LimitsKeeper m_keeper;
    std::shared_ptr<BraceletSession> m_session; ///< null while it is being opened
    /// The same for the pipeline's thread.
    std::shared_ptr<core::LatestCopy<std::shared_ptr<BraceletSession>>> m_slot;
    /// What is played for the newest touch; set by the pipeline's thread.
    struct Felt {
        std::weak_ptr<BraceletSession> session;
        std::uint64_t number = 0; ///< as play()'s
    };
    std::shared_ptr<core::LatestCopy<Felt>> m_felt;
    std::shared_ptr<pipeline::TactileFeedback> m_feedback;
    pipeline::TactileFeedback::Library m_library;
    pattern::PatternMap m_map;
    TouchToSkin m_touchToSkin;
    std::optional<site::ClockOffset> m_siteClock;
    std::uint64_t m_asked = 0; ///< number of the newest program that was not for a touch
    std::optional<std::size_t> m_held;
    bool m_reserved = false;
};

} // namespace teleta::console
