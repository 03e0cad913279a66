// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_session.h"

#include "backend/core/data/array_layout.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"
#include "devices/wts/wts_text.h"

#include <QString>

#include <algorithm>
#include <iterator>
#include <utility>

namespace teleta::wts {

namespace {

using Outcome = link::ByteLink::Outcome;

constexpr std::size_t kLargestAnswer = 256;
constexpr std::size_t kLargestPayload = 0xFFFF;
constexpr int kAttempts = 3;

std::int64_t deadlineIn(int time_ms) {
    return core::steadyNow_ns() + time_ms * kMs_ns;
}

core::Expected<void> checkMatrix(const MatrixInfo& matrix) {
    const auto sideFits = [](int side) { return side >= 1 && side <= core::ArrayLayout::kMaximumSide; };
    if (!sideFits(matrix.rows) || !sideFits(matrix.columns) ||
        kFrameHeaderBytes + 2 * matrix.cells() > kLargestPayload)
        return core::failed(
            core::ErrorKind::refused,
            WtsText::tr("the sensor reports %1 rows and %2 columns").arg(matrix.rows).arg(matrix.columns),
            WtsText::tr("an array of 1 to %1 rows and columns whose frame fits into one message")
                .arg(core::ArrayLayout::kMaximumSide));
    if (matrix.cellWidth_10um == 0 || matrix.cellHeight_10um == 0)
        return core::failed(core::ErrorKind::refused,
                            WtsText::tr("the sensor's cells are %1 mm wide and %2 mm high")
                                .arg(matrix.cellWidth_10um / 100.0)
                                .arg(matrix.cellHeight_10um / 100.0),
                            WtsText::tr("cells with a width and a height"));
    return {};
}

} // namespace

std::string describe(Status status) {
    constexpr std::pair<Status, const char*> kTexts[] = {
        {Status::success, QT_TRANSLATE_NOOP("WtsText", "success")},
        {Status::notAvailable, QT_TRANSLATE_NOOP("WtsText", "not available")},
        {Status::noSensor, QT_TRANSLATE_NOOP("WtsText", "no sensor connected")},
        {Status::notInitialised, QT_TRANSLATE_NOOP("WtsText", "not initialised")},
        {Status::alreadyRunning, QT_TRANSLATE_NOOP("WtsText", "already running")},
        {Status::notSupported, QT_TRANSLATE_NOOP("WtsText", "not supported")},
        {Status::inconsistentData, QT_TRANSLATE_NOOP("WtsText", "inconsistent data")},
        {Status::timeOut, QT_TRANSLATE_NOOP("WtsText", "timeout in the sensor")},
        {Status::readError, QT_TRANSLATE_NOOP("WtsText", "read error in the sensor")},
        {Status::writeError, QT_TRANSLATE_NOOP("WtsText", "write error in the sensor")},
        {Status::checksumError, QT_TRANSLATE_NOOP("WtsText", "wrong checksum")},
        {Status::unknownCommand, QT_TRANSLATE_NOOP("WtsText", "unknown command")},
        {Status::formatError, QT_TRANSLATE_NOOP("WtsText", "wrong format")},
        {Status::accessDenied, QT_TRANSLATE_NOOP("WtsText", "access denied")},
    };
    const auto* const known = std::ranges::find(kTexts, status, &std::pair<Status, const char*>::first);
    const QString text = known != std::end(kTexts) ? WtsText::tr(known->second)
                                                   : WtsText::tr("status %1").arg(static_cast<int>(status));
    return text.toStdString();
}

core::Expected<WtsSession> WtsSession::open(const WtsConfig& config, const link::WakePipe* wake) {
    TELETA_TRY(auto link, link::ByteLink::open(config.address, deadlineIn(config.times.connect_ms), wake));
    WtsSession session(std::move(link), config);
    // It does not matter whether frames were running, only that the sensor answers.
    TELETA_CHECK(
        session.request(encodeRequest(Command::stopFrames), config.times.answer_ms, kAttempts, wake));
    TELETA_CHECK(session.readMatrix(wake));
    return session;
}

core::Expected<void> WtsSession::readMatrix(const link::WakePipe* wake) {
    TELETA_CHECK(demand(encodeRequest(Command::matrixInfo), m_config.times.answer_ms, kAttempts, wake));
    const std::optional<MatrixInfo> matrix = readMatrixInfo(m_answer);
    if (!matrix)
        return core::failed(core::ErrorKind::refused,
                            WtsText::tr("the sensor describes its array in %1 bytes").arg(m_answer.size()),
                            WtsText::tr("the 10 bytes of a WTS array"));
    TELETA_CHECK(checkMatrix(*matrix));
    m_matrix = *matrix;
    m_decoder.setMaximumPayload(std::max(kLargestAnswer, kFrameHeaderBytes + 2 * m_matrix.cells()));
    return {};
}

core::Expected<void> WtsSession::tare(const link::WakePipe* wake) {
    // 1: take the values now as zero; 0 would undo that.
    const std::array<std::uint8_t, 1> params{1};
    return demand(encodeRequest(Command::tare, params), m_config.times.tare_ms, 1, wake);
}

core::Expected<void> WtsSession::startFrames(const link::WakePipe* wake) {
    const std::vector<std::uint8_t> start = encodeStartFrames(m_config.runLength, m_config.delay_ms);
    TELETA_TRY(const auto status, request(start, m_config.times.answer_ms, kAttempts, wake));
    // If it already runs, the answer to the first attempt was lost; the settings are those requested.
    if (status == Status::success || status == Status::alreadyRunning)
        return {};
    return core::failed(
        core::ErrorKind::unavailable,
        WtsText::tr("the sensor sends no frames: %1").arg(QString::fromStdString(describe(status))));
}

void WtsSession::stopFrames() {
    // The result does not matter: the link is closed next.
    (void)request(encodeRequest(Command::stopFrames), m_config.times.answer_ms, 1, nullptr);
}

Outcome WtsSession::receive(std::int64_t deadline_ns, const link::WakePipe* wake) {
    std::size_t count = 0;
    const Outcome outcome = m_link.read(m_read, count, deadline_ns, wake);
    if (outcome == Outcome::done) {
        m_readTime_ns = core::steadyNow_ns();
        m_decoder.feed(std::span(m_read).first(count));
    }
    return outcome;
}

core::Expected<Status> WtsSession::request(std::span<const std::uint8_t> bytes, int answer_ms, int attempts,
                                           const link::WakePipe* wake) {
    const std::uint8_t id = bytes[kPreambleBytes];
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const std::int64_t deadline_ns = deadlineIn(answer_ms);
        if (const Outcome sent = m_link.write(bytes, deadline_ns, wake); sent == Outcome::timedOut)
            continue;
        else if (sent != Outcome::done)
            return failure(sent);
        Outcome outcome = Outcome::done;
        while (outcome == Outcome::done) {
            outcome = receive(deadline_ns, wake);
            // A sensor that only sends frames keeps the line busy beyond any deadline.
            if (outcome == Outcome::done && m_readTime_ns >= deadline_ns)
                outcome = Outcome::timedOut;
            // Behind a message that was cut off, the answer may stand already.
            const auto rest = outcome == Outcome::timedOut ? MessageDecoder::Rest::willNotCome
                                                           : MessageDecoder::Rest::mayCome;
            Message message;
            while (m_decoder.next(message, rest)) {
                if (message.id != id)
                    continue;
                if (const std::optional<Answer> answer = readAnswer(message)) {
                    m_answer.assign(answer->params.begin(), answer->params.end());
                    return answer->status;
                }
            }
        }
        if (outcome != Outcome::timedOut)
            return failure(outcome);
    }
    return core::failed(core::ErrorKind::unavailable, WtsText::tr("the sensor does not answer"));
}

core::Expected<void> WtsSession::demand(std::span<const std::uint8_t> bytes, int answer_ms, int attempts,
                                        const link::WakePipe* wake) {
    TELETA_TRY(const auto status, request(bytes, answer_ms, attempts, wake));
    if (status != Status::success)
        return core::failed(
            core::ErrorKind::unavailable,
            WtsText::tr("the sensor refused a request: %1").arg(QString::fromStdString(describe(status))));
    return {};
}

core::Unexpected WtsSession::failure(Outcome outcome) const {
    if (outcome == Outcome::woken)
        return core::failed(core::ErrorKind::cancelled, WtsText::tr("connecting was cancelled"));
    return core::Unexpected(core::Error{core::ErrorKind::unavailable, m_link.goneReason(), {}, {}});
}

} // namespace teleta::wts
