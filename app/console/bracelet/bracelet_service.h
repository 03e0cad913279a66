// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_opener.h"
#include "app/console/bracelet/bracelet_session.h"
#include "app/console/bracelet/bracelet_texts.h"
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
#include <memory>
#include <optional>

namespace teleta::console {

/// The bracelet of the console, which all pages share: which one is connected, who may drive it, what is felt
/// of a touch. Others open it (BraceletOpener), keep its wearer's limits (LimitsKeeper), time it
/// (TouchToSkin) and put it into words (BraceletTexts). Thread: GUI; no call waits but the destructor, for a
/// device that is being opened or closed.
class BraceletService : public QObject {
    Q_OBJECT

public:
    /// player: of every bracelet, but for its limits and ranges. staleAfter_ns: so old may its newest report
    /// be; an idle one reports ten times a second.
    explicit BraceletService(core::StopSwitch& stop, QObject* parent = nullptr,
                             playback::PlayerConfig player = {},
                             std::int64_t staleAfter_ns = core::staleAfter_ns(10.0));
    ~BraceletService() override;

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
    [[nodiscard]] bool isStopped() const { return m_stop.engaged(); }
    /// Its reports are as young as they should be.
    [[nodiscard]] bool isLive() const;
    /// Of the bracelet that is connected, as it is seen from here.
    [[nodiscard]] core::DeviceState state() const;
    [[nodiscard]] QString note() const { return BraceletTexts::note(*this); }
    [[nodiscard]] bool isSimulated() const;
    [[nodiscard]] std::optional<chrome::DeviceReading> reading() const {
        return BraceletTexts::reading(*this);
    }
    [[nodiscard]] std::optional<TouchToSkin::Latency> touchToSkin() const { return m_touchToSkin.latency(); }
    [[nodiscard]] std::optional<double> newestTouchToSkin_s() const { return m_touchToSkin.newest_s(); }
    /// The newest thing that was recognised while a map was set.
    [[nodiscard]] const std::optional<FeedbackEvent>& lastEvent() const { return m_touchToSkin.last(); }

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
    void letGo();
    void takeOpened();
    void applyCalibration();
    void repeatHold();

    core::StopSwitch& m_stop;
    BraceletOpener m_opener;
    std::int64_t m_staleAfter_ns;
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
    std::uint64_t m_asked = 0; ///< number of the newest program that was not for a touch
    std::optional<std::size_t> m_held;
    bool m_reserved = false;
};

} // namespace teleta::console
