// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/taxels/frames/frame_decoder.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <variant>

namespace teleta::taxels {

/// Frames that are lines of text: numbers between separators, or one JSON document each. Lines end with a
/// line feed, before which a carriage return may stand. A line that is no frame is dropped and counted as bad
/// values; empty lines are dropped. A line of numbers without its end may be cut within a number: only the
/// last one of a file is believed. A document without the values is another frame. Thread: one (pure).
class LineDecoder : public FrameDecoder {
public:
    LineDecoder(CsvFormat format, Framing framing);
    LineDecoder(JsonFormat format, Framing framing);

    [[nodiscard]] bool next(DecodedFrame& frame, Rest rest = Rest::mayCome) override;
    [[nodiscard]] std::string model() const override { return m_model; }
    void expectModel(const std::string& model) override {
        if (m_model.empty())
            m_model = model;
    }

private:
    enum class Verdict { wrong, other, frame };

    [[nodiscard]] bool readCsv(std::string_view line, DecodedFrame& frame) const;
    [[nodiscard]] Verdict readJson(std::string_view line, DecodedFrame& frame);
    [[nodiscard]] bool isOurSensor(const nlohmann::json& sensor);
    void readTime(const nlohmann::json& document, DecodedFrame& frame) const;
    [[nodiscard]] bool readValues(const nlohmann::json& values, DecodedFrame& frame) const;
    [[nodiscard]] bool readHex(std::string_view text, DecodedFrame& frame) const;

    std::variant<CsvFormat, JsonFormat> m_format;
    nlohmann::json::json_pointer m_values;
    nlohmann::json::json_pointer m_time;
    nlohmann::json::json_pointer m_otherTime;
    nlohmann::json::json_pointer m_counter;
    nlohmann::json::json_pointer m_sensor;
    std::string m_model; ///< of the sensor; empty: not told yet
    bool m_datagrams;
    std::size_t m_toSkip = 0;
    bool m_begunLine = false;   ///< the begin of the line at hand was dropped
    std::size_t m_searched = 0; ///< pending bytes in which no end of a line is
};

} // namespace teleta::taxels
