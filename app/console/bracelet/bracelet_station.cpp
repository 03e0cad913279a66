// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_station.h"

#include "app/console/base/background.h"
#include "backend/core/device/device_state.h"
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"
#include "widgets/base/numbers/quantity_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace teleta::console {

namespace {

/// How strong a tactor is that is held to be felt: clearly, but not all it has.
constexpr double kHeldIntensity = 0.75;
constexpr int kKeepSoon_ms = 300;

playback::Program builtIn(const std::string& id) {
    const pattern::Pattern* pattern = pattern::findBuiltIn(id);
    return pattern == nullptr ? playback::Program{} : playback::programOf(*pattern);
}

} // namespace

BraceletStation::BraceletStation(core::StopSwitch& stop, QObject* parent, playback::PlayerConfig player,
                                 std::int64_t staleAfter_ns)
    : QObject(parent)
    , m_stop(stop)
    , m_player(std::move(player))
    , m_staleAfter_ns(staleAfter_ns)
    , m_slot(std::make_shared<core::LatestCopy<std::shared_ptr<BraceletSession>>>())
    , m_felt(std::make_shared<core::LatestCopy<Felt>>())
    , m_feedback(std::make_shared<pipeline::TactileFeedback>(
          [slot = m_slot, felt = m_felt](playback::Program program) {
              const auto session = slot->get();
              if (!session)
                  return;
              const double begin_s = playback::promptBegin_s(program, session->player().rate_Hz());
              felt->set({session, session->player().play(std::move(program), /*loop=*/false, begin_s)});
          }))
    , m_library(builtIn) {
    m_keeping.setMaxThreadCount(1);
    m_keepSoon.setSingleShot(true);
    m_keepSoon.setInterval(kKeepSoon_ms);
    connect(&m_keepSoon, &QTimer::timeout, this, &BraceletStation::keepLimits);
}

BraceletStation::~BraceletStation() {
    if (m_keepSoon.isActive())
        keepLimits();
    m_keeping.waitForDone();
    m_slot->set(nullptr);
}

void BraceletStation::letGo() {
    m_slot->set(nullptr);
    m_held.reset();
    m_asked = 0;
    if (!m_session)
        return;
    if (m_keepSoon.isActive())
        keepLimits();
    close(m_choice, std::exchange(m_session, nullptr));
    m_calibration = {};
    m_limits = {};
    emit sessionChanged();
    emit calibrationChanged(m_calibration);
    emit strongestChanged(m_limits.strongest);
}

void BraceletStation::close(BraceletChoice choice, std::shared_ptr<BraceletSession> session) {
    // Its end waits for the device's last frame.
    m_closings.push_back({choice, std::async(std::launch::async,
                                             [session = std::move(session)]() mutable { session.reset(); })});
}

/// A bracelet has one owner at a time: those that end, or are not wanted any more, go first. A file may
/// describe the very board that is found over USB; a simulated one is nobody else's.
template <typename Ending>
std::vector<Ending> BraceletStation::takeAll(std::vector<Ending>& endings, BraceletChoice choice) {
    const auto others = std::stable_partition(endings.begin(), endings.end(), [choice](const Ending& ending) {
        return (ending.choice == BraceletChoice::simulated) != (choice == BraceletChoice::simulated);
    });
    std::vector<Ending> taken(std::make_move_iterator(others), std::make_move_iterator(endings.end()));
    endings.erase(others, endings.end());
    return taken;
}

void BraceletStation::choose(BraceletChoice choice, const QString& deviceFile) {
    letGo();
    m_choice = choice;
    m_deviceFile = choice == BraceletChoice::file ? deviceFile : QString();
    ++m_chosen;
    emit chosen(choice);
    if (choice == BraceletChoice::none)
        return;
    auto open = [choice, file = m_deviceFile.toStdString(), &stop = m_stop, player = m_player,
                 openings = takeAll(m_openings, choice), closings = takeAll(m_closings, choice)]() mutable {
        openings.clear();
        closings.clear();
        return BraceletSession::open(choice, file, stop, player);
    };
    m_openings.push_back({choice, m_chosen, std::async(std::launch::async, std::move(open))});
}

void BraceletStation::takeOpened() {
    const auto isReady = [](const auto& future) {
        return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    std::erase_if(m_closings, [&](const Closing& closing) { return isReady(closing.done); });
    const auto ready = std::find_if(m_openings.begin(), m_openings.end(),
                                    [&](const Opening& opening) { return isReady(opening.result); });
    if (ready == m_openings.end())
        return;
    const bool wanted = ready->number == m_chosen;
    const BraceletChoice choice = ready->choice;
    core::Expected<std::shared_ptr<BraceletSession>> session = ready->result.get();
    m_openings.erase(ready);
    if (session && !wanted) {
        close(choice, std::move(*session));
    } else if (session) {
        m_session = std::move(*session);
        m_slot->set(m_reserved ? nullptr : m_session);
        m_calibration = m_session->calibration();
        m_limits = m_session->limits();
        emit sessionChanged();
        emit calibrationChanged(m_calibration);
        emit strongestChanged(m_limits.strongest);
        if (m_session->limitsError())
            emit strongestFailed(*m_session->limitsError());
        if (m_session->calibrationError())
            emit calibrationFailed(*m_session->calibrationError());
    } else if (wanted) {
        m_choice = BraceletChoice::none;
        emit chosen(m_choice);
        emit failed(session.error());
    }
}

void BraceletStation::setMap(const pattern::PatternMap& map) {
    m_map = map;
    m_feedback->setMap(m_map, m_library);
}

void BraceletStation::setLibrary(pipeline::TactileFeedback::Library library) {
    m_library = std::move(library);
    m_feedback->setMap(m_map, m_library);
}

void BraceletStation::setMode(pipeline::FeedbackMode mode) {
    m_feedback->setMode(mode);
}

std::uint64_t BraceletStation::play(playback::Program program, bool loop, double from_s) {
    if (!m_session || m_reserved)
        return 0;
    m_asked = m_session->player().play(std::move(program), loop, from_s);
    return m_asked;
}

void BraceletStation::change(std::uint64_t number, playback::Program program, double shift_s) {
    if (m_session && !m_reserved)
        m_session->player().change(number, std::move(program), shift_s);
}

void BraceletStation::setLoop(bool loop) {
    if (m_session && !m_reserved)
        m_session->player().setLoop(loop);
}

void BraceletStation::seek(double time_s) {
    if (m_session && !m_reserved)
        m_session->player().seek(time_s);
}

void BraceletStation::setCalibration(const motors::MotorCalibration& calibration) {
    m_calibration = calibration;
    if (!m_reserved)
        applyCalibration();
    emit calibrationChanged(m_calibration);
}

void BraceletStation::applyCalibration() {
    if (m_session)
        m_session->player().setRanges(playback::rangesOf(m_calibration.profiles()));
}

void BraceletStation::setStrongest(const core::Intensities& strongest) {
    if (!m_session)
        return;
    m_limits.strongest = strongest;
    m_session->player().setLimits({.userLimit = strongest});
    m_keepSoon.start();
    emit strongestChanged(m_limits.strongest);
}

void BraceletStation::keepLimits() {
    m_keepSoon.stop();
    runInBackground(
        m_keeping, this,
        [limits = m_limits] {
            const std::string path = motors::limitsPath(limits.bracelet);
            return path.empty() ? core::Expected<void>() : motors::writeLimits(limits, path);
        },
        [this](core::Expected<void> written) {
            if (!written)
                emit strongestFailed(written.error());
        });
}

void BraceletStation::stopPlaying() {
    if (m_session && !m_reserved)
        m_session->player().stop();
}

std::optional<double> BraceletStation::playingPosition_s() const {
    if (!m_session)
        return std::nullopt;
    const playback::PlayerStatus status = m_session->player().status();
    return status.mode == playback::PlayerMode::program ? std::optional(status.position_s) : std::nullopt;
}

bool BraceletStation::isPlaying(std::uint64_t number) const {
    if (!m_session || number == 0)
        return false;
    const playback::PlayerStatus status = m_session->player().status();
    return number > status.settled ||
           (number == status.program && status.mode == playback::PlayerMode::program);
}

bool BraceletStation::isDriven() const {
    return m_session && m_session->player().status().mode != playback::PlayerMode::idle;
}

void BraceletStation::hold(std::optional<std::size_t> tactor) {
    m_held = m_reserved ? std::nullopt : tactor;
    if (!m_session || m_reserved)
        return;
    if (tactor) {
        m_session->player().startLive();
        repeatHold();
    } else {
        m_session->player().stop();
    }
}

void BraceletStation::reserve(bool reserved) {
    if (reserved == m_reserved)
        return;
    if (reserved && m_session)
        m_session->player().stop();
    m_held.reset();
    m_reserved = reserved;
    m_slot->set(reserved ? nullptr : m_session);
    if (!reserved)
        applyCalibration();
}

void BraceletStation::repeatHold() {
    if (!m_held || !m_session)
        return;
    core::Intensities intensities{};
    intensities[*m_held] = kHeldIntensity;
    m_session->player().post(intensities, core::steadyNow_ns());
}

void BraceletStation::tick() {
    takeOpened();
    repeatHold();
    pipeline::FeedbackSent sent;
    while (m_feedback->popSent(sent)) {
        m_last = FeedbackEvent{std::move(sent), std::nullopt, std::nullopt};
        emit felt(*m_last);
    }
    timeLast();
}

void BraceletStation::timeLast() {
    if (!m_session || !m_last || m_last->onset_s || m_last->sent.patternId.empty() || m_last->sent.missing)
        return;
    const playback::PlayerCounters counters = m_session->player().counters();
    // A frame from before the touch is of another pattern.
    const auto after_s = [felt_ns = m_last->sent.felt_ns](std::int64_t frame_ns) {
        return frame_ns < felt_ns ? std::nullopt
                                  : std::optional(static_cast<double>(frame_ns - felt_ns) * 1e-9);
    };
    const bool began = m_last->begin_s.has_value();
    if (!began && (m_last->begin_s = after_s(counters.firstFrame_ns))) {
        m_touchToSkin_s = m_last->begin_s;
        m_latencies_s.push_back(*m_last->begin_s);
        if (m_latencies_s.size() > kLatencies)
            m_latencies_s.erase(m_latencies_s.begin());
    }
    m_last->onset_s = after_s(counters.onset_ns);
    if (m_last->onset_s || m_last->begin_s.has_value() != began)
        emit felt(*m_last);
}

bool BraceletStation::isFeedbackPlaying() const {
    const Felt felt = m_felt->get();
    const bool isNewest = m_session && felt.session.lock() == m_session && felt.number > m_asked;
    return isNewest && !m_reserved && !m_held && isPlaying(felt.number);
}

void BraceletStation::endFeedback() {
    if (isFeedbackPlaying())
        m_session->player().stop();
}

void BraceletStation::forgetFeedback() {
    endFeedback();
    m_last.reset();
}

std::optional<BraceletStation::Latency> BraceletStation::touchToSkin() const {
    if (m_latencies_s.empty())
        return std::nullopt;
    std::vector<double> sorted = m_latencies_s;
    std::ranges::sort(sorted);
    return Latency{core::quantileOf(sorted, 0.5), core::quantileOf(sorted, 0.99)};
}

core::Intensities BraceletStation::given() const {
    return m_session ? m_session->player().status().given : core::Intensities{};
}

bool BraceletStation::isReady() const {
    return m_session && m_session->source().connection() != 0 && !m_stop.engaged();
}

bool BraceletStation::isAnswering() const {
    return isLive() && !isTooHot();
}

bool BraceletStation::isLive() const {
    return isReady() && stateNow() == core::DeviceState::live;
}

bool BraceletStation::isTooHot() const {
    return m_session && m_session->source().telemetry().board.tooHot;
}

core::DeviceState BraceletStation::stateNow() const {
    const core::DeviceStatus status = m_session->source().status();
    return core::observedState(status.state, status.lastData_ns, core::steadyNow_ns(), m_staleAfter_ns);
}

bool BraceletStation::isSimulated() const {
    return m_session && m_session->source().description().simulated;
}

QString BraceletStation::note() const {
    if (m_stop.engaged())
        return tr("STOP is engaged: the bracelet is off.");
    if (m_choice == BraceletChoice::none)
        return tr("No bracelet: what would be played is named in the table of patterns.");
    if (!m_session)
        return tr("Connecting to the bracelet\u2026");
    if (m_session->source().connection() == 0)
        return tr("The bracelet is not connected. %1")
            .arg(QString::fromStdString(m_session->source().status().message));
    if (stateNow() == core::DeviceState::connecting)
        return tr("Connecting to the bracelet\u2026");
    if (!isLive())
        return tr("The bracelet does not answer.");
    if (isTooHot())
        return tr("The bracelet is too hot: it is off until it has cooled down.");
    if (m_reserved)
        return tr("A study uses the bracelet.");
    const core::BraceletTelemetry telemetry = m_session->source().telemetry();
    if (telemetry.board.supplyLow)
        return std::isfinite(telemetry.board.supply_V)
                   ? tr("The supply of the bracelet is low: %1 V.")
                         .arg(base::fixedDigits(telemetry.board.supply_V, 2))
                   : tr("The supply of the bracelet is low.");
    if (m_session->player().counters().framesRefused > 0)
        return tr("The bracelet refused what was played last: it did not understand it.");
    if (!m_calibration.measured())
        return tr("The motors are not calibrated (page Calibrate).");
    return {};
}

QStringList BraceletStation::boardDetails() const {
    const core::BraceletTelemetry telemetry = m_session->source().telemetry();
    QStringList lines;
    if (telemetry.board.tooHot)
        lines << tr("too hot: off until it has cooled down");
    if (telemetry.board.supplyLow)
        lines << tr("supply low");
    if (telemetry.framesRefused > 0)
        lines << tr("frames refused: %1").arg(telemetry.framesRefused);
    if (std::isfinite(telemetry.board.supply_V))
        lines << tr("supply %1 V").arg(base::fixedDigits(telemetry.board.supply_V, 2));
    if (std::isfinite(telemetry.board.temperature_degC))
        lines << tr("temperature %1 \u00b0"
                    "C")
                     .arg(base::fixedDigits(telemetry.board.temperature_degC, 1));
    return lines;
}

std::optional<chrome::DeviceReading> BraceletStation::reading() const {
    if (m_choice == BraceletChoice::none)
        return std::nullopt;
    chrome::DeviceReading reading;
    reading.name = tr("Bracelet");
    reading.state = core::DeviceState::connecting;
    if (!m_session)
        return reading;
    const core::DeviceStatus status = m_session->source().status();
    const std::int64_t now_ns = core::steadyNow_ns();
    reading.provenance = isSimulated() ? base::Provenance::simulated : base::Provenance::live;
    reading.state = stateNow();
    reading.age_s = status.lastData_ns > 0 ? static_cast<double>(now_ns - status.lastData_ns) * 1e-9 : 0.0;
    reading.rate_Hz = status.rate_Hz;
    reading.lost = status.framesLost;
    reading.details = QString::fromStdString(status.message);
    if (reading.details.isEmpty()) {
        QStringList lines;
        if (status.framesRead > 0)
            lines = boardDetails();
        if (!m_calibration.measured())
            lines << tr("not calibrated: the motors are assumed");
        reading.details = lines.join(QLatin1Char('\n'));
    }
    reading.touchToSkin_s = m_touchToSkin_s;
    return reading;
}

} // namespace teleta::console
