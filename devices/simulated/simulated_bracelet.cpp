// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/simulated_bracelet.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::simulated {

namespace {

class SimulatedPort : public core::BraceletPort {
public:
    explicit SimulatedPort(std::shared_ptr<SimulatedBoard> board)
        : m_board(std::move(board)) {}

    [[nodiscard]] bool write(std::uint16_t sequence, const core::Drive& drive,
                             std::uint16_t timeout_ms) override {
        return m_board->take(sequence, drive, timeout_ms);
    }
    [[nodiscard]] Read read(core::BoardReport& report) override {
        if (m_board->faults().unplugged)
            return Read::lost;
        return m_board->answer(report) ? Read::report : Read::nothing;
    }

private:
    std::shared_ptr<SimulatedBoard> m_board;
};

core::BraceletDescription describe(const SimulatedBraceletConfig& config) {
    core::BraceletDescription description;
    description.name =
        config.name.empty()
            ? QCoreApplication::translate("SimulatedBracelet", "Simulated bracelet").toStdString()
            : config.name;
    description.serial = "simulated";
    description.simulated = true;
    description.maximumRate_Hz = config.maximumRate_Hz;
    return description;
}

core::OpenedBracelet plugIn(const std::shared_ptr<SimulatedBoard>& board,
                            const core::BraceletDescription& description) {
    // Answers that the last connection did not fetch are lost.
    for (core::BoardReport old; board->answer(old);) {
    }
    return {std::make_unique<SimulatedPort>(board), description};
}

core::BraceletOpener opener(std::shared_ptr<SimulatedBoard> board, core::BraceletDescription description) {
    return [board = std::move(board),
            description = std::move(description)]() -> core::Expected<core::OpenedBracelet> {
        if (board->faults().unplugged)
            return core::failed(
                core::ErrorKind::unavailable,
                QCoreApplication::translate("SimulatedBracelet", "The bracelet was unplugged."));
        return plugIn(board, description);
    };
}

} // namespace

SimulatedBracelet::SimulatedBracelet(const core::StopSwitch& stopSwitch,
                                     const SimulatedBraceletConfig& config)
    : m_board(std::make_shared<SimulatedBoard>(config))
    , m_link(plugIn(m_board, describe(config)), opener(m_board, describe(config)), stopSwitch, config.link) {
}

} // namespace teleta::simulated
