// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/modbus/libmodbus_link.h"

#include "backend/core/device/node_claim.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QString>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <modbus/modbus.h>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::modbus {

namespace {

struct ContextDeleter {
    void operator()(modbus_t* context) const {
        modbus_close(context);
        modbus_free(context);
    }
};
using Context = std::unique_ptr<modbus_t, ContextDeleter>;

Context makeContext(const RegisterMap& map) {
    if (const auto* rtu = std::get_if<RtuLink>(&map.link))
        return Context(modbus_new_rtu(rtu->path.c_str(), rtu->baud, rtu->parity, 8, rtu->stopBits));
    const auto& tcp = std::get<TcpLink>(map.link);
    return Context(modbus_new_tcp_pi(tcp.host.c_str(), std::to_string(tcp.port).c_str()));
}

core::Unexpected unavailable(const RegisterMap& map, int error) {
    if (error == EBUSY)
        return core::usedByAnother(linkName(map));
    return core::failed(
        core::ErrorKind::unavailable,
        QCoreApplication::translate("Modbus", "%1 cannot be opened: %2")
            .arg(QString::fromStdString(linkName(map)), QString::fromLocal8Bit(modbus_strerror(error))));
}

Answer failure(int error) {
    // libmodbus numbers the protocol's exceptions from MODBUS_ENOBASE + 1 on.
    if (error > MODBUS_ENOBASE && error < MODBUS_ENOBASE + MODBUS_EXCEPTION_MAX)
        return {Answer::Kind::exception, error - MODBUS_ENOBASE};
    switch (error) {
    case ETIMEDOUT:
        return {Answer::Kind::timedOut};
    case EMBUNKEXC:
        return {Answer::Kind::exception};
    case EMBBADCRC:
    case EMBBADDATA:
    case EMBBADEXC:
    case EMBMDATA:
    case EMBBADSLAVE:
    case EINVAL:
        return {Answer::Kind::damaged};
    default:
        return {Answer::Kind::lost};
    }
}

class LibmodbusLink : public RegisterLink {
public:
    LibmodbusLink(Context context, std::optional<core::NodeClaim> line, int server)
        : m_line(std::move(line))
        , m_context(std::move(context))
        , m_server(server) {}

    [[nodiscard]] Answer write(std::uint16_t address, std::span<const std::uint16_t> words) override {
        discardLateAnswers();
        return answer(
            modbus_write_registers(m_context.get(), address, static_cast<int>(words.size()), words.data()));
    }

    void writeUnanswered(std::uint16_t address, std::span<const std::uint16_t> words) override {
        std::vector<std::uint8_t> request = {static_cast<std::uint8_t>(m_server),
                                             MODBUS_FC_WRITE_MULTIPLE_REGISTERS};
        const auto append = [&request](std::size_t word) {
            request.push_back(static_cast<std::uint8_t>(word >> 8U));
            request.push_back(static_cast<std::uint8_t>(word & 0xFFU));
        };
        append(address);
        append(words.size());
        request.push_back(static_cast<std::uint8_t>(2 * words.size()));
        for (const std::uint16_t word : words)
            append(word);
        (void)modbus_send_raw_request(m_context.get(), request.data(), static_cast<int>(request.size()));
    }

    [[nodiscard]] Answer read(RegisterTable table, std::uint16_t address,
                              std::span<std::uint16_t> words) override {
        discardLateAnswers();
        const auto function =
            table == RegisterTable::input ? modbus_read_input_registers : modbus_read_registers;
        return answer(function(m_context.get(), address, static_cast<int>(words.size()), words.data()));
    }

    [[nodiscard]] std::uint64_t lateAnswers() const override { return m_lateAnswers; }

private:
    [[nodiscard]] static Answer answer(int result) { return result >= 0 ? Answer{} : failure(errno); }

    void discardLateAnswers() {
        if (modbus_flush(m_context.get()) > 0)
            ++m_lateAnswers;
    }

    std::optional<core::NodeClaim> m_line; ///< of a serial one
    Context m_context;
    int m_server;
    std::uint64_t m_lateAnswers = 0;
};

} // namespace

core::Expected<std::unique_ptr<RegisterLink>> openLibmodbusLink(const RegisterMap& map) {
    Context context = makeContext(map);
    if (context == nullptr)
        return unavailable(map, errno);
    std::optional<core::NodeClaim> line;
    if (const auto* rtu = std::get_if<RtuLink>(&map.link)) {
        // One that cannot be claimed cannot be opened either, which tells why.
        if (auto claim = core::NodeClaim::take(rtu->path)) {
            if (!*claim)
                return core::usedByAnother(linkName(map));
            line = std::move(*claim);
        }
    }
    const auto microseconds = std::llround(map.answerTimeout_s * 1e6);
    const auto seconds = static_cast<std::uint32_t>(microseconds / 1'000'000);
    const auto rest = static_cast<std::uint32_t>(microseconds % 1'000'000);
    // The second one is of the gaps within an answer.
    if (modbus_set_slave(context.get(), map.server) != 0 ||
        modbus_set_response_timeout(context.get(), seconds, rest) != 0 ||
        modbus_set_byte_timeout(context.get(), seconds, rest) != 0 || modbus_connect(context.get()) != 0)
        return unavailable(map, errno);
    (void)modbus_flush(context.get());
    return std::make_unique<LibmodbusLink>(std::move(context), std::move(line), map.server);
}

LinkOpener libmodbusOpener(RegisterMap map) {
    return [map = std::move(map)] { return openLibmodbusLink(map); };
}

} // namespace teleta::modbus
