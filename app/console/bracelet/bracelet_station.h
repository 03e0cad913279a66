// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_session.h"
#include "backend/core/device/device_state.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/pattern/model/pattern_map.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "widgets/chrome/device_strip.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <vector>

namespace teleta::console {

/// What was recognised, what was sent for it, and how long after the completed touch the bracelet began.
struct FeedbackEvent {
    pipeline::FeedbackSent sent;
    std::optional<double> begin_s; ///< to the first frame of its pattern; empty: not yet, or never
    std::optional<double> onset_s; ///< to the first frame that is not off, the first one to be felt
};

/// The bracelet of the console: opens and closes it off the GUI's thread, lets touches be felt on it, and
/// tells what it does. Thread: GUI; no call waits but the destructor, for a device that is being opened or
/// closed.
class BraceletStation : public QObject {
    Q_OBJECT

public:
    /// player: of every bracelet, but for its limits and ranges. staleAfter_ns: so old may its newest report
    /// be; an idle one reports ten times a second.
    explicit BraceletStation(core::StopSwitch& stop, QObject* parent = nullptr,
                             playback::PlayerConfig player = {},
                             std::int64_t staleAfter_ns = core::staleAfter_ns(10.0));
    ~BraceletStation() override;

    /// Takes another bracelet in place of the present one. deviceFile: of a Modbus bracelet.
    void choose(BraceletChoice choice, const QString& deviceFile = {});
    [[nodiscard]] BraceletChoice choice() const { return m_choice; }
    [[nodiscard]] const QString& deviceFile() const { return m_deviceFile; }
    /// Null while none is connected, or one is being opened. It ends when its last owner lets it go, which
    /// may wait.
    [[nodiscard]] const std::shared_ptr<BraceletSession>& session() const { return m_session; }

    /// What is known of the motors of the bracelet; of none, assumed ones.
    [[nodiscard]] const motors::MotorCalibration& calibration() const { return m_calibration; }
    /// Takes effect with the next frame; of a reserved bracelet, when it is given back. Writes no file.
    void setCalibration(const motors::MotorCalibration& calibration);

    /// How strong each motor may be at most, 0 .. 1, whoever drives the bracelet; of none, full.
    [[nodiscard]] const core::Intensities& strongest() const { return m_limits.strongest; }
    /// Takes effect with the next frame, also while the bracelet is reserved, and is kept in a file for this
    /// bracelet soon. Without a bracelet: ignored.
    void setStrongest(const core::Intensities& strongest);

    /// For the arm whose touches are to be felt. It goes on telling what would be played without a bracelet.
    [[nodiscard]] const std::shared_ptr<pipeline::TactileFeedback>& feedback() const { return m_feedback; }
    void setMap(const pattern::PatternMap& map);
    /// Where the patterns of the map come from (the built-in ones until then); looks all of them up again.
    void setLibrary(pipeline::TactileFeedback::Library library);
    void setMode(pipeline::FeedbackMode mode);

    /// Plays a program from a time on, once or again and again. Its number tells it from what others play; 0:
    /// there is nothing to play it on.
    std::uint64_t play(playback::Program program, bool loop, double from_s = 0.0);
    /// Goes on with another program in place of the one with that number, see Player::change.
    void change(std::uint64_t number, playback::Program program, double shift_s);
    void setLoop(bool loop);
    /// Ends what is played for a touch, as when the arm tells nothing any more; nothing else.
    void endFeedback();
    /// As endFeedback(), and what was recognised last is not known any more.
    void forgetFeedback();
    /// What was sent for a touch is played now.
    [[nodiscard]] bool isFeedbackPlaying() const;
    /// Goes on somewhere else in what is played.
    void seek(double time_s);
    void stopPlaying();
    /// Where the pattern that is played stands; empty while none is.
    [[nodiscard]] std::optional<double> playingPosition_s() const;
    /// The one with that number has not ended yet, and nothing else is played instead.
    [[nodiscard]] bool isPlaying(std::uint64_t number) const;
    /// Something is played, held or felt.
    [[nodiscard]] bool isDriven() const;
    /// Lets one tactor be felt while it is held; empty: none.
    void hold(std::optional<std::size_t> tactor);

    /// For whoever drives session() alone: meanwhile nothing else is played or held.
    void reserve(bool reserved);
    [[nodiscard]] bool isReserved() const { return m_reserved; }

    /// Collects what happened since the last tick.
    void tick();
    /// What the tactors do now, after the safety limits.
    [[nodiscard]] core::Intensities given() const;
    /// Connected, and not stopped.
    [[nodiscard]] bool isReady() const;
    /// Ready, its reports arrive and do not say that it is too hot: what is played is felt.
    [[nodiscard]] bool isAnswering() const;
    /// The newest report of its board says that it is too hot; nothing is played on it until it is not.
    [[nodiscard]] bool isTooHot() const;
    /// Ready, and not reserved: what is asked to be played is played.
    [[nodiscard]] bool isFree() const { return isReady() && !m_reserved; }
    /// One line on the state; empty when there is nothing to say.
    [[nodiscard]] QString note() const;
    [[nodiscard]] bool isSimulated() const;
    /// For the status bar; empty without a bracelet.
    [[nodiscard]] std::optional<chrome::DeviceReading> reading() const;
    /// Median and 99 % quantile of the newest kLatencies times from a completed touch to the first frame;
    /// empty before the first.
    struct Latency {
        double median_s = 0.0;
        double p99_s = 0.0;
    };
    static constexpr std::size_t kLatencies = 200;
    [[nodiscard]] std::optional<Latency> touchToSkin() const;
    /// The newest thing that was recognised while a map was set.
    [[nodiscard]] const std::optional<FeedbackEvent>& lastEvent() const { return m_last; }

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
    /// What was set of strongest() before is not known, or could not be kept.
    void strongestFailed(const core::Error& error);
    /// Something new was recognised, or its onset became known.
    void felt(const FeedbackEvent& event);

private:
    /// A bracelet that is being closed on a thread of its own; its end waits for that thread.
    struct Closing {
        BraceletChoice choice = BraceletChoice::none;
        std::future<void> done;
    };
    /// A bracelet that is being opened, likewise.
    struct Opening {
        BraceletChoice choice = BraceletChoice::none;
        std::uint64_t number = 0;
        std::future<core::Expected<std::shared_ptr<BraceletSession>>> result;
    };

    /// Of the bracelet that is connected, as it is seen from here.
    [[nodiscard]] core::DeviceState stateNow() const;
    /// Its reports are as young as they should be.
    [[nodiscard]] bool isLive() const;
    /// What its board tells of itself, a line each.
    [[nodiscard]] QStringList boardDetails() const;
    void letGo();
    void close(BraceletChoice choice, std::shared_ptr<BraceletSession> session);
    template <typename Ending>
    static std::vector<Ending> takeAll(std::vector<Ending>& endings, BraceletChoice choice);
    void takeOpened();
    /// How long after the newest touch its pattern began.
    void timeLast();
    void applyCalibration();
    void keepLimits();
    void repeatHold();

    core::StopSwitch& m_stop;
    playback::PlayerConfig m_player;
    std::int64_t m_staleAfter_ns;
    BraceletChoice m_choice = BraceletChoice::none;
    QString m_deviceFile;
    motors::MotorCalibration m_calibration;
    motors::WearerLimits m_limits;
    QTimer m_keepSoon;     ///< a slider that moves is not kept at each step
    QThreadPool m_keeping; ///< of one thread: the last limits are the ones that stay
    std::vector<Opening> m_openings;
    std::vector<Closing> m_closings;
    std::uint64_t m_chosen = 0;                 ///< number of the newest choice
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
    std::optional<FeedbackEvent> m_last;
    std::optional<double> m_touchToSkin_s;
    std::vector<double> m_latencies_s; ///< of the newest touches
    std::uint64_t m_asked = 0;         ///< number of the newest program that was not for a touch
    std::optional<std::size_t> m_held;
    bool m_reserved = false;
};

} // namespace teleta::console
