// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"

#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"

#include <chrono>
#include <thread>
#include <utility>

namespace teleta::console {

namespace {

/// How strong a tactor is that is held to be felt: clearly, but not all it has.
constexpr double kHeldIntensity = 0.75;
/// Four cycles of the player.
constexpr std::chrono::milliseconds kUnderWay{20};
constexpr std::chrono::milliseconds kLongestWait{1000};

playback::Program builtIn(const std::string& id) {
    const pattern::Pattern* pattern = pattern::findBuiltIn(id);
    return pattern == nullptr ? playback::Program{} : playback::programOf(*pattern);
}

} // namespace

BraceletService::BraceletService(core::StopSwitch& stop, QObject* parent, playback::PlayerConfig player,
                                 std::int64_t staleAfter_ns)
    : QObject(parent)
    , m_stop(stop)
    , m_opener(stop, std::move(player))
    , m_staleAfter_ns(staleAfter_ns)
    , m_slot(std::make_shared<core::LatestCopy<std::shared_ptr<BraceletSession>>>())
    , m_felt(std::make_shared<core::LatestCopy<Felt>>())
    , m_feedback(std::make_shared<pipeline::TactileFeedback>(
          [slot = m_slot, felt = m_felt](playback::Program program) {
              const auto session = slot->get();
              if (!session)
                  return false;
              const double begin_s = playback::promptBegin_s(program, session->player().rate_Hz());
              felt->set({session, session->player().play(std::move(program), /*loop=*/false, begin_s)});
              return true;
          }))
    , m_library(builtIn) {
    connect(&m_keeper, &LimitsKeeper::failed, this, &BraceletService::strongestFailed);
}

BraceletService::~BraceletService() {
    m_slot->set(nullptr);
}

void BraceletService::letGo() {
    m_slot->set(nullptr);
    m_held.reset();
    m_asked = 0;
    if (!m_session)
        return;
    m_keeper.flush();
    m_opener.close(m_choice, std::exchange(m_session, nullptr));
    m_calibration = {};
    m_limits = {};
    emit sessionChanged();
    emit calibrationChanged(m_calibration);
    emit strongestChanged(m_limits.strongest);
}

void BraceletService::choose(BraceletChoice choice, const QString& deviceFile) {
    // It has to be let go of before, since both may be the same device.
    if (choice == BraceletChoice::none)
        m_working.reset();
    else if (m_session)
        m_working = {m_choice, m_deviceFile};
    open(choice, deviceFile);
}

void BraceletService::open(BraceletChoice choice, const QString& deviceFile) {
    letGo();
    m_choice = choice;
    m_deviceFile = choice == BraceletChoice::file ? deviceFile : QString();
    emit chosen(choice);
    m_opener.open(choice, m_deviceFile.toStdString());
}

void BraceletService::takeOpened() {
    auto opened = m_opener.take();
    if (!opened)
        return;
    if (*opened) {
        m_session = std::move(**opened);
        m_working.reset();
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
    } else {
        // One that does not open takes the place of none that worked.
        const auto working = std::exchange(m_working, std::nullopt);
        if (working) {
            open(working->first, working->second);
        } else {
            m_choice = BraceletChoice::none;
            emit chosen(m_choice);
        }
        emit failed(opened->error());
    }
}

void BraceletService::setMap(const pattern::PatternMap& map) {
    m_map = map;
    m_feedback->setMap(m_map, m_library);
}

void BraceletService::setLibrary(pipeline::TactileFeedback::Library library) {
    m_library = std::move(library);
    m_feedback->setMap(m_map, m_library);
}

void BraceletService::setMode(pipeline::FeedbackMode mode) {
    m_feedback->setMode(mode);
}

std::uint64_t BraceletService::play(playback::Program program, bool loop, double from_s) {
    if (!m_session || m_reserved)
        return 0;
    m_asked = m_session->player().play(std::move(program), loop, from_s);
    return m_asked;
}

void BraceletService::change(std::uint64_t number, playback::Program program, double shift_s) {
    if (m_session && !m_reserved)
        m_session->player().change(number, std::move(program), shift_s);
}

void BraceletService::setLoop(bool loop) {
    if (m_session && !m_reserved)
        m_session->player().setLoop(loop);
}

void BraceletService::seek(double time_s) {
    if (m_session && !m_reserved)
        m_session->player().seek(time_s);
}

void BraceletService::setCalibration(const motors::MotorCalibration& calibration) {
    m_calibration = calibration;
    if (!m_reserved)
        applyCalibration();
    emit calibrationChanged(m_calibration);
}

void BraceletService::applyCalibration() {
    if (m_session)
        m_session->player().setRanges(playback::rangesOf(m_calibration.profiles()));
}

void BraceletService::setStrongest(const core::Intensities& strongest) {
    if (!m_session)
        return;
    m_limits.strongest = strongest;
    m_session->player().setLimits({.userLimit = strongest});
    m_keeper.keepSoon(m_limits);
    emit strongestChanged(m_limits.strongest);
}

void BraceletService::stopPlaying() {
    if (m_session && !m_reserved)
        m_session->player().stop();
}

std::optional<double> BraceletService::playingPosition_s() const {
    if (!m_session)
        return std::nullopt;
    const playback::PlayerStatus status = m_session->player().status();
    return status.mode == playback::PlayerMode::program ? std::optional(status.position_s) : std::nullopt;
}

bool BraceletService::isPlaying(std::uint64_t number) const {
    if (!m_session || number == 0)
        return false;
    const playback::PlayerStatus status = m_session->player().status();
    return number > status.settled ||
           (number == status.program && status.mode == playback::PlayerMode::program);
}

bool BraceletService::isDriven() const {
    return m_session && m_session->player().status().mode != playback::PlayerMode::idle;
}

void BraceletService::waitUntilOff() const {
    if (!m_session)
        return;
    // A frame that was under way when STOP was engaged is followed by one of zeros.
    std::this_thread::sleep_for(kUnderWay);
    const auto deadline = std::chrono::steady_clock::now() + kLongestWait;
    while (!core::isOff(m_session->source().telemetry().written) &&
           std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

void BraceletService::hold(std::optional<std::size_t> tactor) {
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

void BraceletService::reserve(bool reserved) {
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

void BraceletService::repeatHold() {
    if (!m_held || !m_session)
        return;
    core::Intensities intensities{};
    intensities[*m_held] = kHeldIntensity;
    m_session->player().post(intensities, core::steadyNow_ns());
}

void BraceletService::tick() {
    takeOpened();
    repeatHold();
    pipeline::FeedbackSent sent;
    while (m_feedback->popSent(sent)) {
        m_touchToSkin.begin(std::move(sent), m_siteClock);
        emit felt(*m_touchToSkin.last());
    }
    if (m_session && m_touchToSkin.isOpen() && m_touchToSkin.update(m_session->player().counters()))
        emit felt(*m_touchToSkin.last());
}

bool BraceletService::isFeedbackPlaying() const {
    const Felt felt = m_felt->get();
    const bool isNewest = m_session && felt.session.lock() == m_session && felt.number > m_asked;
    return isNewest && !m_reserved && !m_held && isPlaying(felt.number);
}

void BraceletService::endFeedback() {
    if (isFeedbackPlaying())
        m_session->player().stop();
}

void BraceletService::forgetFeedback() {
    endFeedback();
    m_touchToSkin.forget();
}

core::Intensities BraceletService::given() const {
    return m_session ? m_session->player().status().given : core::Intensities{};
}

bool BraceletService::isReady() const {
    return m_session && m_session->source().connection() != 0 && !m_stop.engaged();
}

bool BraceletService::isAnswering() const {
    return isLive() && !isTooHot();
}

bool BraceletService::isLive() const {
    return isReady() && state() == core::DeviceState::live;
}

bool BraceletService::isTooHot() const {
    return m_session && m_session->source().telemetry().board.tooHot;
}

core::DeviceState BraceletService::state() const {
    const core::DeviceStatus status = m_session->source().status();
    return core::observedState(status.state, status.lastData_ns, core::steadyNow_ns(), m_staleAfter_ns);
}

bool BraceletService::isOnSoundCard() const {
    return m_session && m_session->source().telemetry().board.sound;
}

bool BraceletService::isSimulated() const {
    return m_session && m_session->source().description().simulated;
}

} // namespace teleta::console
